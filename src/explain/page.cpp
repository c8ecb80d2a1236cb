// SPDX-License-Identifier: Apache-2.0
#include "explain/page.hpp"

#include <algorithm>
#include <cmath>

#include "core/base64.hpp"
#include "core/page_css.hpp"
#include "core/text.hpp"
#include "explain/angles.hpp"
#include "explain/math_ml.hpp"
#include "explain/names.hpp"
#include "explain/sentence.hpp"
#include "explain/space.hpp"

namespace zraka {
namespace {

constexpr std::string_view kPageCss =
#include "explain/page.css.inc"
    ;
constexpr std::string_view kPageJs =
#include "explain/page.js.inc"
    ;

/// A child that counts this much is unfolded at first.
constexpr double kUnfolded = 0.05;

class Page {
 public:
  Page(const Scene& scene, const Explanation& explanation, const PagePictures& pictures,
       const PageOptions& options)
      : scene_(scene), e_(explanation), pictures_(pictures), options_(options) {}

  Result<std::string> write();

 private:
  template <class... Values>
  std::string say(Word word, const Values&... values) const {
    return html_text(zraka::say(options_.language, word, values...));
  }
  std::string label(const NamedShape& shape, Case form) const {
    return html_text(label_of(options_.language, shape, form));
  }
  template <class Value>
  std::string short_number(Value v) const {
    return zraka::short_number(options_.language, v);
  }
  template <class Value>
  std::string short_vector(const Value& v) const {
    return zraka::short_vector(options_.language, v);
  }
  template <class Value>
  std::string number(Value v) const {
    return math::number(options_.language, v);
  }
  template <class Value>
  std::string column(const Value& v) const {
    return math::column(options_.language, v);
  }
  std::string degrees(double v) const { return decimal(options_.language, v, 2) + "°"; }
  template <class... Values>
  void put(fmt::format_string<Values...> text, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), text, std::forward<Values>(values)...);
  }
  /// A line of a ray: what it is, and its formulas.
  void row(const std::string& what, const std::string& formulas, const char* kind = "") {
    put("<div class=\"row {}\"><div class=\"what\">{}</div><div class=\"terms\">{}</div></div>\n",
        kind, what, formulas);
  }
  std::string css_color(const Float3& color) const {
    const auto byte = [&](std::size_t c) { return quantize(color[c], e_.profile.transfer, 8); };
    return fmt::format("rgb({} {} {})", byte(0), byte(1), byte(2));
  }
  std::string swatch(const Float3& color) const {
    return fmt::format("<span class=\"swatch\" style=\"background:{}\"></span>", css_color(color));
  }

  void head();
  Result<void> picture();
  void space();
  void tree();
  void ray(std::size_t t, std::size_t r, const std::string& title);
  void hit(std::size_t t, const ExplainedRay& ray);
  void light(const ExplainedHit& hit, std::size_t i);
  void snell(std::size_t t, const ExplainedHit& hit);
  void child(std::size_t t, const Child& child, bool reflected, const ExplainedHit& hit);
  void sum(std::size_t t, const ExplainedRay& ray);

  const Scene& scene_;
  const Explanation& e_;
  const PagePictures& pictures_;
  const PageOptions& options_;
  std::string out_;
};

void Page::head() {
  constexpr Word kProfiles[] = {Word::profile_lab, Word::profile_physical, Word::profile_spd};
  const std::string title = say(Word::page_title, e_.x, e_.y);
  put("<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n",
      code_of(options_.language), title, kSharedCss, kPageCss);
  std::string facts = say(Word::pixel_of, e_.x, e_.y, e_.resolution.width, e_.resolution.height);
  if (options_.profile)
    facts += fmt::format(" · {}", say(kProfiles[static_cast<int>(*options_.profile)]));
  if (const std::optional<Stage> stage = stage_of(e_.terms))
    facts += fmt::format(" · {}", html_text(text_of(options_.language, *stage)));
  put("<header>\n<p class=\"file\">{}</p>\n<h1>{}</h1>\n<p class=\"facts\">{} · {}</p>\n",
      html_text(options_.scene), title, facts, say(Word::depth_is, e_.max_depth));
  if (e_.varied)
    put("<p class=\"unlit\">{}</p>\n",
        say(Word::with_mistake, text_of(options_.language, *e_.varied)));
  const auto byte = [&](std::size_t c) { return quantize(e_.color[c], e_.profile.transfer, 8); };
  put("<div class=\"answer\">{}<div><p class=\"sentence\">{}</p>\n"
      "<p class=\"numbers\">{}: {}; {} ({}, {}, {})</p></div></div>\n</header>\n",
      swatch(e_.color), html_text(in_words(options_.language, e_)), say(Word::color_of_pixel),
      short_vector(e_.color), say(Word::color_in_file), byte(0), byte(1), byte(2));
}

/// The picture with a ring around the pixel, and the pixel among its neighbours.
Result<void> Page::picture() {
  const PngOptions png{8, e_.profile.transfer};
  const Result<std::string> whole = encode_png(pictures_.picture, png);
  if (!whole) return tl::make_unexpected(whole.error());
  const Neighbourhood& near = pictures_.neighbours;
  const Result<std::string> part = encode_png(near.image, png);
  if (!part) return tl::make_unexpected(part.error());
  const auto percent = [](double at, double of) { return 100 * (at + 0.5) / of; };
  put("<section>\n<h2>{}</h2>\n<div class=\"pictures\">\n", say(Word::page_picture));
  put("<figure class=\"whole\"><img alt=\"{0}\" src=\"data:image/png;base64,{1}\">"
      "<span class=\"mark\" style=\"left:{2:.3f}%;top:{3:.3f}%\"></span></figure>\n",
      say(Word::page_picture), base64(*whole), percent(e_.x, e_.resolution.width),
      percent(e_.y, e_.resolution.height));
  put("<figure class=\"near\"><div><img alt=\"{0}\" src=\"data:image/png;base64,{1}\">"
      "<span class=\"cell\" style=\"left:{2:.3f}%;top:{3:.3f}%;width:{4:.3f}%;height:{5:.3f}%\">"
      "</span></div><figcaption>{0}</figcaption></figure>\n</div>\n</section>\n",
      say(Word::page_neighbours), base64(*part), 100.0 * (e_.x - near.left) / near.image.width,
      100.0 * (e_.y - near.top) / near.image.height, 100.0 / near.image.width,
      100.0 / near.image.height);
  return {};
}

/// The drawing that page.js fills.
void Page::space() {
  put("<section>\n<h2>{}</h2>\n<div class=\"space\">\n", say(Word::page_space));
  put("<svg id=\"space\" tabindex=\"0\" role=\"img\" aria-label=\"{}\"></svg>\n"
      "<noscript>{}</noscript>\n<div class=\"views\">",
      say(Word::page_space), say(Word::page_space_needs_script));
  const auto button = [&](const char* action, Word word) {
    put("<button type=\"button\" data-view=\"{}\">{}</button>", action, say(word));
  };
  button("eye", Word::page_from_eye);
  button("above", Word::page_from_above);
  button("side", Word::page_from_side);
  button("closer", Word::page_closer);
  button("farther", Word::page_farther);
  put("</div>\n<p class=\"hint\">{}</p>\n<ul class=\"legend\">", say(Word::page_space_hint));
  constexpr Word kKinds[] = {Word::ray_camera, Word::ray_reflected, Word::ray_refracted,
                             Word::page_shadow_ray_lit, Word::page_shadow_ray_blocked};
  for (std::size_t i = 0; i < std::size(kKinds); ++i)
    put("<li><label><input type=\"checkbox\" checked data-kind=\"{0}\"><i class=\"kind{0}\"></i>"
        "{1}</label></li>",
        i, say(kKinds[i]));
  put("</ul>\n</div>\n</section>\n");
}

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
      note =
          say(Word::reach_blocked, label_of(options_.language, at.blocker->shape, Case::accusative),
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

void Page::hit(std::size_t t, const ExplainedRay& ray) {
  using namespace math;
  const ExplainedHit& hit = *ray.hit;
  row(say(Word::page_hit),
      fmt::format("<p>{}</p>",
                  say(Word::meets, label_of(options_.language, hit.shape, Case::accusative),
                      short_number(hit.distance), short_vector(hit.point))) +
          steps({symbol("N"), column(hit.normal)}) +
          (hit.flipped ? fmt::format("<p>{}</p>", say(Word::normal_turned)) : ""));
  if (e_.terms.silhouette) {
    row(say(Word::silhouette), steps({symbol("I"), column(hit.local)}));
    return;
  }
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
      ray.hit ? label(ray.hit->shape, Case::nominative) : say(Word::meets_nothing));
  row(say(Word::page_start),
      fmt::format("<p>{}</p><p>{}</p>",
                  say(Word::starts, short_vector(ray.origin), short_vector(ray.direction)),
                  say(Word::weight, short_number(ray.weight))));
  if (ray.hit) hit(t, ray);
  sum(t, ray);
  put("</details>\n");
}

void Page::tree() {
  put("<section class=\"tree\">\n<div class=\"bar\"><h2>{}</h2>"
      "<button type=\"button\" data-fold=\"open\">{}</button>"
      "<button type=\"button\" data-fold=\"close\">{}</button></div>\n",
      say(Word::page_tree), say(Word::page_open_all), say(Word::page_close_all));
  for (std::size_t t = 0; t < e_.trees.size(); ++t) {
    std::string title = say(Word::ray_camera);
    if (e_.trees.size() > 1)
      title +=
          fmt::format(", {}", say(static_cast<Word>(static_cast<std::size_t>(Word::corner_0) + t)));
    ray(t, 0, title);
  }
  if (e_.trees.size() > 1)
    row(say(Word::mean_of_corners), math::steps({math::symbol("C"), column(e_.color)}), "result");
  put("</section>\n");
}

Result<std::string> Page::write() {
  std::size_t rays = 0;
  for (const RayTree& tree : e_.trees) rays += tree.rays.size();
  if (rays > kMaxPageRays)
    return failure(
        "",
        fmt::format("the ray tree of pixel ({}, {}) has {} rays: a page shows {} at most", e_.x,
                    e_.y, rays, +kMaxPageRays),
        "ask for fewer levels with a smaller depth, or for JSON");
  head();
  put("<main>\n<div class=\"side\">\n");
  const Result<void> shown = picture();
  if (!shown) return tl::make_unexpected(shown.error());
  space();
  put("</div>\n");
  tree();
  put("</main>\n<footer>{}</footer>\n", say(Word::page_made_by));
  put("<script type=\"application/json\" id=\"space-data\">{}</script>\n<script>\n{}</script>\n"
      "</body>\n</html>\n",
      space_json(options_.language, scene_, e_), kPageJs);
  return std::move(out_);
}

}  // namespace

Result<std::string> to_page(const Scene& scene, const Explanation& explanation,
                            const PagePictures& pictures, const PageOptions& options) {
  return Page(scene, explanation, pictures, options).write();
}

}  // namespace zraka
