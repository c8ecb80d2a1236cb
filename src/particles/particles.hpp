// SPDX-License-Identifier: Apache-2.0
// Particles as files have them: atoms, grains, points of clouds. The list of their formats is in
// read_particles.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include <zraka/diagnostic.hpp>
#include <zraka/scene.hpp>

namespace zraka {

/// A parallelepiped that particles are in.
struct ParticleCell {
  Vec3 origin, a, b, c;
};

/// The half axes of an ellipsoid, and how it is turned: a unit quaternion.
struct ParticleShape {
  std::array<float, 3> radii;
  std::array<float, 4> turn;  ///< w, x, y, z
};

/// sRGB, times kColorUnit: up to 1 or up to 255 as the file has it, so that both have 8 bits.
using ParticleColor = std::array<std::uint16_t, 3>;
inline constexpr double kColorUnit = 257;
/// Whether it is one.
inline bool is_color(double value) {
  return value >= 0 && value <= 255;
}
inline std::uint16_t stored_color(double value) {
  return static_cast<std::uint16_t>(value * kColorUnit + 0.5);
}

/// One time step, one model of a file.
struct Particles {
  /// Centre and radius, 0 where the file says none. `material` is the index in `species`. They are
  /// a scene's spheres from the beginning, so that ten million of them need no second copy.
  std::vector<Object<Sphere>> spheres;
  std::vector<std::string> species;                 ///< "C", "type 1"
  std::vector<float> values;                        ///< of ParticleOptions::column
  std::vector<ParticleColor> colors;                ///< or none
  std::vector<ParticleShape> shapes;                ///< of those that are ellipsoids
  std::vector<std::array<std::uint32_t, 2>> bonds;  ///< that the file tells
  std::optional<ParticleCell> cell;
  bool in_angstrom = false;  ///< lengths are atoms', and species are elements
  bool has_more = false;     ///< other time steps or models follow
};

struct ParticleOptions {
  std::string column{};    ///< whose numbers become Particles::values; "" none
  std::int64_t frame = 1;  ///< which time step or model, from 1
};

/// The most particles of a file, and kinds of them.
inline constexpr std::uint64_t kMostParticles = std::uint64_t{1} << 31;
inline constexpr std::size_t kMostSpecies = 4096;
inline constexpr std::uint64_t kLargestParticleFile = std::uint64_t{1} << 36;

/// A format of particles.
struct ParticleFormat {
  const char* name;                         ///< for people
  std::array<std::string_view, 3> endings;  ///< of its files' names, in small letters
  bool (*is)(std::string_view beginning);   ///< whether the content tells it
  Result<Particles> (*parse)(std::string_view bytes, const std::string& name,
                             const ParticleOptions& options);
};

/// By the content, else by the name, of which an ending .gz or .zst does not count; nullptr if
/// neither tells.
const ParticleFormat* particle_format_of(std::string_view beginning, std::string_view name);
/// By the content alone.
const ParticleFormat* particle_format_of(std::string_view beginning);

/// In whatever format it is. Lines may end in LF, CRLF or CR.
Result<Particles> parse_particles(std::string_view bytes, const std::string& name,
                                  const ParticleOptions& options = {});
/// The same of a file, which may be packed by gzip or zstd.
Result<Particles> read_particles(const std::string& path, const ParticleOptions& options = {});

#define ZRAKA_DECLARE(format)                                                       \
  bool is_##format(std::string_view beginning);                                     \
  Result<Particles> parse_##format(std::string_view bytes, const std::string& name, \
                                   const ParticleOptions& options);
ZRAKA_DECLARE(xyz)
ZRAKA_DECLARE(pdb)
ZRAKA_DECLARE(mmcif)
ZRAKA_DECLARE(lammps)
ZRAKA_DECLARE(npy)
ZRAKA_DECLARE(npz)
ZRAKA_DECLARE(csv)
#undef ZRAKA_DECLARE

}  // namespace zraka
