// SPDX-License-Identifier: Apache-2.0
// The page of a pixel while it is written: page.cpp has its frame, page_rays.cpp the tree's rays.
#pragma once

#include <fmt/format.h>

#include <string>

#include "core/append.hpp"
#include "core/text.hpp"
#include "explain/math_ml.hpp"
#include "explain/names.hpp"
#include "explain/optics_words.hpp"
#include "explain/page.hpp"

namespace zraka {

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
  /// A hit, or what blocks a light; not yet for HTML.
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
    append(out_, text, std::forward<Values>(values)...);
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
  void surface(const ExplainedHit& hit);
  void textures(const ExplainedHit& hit);
  void light(const ExplainedHit& hit, std::size_t i);
  void snell(std::size_t t, const ExplainedHit& hit);
  /// `nm` is not 0 for a part of the spectrum.
  void child(std::size_t t, const Child& child, bool reflected, const ExplainedHit& hit, double nm);
  /// One number where all channels have the same.
  std::string share(const Child& child) const {
    return is_grey(child.shares) ? number(child.share) : column(child.shares);
  }
  /// Paragraphs.
  std::string lines_of(const std::vector<std::string>& lines, const char* kind) const {
    std::string text;
    for (const std::string& line : lines)
      text += fmt::format("<p class=\"{}\">{}</p>", kind, html_text(line));
    return text;
  }
  void sum(std::size_t t, const ExplainedRay& ray);

  const Scene& scene_;
  const Explanation& e_;
  const PagePictures& pictures_;
  const PageOptions& options_;
  std::string out_;
};

}  // namespace zraka
