// SPDX-License-Identifier: Apache-2.0
// zraka quiz: questions about a scene's picture, with answers from the engine that draws it.
#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "commands.hpp"
#include "core/file.hpp"
#include "core/new_file.hpp"
#include "core/phrase.hpp"
#include "progress.hpp"
#include "render_options.hpp"
#include "school/quiz/view.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

std::optional<std::uint64_t> seed_named(const std::string& word) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), seed);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return seed;
}

struct QuizArguments : RenderArguments {
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
std::string QuizArguments::format_name() const {
  if (!format.empty()) return format;
  const std::string extension = std::filesystem::path(output).extension().string();
  return extension == ".json" ? "json" : extension == ".txt" ? "text" : "html";
}

std::string QuizArguments::output_name() const {
  return !output.empty() ? output : format_name() == "html" ? "quiz.html" : "-";
}

QuizOptions QuizArguments::quiz() const {
  QuizOptions options{.seed = *seed_named(seed), .questions = questions, .language = language};
  if (!kinds.empty()) options.kinds.clear();
  for (const std::string& kind : kinds) options.kinds.insert(*quiz_kind_named(kind));
  return options;
}

std::string QuizArguments::contradiction() const {
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
Result<std::vector<std::string>> write_pictures(const QuizArguments& arguments, const Quiz& quiz) {
  std::vector<std::string> files;
  if (arguments.pictures.empty()) return files;
  const Result<void> folder = make_folder(arguments.pictures);
  if (!folder) return tl::make_unexpected(folder.error());
  for (std::size_t i = 0; i < quiz.pictures.size(); ++i)
    files.push_back(
        (std::filesystem::path(arguments.pictures) / fmt::format("picture-{}.png", i + 1))
            .string());
  std::vector<std::string> outputs = files;
  outputs.push_back(arguments.output_name());
  outputs.push_back(arguments.answers);
  if (const Result<void> good = check_outputs({arguments.scene}, outputs); !good)
    return tl::make_unexpected(good.error());
  for (std::size_t i = 0; i < quiz.pictures.size(); ++i) {
    const Result<void> written = write_text_file(files[i], quiz.pictures[i].png);
    if (!written) return tl::make_unexpected(written.error());
  }
  return files;
}

Result<void> write(const QuizArguments& arguments, const Quiz& quiz, const QuizView& view) {
  const std::string format = arguments.format_name();
  const auto made = [&](const auto& html, const auto& json, const auto& text) -> std::string {
    return format == "html" ? html() : format == "json" ? json() : text();
  };
  Result<void> written =
      write_text_file(arguments.output_name(), made([&] { return quiz_page(quiz, view); },
                                                    [&] { return quiz_json(quiz, view); },
                                                    [&] { return quiz_text(quiz, view); }));
  if (!written || arguments.answers.empty()) return written;
  return write_text_file(arguments.answers, made([&] { return quiz_answers_page(quiz, view); },
                                                 [&] { return quiz_answers_json(quiz); },
                                                 [&] { return quiz_answers_text(quiz, view); }));
}

int run(const QuizArguments& arguments) {
  speak(*language_named(arguments.language));
  const Result<Scene> scene = arguments.load({arguments.output_name(), arguments.answers});
  if (!scene) return fail(scene.error());
  RenderOptions options = arguments.options(*scene);
  options.terms = terms_of(*stage_named(arguments.stage), *scene);
  const Result<Quiz> quiz = [&] {
    Progress progress(arguments.quiet);
    options.progress = progress.callback();
    return make_quiz(*scene, options, arguments.quiz());
  }();
  if (!quiz) return fail(quiz.error());
  if (quiz->questions.size() < static_cast<std::size_t>(arguments.questions) && !arguments.quiet)
    show({problem(Severity::warning, arguments.scene == "-" ? "standard input" : arguments.scene,
                  phrase(Word::quiz_fewer, quiz->questions.size(), arguments.questions))});
  const Result<std::vector<std::string>> files = write_pictures(arguments, *quiz);
  if (!files) return fail(files.error());
  const QuizView view{.language = *language_named(arguments.language),
                      .scene = arguments.scene == "-"
                                   ? "-"
                                   : std::filesystem::path(arguments.scene).filename().string(),
                      .resolution = scene->resolution,
                      .profile = arguments.profile_name(*scene),
                      .max_depth = options.max_depth,
                      .seed = *seed_named(arguments.seed),
                      .answers = arguments.answers.empty(),
                      .files = *files};
  const Result<void> written = write(arguments, *quiz, view);
  if (!written) return fail(written.error());
  if (arguments.quiet) return kDone;
  for (const std::string& name : {arguments.output_name(), arguments.answers})
    if (!name.empty() && arguments.output_name() != "-" && arguments.answers != "-")
      print_name(name);
  return kDone;
}

void add_options(Command& app, QuizArguments& arguments) {
  app.add("-o,--output", &arguments.output,
          "the file to write: quiz.html, or - (standard output) for JSON and text, if not "
          "given");
  app.add("--answers", &arguments.answers,
          "write the answers into this file, and nothing of them into the quiz");
  app.add("--seed", &arguments.seed,
          "another number, another quiz (default 1); the same one, the same quiz")
      .check("a whole number, 0 or more",
             [](const std::string& word) { return seed_named(word).has_value(); });
  app.add("--questions", &arguments.questions, "how many (default 10)").range(1, kMaxQuestions);
  app.add("--kind", &arguments.kinds,
          "stage (what is missing?), mistake (what is wrong?) or color (what colour has "
          "this pixel?); may be given more than once; all, if not given")
      .check("stage, mistake or color",
             [](const std::string& word) { return quiz_kind_named(word).has_value(); });
  add_stage_to(app, arguments.stage);
  app.add("--format", &arguments.format,
          "html, json or text; else by the name of the output, else html")
      .one_of({"html", "json", "text"});
  app.add("--pictures", &arguments.pictures,
          "a folder for the pictures of JSON and text; JSON has them in it otherwise");
  add_language_to(app, arguments.language);
}

}  // namespace

void add_quiz(Command& program) {
  auto arguments = std::make_shared<QuizArguments>();
  Command app = program.add_command(
      "quiz", "questions about a scene's picture, with answers and reasons from the engine");
  arguments->add_to(app);
  add_options(app, *arguments);
  app.footer(
      "Examples:\n"
      "  zraka quiz scenes/lab/input.txt\n"
      "  zraka quiz input.txt -o kviz.html --lang hr --seed 7 --questions 6\n"
      "  zraka quiz input.txt -o test.html --answers answers.html --seed 20417\n"
      "  zraka quiz input.txt --kind color --format text\n"
      "  zraka quiz input.txt --stage shadows --kind mistake --format json -o quiz.json");
  app.check([arguments] { return arguments->contradiction(); });
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
