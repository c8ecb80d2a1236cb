// SPDX-License-Identifier: Apache-2.0
// Particles from a file: atoms, grains, points of a cloud.
#include <fmt/format.h>

#include <iterator>

#include "language/files.hpp"
#include "language/meshes.hpp"
#include "particles/look.hpp"

namespace zraka::language {
namespace {

struct ParticlesEntry {
  std::string file;
  ParticleLook look = ParticleLook::van_der_waals;
  double scale = 1;
  std::optional<double> radius;
  std::optional<std::string> color_by;
  ColorMap color_map = ColorMap::viridis;
  std::optional<std::array<double, 2>> range;
  bool solid = false;
  bool cell = false;
  std::int64_t frame = 1;
};

constexpr Choice kLooks[] = {
    {"van_der_waals", "spheres of the file's radii, else of the atoms'"},
    {"ball_and_stick", "spheres of a quarter of that, and cylinders for bonds"},
    {"sticks", "bonds alone, and spheres of their radius at the atoms"},
    {"points", "spheres that are all alike"},
};
constexpr Choice kColorMaps[] = {
    {"viridis", "from violet over green to yellow"},
    {"plasma", "from blue over red to yellow"},
    {"inferno", "from black over red to light yellow"},
    {"magma", "from black over purple to light pink"},
    {"coolwarm", "from blue over grey to red"},
    {"grey", "from black to white"},
};
static_assert(std::size(kLooks) == std::size(kParticleLookNames));
static_assert(std::size(kColorMaps) == std::size(kColorMapNames));

constexpr Field kParticlesFields[] = {
    field<&ParticlesEntry::file>(
        "file", {.text = "where they are read from", .unit = Unit::particles, .required = true}),
    field<&ParticlesEntry::look>("look", {.text = "what becomes of them", .choices = kLooks}),
    field<&ParticlesEntry::scale>(
        "scale",
        {.text = "a factor of all radii that are not said here", .range = greater_than(0)}),
    field<&ParticlesEntry::radius>(
        "radius", {.text = "of points all, of ball_and_stick and sticks the bonds'; where nothing "
                           "is said, half the mean spacing, 0.12 and 0.2",
                   .unit = Unit::length,
                   .range = greater_than(0)}),
    field<&ParticlesEntry::color_by>(
        "color_by", {.text = "element, or the column whose numbers become colours; where nothing "
                             "is said, the colours of the file, else by element or type; with a "
                             "material, none"}),
    field<&ParticlesEntry::color_map>(
        "color_map", {.text = "the colours of the numbers", .choices = kColorMaps}),
    field<&ParticlesEntry::range>(
        "range", {.text = "the numbers of its first and its last colour; where nothing is said, "
                          "the least and the most",
                  .fewest = 2,
                  .most = 2}),
    field<&ParticlesEntry::solid>(
        "solid", {.text = "whether bonds are closed at their ends, so that cuts have caps there"}),
    field<&ParticlesEntry::cell>("cell", {.text = "whether the edges of the file's box are drawn"}),
    field<&ParticlesEntry::frame>(
        "frame", {.text = "which time step or model, counted from 1", .range = at_least(1)}),
};

ParticleStyle style_of(const ParticlesEntry& entry, bool has_material) {
  ParticleStyle style;
  style.look = entry.look;
  style.scale = entry.scale;
  style.radius = entry.radius;
  style.color_by = entry.color_by.value_or("");
  style.color_map = entry.color_map;
  style.range = entry.range;
  style.solid = entry.solid;
  style.cell = entry.cell;
  style.one_material = has_material && !entry.color_by;
  return style;
}

/// Straight to where they go; what has a name or is moved is a group of its own, as meshes are.
void put(ParticlesEntry& entry, Item& item) {
  const toml::Node& file = *item.node.find("file");
  const std::optional<std::string> path = path_of(file, "particles", item.input);
  if (!path) return;
  const CommonEntry& common = common_of(item);
  const ParticleStyle style = style_of(entry, common.material.has_value());
  Result<Particles> particles =
      read_particles(*path, {has_column(style) ? style.color_by : "", entry.frame});
  if (!particles) return tell(particles.error(), file, "particles", item.input);

  Scene& scene = item.input.scene;
  const Material base =
      common.material ? scene.materials[common.material_index] : particle_material();
  const bool is_direct = common.place.shapes != nullptr && !common.transform && common.name.empty();
  Group group;
  Result<AddedParticles> added =
      add_particles(std::move(*particles), style, base, common.material_index, "", scene,
                    is_direct ? *common.place.shapes : group);
  if (!added) return tell(added.error(), file, "particles", item.input);
  if (added->legend) item.input.legends.push_back(std::move(*added->legend));
  for (const Diagnostic& note : added->notes)
    item.input.problems.warn(file.begin, fmt::format("file of particles: {}", note.message));
  if (is_direct) return;
  scene.groups.push_back(std::move(group));
  add_instance(static_cast<std::uint32_t>(scene.groups.size() - 1), item);
}

}  // namespace

constexpr Kind shape::particles = kind_of<ParticlesEntry, put>(
    "particles", "particles",
    "Atoms or other particles from a file: PDB, mmCIF, XYZ, a LAMMPS dump, CSV or NumPy's arrays.",
    kParticlesFields);

}  // namespace zraka::language
