// SPDX-License-Identifier: Apache-2.0
#include "tracer.hpp"

#include <algorithm>
#include <limits>

namespace zraka::embree {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

Float16 largest(Three<Float16> v) {
  return max(abs(v.x), max(abs(v.y), abs(v.z)));
}

/// A material for each lane, or one for all of them.
struct Materials {
  const float* rows;
  Int16 row;
  bool shared;

  Materials(const World& world, Int16 material, unsigned lanes)
      : rows(world.materials.data()), row(material * static_cast<int>(kMaterialColumns)) {
    const int first = row[__builtin_ctz(lanes)];
    shared = (bits(row != first) & lanes) == 0;
    if (shared) row = embree::all(first);
  }
  Float16 operator[](int column) const {
    return shared ? embree::all(rows[row[0] + column]) : gather(rows + column, row);
  }
  Three<Float16> color(int column) const {
    return {(*this)[column], (*this)[column + 1], (*this)[column + 2]};
  }
};

/// Lanes that are not wanted end before they begin: where Embree cuts packets up it goes by that,
/// and not by the mask that it was given.
template <class Ray>
void put_ray(Ray& ray, Int16 wanted, Three<Float16> origin, Three<Float16> direction, Float16 far) {
  store(origin.x, ray.org_x), store(origin.y, ray.org_y), store(origin.z, ray.org_z);
  store(direction.x, ray.dir_x), store(direction.y, ray.dir_y), store(direction.z, ray.dir_z);
  store(Float16{}, ray.tnear), store(choose(wanted, far, all(-1.0f)), ray.tfar);
  store(Float16{}, ray.time);
  store(all(-1), ray.mask), store(Int16{}, ray.flags), store(Int16{}, ray.id);
}

}  // namespace

/// Sixteen rays on their way: as they start, what they hit, how it looks there.
struct Tracer::Packet {
  Three<Float16> origin, direction;
  Float16 weight;
  Int16 pixel;
  unsigned lanes;  ///< that are rays
  unsigned hits;   ///< that hit something
  Float16 t, u, v;
  Three<Float16> flat_normal;
  Int16 geometry, primitive, material;
  Three<Float16> point, normal;  ///< the normal has unit length and points to where the ray began
  Float16 offset;                ///< from the surface to where other rays begin
  Int16 inside;
};

Tracer::Tracer(const World& world, Mode mode, int max_depth)
    : world_(world),
      mode_(mode),
      max_depth_(max_depth),
      reflected_(static_cast<std::size_t>(max_depth) + 1),
      refracted_(static_cast<std::size_t>(max_depth) + 1) {}

void Tracer::make_camera_rays(std::uint32_t x, std::uint32_t y) {
  RayList& rays = reflected_[0];
  rays.clear();
  refracted_[0].clear();
  rays.reserve(kTile * kTile);
  // Squares of 4×4 are packets.
  const Int16 in_square = numbers_from(0) % 4, row_of_square = numbers_from(0) / 4;
  for (int top = 0; top < kTile; top += 4)
    for (int left = 0; left < kTile; left += 4) {
      const Int16 column = in_square + left, row = row_of_square + top;
      const Int16 there = (column + static_cast<int>(x) <= static_cast<int>(world_.width)) &
                          (row + static_cast<int>(y) <= static_cast<int>(world_.height));
      const Float16 px = __builtin_convertvector(column + static_cast<int>(x), Float16);
      const Float16 py = __builtin_convertvector(row + static_cast<int>(y), Float16);
      const Three<Float16> way = all(world_.first) + all(world_.right) * px + all(world_.down) * py;
      rays.add(bits(there), all(world_.eye), unit(way), all(1.0f), row * kTile + column);
    }
  counts_.camera += static_cast<std::uint64_t>(rays.size());
}

void Tracer::trace_tile(std::uint32_t x, std::uint32_t y, float* corners) {
  std::fill(&pixels_[0][0], &pixels_[0][0] + 3 * kTile * kTile, 0.0f);
  make_camera_rays(x, y);
  for (int level = 0; level <= max_depth_; ++level) {
    const auto at = static_cast<std::size_t>(level);
    const int rays = reflected_[at].size() + refracted_[at].size();
    if (rays == 0) break;
    if (level < max_depth_) {
      for (RayList* next : {&reflected_[at + 1], &refracted_[at + 1]}) {
        next->clear();
        next->reserve(rays);
      }
    }
    for (const RayList* list : {&reflected_[at], &refracted_[at]})
      for (int first = 0; first < list->size(); first += kWide) trace_packet(*list, first, level);
  }
  const std::uint32_t width = world_.width + 1, height = world_.height + 1;
  for (std::uint32_t row = 0; row < kTile && y + row < height; ++row)
    for (std::uint32_t column = 0; column < kTile && x + column < width; ++column)
      for (std::size_t c = 0; c < 3; ++c)
        corners[3 * (std::size_t{y + row} * width + x + column) + c] =
            pixels_[c][row * kTile + column];
}

void Tracer::trace_packet(const RayList& rays, int first, int level) {
  const auto i = static_cast<std::size_t>(first);
  const int count = std::min(kWide, rays.size() - first);
  Packet packet;
  packet.origin = {load(&rays.ox[i]), load(&rays.oy[i]), load(&rays.oz[i])};
  packet.direction = {load(&rays.dx[i]), load(&rays.dy[i]), load(&rays.dz[i])};
  packet.weight = load(&rays.weight[i]);
  packet.pixel = load(&rays.pixel[i]);
  packet.lanes = count == kWide ? 0xFFFFu : (1u << count) - 1;
  find_nearest(packet, level);
  const unsigned missed = packet.lanes & ~packet.hits;
  if (missed != 0) add_to_pixels(packet.pixel, missed, all(world_.background) * packet.weight);
  if (packet.hits == 0) return;
  find_surface(packet);
  add_to_pixels(packet.pixel, packet.hits, light(packet) * packet.weight);
  if (level < max_depth_) spawn(packet, level);
}

Going Tracer::going_of(Three<Float16> directions, unsigned lanes) const {
  constexpr float kNear = 0.97f;  // cosine of the widest angle
  if (!world_.coherence_pays) return Going::apart;
  const int some = __builtin_ctz(lanes);
  const Vec way{directions.x[some], directions.y[some], directions.z[some]};
  return (bits(dot(directions, all(way)) < kNear) & lanes) == 0 ? Going::together : Going::apart;
}

void Tracer::find_nearest(Packet& packet, int level) const {
  const Going going = level == 0 ? Going::together : going_of(packet.direction, packet.lanes);
  const Int16 wanted = numbers_from(0) < __builtin_popcount(packet.lanes);
  alignas(64) RTCRayHit16 rays;
  put_ray(rays.ray, wanted, packet.origin, packet.direction, all(kFar));
  store(all(-1), rays.hit.geomID);
  if (mode_ == Mode::packets) {
    alignas(64) int valid[kWide];
    store(wanted, valid);
    nearest(world_.embree, going, valid, rays);
  } else {
    each_bit(packet.lanes, [&](int i) {
      RTCRayHit one;
      one.ray = {rays.ray.org_x[i],
                 rays.ray.org_y[i],
                 rays.ray.org_z[i],
                 0,
                 rays.ray.dir_x[i],
                 rays.ray.dir_y[i],
                 rays.ray.dir_z[i],
                 0,
                 kFar,
                 ~0u,
                 0,
                 0};
      one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      nearest(world_.embree, going, one);
      rays.ray.tfar[i] = one.ray.tfar;
      rays.hit.Ng_x[i] = one.hit.Ng_x;
      rays.hit.Ng_y[i] = one.hit.Ng_y;
      rays.hit.Ng_z[i] = one.hit.Ng_z;
      rays.hit.u[i] = one.hit.u;
      rays.hit.v[i] = one.hit.v;
      rays.hit.primID[i] = one.hit.primID;
      rays.hit.geomID[i] = one.hit.geomID;
    });
  }
  packet.t = load(rays.ray.tfar);
  packet.flat_normal = {load(rays.hit.Ng_x), load(rays.hit.Ng_y), load(rays.hit.Ng_z)};
  packet.u = load(rays.hit.u);
  packet.v = load(rays.hit.v);
  packet.geometry = load<Int16>(rays.hit.geomID);
  packet.primitive = load<Int16>(rays.hit.primID);
  packet.hits = bits(packet.geometry >= 0) & packet.lanes;
}

void Tracer::find_surface(Packet& packet) const {
  const Int16 hit = packet.geometry >= 0;
  // Lanes without a hit borrow the values of one that has any.
  const int some = __builtin_ctz(packet.hits);
  packet.t = hit ? packet.t : all(packet.t[some]);
  packet.geometry = hit ? packet.geometry : all(packet.geometry[some]);
  packet.primitive = hit ? packet.primitive : all(packet.primitive[some]);
  packet.flat_normal = choose(hit, packet.flat_normal, all(Vec{0, 0, 1}));

  const unsigned smooth = bits(packet.geometry == static_cast<int>(kSmoothTriangles)) & packet.hits;
  const unsigned spheres = bits(packet.geometry == static_cast<int>(kSpheres)) & packet.hits;
  Three<Float16> normal = packet.flat_normal;
  if (smooth != 0) {
    const Int16 mine = packet.geometry == static_cast<int>(kSmoothTriangles);
    const Int16 row = mine ? packet.primitive * 9 : Int16{};
    const auto corner = [&](int first) {
      const float* columns = world_.corner_normals.data() + first;
      return Three<Float16>{gather(columns, row), gather(columns + 1, row),
                            gather(columns + 2, row)};
    };
    const Three<Float16> blended =
        corner(0) * (1.0f - packet.u - packet.v) + corner(3) * packet.u + corner(6) * packet.v;
    normal = choose(mine, blended, normal);
  }
  normal = unit(normal);
  packet.point = packet.origin + packet.direction * packet.t;
  Float16 magnitude = largest(packet.point);
  if (spheres != 0) {
    const Int16 mine = packet.geometry == static_cast<int>(kSpheres);
    magnitude += gather(&world_.spheres.data()->radius, mine ? packet.primitive * 4 : Int16{});
  }
  packet.offset = magnitude * 0x1p-18f;
  packet.inside = dot(normal, packet.direction) > 0.0f;
  packet.normal = choose(packet.inside, normal * all(-1.0f), normal);
  const Int16 first = gather(world_.first_of, packet.geometry);
  packet.material = gather(world_.material_of.data(), first + packet.primitive);
}

Int16 Tracer::find_lit(const Packet& packet, Int16 wanted, Three<Float16> way,
                       Float16 distance) const {
  const Going going = going_of(way, bits(wanted));
  alignas(64) RTCRay16 rays;
  put_ray(rays, wanted, packet.point + packet.normal * packet.offset, way, distance);
  if (mode_ == Mode::packets) {
    alignas(64) int valid[kWide];
    store(wanted, valid);
    any_hit(world_.embree, going, valid, rays);
  } else {
    each_bit(bits(wanted), [&](int i) {
      RTCRay one{rays.org_x[i],
                 rays.org_y[i],
                 rays.org_z[i],
                 0,
                 rays.dir_x[i],
                 rays.dir_y[i],
                 rays.dir_z[i],
                 0,
                 rays.tfar[i],
                 ~0u,
                 0,
                 0};
      any_hit(world_.embree, going, one);
      rays.tfar[i] = one.tfar;
    });
  }
  return wanted & (load(rays.tfar) >= 0.0f);
}

Three<Float16> Tracer::light(const Packet& packet) {
  const Materials material(world_, packet.material, packet.hits);
  const Int16 hit = (static_cast<int>(packet.hits) >> numbers_from(0) & 1) != 0;
  Three<Float16> sum = material.color(kAmbientIn);
  for (const PointLight& light : world_.lights) {
    const Three<Float16> to_light = all(light.position) - packet.point;
    const Float16 distance = sqrt(dot(to_light, to_light));
    const Three<Float16> way = to_light * (1.0f / distance);
    const Float16 facing = dot(way, packet.normal);
    const Int16 wanted = hit & (facing >= 0.0f);
    const unsigned shadow_rays = bits(wanted);
    if (shadow_rays == 0) continue;
    counts_.shadow += static_cast<std::uint64_t>(__builtin_popcount(shadow_rays));
    const Int16 lit = find_lit(packet, wanted, way, distance);
    if (bits(lit) == 0) continue;
    const Three<Float16> color = all(light.color);
    Three<Float16> more = color * material.color(kDiffuse) * facing;
    const Three<Float16> specular = material.color(kSpecular);
    if ((bits(largest(specular) > 0.0f) & packet.hits) != 0) {
      const Three<Float16> mirrored = packet.normal * (facing + facing) - way;
      const Float16 towards_eye = -dot(mirrored, packet.direction);
      const Float16 highlight = towards_eye >= 0.0f
                                    ? power(max(towards_eye, Float16{}), material[kShininess])
                                    : Float16{};
      more = more + color * specular * highlight;
    }
    sum = sum + choose(lit, more, all(Vec{}));
  }
  return sum;
}

void Tracer::spawn(const Packet& packet, int level) {
  const Materials material(world_, packet.material, packet.hits);
  const auto next = static_cast<std::size_t>(level) + 1;
  const Float16 cosine = -dot(packet.direction, packet.normal);
  const Float16 reflection = material[kReflection], refraction = material[kRefraction];
  const unsigned reflects = bits(reflection > 0.0f) & packet.hits;
  if (reflects != 0) {
    reflected_[next].add(reflects, packet.point + packet.normal * packet.offset,
                         packet.direction + packet.normal * (cosine + cosine),
                         packet.weight * reflection, packet.pixel);
    counts_.reflected += static_cast<std::uint64_t>(__builtin_popcount(reflects));
  }
  if ((bits(refraction > 0.0f) & packet.hits) == 0) return;
  const Float16 ratio = packet.inside ? material[kRatioOut] : material[kRatioIn];
  const Float16 square = 1.0f - ratio * ratio * (1.0f - cosine * cosine);
  const unsigned refracts = bits((refraction > 0.0f) & (square >= 0.0f)) & packet.hits;
  if (refracts == 0) return;
  const Three<Float16> way =
      packet.direction * ratio + packet.normal * (ratio * cosine - sqrt(max(square, Float16{})));
  refracted_[next].add(refracts, packet.point - packet.normal * packet.offset, unit(way),
                       packet.weight * refraction, packet.pixel);
  counts_.refracted += static_cast<std::uint64_t>(__builtin_popcount(refracts));
}

void Tracer::add_to_pixels(Int16 pixel, unsigned lanes, Three<Float16> color) {
  // One by one: a pixel may have two rays in a packet.
  each_bit(lanes, [&](int i) {
    pixels_[0][pixel[i]] += color.x[i];
    pixels_[1][pixel[i]] += color.y[i];
    pixels_[2][pixel[i]] += color.z[i];
  });
}

}  // namespace zraka::embree
