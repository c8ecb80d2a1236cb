// SPDX-License-Identifier: Apache-2.0
#include "explain/optics_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "explain/formulas.hpp"
#include "explain/names.hpp"

namespace zraka {
namespace {

std::string label(Language language, const PassedBody& body) {
  return label_of(language, Blocker{body.shape, body.distance, body.path}, Case::accusative);
}

/// From a spot's axis to the direction towards the hit.
double degrees_from_axis(const Light& light, const LightTerms& at) {
  const Vec3& d = light.direction;
  const double length = std::hypot(d.x, d.y, d.z);
  const double cosine = -(d.x * static_cast<double>(at.to_light[0]) +
                          d.y * static_cast<double>(at.to_light[1]) +
                          d.z * static_cast<double>(at.to_light[2])) /
                        length;
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 57.295779513082320877;
}

double left_by_distance(const Light& light, double distance) {
  const Vec3& a = light.attenuation;
  return 1 / (a.x + a.y * distance + a.z * distance * distance);
}

std::string degrees(Language language, double v) {
  return decimal(language, v, 2);
}

}  // namespace

std::string light_title(Language language, const Explanation& explanation, std::size_t light) {
  constexpr Word kKinds[] = {Word::light,           Word::light_directional, Word::light_spot,
                             Word::light_rectangle, Word::light_disc,        Word::light_sphere};
  const LightKind kind = explanation.lights[light].light.kind;
  if (kind == LightKind::point) return say(language, Word::light, light_number(light));
  return say(language, Word::light_of_kind, light_number(light),
             text_of(language, kKinds[static_cast<int>(kind)]));
}

std::string light_distance(Language language, const LightTerms& at) {
  if (!std::isfinite(at.distance)) return say(language, Word::light_far);
  return say(language, Word::light_distance, short_number(language, at.distance));
}

std::vector<std::string> fading_lines(Language language, const ExplainedLight& light,
                                      const LightTerms& at) {
  const Light& its = light.light;
  std::vector<std::string> lines;
  if (at.arriving == light.color || at.reach == Reach::dark || at.reach == Reach::behind)
    return lines;
  if (its.kind != LightKind::directional && its.attenuation != Vec3{1, 0, 0})
    lines.push_back(say(language, Word::light_attenuation,
                        fmt::format("1/(c + l·d + q·d²) = {}",
                                    short_number(language, left_by_distance(its, at.distance)))));
  if (its.kind == LightKind::spot)
    lines.push_back(say(language, Word::light_cone,
                        degrees(language, degrees_from_axis(its, at)),
                        degrees(language, its.inner_deg), degrees(language, its.outer_deg)));
  lines.push_back(
      say(language, Word::light_arrives, "Ii' = " + short_vector(language, at.arriving)));
  return lines;
}

ReachWords reach_words(Language language, const ExplainedLight& light, const LightTerms& at) {
  ReachWords words;
  const auto add = [&](const std::string& line) { words.lines.push_back(line); };
  const auto add_hidden_points = [&] {
    if (at.samples > 1 && at.facing < at.samples)
      add(say(language, Word::reach_points_behind, at.samples - at.facing, at.samples));
  };
  switch (at.reach) {
    case Reach::lit:
      add(at.samples > 1 ? say(language, Word::reach_samples, at.reaching, at.samples)
                         : say(language, Word::reach_lit));
      add_hidden_points();
      break;
    case Reach::unchecked:
      add(say(language, Word::reach_unchecked));
      add_hidden_points();
      break;
    case Reach::behind:
      add(say(language, Word::reach_behind));
      words.in_shadow = true;
      break;
    case Reach::dark:
      add(say(language, Word::reach_dark, degrees(language, degrees_from_axis(light.light, at)),
              degrees(language, light.light.outer_deg)));
      words.in_shadow = true;
      break;
    case Reach::blocked:
      words.in_shadow = true;
      const std::string by =
          at.blocker ? label_of(language, *at.blocker, Case::accusative) : std::string();
      const std::string t = at.blocker ? short_number(language, at.blocker->distance) : "";
      if (at.samples == 1 && at.blocker) {
        add(say(language, Word::reach_blocked, by, t));
        break;
      }
      add(say(language, Word::reach_none, at.samples));
      add_hidden_points();
      if (at.blocker) add(say(language, Word::reach_first_hits, by, t));
      break;
  }
  return words;
}

bool is_filtered(const LightTerms& at) {
  return at.filter && *at.filter != Float3{1, 1, 1};
}

std::vector<std::string> passed_lines(Language language, const LightTerms& at) {
  std::vector<std::string> lines;
  if (!at.filter || at.reach == Reach::blocked) return lines;
  for (const PassedBody& body : at.passed) {
    const std::string by = label(language, body), t = short_number(language, body.distance);
    if (body.length > 0)
      lines.push_back(say(language, Word::passed_inside, short_number(language, body.length),
                          "exp(-a·d) = " + short_vector(language, body.transmittance)));
    if (body.share == Float3{})
      lines.push_back(say(language, Word::reach_first_hits, by, t));
    else if (body.share == Float3{1, 1, 1})
      lines.push_back(say(language, Word::passes_again, by, t));
    else
      lines.push_back(
          say(language, Word::passes, by, t, "k2 = " + short_vector(language, body.share)));
  }
  if (at.last)
    lines.push_back(say(language, Word::passed_inside, short_number(language, at.last->length),
                        "exp(-a·d) = " + short_vector(language, at.last->transmittance)));
  lines.push_back(say(language, Word::passed_left, "T = " + short_vector(language, *at.filter)));
  return lines;
}

std::string mean_of_samples(Language language, const LightTerms& at) {
  return say(language, Word::mean_of_samples, at.samples);
}

std::string inside_line(Language language, const ExplainedRay& ray) {
  std::string bodies;
  for (const NamedBody& body : ray.inside)
    bodies += (bodies.empty() ? "" : ", ") + label_of(language, Blocker{body.shape, 0, body.path});
  return bodies.empty() ? "" : say(language, Word::inside_of, bodies);
}

std::string medium_line(Language language, const ExplainedHit& hit) {
  if (!hit.medium) return "";
  const ThroughMedium& medium = *hit.medium;
  const std::string name = medium.name.empty()
                               ? fmt::format("{}", std::uint64_t{medium.material} + 1)
                               : fmt::format("'{}'", shown_line(medium.name));
  return say(language, Word::through_medium, short_number(language, hit.distance), name,
             fmt::format("T = exp(-a·d) = exp(-{}·{}) = {}",
                         short_vector(language, medium.absorption),
                         short_number(language, hit.distance),
                         short_vector(language, medium.transmittance)));
}

std::string occlusion_line(Language language, const ExplainedHit& hit) {
  if (!hit.occlusion) return "";
  return say(language, Word::occlusion, "O = " + short_vector(language, *hit.occlusion));
}

std::string fresnel_line(Language language, const ExplainedHit& hit) {
  if (!hit.snell || !hit.snell->fresnel) return "";
  return say(language, Word::fresnel, "F = " + short_number(language, *hit.snell->fresnel));
}

Word name_of_sky(const Explanation& explanation) {
  return explanation.sky == Sky::Kind::gradient ? Word::sky_gradient
         : explanation.sky == Sky::Kind::image  ? Word::sky_image
                                                : Word::background;
}

std::string share_symbols(const ExplainedHit& hit, const Child& child, bool reflected,
                          bool split) {
  const bool by_fresnel = hit.snell && hit.snell->fresnel;
  if (!reflected) {
    const std::string plain = by_fresnel ? "k2·(1 - F)" : "k2";
    return split ? plain + "·w" : plain;
  }
  if (child.shares == hit.reflection) return "k1";
  const bool parts = !hit.split.empty();  // each with an F of its own
  if (by_fresnel) return hit.snell->total && !parts ? "k1 + k2" : "k1 + k2·F";
  return parts ? "k1 + k2·w" : "k1 + k2";
}

std::string absence_words(Language language, const Explanation& explanation,
                          const ExplainedHit& hit, const Child& child, bool reflected) {
  const bool by_fresnel = hit.snell && hit.snell->fresnel && hit.k2 != 0;
  switch (child.absence) {
    case Absence::depth:
      return say(language, Word::absent_depth, explanation.max_depth);
    case Absence::stage:
      return say(language, Word::absent_stage);
    case Absence::total:
      return say(language, Word::total_reflection);
    case Absence::contribution:
      return say(language, hit.split.empty() || reflected ? Word::absent_contribution
                                                          : Word::absent_wavelengths,
                 short_number(language, child.bound.value_or(0)),
                 short_number(language, explanation.min_contribution));
    default:
      break;
  }
  if (!by_fresnel) return reflected ? "k1 = 0" : "k2 = 0";
  return reflected ? "k1 + k2·F = 0" : "k2·(1 - F) = 0";
}

Word after_total_reflection(const Explanation& explanation, const ExplainedHit& hit) {
  return hit.snell && hit.snell->fresnel ? Word::total_mirrored
                                         : after_total_reflection(explanation);
}

Float3 brought_by_split(const RayTree& tree, const ExplainedHit& hit) {
  Float3 sum{};
  for (const SplitChild& part : hit.split) {
    const Float3& color = tree.rays[static_cast<std::size_t>(part.child.ray)].color;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += part.child.shares[c] * color[c];
  }
  return sum;
}

Float3 after_clamp(const Explanation& explanation, const Float3& sum) {
  Float3 color = sum;
  if (explanation.profile.clamp_levels)
    for (float& c : color) c = c > 0 ? std::min(c, 1.0f) : 0.0f;
  return color;
}

Float3 before_fog(const Explanation& explanation, const ExplainedRay& ray) {
  if (!ray.hit) return ray.color;
  Float3 color = after_clamp(explanation, ray.hit->sum);
  if (ray.hit->medium)
    for (std::size_t c = 0; c < 3; ++c) color[c] = color[c] * ray.hit->medium->transmittance[c];
  return color;
}

std::string fog_line(Language language, const Explanation& explanation, const ExplainedRay& ray) {
  if (!ray.fog) return "";
  const float left = ray.fog->left;
  const std::string before =
      ray.hit ? short_vector(language, before_fog(explanation, ray)) : say(language, name_of_sky(explanation));
  return say(language, Word::through_fog,
             fmt::format("C = f·C + (1 - f)·Cfog = {}·{} + {}·{} = {}", short_number(language, left),
                         before, short_number(language, 1 - left),
                         short_vector(language, ray.fog->color), short_vector(language, ray.color)));
}

std::string sky_beyond_line(Language language, const ExplainedHit& hit) {
  if (!hit.sky_beyond) return "";
  return say(language, Word::sky_beyond,
             short_vector(language, hit.sky_beyond->reflected) + " + " +
                 short_vector(language, hit.sky_beyond->refracted));
}

}  // namespace zraka
