// SPDX-License-Identifier: Apache-2.0
// Atoms of files that have them one by one: PDB and mmCIF.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "particles/elements.hpp"
#include "particles/particles.hpp"

namespace zraka {

/// Adds atoms to particles, whose species become the symbols of elements.
class AtomList {
 public:
  explicit AtomList(Particles& particles) : particles_(particles) {}

  void add(std::string_view species, const Vec3& position) {
    particles_.spheres.push_back({{position, 0}, index_of(species)});
  }
  /// A number for whatever is no number, a new one for each: a column of chains, of residues.
  float number_of(std::string_view word) {
    return static_cast<float>(words_.try_emplace(std::string(word), words_.size()).first->second);
  }
  /// Whether an atom of this name may be added to the residue that was begun last: of alternate
  /// locations only the first may.
  bool is_first(std::string_view residue, std::string_view atom) {
    if (residue != residue_) {
      residue_ = residue;
      names_.clear();
    }
    if (std::find(names_.begin(), names_.end(), atom) != names_.end()) return false;
    names_.emplace_back(atom);
    return true;
  }

 private:
  std::uint32_t index_of(std::string_view species) {
    std::vector<std::string>& all = particles_.species;
    if (last_ < all.size() && all[last_] == species) return last_;
    const auto found = std::find(all.begin(), all.end(), species);
    last_ = static_cast<std::uint32_t>(found - all.begin());
    if (found == all.end()) all.emplace_back(species);
    return last_;
  }

  Particles& particles_;
  std::uint32_t last_ = 0;
  std::map<std::string, std::size_t> words_;
  std::string residue_;
  std::vector<std::string> names_;
};

/// The symbol of the element, or what is written there, at most so much of it that there are not
/// many.
inline std::string_view species_of(std::string_view symbol) {
  if (const Element* const element = element_of_symbol(symbol)) return element->symbol;
  if (const Element* const element = element_of_label(symbol)) return element->symbol;
  return "?";
}

/// Lengths and angles, in degrees, of a crystal's cell, a along x and b in the plane of x and y;
/// none where they are none.
std::optional<ParticleCell> cell_of(const std::array<double, 6>& lengths_and_angles);

}  // namespace zraka
