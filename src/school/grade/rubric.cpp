// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <zraka/school/grade.hpp>

#include "core/file.hpp"
#include "core/text.hpp"

namespace zraka {

Result<Rubric> read_rubric(const std::string& path) {
  const Result<std::string> text = read_file(path, std::uint64_t{1} << 20);
  if (!text) return tl::make_unexpected(text.error());
  const nlohmann::json json = nlohmann::json::parse(*text, nullptr, false);
  if (json.is_discarded() || !json.is_object())
    return failure(path, "it is no JSON object", "docs/grade.md shows a rubric");
  Rubric rubric = default_rubric();
  const auto number = [&](const char* key, double low, double high, double& value) -> Result<void> {
    const auto found = json.find(key);
    if (found == json.end()) return {};
    if (!found->is_number() || !(found->get<double>() >= low && found->get<double>() <= high))
      return failure(path, fmt::format("\"{}\" is not a number from {} to {}", key, low, high));
    value = found->get<double>();
    return {};
  };
  Result<void> good = number("tolerance", 0, 255, rubric.tolerance);
  if (good) good = number("share", 0, 1, rubric.share);
  if (good) good = number("for_mistake", 0, 1, rubric.for_mistake);
  if (!good) return tl::make_unexpected(good.error());
  for (const auto& [key, value] : json.items()) {
    if (key == "tolerance" || key == "share" || key == "for_mistake") continue;
    if (key == "once" && value.is_boolean()) {
      rubric.once = value.get<bool>();
    } else if (key == "marks" && value.is_array() && value.size() == rubric.marks.size()) {
      for (std::size_t i = 0; i < rubric.marks.size(); ++i) {
        if (!value[i].is_number() || !(value[i].get<double>() >= 0))
          return failure(path,
                         fmt::format("\"marks\": value {} is not a number of 0 or more", i + 1));
        rubric.marks[i] = value[i].get<double>();
      }
    } else if (key == "allowed" && value.is_array()) {
      rubric.allowed.clear();
      for (const auto& one : value) {
        const std::string name = one.is_string() ? one.get<std::string>() : one.dump();
        const std::optional<Mistake> mistake = mistake_named(name);
        if (!mistake)
          return failure(path, fmt::format("\"allowed\": there is no mistake '{}'", shown(name)),
                         "zraka grade --list names them all");
        rubric.allowed.insert(*mistake);
      }
    } else if (key == "marks") {
      return failure(path, "\"marks\" is not an array of seven numbers");
    } else if (key == "once" || key == "allowed") {
      return failure(path, fmt::format("\"{}\" is not {}", key,
                                       key == "once" ? "true or false" : "an array of mistakes"));
    } else {
      return failure(path, fmt::format("there is no \"{}\" in a rubric", shown(key)),
                     "marks, tolerance, share, for_mistake, once, allowed");
    }
  }
  return rubric;
}

}  // namespace zraka
