// SPDX-License-Identifier: Apache-2.0
// Images in smaller and smaller sizes, looked up for a register of hits at a time: filtered() of
// textures/image.cpp, operation by operation, so that the bits are the same. Where to look is found
// in lanes; texels lie anywhere and are mixed hit by hit.
#pragma once

#include "math/double_lanes.hpp"
#include "math/elementary_power.hpp"
#include "textures/prepared_texture.hpp"

namespace zraka::ZRAKA_ISA {

#if defined(ZRAKA_WIDE) && HWY_MAX_BYTES >= 32
/// A colour in one register; its fourth number counts for nothing.
struct Texel {
  using Four = hn::FixedTag<double, 4>;
  hn::Vec<Four> v;
  static ZRAKA_INLINE Texel black() { return {hn::Zero(Four())}; }
  static ZRAKA_INLINE Texel at(const float* t) {
    const hn::FixedTag<float, 4> floats;
    return {hn::PromoteTo(Four(), hn::MaskedLoad(hn::FirstN(floats, 3), floats, t))};
  }
  ZRAKA_INLINE V3<double> color() const {
    alignas(32) double numbers[4];
    hn::Store(v, Four(), numbers);
    return {numbers[0], numbers[1], numbers[2]};
  }
};
ZRAKA_INLINE Texel operator+(Texel a, Texel b) {
  return {hn::Add(a.v, b.v)};
}
ZRAKA_INLINE Texel operator*(Texel a, double s) {
  return {hn::Mul(a.v, hn::Set(Texel::Four(), s))};
}
#else
struct Texel {
  __extension__ typedef double Two __attribute__((vector_size(16)));
  Two rg;
  double b;
  static ZRAKA_INLINE Texel black() { return {Two{0, 0}, 0}; }
  static ZRAKA_INLINE Texel at(const float* t) { return {Two{t[0], t[1]}, t[2]}; }
  ZRAKA_INLINE V3<double> color() const { return {rg[0], rg[1], b}; }
};
ZRAKA_INLINE Texel operator+(Texel x, Texel y) {
  return {x.rg + y.rg, x.b + y.b};
}
ZRAKA_INLINE Texel operator*(Texel x, double s) {
  return {x.rg * Texel::Two{s, s}, x.b * s};
}
#endif

/// TexturePlace of an image: a point and the two half axes of a footprint.
template <class F>
struct ImagePlace {
  F u, v;
  F au, av, bu, bv;
};

/// Of filtered(): how far apart probes are, from which levels, and how many.
template <class F>
struct MipFootprint {
  F along_u, along_v;  ///< from the first end of the longer axis to the other
  F level, probes;
};

template <class F>
ZRAKA_INLINE MipFootprint<F> footprint_on(const PreparedTexture& t, const ImagePlace<F>& at) {
  constexpr double kMostProbes = 16, kPerLn2 = 1.4426950408889634;
  const F columns(t.levels[0].columns), rows(t.levels[0].rows);
  // ellipse() of image.cpp.
  const F ax = at.au * columns, ay = at.av * rows, bx = at.bu * columns, by = at.bv * rows;
  const F xx = ax * ax + bx * bx, yy = ay * ay + by * by, xy = ax * ay + bx * by;
  const F half = (xx - yy) * F(0.5), root = sqrt(half * half + xy * xy);
  const F long_axis = sqrt((xx + yy) * F(0.5) + root);
  const auto any_size = long_axis > F(0.0);
  const auto upwards = half >= F(0.0);
  F x = select(upwards, half + root, xy);
  const F y = select(upwards, xy, root - half);
  x = select(both(x == F(0.0), y == F(0.0)), F(1.0), x);
  const F size = select(any_size, long_axis, F(1.0));
  const F scale = size / sqrt(x * x + y * y);
  const auto if_any = [&](F value) { return select(any_size, value, F(0.0)); };
  const F wide = if_any(F(2.0) * size);
  const F narrow = if_any(F(2.0) * abs(ax * by - ay * bx) / size);
  const F half_u = if_any(x * scale), half_v = if_any(y * scale);

  const F width = max(max(narrow, wide * F(1 / kMostProbes)), F(1.0));
  const F probes = min(max(F(0.0) - floor(F(0.0) - wide / width), F(1.0)), F(kMostProbes));
  MipFootprint<F> found{F(2.0) * half_u / columns, F(2.0) * half_v / rows, F(0.0), probes};
  if (const auto smaller = width > F(1.0); any(smaller)) {
    const F level = pair_log(width).high * F(kPerLn2);
    const F last(static_cast<double>(t.levels.size() - 1));
    found.level = select(smaller, min(level, last), F(0.0));
  }
  return found;
}

/// folded() of image.cpp.
template <class F>
ZRAKA_INLINE F folded_in(F x, TextureWrap wrap) {
  if (wrap == TextureWrap::repeat) return x - floor(x);
  if (wrap == TextureWrap::clamp) return min(max(x, F(0.0)), F(1.0));
  x = x - F(2.0) * floor(x * F(0.5));
  return select(x > F(1.0), F(2.0) - x, x);
}

/// The levels that a register of hits looks at, each its own, and where in them: between_four() of
/// image.cpp.
template <class D>
class LevelLanes {
 public:
  using F = typename D::F;
  ZRAKA_INLINE LevelLanes(const PreparedTexture& t, F level, TextureWrap wrap_v)
      : wrap_u_(t.wrap), wrap_v_(wrap_v) {
    alignas(64) double number[D::kWidth];
    D::store(level, number);
    for (std::size_t k = 0; k < D::kWidth; ++k) {
      const ImageLevel& its = t.levels[static_cast<std::size_t>(number[k])];
      pixels_[k] = its.pixels;
      columns_[k] = its.columns, rows_[k] = its.rows;
    }
  }

  ZRAKA_INLINE void aim(F u, F v) {
    const F columns = D::load(columns_), rows = D::load(rows_);
    const F x = u * columns - F(0.5), y = v * rows - F(0.5);
    const F i = floor(x), j = floor(y), right = x - i, above = y - j;
    const F stride = F(3.0) * columns, top = rows - F(1.0);
    const F left_at = F(3.0) * before(i, columns, wrap_u_);
    const F right_at = F(3.0) * after(i + F(1.0), columns, wrap_u_);
    const F lower_at = stride * (top - before(j, rows, wrap_v_));
    const F upper_at = stride * (top - after(j + F(1.0), rows, wrap_v_));
    D::store(lower_at + left_at, at_[0]), D::store(lower_at + right_at, at_[1]);
    D::store(upper_at + left_at, at_[2]), D::store(upper_at + right_at, at_[3]);
    D::store(F(1.0) - right, left_), D::store(right, right_);
    D::store(F(1.0) - above, below_), D::store(above, above_);
  }

  /// Of lane k, where aim() was last.
  ZRAKA_INLINE Texel mixed(std::size_t k) const {
    const auto at = [&](int i) {
      return Texel::at(pixels_[k] + static_cast<std::ptrdiff_t>(at_[i][k]));
    };
    const Texel low = at(0) * left_[k] + at(1) * right_[k];
    const Texel high = at(2) * left_[k] + at(3) * right_[k];
    return low * below_[k] + high * above_[k];
  }

 private:
  /// neighbor() of image.cpp, of what may be -1, and of what may be as many as there are.
  static ZRAKA_INLINE F before(F i, F count, TextureWrap wrap) {
    return select(i < F(0.0), wrap == TextureWrap::repeat ? count - F(1.0) : F(0.0), i);
  }
  static ZRAKA_INLINE F after(F i, F count, TextureWrap wrap) {
    return select(i >= count, wrap == TextureWrap::repeat ? F(0.0) : count - F(1.0), i);
  }

  TextureWrap wrap_u_, wrap_v_;
  const float* pixels_[D::kWidth];
  alignas(64) double columns_[D::kWidth], rows_[D::kWidth];
  alignas(64) double at_[4][D::kWidth] = {};  ///< floats from the level's first on
  alignas(64) double left_[D::kWidth] = {}, right_[D::kWidth] = {};
  alignas(64) double below_[D::kWidth] = {}, above_[D::kWidth] = {};
};

/// What an image with smaller sizes gives at the first `count` places. `wrap_v`: a sphere's poles
/// lie beside nothing.
template <class D, class Put>
ZRAKA_INLINE void look_up_mips(const PreparedTexture& t, const ImagePlace<typename D::F>& at,
                               TextureWrap wrap_v, std::size_t count, const Put& put_value) {
  using F = typename D::F;
  const MipFootprint<F> seen = footprint_on(t, at);
  const F fine = floor(seen.level), coarser = seen.level - fine;
  const auto between = coarser > F(0.0);
  const bool any_between = any(between);
  LevelLanes<D> sheet(t, fine, wrap_v);
  LevelLanes<D> coarse(t, select(between, fine + F(1.0), fine), wrap_v);
  alignas(64) double probes[D::kWidth], share_of_coarse[D::kWidth], share_of_fine[D::kWidth];
  D::store(seen.probes, probes);
  D::store(coarser, share_of_coarse);
  D::store(F(1.0) - coarser, share_of_fine);
  double most = 1;
  for (std::size_t k = 0; k < count; ++k) most = most < probes[k] ? probes[k] : most;
  Texel sums[D::kWidth];
  for (Texel& sum : sums) sum = Texel::black();
  for (double i = 0.5; i < most; ++i) {
    const F share = F(i) / seen.probes - F(0.5);
    const F u = folded_in(at.u + share * seen.along_u, t.wrap);
    const F v = folded_in(at.v + share * seen.along_v, wrap_v);
    sheet.aim(u, v);
    if (any_between) coarse.aim(u, v);
    for (std::size_t k = 0; k < count; ++k) {
      if (i > probes[k]) continue;
      Texel probe = sheet.mixed(k);
      if (share_of_coarse[k] > 0)
        probe = probe * share_of_fine[k] + coarse.mixed(k) * share_of_coarse[k];
      sums[k] = sums[k] + probe;
    }
  }
  for (std::size_t k = 0; k < count; ++k) put_value(k, (sums[k] * (1 / probes[k])).color());
}

}  // namespace zraka::ZRAKA_ISA
