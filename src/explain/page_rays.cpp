// SPDX-License-Identifier: Apache-2.0
// The rays of a tree on its page, each with all of its terms.
#include <cmath>

#include "explain/angles.hpp"
#include "explain/page_writer.hpp"
#include "explain/space.hpp"
#include "explain/surface_words.hpp"

namespace zraka {
namespace {

/// A child that counts this much is unfolded at first.
constexpr double kUnfolded = 0.05;

}  // namespace

void Page::light(const ExplainedHit& hit, std::size_t i) {
  using namespace math;
  const LightTerms& at = hit.lights[i];
  const Float3& intensity = e_.lights[i].color;
  std::string note, kind = "lit";
  switch (at.reach) {
    case Reach::lit:
      note = say(Word::reach_lit);
      break;
    case Reach::unchecked:
      note = say(Word::reach_unchecked);
      break;
    case Reach::behind:
      note = say(Word::reach_behind), kind = "unlit";
      break;
    case Reach::blocked:
      note = say(Word::reach_blocked, label(*at.blocker, Case::accusative),
                 short_number(at.blocker->distance));
      kind = "unlit";
      break;
  }
  row(say(Word::light, light_number(i)),
      steps({symbol("L"), column(at.to_light)}) + steps({dot("L", "N"), number(at.l_n)}) +
          fmt::format("<p class=\"{}\">{}</p><p>{}</p>", kind, note,
                      say(Word::light_distance, short_number(at.distance))));
  if (at.diffuse)
    row(say(Word::diffuse),
        steps({product({indexed("I", "i"), indexed("k", "d"), in_brackets(dot("L", "N"))}),
               product({column(intensity), column(hit.kd), number(at.l_n)}), column(*at.diffuse)}));
  if (at.specular)
    row(say(Word::specular), steps({product({indexed("I", "i"), indexed("k", "s"),
                                             power(in_brackets(dot("R", "V")), symbol("n"))}),
                                    product({column(intensity), column(hit.ks),
                                             power(number(*at.r_v), number(hit.shininess))}),
                                    column(*at.specular)}));
  else if (at.r_v)
    row(say(Word::specular),
        fmt::format("<p>{}</p>", say(Word::no_specular, short_number(*at.r_v))));
}

void Page::snell(std::size_t t, const ExplainedHit& hit) {
  using namespace math;
  const SnellTerms& s = *hit.snell;
  const Angles angles = angles_of(s);
  const std::string b = symbol("b"), b2 = power(b, "<mn>2</mn>"), cosine = "<mi>cos</mi><mi>α</mi>",
                    minus = operation("−");
  std::string text =
      steps({b, fraction(indexed("n", "1"), indexed("n", "2")), number(s.ratio)}) +
      steps({cosine, dot("U", "N"), number(s.cosine)}) +
      fmt::format("<p>{} α = {}</p>", say(Word::page_angle_in), degrees(angles.alpha_deg)) +
      steps({symbol("D"),
             product({"<mn>4</mn>",
                      in_brackets(fmt::format("{}<mo>·</mo>{}{}{}{}<mn>1</mn>", b2,
                                              power("<mi>cos</mi>", "<mn>2</mn>") + "<mi>α</mi>",
                                              minus, b2, operation("+")))}),
             number(4 * s.quarter_d)});
  if (s.total) {
    text += fmt::format("<p class=\"unlit\">{}", say(Word::total_reflection));
    if (angles.critical_deg)
      text += fmt::format(
          " ({})", say(Word::critical_angle, decimal(options_.language, *angles.critical_deg, 2)));
    text += fmt::format("; {}</p>", say(after_total_reflection(e_)));
  } else if (s.a) {
    const ExplainedRay& refracted = e_.trees[t].rays[static_cast<std::size_t>(hit.refracted.ray)];
    text += steps({symbol("a"),
                   fraction(fmt::format("{}<mn>2</mn>{}{}{}{}{}", minus, b, operation("·"), cosine,
                                        operation("+"), root(symbol("D"))),
                            "<mn>2</mn>"),
                   number(*s.a)}) +
            fmt::format("<p>{} β = {}</p>", say(Word::page_angle_out),
                        degrees(angles.beta_deg.value_or(0))) +
            steps({symbol("R"),
                   fmt::format("{}<mi>a</mi>{}<mi>N</mi>{}<mi>b</mi>{}<mi>U</mi>", minus,
                               operation("·"), minus, operation("·")),
                   column(refracted.direction)});
  }
  row(say(Word::refraction), text);
}

/// What was hit and where on it.
void Page::surface(const ExplainedHit& hit) {
  using namespace math;
  std::string terms =
      fmt::format("<p>{}</p>", say(Word::meets, label(hit, Case::accusative),
                                   short_number(hit.distance), short_vector(hit.point)));
  for (const std::string& line : place_lines(options_.language, hit))
    terms += fmt::format("<p class=\"place\">{}</p>", html_text(line));
  terms += steps({symbol("N"), column(hit.normal)});
  if (hit.flipped) terms += fmt::format("<p>{}</p>", say(Word::normal_turned));
  if (hit.bent) terms += fmt::format("<p>{}</p>", html_text(bent_line(options_.language, hit)));
  row(say(Word::page_hit), terms);
}

/// The coefficients that textures give.
void Page::textures(const ExplainedHit& hit) {
  using namespace math;
  for (const TextureWords& words : texture_words(options_.language, hit)) {
    std::string symbols;
    for (const std::string& name : words.symbols)
      symbols += (symbols.empty() ? "" : operation("=")) +
                 (name.size() > 1 ? indexed(name.substr(0, 1), name.substr(1)) : symbol(name));
    row(html_text(words.texture),
        steps(
            {symbols, is_color(words.coefficient) ? column(words.value) : number(words.value[0])}));
  }
}

void Page::hit(std::size_t t, const ExplainedRay& ray) {
  using namespace math;
  const ExplainedHit& hit = *ray.hit;
  surface(hit);
  if (e_.terms.silhouette) {
    row(say(Word::silhouette), steps({symbol("I"), column(hit.local)}));
    return;
  }
  textures(hit);
  if (e_.terms.ambient)
    row(say(Word::ambient),
        steps({product({indexed("I", "a"), indexed("k", "a")}),
               product({column(e_.ambient_light), column(hit.ka)}), column(hit.ambient)}));
  for (std::size_t i = 0; i < hit.lights.size(); ++i) light(hit, i);
  std::string terms = column(hit.ambient);
  for (const LightTerms& at : hit.lights) {
    if (at.diffuse) terms += kPlus + column(*at.diffuse);
    if (at.specular) terms += kPlus + column(*at.specular);
  }
  row(say(Word::local_light),
      terms == column(hit.local) ? steps({symbol("I"), terms})
                                 : steps({symbol("I"), terms, column(hit.local)}),
      "result");
  if (hit.snell) snell(t, hit);
  child(t, hit.reflected, true, hit);
  child(t, hit.refracted, false, hit);
}

void Page::child(std::size_t t, const Child& child, bool reflected, const ExplainedHit& hit) {
  if (child.ray >= 0) {
    const bool both = reflected && child.share != hit.k1;
    ray(t, static_cast<std::size_t>(child.ray),
        fmt::format("{}, <math>{}<mo>=</mo>{}</math>",
                    say(reflected ? Word::ray_reflected : Word::ray_refracted),
                    both ? math::indexed("k", "1") + "<mo>+</mo>" + math::indexed("k", "2")
                         : math::indexed("k", reflected ? "1" : "2"),
                    number(child.share)));
    return;
  }
  std::string why = reflected ? "k₁ = 0" : "k₂ = 0";
  if (child.absence == Absence::depth) why = say(Word::absent_depth, e_.max_depth);
  if (child.absence == Absence::stage) why = say(Word::absent_stage);
  if (child.absence == Absence::total) why = say(Word::total_reflection);
  put("<p class=\"absent\">{}: {}</p>\n", say(reflected ? Word::no_reflected : Word::no_refracted),
      why);
}

/// What the ray brings back.
void Page::sum(std::size_t t, const ExplainedRay& ray) {
  using namespace math;
  if (!ray.hit) {
    row(say(Word::page_what_it_brings),
        steps({symbol("C"), column(ray.color)}) + fmt::format("<p>{}</p>", say(Word::background)),
        "result");
    return;
  }
  const ExplainedHit& hit = *ray.hit;
  std::string symbols = symbol("I"), numbers = column(hit.local);
  const auto add = [&](const Child& child, const std::string& share, const char* index) {
    if (child.ray < 0) return;
    symbols += kPlus + product({share, indexed("C", index)});
    numbers +=
        kPlus + product({number(child.share),
                         column(e_.trees[t].rays[static_cast<std::size_t>(child.ray)].color)});
  };
  const std::string k1 = indexed("k", "1"), k2 = indexed("k", "2");
  add(hit.reflected, hit.reflected.share == hit.k1 ? k1 : in_brackets(k1 + operation("+") + k2),
      "refl");
  add(hit.refracted, k2, "refr");
  std::string text = numbers == column(hit.local)
                         ? steps({symbol("C"), symbols, numbers})
                         : steps({symbol("C"), symbols, numbers, column(hit.sum)});
  if (hit.sum != ray.color)
    text += fmt::format("<p>{}</p>", say(Word::clamped)) + steps({symbol("C"), column(ray.color)});
  row(say(Word::page_what_it_brings), text, "result");
}

/// A ray with all that comes of it, to fold and unfold.
void Page::ray(std::size_t t, std::size_t r, const std::string& title) {
  const ExplainedRay& ray = e_.trees[t].rays[r];
  const bool unfolded = r == 0 || std::fabs(ray.weight) >= kUnfolded;
  constexpr const char* kKinds[] = {"camera", "reflected", "refracted"};
  put("<details class=\"ray {}\" id=\"{}\"{}>\n<summary>{}<span class=\"title\">{}</span>"
      "<span class=\"target\">{}</span></summary>\n",
      kKinds[static_cast<int>(ray.kind)], ray_mark(t, r), unfolded ? " open" : "",
      swatch(ray.color), title,
      ray.hit ? html_text(label(*ray.hit, Case::nominative)) : say(Word::meets_nothing));
  row(say(Word::page_start),
      fmt::format("<p>{}</p><p>{}</p>",
                  say(Word::starts, short_vector(ray.origin), short_vector(ray.direction)),
                  say(Word::weight, short_number(ray.weight))));
  if (ray.hit) hit(t, ray);
  sum(t, ray);
  put("</details>\n");
}

}  // namespace zraka
