// SPDX-License-Identifier: Apache-2.0
// zraka quiz: questions about a scene's picture, with answers from the engine that draws it.
#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "commands.hpp"
#include "core/file.hpp"
#include "progress.hpp"
#include "quiz/view.hpp"
#include "render_options.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

std::optional<std::uint64_t> seed_named(const std::string& word) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seed);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return seed;
}

struct Words : RenderWords {
  std::string output, answers, format, pictures, language = "en", stage = "refraction", seed = "1";
  int questions = 10;
  std::vector<std::string> kinds;

  std::string format_name() const;
  std::string output_name() const;
  QuizOptions quiz() const;
  /// What does not go together; "" if all does.
  std::string contradiction() const;
};

/// The format asked for; else the one that the output's name asks for; else a page.
std::string Words::format_name() const {
  if (!format.empty()) return format;
  const std::string extension = std::filesystem::path(output).extension().string();
  return extension == ".json" ? "json" : extension == ".txt" ? "text" : "html";
}

std::string Words::output_name() const {
  return !output.empty() ? output : format_name() == "html" ? "quiz.html" : "-";
}

QuizOptions Words::quiz() const {
  QuizOptions options{.seed = *seed_named(seed), .questions = questions, .language = language};
  if (!kinds.empty()) options.kinds.clear();
  for (const std::string& kind : kinds) options.kinds.insert(*quiz_kind_named(kind));
  return options;
}

std::string Words::contradiction() const {
  const std::string name = format_name();
  if (name == "html" && !pictures.empty())
    return "--pictures goes with --format json or text: a page has its pictures in it";
  if (name == "text" && pictures.empty() && quiz().kinds != std::set{QuizKind::color})
    return "--format text needs --pictures FOLDER for what is asked about pictures, or --kind "
           "color";
  if (!answers.empty() && answers == output_name()) return "--answers needs a file of its own";
  return "";
}

/// Writes the pictures into a folder; gives back their names.
Result<std::vector<std::string>> write_pictures(const Words& words, const Quiz& quiz) {
  std::vector<std::string> files;
  if (words.pictures.empty()) return files;
  const Result<void> folder = make_folder(words.pictures);
  if (!folder) return tl::make_unexpected(folder.error());
  for (const QuizPicture& picture : quiz.pictures) {
    const std::string name = fmt::format("picture-{}.png", files.size() + 1);
    files.push_back((std::filesystem::path(words.pictures) / name).string());
    const Result<void> written = write_text_file(files.back(), picture.png);
    if (!written) return tl::make_unexpected(written.error());
  }
  return files;
}

Result<void> write(const Words& words, const Quiz& quiz, const QuizView& view) {
  const std::string format = words.format_name();
  const auto made = [&](const auto& html, const auto& json, const auto& text) -> std::string {
    return format == "html" ? html() : format == "json" ? json() : text();
  };
  Result<void> written =
      write_text_file(words.output_name(), made([&] { return quiz_page(quiz, view); },
                                                [&] { return quiz_json(quiz, view); },
                                                [&] { return quiz_text(quiz, view); }));
  if (!written || words.answers.empty()) return written;
  return write_text_file(words.answers, made([&] { return quiz_answers_page(quiz, view); },
                                             [&] { return quiz_answers_json(quiz); },
                                             [&] { return quiz_answers_text(quiz, view); }));
}

int run(const Words& words) {
  const Result<Scene> scene = words.load();
  if (!scene) return fail(scene.error());
  RenderOptions options = words.options(*scene);
  options.terms = terms_of(*stage_named(words.stage));
  const Result<Quiz> quiz = [&] {
    Progress progress(words.quiet);
    options.progress = progress.callback();
    return make_quiz(*scene, options, words.quiz());
  }();
  if (!quiz) return fail(quiz.error());
  if (quiz->questions.size() < static_cast<std::size_t>(words.questions) && !words.quiet)
    show({{.severity = Severity::warning,
           .file = words.scene == "-" ? "standard input" : words.scene,
           .message = fmt::format("{} of {} questions: the scene gives no more of these kinds",
                                  quiz->questions.size(), words.questions)}});
  const Result<std::vector<std::string>> files = write_pictures(words, *quiz);
  if (!files) return fail(files.error());
  const QuizView view{
      .language = *language_named(words.language),
      .scene = words.scene == "-" ? "-" : std::filesystem::path(words.scene).filename().string(),
      .resolution = scene->resolution,
      .profile = words.profile_name(*scene),
      .max_depth = words.max_depth,
      .seed = *seed_named(words.seed),
      .answers = words.answers.empty(),
      .files = *files};
  const Result<void> written = write(words, *quiz, view);
  if (!written) return fail(written.error());
  if (words.quiet) return kDone;
  for (const std::string& name : {words.output_name(), words.answers})
    if (!name.empty() && words.output_name() != "-" && words.answers != "-")
      fmt::print("{}\n", name);
  return kDone;
}

void add_options(CLI::App& app, Words& words) {
  app.add_option("-o,--output", words.output,
                 "the file to write: quiz.html, or - (standard output) for JSON and text, if not "
                 "given");
  app.add_option("--answers", words.answers,
                 "write the answers into this file, and nothing of them into the quiz");
  app.add_option("--seed", words.seed,
                 "another number, another quiz (default 1); the same one, the same quiz")
      ->check(one_of("a whole number, 0 or more",
                     [](const std::string& word) { return seed_named(word).has_value(); }));
  app.add_option("--questions", words.questions, "how many (default 10)")
      ->check(CLI::Range(1, kMaxQuestions));
  app.add_option("--kind", words.kinds,
                 "stage (what is missing?), mistake (what is wrong?) or color (what colour has "
                 "this pixel?); may be given more than once; all, if not given")
      ->check(one_of("stage, mistake or color",
                     [](const std::string& word) { return quiz_kind_named(word).has_value(); }));
  app.add_option("--stage", words.stage,
                 "up to which stage of the lab, as render has it (default: all)")
      ->check(one_of(
          "a stage: 1…7, silhouette, ambient, diffuse, specular, shadows, reflection or refraction",
          [](const std::string& word) { return stage_named(word).has_value(); }));
  app.add_option("--format", words.format,
                 "html, json or text; else by the name of the output, else html")
      ->check(CLI::IsMember({"html", "json", "text"}));
  app.add_option("--pictures", words.pictures,
                 "a folder for the pictures of JSON and text; JSON has them in it otherwise");
  add_language_to(app, words.language);
}

}  // namespace

CLI::App* add_quiz(CLI::App& program, Command& command) {
  auto words = std::make_shared<Words>();
  CLI::App* app = program.add_subcommand(
      "quiz", "questions about a scene's picture, with answers and reasons from the engine");
  words->add_to(*app);
  app->remove_option(app->get_option("--mistake"));
  add_options(*app, *words);
  app->footer(
      "Examples:\n"
      "  zraka quiz scenes/lab/input.txt\n"
      "  zraka quiz input.txt -o kviz.html --lang hr --seed 7 --questions 6\n"
      "  zraka quiz input.txt -o test.html --answers answers.html --seed 20417\n"
      "  zraka quiz input.txt --kind color --format text\n"
      "  zraka quiz input.txt --stage shadows --kind mistake --format json -o quiz.json");
  app->callback([&command, words] {
    if (const std::string wrong = words->contradiction(); !wrong.empty())
      throw CLI::ValidationError(wrong);
    command = [words] { return run(*words); };
  });
  return app;
}

}  // namespace zraka::app
