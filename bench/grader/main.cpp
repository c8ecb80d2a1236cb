// SPDX-License-Identifier: Apache-2.0
// How often the grader is right: pictures as they are handed in, right ones, those of every mistake
// and of some that no catalogue knows, each altered once or twice. grader_bench SEED CASES [KIND];
// with -v it tells each picture that was not judged right, -o FOLDER keeps them, =NUMBER judges
// one, -s SIDE draws smaller ones.
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <set>

#include "alterations.hpp"
#include "course_scenes.hpp"
#include "outside_tracer.hpp"
#include "picture_files.hpp"
#include "school/grade/align.hpp"
#include "school/grade/words.hpp"

namespace zraka {
namespace {

using altered::Alteration;
using altered::Altered;
using altered::Random;

constexpr std::string_view kWords[] = {"",         "silhouette", "ambient",    "diffuse",
                                       "specular", "shadow",     "reflection", "refraction"};

struct Case {
  std::string kind, name;
  std::size_t scene = 0;
  int stage = 7;
  Image picture{};
  std::vector<Mistake> expected{};
  std::vector<Alteration> how{};
  std::size_t number = 0;
};

struct Tally {
  int cases = 0, right = 0, unknown = 0;
  int in_part = 0;  ///< one of two, and that it is not all
  int missed = 0;   ///< taken for right
  int wrong = 0, wrong_as_fact = 0;
};

/// Shows it nothing but its background? What is plain is a kind of its own.
bool is_plain(const Image& picture) {
  return spread(picture, {0, 0, picture.width, picture.height}) < 1e-4;
}

struct Bench {
  Bench(unsigned seed, std::uint32_t side) : random(seed) {
    scenes = {course_scene(), second_scene(), third_scene()};
    for (Scene& scene : scenes) scene.resolution = {side, side};
    for (const Scene& scene : scenes)
      graders.push_back(Grader::create(scene, lab_options()).value());
  }

  std::vector<Alteration> some_alterations(std::size_t i) {
    const auto any = [&] {
      return static_cast<Alteration>(1 + random() % (static_cast<unsigned>(Alteration::count) - 1));
    };
    if (i % 3 == 0) return {Alteration::none};
    if (i % 3 == 1) return {any()};
    Alteration a = any(), b = any();
    while (a == b) b = any();
    // A file is compressed last, and a screen shows what was drawn.
    if (a > b && !(b == Alteration::crop)) std::swap(a, b);
    if (a == Alteration::jpeg_60 || a == Alteration::jpeg_85) std::swap(a, b);
    return {a, b};
  }

  Case right(std::size_t i) {
    const std::size_t scene = random() % 3;
    const int stage = 1 + static_cast<int>(random() % 7);
    return {"right",
            fmt::format("stage {}", stage),
            scene,
            stage,
            graders[scene].picture(stage),
            {},
            some_alterations(i)};
  }
  Case own_right(std::size_t i) {
    const std::size_t scene = random() % 3;
    const int stage = 1 + static_cast<int>(random() % 7);
    return {"right, own tracer",
            fmt::format("stage {}", stage),
            scene,
            stage,
            outside::Tracer(scenes[scene], stage).picture(),
            {},
            some_alterations(i)};
  }
  Case one(std::size_t i) {
    for (;;) {
      const MistakeEntry& entry = lab_mistakes()[random() % lab_mistakes().size()];
      const std::size_t scene = random() % 3;
      const int stage = random() % 2 == 0 ? 7 : std::max(2, entry.first_stage);
      const Image picture = graders[scene].picture(stage, entry.mistake);
      if (measure_errors(picture, graders[scene].picture(stage), 2.5 / 255).share() < 0.02 ||
          is_plain(picture))
        continue;
      return {"one mistake",   std::string(entry.key), scene, stage, picture,
              {entry.mistake}, some_alterations(i)};
    }
  }
  Case outside(std::size_t i, bool held_out) {
    const auto index = [](outside::Slip slip) { return static_cast<unsigned>(slip); };
    const unsigned first = held_out ? index(outside::kFirstHeldOut) : 1,
                   last = index(held_out ? outside::Slip::count : outside::kFirstHeldOut);
    for (;;) {
      const auto slip = static_cast<outside::Slip>(first + random() % (last - first));
      const std::size_t scene = random() % 3;
      const int stage = random() % 2 == 0 ? 7 : outside::stage_of(slip);
      const Image picture = outside::Tracer(scenes[scene], stage, slip).picture();
      if (measure_errors(picture, graders[scene].picture(stage), 2.5 / 255).share() < 0.02)
        continue;
      return {held_out ? "outside, held out" : "outside",
              std::string(outside::kNames[static_cast<std::size_t>(slip)]),
              scene,
              stage,
              picture,
              {},
              some_alterations(i)};
    }
  }
  Case two(std::size_t i);
  Case nothing(std::size_t i) {
    const std::size_t scene = random() % 3;
    Image picture(scenes[0].resolution.width, scenes[0].resolution.height);
    std::string name;
    switch (random() % 3) {
      case 0: {
        name = "plain";
        const float grey = static_cast<float>(altered::from(random, 0, 1));
        for (float& value : picture.pixels) value = grey;
        break;
      }
      case 1:
        name = "noise";
        for (float& value : picture.pixels) value = static_cast<float>(random() % 256) / 255;
        break;
      default:
        name = "another scene";
        picture = graders[(scene + 2) % 3].picture(7);
        if (scene == 1) picture = graders[2].picture(7);
    }
    return {"nothing",          name, scene, 2 + static_cast<int>(random() % 6), picture, {},
            some_alterations(i)};
  }

  void judge(const Case& c, unsigned seed);
  void print() const;

  Random random;
  std::vector<Scene> scenes;
  std::vector<Grader> graders;
  std::map<std::string, Tally> of_kind;
  std::map<std::string, std::map<std::string, Tally>> of_alteration;
  std::mutex mutex;
  bool tell = false;
  std::filesystem::path kept{};  ///< where pictures are kept that were not judged right
};

Case Bench::two(std::size_t i) {
  for (;;) {
    const std::size_t scene = random() % 3;
    const auto any = [&]() -> const MistakeEntry& {
      return lab_mistakes()[random() % lab_mistakes().size()];
    };
    const MistakeEntry *a = &any(), *b = &any();
    if (a->mistake == b->mistake) continue;
    if (a->mistake > b->mistake) std::swap(a, b);
    const auto stored = [&](const MistakenBy& by) {
      return as_stored(render_mistaken(scenes[scene], lab_options(), by).value().image,
                       Transfer::linear, 8);
    };
    const Image picture = stored({a->mistake, b->mistake});
    const auto far = [&](const Image& other) {
      return measure_errors(picture, other, 2.5 / 255).share() > 0.02;
    };
    // Each of them has to show beside the other.
    if (!far(graders[scene].picture(7)) || !far(stored({a->mistake})) || !far(stored({b->mistake})))
      continue;
    return {"two mistakes",
            fmt::format("{} + {}", a->key, b->key),
            scene,
            7,
            picture,
            {a->mistake, b->mistake},
            {i % 2 == 0 ? Alteration::none : Alteration::jpeg_85}};
  }
}

void Bench::judge(const Case& c, unsigned seed) {
  Random own(seed);
  Altered a{c.picture};
  for (const Alteration how : c.how) altered::alter(a, how, own);
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("grader-bench-{}-{}", ::getpid(), seed);
  std::filesystem::create_directory(folder);
  const std::string file = (folder / fmt::format("{}.{}", kWords[static_cast<std::size_t>(c.stage)],
                                                 a.jpeg > 0 ? "jpg" : "png"))
                               .string();
  if (a.jpeg > 0)
    std::ofstream(file, std::ios::binary) << jpeg_file(a.image, a.jpeg);
  else
    static_cast<void>(write_png(a.image, file, {8, Transfer::linear}));
  const Grade grade = graders[c.scene].grade(file);
  const StageGrade& got = grade.stages.front();
  const std::string_view verdict = key_of(got.verdict);
  const auto names = [&](Mistake mistake) {
    return verdict != "unknown" &&
           std::find(got.mistakes.begin(), got.mistakes.end(), mistake) != got.mistakes.end();
  };
  const bool quarter_turned =
      std::find(c.how.begin(), c.how.end(), Alteration::transposed) != c.how.end();
  const bool part_of_pixel =
      std::max(std::fabs(got.alignment.left), std::fabs(got.alignment.top)) > 0.25;
  // What the alignment takes back is told there; what was turned twice is as it should be.
  const auto told = [&](Mistake mistake) {
    if (names(mistake)) return true;
    switch (mistake) {
      case Mistake::red_and_blue:
        return got.alignment.swapped;
      case Mistake::gamma_applied:
        return got.alignment.curve != Alignment::Curve::none;
      case Mistake::x_mirrored:
        return verdict == "right" && quarter_turned && got.alignment.transposed;
      case Mistake::y_down:
      case Mistake::transposed:
      case Mistake::shifted:
      case Mistake::pixel_center:
        return verdict == "right" || !got.alignment.plain() || part_of_pixel;
      default:
        return false;
    }
  };
  bool right = false, unknown = verdict == "unknown";
  if (c.kind.starts_with("right"))
    right = verdict == "right";
  else if (c.kind.starts_with("outside") || c.kind == "nothing")
    right = unknown;
  else
    right = std::all_of(c.expected.begin(), c.expected.end(), told);
  // One of two mistakes is true where the verdict says that more is left.
  const bool in_part =
      !right && verdict == "probably" && !c.expected.empty() &&
      std::all_of(got.mistakes.begin(), got.mistakes.end(), [&](Mistake mistake) {
        return std::find(c.expected.begin(), c.expected.end(), mistake) != c.expected.end();
      });
  if (!right && !kept.empty())
    std::filesystem::copy_file(
        file,
        kept / fmt::format("{}-{}", c.number, std::filesystem::path(file).filename().string()),
        std::filesystem::copy_options::overwrite_existing);
  std::filesystem::remove_all(folder);
  const std::lock_guard lock(mutex);
  std::string how;
  for (const Alteration one : c.how)
    how += (how.empty() ? "" : " + ") + std::string(altered::kNames[static_cast<std::size_t>(one)]);
  const auto count = [&](Tally& tally) {
    ++tally.cases;
    tally.right += right;
    tally.unknown += !right && unknown;
    tally.in_part += in_part;
    const bool missed = !right && verdict == "right",
               named = !right && !unknown && !missed && !in_part;
    tally.missed += missed;
    tally.wrong += named;
    tally.wrong_as_fact += named && verdict != "probably";
  };
  count(of_kind[c.kind]);
  count(of_kind[c.kind + (c.how.size() > 1               ? ", altered twice"
                          : c.how[0] == Alteration::none ? ", as it is"
                                                         : ", altered")]);
  for (const Alteration one : c.how)
    count(of_alteration[std::string(altered::kNames[static_cast<std::size_t>(one)])][c.kind]);
  std::string named;
  for (const Mistake mistake : got.mistakes)
    named += fmt::format(" {}{}", got.both ? "& " : "", entry_of(mistake).key);
  if (tell && !right)
    fmt::print("{:<4} {:<12} scene {} stage {} {:<28} [{}] -> {}{} wrong {:.3f} left {:.3f} {}\n",
               c.number, c.kind, c.scene, c.stage, c.name, how, verdict, named, got.share_wrong,
               got.share_left, alignment_text(Language::english, got.alignment));
}

void Bench::print() const {
  fmt::print("{:<34} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "", "cases", "right", "unknown",
             "in part", "missed", "false", "as fact");
  const auto line = [](const std::string& name, const Tally& t) {
    const auto share = [&](int n) { return fmt::format("{:.1f} %", 100.0 * n / t.cases); };
    fmt::print("{:<34} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", name, t.cases, share(t.right),
               share(t.unknown), share(t.in_part), share(t.missed), share(t.wrong),
               share(t.wrong_as_fact));
  };
  for (const auto& [kind, tally] : of_kind) line(kind, tally);
  for (const auto& [how, kinds] : of_alteration)
    for (const auto& [kind, tally] : kinds) line(how + ": " + kind, tally);
}

}  // namespace

int run(int count, char** values) {
  if (count < 3) {
    fmt::print(stderr,
               "grader_bench SEED CASES [right own one outside held two nothing] [-v] [-o FOLDER] "
               "[-s SIDE] [=NUMBER]\n");
    return 2;
  }
  const auto seed = static_cast<unsigned>(std::stoul(values[1]));
  const std::size_t cases = std::stoul(values[2]);
  std::uint32_t side = kSide;
  for (int i = 3; i + 1 < count; ++i)
    if (std::string_view(values[i]) == "-s")
      side = static_cast<std::uint32_t>(std::stoul(values[i + 1]));
  Bench bench(seed, side);
  std::string kinds;
  std::set<std::size_t> only;
  for (int i = 3; i < count; ++i) {
    if (std::string_view(values[i]) == "-v")
      bench.tell = true;
    else if (std::string_view(values[i]) == "-o" && i + 1 < count)
      bench.kept = values[++i];
    else if (std::string_view(values[i]) == "-s" && i + 1 < count)
      ++i;
    else if (std::string_view(values[i]).starts_with("="))
      only.insert(std::stoul(values[i] + 1));
    else
      kinds += fmt::format("{} ", values[i]);
  }
  const auto wanted = [&](const char* kind) {
    return kinds.empty() || kinds.find(kind) != std::string::npos;
  };
  std::vector<Case> all;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < cases; ++i) {
    if (wanted("right")) all.push_back(bench.right(i));
    if (wanted("own")) all.push_back(bench.own_right(i));
    if (wanted("one")) all.push_back(bench.one(i));
    if (wanted("outside")) all.push_back(bench.outside(i, false));
    if (wanted("held")) all.push_back(bench.outside(i, true));
    if (wanted("two")) all.push_back(bench.two(i));
    if (wanted("nothing")) all.push_back(bench.nothing(i));
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].number = i;
  const auto made = std::chrono::steady_clock::now();
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
    if (only.empty() || only.contains(i))
      bench.judge(all[i], seed * 100003 + static_cast<unsigned>(i));
  });
  bench.print();
  const std::chrono::duration<double> making = made - start,
                                      judging = std::chrono::steady_clock::now() - made;
  fmt::print("{} pictures, made in {:.1f} s, judged in {:.1f} s\n", all.size(), making.count(),
             judging.count());
  return 0;
}

}  // namespace zraka

int main(int count, char** values) {
  return zraka::run(count, values);
}
