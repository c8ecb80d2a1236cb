// SPDX-License-Identifier: Apache-2.0
// micro_benchmarks: the parts of zraka one by one, with each instruction set that the machine has.
// Items are rays, shapes or hits; bytes are of text. Google Benchmark's options apply.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <zraka/formats.hpp>

#include "accel/build.hpp"
#include "core/file.hpp"
#include "probe.hpp"
#include "render/prepare.hpp"
#include "render/workspace.hpp"
#include "samples.hpp"
#include "school/generate/benchmarks.hpp"

namespace zraka {

namespace isa_avx512 {
micro::Probe probe();
}
namespace isa_avx2 {
micro::Probe probe();
}
namespace isa_portable {
micro::Probe probe();
}

namespace micro {

std::vector<Probe> probes() {
  std::vector<Probe> all;
  for (const Isa isa : available_isas()) {
#ifdef ZRAKA_HAVE_X86
    if (isa == Isa::avx512) all.push_back(isa_avx512::probe());
    if (isa == Isa::avx2) all.push_back(isa_avx2::probe());
#endif
    if (isa == Isa::portable) all.push_back(isa_portable::probe());
    all.back().isa = name_of(isa).data();
  }
  return all;
}

namespace {

/// The memory behind Rays.
class RayColumns {
 public:
  void add(const Vec3& origin, const Vec3& way) {
    const double length = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
    const double numbers[6] = {origin.x,       origin.y,       origin.z,
                               way.x / length, way.y / length, way.z / length};
    for (std::size_t k = 0; k < 6; ++k) columns_[k].push_back(static_cast<float>(numbers[k]));
  }
  std::size_t size() const { return columns_[0].size(); }
  /// Ray i of another set.
  void add(const RayColumns& from, std::size_t i) {
    for (std::size_t k = 0; k < 6; ++k) columns_[k].push_back(from.columns_[k][i]);
  }
  Rays rays() {
    const std::size_t count = size();
    for (auto& column : columns_) column.reserve(count + kArrayPadding);
    return {columns_[0].data(),
            columns_[1].data(),
            columns_[2].data(),
            columns_[3].data(),
            columns_[4].data(),
            columns_[5].data(),
            count};
  }

 private:
  std::vector<float> columns_[6];
};

constexpr std::size_t kRays = 4096;

double unit(std::mt19937& random) {
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

/// A folder for scene files, gone at the end.
struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() /
                               fmt::format("zraka-micro-{}", static_cast<long>(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

[[noreturn]] void give_up(const Diagnostics& problems) {
  for (const Diagnostic& problem : problems) fmt::print(stderr, "{}", to_string(problem));
  std::exit(1);
}

template <class T>
T must(Result<T> result) {
  if (!result) give_up(result.error());
  return std::move(*result);
}

std::string generated_text(const std::string& name, int size) {
  static const Folder folder;
  const std::string file = (folder.path / fmt::format("{}-{}.nff", name, size)).string();
  if (const auto made = generate_benchmark(name, size, 1, file); !made) give_up(made.error());
  return must(read_file(file, std::uint64_t{1} << 32));
}

/// A generated scene, ready to be traced.
struct Traced {
  Scene scene;
  PreparedScene<float> prepared;
  RayColumns camera, random;

  Traced(const std::string& name, int size)
      : scene(must(parse_scene(generated_text(name, size), name)).scene),
        prepared(prepare<float>(scene, RenderOptions{})) {
    // Squares of 4×4 neighbours spread over the picture, as tiles have them.
    const FrozenCamera<float>& c = prepared.store->scene.camera;
    const Vec3 eye{c.eye.x, c.eye.y, c.eye.z};
    constexpr unsigned kSquares = 16;  // along each side
    static_assert(16 * kSquares * kSquares == kRays);
    for (unsigned square = 0; square < kSquares * kSquares; ++square)
      for (unsigned i = 0; i < 16; ++i) {
        const double x = 512.0 / kSquares * (square % kSquares) + i % 4;
        const double y = 512.0 / kSquares * (square / kSquares) + i / 4;
        camera.add(eye, {c.first.x + c.right.x * x + c.down.x * y,
                         c.first.y + c.right.y * x + c.down.y * y,
                         c.first.z + c.right.z * x + c.down.z * y});
      }
    std::mt19937 engine(3);
    for (std::size_t i = 0; i < kRays; ++i) {
      const Vec3 from{0.1 * unit(engine), 0.1 * unit(engine), 0.1 * unit(engine)};
      random.add(from, {unit(engine), unit(engine), unit(engine)});
    }
  }
};

Traced& traced(const std::string& name, int size) {
  static std::map<std::string, std::unique_ptr<Traced>> all;
  std::unique_ptr<Traced>& one = all[name];
  if (!one) one = std::make_unique<Traced>(name, size);
  return *one;
}

void count_items(benchmark::State& state, std::size_t each) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(each));
}

/// Rays from around that are aimed at the shape's neighbourhood: those that hit it, or those that
/// do not.
template <class Shape>
void time_intersect(benchmark::State& state, const Probe& probe, Kind kind, bool hits) {
  using Traits = ShapeTraits<Shape>;
  Shape shape;
  make_sample(shape);
  double numbers[Traits::kReals];
  Traits::freeze(shape, Frame{}, numbers);
  const std::vector<float> frozen(numbers, numbers + Traits::kReals);

  std::mt19937 random(1);
  RayColumns wanted;
  while (wanted.size() < kRays) {
    RayColumns some;
    for (std::size_t i = 0; i < kRays; ++i) {
      const Vec3 from{4 * unit(random), 4 * unit(random), 4 * unit(random)};
      some.add(from, {unit(random) - from.x, unit(random) - from.y, unit(random) - from.z});
    }
    std::vector<float> t(kRays + kArrayPadding);
    probe.intersect[kind](frozen.data(), some.rays(), t.data());
    for (std::size_t i = 0; i < kRays && wanted.size() < kRays; ++i)
      if ((t[i] > 0) == hits) wanted.add(some, i);
  }
  const Rays rays = wanted.rays();
  std::vector<float> t(kRays + kArrayPadding);
  for (auto _ : state) {
    probe.intersect[kind](frozen.data(), rays, t.data());
    benchmark::DoNotOptimize(t.data());
  }
  count_items(state, kRays);
}

struct TimedScene {
  const char* name;
  int size;
};
constexpr TimedScene kScenes[] = {
    {"sphereflake", 4}, {"lattice", 10}, {"rings", 5}, {"terrain", 6}};

void add_intersections(const Probe& probe) {
  for (const bool hits : {true, false}) {
#define ZRAKA_TIME(Type, plural)                                                           \
  benchmark::RegisterBenchmark(fmt::format("intersect/{}/{}/{}", ShapeTraits<Type>::kName, \
                                           hits ? "hit" : "miss", probe.isa)               \
                                   .c_str(),                                               \
                               [probe, hits](benchmark::State& s) {                        \
                                 time_intersect<Type>(s, probe, kKindOf##Type, hits);      \
                               });
    ZRAKA_INLINED_KINDS(ZRAKA_TIME)
#undef ZRAKA_TIME
  }
}

void add_traversals(const Probe& probe) {
  const auto add = [&](const char* what, const TimedScene& scene, const char* kind, auto time) {
    benchmark::RegisterBenchmark(
        fmt::format("{}/{}/{}/{}", what, scene.name, kind, probe.isa).c_str(),
        [time, scene](benchmark::State& state) {
          Traced& t = traced(scene.name, scene.size);
          for (auto _ : state) benchmark::DoNotOptimize(time(t));
          count_items(state, kRays);
        });
  };
  for (const TimedScene& scene : kScenes) {
    add("nearest", scene, "camera",
        [probe](Traced& t) { return probe.nearest(t.prepared.store->scene, t.camera.rays()); });
    add("nearest", scene, "random",
        [probe](Traced& t) { return probe.nearest(t.prepared.store->scene, t.random.rays()); });
    add("blocked", scene, "camera",
        [probe](Traced& t) { return probe.blocked(t.prepared.store->scene, t.camera.rays(), 10); });
    add("blocked", scene, "random",
        [probe](Traced& t) { return probe.blocked(t.prepared.store->scene, t.random.rays(), 10); });
  }
}

/// The steps after traversal, on the tile in the middle of the sphereflake's picture; items are
/// hits. Light is without shadow rays.
void add_steps(const Probe& probe) {
  enum Step { kSurfaces, kLight, kSpawn, kFold };
  const auto add = [&](const char* name, Step step) {
    benchmark::RegisterBenchmark(
        fmt::format("{}/{}", name, probe.isa).c_str(), [probe, step](benchmark::State& state) {
          const FrozenScene<float>& scene = traced("sphereflake", 4).prepared.store->scene;
          constexpr std::int32_t kTile = 32;
          WorkspaceMemory<float> memory(kTile * kTile, 1, false);
          Workspace<float>& workspace = memory.workspace();
          TraceSettings settings;
          settings.max_depth = 1;
          settings.terms.shadows = false;
          const auto take = [&](Step which) {
            if (which == kSurfaces) probe.surfaces(scene, workspace);
            if (which == kLight) probe.light(scene, settings, workspace);
            if (which == kSpawn) probe.spawn(scene, settings, workspace);
            if (which == kFold) probe.fold(settings, workspace);
          };
          probe.hits(scene, {256, 256, kTile, kTile}, workspace);
          for (const Step before : {kSurfaces, kLight, kSpawn}) take(before);
          Level<float>& next = workspace.levels[1];
          for (std::int32_t i = 0; i < next.ray_count; ++i)
            next.rays.r[i] = next.rays.g[i] = next.rays.b[i] = 0.5f;
          for (auto _ : state) {
            take(step);
            benchmark::ClobberMemory();
          }
          count_items(state, static_cast<std::size_t>(workspace.levels[0].hit_count));
        });
  };
  add("surfaces", kSurfaces);
  add("light", kLight);
  add("spawn", kSpawn);
  add("fold", kFold);
}

void add_power(const Probe& probe) {
  benchmark::RegisterBenchmark(fmt::format("power/{}", probe.isa).c_str(),
                               [probe](benchmark::State& state) {
                                 std::mt19937 random(1);
                                 std::vector<float> x, n, out(kRays);
                                 for (std::size_t i = 0; i < kRays; ++i) {
                                   x.push_back(static_cast<float>(0.5 + 0.5 * unit(random)));
                                   n.push_back(static_cast<float>(50 + 49 * unit(random)));
                                 }
                                 for (auto _ : state) {
                                   probe.power(x.data(), n.data(), out.data(), kRays);
                                   benchmark::DoNotOptimize(out.data());
                                 }
                                 count_items(state, kRays);
                               });
}

void time_build(benchmark::State& state, const TimedScene& which) {
  const Scene scene = must(parse_scene(generated_text(which.name, which.size), which.name)).scene;
  const auto store = freeze<float>(scene, profile_of(ProfileName::physical), frame_of(scene));
  const std::vector<std::int32_t> kind_starts = kind_starts_of(store->scene);
  for (auto _ : state) {
    BuildRefs refs(static_cast<std::size_t>(kind_starts.back()));
    refer_to(store->scene, refs.data());
    benchmark::DoNotOptimize(build_hierarchy(std::move(refs), kind_starts));
  }
  count_items(state, scene.shape_count());
}

void time_freeze(benchmark::State& state, const TimedScene& which) {
  const Scene scene = must(parse_scene(generated_text(which.name, which.size), which.name)).scene;
  const RenderOptions options;
  for (auto _ : state) benchmark::DoNotOptimize(prepare<float>(scene, options));
  count_items(state, scene.shape_count());
}

void time_reader(benchmark::State& state, const std::string& text) {
  for (auto _ : state) {
    const Result<ReadScene> read = parse_scene(text, "text");
    if (!read) give_up(read.error());
    benchmark::DoNotOptimize(read->scene.materials.data());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(text.size()));
}

/// Spheres beside each other, in the lab's format.
std::string lab_text() {
  Scene scene;
  scene.materials = {{}};
  scene.lights = {{{-2, 3, 3}, {1, 1, 1}}};
  for (int i = 0; i < 2000; ++i)
    scene.spheres.push_back({{{0.25 * i, 0.125 * (i % 7), -2.5}, 0.375}, 0});
  return must(write_lab_input(scene));
}

void add_builds_and_readers() {
  for (const TimedScene scene : {TimedScene{"sphereflake", 5}, {"lattice", 20}, {"terrain", 7}}) {
    benchmark::RegisterBenchmark(fmt::format("build/{}:{}", scene.name, scene.size).c_str(),
                                 [scene](benchmark::State& s) { time_build(s, scene); })
        ->UseRealTime();
    benchmark::RegisterBenchmark(fmt::format("prepare/{}:{}", scene.name, scene.size).c_str(),
                                 [scene](benchmark::State& s) { time_freeze(s, scene); })
        ->UseRealTime();
    benchmark::RegisterBenchmark(
        fmt::format("read/nff/{}:{}", scene.name, scene.size).c_str(),
        [scene](benchmark::State& s) { time_reader(s, generated_text(scene.name, scene.size)); });
  }
  benchmark::RegisterBenchmark("read/lab", [](benchmark::State& s) { time_reader(s, lab_text()); });
}

}  // namespace
}  // namespace micro
}  // namespace zraka

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const zraka::micro::Probe& probe : zraka::micro::probes()) {
    zraka::micro::add_intersections(probe);
    zraka::micro::add_traversals(probe);
    zraka::micro::add_steps(probe);
    zraka::micro::add_power(probe);
  }
  zraka::micro::add_builds_and_readers();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
