// SPDX-License-Identifier: Apache-2.0
// zraka generate: scenes made to order.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string_view>

#include "commands.hpp"
#include "core/new_file.hpp"
#include "render_options.hpp"
#include "school/generate/benchmarks.hpp"
#include "school/generate/letter.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

/// Names without an extension, and those of devices and pipes, are anybody's.
bool extension_is(const std::string& path, std::string_view extension) {
  const std::string has = std::filesystem::path(path).extension().string();
  return has.empty() || has == extension;
}
bool is_nff_name(const std::string& path) {
  return extension_is(path, ".nff");
}
bool is_lab_name(const std::string& path) {
  return extension_is(path, ".txt");
}

struct LetterArguments {
  std::string text, output, packing = "strokes";
  LetterOptions options;
};

int run_letter(LetterArguments arguments) {
  arguments.options.packing = arguments.packing == "fill" ? Packing::fill : Packing::strokes;
  const Result<void> good = check_outputs({arguments.options.font}, {arguments.output});
  if (!good) return fail(good.error());
  const Result<Scene> scene = generate_letter(arguments.text, arguments.options);
  if (!scene) return fail(scene.error());
  const Result<std::string> text = write_lab_input(*scene);
  if (!text) return fail(text.error());
  const Result<void> written = write_text_file(arguments.output, *text);
  return written ? kDone : fail(written.error());
}

struct BenchmarkArguments {
  std::string output;
  int size = 0;
  std::uint32_t seed = 1;
};

void add_benchmark(Command& generate, const Benchmark& benchmark) {
  auto arguments = std::make_shared<BenchmarkArguments>();
  arguments->size = benchmark.usual;
  Command command = generate.add_command(benchmark.name, benchmark.what);
  command.add("-o,--output", &arguments->output, "the NFF file to write, NAME.nff")
      .required()
      .check("the name of an NFF file, NAME.nff", is_nff_name);
  command.add("--size", &arguments->size, fmt::format("how large (default {})", benchmark.usual))
      .range(benchmark.smallest, benchmark.largest);
  command.add("--seed", &arguments->seed, "another seed, another scene of the kind (default 1)");
  command.footer(fmt::format(
      "Example:\n  zraka generate {0} --size {1} -o {0}.nff && zraka render {0}.nff -o {0}.png",
      benchmark.name, benchmark.usual));
  command.action([&benchmark, arguments] {
    const Result<void> written =
        generate_benchmark(benchmark.name, arguments->size, arguments->seed, arguments->output);
    return written ? +kDone : fail(written.error());
  });
}

void add_letter(Command& generate) {
  auto arguments = std::make_shared<LetterArguments>();
  Command command =
      generate.add_command("letter", "a letter or a word of spheres, in the lab's format");
  command.add("TEXT", &arguments->text, "the letter or word, in UTF-8").required();
  command.add("-o,--output", &arguments->output, "the scene file to write, NAME.txt")
      .required()
      .check("the name of a file of the lab's format, NAME.txt", is_lab_name);
  command
      .add("--packing", &arguments->packing,
           "strokes (default): a chain along each stroke; fill: all over the glyphs")
      .one_of({"strokes", "fill"});
  command.add("--spheres", &arguments->options.spheres, "about how many spheres a letter")
      .range(1, 1000);
  command
      .add("--resolution", &arguments->options.resolution,
           "side of the picture in pixels (default 400)")
      .range(1, 11585);
  command.add("--font", &arguments->options.font,
              "a font file; else a bold sans-serif of the system");
  command.add("--seed", &arguments->options.seed, "which materials the spheres get (default 1)");
  command.footer(
      "Examples:\n"
      "  zraka generate letter Š -o letter.txt && zraka render letter.txt -o letter.png\n"
      "  zraka generate letter Đ -o letter.txt --packing fill --spheres 60\n"
      "  zraka generate letter ĆAO -o word.txt --resolution 1080");
  command.action([arguments] { return run_letter(*arguments); });
}

}  // namespace

void add_generate(Command& program) {
  Command generate = program.add_command("generate", "make a scene");
  generate.require_command();
  generate.footer(
      "Examples:\n  zraka generate letter Č -o letter.txt\n  zraka generate sphereflake --size 5 "
      "-o flake.nff");
  add_letter(generate);
  for (const Benchmark& benchmark : kBenchmarks) add_benchmark(generate, benchmark);
}

}  // namespace zraka::app
