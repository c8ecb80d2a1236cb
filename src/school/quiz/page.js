// SPDX-License-Identifier: Apache-2.0
// The quiz: the first choice of a question counts, and unfolds its answer.
'use strict';
(() => {
  const main = document.querySelector('main');
  const questions = [...document.querySelectorAll('article')];
  const score = document.querySelector('.score');
  const output = score.querySelector('output');
  let right = 0;

  const show = () => {
    output.textContent = output.dataset.text.replace('{0}', right).replace('{1}', questions.length);
  };
  const mark = (choice, good) => {
    choice.classList.add(good ? 'good' : 'bad');
    const verdict = document.createElement('span');
    verdict.className = 'verdict';
    verdict.textContent = good ? `✓ ${main.dataset.good}` : `✗ ${main.dataset.bad}`;
    choice.append(verdict);
  };
  const answer = (question, chosen) => {
    const choices = [...question.querySelectorAll('.choice')];
    const wanted = choices[question.querySelector('[data-right]').dataset.right];
    for (const choice of choices) choice.disabled = true;
    mark(wanted, true);
    if (chosen === wanted) right += 1;
    else mark(chosen, false);
    question.querySelector('details').open = true;
    show();
  };
  const start = () => {
    right = 0;
    for (const choice of document.querySelectorAll('.choice')) {
      choice.disabled = false;
      choice.classList.remove('good', 'bad');
    }
    for (const verdict of document.querySelectorAll('.verdict')) verdict.remove();
    for (const details of document.querySelectorAll('details')) details.open = false;
    show();
  };

  for (const question of questions)
    for (const choice of question.querySelectorAll('.choice'))
      choice.addEventListener('click', () => answer(question, choice));
  score.querySelector('button').addEventListener('click', () => { start(); scrollTo(0, 0); });
  score.hidden = false;
  start();
})();
