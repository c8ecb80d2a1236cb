// SPDX-License-Identifier: Apache-2.0
// zraka grade: marks for submissions, and the cause of what is wrong in them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "core/in_parallel.hpp"
#include "core/phrase.hpp"
#include "core/text.hpp"
#include "core/words.hpp"
#include "render_options.hpp"
#include "school/grade/page.hpp"
#include "school/grade/submission.hpp"
#include "school/grade/words.hpp"
#include "school/mistakes/names.hpp"
#include "terminal.hpp"
#include "zraka/zraka.hpp"

namespace zraka::app {
namespace {

namespace fs = std::filesystem;

struct GradeArguments : RenderArguments {
  std::string submission, stage, rubric, format, language = "en", output = "-";
  bool all = false, list = false;
};

int list_mistakes(Language language) {
  for (const MistakeEntry& entry : all_mistakes()) {
    std::string note = entry.allowed ? " *" : "";
    if (entry.first_stage == kAdvanced)
      note = fmt::format(" {}", text_of(language, Word::grade_not_graded));
    fmt::print("{:<34} {}{}\n", entry.key, text_of(language, entry.mistake), note);
  }
  return kDone;
}

/// A class's folder: each folder, archive or picture in it is a submission.
Result<std::vector<std::string>> submissions_in(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> paths;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (!it->path().filename().string().starts_with('.')) paths.push_back(it->path().string());
  if (error) return failure(folder, phrase(Word::grade_folder, reason_of(error.value())));
  if (paths.empty()) return failure(folder, phrase(Word::grade_nothing));
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The files in what was handed in that marking reads: pictures and archives.
std::vector<std::string> files_in(const std::string& submission) {
  std::vector<std::string> files = {submission};
  std::error_code error;
  fs::recursive_directory_iterator it(submission, fs::directory_options::skip_permission_denied,
                                      error),
      end;
  for (; !error && it != end; it.increment(error))
    if (is_handed_in(it->path().string())) files.push_back(it->path().string());
  return files;
}

int run(const GradeArguments& arguments) {
  speak(*language_named(arguments.language));
  const Language language = *language_named(arguments.language);
  if (arguments.list) return list_mistakes(language);
  std::vector<std::string> inputs;
  if (arguments.output != "-") inputs = files_in(arguments.submission);
  inputs.push_back(arguments.rubric);
  const Result<Scene> scene = arguments.load({arguments.output}, std::move(inputs));
  if (!scene) return fail(scene.error());
  Result<Rubric> rubric =
      arguments.rubric.empty() ? default_rubric() : read_rubric(arguments.rubric);
  if (!rubric) return fail(rubric.error());
  std::vector<std::string> paths{arguments.submission};
  if (arguments.all) {
    Result<std::vector<std::string>> found = submissions_in(arguments.submission);
    if (!found) return fail(found.error());
    paths = std::move(*found);
    // What was written into the folder before is no submission.
    std::erase_if(paths, [&](const std::string& path) {
      std::error_code ignored;
      return fs::equivalent(path, arguments.output, ignored) && !is_handed_in(path);
    });
  }
  const Result<Grader> grader = Grader::create(*scene, arguments.options(*scene), *rubric);
  if (!grader) return fail(grader.error());
  const std::string format = format_of(arguments.format, arguments.output);
  const int stage =
      arguments.stage.empty() ? 0 : static_cast<int>(*stage_named(arguments.stage));
  std::vector<Grade> grades(paths.size());
  const auto grade_one = [&](std::size_t i) {
    grades[i] = grader->grade(paths[i], arguments.all ? Links::refuse : Links::follow, stage);
    if (arguments.all) grades[i].name = fs::path(paths[i]).filename().string();
    if (arguments.all || format != "html")
      for (StageGrade& judged : grades[i].stages) judged.aligned = {};
  };
  in_parallel(
      paths.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) grade_one(i);
      },
      1);
  std::string text;
  if (format == "json") {
    text = grade_json(language, *grader, grades, arguments.all);
  } else if (format == "html") {
    const std::string name =
        arguments.scene == "-" ? "-" : fs::path(arguments.scene).filename().string();
    Result<std::string> page = arguments.all ? grades_page(language, *grader, grades, name)
                                             : grade_page(language, *grader, grades.front(), name);
    if (!page) return fail(page.error());
    text = std::move(*page);
  } else if (arguments.all) {
    text = grades_table(language, grades);
  } else {
    text = grade_text(language, *grader, grades.front());
  }
  const Result<void> written = write_text_file(arguments.output, text);
  if (!written) return fail(written.error());
  if (arguments.all || grades.front().problems.empty()) return kDone;
  // The text that was printed has said why.
  if (arguments.output != "-" || format != "text") show(grades.front().problems);
  return kFailed;
}

}  // namespace

void add_grade(Command& program) {
  auto arguments = std::make_shared<GradeArguments>();
  Command app = program.add_command(
      "grade", "mark pictures of the lab's stages, and name the cause of what is wrong");
  arguments->add_to(app, Needs::perhaps);
  app.add("SUBMISSION", &arguments->submission,
          "a picture, or a folder, a zip archive, a .docx or a .pdf of pictures, best called 1 to 7 or by "
          "their stage");
  app.add("--all", &arguments->all, "SUBMISSION is a class's folder: mark all that is in it");
  app.add("--list", &arguments->list, "print the mistakes that are known, and do nothing else");
  app.add("--stage", &arguments->stage,
          "what SUBMISSION is of, whatever it is called: 1…7, or silhouette, ambient, diffuse,\n"
          "specular, shadows, reflection, refraction")
      .check(
          "a stage: 1…7, silhouette, ambient, diffuse, specular, shadows, reflection or refraction",
          [](const std::string& name) { return stage_named(name).has_value(); });
  app.add("--rubric", &arguments->rubric, "a JSON file with marks, tolerances and what is allowed");
  app.add("-o,--output", &arguments->output, "the file to write; - (default) is standard output");
  add_format_to(app, arguments->format);
  add_language_to(app, arguments->language);
  app.footer(
      "Upside down, red and blue swapped, gamma, JPEG, crops, scaled screenshots and window frames\n"
      "are found out and cost nothing. docs/grade.md explains the marks, and how sure they are.\n\n"
      "Examples:\n"
      "  zraka grade input.txt ana-anic/\n"
      "  zraka grade input.txt slika.png --lang hr\n"
      "  zraka grade input.txt ana-anic.zip -o ana-anic.html\n"
      "  zraka grade input.txt IMG_2026.png --stage shadows\n"
      "  zraka grade input.txt class/ --all --rubric rubric.json\n"
      "  zraka grade --list");
  app.check([arguments] {
    if (arguments->list) return "";
    if (arguments->scene.empty()) return "SCENE is required";
    return arguments->submission.empty() ? "SUBMISSION is required" : "";
  });
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
