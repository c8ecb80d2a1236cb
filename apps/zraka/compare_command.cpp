// SPDX-License-Identifier: Apache-2.0
// zraka compare: how far two pictures are apart, and where.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>

#include "commands.hpp"
#include "compare/words.hpp"
#include "core/json.hpp"
#include "core/new_file.hpp"
#include "core/text.hpp"
#include "render_options.hpp"
#include "terminal.hpp"
#include "zraka/zraka.hpp"

namespace zraka::app {
namespace {

/// What diff and cmp end with, so that a script can tell pictures that differ from pictures that
/// nobody has compared.
enum CompareCode { kWithin = 0, kDiffer = 1, kTrouble = 2 };

/// Both pictures, what is compared of them and the filters' rows are in memory at once: 8K fits.
constexpr std::uint64_t kMostPixels = kMaxPixels / 4;

struct CompareArguments {
  std::string a, b;
  CompareOptions options;
  std::string format = "text", transfer = "srgb";
  std::string heat, heat_of = "difference", html;
  bool quiet = false;
};

int trouble(const Diagnostics& problems) {
  show(problems);
  return kTrouble;
}

std::string name_of_input(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

Json json_of(const ReadImage& read, const std::string& name) {
  return {{"file", name},
          {"format", read.format},
          {"width", read.image.width},
          {"height", read.image.height},
          {"bits", read.bits},
          {"floats", read.floats},
          {"transparent", read.alpha}};
}

Json json_of(const std::vector<PixelPair>& pairs, const Comparison& c) {
  Json list = Json::array();
  const auto values = [&](const std::array<float, 3>& pixel) {
    Json json = Json::array();
    for (const float v : pixel) {
      if (c.floats)
        json.push_back(v);
      else
        json.push_back(quantize(v, Transfer::linear, c.bits));
    }
    return json;
  };
  for (const PixelPair& pair : pairs)
    list.push_back({{"x", pair.x},
                    {"y", pair.y},
                    {"a", values(pair.a)},
                    {"b", values(pair.b)},
                    {"difference", steps_of(pair.difference)}});
  return list;
}

void print(const Json& json) {
  // Names of files may be anything; what is no UTF-8 is replaced.
  std::puts(json.dump(2).c_str());
}

void print_json(const Comparison& c, const CompareArguments& arguments) {
  const Errors& e = c.errors;
  Json json = {{"within", c.within},
               {"equal", e.largest == 0},
               {"same_size", true},
               {"a", json_of(c.a, name_of_input(arguments.a))},
               {"b", json_of(c.b, name_of_input(arguments.b))},
               {"compared", {{"bits", c.bits}, {"floats", c.floats}}},
               {"unit", "1/255"},
               {"tolerance", c.options.tolerance},
               {"allow", c.options.allow},
               {"over", {{"pixels", e.over}, {"share", e.share()}, {"box", nullptr}}},
               {"largest", steps_of(e.largest)},
               {"mean", 255 * e.mean},
               {"rmse", 255 * e.root_mean_square()},
               {"psnr_db", nullptr},
               {"ssim", nullptr},
               {"flip", {{"mean", c.flip.mean}, {"largest", c.flip.largest}}},
               {"first", json_of(c.first, c)},
               {"worst", json_of(c.worst, c)}};
  if (e.over > 0)
    json["over"]["box"] = {
        {"left", e.box.left}, {"top", e.box.top}, {"right", e.box.right}, {"bottom", e.box.bottom}};
  if (e.mean_square > 0) json["psnr_db"] = e.peak_signal_to_noise();
  if (c.similarity) json["ssim"] = *c.similarity;
  print(json);
}

void print_text(const Comparison& c, const CompareArguments& arguments) {
  fmt::print("{}\n", verdict_on(c));
  const auto print_lines = [](const Lines& lines) {
    for (const auto& [label, value] : lines) fmt::print("  {:<9} {}\n", label, value);
  };
  print_lines(measure_lines(c, shown_line(name_of_input(arguments.a)),
                            shown_line(name_of_input(arguments.b))));
  print_lines(pixel_lines(c));
}

int sizes_differ(const ReadImage& a, const ReadImage& b, const CompareArguments& arguments) {
  if (arguments.quiet) return kDiffer;
  if (arguments.format == "json") {
    print({{"within", false},
           {"equal", false},
           {"same_size", false},
           {"a", json_of(a, name_of_input(arguments.a))},
           {"b", json_of(b, name_of_input(arguments.b))}});
    return kDiffer;
  }
  fmt::print("The pictures have different sizes.\n  A         {}: {}\n  B         {}: {}\n",
             shown_line(name_of_input(arguments.a)), describe(a),
             shown_line(name_of_input(arguments.b)), describe(b));
  if (!arguments.heat.empty() || !arguments.html.empty())
    fmt::print("  There is nothing to draw: no heat map and no page were written.\n");
  return kDiffer;
}

Result<void> write_heat(const Comparison& c, const CompareArguments& arguments) {
  const std::uint32_t width = c.a.image.width, height = c.a.image.height;
  if (arguments.heat_of == "flip")
    return write_png(heat_picture(c.flip.map, width, height), arguments.heat);
  const std::vector<float> map = difference_map(c.a.image, c.b.image);
  return write_png(heat_picture(map, width, height, brightest_difference(map)), arguments.heat);
}

/// A page is handed on, so it names files without their folders, unless only these differ.
Result<void> write_page(const Comparison& c, const CompareArguments& arguments) {
  std::string a = std::filesystem::path(name_of_input(arguments.a)).filename().string();
  std::string b = std::filesystem::path(name_of_input(arguments.b)).filename().string();
  if (a == b) a = name_of_input(arguments.a), b = name_of_input(arguments.b);
  const Result<std::string> page = comparison_page(c, a, b);
  if (!page) return tl::make_unexpected(page.error());
  return write_text_file(arguments.html, *page);
}

void warn_of_curve(const Comparison& c, const CompareArguments& arguments) {
  Diagnostic note;
  note.severity = Severity::warning;
  note.file = name_of_input(c.a.floats ? arguments.b : arguments.a);
  note.message = fmt::format(
      "agrees much better (RMSE {:.4g} of 255) if it was written {} the sRGB "
      "curve",
      255 * *c.better_by_other_transfer, arguments.transfer == "srgb" ? "without" : "with");
  note.hint =
      fmt::format("compare with --transfer {}", arguments.transfer == "srgb" ? "linear" : "srgb");
  show({note});
}

int run(CompareArguments arguments) {
  arguments.options.transfer = arguments.transfer == "srgb" ? Transfer::srgb : Transfer::linear;
  Result<ReadImage> a = read_image(arguments.a, kMostPixels);
  Result<ReadImage> b = read_image(arguments.b, kMostPixels);
  if (!a) show(a.error());
  if (!b) show(b.error());
  if (!a || !b) return kTrouble;
  if (a->image.width != b->image.width || a->image.height != b->image.height)
    return sizes_differ(*a, *b, arguments);
  arguments.options.perception =
      !arguments.quiet || !arguments.html.empty() || arguments.heat_of == "flip";
  const Result<Comparison> c = compare(std::move(*a), std::move(*b), arguments.options);
  if (!c) return trouble(c.error());
  if (!arguments.heat.empty())
    if (const Result<void> written = write_heat(*c, arguments); !written)
      return trouble(written.error());
  if (!arguments.html.empty())
    if (const Result<void> written = write_page(*c, arguments); !written)
      return trouble(written.error());
  if (!arguments.quiet && c->better_by_other_transfer) warn_of_curve(*c, arguments);
  if (!arguments.quiet && arguments.format == "json") print_json(*c, arguments);
  if (!arguments.quiet && arguments.format == "text") print_text(*c, arguments);
  return c->within ? kWithin : kDiffer;
}

/// Nothing where the outputs have names of their own, else what is wrong.
std::string problem_of_names(const CompareArguments& arguments) {
  if (arguments.a == "-" && arguments.b == "-")
    return "Only one of the pictures can be standard input.";
  if (arguments.heat == "-" && arguments.html == "-")
    return "Only one output can be standard output.";
  return "";
}

/// run(), with the exit codes of this command also where memory or the output's disk ends.
int run_to_code(CompareArguments arguments) {
  if (const std::string problem = problem_of_names(arguments); !problem.empty()) {
    fmt::print(stderr, "{}\n", problem);
    return kWrongUsage;
  }
  const Result<void> good =
      check_outputs({arguments.a, arguments.b}, {arguments.heat, arguments.html});
  if (!good) return trouble(good.error());
  if (arguments.heat == "-" || arguments.html == "-") arguments.quiet = true;
  try {
    const int code = run(arguments);
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? code : +kTrouble;
  } catch (const std::bad_alloc&) {
    Diagnostic problem;
    problem.message = "there is not enough memory for this";
    return trouble({problem});
  }
}

}  // namespace

void add_compare(Command& program) {
  auto arguments = std::make_shared<CompareArguments>();
  Command app = program.add_command("compare", "say how far two pictures are apart, and where");
  app.add("A", &arguments->a,
          "a picture: PNG, JPEG, BMP, TGA, PPM, PGM, PFM, HDR or OpenEXR; - reads standard input")
      .required();
  app.add("B", &arguments->b, "the picture to compare with it").required();
  app.add("--tolerance", &arguments->options.tolerance,
          "what a channel may differ by, in steps of 1/255 (default 0)")
      .range(0.0, 255.0);
  app.add("--allow", &arguments->options.allow,
          "the share of the pixels that may differ by more, 0 to 1 (default 0)")
      .range(0.0, 1.0);
  app.add("--format", &arguments->format, "text (default) or json").one_of({"text", "json"});
  check_png_name(app.add(
      "--heat", &arguments->heat,
      "a PNG to draw the differences in, black to white by violet and red; - is standard output"));
  app.add("--heat-of", &arguments->heat_of,
          "what --heat draws: difference (default), the brightest being the largest; or "
          "flip")
      .one_of({"difference", "flip"});
  app.add("--html", &arguments->html,
          "a page to write, with slider, blinking, heat maps and a loupe; all in one file;\n"
          "- is standard output");
  app.add("--transfer", &arguments->transfer,
          "how light became integers, where floats meet integers: srgb (default) or\n"
          "linear, as the lab profile stores it")
      .one_of({"srgb", "linear"});
  app.add("--places", &arguments->options.places,
          "how many of the first and of the worst pixels to name (default 5)")
      .range(0, 1000);
  app.add("-q,--quiet", &arguments->quiet, "print nothing; the exit code tells");
  app.footer(
      "Examples:\n"
      "  zraka compare mine.png reference.png\n"
      "  zraka compare mine.png reference.png --tolerance 2 --allow 0.001 --quiet\n"
      "  zraka compare mine.png reference.jpg --html compare.html --heat heat.png\n"
      "  zraka compare lab.png lab.exr --transfer linear --format json | jq .flip.mean\n"
      "Exit codes, as diff has them: 0 equal or within the tolerance, 1 the pictures differ, also "
      "in\n"
      "size, 2 trouble: wrong usage, a picture that cannot be read, a file that cannot be "
      "written.");
  app.action([arguments] { return run_to_code(*arguments); });
}

}  // namespace zraka::app
