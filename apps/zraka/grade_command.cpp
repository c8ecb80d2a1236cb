// SPDX-License-Identifier: Apache-2.0
// zraka grade: marks for submissions, and the cause of what is wrong in them.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "core/words.hpp"
#include "explain/names.hpp"
#include "grade/page.hpp"
#include "grade/words.hpp"
#include "render_options.hpp"
#include "terminal.hpp"
#include "zraka/zraka.hpp"

namespace zraka::app {
namespace {

namespace fs = std::filesystem;

struct Words : RenderWords {
  std::string submission, rubric, format, language = "en", output = "-";
  bool all = false, list = false;
};

int list_mistakes(Language language) {
  for (const MistakeEntry& entry : all_mistakes())
    fmt::print("{:<34} {}{}\n", entry.key, text_of(language, entry.mistake),
               entry.allowed ? " *" : "");
  return kDone;
}

/// A class's folder: each folder, archive or picture in it is a submission.
Result<std::vector<std::string>> submissions_in(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> paths;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (!it->path().filename().string().starts_with('.')) paths.push_back(it->path().string());
  if (error) return failure(folder, "the folder cannot be read: " + error.message());
  if (paths.empty()) return failure(folder, "there is nothing in it to mark");
  std::sort(paths.begin(), paths.end());
  return paths;
}

int run(const Words& words) {
  const Language language = *language_named(words.language);
  if (words.list) return list_mistakes(language);
  const Result<Scene> scene = words.load();
  if (!scene) return fail(scene.error());
  Result<Rubric> rubric = words.rubric.empty() ? default_rubric() : read_rubric(words.rubric);
  if (!rubric) return fail(rubric.error());
  std::vector<std::string> paths{words.submission};
  if (words.all) {
    Result<std::vector<std::string>> found = submissions_in(words.submission);
    if (!found) return fail(found.error());
    paths = std::move(*found);
  }
  const Result<Grader> grader = Grader::create(*scene, words.options(*scene), *rubric);
  if (!grader) return fail(grader.error());
  const std::string format = format_of(words.format, words.output);
  std::vector<Grade> grades(paths.size());
  tbb::parallel_for(std::size_t{0}, paths.size(), [&](std::size_t i) {
    grades[i] = grader->grade(paths[i]);
    if (words.all) grades[i].name = fs::path(paths[i]).filename().string();
    if (words.all || format != "html")
      for (StageGrade& stage : grades[i].stages) stage.aligned = {};
  });
  std::string text;
  if (format == "json") {
    text = grade_json(language, *grader, grades, words.all);
  } else if (format == "html") {
    const std::string name = words.scene == "-" ? "-" : fs::path(words.scene).filename().string();
    Result<std::string> page = words.all ? grades_page(language, *grader, grades, name)
                                         : grade_page(language, *grader, grades.front(), name);
    if (!page) return fail(page.error());
    text = std::move(*page);
  } else if (words.all) {
    text = grades_table(language, grades);
  } else {
    text = grade_text(language, *grader, grades.front());
  }
  const Result<void> written = write_text_file(words.output, text);
  if (!written) return fail(written.error());
  return words.all || grades.front().problems.empty() ? +kDone : +kFailed;
}

}  // namespace

CLI::App* add_grade(CLI::App& program, Command& command) {
  auto words = std::make_shared<Words>();
  CLI::App* app = program.add_subcommand(
      "grade", "mark pictures of the lab's stages, and name the cause of what is wrong");
  words->add_to(*app);
  app->get_option("SCENE")->required(false);
  app->add_option("SUBMISSION", words->submission,
                  "a picture, or a folder or zip archive of pictures called 1 to 7 or by their "
                  "stage");
  app->add_flag("--all", words->all, "SUBMISSION is a class's folder: mark all that is in it");
  app->add_flag("--list", words->list, "print the mistakes that can be named, and do nothing else");
  app->add_option("--rubric", words->rubric,
                  "a JSON file with marks, tolerances and what is allowed");
  app->add_option("-o,--output", words->output,
                  "the file to write; - (default) is standard output");
  add_format_to(*app, words->format);
  add_language_to(*app, words->language);
  app->footer(
      "Upside down, red and blue swapped, gamma, JPEG, scaled screenshots and window frames are\n"
      "found out and cost nothing. docs/grade.md explains the marks.\n\n"
      "Examples:\n"
      "  zraka grade input.txt ana-anic/\n"
      "  zraka grade input.txt slika.png --lang hr\n"
      "  zraka grade input.txt ana-anic.zip -o ana-anic.html\n"
      "  zraka grade input.txt class/ --all --rubric rubric.json\n"
      "  zraka grade --list");
  app->callback([&command, words] {
    if (!words->list && words->scene.empty()) throw CLI::RequiredError("SCENE");
    if (!words->list && words->submission.empty()) throw CLI::RequiredError("SUBMISSION");
    command = [words] { return run(*words); };
  });
  return app;
}

}  // namespace zraka::app
