// SPDX-License-Identifier: Apache-2.0
// The page for browsers: page.html, filled in.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <zraka/compare.hpp>

#include "compare/words.hpp"
#include "core/base64.hpp"
#include "core/text.hpp"

namespace zraka {
namespace {

constexpr std::string_view kPage =
#include "compare/page.html.inc"
    ;

Result<std::string> data_uri(const Image& shown_image) {
  const Result<std::string> png = encode_png(shown_image);
  if (!png) return png;
  return "data:image/png;base64," + base64(*png);
}

/// A map as levels of grey, for the page to colour: black for 0, white for `brightest`.
Image grey_picture(const std::vector<float>& map, std::uint32_t width, std::uint32_t height,
                   double brightest) {
  Image picture(width, height);
  for (std::size_t i = 0; i < map.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      picture.pixels[3 * i + c] = static_cast<float>(map[i] / brightest);
  return picture;
}

std::string places_of(const std::vector<PixelPair>& pairs) {
  std::string list;
  for (const PixelPair& pair : pairs)
    list += fmt::format("{}[{},{}]", list.empty() ? "" : ",", pair.x, pair.y);
  return list;
}

std::string data_for_script(const Comparison& c, double brightest) {
  std::string colors;
  for (const auto& color : heat_colors())
    colors += fmt::format(
        "{}[{},{},{}]", colors.empty() ? "" : ",", quantize(color[0], Transfer::linear, 8),
        quantize(color[1], Transfer::linear, 8), quantize(color[2], Transfer::linear, 8));
  return fmt::format(
      R"({{"width":{},"height":{},"brightest_text":"{:.4g} of 255","worst":[{}],"first":[{}],"heat":[{}]}})",
      c.a.image.width, c.a.image.height, steps_of(brightest), places_of(c.worst),
      places_of(c.first), colors);
}

std::string table_of(const Comparison& c, const std::string& a_name, const std::string& b_name) {
  std::string rows;
  for (const auto& [label, value] : measure_lines(c, a_name, b_name))
    rows += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", html_text(label), html_text(value));
  return rows;
}

}  // namespace

Result<std::string> comparison_page(const Comparison& c, const std::string& a_name,
                                    const std::string& b_name) {
  const std::uint32_t width = c.a.image.width, height = c.a.image.height;
  const std::vector<float> differences = difference_map(c.a.image, c.b.image);
  const double brightest = brightest_difference(differences);
  std::map<std::string_view, std::string> parts;
  const auto add_picture = [&](std::string_view key, const Image& image) -> Result<void> {
    const Result<std::string> uri = data_uri(image);
    if (!uri) return tl::make_unexpected(uri.error());
    parts[key] = *uri;
    return {};
  };
  Result<void> good = add_picture("a_src", as_shown(c.a.image, c.floats));
  if (good) good = add_picture("b_src", as_shown(c.b.image, c.floats));
  if (good)
    good = add_picture("difference_src", grey_picture(differences, width, height, brightest));
  if (good) good = add_picture("flip_src", grey_picture(c.flip.map, width, height, 1));
  if (!good) return tl::make_unexpected(good.error());

  parts["title"] = html_text(fmt::format("{} against {}", b_name, a_name));
  parts["heading"] = html_text(fmt::format("{} against {}", b_name, a_name));
  parts["verdict"] = html_text(verdict_on(c));
  parts["verdict_class"] = c.within ? "good" : "bad";
  parts["a_name"] = html_text(a_name);
  parts["b_name"] = html_text(b_name);
  parts["numbers"] = table_of(c, a_name, b_name);
  parts["values_note"] = c.floats || c.bits != 8
                             ? "Values are those that the screen is given, rounded to 8 bits."
                             : "Values are the stored ones, 0 to 255.";
  parts["data"] = data_for_script(c, brightest);

  std::string page;
  std::string_view rest = kPage;
  for (;;) {
    const std::size_t begin = rest.find("{{");
    page += rest.substr(0, begin);
    if (begin == std::string_view::npos) return page;
    const std::size_t end = rest.find("}}", begin);
    page += parts.at(rest.substr(begin + 2, end - begin - 2));
    rest.remove_prefix(end + 2);
  }
}

}  // namespace zraka
