// SPDX-License-Identifier: Apache-2.0
// The list of formats of particles, and how a file finds its own.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/file.hpp"
#include "core/unpack.hpp"
#include "particles/particles.hpp"

namespace zraka {
namespace {

constexpr ParticleFormat kFormats[] = {
    {"PDB", {".pdb", ".ent"}, is_pdb, parse_pdb},
    {"mmCIF", {".cif", ".mmcif"}, is_mmcif, parse_mmcif},
    {"LAMMPS dump", {".lammpstrj", ".dump"}, is_lammps, parse_lammps},
    {"NumPy .npy", {".npy"}, is_npy, parse_npy},
    {"NumPy .npz", {".npz"}, is_npz, parse_npz},
    {"XYZ", {".xyz", ".extxyz"}, is_xyz, parse_xyz},
    {"CSV", {".csv", ".tsv"}, is_csv, parse_csv},
};

constexpr std::size_t kBeginning = std::size_t{1} << 16;

/// Whether lines end in CR alone, as they did on old Macs.
bool has_lone_returns(std::string_view beginning) {
  return beginning.find('\n') == std::string_view::npos &&
         beginning.find('\r') != std::string_view::npos;
}

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return small;
}

bool is_utf16(std::string_view text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

const ParticleFormat* by_content(std::string_view beginning) {
  for (const ParticleFormat& format : kFormats)
    if (format.is(beginning)) return &format;
  return nullptr;
}

}  // namespace

const ParticleFormat* particle_format_of(std::string_view beginning) {
  beginning = beginning.substr(0, kBeginning);
  if (!has_lone_returns(beginning)) return by_content(beginning);
  std::string lines(beginning);
  std::replace(lines.begin(), lines.end(), '\r', '\n');
  return by_content(lines);
}

const ParticleFormat* particle_format_of(std::string_view beginning, std::string_view name) {
  if (const ParticleFormat* const format = particle_format_of(beginning)) return format;
  std::string small = lower(name);
  for (const std::string_view packed : {".gz", ".zst"})
    if (small.ends_with(packed)) small.erase(small.size() - packed.size());
  for (const ParticleFormat& format : kFormats)
    for (const std::string_view ending : format.endings)
      if (!ending.empty() && small.ends_with(ending)) return &format;
  return nullptr;
}

Result<Particles> parse_particles(std::string_view bytes, const std::string& name,
                                  const ParticleOptions& options) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  const ParticleFormat* const format = particle_format_of(bytes, name);
  if (format != nullptr && is_utf16(bytes))
    return failure(name, "is text of UTF-16, of which nothing is read",
                   "save it as UTF-8, or as plain text");
  if (format == nullptr) {
    std::string names;
    for (const ParticleFormat& each : kFormats)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", each.name);
    return failure(name, "is of no format of particles that can be read",
                   fmt::format("formats: {}", names));
  }
  if (!has_lone_returns(bytes.substr(0, kBeginning))) return format->parse(bytes, name, options);
  std::string lines(bytes);
  std::replace(lines.begin(), lines.end(), '\r', '\n');
  return format->parse(lines, name, options);
}

Result<Particles> read_particles(const std::string& path, const ParticleOptions& options) {
  Result<std::string> bytes = read_file(path, kLargestParticleFile);
  if (bytes && is_packed(*bytes)) bytes = unpacked(*bytes, path);
  if (!bytes) return tl::make_unexpected(bytes.error());
  return parse_particles(*bytes, path, options);
}

}  // namespace zraka
