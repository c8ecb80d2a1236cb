// SPDX-License-Identifier: Apache-2.0
// embree_rival: what a careful Whitted renderer on Embree does with a scene, by the rules of
// `zraka render --profile spd`. Prints times and counts as JSON.
#include <fmt/format.h>
#include <pmmintrin.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <xmmintrin.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <zraka/zraka.hpp>

#include "tracer.hpp"

namespace {

using namespace zraka;
using embree::Counts;
using embree::Mode;
using embree::Tracer;
using embree::World;

struct Words {
  std::string scene, output, isa;
  Mode mode = Mode::packets;
  embree::Spheres spheres = embree::Spheres::callbacks;
  int threads = 0, max_depth = 4, repeats = 1;
  std::uint32_t width = 0;
};

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string embree_version(RTCDevice device) {
  const auto part = [&](RTCDeviceProperty which) { return rtcGetDeviceProperty(device, which); };
  return fmt::format("{}.{}.{}", part(RTC_DEVICE_PROPERTY_VERSION_MAJOR),
                     part(RTC_DEVICE_PROPERTY_VERSION_MINOR),
                     part(RTC_DEVICE_PROPERTY_VERSION_PATCH));
}

Counts render(const World& world, const Words& words, Image& corners) {
  constexpr std::uint32_t kTile = Tracer::kTile;
  const std::uint32_t columns = (corners.width + kTile - 1) / kTile,
                      rows = (corners.height + kTile - 1) / kTile;
  tbb::enumerable_thread_specific<Tracer> tracers(
      [&] { return Tracer(world, words.mode, words.max_depth); });
  tbb::parallel_for(std::uint32_t{0}, columns * rows, [&](std::uint32_t tile) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    tracers.local().trace_tile(tile % columns * kTile, tile / columns * kTile,
                               corners.pixels.data());
  });
  Counts sum;
  for (const Tracer& tracer : tracers) {
    sum.camera += tracer.counts().camera;
    sum.shadow += tracer.counts().shadow;
    sum.reflected += tracer.counts().reflected;
    sum.refracted += tracer.counts().refracted;
  }
  return sum;
}

Image means_of_corners(const Image& corners) {
  Image image(corners.width - 1, corners.height - 1);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const float *above = corners.row(y), *below = corners.row(y + 1);
    for (std::size_t i = 0; i < std::size_t{3} * image.width; ++i)
      image.row(y)[i] = (above[i] + above[i + 3] + below[i] + below[i + 3]) * 0.25f;
  }
  return image;
}

int fail(const Diagnostics& diagnostics) {
  for (const Diagnostic& d : diagnostics) fmt::print(stderr, "{}", to_string(d));
  return 1;
}

int run(const Words& words) {
  auto start = std::chrono::steady_clock::now();
  Result<ReadScene> read = read_scene(words.scene);
  if (!read) return fail(read.error());
  Scene& scene = read->scene;
  if (words.width > 0) {
    scene.resolution.height =
        std::max(1u, words.width * scene.resolution.height / scene.resolution.width);
    scene.resolution.width = words.width;
  }
  const double load = since(start);

  const int threads = words.threads > 0 ? words.threads : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  start = std::chrono::steady_clock::now();
  const std::uint64_t shapes = scene.shape_count();
  const World world(std::move(scene), words.spheres, words.isa);
  if (world.device == nullptr) return fail(failure("", "Embree cannot start").value());
  const double build = since(start);

  Image corners(world.width + 1, world.height + 1);
  std::vector<double> seconds;
  Counts counts;
  for (int i = 0; i < words.repeats; ++i) {
    start = std::chrono::steady_clock::now();
    counts = render(world, words, corners);
    seconds.push_back(since(start));
  }
  std::sort(seconds.begin(), seconds.end());

  const Result<void> written =
      write_png(means_of_corners(corners), words.output, {8, Transfer::linear});
  if (!written) return fail(written.error());
  const nlohmann::ordered_json json = {
      {"seconds", {{"load", load}, {"build", build}, {"render", seconds[seconds.size() / 2]}}},
      {"rays",
       {{"camera", counts.camera},
        {"shadow", counts.shadow},
        {"reflected", counts.reflected},
        {"refracted", counts.refracted}}},
      {"shapes", shapes},
      {"bytes", {{"scene", world.scene_bytes()}, {"accel", world.embree_bytes()}}},
      {"embree", embree_version(world.device)},
      {"packet", world.packet()},
      {"threads", threads}};
  fmt::print("{}\n", json.dump(2));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("A Whitted renderer on Embree, to measure zraka by.");
  Words words;
  std::string mode = "packets", spheres = "callbacks";
  app.add_option("SCENE", words.scene, "a scene that zraka reads")->required();
  app.add_option("-o,--output", words.output, "the PNG to write")->required();
  app.add_option("--mode", mode, "how rays are handed to Embree")
      ->check(CLI::IsMember({"packets", "single"}));
  app.add_option("--spheres", spheres,
                 "how spheres are: callbacks (faster rays) or Embree's own points (smaller)")
      ->check(CLI::IsMember({"callbacks", "points"}));
  std::vector<std::string> isas;
  for (const embree::Isa& isa : embree::offered_isas()) isas.push_back(isa.name);
  app.add_option("--isa", words.isa, "Embree's instruction set; its best unless told")
      ->check(CLI::IsMember(isas));
  app.add_flag_callback(
      "--list-isas",
      [&] {
        for (const std::string& isa : isas) fmt::print("{}\n", isa);
        throw CLI::Success();
      },
      "print the instruction sets that Embree offers here");
  app.add_option("--width", words.width, "width of the picture, in pixels")
      ->check(CLI::Range(1u, 16384u));
  app.add_option("--threads", words.threads, "how many threads; 0 is all that there are")
      ->check(CLI::Range(0, kMaxThreads));
  app.add_option("--max-depth", words.max_depth, "levels of rays after the first")
      ->check(CLI::Range(0, 12));
  app.add_option("--repeats", words.repeats, "renders the picture so often, tells the median")
      ->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  if (mode == "single") words.mode = Mode::single;
  if (spheres == "points") words.spheres = embree::Spheres::points;
  return run(words);
}
