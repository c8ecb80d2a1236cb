// SPDX-License-Identifier: Apache-2.0
// The catalogue of mistakes that a picture can be rendered with, for grading and for questions.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>
#include <zraka/explain.hpp>
#include <zraka/render.hpp>

namespace zraka {

enum class Mistake {
  none,
#define ZRAKA_MISTAKE(name, key, allowed, stage, english, croatian) name,
#include <zraka/school/mistakes.def>
#undef ZRAKA_MISTAKE
};

/// MistakeEntry::first_stage of mistakes of dispersion and the sheet's advanced tasks, which none of
/// the lab's pictures shows.
inline constexpr int kAdvanced = 8;

/// A mistake as people and files call it.
struct MistakeEntry {
  Mistake mistake;
  std::string_view key;  ///< in rubrics and JSON: "feeler-unbounded"
  bool allowed;          ///< the sheet's wording allows it, so it costs no marks by default
  int first_stage;       ///< 1 to 7: the first of the lab's pictures that can show it; or kAdvanced
  std::string_view english, croatian;
};

/// All mistakes, without Mistake::none.
const std::vector<MistakeEntry>& all_mistakes();
/// Those that the lab's pictures can show: what is graded and asked about.
std::span<const MistakeEntry> lab_mistakes();
/// Not for Mistake::none.
const MistakeEntry& entry_of(Mistake mistake);
std::optional<Mistake> mistake_named(std::string_view key);

/// What a program does wrong: nothing, one mistake, or two at once.
struct MistakenBy {
  Mistake first = Mistake::none, second = Mistake::none;
  MistakenBy(Mistake one = Mistake::none, Mistake other = Mistake::none)
      : first(one), second(other) {}
  friend bool operator==(const MistakenBy&, const MistakenBy&) = default;
};

/// render() as a program does that makes the mistakes. Fails where render() does; with mistakes of
/// the lab also for scenes that ask for more, and for Isa::oracle.
Result<Rendering> render_mistaken(const Scene& scene, const RenderOptions& options,
                                  const MistakenBy& by);
/// Explainer::create() for such a picture.
Result<Explainer> mistaken_explainer(const Scene& scene, const RenderOptions& options,
                                     const MistakenBy& by);
/// explain() for a pixel of such a picture.
Result<Explanation> explain_mistaken(const Scene& scene, const RenderOptions& options,
                                     const MistakenBy& by, std::uint32_t x, std::uint32_t y);

}  // namespace zraka
