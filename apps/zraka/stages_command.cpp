// SPDX-License-Identifier: Apache-2.0
// zraka stages: the lab's seven pictures, what each stage changed, and all of them on one sheet.
#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "commands.hpp"
#include "contact_sheet.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "progress.hpp"
#include "render_options.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

constexpr std::size_t kStages = kStageNames.size();
constexpr std::uint32_t kThumbnail = 240;
constexpr const char* kSheetFile = "contact-sheet.png";

struct StagesArguments : RenderArguments {
  std::string folder, mistake;
};

Result<std::array<Image, kStages>> render_stages(const StagesArguments& arguments,
                                                 const Scene& scene, RenderOptions options) {
  std::array<Image, kStages> images;
  for (std::size_t i = 0; i < kStages; ++i) {
    options.terms = terms_of(static_cast<Stage>(i + 1), scene);
    Progress progress(arguments.quiet);
    options.progress = progress.callback();
    Result<Rendering> rendering = render_mistaken(scene, options, mistake_of(arguments.mistake));
    if (!rendering) return tl::make_unexpected(rendering.error());
    images[i] = std::move(rendering->image);
  }
  return images;
}

std::string stage_file(std::size_t i) {
  return fmt::format("{}-{}.png", i + 1, kStageNames[i]);
}

std::string difference_file(std::size_t i) {
  return fmt::format("difference-{}-{}.png", i + 1, i + 2);
}

int run(const StagesArguments& arguments) {
  const std::filesystem::path out(arguments.folder);
  std::vector<std::string> outputs = {(out / kSheetFile).string()};
  for (std::size_t i = 0; i < kStages; ++i) {
    outputs.push_back((out / stage_file(i)).string());
    if (i + 1 < kStages) outputs.push_back((out / difference_file(i)).string());
  }
  const Result<Scene> scene = arguments.load(outputs);
  if (!scene) return fail(scene.error());
  // Seven pictures and six differences are in memory at once.
  const std::uint64_t pixels = std::uint64_t{scene->resolution.width} * scene->resolution.height;
  if (pixels > kMaxPixels / 8)
    return fail(
        failure(arguments.scene,
                fmt::format("its stages have {} pixels each: {} at most", pixels, kMaxPixels / 8),
                "ask for smaller pictures with --width")
            .value());
  const Result<void> folder = make_folder(arguments.folder);
  if (!folder) return fail(folder.error());
  const RenderOptions options = arguments.options(*scene);
  const Result<std::array<Image, kStages>> images = render_stages(arguments, *scene, options);
  if (!images) return fail(images.error());

  std::vector<Captioned> stages, changes;
  std::array<Difference, kStages - 1> differences;
  Result<void> written;
  const auto write = [&](const Image& image, const std::string& name) {
    if (written)
      written =
          write_png(image, (out / name).string(), {8, options.profile.transfer, options.threads});
  };
  for (std::size_t i = 0; i < kStages; ++i) {
    write((*images)[i], stage_file(i));
    stages.push_back({&(*images)[i], fmt::format("{} {}", i + 1, kStageNames[i])});
  }
  for (std::size_t i = 0; i + 1 < kStages; ++i) {
    differences[i] = difference((*images)[i], (*images)[i + 1], options.profile.transfer);
    write(differences[i].image, difference_file(i));
    changes.push_back({&differences[i].image,
                       fmt::format("{} to {}, ×{:.1f}", i + 1, i + 2, differences[i].gain)});
  }
  write(contact_sheet({stages, changes}, kThumbnail), kSheetFile);
  if (!written) return fail(written.error());
  if (arguments.quiet) return kDone;

  print_name((out / kSheetFile).string());
  for (std::size_t i = 0; i < kStages; ++i) {
    print_name((out / stage_file(i)).string());
    if (i + 1 == kStages) break;
    fmt::print("  {} (amplified {:.1f} times): {} of {} pixels change\n",
               for_output((out / difference_file(i)).string()), differences[i].gain,
               grouped(differences[i].pixels), grouped(pixels));
  }
  return kDone;
}

}  // namespace

void add_stages(Command& program) {
  auto arguments = std::make_shared<StagesArguments>();
  Command app = program.add_command(
      "stages", "render the lab's seven stages, the differences between them, and a contact sheet");
  arguments->add_to(app);
  arguments->sampling.add_to(app);
  add_mistake_to(app, arguments->mistake);
  app.add("-o,--output", &arguments->folder, "the folder for the pictures; made if it is not there")
      .required();
  app.footer(
      "Examples:\n"
      "  zraka stages scenes/lab/input.txt -o pictures\n"
      "  zraka stages input.txt -o large --width 1080");
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
