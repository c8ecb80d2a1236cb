// SPDX-License-Identifier: Apache-2.0
#include "school/report/page.hpp"

#include <cmath>

#include "core/append.hpp"
#include "core/base64.hpp"
#include "core/counted.hpp"
#include "core/text.hpp"
#include "explain/names.hpp"
#include "school/report/comments.hpp"

namespace zraka {
namespace {

constexpr std::string_view kPageCss =
#include "school/report/page.css.inc"
    ;

/// The sheet's formulas in MathML (3.3 to 3.6).
constexpr std::string_view kHitFormula =
    "<msup><mrow><mo>|</mo><mi>P</mi><mo>+</mo><mi>t</mi><mi>S</mi><mo>−</mo><mi>C</mi><mo>|</mo>"
    "</mrow><mn>2</mn></msup><mo>=</mo><msup><mi>r</mi><mn>2</mn></msup>";
constexpr std::string_view kLightFormula =
    "<mi>I</mi><mo>=</mo><msub><mi>I</mi><mi>a</mi></msub><msub><mi>k</mi><mi>a</mi></msub>"
    "<mo>+</mo><munder><mo>∑</mo><mi>i</mi></munder><mo>(</mo><msub><mi>I</mi><mi>i</mi></msub>"
    "<msub><mi>k</mi><mi>d</mi></msub><mo>(</mo><mi>L</mi><mo>·</mo><mi>N</mi><mo>)</mo><mo>+</mo>"
    "<msub><mi>I</mi><mi>i</mi></msub><msub><mi>k</mi><mi>s</mi></msub><msup><mrow><mo>(</mo>"
    "<mi>R</mi><mo>·</mo><mi>V</mi><mo>)</mo></mrow><mi>n</mi></msup><mo>)</mo>";
constexpr std::string_view kReflectionFormula =
    "<mi>R</mi><mo>=</mo><mn>2</mn><mo>(</mo><mi>U</mi><mo>·</mo><mi>N</mi><mo>)</mo><mi>N</mi>"
    "<mo>−</mo><mi>U</mi>";
constexpr std::string_view kRefractionFormula =
    "<mi>R</mi><mo>=</mo><mo>−</mo><mi>a</mi><mi>N</mi><mo>−</mo><mi>b</mi><mi>U</mi><mo>,</mo>"
    "<mspace width=\"1em\"/><mi>b</mi><mo>=</mo><mfrac><msub><mi>n</mi><mn>1</mn></msub>"
    "<msub><mi>n</mi><mn>2</mn></msub></mfrac>";
constexpr std::string_view kAlongNormalFormula =
    "<mi>a</mi><mo>=</mo><mfrac><mrow><msqrt><mi>D</mi></msqrt><mo>−</mo><mn>2</mn><mi>b</mi>"
    "<mi>cos</mi><mi>α</mi></mrow><mn>2</mn></mfrac>";
constexpr std::string_view kDiscriminantFormula =
    "<mi>D</mi><mo>=</mo><mn>4</mn><mo>(</mo><msup><mi>b</mi><mn>2</mn></msup>"
    "<msup><mi>cos</mi><mn>2</mn></msup><mi>α</mi><mo>−</mo><msup><mi>b</mi><mn>2</mn></msup>"
    "<mo>+</mo><mn>1</mn><mo>)</mo>";
constexpr std::string_view kSumFormula =
    "<mi>C</mi><mo>=</mo><mi>I</mi><mo>+</mo><msub><mi>k</mi><mn>1</mn></msub>"
    "<msub><mi>C</mi><mi>refl</mi></msub><mo>+</mo><msub><mi>k</mi><mn>2</mn></msub>"
    "<msub><mi>C</mi><mi>refr</mi></msub>";

class Page {
 public:
  Page(const SceneFacts& facts, const std::array<ReportPicture, 7>& pictures,
       const std::optional<ReportLetter>& letter, const ReportOptions& options)
      : facts_(facts), pictures_(pictures), letter_(letter), options_(options) {}

  std::string write() {
    head();
    method();
    put("<section>\n<h2>{}</h2>\n", say(Word::report_stages));
    for (std::size_t i = 0; i < pictures_.size(); ++i) stage(i);
    put("</section>\n");
    if (letter_) letter();
    times();
    put("<footer>{} {}</footer>\n</body>\n</html>\n", say(Word::report_files, "PNG"),
        say(Word::report_made_by));
    return std::move(out_);
  }

 private:
  template <class... Values>
  std::string say(Word word, const Values&... values) const {
    return html_prose(zraka::say(options_.language, word, values...));
  }
  template <class... Values>
  void put(fmt::format_string<Values...> text, Values&&... values) {
    append(out_, text, std::forward<Values>(values)...);
  }

  void head();
  void method();
  void stage(std::size_t i);
  void letter();
  void times();
  /// A paragraph of the method, its title set off, and a formula after it.
  void paragraph(const std::string& text, std::string_view formula = {});
  void figure(const std::string& png, const std::string& caption);
  std::string milliseconds(const RenderStats& stats) const {
    return fmt::format("{} ms", decimal(options_.language,
                                        1000 * (stats.build_seconds + stats.render_seconds), 1));
  }

  const SceneFacts& facts_;
  const std::array<ReportPicture, 7>& pictures_;
  const std::optional<ReportLetter>& letter_;
  const ReportOptions& options_;
  std::string out_;
};

Word title_of(std::size_t i) {
  return static_cast<Word>(static_cast<std::size_t>(Word::title_silhouette) + i);
}

void Page::head() {
  put("<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<header>\n",
      code_of(options_.language), say(Word::report_title), kPageCss);
  put("<p class=\"sheet\">{}</p>\n<h1>{}</h1>\n", say(Word::report_sheet), say(Word::report_title));
  if (!options_.author.empty())
    put("<p class=\"author\">{}</p>\n", say(Word::report_author, options_.author));
  put("<p class=\"facts\">{}</p>\n</header>\n",
      say(Word::report_scene, options_.scene,
          fmt::format("{}×{}", facts_.resolution.width, facts_.resolution.height),
          zraka::say(options_.language, word_of(options_.profile)), facts_.max_depth));
}

void Page::paragraph(const std::string& text, std::string_view formula) {
  const std::size_t end = text.find(". ");
  put("<p><b>{}</b>{}</p>\n", text.substr(0, end + 1), text.substr(end + 1));
  if (!formula.empty()) put("<math display=\"block\">{}</math>\n", formula);
}

void Page::method() {
  put("<section class=\"method\">\n<h2>{}</h2>\n", say(Word::report_method));
  paragraph(say(Word::method_ray));
  paragraph(say(Word::method_hit), kHitFormula);
  put("<p>{}</p>\n", say(Word::method_hit_after));
  paragraph(say(Word::method_light), kLightFormula);
  put("<p>{}</p>\n", say(Word::method_light_after));
  paragraph(say(Word::method_shadow));
  paragraph(say(Word::method_reflection), kReflectionFormula);
  paragraph(say(Word::method_refraction), kRefractionFormula);
  for (const std::string_view more : {kAlongNormalFormula, kDiscriminantFormula})
    put("<math display=\"block\">{}</math>\n", more);
  put("<p>{}</p>\n", say(Word::method_total));
  paragraph(say(Word::method_sum, facts_.max_depth), kSumFormula);
  put("<p>{}</p>\n</section>\n",
      say(facts_.profile.clamp_levels ? Word::method_clamp_levels : Word::method_clamp));
}

void Page::figure(const std::string& png, const std::string& caption) {
  put("<figure><img src=\"data:image/png;base64,{}\" alt=\"{}\" width=\"{}\" height=\"{}\">"
      "<figcaption>{}</figcaption></figure>\n",
      base64(png), caption, facts_.resolution.width, facts_.resolution.height, caption);
}

void Page::stage(std::size_t i) {
  const auto stage = static_cast<Stage>(i + 1);
  const std::string title = say(title_of(i));
  put("<article>\n<h3>{}</h3>\n<div class=\"pictures\">\n", title);
  figure(pictures_[i].picture, say(Word::report_stage_picture, i + 1));
  if (i > 0)
    figure(pictures_[i].changes,
           say(Word::report_difference, i, std::lround(255 * pictures_[i].brightest)));
  put("</div>\n<p>");
  for (const std::string& sentence : comments_on(options_.language, facts_, stage))
    put("{}\n", html_prose(sentence));
  put("</p>\n</article>\n");
}

void Page::letter() {
  put("<section>\n<article>\n<h2>{}</h2>\n<div class=\"pictures\">\n", say(Word::report_letter));
  put("<figure><img src=\"data:image/png;base64,{}\" alt=\"{}\" width=\"400\" height=\"400\">"
      "<figcaption>{}</figcaption></figure>\n</div>\n",
      base64(letter_->picture), say(Word::report_letter), say(Word::report_stage_picture, 8));
  put("<p>{}</p>\n</article>\n</section>\n",
      say(Word::report_letter_of, letter_->text,
          counted(options_.language, Counted::sphere, letter_->spheres),
          counted(options_.language, Counted::ray, letter_->stats.rays.total()),
          milliseconds(letter_->stats)));
}

void Page::times() {
  put("<section class=\"times\">\n<h2>{}</h2>\n<div class=\"wide\"><table>\n<thead><tr>"
      "<th>{}</th><th>{}</th><th>{}</th><th>{}</th><th>{}</th><th>{}</th><th>ms</th><th>{}</th>"
      "</tr></thead>\n<tbody>\n",
      say(Word::report_times), say(Word::report_column_stage), say(Word::report_column_eye),
      say(Word::report_column_shadow_rays), say(Word::report_column_reflected),
      say(Word::report_column_refracted), say(Word::report_column_all),
      say(Word::report_column_rate));
  for (std::size_t i = 0; i < facts_.stages.size(); ++i) {
    const StageFacts& stage = facts_.stages[i];
    const double seconds = stage.build_seconds + stage.render_seconds;
    const std::string title = say(title_of(i));
    put("<tr><th>{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td></tr>\n",
        title, grouped(stage.rays.camera), grouped(stage.rays.shadow),
        grouped(stage.rays.reflected), grouped(stage.rays.refracted), grouped(stage.rays.total()),
        decimal(options_.language, 1000 * seconds, 1),
        decimal(options_.language,
                seconds > 0 ? static_cast<double>(stage.rays.total()) / seconds / 1e6 : 0, 1));
  }
  put("</tbody>\n</table></div>\n<p class=\"facts\">{}</p>\n</section>\n",
      say(Word::report_threads, facts_.threads, name_of(facts_.isa)));
}

}  // namespace

std::string report_page(const SceneFacts& facts, const std::array<ReportPicture, 7>& pictures,
                        const std::optional<ReportLetter>& letter, const ReportOptions& options) {
  return Page(facts, pictures, letter, options).write();
}

}  // namespace zraka
