// SPDX-License-Identifier: Apache-2.0
#include "particles/look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/in_parallel.hpp"
#include "math/bounds.hpp"
#include "particles/bonds.hpp"
#include "particles/coloring.hpp"
#include "particles/elements.hpp"

namespace zraka {
namespace {

/// Of balls, as a part of the van der Waals radius; of bonds between them and of sticks alone, in
/// ångström.
constexpr double kBall = 0.25, kBond = 0.12, kStick = 0.2;

const Element* element_of(const std::string& species, bool in_angstrom) {
  const Element* const element = element_of_symbol(species);
  return element != nullptr || !in_angstrom ? element : element_of_label(species);
}

Bounds bounds_of_centers(const std::vector<Object<Sphere>>& spheres) {
  Bounds all;
  std::mutex joining;
  in_parallel(spheres.size(), [&](std::size_t begin, std::size_t end) {
    Bounds part;
    for (std::size_t i = begin; i != end; ++i)
      part.include({spheres[i].shape.center, spheres[i].shape.center});
    const std::lock_guard lock(joining);
    all.include(part);
  });
  return all;
}

/// Half of what would be between neighbours if all stood on a grid: the radius of what has none.
double spacing_radius(const std::vector<Object<Sphere>>& spheres) {
  const Bounds box = bounds_of_centers(spheres);
  const double sides[] = {box.upper.x - box.lower.x, box.upper.y - box.lower.y,
                          box.upper.z - box.lower.z};
  const double longest = *std::max_element(std::begin(sides), std::end(sides));
  if (!(longest > 0)) return 1;
  double logarithms = 0;
  int dimensions = 0;
  for (const double side : sides)
    if (side > 1e-4 * longest) {
      logarithms += std::log(side);
      ++dimensions;
    }
  const double count = static_cast<double>(spheres.size());
  return std::exp((logarithms - std::log(count)) / dimensions) / 2;
}

class Drawing {
 public:
  Drawing(Particles&& particles, const ParticleStyle& style, const std::string& name)
      : particles_(std::move(particles)), style_(style), name_(name) {}

  Result<AddedParticles> add_to(const Material& base, std::uint32_t base_index, Scene& scene,
                                ShapeLists& shapes) {
    AddedParticles added;
    const Result<MaterialOf> materials =
        color_particles(particles_, style_, base, base_index, name_, scene, added.legend);
    if (!materials) return tl::make_unexpected(materials.error());
    if (has_sticks()) find_bonds_of_atoms();
    set_spheres(*materials);
    add_bonds(shapes);
    if (style_.cell) add_cell(scene, shapes, base);
    if (particles_.shapes.empty() || style_.look != ParticleLook::van_der_waals)
      add_spheres(shapes);
    else
      add_ellipsoids(scene, shapes);
    added.notes = std::move(notes_);
    return added;
  }

 private:
  bool has_sticks() const {
    return style_.look == ParticleLook::ball_and_stick || style_.look == ParticleLook::sticks;
  }
  double stick_radius() const {
    if (style_.radius) return *style_.radius;
    return (style_.look == ParticleLook::sticks ? kStick : kBond) * style_.scale;
  }

  void note(std::string message) {
    notes_.push_back({.severity = Severity::note, .file = name_, .message = std::move(message)});
  }

  void find_bonds_of_atoms() {
    std::vector<float> covalent;
    for (const std::string& species : particles_.species) {
      const Element* const element = element_of(species, particles_.in_angstrom);
      covalent.push_back(element != nullptr ? element->covalent : 0);
    }
    auto found = find_bonds(particles_.spheres, covalent);
    if (!found)
      note("its atoms are too dense to be ones of matter: no bonds are drawn");
    else
      bonds_ = std::move(*found);
    if (!particles_.bonds.empty()) {  // others than those
      bonds_.insert(bonds_.end(), particles_.bonds.begin(), particles_.bonds.end());
      std::sort(bonds_.begin(), bonds_.end());
      bonds_.erase(std::unique(bonds_.begin(), bonds_.end()), bonds_.end());
    }
    if (found && bonds_.empty() && particles_.spheres.size() > 1)
      note("none of its particles are atoms near enough to be bonded");
  }

  /// Radii, and materials in the place of species.
  void set_spheres(const MaterialOf& material_of) {
    std::vector<double> radii;
    for (const std::string& species : particles_.species) {
      const Element* const element = element_of(species, particles_.in_angstrom);
      radii.push_back(element != nullptr ? static_cast<double>(element->van_der_waals) : 0);
    }
    const bool all_known = std::all_of(radii.begin(), radii.end(), [](double r) { return r > 0; });
    if (!all_known || style_.look == ParticleLook::points) {
      const double spacing = spacing_radius(particles_.spheres);
      for (double& radius : radii)
        if (!(radius > 0) || style_.look == ParticleLook::points) radius = spacing;
    }
    const double scale = style_.scale * (style_.look == ParticleLook::ball_and_stick ? kBall : 1);
    in_parallel(particles_.spheres.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i) {
        auto& [sphere, material, transform] = particles_.spheres[i];
        const double own = sphere.radius > 0 ? sphere.radius : radii[material];
        sphere.radius = radius_of(own * scale);
        material = material_of(i, material);
      }
    });
  }
  double radius_of(double usual) const {
    if (style_.look == ParticleLook::sticks) return stick_radius();
    if (style_.look == ParticleLook::points && style_.radius) return *style_.radius;
    return usual;
  }

  /// Each in two halves, of the colours of its ends.
  void add_bonds(ShapeLists& shapes) {
    const double radius = stick_radius();
    const auto add = [&](const Vec3& from, const Vec3& to, std::uint32_t material) {
      if (style_.solid)
        shapes.frustums.push_back({{from, radius, to, radius, true}, material});
      else
        shapes.cones.push_back({{from, radius, to, radius}, material});
    };
    if (!style_.solid) shapes.cones.reserve(shapes.cones.size() + 2 * bonds_.size());
    for (const auto& [first, second] : bonds_) {
      const auto &a = particles_.spheres[first], &b = particles_.spheres[second];
      const Vec3 &p = a.shape.center, &q = b.shape.center;
      if (p == q) continue;
      const Vec3 middle{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
      if (a.material == b.material) {
        add(p, q, a.material);
        continue;
      }
      add(p, middle, a.material);
      add(middle, q, b.material);
    }
  }

  /// Edges as thin rods with balls at the corners, in the material given.
  void add_cell(Scene& scene, ShapeLists& shapes, const Material& base) {
    if (!particles_.cell) return note("it has no cell that could be drawn");
    const auto& [origin, a, b, c] = *particles_.cell;
    const Vec3* const edges[] = {&a, &b, &c};
    const auto corner = [&](unsigned bits) {
      Vec3 p = origin;
      for (unsigned i = 0; i < 3; ++i)
        if (bits >> i & 1) p = {p.x + edges[i]->x, p.y + edges[i]->y, p.z + edges[i]->z};
      return p;
    };
    double longest = 0;
    for (const Vec3* const edge : edges)
      longest = std::max(longest, std::hypot(edge->x, edge->y, edge->z));
    const double radius = longest / 400;
    if (!(radius > 0)) return;
    Material grey = base;
    grey.ambient = grey.diffuse = linear_color(0xC0C0C0);
    const auto material = static_cast<std::uint32_t>(scene.materials.size());
    scene.materials.push_back(std::move(grey));
    for (unsigned from = 0; from < 8; ++from) {
      particles_.spheres.push_back({{corner(from), radius}, material});
      for (unsigned i = 0; i < 3; ++i)
        if ((from >> i & 1) == 0 && !(corner(from) == corner(from | 1u << i)))
          shapes.cones.push_back(
              {{corner(from), radius, corner(from | 1u << i), radius}, material});
    }
  }

  void add_spheres(ShapeLists& shapes) {
    if (shapes.spheres.empty()) {
      shapes.spheres = std::move(particles_.spheres);
      return;
    }
    shapes.spheres.insert(shapes.spheres.end(), particles_.spheres.begin(),
                          particles_.spheres.end());
  }

  /// What has no extent along some axis stays a sphere.
  void add_ellipsoids(Scene& scene, ShapeLists& shapes) {
    for (std::size_t i = 0; i < particles_.spheres.size(); ++i) {
      const Object<Sphere>& sphere = particles_.spheres[i];
      if (i >= particles_.shapes.size()) {  // of the cell
        shapes.spheres.push_back(sphere);
        continue;
      }
      const auto& [radii, turn] = particles_.shapes[i];
      const auto number = [](float value) { return static_cast<double>(value); };
      const Vec3 axes{number(radii[0]) * style_.scale, number(radii[1]) * style_.scale,
                      number(radii[2]) * style_.scale};
      if (!(axes.x > 0 && axes.y > 0 && axes.z > 0)) {
        shapes.spheres.push_back(sphere);
        continue;
      }
      scene.transforms.push_back(
          turned(number(turn[0]), number(turn[1]), number(turn[2]), number(turn[3])));
      scene.transforms.back().origin = sphere.shape.center;
      shapes.ellipsoids.push_back(
          {{{}, axes}, sphere.material, static_cast<std::uint32_t>(scene.transforms.size())});
    }
  }

  /// The rotation of a quaternion, which need not be a unit one; none of 0.
  static Transform turned(double w, double x, double y, double z) {
    const double square = w * w + x * x + y * y + z * z;
    if (!(square > 0)) return {};
    const double s = 2 / square;
    return {{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
            {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
            {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)},
            {}};
  }

  Particles particles_;
  const ParticleStyle& style_;
  const std::string& name_;
  std::vector<std::array<std::uint32_t, 2>> bonds_;
  Diagnostics notes_;
};

}  // namespace

Material particle_material() {
  Material material;
  material.specular = {0.2, 0.2, 0.2};
  material.shininess = 40;
  return material;
}

Result<AddedParticles> add_particles(Particles&& particles, const ParticleStyle& style,
                                     const Material& base, std::uint32_t base_index,
                                     const std::string& name, Scene& scene, ShapeLists& shapes) {
  return Drawing(std::move(particles), style, name).add_to(base, base_index, scene, shapes);
}

}  // namespace zraka
