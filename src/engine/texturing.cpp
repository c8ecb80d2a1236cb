// SPDX-License-Identifier: Apache-2.0
// Textures of many hits that lie in space: engine/coefficients.cpp and textures/ in lanes of doubles, operation
// by operation, so that the bits are the same. CMake compiles this file once for each instruction
// set, like engine/kernel.cpp.
#include "engine/texturing.hpp"

#include "engine/coefficients.hpp"
#include "engine/indices.hpp"
#include "engine/mip_lanes.hpp"
#include "math/double_lanes.hpp"
#include "math/vec.hpp"

namespace zraka::ZRAKA_ISA {
namespace {

constexpr double kPointError = 0x1p-23;  ///< kEpsilon of coefficients.cpp

/// Numbers of as many hits as a register of the engine's holds.
template <class L>
struct OfHits {
  using R = typename L::Real;
  using D = DoublesOf<L>;
  alignas(64) R of[L::kWidth];
  ZRAKA_INLINE OfHits(const Indices<L>& at, const R* array) { L::store(at.load(array), of); }
  ZRAKA_INLINE typename D::F operator()(std::size_t i) const { return D::load_reals(of + i); }
};
template <class L>
struct ThreeOfHits {
  OfHits<L> x, y, z;
  ZRAKA_INLINE V3<typename DoublesOf<L>::F> operator()(std::size_t i) const {
    return {x(i), y(i), z(i)};
  }
};

template <class F>
ZRAKA_INLINE V3<F> in_all_lanes(const V3<double>& v) {
  return {F(v.x), F(v.y), F(v.z)};
}

/// turned() and moved() of scene/bounds_of.hpp.
template <class F>
ZRAKA_INLINE V3<F> turned_by(const Transform& t, const V3<F>& v) {
  const Vec3 &x = t.along_x, &y = t.along_y, &z = t.along_z;
  return {F(x.x) * v.x + F(y.x) * v.y + F(z.x) * v.z, F(x.y) * v.x + F(y.y) * v.y + F(z.y) * v.z,
          F(x.z) * v.x + F(y.z) * v.y + F(z.z) * v.z};
}
template <class F>
ZRAKA_INLINE V3<F> moved_by(const Transform& t, const V3<F>& v) {
  return turned_by(t, v) + V3<F>{F(t.origin.x), F(t.origin.y), F(t.origin.z)};
}

template <class F>
ZRAKA_INLINE F length_of(const V3<F>& v) {
  return sqrt(dot(v, v));
}

/// std::fmax(): what is no number does not count.
template <class F>
ZRAKA_INLINE F greater_of(F a, F b) {
  const F greater = select(a > b, a, b);
  return select(b == b, greater, a);
}
template <class F>
ZRAKA_INLINE F largest_of(const V3<F>& v) {
  return greater_of(abs(v.x), greater_of(abs(v.y), abs(v.z)));
}

/// TexturePoint and TexturePlace of textures in space.
template <class F>
struct SolidPlace {
  V3<F> point, axes[2];
  F error;
};

/// One register of hits: find_footprint() and find_unit() of coefficients.cpp.
template <class F>
ZRAKA_INLINE SolidPlace<F> place_in_shape(const Transform& to_shape, const V3<F>& point,
                                          const V3<F>& any_normal, const V3<F>& view, F width) {
  const V3<F> normal = any_normal * (F(1.0) / length_of(any_normal));
  const F cosine = dot(view, normal);
  const F facing = select(abs(cosine) > F(1e-6), abs(cosine), F(1e-6));
  const V3<F> slide = view - normal * cosine;
  const F slope = length_of(slide);
  V3<F> major = slide * (F(1.0) / slope);
  if (const auto slides = slope > F(1e-9); !all(slides)) {
    const V3<F> aside = cross(normal, V3<F>{F(1.0), F(0.0), F(0.0)});
    major = {select(slides, major.x, aside.x), select(slides, major.y, aside.y),
             select(slides, major.z, aside.z)};
  }
  if (const auto is_long = dot(major, major) > F(0.5); !all(is_long)) {
    const V3<F> aside = cross(normal, V3<F>{F(0.0), F(1.0), F(0.0)});
    major = {select(is_long, major.x, aside.x), select(is_long, major.y, aside.y),
             select(is_long, major.z, aside.z)};
  }
  const V3<F> minor = cross(normal, major);
  const F half = abs(width) * F(0.5);

  SolidPlace<F> place;
  place.point = moved_by(to_shape, point);
  place.axes[0] = turned_by(to_shape, major * (half / facing));
  place.axes[1] = turned_by(to_shape, minor * half);
  const F unit = F(1.0) / length_of(turned_by(to_shape, normal));
  place.error = (largest_of(point) + F(0x1p-10)) * F(kPointError) / unit +
                largest_of(place.point) * F(0x1p-50);
  return place;
}

template <class F>
ZRAKA_INLINE V3<F> within_huge(const V3<F>& v, double else_) {
  const auto within = [&](F x) { return select(abs(x) < F(kHugeNumber), x, F(else_)); };
  return {within(v.x), within(v.y), within(v.z)};
}

/// find_place() of texture_set.cpp; axes and error only where they count.
template <class F>
ZRAKA_INLINE SolidPlace<F> place_in_texture(const PreparedTexture& t, const SolidPlace<F>& at) {
  const V3<F> x = in_all_lanes<F>(t.into.x), y = in_all_lanes<F>(t.into.y),
              z = in_all_lanes<F>(t.into.z);
  const auto direction = [&](const V3<F>& d) { return V3<F>{dot(x, d), dot(y, d), dot(z, d)}; };
  SolidPlace<F> place;
  place.point = within_huge(direction(at.point) + in_all_lanes<F>(t.into.origin), 0);
  if (!t.sees_footprint) return place;
  place.axes[0] = within_huge(direction(at.axes[0]), kHugeNumber);
  place.axes[1] = within_huge(direction(at.axes[1]), kHugeNumber);
  place.error = at.error * F(t.error_scale);
  return place;
}

/// x in sizes of a texture. By a power of two a product is rounded as the quotient.
template <class F>
ZRAKA_INLINE F in_sizes(const PreparedTexture& t, F x) {
  return t.per_size != 0 ? x * F(t.per_size) : x / F(t.size);
}

/// tolerance() of prepared_texture.cpp.
template <class F>
ZRAKA_INLINE F tolerance_at(const PreparedTexture& t, F error) {
  const F cells = in_sizes(t, error);
  return select(cells > F(kLeastTolerance), min(cells, F(kMostTolerance)), F(kLeastTolerance));
}

/// Of turns.cpp.
template <class F>
ZRAKA_INLINE F triangle_of(F x) {
  return F(1.0) - abs(x - F(2.0) * floor(x * F(0.5)) - F(1.0));
}
template <class F>
ZRAKA_INLINE F sign_of_turn(F x, F width, F tolerance) {
  const F cell = floor(x + tolerance);
  const F sharp = select(cell - F(2.0) * floor(cell * F(0.5)) == F(0.0), F(1.0), F(-1.0));
  const F t = min(max(F(2.0) * width - F(1.0), F(0.0)), F(1.0));
  const F share = t * t * (F(3.0) - F(2.0) * t);
  const auto is_sharp = share == F(0.0);
  if (all(is_sharp)) return sharp;
  const F in_two = x - F(2.0) * floor(x * F(0.5)), half = width * F(0.5);
  const F mean = (triangle_of(in_two + half) - triangle_of(in_two - half)) / width;
  return select(is_sharp, sharp, sharp * (F(1.0) - share) + mean * share);
}

/// checker_value() of checker.cpp.
template <class F>
ZRAKA_INLINE V3<F> checker_at(const PreparedTexture& t, const SolidPlace<F>& at) {
  const F below = tolerance_at(t, at.error);
  const auto sign = [&](F p, F a, F b) {
    return sign_of_turn(in_sizes(t, p), in_sizes(t, F(2.0) * sqrt(a * a + b * b)), below);
  };
  const F product = sign(at.point.x, at.axes[0].x, at.axes[1].x) *
                    sign(at.point.y, at.axes[0].y, at.axes[1].y) *
                    sign(at.point.z, at.axes[0].z, at.axes[1].z);
  const F first = F(0.5) + F(0.5) * product;
  return in_all_lanes<F>(t.first_colors[0]) * first +
         in_all_lanes<F>(t.first_colors[1]) * (F(1.0) - first);
}

/// A V3 of each of as many hits as a register of doubles holds.
template <class D>
struct InLanes {
  alignas(64) double x[D::kWidth], y[D::kWidth], z[D::kWidth];
  ZRAKA_INLINE void store(const V3<typename D::F>& v) {
    D::store(v.x, x);
    D::store(v.y, y);
    D::store(v.z, z);
  }
  ZRAKA_INLINE V3<double> operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
};

template <class D>
ZRAKA_INLINE void color_by_mips(const PreparedTexture& t, const SolidPlace<typename D::F>& at,
                                std::size_t count, InLanes<D>& values) {
  look_up_mips<D>(t, {at.point.x, at.point.y, at.axes[0].x, at.axes[0].y, at.axes[1].x, at.axes[1].y},
                  t.wrap, count, [&](std::size_t k, const V3<double>& value) {
                    values.x[k] = value.x, values.y[k] = value.y, values.z[k] = value.z;
                  });
}

/// TextureLookup of as many hits as a register of doubles holds, for kinds that have no lanes.
template <class D>
class Lookups {
 public:
  using F = typename D::F;
  /// The next ones, of which nothing is known.
  ZRAKA_INLINE void start() { placed_ = PreparedTexture::kNone; }

  /// Of the first `count` lanes.
  ZRAKA_INLINE void find(const PreparedTexture& t, const SolidPlace<F>& in_shape, F distance,
                         std::size_t count, InLanes<D>& values) {
    if (placed_ != t.placed_like) {
      placed_ = t.placed_like, sampled_ = PreparedTexture::kNone;
      find_places(t, in_shape, distance, count);
    }
    const bool by_taps = t.sampled_like != PreparedTexture::kNone;
    const bool fresh = by_taps && sampled_ != t.sampled_like;
    if (by_taps) sampled_ = t.sampled_like;
    for (std::size_t i = 0; i < count; ++i) {
      if (fresh) find_taps(t, place_[i], taps_[i]);
      const TextureValue value = by_taps ? value_of_taps(t, taps_[i]) : value_at(t, place_[i]);
      values.x[i] = value.x, values.y[i] = value.y, values.z[i] = value.z;
    }
  }

 private:
  ZRAKA_INLINE void find_places(const PreparedTexture& t, const SolidPlace<F>& in_shape,
                                F along_rays, std::size_t count) {
    const SolidPlace<F> at = place_in_texture(t, in_shape);
    InLanes<D> point, axes[2]{};
    alignas(64) double error[D::kWidth] = {}, distance[D::kWidth];
    point.store(at.point);
    D::store(along_rays, distance);
    if (t.sees_footprint) {
      axes[0].store(at.axes[0]);
      axes[1].store(at.axes[1]);
      D::store(at.error, error);
    }
    const bool rolled = t.mapping != TextureMapping::solid;
    for (std::size_t i = 0; i < count; ++i) {
      TexturePlace& place = place_[i];
      place.point = point[i];
      place.distance = distance[i];
      if (t.sees_footprint) {
        place.axes[0] = axes[0][i], place.axes[1] = axes[1][i];
        place.error = error[i];
      }
      place.away = 1;
      if (rolled) roll(t, place);
    }
  }

  std::uint32_t placed_ = PreparedTexture::kNone, sampled_ = PreparedTexture::kNone;
  TexturePlace place_[D::kWidth];
  ImageTaps taps_[D::kWidth];
};

}  // namespace

template <class L>
void color_hits(const HitsOfMaterial& hits, const Level<typename L::Real>& level,
                Scratch<typename L::Real>& scratch) {
  using I = typename L::I;
  using D = DoublesOf<L>;
  using F = typename D::F;
  const auto begin = static_cast<std::size_t>(level.done);
  const V3<F> none{F(0.0), F(0.0), F(0.0)};
  Lookups<D> lookups;
  for (std::size_t first = 0; first < hits.count; first += L::kWidth) {
    const Indices<L> hit(select(L::first(hits.count - first), L::load(hits.hit + first),
                                I(hits.hit[first])));
    const Indices<L> ray(hit.load(level.hits.ray));
    const ThreeOfHits<L> points{{hit, scratch.px}, {hit, scratch.py}, {hit, scratch.pz}};
    const ThreeOfHits<L> normals{{hit, scratch.nx}, {hit, scratch.ny}, {hit, scratch.nz}};
    const ThreeOfHits<L> views{{hit, scratch.vx}, {hit, scratch.vy}, {hit, scratch.vz}};
    const OfHits<L> before(ray, level.rays.width + begin), spread(ray, level.rays.spread + begin);
    const OfHits<L> travelled(ray, level.rays.travelled + begin), distance(ray, scratch.t);
    for (std::size_t i = 0; i < L::kWidth && first + i < hits.count; i += D::kWidth) {
      const std::int32_t* const numbers = hits.hit + first + i;
      const std::size_t left = hits.count - first - i;
      const std::size_t count = left < D::kWidth ? left : D::kWidth;
      const F width = before(i) + spread(i) * distance(i);
      alignas(64) double widths[D::kWidth];
      D::store(width, widths);
      for (std::size_t k = 0; k < count; ++k) scratch.cones[numbers[k]].width = widths[k];

      SolidPlace<F> at;
      if (hits.its->sees_footprint)
        at = place_in_shape(*hits.to_shape, points(i), normals(i), views(i), width);
      else
        at = {moved_by(*hits.to_shape, points(i)), {none, none}, F(0.0)};
      lookups.start();
      InLanes<D> values{};
      for (std::int32_t use = 0; use < hits.its->use_count; ++use) {
        const TextureUse& its = hits.its->uses[use];
        const PreparedTexture& t = hits.textures[its.texture];
        // A colour is two coefficients with one texture.
        if (use == 0 || its.texture != hits.its->uses[use - 1].texture) {
          if (t.kind == TextureKind::checker && t.mapping == TextureMapping::solid)
            values.store(checker_at(t, place_in_texture(t, at)));
          else if (t.has_mips() && t.mapping == TextureMapping::solid)
            color_by_mips(t, place_in_texture(t, at), count, values);
          else
            lookups.find(t, at, (travelled(i) + distance(i)) / F(hits.frame_scale), count, values);
        }
        for (std::size_t k = 0; k < count; ++k)
          put(its.coefficient, values[k],
              scratch.own_rows + static_cast<std::ptrdiff_t>(numbers[k]) * kMaterialReals);
      }
    }
  }
}

#ifdef ZRAKA_WIDE
using Lanes = WideLanes;
#else
using Lanes = ScalarLanes<double>;
#endif
template void color_hits<Lanes>(const HitsOfMaterial&, const Level<Lanes::Real>&,
                                Scratch<Lanes::Real>&);

}  // namespace zraka::ZRAKA_ISA
