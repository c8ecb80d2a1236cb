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

std::optional<Stage> stage_of(const Terms& terms) {
  for (std::size_t i = 0; i < kStageNames.size(); ++i)
    if (const auto stage = static_cast<Stage>(i + 1); terms == terms_of(stage)) return stage;
  return std::nullopt;
}

Profile profile_of(ProfileName name) {
  switch (name) {
    case ProfileName::lab:
      return {.pixel_centers = false,
              .average_corners = false,
              .clamp_levels = true,
              .index_is_ratio = true,
              .mirror_when_total = false,
              .transfer = Transfer::linear};
    case ProfileName::physical:
      return {.pixel_centers = true,
              .average_corners = false,
              .clamp_levels = false,
              .index_is_ratio = false,
              .mirror_when_total = true,
              .transfer = Transfer::srgb};
    case ProfileName::spd:
      return {.pixel_centers = false,
              .average_corners = true,
              .clamp_levels = false,
              .index_is_ratio = false,
              .mirror_when_total = false,
              .transfer = Transfer::linear};
    case ProfileName::tachyon:
      return {.pixel_centers = true,
              .average_corners = false,
              .clamp_levels = false,
              .index_is_ratio = false,
              .mirror_when_total = false,
              .transfer = Transfer::linear,
              .filter_surfaces = true,
              .sky_beyond = true};
  }
  return {};
}

std::string_view name_of(ProfileName name) {
  switch (name) {
    case ProfileName::lab:
      return "lab";
    case ProfileName::physical:
      return "physical";
    case ProfileName::spd:
      return "spd";
    case ProfileName::tachyon:
      return "tachyon";
  }
  return "";
}

std::optional<ProfileName> profile_named(std::string_view name) {
  for (const ProfileName profile : {ProfileName::lab, ProfileName::physical, ProfileName::spd,
                                    ProfileName::tachyon})
    if (name == name_of(profile)) return profile;
  return std::nullopt;
}

}  // namespace zraka
