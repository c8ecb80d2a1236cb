// SPDX-License-Identifier: Apache-2.0
// Arrays of NumPy, and particles of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "particles/particles.hpp"

namespace zraka {

/// One number of each particle, wherever it lies in an array.
struct ArrayColumn {
  std::string name;
  const char* data = nullptr;
  std::size_t stride = 0;  ///< bytes from one particle's to the next one's
  char type = 'f';         ///< f, i, u or b as NumPy has it
  std::size_t size = 4;    ///< bytes of a number
  bool swapped = false;    ///< of the other order of bytes than this machine's
};

struct Array {
  std::size_t rows = 0;
  std::vector<ArrayColumn> columns;
};

/// The columns of the array of a .npy file, which go on pointing into `bytes`. Those of an array
/// with two dimensions get names by `name`: "positions" become x, y and z; "" by how many there
/// are. What is no array of numbers has no columns.
Result<Array> array_of(std::string_view bytes, const std::string& name, const std::string& file);

/// Particles of columns that all have so many rows.
Result<Particles> particles_of(const std::vector<ArrayColumn>& columns, std::size_t rows,
                               const std::string& file, const ParticleOptions& options);

}  // namespace zraka
