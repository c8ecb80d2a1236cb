// SPDX-License-Identifier: Apache-2.0
// A scene as Embree and the shading read it.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>
#include <zraka/scene.hpp>

#include "shapes.hpp"

namespace zraka::embree {

/// Embree's numbers of the geometries, a kind of shape each.
enum Geometry : unsigned { kSpheres, kTriangles, kSmoothTriangles, kCones, kGeometries };

/// Columns of a material's row.
enum MaterialColumn {
  kAmbientIn = 0,  // ambient light times ka, three numbers
  kDiffuse = 3,
  kSpecular = 6,
  kShininess = 9,
  kReflection,
  kRefraction,
  kRatioIn,   // n1/n2 on entry
  kRatioOut,  // n1/n2 on the way out
  kMaterialColumns = 16
};

struct PointLight {
  Vec position, color;
};

/// How spheres are handed to Embree: as callbacks that hit sixteen rays at a time, which is faster
/// for packets, or as its own points, which is built faster and takes less memory.
enum class Spheres { callbacks, points };

/// An instruction set of Embree's, and how many rays it has in a packet.
struct Isa {
  const char* name;
  int packet;
};
/// Those that this Embree offers on this machine, the best last.
std::vector<Isa> offered_isas();

struct World {
  /// Fails (device is null) where Embree cannot start. The scene is given up before Embree builds.
  /// The instruction set is Embree's choice where none is named.
  World(Scene scene, Spheres spheres, const std::string& isa);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// What shapes and materials take here, and what Embree has taken beyond that, at most.
  std::uint64_t scene_bytes() const;
  std::uint64_t embree_bytes() const { return most_bytes; }

  /// How many rays Embree has in a packet: more are cut up.
  int packet() const;

  RTCDevice device;
  RTCScene embree;
  Vec eye, first, right, down;  ///< a ray through the corner (x, y): first + right·x + down·y
  std::uint32_t width, height;
  Vec background;
  std::vector<PointLight> lights;
  std::vector<float> materials;  ///< rows of kMaterialColumns
  /// The material of a primitive: material_of[first_of[geometry] + primitive].
  std::vector<int> material_of;
  int first_of[kGeometries] = {};
  std::vector<float> corner_normals;  ///< nine numbers a smooth triangle
  std::vector<Sphere4> spheres;
  std::vector<OpenCone> cones;
  bool coherence_pays;  ///< whether Embree is to be told which rays are coherent
  std::atomic<std::int64_t> bytes{0}, most_bytes{0};  ///< by Embree's own count
};

}  // namespace zraka::embree
