// SPDX-License-Identifier: Apache-2.0
#include "school/report/comments.hpp"

#include <algorithm>

#include "core/counted.hpp"
#include "core/text.hpp"
#include "explain/names.hpp"

namespace zraka {
namespace {

/// Shapes and lights that a sentence names before it says how many more there are.
constexpr std::size_t kMostNamed = 4;

class Comments {
 public:
  Comments(Language language, const SceneFacts& scene, Stage stage)
      : language_(language),
        scene_(scene),
        facts_(scene.stages[static_cast<std::size_t>(stage) - 1]),
        before_(scene.stages[std::max<std::size_t>(static_cast<std::size_t>(stage), 2) - 2]) {}

  std::vector<std::string> write(Stage stage);

 private:
  template <class... Values>
  std::string text(Word word, const Values&... values) const {
    return zraka::say(language_, word, values...);
  }
  template <class... Values>
  void say(Word word, const Values&... values) {
    sentences_.push_back(capitalized(text(word, values...)));
  }
  std::string count(Counted what, std::uint64_t number) const {
    return counted(language_, what, number);
  }
  std::string share(std::uint64_t part, std::uint64_t whole) const {
    return percentage(language_, part, whole);
  }
  std::string label(const ShapePixels& shape, Case form = Case::nominative) const {
    return label_of(language_, shape.shape, form);
  }
  std::uint64_t pixels() const {
    return std::uint64_t{scene_.resolution.width} * scene_.resolution.height;
  }
  /// "a, b, c and 5 more".
  template <class List, class Text>
  std::string listed(const List& list, std::size_t first, const Text& text_of_one) const {
    std::string all;
    for (std::size_t i = first; i < list.size() && i < first + kMostNamed; ++i)
      all += fmt::format("{}{}", i == first ? "" : ", ", text_of_one(list[i]));
    return list.size() > first + kMostNamed
               ? text(Word::report_and_more, all, grouped(list.size() - first - kMostNamed))
               : all;
  }

  void silhouette();
  void ambient();
  void diffuse();
  void specular();
  void shadows();
  void reflection();
  void refraction();
  /// How many pixels changed, and how.
  void change();
  void mostly_on();
  void full();
  void ended();
  /// What there is beyond the lab's optics.
  void optics(Stage stage);

  Language language_;
  const SceneFacts& scene_;
  const StageFacts &facts_, &before_;
  std::vector<std::string> sentences_;
};

void Comments::change() {
  const Change& c = facts_.change;
  if (c.pixels == 0) return say(Word::report_same);
  std::string how;
  if (c.brighter == c.pixels)
    how = text(c.pixels == 1 ? Word::report_one_brighter : Word::report_all_brighter);
  else if (c.darker == c.pixels)
    how = text(c.pixels == 1 ? Word::report_one_darker : Word::report_all_darker);
  else
    how = text(Word::report_mixed, grouped(c.brighter), grouped(c.darker));
  if (c.brighter + c.darker < c.pixels)
    how = text(Word::report_as_bright,
               text(Word::report_mixed, grouped(c.brighter), grouped(c.darker)),
               grouped(c.pixels - c.brighter - c.darker));
  say(Word::report_changed, count(Counted::pixel, c.pixels), share(c.pixels, pixels()), how,
      c.largest);
}

void Comments::mostly_on() {
  const Change& c = facts_.change;
  if (c.on.size() > 1)
    say(Word::report_mostly_on, label(c.on[0], Case::locative),
        count(Counted::pixel, c.on[0].pixels));
  if (c.on_background > 0) say(Word::report_on_background, grouped(c.on_background));
}

void Comments::full() {
  if (facts_.change.full > before_.change.full)
    say(Word::report_full, grouped(facts_.change.full), grouped(before_.change.full));
}

void Comments::silhouette() {
  say(scene_.profile.average_corners ? Word::report_rays_corners : Word::report_rays_pixels,
      count(Counted::eye_ray, facts_.rays.camera));
  if (scene_.covered == 0) {
    if (scene_.shapes == 0) say(Word::report_empty);
    return say(Word::report_nothing_seen);
  }
  say(Word::report_covered, count(Counted::pixel, scene_.covered), share(scene_.covered, pixels()));
  if (scene_.covered < pixels()) say(Word::report_background);
  say(Word::report_seen, grouped(scene_.seen.size()), grouped(scene_.shapes), label(scene_.seen[0]),
      count(Counted::pixel, scene_.seen[0].pixels));
}

void Comments::ambient() {
  change();
  if (scene_.covered == 0) return say(Word::report_nothing_seen);
  if (scene_.dark) return say(Word::report_black, "Ia = 0");
  if (facts_.change.pixels > 0) say(Word::report_ambient, "Ia·ka");
  say(Word::report_colors, count(Counted::color, facts_.change.colors));
}

void Comments::diffuse() {
  change();
  if (scene_.lights == 0) return say(Word::report_no_light);
  if (scene_.covered == 0) return say(Word::report_nothing_seen);
  const bool any = std::any_of(scene_.seen.begin(), scene_.seen.end(), [](const ShapePixels& s) {
    return s.material.diffuse != Color{0, 0, 0};
  });
  if (!any) return say(Word::report_no_diffuse, "kd = 0");
  if (facts_.change.pixels > 0) say(Word::report_diffuse, "Ii·kd·(L·N)");
  for (std::size_t i = 0; i < facts_.lights.size() && i < kMostNamed; ++i) {
    const LightFacts& light = facts_.lights[i];
    say(Word::report_facing, count(Counted::point, facts_.points), light_number(i),
        grouped(light.facing), grouped(light.away), "L·N < 0");
  }
  if (facts_.lights.size() > 1 && facts_.unlit > 0) say(Word::report_unlit, grouped(facts_.unlit));
  mostly_on();
  full();
}

void Comments::specular() {
  change();
  if (scene_.lights == 0) return say(Word::report_no_light);
  if (scene_.covered == 0) return say(Word::report_nothing_seen);
  const bool any = std::any_of(scene_.seen.begin(), scene_.seen.end(), [](const ShapePixels& s) {
    return s.material.specular != Color{0, 0, 0};
  });
  if (!any) return say(Word::report_no_specular, "ks = 0");
  if (facts_.change.pixels == 0) return say(Word::report_too_small);
  say(Word::report_specular, "Ii·ks·(R·V)ⁿ", "n");
  if (!facts_.change.on.empty())
    say(Word::report_highlights, listed(facts_.change.on, 0, [&](const ShapePixels& s) {
          return fmt::format("{} (n = {}) {}", label(s),
                             with_comma(language_, fmt::format("{:.4g}", s.material.shininess)),
                             grouped(s.pixels));
        }));
  full();
}

void Comments::shadows() {
  change();
  if (scene_.lights == 0) return say(Word::report_no_light);
  if (scene_.covered == 0) return say(Word::report_nothing_seen);
  if (facts_.rays.shadow == 0) return say(Word::report_no_shadow_rays);
  std::uint64_t blocked = 0;
  for (const LightFacts& light : facts_.lights) blocked += light.blocked;
  if (scene_.general)
    say(Word::report_shadow_rays_all, count(Counted::shadow_ray, facts_.rays.shadow),
        grouped(blocked));
  else
    say(Word::report_shadow_rays, count(Counted::shadow_ray, facts_.rays.shadow),
        grouped(blocked), share(blocked, facts_.rays.shadow));
  if (blocked == 0 && scene_.general) return;
  if (blocked == 0) return say(Word::report_no_shadow);
  if (facts_.change.pixels > 0) say(Word::report_shadows);
  if (facts_.shadows.empty()) return;
  const ShadowFacts& most = facts_.shadows[0];
  say(Word::report_thrower, label(most.by), count(Counted::pixel, most.by.pixels),
      label(most.mostly_on, Case::locative), grouped(most.mostly_on.pixels));
  if (std::none_of(scene_.seen.begin(), scene_.seen.end(),
                   [&](const ShapePixels& s) { return s.shape.id == most.by.shape.id; }))
    say(Word::report_shadow_unseen);
  if (facts_.shadows.size() > 1)
    say(Word::report_throwers, listed(facts_.shadows, 1, [&](const ShadowFacts& s) {
          return fmt::format("{} ({})", label(s.by), grouped(s.by.pixels));
        }));
  if (facts_.shadowed > facts_.change.pixels)
    say(Word::report_shadow_same, grouped(facts_.shadowed - facts_.change.pixels));
  if (facts_.unlit > before_.unlit) say(Word::report_unlit, grouped(facts_.unlit));
}

void Comments::ended() {
  if (facts_.ended_refracted > 0)
    say(Word::report_ended, scene_.max_depth, grouped(facts_.ended_reflected),
        grouped(facts_.ended_refracted));
  else if (facts_.ended_reflected > 0)
    say(Word::report_ended_reflected, scene_.max_depth, grouped(facts_.ended_reflected));
}

void Comments::reflection() {
  change();
  if (scene_.covered == 0) return say(Word::report_nothing_seen);
  const std::uint64_t rays = facts_.rays.reflected;
  if (rays == 0) {
    if (facts_.ended_reflected > 0) return say(Word::report_depth_zero);
    return say(Word::report_no_reflection, "k1 = 0");
  }
  if (facts_.change.pixels > 0)
    say(Word::report_reflection, "k1");
  else
    say(Word::report_too_small);
  say(Word::report_reflected, count(Counted::reflected, rays), facts_.deepest,
      grouped(facts_.later_points), grouped(rays - facts_.later_points));
  mostly_on();
  if (!facts_.mirrored.empty())
    say(Word::report_mirrored, label(facts_.mirrored[0]),
        count(Counted::pixel, facts_.mirrored[0].pixels));
  full();
  ended();
}

void Comments::refraction() {
  change();
  if (scene_.covered == 0) return say(Word::report_nothing_seen);
  const TotalFacts& total = facts_.total;
  const std::uint64_t rays = facts_.rays.refracted, times = total.entering + total.leaving;
  if (rays == 0 && times == 0) {
    if (facts_.ended_refracted > 0 && facts_.deepest == scene_.max_depth) return ended();
    return say(Word::report_no_refraction, "k2 = 0");
  }
  if (rays > 0) {
    if (facts_.change.pixels > 0)
      say(Word::report_refraction, "k2");
    else
      say(Word::report_too_small);
    say(Word::report_refracted, count(Counted::refracted, rays), grouped(facts_.entering),
        grouped(facts_.leaving));
  } else {
    say(Word::report_only_total);
  }
  mostly_on();
  if (facts_.rays.reflected > before_.rays.reflected)
    say(Word::report_more_reflected, count(Counted::reflected, facts_.rays.reflected),
        grouped(before_.rays.reflected));
  if (!facts_.seen_through.empty())
    say(Word::report_seen_through, label(facts_.seen_through[0]),
        count(Counted::pixel, facts_.seen_through[0].pixels));
  if (times == 0) {
    say(Word::report_total_none);
  } else {
    const PixelBox& box = total.box;
    say(Word::report_total, "D < 0", count(Counted::time, times),
        label(total.on[0], Case::locative), count(Counted::pixel, total.pixels), box.left,
        box.right, box.top, box.bottom);
    say(Word::report_total_sides, grouped(total.leaving), grouped(total.entering));
    if (total.entering > 0) say(Word::report_total_outside);
    if (facts_.fresnel == 0)  // else by material
      say(scene_.profile.mirror_when_total ? Word::report_total_mirrored
                                           : Word::report_total_black,
          "k2");
  }
  full();
  ended();
}

void Comments::optics(Stage stage) {
  std::uint64_t partly = 0, dimmed = 0;
  for (std::size_t i = 0; i < facts_.lights.size(); ++i) {
    const LightFacts& light = facts_.lights[i];
    partly += light.partly;
    dimmed += light.dimmed;
    if (stage == Stage::diffuse && light.dark > 0)
      say(Word::report_dark, light_number(i), grouped(light.dark));
  }
  if (stage == Stage::shadows && partly > 0) say(Word::report_partly, grouped(partly));
  if (stage == Stage::shadows && dimmed > 0) say(Word::report_dimmed, grouped(dimmed));
  if (stage < Stage::reflection) return;
  if (facts_.absorbed > 0) say(Word::report_absorbed, grouped(facts_.absorbed));
  if (facts_.fresnel > 0) say(Word::report_fresnel, grouped(facts_.fresnel));
  if (facts_.split > 0)
    say(Word::report_split, scene_.wavelengths, grouped(facts_.split));
  if (facts_.rays.cut > 0)
    say(Word::report_cut,
        with_comma(language_, fmt::format("{:.4g}", scene_.min_contribution)),
        grouped(facts_.rays.cut));
}

std::vector<std::string> Comments::write(Stage stage) {
  switch (stage) {
    case Stage::silhouette:
      silhouette();
      break;
    case Stage::ambient:
      ambient();
      break;
    case Stage::diffuse:
      diffuse();
      break;
    case Stage::specular:
      specular();
      break;
    case Stage::shadows:
      shadows();
      break;
    case Stage::reflection:
      reflection();
      break;
    case Stage::refraction:
      refraction();
      break;
  }
  optics(stage);
  return std::move(sentences_);
}

}  // namespace

std::vector<std::string> comments_on(Language language, const SceneFacts& scene, Stage stage) {
  return Comments(language, scene, stage).write(stage);
}

}  // namespace zraka
