// SPDX-License-Identifier: Apache-2.0
// zraka report: what the lab's sheet wants handed in, written from what was measured.
#include <fmt/format.h>

#include <filesystem>

#include "commands.hpp"
#include "core/file.hpp"
#include "core/new_file.hpp"
#include "core/phrase.hpp"
#include "core/text.hpp"
#include "image/alter.hpp"
#include "image/page_picture.hpp"
#include "progress.hpp"
#include "render_options.hpp"
#include "school/generate/letter.hpp"
#include "school/report/archive.hpp"
#include "school/report/page.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

constexpr std::uint32_t kMostLetterPixels = 2000;

struct ReportArguments : RenderArguments {
  std::string folder, letter, author, language = "en";
  bool zip = false;
};

/// All that a report consists of, before any of it is written.
struct Report {
  std::vector<NamedBytes> files;
  std::array<ReportPicture, 7> pictures;
  std::optional<ReportLetter> letter;
};

Result<void> add_stage(Report& report, Language language, Stage stage,
                       const StagePictures& pictures) {
  const auto i = static_cast<std::size_t>(stage) - 1;
  const auto name = static_cast<Word>(static_cast<std::size_t>(Word::file_silhouette) + i);
  ReportPicture& of_page = report.pictures[i];
  const auto add = [&](const Image& image, const std::string& file,
                       std::string& png) -> Result<void> {
    const Result<std::string> bytes = encode_png(image);
    if (!bytes) return tl::make_unexpected(bytes.error());
    const Result<std::string> small = png_for_page(image);
    if (!small) return tl::make_unexpected(small.error());
    png = *small;
    report.files.push_back({file + ".png", *bytes});
    return {};
  };
  Result<void> added =
      add(pictures.picture, fmt::format("{}-{}", i + 1, text_of(language, name)), of_page.picture);
  if (added && stage != Stage::silhouette)
    added = add(pictures.changes, say(language, Word::file_difference, i, i + 1), of_page.changes);
  of_page.brightest = pictures.brightest;
  return added;
}

Result<void> add_letter(Report& report, Language language, const std::string& text,
                        const Scene& of_stages, RenderOptions options) {
  LetterOptions letter;
  letter.resolution = std::min(std::max(of_stages.resolution.width, of_stages.resolution.height),
                               kMostLetterPixels);
  const Result<Scene> scene = generate_letter(text, letter);
  if (!scene) return tl::make_unexpected(scene.error());
  options.profile = profile_of(scene->defaults.profile);
  const Result<Rendering> rendering = render(*scene, options);
  if (!rendering) return tl::make_unexpected(rendering.error());
  const Image stored = as_stored(rendering->image, options.profile.transfer, 8);
  const Result<std::string> png = encode_png(stored), small = png_for_page(stored),
                            input = write_lab_input(*scene);
  for (const Result<std::string>* made : {&png, &small, &input})
    if (!*made) return tl::make_unexpected(made->error());
  const std::string name(text_of(language, Word::file_letter));
  report.files.push_back({fmt::format("8-{}.png", name), *png});
  report.files.push_back({name + ".txt", *input});
  report.letter = ReportLetter{text, scene->shape_count(), rendering->stats, *small};
  return {};
}

int run(const ReportArguments& arguments) {
  speak(*language_named(arguments.language));
  const Language language = *language_named(arguments.language);
  const std::string archive = archive_name(arguments.author);
  if (arguments.zip && archive.empty())
    return fail(failure("", phrase(Word::report_no_letter, shown(arguments.author)),
                        phrase(Word::report_name_in_latin, "--author", "Ana Šarić"))
                    .value());
  Result<Scene> scene = arguments.load({});
  if (!scene) return fail(scene.error());
  // The pictures of two stages, their difference, and all files are in memory at once.
  const std::uint64_t pixels = std::uint64_t{scene->resolution.width} * scene->resolution.height;
  if (pixels > kMaxPixels / 8)
    return fail(failure(arguments.scene, phrase(Word::stages_pixels, pixels, kMaxPixels / 8),
                        phrase(Word::quiz_smaller))
                    .value());
  const Result<void> folder = make_folder(arguments.folder);
  if (!folder) return fail(folder.error());

  Report report;
  RenderOptions options = arguments.options(*scene);
  Result<SceneFacts> facts = [&] {
    Progress progress(arguments.quiet);
    options.progress = progress.callback();
    return measure_stages(*scene, options, [&](Stage stage, const StagePictures& pictures) {
      return add_stage(report, language, stage, pictures);
    });
  }();
  if (!facts) return fail(facts.error());
  options.progress = {};
  const std::string letter =
      arguments.letter.empty() ? initial_of(arguments.author) : arguments.letter;
  if (!letter.empty()) {
    const Result<void> added = add_letter(report, language, letter, *scene, options);
    if (!added) return fail(added.error());
  }
  const std::string scene_name =
      arguments.scene == "-" ? "-" : std::filesystem::path(arguments.scene).filename().string();
  report.files.push_back(
      {fmt::format("{}.html", text_of(language, Word::file_report)),
       report_page(*facts, report.pictures, report.letter,
                   {language, scene_name, arguments.author, arguments.profile_name(*scene)})});

  const std::filesystem::path out(arguments.folder);
  if (arguments.zip) {
    Result<std::string> zip = zip_of(report.files);
    if (!zip) return fail(zip.error());
    report.files.push_back({archive, std::move(*zip)});
  }
  std::vector<std::string> outputs;
  for (const NamedBytes& file : report.files) outputs.push_back((out / file.name).string());
  if (const Result<void> good = check_outputs({arguments.scene}, outputs); !good)
    return fail(good.error());
  for (const NamedBytes& file : report.files) {
    const Result<void> written = write_text_file((out / file.name).string(), file.bytes);
    if (!written) return fail(written.error());
    if (!arguments.quiet) print_name((out / file.name).string());
  }
  return kDone;
}

}  // namespace

void add_report(Command& program) {
  auto arguments = std::make_shared<ReportArguments>();
  Command app = program.add_command(
      "report",
      "what the lab's sheet wants handed in: the stages, what each changed and why, as a page");
  arguments->add_to(app);
  app.add("-o,--output", &arguments->folder,
          "the folder for the report; made if it is not there, files of the same names are "
          "replaced")
      .required();
  app.add("--letter", &arguments->letter,
          "the letter or word of the eighth picture; else the surname's first letter");
  app.add("--author", &arguments->author, "whose report it is");
  add_language_to(app, arguments->language);
  app.add("--zip", &arguments->zip,
          "also pack all into OVO-V3-Rezultati-<ImePrezime>.zip, named after the author");
  app.check([arguments] {
    return arguments->zip && arguments->author.empty() ? "--zip needs --author" : "";
  });
  app.footer(
      "The sheet also wants your source code and program in the archive: add them.\n"
      "Examples:\n"
      "  zraka report scenes/lab/input.txt -o report\n"
      "  zraka report input.txt -o izvjestaj --lang hr --author 'Ana Šarić' --zip\n"
      "  zraka report input.txt -o report --letter Č --width 800");
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
