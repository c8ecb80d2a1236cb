// SPDX-License-Identifier: Apache-2.0
// zraka render: a scene to a picture.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <future>

#include "commands.hpp"
#include "core/json.hpp"
#include "core/text.hpp"
#include "legend.hpp"
#include "progress.hpp"
#include "render_options.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

struct RenderCommandArguments : RenderArguments {
  std::string output;
  std::string stage = "refraction", mistake;
  int bits = 0;  // 0: the format's own
  bool transparent = false, legend = false;
  std::string layers;              // names with commas between them, or "all"
  std::string tone_map;            // "": clamp
  double exposure = 0, white = 0;  // 0: the curve's own
  int jpeg_quality = 0;            // 0: the usual one
  std::string stats;               // "", "text" or "json"
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
                     {"cut", {{"rays", s.rays.cut}, {"most", s.most_cut}, {"mean", s.mean_cut}}},
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
  if (s.rays.cut > 0)
    fmt::print("cut     {} rays not traced; a pixel lacks at most {:.3g}, on average {:.3g}\n",
               grouped(s.rays.cut), s.most_cut, s.mean_cut);
  fmt::print("memory  scene {} bytes, acceleration structure {} bytes\n", grouped(s.scene_bytes),
             grouped(s.accel_bytes));
  fmt::print("with    {} threads, {}\n", s.threads, name_of(s.isa));
  fmt::print("sha256  {}\n", hash);
}

constexpr std::string_view kAllLayers = "all";

std::vector<std::string> layer_words() {
  std::vector<std::string> words(kLayerNames.begin(), kLayerNames.end());
  words.emplace_back(kAllLayers);
  return words;
}

/// Names with commas between them; none where one is unknown.
std::optional<LayerSet> layers_named(const std::string& list) {
  if (list == kAllLayers) return LayerSet::all();
  LayerSet layers;
  for (std::string_view left = list; !left.empty();) {
    const std::size_t comma = std::min(left.find(','), left.size());
    const std::optional<Layer> layer = layer_named(left.substr(0, comma));
    if (!layer || comma + 1 == left.size()) return std::nullopt;
    layers.add(*layer);
    left.remove_prefix(std::min(comma + 1, left.size()));
  }
  return layers;
}

WriteOptions write_options(const RenderCommandArguments& arguments) {
  WriteOptions options;
  options.bits = arguments.bits;
  options.tone = {tone_curve_named(arguments.tone_map).value_or(ToneCurve::clamp),
                  arguments.exposure, arguments.white};
  if (arguments.jpeg_quality != 0) options.jpeg_quality = arguments.jpeg_quality;
  return options;
}

/// Why what is asked for does not go together, or "".
std::string problem_of(const RenderCommandArguments& arguments) {
  const std::optional<PictureFormat> format = picture_format_of(arguments.output);
  if (!format) return "";  // a folder has an error of its own
  const auto only = [&](std::string_view option, auto has) {
    std::string names;
    for (const PictureFormat& other : picture_formats())
      if (has(other)) names += fmt::format("{}{}", names.empty() ? "" : ", ", other.endings[0]);
    return fmt::format("{} is for {}, and not for {}", option, names, format->name);
  };
  if (arguments.bits != 0 && std::ranges::find(format->bits, arguments.bits) == format->bits.end())
    return fmt::format("--bits {} is not for {}, which has {}", arguments.bits, format->name,
                       fmt::join(format->bits, " or "));
  if (arguments.transparent && !format->alpha)
    return only("--transparent", [](const PictureFormat& other) { return other.alpha; });
  if (!arguments.layers.empty() && !format->layers)
    return only("--layers", [](const PictureFormat& other) { return other.layers; });
  const auto is_integer = [](const PictureFormat& other) { return !other.floats; };
  if (format->floats && !arguments.tone_map.empty()) return only("--tone-map", is_integer);
  if (format->floats && arguments.exposure != 0) return only("--exposure", is_integer);
  if (arguments.white != 0 && (arguments.tone_map.empty() || arguments.tone_map == "clamp"))
    return "--white is for --tone-map reinhard and filmic";
  if (arguments.jpeg_quality != 0 && format->name != "JPEG")
    return only("--jpeg-quality", [](const PictureFormat& other) { return other.name == "JPEG"; });
  if (arguments.legend && (arguments.transparent || !arguments.layers.empty()))
    return fmt::format("--legend makes the picture wider: it does not go with {}",
                       arguments.transparent ? "--transparent" : "--layers");
  if (!arguments.mistake.empty() && arguments.look.outlines > 0)
    return "--outlines are those of the right picture: they do not go with --mistake";
  if (!arguments.mistake.empty() && (arguments.transparent || !arguments.layers.empty()))
    return fmt::format("{} shows the right picture: it does not go with --mistake",
                       arguments.transparent ? "--transparent" : "--layers");
  return "";
}

int run(const RenderCommandArguments& arguments) {
  const auto since = [](auto start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  Seconds seconds;
  const auto start = std::chrono::steady_clock::now();
  std::vector<ColorLegend> legends;
  Result<Scene> scene = arguments.load({arguments.output}, {}, &legends);
  if (!scene) return fail(scene.error());
  if (arguments.legend && legends.empty())
    return fail(failure(arguments.scene, "there are no colours that --legend could explain",
                        "particles have some with --color-by COLUMN, or in a scene with color_by")
                    .value());
  const Color background = scene->background;
  seconds.load = since(start);

  RenderOptions options = arguments.options(*scene);
  options.terms = terms_of(*stage_named(arguments.stage), *scene);
  options.crop = arguments.sampling.crop_rect();
  options.layers = layers_named(arguments.layers).value_or(LayerSet());
  options.transparent = arguments.transparent;
  Result<Rendering> rendering;
  const Mistake mistake = mistake_of(arguments.mistake);
  {
    Progress progress(arguments.quiet);
    options.progress = progress.callback();
    rendering = mistake == Mistake::none ? render(std::move(*scene), options)
                                         : render_mistaken(*scene, options, mistake);
  }
  if (!rendering) return fail(rendering.error());

  if (arguments.legend) {
    Result<Image> explained =
        with_legends(rendering->image, legends, background, options.profile.transfer);
    if (!explained) return fail(explained.error());
    rendering->image = std::move(*explained);
  }
  std::future<std::string> hash;  // takes longer than writing, so it begins before
  if (!arguments.stats.empty())
    hash = std::async(options.threads == 1 ? std::launch::deferred : std::launch::async,
                      [&] { return sha256(rendering->image); });
  const auto written_from = std::chrono::steady_clock::now();
  WriteOptions writing = write_options(arguments);
  writing.transfer = options.profile.transfer;
  writing.threads = options.threads;
  const Result<void> written =
      write_image(rendering->image, rendering->layers, arguments.output, writing);
  if (!written) return fail(written.error());
  seconds.write = since(written_from);
  if (arguments.stats == "json") print_json(*rendering, seconds, hash.get());
  if (arguments.stats == "text") print_text(*rendering, seconds, hash.get());
  return kDone;
}

}  // namespace

void add_render(Command& program) {
  auto arguments = std::make_shared<RenderCommandArguments>();
  Command app = program.add_command("render", "render a scene to a picture");
  arguments->add_to(app);
  arguments->sampling.add_to(app);
  arguments->sampling.add_crop_to(app);
  arguments->look.add_to(app);
  app.add("--legend", &arguments->legend,
          "beside the picture, which becomes wider, what the colours of particles mean");
  add_mistake_to(app, arguments->mistake);
  check_picture_name(
      app.add("-o,--output", &arguments->output,
              "the picture to write: .png, .exr, .ppm, .pfm, .jpg or .hdr; - is standard output,\n"
              "for a PNG")
          .required());
  add_stage_to(app, arguments->stage);
  app.add("--bits", &arguments->bits,
          "bits of a value: 8 (default) or 16; of an .exr 16 (default) or 32")
      .one_of({"8", "16", "32"});
  app.add("--transparent", &arguments->transparent,
          "no background, but alpha that says where shapes are (.png, .exr)");
  app.add("--layers", &arguments->layers,
          fmt::format(
              "what else to store of each pixel (.exr): {}; with commas between them, or all",
              fmt::join(kLayerNames, ", ")))
      .check(fmt::format("a list of {}, with commas between them, or all",
                         fmt::join(kLayerNames, ", ")),
             [](const std::string& list) { return !list.empty() && layers_named(list); })
      .propose(layer_words);
  app.add("--tone-map", &arguments->tone_map,
          "how light becomes integers: clamp (default), reinhard or filmic")
      .check("clamp, reinhard or filmic",
             [](const std::string& name) { return tone_curve_named(name).has_value(); })
      .propose([] {
        return std::vector<std::string>{"clamp", "reinhard", "filmic"};
      });
  app.add("--exposure", &arguments->exposure, "in stops: 1 doubles the light before it is mapped")
      .range(-100, 100);
  app.add(
         "--white", &arguments->white,
         fmt::format("the light that becomes white with --tone-map reinhard (default {}) or filmic "
                     "({})",
                     kReinhardWhite, kFilmicWhite))
      .range(1e-6, 1e6);
  app.add("--jpeg-quality", &arguments->jpeg_quality, "1…100 (default 95)").range(1, 100);
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
      "  zraka render scene.toml -o part.png --samples 16 --crop 100,80,64,64\n"
      "  zraka render input.txt -o cut-out.png --transparent\n"
      "  zraka render run.lammpstrj -o half.png --cut 0,0,1,12 --color-by c_pe --legend\n"
      "  zraka render input.txt -o layers.exr --transparent --layers depth,normal,object-id");
  app.check([arguments] {
    for (const std::string& problem : {arguments->sampling.problem(), arguments->look.problem()})
      if (!problem.empty()) return problem;
    return problem_of(*arguments);
  });
  app.action([arguments] { return run(*arguments); });
}

}  // namespace zraka::app
