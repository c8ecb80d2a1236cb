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

/// "k1 + k2·F" as a formula.
std::string share_formula(const std::string& symbols) {
  std::string text;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const char c = symbols[i];
    if (c == 'k') {
      text += math::indexed("k", symbols.substr(++i, 1));
    } else if (symbols.compare(i, 2, "·") == 0) {
      text += math::operation("·");
      ++i;
    } else if (c >= '0' && c <= '9') {
      text += fmt::format("<mn>{}</mn>", c);
    } else if (c == 'F' || c == 'w') {
      text += math::symbol(std::string(1, c));
    } else if (c != ' ') {
      text += math::operation(c == '-' ? "−" : std::string(1, c));
    }
  }
  return text;
}

/// k₁ for k1, as far as a text begins with it.
std::string with_indices(const std::string& text) {
  if (text.rfind("k1 = ", 0) == 0) return "k₁" + text.substr(2);
  if (text.rfind("k2 = ", 0) == 0) return "k₂" + text.substr(2);
  return text;
}

}  // namespace

void Page::light(const ExplainedHit& hit, std::size_t i) {
  using namespace math;
  const LightTerms& at = hit.lights[i];
  const Language language = options_.language;
  const ExplainedLight& from = e_.lights[i];
  const ReachWords reach = reach_words(language, from, at);
  std::string way = steps({symbol("L"), column(at.to_light)}) +
                    steps({dot("L", "N"), number(at.l_n)}) +
                    lines_of(reach.lines, reach.in_shadow ? "unlit" : "lit") +
                    fmt::format("<p>{}</p>", html_text(light_distance(language, at)));
  for (const auto& lines : {fading_lines(language, from, at), passed_lines(language, at)})
    way += lines_of(lines, "place");
  row(html_text(light_title(language, e_, i)), way);

  // Ii, less what distance, cone and transparent bodies take.
  std::string symbols = indexed(at.arriving == from.color ? "I" : "I'", "i");
  std::string numbers = column(at.arriving);
  if (is_filtered(at)) {
    symbols = product({symbols, symbol("T")});
    numbers = product({numbers, column(*at.filter)});
  }
  const bool blinn = hit.highlight == Highlight::blinn;
  const std::string mean = fmt::format("<p>{}</p>", html_text(mean_of_samples(language, at)));
  if (at.diffuse)
    row(say(Word::diffuse),
        at.samples > 1
            ? mean + steps({column(*at.diffuse)})
            : steps({product({symbols, indexed("k", "d"), in_brackets(dot("L", "N"))}),
                     product({numbers, column(hit.kd), number(at.l_n)}), column(*at.diffuse)}));
  if (at.specular)
    row(say(Word::specular),
        at.samples > 1
            ? mean + steps({column(*at.specular)})
            : steps({product({symbols, indexed("k", "s"),
                              power(in_brackets(blinn ? dot("N", "H") : dot("R", "V")),
                                    symbol("n"))}),
                     product({numbers, column(hit.ks),
                              power(number(at.r_v.value_or(0)), number(hit.shininess))}),
                     column(*at.specular)}));
  else if (at.r_v && at.samples == 1)
    row(say(Word::specular),
        fmt::format("<p>{}</p>", say(blinn ? Word::no_specular_blinn : Word::no_specular,
                                     short_number(*at.r_v))));
}

void Page::snell(std::size_t t, const ExplainedHit& hit) {
  using namespace math;
  const SnellTerms& s = *hit.snell;
  const Angles angles = angles_of(s);
  const std::string b = symbol("b"), b2 = power(b, "<mn>2</mn>"), cosine = "<mi>cos</mi><mi>α</mi>",
                    minus = operation("−");
  const std::string quotient = fraction(indexed("n", "1"), indexed("n", "2"));
  std::string text =
      (s.nm ? fmt::format("<p>{} nm</p>", short_number(*s.nm)) : "") +
      (s.n1 == 0 ? steps({b, quotient, number(s.ratio)})
                 : steps({b, quotient, fraction(number(s.n1), number(s.n2)), number(s.ratio)})) +
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
    text += fmt::format("; {}</p>", say(after_total_reflection(e_, hit)));
  } else if (s.a) {
    text += steps({symbol("a"),
                   fraction(fmt::format("{}<mn>2</mn>{}{}{}{}{}", minus, b, operation("·"), cosine,
                                        operation("+"), root(symbol("D"))),
                            "<mn>2</mn>"),
                   number(*s.a)}) +
            fmt::format("<p>{} β = {}</p>", say(Word::page_angle_out),
                        degrees(angles.beta_deg.value_or(0)));
    if (hit.refracted.ray >= 0)
      text += steps(
          {symbol("R"),
           fmt::format("{}<mi>a</mi>{}<mi>N</mi>{}<mi>b</mi>{}<mi>U</mi>", minus, operation("·"),
                       minus, operation("·")),
           column(e_.trees[t].rays[static_cast<std::size_t>(hit.refracted.ray)].direction)});
    const std::string fresnel = fresnel_line(options_.language, hit);
    if (!fresnel.empty()) text += fmt::format("<p>{}</p>", html_text(fresnel));
  }
  row(say(Word::refraction), text);
}

/// What was hit and where on it.
void Page::surface(const ExplainedHit& hit) {
  using namespace math;
  std::string terms =
      fmt::format("<p>{}</p>", say(Word::meets, label(hit, Case::accusative),
                                   short_number(hit.distance), short_vector(hit.point)));
  if (const std::string medium = medium_line(options_.language, hit); !medium.empty())
    terms += fmt::format("<p class=\"place\">{}</p>", html_text(medium));
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
  if (e_.terms.ambient) {
    std::string symbols = product({indexed("I", "a"), indexed("k", "a")}),
                numbers = product({column(e_.ambient_light), column(hit.ka)}), arrives;
    if (hit.occlusion) {
      arrives = fmt::format("<p>{}</p>", html_text(occlusion_line(options_.language, hit)));
      symbols = product({symbols, symbol("O")});
      numbers = product({numbers, column(*hit.occlusion)});
    }
    row(say(Word::ambient), arrives + steps({symbols, numbers, column(hit.ambient)}));
  }
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
  child(t, hit.reflected, true, hit, 0);
  if (hit.split.empty() || hit.refracted.absence == Absence::contribution)
    child(t, hit.refracted, false, hit, 0);
  for (const SplitChild& part : hit.split) child(t, part.child, false, hit, part.nm);
}

void Page::child(std::size_t t, const Child& child, bool reflected, const ExplainedHit& hit,
                 double nm) {
  if (child.ray >= 0) {
    std::string title = say(reflected ? Word::ray_reflected : Word::ray_refracted);
    if (nm > 0) title += fmt::format(", {} nm", short_number(nm));
    ray(t, static_cast<std::size_t>(child.ray),
        fmt::format("{}, <math>{}<mo>=</mo>{}</math>", title,
                    share_formula(share_symbols(hit, child, reflected, nm > 0)), share(child)));
    return;
  }
  const std::string why = absence_words(options_.language, e_, hit, child, reflected);
  put("<p class=\"absent\">{}: {}</p>\n", say(reflected ? Word::no_reflected : Word::no_refracted),
      html_text(with_indices(why)));
}

/// What the ray brings back.
void Page::sum(std::size_t t, const ExplainedRay& ray) {
  using namespace math;
  if (!ray.hit) {
    row(say(Word::page_what_it_brings),
        steps({symbol("C"), column(ray.color)}) + fmt::format("<p>{}</p>", say(name_of_sky(e_))),
        "result");
    return;
  }
  const ExplainedHit& hit = *ray.hit;
  std::string symbols = symbol("I"), numbers = column(hit.local);
  const auto add = [&](const Child& child, bool reflected) {
    if (child.ray < 0) return;
    const std::string factor = share_symbols(hit, child, reflected, false);
    symbols += kPlus + product({factor.find(" + ") == std::string::npos
                                    ? share_formula(factor)
                                    : in_brackets(share_formula(factor)),
                                indexed("C", reflected ? "refl" : "refr")});
    numbers +=
        kPlus + product({share(child),
                         column(e_.trees[t].rays[static_cast<std::size_t>(child.ray)].color)});
  };
  add(hit.reflected, true);
  add(hit.refracted, false);
  if (!hit.split.empty()) {
    const std::string factor = share_symbols(hit, hit.split.front().child, false, true);
    symbols +=
        kPlus + operation("Σ") + product({share_formula(factor), indexed("C", "refr")});
    numbers += kPlus + column(brought_by_split(e_.trees[t], hit));
  }
  if (hit.sky_beyond) {
    symbols += kPlus + symbol("S");
    numbers += kPlus + column(hit.sky_beyond->reflected) + kPlus + column(hit.sky_beyond->refracted);
  }
  const Float3 brought = before_fog(e_, ray);
  std::string text = numbers == column(hit.local)
                         ? steps({symbol("C"), symbols, numbers})
                         : steps({symbol("C"), symbols, numbers, column(hit.sum)});
  const Float3 clamped = after_clamp(e_, hit.sum);
  if (clamped != hit.sum || (hit.sum != brought && !hit.medium))
    text += fmt::format("<p>{}</p>", say(Word::clamped)) + steps({symbol("C"), column(hit.medium ? clamped : brought)});
  if (hit.medium)
    text += steps({product({symbol("C"), symbol("T")}),
                   product({column(clamped), column(hit.medium->transmittance)}),
                   column(brought)});
  if (const std::string sky = sky_beyond_line(options_.language, hit); !sky.empty())
    text += fmt::format("<p>S: {}</p>", html_text(sky));
  if (ray.fog) text += fmt::format("<p>{}</p>", html_text(fog_line(options_.language, e_, ray)));
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
                  say(Word::weight, short_number(ray.weight))) +
          (ray.inside.empty()
               ? std::string()
               : fmt::format("<p>{}</p>", html_text(inside_line(options_.language, ray)))));
  if (ray.hit) hit(t, ray);
  sum(t, ray);
  put("</details>\n");
}

}  // namespace zraka
