// SPDX-License-Identifier: Apache-2.0
#include "explain/page.hpp"

#include "core/base64.hpp"
#include "core/page_css.hpp"
#include "explain/names.hpp"
#include "explain/page_writer.hpp"
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

}  // namespace

void Page::head() {
  const std::string title = say(Word::page_title, e_.x, e_.y);
  put("<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n",
      code_of(options_.language), title, kSharedCss, kPageCss);
  std::string facts = say(Word::pixel_of, e_.x, e_.y, e_.resolution.width, e_.resolution.height);
  if (options_.profile)
    facts += fmt::format(" · {}", say(word_of(*options_.profile)));
  if (const std::optional<Stage> stage = stage_of(e_.terms))
    facts += fmt::format(" · {}", html_text(text_of(options_.language, *stage)));
  if (e_.samples > 1)
    facts += fmt::format(" · {}", say(Word::sample_of, e_.sample + 1, e_.samples));
  put("<header>\n<p class=\"file\">{}</p>\n<h1>{}</h1>\n<p class=\"facts\">{} · {}</p>\n",
      html_text(options_.scene), title, facts, say(Word::depth_is, e_.max_depth));
  if (e_.varied)
    put("<p class=\"unlit\">{}</p>\n",
        say(Word::with_mistake, text_of(options_.language, *e_.varied)));
  const auto byte = [&](std::size_t c) {
    return e_.outlined ? 0 : quantize(e_.color[c], e_.profile.transfer, 8);
  };
  put("<div class=\"answer\">{}<div><p class=\"sentence\">{}</p>\n"
      "<p class=\"numbers\">{}: {}; {} ({}, {}, {})</p></div></div>\n</header>\n",
      swatch(e_.color), html_text(in_words(options_.language, e_)), say(color_of_what(e_)),
      short_vector(e_.color), say(Word::color_in_file), byte(0), byte(1), byte(2));
  if (e_.outlined) put("<p class=\"unlit\">{}</p>\n", say(Word::outlined));
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
  constexpr Word kKinds[] = {Word::ray_camera,          Word::ray_reflected,
                             Word::ray_refracted,       Word::page_shadow_ray_lit,
                             Word::page_shadow_ray_blocked, Word::page_shadow_ray_dimmed};
  const std::size_t kinds = std::size(kKinds) - (e_.transparent_shadows ? 0 : 1);
  for (std::size_t i = 0; i < kinds; ++i)
    put("<li><label><input type=\"checkbox\" checked data-kind=\"{0}\"><i class=\"kind{0}\"></i>"
        "{1}</label></li>",
        i, say(kKinds[i]));
  put("</ul>\n</div>\n</section>\n");
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

Result<std::string> to_page(const Scene& scene, const Explanation& explanation,
                            const PagePictures& pictures, const PageOptions& options) {
  return Page(scene, explanation, pictures, options).write();
}

}  // namespace zraka
