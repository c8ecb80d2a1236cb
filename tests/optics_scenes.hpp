// SPDX-License-Identifier: Apache-2.0
// Scenes with everything that the general engine does, one thing after the other.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace zraka {

/// A floor, a wall of mirror, glass and matt bodies in front; what a test adds is up to it.
inline Scene room_with_glass(std::uint32_t side = 24) {
  Scene scene;
  scene.resolution = {side, side};
  scene.camera = {{0, 1, 6}, {0, 0.8, 0}, {4, 0, 0}, {0, 4, 0}};
  scene.ambient_light = {0.3, 0.3, 0.4};
  scene.background = {0.1, 0.3, 0.5};
  scene.lights = {{{2, 4, 3}, {0.9, 0.8, 0.7}}, {{-3, 2, 1}, {0.3, 0.4, 0.5}}};
  scene.materials = {
      {.ambient = {0.2, 0.2, 0.2}, .diffuse = {0.6, 0.5, 0.4}, .specular = {0.3, 0.3, 0.3}},
      {.ambient = {}, .diffuse = {0.05, 0.05, 0.05}, .specular = {0.5, 0.5, 0.5}, .shininess = 80,
       .reflection = 0.1, .refraction = 0.85, .ior = 1.5},
      {.ambient = {0.1, 0, 0}, .diffuse = {0.3, 0.3, 0.3}, .reflection = Color{0.5, 0.6, 0.7}},
      {.ambient = {0.4, 0.1, 0.1}, .diffuse = {0.7, 0.2, 0.2}, .specular = {1, 1, 1},
       .shininess = 20, .highlight = Highlight::blinn},
  };
  scene.planes.push_back({Plane{{0, -1, 0}, {0, 1, 0}}, 0});
  scene.parallelograms.push_back({Parallelogram{{-3, -1, -3}, {6, 0, 0}, {0, 4, 0}}, 2});
  scene.spheres.push_back({Sphere{{-0.6, 0.2, 0.5}, 0.9}, 1});
  scene.spheres.push_back({Sphere{{1.1, 0, -1}, 0.7}, 3});
  scene.boxes.push_back({Box{{0.5, -1, 0.8}, {1.2, -0.2, 1.5}}, 1});
  scene.names[{0, 0}] = "bowl";
  scene.material_names[1] = "glass";
  return scene;
}

inline Light surface_light(LightKind kind, int samples = 4) {
  Light light;
  light.kind = kind;
  light.position = {1, 3.5, 2};
  light.edge_u = {1, 0, 0}, light.edge_v = {0, 0, 1};
  light.radius = 0.6;
  light.color = {0.8, 0.7, 0.9};
  light.samples = samples;
  return light;
}

struct OpticsCase {
  std::string name;
  Scene scene;
  RenderOptions options{};
};

/// The first cases are the lean engine's, with what it knows beyond the lab; the others are not.
inline std::vector<OpticsCase> optics_cases() {
  std::vector<OpticsCase> all;
  const auto add = [&](std::string name, const auto& change) {
    OpticsCase one{std::move(name), room_with_glass(), {.profile = profile_of(ProfileName::physical)}};
    change(one.scene, one.options);
    all.push_back(std::move(one));
  };
  add("Blinn's highlights", [](Scene& scene, RenderOptions&) {
    for (Material& material : scene.materials) material.highlight = Highlight::blinn;
    scene.materials[2].reflection = 0.5;
  });
  for (const bool linear : {false, true})
    add(linear ? "lean spot with a linear edge" : "lean spot", [&](Scene& s, RenderOptions&) {
      s.materials[2].reflection = 0.5;
      s.lights[0].kind = LightKind::spot;
      s.lights[0].direction = {-2, -4, -3};
      s.lights[0].inner_deg = 8, s.lights[0].outer_deg = 20;
      s.lights[0].linear_edge = linear;
      s.lights[1].attenuation = {1, 0.1, 0.05};
    });
  add("spot", [](Scene& s, RenderOptions&) {
    s.lights[0].kind = LightKind::spot;
    s.lights[0].direction = {-2, -4, -3};
    s.lights[0].inner_deg = 8, s.lights[0].outer_deg = 20;
  });
  add("spot with a linear edge", [](Scene& s, RenderOptions&) {
    s.lights[0].kind = LightKind::spot;
    s.lights[0].direction = {-2, -4, -3};
    s.lights[0].inner_deg = 4, s.lights[0].outer_deg = 30;
    s.lights[0].linear_edge = true;
  });
  for (const Fog::Kind kind : {Fog::Kind::linear, Fog::Kind::exponential, Fog::Kind::squared})
    for (const bool planar : {false, true})
      add(fmt::format("fog {} {}", static_cast<int>(kind), planar), [&](Scene& s, RenderOptions&) {
        s.fog = {kind, 1, 12, 0.11, {0.5, 0.6, 0.7}, planar};
        s.materials[1].absorption = {0.1, 0.4, 0.9};
      });
  add("the sky beyond", [](Scene& s, RenderOptions& o) {
    o.profile = profile_of(ProfileName::tachyon);
    o.max_depth = 1;
    o.shadows = Shadows::transparent;
    s.fog = {Fog::Kind::exponential, 1, 12, 0.05, {0.5, 0.6, 0.7}, false};
    s.materials[3].casts_shadow = false;
  });
  add("directional", [](Scene& s, RenderOptions&) {
    s.lights[0].kind = LightKind::directional;
    s.lights[0].direction = {-1, -3, -2};
  });
  for (const LightKind kind : {LightKind::rectangle, LightKind::disc, LightKind::sphere})
    add(fmt::format("surface {}", static_cast<int>(kind)), [&](Scene& s, RenderOptions& o) {
      s.lights.push_back(surface_light(kind));
      o.shadows = kind == LightKind::disc ? Shadows::transparent : Shadows::opaque;
    });
  add("attenuation", [](Scene& s, RenderOptions&) { s.lights[0].attenuation = {1, 0.1, 0.05}; });
  add("transparent shadows", [](Scene& s, RenderOptions& o) {
    s.materials[1].absorption = {0.1, 0.4, 0.9};
    s.materials[1].refraction = Color{0.9, 0.6, 0.3};
    o.shadows = Shadows::transparent;
  });
  for (const Fresnel fresnel : {Fresnel::exact, Fresnel::schlick})
    for (const ProfileName profile : {ProfileName::physical, ProfileName::lab, ProfileName::spd})
      add(fmt::format("fresnel {}", static_cast<int>(fresnel)), [&](Scene& s, RenderOptions& o) {
        s.materials[1].fresnel = fresnel;
        s.materials[1].reflection = 0;
        s.materials[1].refraction = Color{1, 0.9, 0.8};
        o.profile = profile_of(profile);
      });
  add("priorities", [](Scene& s, RenderOptions& o) {
    s.materials[1].priority = 1;
    s.materials[1].absorption = {0.2, 0.1, 0};
    s.materials.push_back({.ambient = {}, .diffuse = {}, .refraction = 1, .ior = 1.2,
                           .absorption = {0, 0.3, 0.5}, .priority = 2});
    s.spheres.push_back({Sphere{{-0.3, 0.4, 0.9}, 0.5}, 4});
    o.max_depth = 6;
  });
  add("cuts", [](Scene& s, RenderOptions& o) {
    s.materials[1].absorption = {0.1, 0.4, 0.9};
    s.materials[2].cut_group = 5;
    s.cuts = {{.point = {0, 0, 0.6}, .normal = {0.3, 0.1, 1}, .eye_only = true},
              {.point = {0.9, 0, 0}, .normal = {1, 0.2, 0}},
              {.point = {0, 1.5, 0}, .normal = {0, 1, 0}, .caps = false, .group = 5}};
    s.ambient_occlusion.samples = 4;
    o.shadows = Shadows::transparent;
  });
  add("dispersion", [](Scene& s, RenderOptions& o) {
    s.materials[1].dispersion = {Dispersion::Kind::abbe, {20}};
    s.materials[1].fresnel = Fresnel::exact;
    o.wavelengths = 5;
    o.max_depth = 3;
  });
  add("cut", [](Scene& s, RenderOptions& o) {
    s.materials[1].fresnel = Fresnel::exact;
    s.materials[1].dispersion = {Dispersion::Kind::cauchy, {1.4, 0.02}};
    o.wavelengths = 6;
    o.min_contribution = 0.1;
    o.max_depth = 6;
  });
  add("occlusion", [](Scene& s, RenderOptions&) { s.ambient_occlusion.samples = 8; });
  add("occlusion and transparent", [](Scene& s, RenderOptions& o) {
    s.ambient_occlusion = {.samples = 4, .distance = 2, .color = {1, 0.9, 0.5}};
    o.shadows = Shadows::transparent;
  });
  add("sky", [](Scene& s, RenderOptions&) {
    s.sky.kind = Sky::Kind::gradient;
    s.sky.bottom = {0.9, 0.8, 0.7}, s.sky.top = {0.1, 0.2, 0.9};
  });
  add("lab, clamped", [](Scene& s, RenderOptions& o) {
    s.lights[0].color = {3, 3, 3};
    s.materials[1].absorption = {0.3, 0.2, 0.1};
    s.materials[1].ior = 0.667;
    o.profile = profile_of(ProfileName::lab);
  });
  add("textures", [](Scene& s, RenderOptions& o) {
    s.textures.emplace_back();
    s.textures[0].colors = {{0.9, 0.9, 0.9}, {0.2, 0.3, 0.1}};
    s.materials[0].textures = {{Coefficient::ambient, 0}, {Coefficient::diffuse, 0}};
    s.materials[1].textures = {{Coefficient::refraction, 0}};
    s.materials[1].fresnel = Fresnel::schlick;
    s.materials[1].absorption = {0.1, 0.4, 0.9};
    s.materials[1].dispersion = {Dispersion::Kind::abbe, {30}};
    s.lights.push_back(surface_light(LightKind::sphere, 2));
    o.wavelengths = 3;
    o.max_depth = 3;
    o.shadows = Shadows::transparent;
  });
  for (const NamedScene& named : test_scenes(24))
    add(named.name, [&](Scene& s, RenderOptions& o) {
      s = named.scene;
      o.min_contribution = 1e-3;
      o.shadows = Shadows::transparent;
      o.profile = profile_of(ProfileName::lab);
    });
  return all;
}

inline OpticsCase optics_case(const std::string& name) {
  for (OpticsCase& one : optics_cases())
    if (one.name == name) return std::move(one);
  ADD_FAILURE() << name;
  return {};
}

}  // namespace zraka
