// SPDX-License-Identifier: Apache-2.0
#include "school/grade/page.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/append.hpp"
#include "core/base64.hpp"
#include "core/page_css.hpp"
#include "core/text.hpp"
#include "explain/names.hpp"
#include "image/page_picture.hpp"
#include "school/grade/words.hpp"
#include "school/mistakes/names.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPageCss =
#include "school/grade/page.css.inc"
    ;

class Page {
 public:
  Page(Language language, const Grader& grader) : language_(language), grader_(grader) {}

  Result<std::string> of_one(const Grade& grade, const std::string& scene);
  Result<std::string> of_all(const std::vector<Grade>& grades, const std::string& scene);

 private:
  template <class... Values>
  std::string say(Word word, const Values&... values) const {
    return html_text(zraka::say(language_, word, values...));
  }
  template <class... Values>
  void put(fmt::format_string<Values...> text, Values&&... values) {
    append(out_, text, std::forward<Values>(values)...);
  }

  void head(const std::string& title, const std::string& scene);
  void stage(const StageGrade& stage);
  void findings_of(const StageGrade& stage);
  void pictures(const StageGrade& stage);
  void figure(const Image& image, const std::string& caption, const StageGrade* marked = nullptr);
  void row(const Grade& grade);
  Result<std::string> finished() {
    put("<footer>{}</footer>\n</body>\n</html>\n", say(Word::report_made_by));
    if (!problems_.empty()) return tl::make_unexpected(std::move(problems_));
    return std::move(out_);
  }

  Language language_;
  const Grader& grader_;
  std::string out_;
  Diagnostics problems_;
};

void Page::head(const std::string& title, const std::string& scene) {
  put("<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n<header>\n<p "
      "class=\"scene\">{}</p>\n<h1>{}</h1>\n",
      code_of(language_), title, kSharedCss, kPageCss, say(Word::grade_scene, scene), title);
}

/// A picture, with rings around the pixels that `marked` names.
void Page::figure(const Image& image, const std::string& caption, const StageGrade* marked) {
  const Result<std::string> png = png_for_page(image);
  if (!png) {
    problems_ = png.error();
    return;
  }
  put("<figure><div><img alt=\"{}\" src=\"data:image/png;base64,{}\">", caption, base64(*png));
  if (marked != nullptr)
    for (const PixelPair& pixel : marked->pixels)
      put("<span class=\"mark\" style=\"left:{:.3f}%;top:{:.3f}%\"></span>",
          100 * (pixel.x + 0.5) / image.width, 100 * (pixel.y + 0.5) / image.height);
  put("</div><figcaption>{}</figcaption></figure>\n", caption);
}

void Page::pictures(const StageGrade& stage) {
  if (stage.aligned.pixels.empty()) return;
  const Image right = grader_.picture(stage);
  put("<div class=\"pictures\">\n");
  figure(stage.aligned, say(Word::grade_handed_in, shown(stage.file)), &stage);
  if (stage.verdict != Verdict::right) {
    figure(right, say(Word::grade_picture_right), &stage);
    const std::vector<float> map = difference_map(stage.aligned, right);
    const double brightest = brightest_difference(map);
    figure(heat_picture(map, right.width, right.height, brightest),
           say(Word::grade_difference, std::lround(255 * brightest)));
  }
  if (!stage.mistakes.empty())
    figure(grader_.picture(stage, stage.named()), say(Word::grade_picture_mistake));
  put("</div>\n");
}

void Page::findings_of(const StageGrade& stage) {
  bool first = true;
  for (const std::string& line : findings(language_, grader_, stage)) {
    put("<p{}>{}</p>\n", first ? " class=\"verdict\"" : "", html_prose(line));
    first = false;
  }
}

void Page::stage(const StageGrade& stage) {
  put("<article class=\"{}\">\n<h2>{}<span class=\"marks\">{}</span></h2>\n", key_of(stage.verdict),
      html_text(capitalized(std::string(text_of(language_, static_cast<Stage>(stage.stage))))),
      say(Word::grade_marks, marks_text(language_, stage.marks), marks_text(language_, stage.of)));
  findings_of(stage);
  pictures(stage);
  put("</article>\n");
}

Result<std::string> Page::of_one(const Grade& grade, const std::string& scene) {
  head(html_text(shown(fs::path(grade.name).lexically_normal().filename().string())), scene);
  put("<p class=\"total\">{}</p>\n</header>\n<main>\n",
      say(Word::grade_marks, marks_text(language_, grade.marks), marks_text(language_, grade.of)));
  for (const Diagnostic& problem : grade.problems)
    put("<p class=\"problem\">{}</p>\n", html_text(to_string(problem, language_)));
  for (const StageGrade& one : grade.stages) stage(one);
  put("</main>\n");
  return finished();
}

/// Name, marks, a cell for each stage; below it, folded, what was found out.
void Page::row(const Grade& grade) {
  put("<details>\n<summary><span class=\"name\">{}</span><span class=\"marks\">{}</span>"
      "<span class=\"cells\">",
      html_text(shown(grade.name)),
      say(Word::grade_marks, marks_text(language_, grade.marks), marks_text(language_, grade.of)));
  for (const StageGrade& stage : grade.stages)
    put("<i class=\"{}\" title=\"{}\">{}{}</i>", key_of(stage.verdict),
        html_text(findings(language_, grader_,
                           {.stage = stage.stage,
                            .verdict = stage.verdict,
                            .mistakes = stage.mistakes,
                            .both = stage.both,
                            .share_wrong = stage.share_wrong,
                            .problems = stage.problems})
                      .front()),
        stage.stage, sign_of(stage.verdict));
  put("</span></summary>\n");
  for (const Diagnostic& problem : grade.problems)
    put("<p class=\"problem\">{}</p>\n", html_text(to_string(problem, language_)));
  for (const StageGrade& stage : grade.stages) {
    put("<h3>{}</h3>\n",
        html_text(capitalized(std::string(text_of(language_, static_cast<Stage>(stage.stage))))));
    findings_of(stage);
  }
  put("</details>\n");
}

Result<std::string> Page::of_all(const std::vector<Grade>& grades, const std::string& scene) {
  head(say(Word::grade_title), scene);
  put("</header>\n<main class=\"class\">\n");
  for (const Grade& grade : grades) row(grade);
  put("</main>\n");
  return finished();
}

}  // namespace

Result<std::string> grade_page(Language language, const Grader& grader, const Grade& grade,
                               const std::string& scene) {
  return Page(language, grader).of_one(grade, scene);
}

Result<std::string> grades_page(Language language, const Grader& grader,
                                const std::vector<Grade>& grades, const std::string& scene) {
  return Page(language, grader).of_all(grades, scene);
}

}  // namespace zraka
