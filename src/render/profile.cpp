// SPDX-License-Identifier: Apache-2.0
// Stages and profiles as switches: the one place that says what each of them is.
#include <zraka/render.hpp>

namespace zraka {

Terms terms_of(Stage stage) {
  return {.silhouette = stage == Stage::silhouette,
          .ambient = stage >= Stage::ambient,
          .diffuse = stage >= Stage::diffuse,
          .specular = stage >= Stage::specular,
          .shadows = stage >= Stage::shadows,
          .reflection = stage >= Stage::reflection,
          .refraction = stage >= Stage::refraction};
}

Profile profile_of(ProfileName name) {
  switch (name) {
    case ProfileName::lab:
      return {.pixel_centers = false,
              .clamp_levels = true,
              .index_is_ratio = true,
              .mirror_when_total = false,
              .transfer = Transfer::linear};
    case ProfileName::physical:
      return {.pixel_centers = true,
              .clamp_levels = false,
              .index_is_ratio = false,
              .mirror_when_total = true,
              .transfer = Transfer::srgb};
  }
  return {};
}

}  // namespace zraka
