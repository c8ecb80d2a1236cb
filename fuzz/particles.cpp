// SPDX-License-Identifier: Apache-2.0
// libFuzzer's target for the files of particles: any bytes are read or refused, and what is read can
// be drawn. The first byte tells which reader has them, or that the content does; of some files the
// look and a column come from it, too.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/unpack.hpp"
#include "particles/look.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace zraka;
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  constexpr Result<Particles> (*kReaders[])(std::string_view, const std::string&,
                                            const ParticleOptions&) = {
      parse_particles, parse_xyz, parse_pdb, parse_mmcif, parse_lammps, parse_npy, parse_npz,
      parse_csv};
  ParticleOptions options;
  if ((data[0] & 64) != 0) options.column = "x";
  if ((data[0] & 128) != 0) options.frame = 2;
  if (is_packed(bytes)) (void)unpacked(bytes, "fuzz");
  Result<Particles> particles = kReaders[data[0] % 8](bytes, "fuzz", options);
  if (!particles) return 0;
  const std::size_t count = particles->spheres.size();
  for (const Object<Sphere>& each : particles->spheres)
    if (each.material >= particles->species.size()) std::abort();
  if (!particles->values.empty() && particles->values.size() != count) std::abort();
  if (!particles->colors.empty() && particles->colors.size() != count) std::abort();
  for (const auto& [a, b] : particles->bonds)
    if (a >= count || b >= count) std::abort();
  ParticleStyle style;
  style.look = static_cast<ParticleLook>(data[0] >> 3 & 3);
  style.cell = (data[0] & 32) != 0;
  if (!particles->values.empty()) style.color_by = "x";
  Scene scene;
  if (!add_particles(std::move(*particles), style, Material{}, 0, "fuzz", scene, scene)) return 0;
  for (const Object<Sphere>& each : scene.spheres)
    if (each.material >= scene.materials.size() || !(each.shape.radius > 0)) std::abort();
  return 0;
}
