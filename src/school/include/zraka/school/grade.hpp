// SPDX-License-Identifier: Apache-2.0
// Marks for pictures of the lab's stages, and the cause of what is wrong in them.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>
#include <zraka/compare.hpp>
#include <zraka/explain.hpp>
#include <zraka/school/mistakes.hpp>

namespace zraka {

/// What a teacher sets (docs/grade.md).
struct Rubric {
  std::array<double, 7> marks = {1, 1, 1, 1, 1, 1, 1};  ///< of a right picture, stage by stage
  double tolerance = 2;       ///< what a channel may differ by, in steps of 1/255
  double share = 0.005;       ///< of the pixels that may differ by more
  double for_mistake = 0.5;   ///< share of the marks that is left where a mistake is named first
  bool once = true;           ///< a mistake costs where it is first seen, and not again
  std::set<Mistake> allowed;  ///< mistakes that cost nothing
};
/// Allows what the sheet's wording allows.
Rubric default_rubric();
/// From JSON (docs/grade.md). Fails with the place of what is wrong.
Result<Rubric> read_rubric(const std::string& path);

/// How a submission had to be brought into line; none of it costs marks where nothing else is left.
struct Alignment {
  bool flipped = false;                                        ///< upside down
  bool transposed = false;                                     ///< rows for columns
  bool swapped = false;                                        ///< red and blue
  enum class Curve { none, srgb, power } curve = Curve::none;  ///< taken back from the colours
  bool unpainted = false;       ///< a grid of lines that the program left out on a scaled screen
  bool scaled = false;          ///< it has another size
  bool cut = false;             ///< a part of a window, or a part of the picture
  double across = 1, down = 1;  ///< its pixels for one of the right picture
  double left = 0, top = 0;     ///< where the picture begins in it
  /// Where it was compared in its own size, with the scene rendered anew; 0: the scene's.
  std::uint32_t drawn_width = 0, drawn_height = 0;
  double visible = 1;  ///< the share of the picture that was handed in, and judged
  bool plain() const {
    return !flipped && !transposed && !swapped && curve == Curve::none && !unpainted && !scaled &&
           !cut && drawn_width == 0;
  }
};

enum class Verdict {
  right,
  mistaken,  ///< one of the catalogue's mistakes, or two, make this picture: nothing is left
  probable,  ///< one explains most of what differs, and something is left
  unknown,   ///< it differs, and no known mistake explains that
  missing,
  unreadable
};

struct StageGrade {
  int stage = 1;
  std::string file{};  ///< "" where missing
  Verdict verdict = Verdict::missing;
  double marks = 0, of = 0;
  Alignment alignment{};
  /// Those that make the picture; several where it cannot tell them apart.
  std::vector<Mistake> mistakes{};
  bool both = false;       ///< two at once: the first, and one of the others
  /// Another stage whose right picture it is: then what this stage adds is not to be seen. Nothing
  /// is named then: mistakes are only some that would hide it. 0: none.
  int right_as = 0;
  bool repeated = false;   ///< the mistake was there in an earlier stage
  double share_wrong = 0;  ///< pixels that differ from the right picture
  double share_left = 0;   ///< pixels that differ from what is named
  std::vector<PixelPair>
      pixels{};            ///< a: the submission, b: the right picture, where they differ first
  Diagnostics problems{};  ///< of an unreadable file
  /// Is it so for all that were made?
  template <class Is>
  bool made_only(const Is& is) const {
    const auto first = mistakes.begin(), last = mistakes.end();
    if (first == last || !both) return std::any_of(first, last, is);
    return is(*first) && std::any_of(first + 1, last, is);
  }
  /// What is shown and explained as named.
  MistakenBy named() const {
    if (mistakes.empty()) return {};
    return both ? MistakenBy(mistakes[0], mistakes[1]) : MistakenBy(mistakes[0]);
  }
  /// As it was compared; what was cut off of it is the right picture's. Empty where there is none.
  Image aligned{};
};

struct Grade {
  std::string name;
  std::vector<StageGrade> stages;
  double marks = 0, of = 0;
  Diagnostics problems;  ///< of the whole submission; then there are no stages
};

/// Why a pixel has its colour, right and with a mistake.
struct ToldApart {
  Explanation right, mistaken;
};

/// May a submission be a link to where it lies? What is in a folder never may.
enum class Links { follow, refuse };

/// Marks submissions of one scene, from any number of threads. The scene must outlive it.
class Grader {
 public:
  static Result<Grader> create(const Scene& scene, const RenderOptions& options,
                               const Rubric& rubric = default_rubric());
  Grader(Grader&&) noexcept;
  ~Grader();

  /// A picture, or a folder, a zip archive or a document (.docx) of pictures. A single picture is
  /// one of the stage that it is nearest to. Never fails: what is wrong stands in the grade.
  /// `stage` is what all its pictures are of, 1 to 7; 0: what they show and how they are called.
  Grade grade(const std::string& path, Links links = Links::follow, int stage = 0) const;

  /// The picture of a stage as an 8 bit file has it, right or with mistakes.
  Image picture(int stage, const MistakenBy& by = {}) const;
  /// The same in the size that a submission's picture was compared in.
  Image picture(const StageGrade& judged, const MistakenBy& by = {}) const;
  const Rubric& rubric() const;

  /// The first of the stage's pixels, right and as the named mistakes make it. None where none is
  /// named.
  std::optional<ToldApart> told_apart(const StageGrade& stage) const;

 private:
  struct Impl;
  explicit Grader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace zraka
