// SPDX-License-Identifier: Apache-2.0
#include "core/counted.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace zraka {

std::string counted(Language language, Counted what, std::uint64_t number) {
  constexpr Word kFirst[] = {Word::count_pixel_one,     Word::count_ray_one,
                             Word::count_eye_ray_one,   Word::count_shadow_ray_one,
                             Word::count_reflected_one, Word::count_refracted_one,
                             Word::count_color_one,     Word::count_point_one,
                             Word::count_sphere_one,    Word::count_time_one};
  const std::uint64_t ones = number % 10, hundred = number % 100;
  int form = 2;
  if (language == Language::english)
    form = number == 1 ? 0 : 2;
  else if (ones == 1 && hundred != 11)
    form = 0;
  else if (ones >= 2 && ones <= 4 && (hundred < 12 || hundred > 14))
    form = 1;
  const int first = static_cast<int>(kFirst[static_cast<int>(what)]);
  return say(language, static_cast<Word>(first + form), grouped(number));
}

std::string with_comma(Language language, std::string number) {
  if (language == Language::croatian) std::replace(number.begin(), number.end(), '.', ',');
  return number;
}

std::string decimal(Language language, double value, int digits) {
  return with_comma(language, fmt::format("{:.{}f}", value, digits));
}

std::string percentage(Language language, std::uint64_t part, std::uint64_t whole) {
  const double percent =
      100 * static_cast<double>(part) / static_cast<double>(std::max<std::uint64_t>(whole, 1));
  if (percent > 99.95 && part < whole) return "> " + decimal(language, 99.9, 1);
  return percent > 0 && percent < 0.05 ? "< " + decimal(language, 0.1, 1)
                                       : decimal(language, percent, 1);
}

}  // namespace zraka
