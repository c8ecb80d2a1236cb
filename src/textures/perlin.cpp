// SPDX-License-Identifier: Apache-2.0
#include "textures/perlin.hpp"

#include <cmath>

#include "textures/turns.hpp"

namespace zraka {
namespace {

/// From the middle of a cube to the middles of its edges.
constexpr V3<double> kGradients[12] = {{1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0},
                                       {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
                                       {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}};

/// The end of SplitMix64 (Steele, Lea and Flood, 2014), which spreads every bit.
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// Of a corner.
const V3<double>& gradient(std::uint64_t hash) {
  return kGradients[(mixed(hash) >> 32) * 12 >> 32];
}
/// What it gives at a place that is so far from it.
double corner(std::uint64_t hash, const V3<double>& from) {
  return dot(gradient(hash), from);
}

/// 0 to 1, without slope and curvature at both ends.
double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

double between(double a, double b, double share) {
  return a + (b - a) * share;
}

/// Every whole number and the seed have a factor of their own; one step further adds it once more.
constexpr std::uint64_t kX = 0x9E3779B97F4A7C15u, kY = 0xD1B54A32D192ED03u,
                        kZ = 0xABC98388FB8FAC03u, kSeed = 0x8CB92BA72F3D8DD7u;

std::uint64_t hash_of(const double (&cell)[3], std::uint64_t seed) {
  const auto whole = [](double v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(v));
  };
  return whole(cell[0]) * kX + whole(cell[1]) * kY + whole(cell[2]) * kZ + (seed + 1) * kSeed;
}

constexpr double kFurthest = 0x1p50;  // where doubles still have a few bits behind the point

/// Places near each other, on the axes through their middle: they mostly lie in the cell of the
/// lattice where that is, of which the gradients of the corners are found once.
struct Together {
  static constexpr std::size_t kCount = Fractal::kMostTogether;
  double x[kCount], y[kCount], z[kCount];

  /// gradient_noise() of each.
  void noise(std::uint64_t seed, double (&values)[kCount]) const {
    // Of slopes, the first two are moved along x alone, the last two along z.
    const V3<double> middle{x[kCount - 1], y[0], z[0]};
    const double cell[3] = {std::floor(middle.x), std::floor(middle.y), std::floor(middle.z)};
    const bool near = std::fabs(middle.x) < kFurthest && std::fabs(middle.y) < kFurthest &&
                      std::fabs(middle.z) < kFurthest;
    if (near) noise_in(cell, seed, values);
    for (std::size_t i = 0; i < kCount; ++i)
      if (!near || !(x[i] >= cell[0] && x[i] < cell[0] + 1 && y[i] >= cell[1] &&
                     y[i] < cell[1] + 1 && z[i] >= cell[2] && z[i] < cell[2] + 1))
        values[i] = gradient_noise({x[i], y[i], z[i]}, seed);
  }

 private:
  /// Of those that lie in a cell; of the others anything.
  void noise_in(const double (&cell)[3], std::uint64_t seed, double (&values)[kCount]) const {
    const std::uint64_t h = hash_of(cell, seed);
    V3<double> g[8];
    for (std::size_t i = 0; i < 8; ++i)
      g[i] = gradient(h + (i & 1) * kX + (i >> 1 & 1) * kY + (i >> 2) * kZ);
    for (std::size_t i = 0; i < kCount; ++i) {  // as gradient_noise(); compilers make lanes of it
      const V3<double> a{x[i] - cell[0], y[i] - cell[1], z[i] - cell[2]};
      const V3<double> b{a.x - 1, a.y - 1, a.z - 1};
      const double u = fade(a.x), v = fade(a.y), w = fade(a.z);
      const auto corner = [](const V3<double>& slope, double cx, double cy, double cz) {
        return dot(slope, V3<double>{cx, cy, cz});
      };
      const double front = between(
          between(corner(g[0], a.x, a.y, a.z), corner(g[1], b.x, a.y, a.z), u),
          between(corner(g[2], a.x, b.y, a.z), corner(g[3], b.x, b.y, a.z), u), v);
      const double back = between(
          between(corner(g[4], a.x, a.y, b.z), corner(g[5], b.x, a.y, b.z), u),
          between(corner(g[6], a.x, b.y, b.z), corner(g[7], b.x, b.y, b.z), u), v);
      values[i] = between(front, back, w);
    }
  }
};

/// Moves an octave, so that not all of them are 0 at the same places, or along whole planes.
V3<double> moved(const V3<double>& p, double scale, int octave) {
  const double n = octave + 1;
  return V3<double>{p.x * scale + n * 0.8191725134, p.y * scale + n * 0.6710436067,
                    p.z * scale + n * 0.5497004779};
}

/// The mean of the absolute value of noise.
constexpr double kMeanSize = 0.22;

template <class Shape>
double sum(const Fractal& fractal, const V3<double>& p, double width, double mean, Shape shape) {
  double total = 0, squares = 0, height = 1, scale = 1;
  for (int octave = 0; octave < fractal.octaves; ++octave) {
    const double left = 1 - share_of_filtered(width * scale);
    double value = mean;
    if (left > 0) {
      const std::uint64_t seed = std::uint64_t{fractal.seed} << 8 | static_cast<unsigned>(octave);
      value += left * (shape(gradient_noise(moved(p, scale, octave), seed)) - mean);
    }
    total += height * value;
    squares += height * height;
    height /= 2;
    scale *= 2;
  }
  return total / std::sqrt(squares);
}

}  // namespace

double gradient_noise(const V3<double>& p, std::uint64_t seed) {
  if (!(std::fabs(p.x) < kFurthest && std::fabs(p.y) < kFurthest && std::fabs(p.z) < kFurthest))
    return 0;
  const double cell[3] = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const V3<double> a = {p.x - cell[0], p.y - cell[1], p.z - cell[2]};
  const V3<double> b = {a.x - 1, a.y - 1, a.z - 1};

  const std::uint64_t h = hash_of(cell, seed);
  const double u = fade(a.x), v = fade(a.y), w = fade(a.z);
  const double front =
      between(between(corner(h, a), corner(h + kX, {b.x, a.y, a.z}), u),
              between(corner(h + kY, {a.x, b.y, a.z}), corner(h + kX + kY, {b.x, b.y, a.z}), u), v);
  const double back =
      between(between(corner(h + kZ, {a.x, a.y, b.z}), corner(h + kX + kZ, {b.x, a.y, b.z}), u),
              between(corner(h + kY + kZ, {a.x, b.y, b.z}), corner(h + kX + kY + kZ, b), u), v);
  return between(front, back, w);
}

double Fractal::operator()(const V3<double>& p, double width) const {
  return sum(*this, p, width, 0, [](double noise) { return noise; });
}

void Fractal::at_each(const V3<double>* p, std::size_t count, double width, double* values) const {
  for (std::size_t i = 0; i < count; ++i) values[i] = 0;
  double squares = 0, height = 1, scale = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    const double left = 1 - share_of_filtered(width * scale);
    double noise[kMostTogether] = {};
    if (left > 0) {
      const std::uint64_t of_octave = std::uint64_t{seed} << 8 | static_cast<unsigned>(octave);
      Together together;
      for (std::size_t i = 0; i < kMostTogether; ++i) {
        const V3<double> at = moved(p[i < count ? i : 0], scale, octave);
        together.x[i] = at.x, together.y[i] = at.y, together.z[i] = at.z;
      }
      together.noise(of_octave, noise);
    }
    for (std::size_t i = 0; i < count; ++i)
      values[i] += height * (left > 0 ? 0 + left * (noise[i] - 0) : 0.0);
    squares += height * height;
    height /= 2;
    scale *= 2;
  }
  for (std::size_t i = 0; i < count; ++i) values[i] /= std::sqrt(squares);
}

double Fractal::turbulence(const V3<double>& p, double width) const {
  return sum(*this, p, width, kMeanSize, [](double noise) { return std::fabs(noise); });
}

double finest_grain(int octaves) {
  double grain = 1;
  for (int i = 1; i < octaves; ++i) grain /= 2;
  return grain;
}

}  // namespace zraka
