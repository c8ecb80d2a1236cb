// SPDX-License-Identifier: Apache-2.0
// 62 mistakes of which the catalogue knows none: whoever names one of its own for them names a
// false one. The last twelve are held out: nothing has been tuned on them. Whoever does adds as
// many others.
#pragma once

#include <iterator>
#include <string_view>

namespace zraka::outside {

enum class Slip {
  none,
  no_ambient,
  ambient_triple,
  ambient_is_diffuse,
  diffuse_squared,
  diffuse_wrapped,
  diffuse_by_distance,
  diffuse_stepped,
  specular_third,
  specular_white,
  specular_squared_color,
  exponent_fixed,
  specular_times_facing,
  shadow_inverted,
  shadow_of_first_only,
  shadow_short,
  local_shared,
  mean_of_three,
  reflection_squared,
  reflection_schlick,
  mirror_from_light,
  background_grey,
  radius_larger,
  radius_squared,
  moved_down,
  first_missing,
  green_lost,
  channels_turned,
  few_colors,
  normalised_by_brightest,
  normal_from_origin,
  normal_not_unit,
  shadow_of_all,
  diffuse_linear,
  tone_mapped,
  farthest_hit,
  reflection_colored,
  light_at_eye,
  light_from_afar,
  eye_nearer,
  one_ior,
  highlight_stepped,
  diffuse_root,
  shadow_not_by_glass,
  shadow_from_center,
  far_root,
  radius_halved,
  ambient_where_unlit,
  local_less_mirror,
  refraction_is_rest,
  colors_squared,
  // Held out.
  parallel_rays,
  root_forgotten,
  light_twice,
  normal_z_reversed,
  diffuse_blue_and_red,
  view_from_origin,
  shadow_behind,
  shadow_not_of_last,
  brightest_counts,
  one_bounce,
  missed_are_ambient,
  brackets_forgotten,
  count
};
inline constexpr Slip kFirstHeldOut = Slip::parallel_rays;

constexpr std::string_view kNames[] = {"none",
                                       "no ambient",
                                       "ambient three times",
                                       "kd for ka",
                                       "diffuse squared",
                                       "diffuse wrapped",
                                       "light fades with distance",
                                       "diffuse in steps",
                                       "a third of ks",
                                       "ks is white",
                                       "ks squared",
                                       "one exponent for all",
                                       "specular times L·N",
                                       "shadow inverted",
                                       "shadow of the first sphere only",
                                       "shadow rays of length 1",
                                       "local light times 1 - k1 - k2",
                                       "mean of local, reflected and refracted",
                                       "k1 squared",
                                       "Schlick for k1",
                                       "reflected ray from the light",
                                       "grey background",
                                       "radius times 1.15",
                                       "radius squared",
                                       "all moved down",
                                       "first sphere missing",
                                       "green lost",
                                       "channels turned",
                                       "8 steps of colour",
                                       "brightest is white",
                                       "normal from the origin",
                                       "N not normalised",
                                       "shadow leaves a third of all",
                                       "diffuse by the angle itself",
                                       "c / (1 + c) for clamping",
                                       "farthest hit",
                                       "k1 times kd",
                                       "light at the eye",
                                       "L the same everywhere",
                                       "eye at z = 1.6",
                                       "one index for all glass",
                                       "highlight is all or nothing",
                                       "root of L·N",
                                       "glass throws no shadow",
                                       "shadow rays from the centre",
                                       "the far root of the sphere",
                                       "radius halved",
                                       "ambient only where unlit",
                                       "local light times 1 - k1",
                                       "k2 is 1 - k1 in glass",
                                       "colours squared",
                                       "parallel rays",
                                       "r² - d² without its root",
                                       "each light counts twice",
                                       "N's z has the wrong sign",
                                       "kd as blue, green, red",
                                       "V to the origin",
                                       "shadow of what is behind the point",
                                       "no shadow of the last sphere",
                                       "the brightest of three terms",
                                       "depth 1",
                                       "rays that miss bring Ia",
                                       "(-2b cos + root) / 2 without brackets"};
static_assert(std::size(kNames) == static_cast<std::size_t>(Slip::count));

/// The first stage that the slip shows in.
inline int stage_of(Slip slip) {
  if (slip >= Slip::parallel_rays)
    return slip == Slip::brackets_forgotten ? 7
           : slip >= Slip::brightest_counts ? 6
           : slip >= Slip::shadow_behind    ? 5
           : slip == Slip::view_from_origin ? 4
           : slip == Slip::parallel_rays    ? 2
                                            : 3;
  if (slip >= Slip::highlight_stepped)
    return slip == Slip::refraction_is_rest                                        ? 7
           : slip == Slip::local_less_mirror                                       ? 6
           : slip == Slip::shadow_not_by_glass || slip == Slip::shadow_from_center ? 5
           : slip == Slip::highlight_stepped                                       ? 4
           : slip == Slip::diffuse_root || slip == Slip::ambient_where_unlit       ? 3
                                                                                   : 2;
  if (slip >= Slip::normal_not_unit)
    return slip == Slip::shadow_of_all                              ? 5
           : slip == Slip::reflection_colored                       ? 6
           : slip == Slip::one_ior                                  ? 7
           : slip == Slip::farthest_hit || slip >= Slip::eye_nearer ? 2
                                                                    : 3;
  if (slip >= Slip::background_grey) return 7;
  if (slip >= Slip::local_shared) return 7;
  if (slip >= Slip::shadow_inverted) return 5;
  if (slip >= Slip::specular_third) return 4;
  return slip >= Slip::diffuse_squared ? 3 : slip >= Slip::no_ambient ? 3 : 7;
}

}  // namespace zraka::outside
