// SPDX-License-Identifier: Apache-2.0
// zraka generate: scenes made to order.
#include <fmt/format.h>

#include <memory>

#include "commands.hpp"
#include "generate/benchmarks.hpp"
#include "generate/letter.hpp"
#include "render_options.hpp"
#include "terminal.hpp"

namespace zraka::app {
namespace {

struct LetterWords {
  std::string text, output, packing = "strokes";
  LetterOptions options;
};

int run_letter(LetterWords words) {
  words.options.packing = words.packing == "fill" ? Packing::fill : Packing::strokes;
  const Result<Scene> scene = generate_letter(words.text, words.options);
  if (!scene) return fail(scene.error());
  const Result<std::string> text = write_lab_input(*scene);
  if (!text) return fail(text.error());
  const Result<void> written = write_text_file(words.output, *text);
  return written ? kDone : fail(written.error());
}

struct BenchmarkWords {
  std::string output;
  int size = 0;
  std::uint32_t seed = 1;
};

void add_benchmark(CLI::App& app, const Benchmark& benchmark, Command& command) {
  auto words = std::make_shared<BenchmarkWords>();
  words->size = benchmark.usual;
  CLI::App* sub = app.add_subcommand(benchmark.name, benchmark.what);
  sub->add_option("-o,--output", words->output, "the NFF file to write, NAME.nff")->required();
  sub->add_option("--size", words->size, fmt::format("how large (default {})", benchmark.usual))
      ->check(CLI::Range(benchmark.smallest, benchmark.largest));
  sub->add_option("--seed", words->seed, "another seed, another scene of the kind (default 1)");
  sub->footer(fmt::format(
      "Example:\n  zraka generate {0} --size {1} -o {0}.nff && zraka render {0}.nff -o {0}.png",
      benchmark.name, benchmark.usual));
  sub->callback([&command, &benchmark, words] {
    command = [&benchmark, words] {
      const Result<void> written =
          generate_benchmark(benchmark.name, words->size, words->seed, words->output);
      return written ? +kDone : fail(written.error());
    };
  });
}

}  // namespace

CLI::App* add_generate(CLI::App& program, Command& command) {
  CLI::App* app = program.add_subcommand("generate", "make a scene");
  app->require_subcommand(1);
  app->footer(
      "Examples:\n  zraka generate letter Č -o letter.txt\n  zraka generate sphereflake --size 5 "
      "-o flake.nff");

  auto words = std::make_shared<LetterWords>();
  CLI::App* letter =
      app->add_subcommand("letter", "a letter or a word of spheres, in the lab's format");
  letter->add_option("TEXT", words->text, "the letter or word, in UTF-8")->required();
  letter->add_option("-o,--output", words->output, "the scene file to write")->required();
  letter
      ->add_option("--packing", words->packing,
                   "strokes (default): a chain along each stroke; fill: all over the glyphs")
      ->check(CLI::IsMember({"strokes", "fill"}));
  letter->add_option("--spheres", words->options.spheres, "about how many spheres a letter")
      ->check(CLI::Range(1, 1000));
  letter
      ->add_option("--resolution", words->options.resolution,
                   "side of the picture in pixels (default 400)")
      ->check(CLI::Range(1, 11585));
  letter->add_option("--font", words->options.font,
                     "a font file; else a bold sans-serif of the system");
  letter->add_option("--seed", words->options.seed, "which materials the spheres get (default 1)");
  letter->footer(
      "Examples:\n"
      "  zraka generate letter Š -o letter.txt && zraka render letter.txt -o letter.png\n"
      "  zraka generate letter Đ -o letter.txt --packing fill --spheres 60\n"
      "  zraka generate letter ĆAO -o word.txt --resolution 1080");
  for (const Benchmark& benchmark : kBenchmarks) add_benchmark(*app, benchmark, command);
  letter->callback([&command, words] { command = [words] { return run_letter(*words); }; });
  return app;
}

}  // namespace zraka::app
