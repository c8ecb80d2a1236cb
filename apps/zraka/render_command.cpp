// SPDX-License-Identifier: Apache-2.0
// zraka render: a scene to a picture.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <future>

#include "commands.hpp"
#include "core/json.hpp"
#include "core/text.hpp"
#include "progress.hpp"
#include "render_options.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

struct Arguments : RenderArguments {
  std::string output;
  std::string stage = "refraction", mistake;
  int bits = 8;
  std::string stats;  // "", "text" or "json"
};

struct Seconds {
  double load = 0, write = 0;
};

void print_json(const Rendering& rendering, const Seconds& seconds, const std::string& hash) {
  const RenderStats& s = rendering.stats;
  const Json json = {{"seconds",
                      {{"load", seconds.load},
                       {"build", s.build_seconds},
                       {"render", s.render_seconds},
                       {"write", seconds.write}}},
                     {"rays",
                      {{"camera", s.rays.camera},
                       {"shadow", s.rays.shadow},
                       {"reflected", s.rays.reflected},
                       {"refracted", s.rays.refracted}}},
                     {"samples_per_pixel", s.samples_per_pixel},
                     {"hits", s.rays.hits},
                     {"bytes", {{"scene", s.scene_bytes}, {"accel", s.accel_bytes}}},
                     {"threads", s.threads},
                     {"isa", name_of(s.isa)},
                     {"sha256", hash}};
  std::puts(json.dump(2).c_str());
}

void print_text(const Rendering& rendering, const Seconds& seconds, const std::string& hash) {
  const RenderStats& s = rendering.stats;
  const auto ms = [](double t) { return t * 1000; };
  fmt::print("time    load {:.1f} ms, build {:.1f} ms, render {:.1f} ms, write {:.1f} ms\n",
             ms(seconds.load), ms(s.build_seconds), ms(s.render_seconds), ms(seconds.write));
  fmt::print("rays    {} camera, {} shadow, {} reflected, {} refracted; {:.1f} M a second\n",
             grouped(s.rays.camera), grouped(s.rays.shadow), grouped(s.rays.reflected),
             grouped(s.rays.refracted),
             static_cast<double>(s.rays.total()) / s.render_seconds / 1e6);
  if (s.samples_per_pixel != 1) fmt::print("samples {:.4g} a pixel\n", s.samples_per_pixel);
  fmt::print("hits    {}\n", grouped(s.rays.hits));
  fmt::print("memory  scene {} bytes, acceleration structure {} bytes\n", grouped(s.scene_bytes),
             grouped(s.accel_bytes));
  fmt::print("with    {} threads, {}\n", s.threads, name_of(s.isa));
  fmt::print("sha256  {}\n", hash);
}

int run(const Arguments& arguments) {
  const auto since = [](auto start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  Seconds seconds;
  const auto start = std::chrono::steady_clock::now();
  Result<Scene> scene = arguments.load({arguments.output});
  if (!scene) return fail(scene.error());
  seconds.load = since(start);

  RenderOptions options = arguments.options(*scene);
  options.terms = terms_of(*stage_named(arguments.stage), *scene);
  options.crop = arguments.sampling.crop_rect();
  Result<Rendering> rendering;
  const Mistake mistake = mistake_of(arguments.mistake);
  {
    Progress progress(arguments.quiet);
    options.progress = progress.callback();
    rendering = mistake == Mistake::none ? render(std::move(*scene), options)
                                         : render_mistaken(*scene, options, mistake);
  }
  if (!rendering) return fail(rendering.error());

  std::future<std::string> hash;  // takes longer than writing, so it begins before
  if (!arguments.stats.empty())
    hash = std::async(options.threads == 1 ? std::launch::deferred : std::launch::async,
                      [&] { return sha256(rendering->image); });
  const auto written_from = std::chrono::steady_clock::now();
  const Result<void> written =
      write_png(rendering->image, arguments.output,
                {arguments.bits, options.profile.transfer, options.threads});
  if (!written) return fail(written.error());
  seconds.write = since(written_from);
  if (arguments.stats == "json") print_json(*rendering, seconds, hash.get());
  if (arguments.stats == "text") print_text(*rendering, seconds, hash.get());
  return kDone;
}

}  // namespace

void add_render(Command& program) {
  auto arguments = std::make_shared<Arguments>();
  Command app = program.add_command("render", "render a scene to a picture");
  arguments->add_to(app);
  arguments->sampling.add_to(app);
  arguments->sampling.add_crop_to(app);
  add_mistake_to(app, arguments->mistake);
  check_png_name(
      app.add("-o,--output", &arguments->output, "the PNG to write; - is standard output")
          .required());
  add_stage_to(app, arguments->stage);
  app.add("--bits", &arguments->bits, "bits of a channel: 8 (default) or 16")
      .check("8 or 16", [](const std::string& bits) { return bits == "8" || bits == "16"; });
  app.add_flag("--stats", "text", arguments->stats,
               "print times, rays, memory and the picture's SHA-256; --stats=json for programs")
      .one_of({"text", "json"});
  app.footer(
      "Examples:\n"
      "  zraka render scenes/lab/input.txt -o picture.png\n"
      "  zraka render input.txt -o shadows.png --stage shadows\n"
      "  zraka render input.txt -o large.png --width 2160 --stats\n"
      "  zraka render input.txt -o glass.png --profile physical --max-depth 12\n"
      "  zraka render scene.toml -o smooth.png --quality final\n"
      "  zraka render scene.toml -o edges.png --adaptive 4,64,0.05 --filter mitchell --stats\n"
      "  zraka render scene.toml -o part.png --samples 16 --crop 100,80,64,64");
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
