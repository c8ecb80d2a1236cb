// SPDX-License-Identifier: Apache-2.0
#include "look_options.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "particles/color_map.hpp"
#include "scene/depth_cue.hpp"

namespace zraka::app {
namespace {

/// X,Y,Z,D once or several times: what lies more than D along the unit vector of (X, Y, Z).
std::optional<std::vector<Cut>> cuts_in(const std::string& list, bool eye_only) {
  std::vector<double> numbers;
  const char* at = list.data();
  const char* const end = at + list.size();
  for (;;) {
    double number = 0;
    const auto [after, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
    if (after == end) break;
    if (*after != ',') return std::nullopt;
    at = after + 1;
  }
  if (numbers.size() % 4 != 0) return std::nullopt;
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    const double x = numbers[i], y = numbers[i + 1], z = numbers[i + 2];
    const double length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0)) return std::nullopt;
    const double away = numbers[i + 3] / length;
    cuts.push_back(
        {.point = {x * away, y * away, z * away}, .normal = {x, y, z}, .eye_only = eye_only});
  }
  return cuts;
}

}  // namespace

void LookArguments::add_to(Command& command) {
  command
      .add("--cut", &cut,
           "X,Y,Z,D: take away what lies farther than D along (X, Y, Z), and close what is cut "
           "open; several cuts one after the other")
      .check(
          "X,Y,Z,D with commas between the numbers, or several such, where X, Y, Z are not all 0",
          [](const std::string& list) { return cuts_in(list, false).has_value(); });
  command.add("--cut-eye-only", &cut_eye_only,
              "mirrors, glass and shadows know nothing of what --cut takes away");
  command.add("--depth-cue", &depth_cue, "what is farther away fades into the background");
  command
      .add("--outlines", &outlines,
           "black lines of this width, in pixels, where objects, depths or edges meet")
      .range(1, kMaxOutlines);
  command.add("--color-by", &color_by,
              "of a file of particles: element, or the column whose numbers become colours");
  std::vector<std::string> maps(std::begin(kColorMapNames), std::end(kColorMapNames));
  command.add("--color-map", &color_map, "the colours of --color-by's numbers (default: viridis)")
      .one_of(maps);
}

std::string LookArguments::problem() const {
  if (cut_eye_only && cut.empty()) return "--cut-eye-only is for --cut, which is not there";
  if (!color_map.empty() && (color_by.empty() || color_by == "element"))
    return "--color-map is for --color-by with a column";
  return "";
}

void LookArguments::apply_to(ReadOptions& options) const {
  options.color_by = color_by;
  options.color_map = color_map;
}

Result<void> LookArguments::apply_to(Scene& scene, const std::string& name) const {
  if (!color_by.empty() && scene.format != "particles")
    return failure(name, "--color-by is for files of particles alone",
                   "a scene says color_by in its shape of kind 'particles'");
  if (const auto cuts = cuts_in(cut, cut_eye_only))
    scene.cuts.insert(scene.cuts.end(), cuts->begin(), cuts->end());
  if (depth_cue && scene.fog.kind != Fog::Kind::none)
    return failure(name, "the scene has fog, and --depth-cue would be another",
                   "leave out one of the two");
  if (depth_cue && !add_depth_cue(scene))
    return failure(name, "nothing is in front of the eye that could fade with --depth-cue",
                   "shapes without an end, as planes, do not count");
  return {};
}

}  // namespace zraka::app
