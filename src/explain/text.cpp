// SPDX-License-Identifier: Apache-2.0
#include "explain/text.hpp"

#include "core/text.hpp"
#include "explain/angles.hpp"
#include "explain/formulas.hpp"
#include "explain/names.hpp"
#include "explain/optics_words.hpp"
#include "explain/sentence.hpp"
#include "explain/surface_words.hpp"

namespace zraka {
namespace {

enum class Style { plain, faint, strong, camera, reflected, refracted, shadow, result };

class Writer {
 public:
  Writer(const Explanation& explanation, const TextOptions& options)
      : e_(explanation), options_(options) {}

  std::string write();

 private:
  template <class... Values>
  std::string say(Word word, const Values&... values) const {
    return zraka::say(options_.language, word, values...);
  }
  /// A hit, or what blocks a light.
  template <class Hit>
  std::string label(const Hit& hit, Case form) const {
    return label_of(options_.language, hit, form);
  }
  template <class Value>
  std::string short_number(Value v) const {
    return zraka::short_number(options_.language, v);
  }
  template <class Value>
  std::string short_vector(const Value& v) const {
    return zraka::short_vector(options_.language, v);
  }
  /// One number where all channels have the same.
  std::string share(const Child& child) const {
    return is_grey(child.shares) ? short_number(child.share) : short_vector(child.shares);
  }
  std::string degrees(double v) const { return decimal(options_.language, v, 2) + "°"; }
  std::string_view between() const { return between_numbers(options_.language); }
  std::string in(Style style, const std::string& text) const;
  std::string swatch(const Float3& color) const;

  void line(const std::string& lead, const std::string& text) {
    out_ += in(Style::faint, lead) + text + "\n";
  }
  void ray(const RayTree& tree, std::size_t r, const std::string& lead);
  void hit(const RayTree& tree, const ExplainedRay& ray, const std::string& lead);
  /// A line, unless it is empty.
  void note(const std::string& lead, const std::string& text) {
    if (!text.empty()) line(lead, text);
  }
  void textures(const ExplainedHit& hit, const std::string& lead);
  void light(const ExplainedHit& hit, std::size_t i, const std::string& lead);
  void snell(const ExplainedHit& hit, const std::string& lead);
  /// `nm` is not 0 for a part of the spectrum.
  void child(const RayTree& tree, const Child& child, RayKind kind, const ExplainedHit& hit,
             double nm, const std::string& lead);
  void sum(const RayTree& tree, const ExplainedRay& ray, const std::string& lead);
  std::string header() const;

  const Explanation& e_;
  const TextOptions& options_;
  std::string out_;
};

std::string Writer::in(Style style, const std::string& text) const {
  constexpr const char* kCodes[] = {"", "2", "1", "1", "1;36", "1;35", "31", "1"};
  if (!options_.color || style == Style::plain || text.empty()) return text;
  return fmt::format("\x1b[{}m{}\x1b[0m", kCodes[static_cast<int>(style)], text);
}

/// A little of the colour itself, as the file will show it.
std::string Writer::swatch(const Float3& color) const {
  if (!options_.color) return "";
  const auto byte = [&](std::size_t c) { return quantize(color[c], e_.profile.transfer, 8); };
  return fmt::format("\x1b[48;2;{};{};{}m  \x1b[0m ", byte(0), byte(1), byte(2));
}

/// The coefficients that textures give.
void Writer::textures(const ExplainedHit& hit, const std::string& lead) {
  for (const TextureWords& words : texture_words(options_.language, hit))
    line(lead, fmt::format("{}: {} = {}", words.texture, fmt::join(words.symbols, " = "),
                           is_color(words.coefficient) ? short_vector(words.value)
                                                       : short_number(words.value[0])));
}

/// One light: the way to it, then its two terms.
void Writer::light(const ExplainedHit& hit, std::size_t i, const std::string& lead) {
  const LightTerms& at = hit.lights[i];
  const ExplainedLight& from = e_.lights[i];
  const Language language = options_.language;
  line(lead, fmt::format("{0}: L = {2}{1}{3}{1}L·N = {4}", light_title(language, e_, i), between(),
                         short_vector(at.to_light), light_distance(language, at),
                         short_number(at.l_n)));
  for (const std::string& more : fading_lines(language, from, at)) line(lead, "  " + more);
  const ReachWords reach = reach_words(language, from, at);
  for (const std::string& more : reach.lines)
    line(lead, fmt::format("  {}", reach.in_shadow ? in(Style::shadow, more) : more));
  for (const std::string& more : passed_lines(language, at)) line(lead, "  " + more);

  // Ii, less what distance, cone and transparent bodies take.
  std::string symbols = "Ii", numbers = short_vector(at.arriving);
  if (at.arriving != from.color) symbols += "'";
  if (is_filtered(at)) {
    symbols += "·T";
    numbers += "·" + short_vector(*at.filter);
  }
  const bool mean = at.samples > 1, blinn = hit.highlight == Highlight::blinn;
  const auto put = [&](Word what, const std::string& formula, const Float3& term) {
    if (mean)
      line(lead, fmt::format("  {}: {} = {}", say(what), mean_of_samples(language, at),
                             short_vector(term)));
    else
      line(lead, fmt::format("  {}: {}{}", say(what), symbols, formula));
  };
  if (at.diffuse)
    put(Word::diffuse,
        fmt::format("·kd·(L·N) = {}·{}·{} = {}", numbers, short_vector(hit.kd),
                    short_number(at.l_n), short_vector(*at.diffuse)),
        *at.diffuse);
  if (at.specular)
    put(Word::specular,
        fmt::format("·ks·({})ⁿ = {}·{}·{}^{} = {}", blinn ? "N·H" : "R·V", numbers,
                    short_vector(hit.ks), short_number(at.r_v.value_or(0)),
                    short_number(hit.shininess), short_vector(*at.specular)),
        *at.specular);
  else if (at.r_v && !mean)
    line(lead, fmt::format("  {}: {}", say(Word::specular),
                           say(blinn ? Word::no_specular_blinn : Word::no_specular,
                               short_number(*at.r_v))));
}

void Writer::snell(const ExplainedHit& hit, const std::string& lead) {
  const SnellTerms& s = *hit.snell;
  const Angles angles = angles_of(s);
  std::string title = say(Word::refraction), indices;
  if (s.nm) title += fmt::format(", {} nm", short_number(*s.nm));
  if (s.n1 != 0) indices = fmt::format("{}/{} = ", short_number(s.n1), short_number(s.n2));
  line(lead, fmt::format("{0}: b = n1/n2 = {5}{2}{1}cos α = U·N = {3}{1}α = {4}", title,
                         between(), short_number(s.ratio), short_number(s.cosine),
                         degrees(angles.alpha_deg), indices));
  const std::string d =
      fmt::format("  D = 4·(b²·cos²α - b² + 1) = {}", short_number(4 * s.quarter_d));
  if (s.total) {
    line(lead, d);
    std::string text = say(Word::total_reflection);
    if (angles.critical_deg)
      text += fmt::format(
          " ({})", say(Word::critical_angle, decimal(options_.language, *angles.critical_deg, 2)));
    text += fmt::format("; {}", say(after_total_reflection(e_, hit)));
    line(lead, fmt::format("  {}", in(Style::shadow, text)));
  } else if (s.a) {
    line(lead, fmt::format("{0}{1}a = (-2·b·cos α + √D)/2 = {2}{1}β = {3}", d, between(),
                           short_number(*s.a), degrees(angles.beta_deg.value_or(0))));
    const std::string fresnel = fresnel_line(options_.language, hit);
    if (!fresnel.empty()) line(lead, "  " + fresnel);
  }
}

void Writer::hit(const RayTree& tree, const ExplainedRay& ray, const std::string& lead) {
  const ExplainedHit& hit = *ray.hit;
  line(lead, say(Word::meets, in(Style::strong, label(hit, Case::accusative)),
                 short_number(hit.distance), short_vector(hit.point)));
  note(lead, medium_line(options_.language, hit));
  for (const std::string& more : place_lines(options_.language, hit)) line(lead, "  " + more);
  line(lead, say(Word::normal, short_vector(hit.normal)) +
                 (hit.flipped ? fmt::format(", {}", say(Word::normal_turned)) : ""));
  if (hit.bent) line(lead, "  " + bent_line(options_.language, hit));
  if (e_.terms.silhouette) {
    line(lead, fmt::format("{}: {}", say(Word::silhouette), short_vector(hit.local)));
    return;
  }
  textures(hit, lead);
  note(lead, occlusion_line(options_.language, hit));
  if (e_.terms.ambient)
    line(lead, fmt::format("{}: Ia·ka{} = {}·{}{} = {}", say(Word::ambient),
                           hit.occlusion ? "·O" : "", short_vector(e_.ambient_light),
                           short_vector(hit.ka),
                           hit.occlusion ? "·" + short_vector(*hit.occlusion) : std::string(),
                           short_vector(hit.ambient)));
  for (std::size_t i = 0; i < hit.lights.size(); ++i) light(hit, i, lead);
  line(lead, fmt::format("{}: I = {}", say(Word::local_light),
                         in(Style::result, short_vector(hit.local))));
  if (hit.snell) snell(hit, lead);
  child(tree, hit.reflected, RayKind::reflected, hit, 0, lead);
  if (hit.split.empty() || hit.refracted.absence == Absence::contribution)
    child(tree, hit.refracted, RayKind::refracted, hit, 0, lead);
  for (const SplitChild& part : hit.split)
    child(tree, part.child, RayKind::refracted, hit, part.nm, lead);
}

/// A child with all its tree, or why there is none.
void Writer::child(const RayTree& tree, const Child& child, RayKind kind, const ExplainedHit& hit,
                   double nm, const std::string& lead) {
  const bool reflected = kind == RayKind::reflected;
  if (child.ray >= 0) {
    const std::string bare = lead.substr(0, lead.size() - std::string("│ ").size());
    const ExplainedRay& next = tree.rays[static_cast<std::size_t>(child.ray)];
    std::string title = say(reflected ? Word::ray_reflected : Word::ray_refracted);
    if (nm > 0) title += fmt::format(", {} nm", short_number(nm));
    title += fmt::format(", {} = {}, {}", share_symbols(hit, child, reflected, nm > 0),
                         share(child), say(Word::weight, short_number(next.weight)));
    line(bare + "├─ ",
         swatch(next.color) + in(reflected ? Style::reflected : Style::refracted, title));
    if (!options_.sums_only)
      ray(tree, static_cast<std::size_t>(child.ray), bare + "│  ");
    else
      line(bare + "│  └ ", "C = " + in(Style::result, short_vector(next.color)));
    return;
  }
  line(lead,
       in(Style::faint,
          fmt::format("{}: {}", say(reflected ? Word::no_reflected : Word::no_refracted),
                      absence_words(options_.language, e_, hit, child, reflected))));
}

/// What the ray brings back.
void Writer::sum(const RayTree& tree, const ExplainedRay& ray, const std::string& lead) {
  if (!ray.hit) {
    if (ray.fog) return line(lead, fog_line(options_.language, e_, ray));
    line(lead, fmt::format("C = {} = {}", say(name_of_sky(e_)),
                           in(Style::result, short_vector(ray.color))));
    return;
  }
  const ExplainedHit& hit = *ray.hit;
  std::string symbols = "I", numbers = short_vector(hit.local);
  const auto add = [&](const Child& child, bool reflected) {
    if (child.ray < 0) return;
    const std::string symbol = share_symbols(hit, child, reflected, false);
    symbols += fmt::format(" + {}·{}",
                           symbol.find(" + ") == std::string::npos ? symbol
                                                                   : fmt::format("({})", symbol),
                           reflected ? "Crefl" : "Crefr");
    numbers += fmt::format(" + {}·{}", share(child),
                           short_vector(tree.rays[static_cast<std::size_t>(child.ray)].color));
  };
  add(hit.reflected, true);
  add(hit.refracted, false);
  if (!hit.split.empty()) {
    symbols += fmt::format(" + Σ {}·Crefr", share_symbols(hit, hit.split.front().child, false, true));
    numbers += " + " + short_vector(brought_by_split(tree, hit));
  }
  note(lead, sky_beyond_line(options_.language, hit));
  if (hit.sky_beyond) {
    symbols += " + S";
    numbers += " + " + short_vector(hit.sky_beyond->reflected) + " + " +
               short_vector(hit.sky_beyond->refracted);
  }
  const Float3 brought = before_fog(e_, ray);
  const bool alone = symbols == "I";
  std::string text = alone ? "C = I = " : fmt::format("C = {} = {} = ", symbols, numbers);
  const Float3 clamped = after_clamp(e_, hit.sum);
  if (hit.medium) {
    const std::string left = short_vector(hit.medium->transmittance);
    if (clamped == hit.sum)
      text = fmt::format("C = ({})·T = ({})·{} = ", symbols, numbers, left);
    else
      text += fmt::format("{}, {}: {}·T = {}·{} = ", short_vector(hit.sum), say(Word::clamped),
                          short_vector(clamped), short_vector(clamped), left);
  } else if (hit.sum != brought) {
    text += fmt::format("{}, {}: ", short_vector(hit.sum), say(Word::clamped));
  }
  line(lead, text + in(Style::result, short_vector(brought)));
  if (ray.fog) line(lead, fog_line(options_.language, e_, ray));
}

/// All lines of a ray below its title.
void Writer::ray(const RayTree& tree, std::size_t r, const std::string& lead) {
  const ExplainedRay& ray = tree.rays[r];
  const std::string inner = lead + "│ ";
  line(inner, say(Word::starts, short_vector(ray.origin), short_vector(ray.direction)));
  note(inner, inside_line(options_.language, ray));
  if (ray.hit)
    hit(tree, ray, inner);
  else
    line(inner, say(Word::meets_nothing));
  sum(tree, ray, lead + "└ ");
}

std::string Writer::header() const {
  std::string text = say(Word::pixel_of, e_.x, e_.y, e_.resolution.width, e_.resolution.height);
  if (!options_.scene.empty()) text = fmt::format("{}, {}", shown_line(options_.scene), text);
  if (options_.profile)
    text += fmt::format(", {}", say(word_of(*options_.profile)));
  if (const std::optional<Stage> stage = stage_of(e_.terms))
    text += fmt::format(", {}", text_of(options_.language, *stage));
  text += fmt::format(", {}", say(Word::depth_is, e_.max_depth));
  if (e_.samples > 1) text += fmt::format(", {}", say(Word::sample_of, e_.sample + 1, e_.samples));
  return text;
}

std::string Writer::write() {
  if (!options_.sums_only) {
    line("", in(Style::strong, header()));
    if (e_.varied)
      line("", in(Style::shadow, say(Word::with_mistake, text_of(options_.language, *e_.varied))));
  }
  for (std::size_t t = 0; t < e_.trees.size(); ++t) {
    const ExplainedRay& root = e_.trees[t].rays.front();
    std::string title = say(Word::ray_camera);
    if (e_.trees.size() > 1)
      title +=
          fmt::format(", {}", say(static_cast<Word>(static_cast<std::size_t>(Word::corner_0) + t)));
    line("", swatch(root.color) + in(Style::camera, title));
    ray(e_.trees[t], 0, "");
  }
  if (e_.trees.size() > 1)
    line("", fmt::format("{}: {}", say(Word::mean_of_corners), short_vector(e_.color)));
  const auto byte = [&](std::size_t c) {
    return e_.outlined ? 0 : quantize(e_.color[c], e_.profile.transfer, 8);
  };
  line("", fmt::format("{}{}: {}, {} ({}, {}, {})", swatch(e_.color), say(color_of_what(e_)),
                       in(Style::result, short_vector(e_.color)), say(Word::color_in_file), byte(0),
                       byte(1), byte(2)));
  if (e_.outlined) line("", say(Word::outlined));
  if (!options_.sums_only) line("", in(Style::strong, in_words(options_.language, e_)));
  return std::move(out_);
}

}  // namespace

std::string to_text(const Explanation& explanation, const TextOptions& options) {
  return Writer(explanation, options).write();
}

}  // namespace zraka
