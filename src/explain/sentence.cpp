// SPDX-License-Identifier: Apache-2.0
#include "explain/sentence.hpp"

#include <algorithm>
#include <cmath>

#include "core/counted.hpp"
#include "explain/names.hpp"
#include "explain/optics_words.hpp"
#include "explain/parts.hpp"

namespace zraka {
namespace {

constexpr int kDark = 64, kBright = 217;  // of 255

/// The parts of the tree that gives most, summed up by ray and by way.
struct Shares {
  std::size_t tree = 0;
  Part main;                            ///< the largest part of the ray that gives most
  double all = 0;                       ///< sizes of the tree's parts together
  double of_main = 0;                   ///< main's share of them
  double of_ray = 0;                    ///< the share of all parts of main's ray
  bool alone = false;                   ///< main is all that is not 0
  bool ray_alone = false;               ///< main is all that is not 0 on its ray
  double reflected = 0, refracted = 0;  ///< shares that come by children of the ray from the eye
};

/// Which child of the ray from the eye each ray hangs on; the camera's kind for that ray itself.
std::vector<RayKind> ways_of(const RayTree& tree) {
  std::vector<RayKind> ways(tree.rays.size(), RayKind::camera);
  for (std::size_t r = 1; r < ways.size(); ++r) {
    const auto parent = static_cast<std::size_t>(tree.rays[r].parent);
    ways[r] = parent == 0 ? tree.rays[r].kind : ways[parent];
  }
  return ways;
}

Shares shares_of(const Explanation& e) {
  Shares s;
  std::vector<Part> parts = parts_of(e);
  std::vector<double> by_tree(e.trees.size(), 0.0);
  for (const Part& part : parts) by_tree[part.tree] += part.size();
  s.tree =
      static_cast<std::size_t>(std::max_element(by_tree.begin(), by_tree.end()) - by_tree.begin());
  s.all = by_tree[s.tree];
  std::erase_if(parts, [&](const Part& part) { return part.tree != s.tree; });

  std::vector<double> by_ray(e.trees[s.tree].rays.size(), 0.0);
  for (const Part& part : parts) by_ray[part.ray] += part.size();
  s.main = parts.front();
  for (const Part& part : parts)
    if (by_ray[part.ray] > by_ray[s.main.ray] ||
        (part.ray == s.main.ray && part.size() > s.main.size()))
      s.main = part;
  std::size_t there = 0, there_on_ray = 0;
  for (const Part& part : parts) {
    there += part.size() > 0;
    there_on_ray += part.size() > 0 && part.ray == s.main.ray;
  }
  s.alone = there <= 1;
  s.ray_alone = there_on_ray <= 1;
  if (!(s.all > 0)) return s;
  s.of_main = s.main.size() / s.all;
  s.of_ray = by_ray[s.main.ray] / s.all;
  const std::vector<RayKind> ways = ways_of(e.trees[s.tree]);
  for (std::size_t r = 1; r < ways.size(); ++r)
    (ways[r] == RayKind::reflected ? s.reflected : s.refracted) += by_ray[r] / s.all;
  return s;
}

class Speaker {
 public:
  Speaker(Language language, const Explanation& explanation)
      : lang_(language), e_(explanation), s_(shares_of(explanation)) {}

  std::string sentences() const;

 private:
  template <class... Values>
  std::string say(Word word, const Values&... values) const {
    return zraka::say(lang_, word, values...);
  }
  /// A hit, or what blocks a light.
  template <class Hit>
  std::string label(const Hit& hit, Case form) const {
    return label_of(lang_, hit, form);
  }
  const ExplainedRay& ray(std::size_t r) const { return e_.trees[s_.tree].rays[r]; }
  const ExplainedRay& main_ray() const { return ray(s_.main.ray); }

  std::string percent(double share) const;
  std::string shorter(double number) const {
    return with_comma(lang_, fmt::format("{:.3g}", number));
  }
  std::string why_unlit(const ExplainedHit& hit, bool after_because) const;
  int brightest_byte() const;
  bool is_dark() const { return brightest_byte() < kDark; }
  std::string by_the_way() const;
  std::string of_root() const;
  std::string of_child() const;
  std::string rest() const;
  std::string toned(const std::string& clause, bool is_reason) const;
  std::string on_the_way() const;
  std::string notes() const;

  Language lang_;
  const Explanation& e_;
  Shares s_;
};

std::string Speaker::percent(double share) const {
  if (share < 0.005) return "<1";
  if (share >= 0.995 && share < 1) return ">99";
  return fmt::format("{:.0f}", 100 * share);
}

/// Why no light but the ambient one reaches a hit; "" if one does. Croatian has another order of
/// words after "because".
std::string Speaker::why_unlit(const ExplainedHit& hit, bool after_because) const {
  if (!e_.terms.diffuse && !e_.terms.specular) return say(Word::say_stage_ambient);
  if (hit.lights.empty()) return say(Word::say_no_lights);
  for (const LightTerms& at : hit.lights)
    if (at.reach == Reach::lit || at.reach == Reach::unchecked) return "";
  if (hit.lights.size() > 2) return say(Word::say_unlit, hit.lights.size());
  std::string reasons;
  for (std::size_t i = 0; i < hit.lights.size(); ++i) {
    const LightTerms& at = hit.lights[i];
    const bool turned = i == 0 && after_because;
    std::string reason;
    if (at.reach == Reach::dark)
      reason = say(turned ? Word::say_dark_because : Word::say_dark, light_number(i));
    else if (at.reach == Reach::blocked && (at.samples > 1 || !at.blocker))
      reason = say(Word::say_none_reaches, light_number(i));
    else if (at.blocker)
      reason = say(Word::say_blocked, light_number(i), label(*at.blocker, Case::accusative),
                   shorter(at.blocker->distance));
    else
      reason = say(turned ? Word::say_behind_because : Word::say_behind, light_number(i));
    reasons = reasons.empty() ? reason : say(Word::say_and, reasons, reason);
  }
  return reasons;
}

/// The rays from the eye's hit to main's ray.
std::string Speaker::by_the_way() const {
  constexpr std::size_t kNamed = 2;
  std::vector<std::size_t> way;
  for (auto r = s_.main.ray; r != 0; r = static_cast<std::size_t>(ray(r).parent))
    way.insert(way.begin(), r);
  std::string text;
  for (std::size_t i = 0; i < way.size() && i < kNamed; ++i) {
    const ExplainedRay& step = ray(way[i]);
    const ExplainedHit& hit = *ray(static_cast<std::size_t>(step.parent)).hit;
    std::string name =
        say(step.kind == RayKind::reflected ? Word::say_by_reflected : Word::say_by_refracted,
            label(hit, Case::genitive));
    if (step.nm && step.kind == RayKind::refracted && !hit.split.empty())
      name += fmt::format(" ({:.0f} nm)", *step.nm);
    text = i == 0 ? name : say(Word::say_then, text, name);
  }
  return way.size() <= kNamed ? text : say(Word::say_by_many, text, way.size() - kNamed);
}

/// What the children of the rays from the eye add.
std::string Speaker::rest() const {
  std::string text;
  if (s_.reflected >= 0.005)
    text += fmt::format(", {}", say(Word::say_by_reflected_rest, percent(s_.reflected)));
  if (s_.refracted >= 0.005)
    text += fmt::format(", {}", say(Word::say_by_refracted_rest, percent(s_.refracted)));
  return text;
}

/// Where a ray from the eye gives most.
std::string Speaker::of_root() const {
  if (s_.main.source == Source::fog) return toned(say(Word::say_fog_most, percent(s_.of_main)), false);
  if (!main_ray().hit) return toned(say(Word::say_nothing_met), true);
  const ExplainedHit& hit = *main_ray().hit;
  const std::string whole = percent(s_.of_main);
  switch (s_.main.source) {
    case Source::background:
      return toned(say(Word::say_sky_beyond, whole) + rest(), false);
    case Source::silhouette:
      return toned(say(Word::say_silhouette, label(hit, Case::accusative)), false);
    case Source::diffuse:
      return toned(say(Word::say_diffuse, whole, light_number(s_.main.light),
                       label(hit, Case::locative)) +
                       rest(),
                   false);
    case Source::specular:
      return toned(say(Word::say_specular, whole, light_number(s_.main.light),
                       label(hit, Case::locative)) +
                       rest(),
                   false);
    default:
      break;
  }
  const std::string why = why_unlit(hit, is_dark());
  if (why.empty())
    return toned(say(Word::say_ambient_most, whole, label(hit, Case::genitive)) + rest(),
                 false);
  return toned(s_.alone ? say(Word::say_only_ambient, why)
                        : say(Word::say_ambient_left, why, whole) + rest(),
               true);
}

/// Where a reflected or refracted ray gives most.
std::string Speaker::of_child() const {
  const std::string share = percent(s_.of_ray);
  if (s_.main.source == Source::fog)
    return toned(say(Word::say_fog_by, share, by_the_way()), false);
  if (s_.main.source == Source::background && main_ray().hit)
    return toned(say(Word::say_sky_beyond, share), false);
  if (!main_ray().hit) return toned(say(Word::say_from_background, share, by_the_way()), false);
  const ExplainedHit& hit = *main_ray().hit;
  const std::string from =
      say(Word::say_from_shape, share, label(hit, Case::genitive), by_the_way());
  std::string there;
  if (s_.main.source == Source::ambient) {
    const std::string why = why_unlit(hit, false);
    there = why.empty() || !s_.ray_alone ? say(Word::say_there_ambient)
                                         : say(Word::say_there_only_ambient, why);
  } else {
    there =
        say(s_.main.source == Source::diffuse ? Word::say_there_diffuse : Word::say_there_specular,
            light_number(s_.main.light));
  }
  return toned(say(Word::say_there, from, there), false);
}

int Speaker::brightest_byte() const {
  int most = 0;
  for (const float c : ray(0).color)
    most = std::max(most, static_cast<int>(quantize(c, e_.profile.transfer, 8)));
  return most;
}

std::string Speaker::toned(const std::string& clause, bool is_reason) const {
  const int most = brightest_byte();
  if (most >= kDark && most < kBright) return clause;
  const std::string tone = say(most == 0      ? Word::tone_black
                               : most < kDark ? Word::tone_dark
                                              : Word::tone_bright);
  return say(is_reason && most < kDark ? Word::tone_because : Word::tone_colon, tone, clause);
}

/// What main's light comes through, before the hit and after it.
std::string Speaker::on_the_way() const {
  std::string text;
  if (!(s_.all > 0)) return text;
  if (s_.main.source == Source::diffuse || s_.main.source == Source::specular) {
    const LightTerms& at = main_ray().hit->lights[s_.main.light];
    if (at.reaching > 0 && at.reaching < at.samples && at.reach == Reach::lit)
      text += " " + say(Word::say_partly, at.reaching, at.samples, light_number(s_.main.light));
    if (is_filtered(at) && *at.filter != Float3{}) {
      const PassedBody& first = at.passed.front();
      text += " " + say(Word::say_through, light_number(s_.main.light),
                        label(Blocker{first.shape, first.distance, first.path}, Case::accusative));
    }
  }
  std::array<double, 3> left{1, 1, 1};
  for (auto r = static_cast<int>(s_.main.ray); r >= 0; r = ray(static_cast<std::size_t>(r)).parent)
    if (const auto& hit = ray(static_cast<std::size_t>(r)).hit; hit && hit->medium)
      for (std::size_t c = 0; c < 3; ++c)
        left[c] *= static_cast<double>(hit->medium->transmittance[c]);
  const double most = *std::max_element(left.begin(), left.end());
  const double least = *std::min_element(left.begin(), left.end());
  if (least < 1 - kNotableWeight) text += " " + say(Word::say_absorbed, percent(most));
  double clear = 1;
  for (auto r = static_cast<int>(s_.main.ray); r >= 0; r = ray(static_cast<std::size_t>(r)).parent)
    if (const auto& fog = ray(static_cast<std::size_t>(r)).fog) clear *= static_cast<double>(fog->left);
  if (clear < 1 - kNotableWeight && s_.main.source != Source::fog)
    text += " " + say(Word::say_fog, percent(clear));
  return text;
}

/// What the parts cannot show: clamped sums, and children that would have counted.
std::string Speaker::notes() const {
  std::string text = on_the_way();
  const ExplainedRay& root = ray(0);
  if (e_.profile.clamp_levels && root.hit) {
    const float most = std::max({root.hit->sum[0], root.hit->sum[1], root.hit->sum[2]});
    if (most > 1)
      text += fmt::format(" {}", say(Word::say_clamped, shorter(static_cast<double>(most))));
  }
  struct Missing {
    double weight = kNotableWeight;
    const ExplainedHit* hit = nullptr;
    Word word{};
    float share = 0;
  } black, cut;
  for (const ExplainedRay& r : e_.trees[s_.tree].rays) {
    if (!r.hit) continue;
    const auto look = [&](const Child& child, float share, Absence why, Word word, Missing& most) {
      const double weight = std::fabs(r.weight * static_cast<double>(share));
      const bool loses = why != Absence::depth || (child.beyond && *child.beyond != Float3{});
      if (child.absence == why && loses && weight >= most.weight)
        most = {weight, &*r.hit, word, share};
    };
    if (after_total_reflection(e_, *r.hit) == Word::total_black)
      look(r.hit->refracted, r.hit->k2, Absence::total, Word::say_total_black, black);
    look(r.hit->reflected, r.hit->k1, Absence::depth, Word::say_cut_reflected, cut);
    look(r.hit->refracted, r.hit->k2, Absence::depth, Word::say_cut_refracted, cut);
  }
  if (black.hit != nullptr)
    text += fmt::format(" {}", say(black.word, shorter(static_cast<double>(black.share)),
                                   label(*black.hit, Case::genitive)));
  if (cut.hit != nullptr)
    text += fmt::format(" {}", say(cut.word, e_.max_depth, label(*cut.hit, Case::genitive),
                                   shorter(static_cast<double>(cut.share))));
  return text;
}

std::string Speaker::sentences() const {
  std::string text;
  if (s_.all > 0 || !main_ray().hit) {
    text = s_.main.ray == 0 ? of_root() : of_child();
  } else {
    const std::string why = why_unlit(*main_ray().hit, false);
    const std::string zero = say(Word::say_all_zero);
    text = toned(why.empty() ? zero : say(Word::say_and, zero, why), true);
  }
  text = capitalized(text);
  if (e_.trees.size() > 1) {
    const auto corner = static_cast<Word>(static_cast<std::size_t>(Word::corner_0) + s_.tree);
    text = fmt::format("{}. {}", capitalized(say(Word::say_corner, say(corner))), text);
  }
  return fmt::format("{}.{}", text, notes());
}

}  // namespace

std::string in_words(Language language, const Explanation& explanation) {
  return Speaker(language, explanation).sentences();
}

}  // namespace zraka
