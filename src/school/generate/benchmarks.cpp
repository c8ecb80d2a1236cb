// SPDX-License-Identifier: Apache-2.0
#include "school/generate/benchmarks.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>
#include <zraka/values.hpp>

#include "core/new_file.hpp"
#include "core/random.hpp"

namespace zraka {
namespace {

constexpr double kTurn = 6.28318530717958648;
/// Exponents of highlights, as the Standard Procedural Databases' generators write them.
constexpr double kHighlight = 3.0827, kMatt = 100000;

Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vec3 operator*(const Vec3& a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 unit(const Vec3& a) {
  return a * (1 / std::sqrt(dot(a, a)));
}

/// Lines of NFF into a file, by way of a buffer.
class Lines {
 public:
  explicit Lines(std::FILE* stream) : stream_(stream) {}
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  ~Lines() { flush(); }

  void view(const Vec3& from, const Vec3& at, const Vec3& up, double angle) {
    add("b 0.078 0.361 0.753\nv\nfrom {:.9g} {:.9g} {:.9g}\nat {:.9g} {:.9g} {:.9g}\n", from.x,
        from.y, from.z, at.x, at.y, at.z);
    add("up {:.9g} {:.9g} {:.9g}\nangle {:.9g}\nhither 0.01\nresolution 512 512\n", up.x, up.y,
        up.z, angle);
  }
  void light(const Vec3& p) { add("l {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z); }
  void material(double r, double g, double b, double kd, double ks, double shine) {
    add("f {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} 0 0\n", r, g, b, kd, ks, shine);
  }
  void sphere(const Vec3& c, double r) { add("s {:.9g} {:.9g} {:.9g} {:.9g}\n", c.x, c.y, c.z, r); }
  void cylinder(const Vec3& a, const Vec3& b, double r) {
    add("c {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n", a.x, a.y, a.z, r, b.x, b.y,
        b.z, r);
  }
  template <std::size_t N>
  void polygon(const std::array<Vec3, N>& corners) {
    add("p {}\n", N);
    for (const Vec3& c : corners) add("{:.9g} {:.9g} {:.9g}\n", c.x, c.y, c.z);
  }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
    if (buffer_.size() > (1u << 20)) flush();
  }
  void flush() {
    std::fwrite(buffer_.data(), 1, buffer_.size(), stream_);
    buffer_.clear();
  }
  std::FILE* stream_;
  fmt::memory_buffer buffer_;
};

/// Three children on the lower ring, six on the equator seen from the parent's own axis, each a
/// third as large (Haines, "A proposal for standard graphics environments", 1987).
void flake(Lines& out, const Vec3& center, double radius, const Vec3& axis, int levels) {
  out.sphere(center, radius);
  if (levels == 0) return;
  const Vec3 side = unit(cross(axis, std::fabs(axis.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 other = cross(axis, side);
  for (int i = 0; i < 9; ++i) {
    const bool equator = i < 6;
    const double around = equator ? kTurn * i / 6 : kTurn * (i - 6) / 3 + kTurn / 12;
    const double height = equator ? 0 : std::sqrt(2.0 / 3);
    const double wide = std::sqrt(1 - height * height);
    const Vec3 way =
        side * (wide * std::cos(around)) + other * (wide * std::sin(around)) + axis * height;
    flake(out, center + way * (radius * 4 / 3), radius / 3, way, levels - 1);
  }
}

void ground_and_lights(Lines& out, double height) {
  out.light({4, 3, 2});
  out.light({1, -4, 4});
  out.light({-3, 1, 5});
  out.material(1, 0.75, 0.33, 0.8, 0, 1);
  out.polygon(std::array<Vec3, 4>{
      {{12, 12, height}, {-12, 12, height}, {-12, -12, height}, {12, -12, height}}});
}

void sphereflake(Lines& out, int size) {
  out.view({2.1, 1.3, 1.7}, {0, 0, 0}, {0, 0, 1}, 45);
  ground_and_lights(out, -0.5);
  out.material(1, 0.9, 0.7, 0.5, 0.5, 3);
  flake(out, {0, 0, 0}, 0.5, {0, 0, 1}, size);
}

/// The lattice of the Standard Procedural Databases (Antonio Costa, 1993), with its view and
/// lights: mirroring spheres on the corners of size³ cubes, matt cylinders along their edges.
void lattice(Lines& out, int size) {
  const double step = 1.0 / size, radius = step / 4;
  const double aside = (size / 2 + 0.5) * step;  // between two rows of spheres
  out.view({aside, 1, 1 - step / 2}, {aside, -1, -1 - step / 2}, {0.2, 1, 0}, 60);
  for (const double side : {2.0, -1.0}) {
    out.light({side, 0.5, 0.5});
    out.light({0.5, side, 0.5});
    out.light({0.5, 0.5, side});
  }
  const auto corners = [&](int last_x, int last_y, int last_z, const auto& function) {
    for (int x = 0; x <= last_x; ++x)
      for (int y = 0; y <= last_y; ++y)
        for (int z = 0; z <= last_z; ++z) function(Vec3{1.0 * x, 1.0 * y, 1.0 * z} * step);
  };
  out.material(0.9, 0.9, 0.9, 0.5, 0.5, kHighlight);
  corners(size, size, size, [&](const Vec3& at) { out.sphere(at, radius); });
  // They begin within the spheres.
  const double from = radius / 2 * 0.99, to = step - from;
  out.material(0.9, 0.1, 0.1, 0.99, 0, kMatt);
  corners(size - 1, size, size, [&](const Vec3& at) {
    out.cylinder(at + Vec3{from, 0, 0}, at + Vec3{to, 0, 0}, radius / 4);
  });
  out.material(0.1, 0.9, 0.1, 0.99, 0, kMatt);
  corners(size, size - 1, size, [&](const Vec3& at) {
    out.cylinder(at + Vec3{0, from, 0}, at + Vec3{0, to, 0}, radius / 4);
  });
  out.material(0.1, 0.1, 0.9, 0.99, 0, kMatt);
  corners(size, size, size - 1, [&](const Vec3& at) {
    out.cylinder(at + Vec3{0, 0, from}, at + Vec3{0, 0, to}, radius / 4);
  });
}

/// The pentagon that joins the middles of five of a dodecahedron's edges: the first of six lies
/// across z, the others lean on it by the angle between two faces.
std::array<Vec3, 5> pentagon(int number, double radius) {
  std::array<Vec3, 5> corners;
  const double lean = number == 0 ? 0 : 2 * std::acos(0.5 / std::sin(kTurn / 10));
  const double turn = number == 0 ? 0 : kTurn * (2 * number - 1) / 10;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double around = kTurn * static_cast<double>(i) / 5;
    const double x = radius * std::cos(around), y = radius * std::sin(around) * std::cos(lean);
    corners[i] = {x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn),
                  radius * std::sin(around) * std::sin(lean)};
  }
  return corners;
}

/// The rings of the Standard Procedural Databases (Haines, 1987), with their view and lights: a
/// pyramid of balls of six pentagons each, of spheres and cylinders that mirror each other, before
/// a wall.
void rings(Lines& out, int size) {
  const double layer = 1 / std::sin(kTurn / 16);  // from one layer to the next, and to the eye
  const double thick = 0.07412, wide = 1 / (1 + thick);
  const Vec3 eye{-1, -layer, 0.5};
  out.view(eye, eye + Vec3{0, 1, 0}, {0, 0, 1}, 45);
  out.light({3, -layer, 3});
  out.light({-4, -layer, 1});
  out.light({2, -layer, -4});
  // The wall is 1 % larger than what is seen of it.
  const double back = layer * (size + 1), reach = 1.01 * (back + layer) * std::tan(kTurn / 16);
  out.material(1, 1, 1, 1, 0, kMatt);
  out.polygon(std::array<Vec3, 4>{{{eye.x + reach, back, eye.z + reach},
                                   {eye.x - reach, back, eye.z + reach},
                                   {eye.x - reach, back, eye.z - reach},
                                   {eye.x + reach, back, eye.z - reach}}});
  constexpr std::array<Color, 6> kColors = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};
  for (std::size_t ring = 0; ring < kColors.size(); ++ring) {
    const std::array<Vec3, 5> corners = pentagon(static_cast<int>(ring), wide);
    out.material(kColors[ring].r, kColors[ring].g, kColors[ring].b, 0.5, 0.2, kHighlight);
    for (int depth = 0; depth < size; ++depth)
      for (int z = 0; z <= depth; ++z)
        for (int x = 0; x <= depth; ++x) {
          const Vec3 center{2.0 * x - depth, layer * (depth + 1), 2.0 * z - depth};
          for (std::size_t i = 0; i < corners.size(); ++i) {
            out.sphere(center + corners[i], thick);
            out.cylinder(center + corners[i], center + corners[(i + 4) % 5], thick);
          }
        }
  }
}

void spheres(Lines& out, int size, std::uint32_t seed) {
  out.view({2.4, -1.6, 1.8}, {0, 0, 0}, {0, 0, 1}, 40);
  ground_and_lights(out, -0.7);
  Random random(seed);
  const auto count = static_cast<std::int64_t>(std::llround(std::pow(10.0, size)));
  const double radius = 0.35 / std::cbrt(static_cast<double>(count));
  for (const bool mirrors : {false, true}) {
    out.material(mirrors ? 0.9 : 0.3, 0.8, mirrors ? 0.9 : 0.6, mirrors ? 0.3 : 0.8,
                 mirrors ? 0.6 : 0, 20);
    for (std::int64_t i = mirrors ? (count + 1) / 2 : 0; i < (mirrors ? count : (count + 1) / 2);
         ++i) {
      const double x = random.unit(), y = random.unit(), z = random.unit();
      out.sphere({x - 0.5, y - 0.5, z - 0.5}, radius * (0.5 + random.unit()));
    }
  }
}

void terrain(Lines& out, int size, std::uint32_t seed) {
  out.view({1.6, -1.4, 1.2}, {0, 0, 0}, {0, 0, 1}, 40);
  out.light({4, 3, 4});
  out.light({-4, -1, 5});
  out.material(0.45, 0.55, 0.35, 1, 0, 1);
  // Heights as sums of waves whose directions and phases are drawn once.
  Random random(seed);
  constexpr int kWaves = 40;
  std::array<std::array<double, 4>, kWaves> waves;
  for (std::size_t i = 0; i < kWaves; ++i) {
    const double turn = kTurn * random.unit(), many = 3 * std::pow(1.15, static_cast<double>(i));
    waves[i] = {many * std::cos(turn), many * std::sin(turn), kTurn * random.unit(), 0.25 / many};
  }
  const int side = 1 << size;
  const auto row = [&](int j) {
    std::vector<Vec3> points;
    for (int i = 0; i <= side; ++i) {
      const double x = 2.0 * i / side - 1, y = 2.0 * j / side - 1;
      double z = 0;
      for (const auto& w : waves) z += w[3] * std::sin(w[0] * x + w[1] * y + w[2]);
      points.push_back({x, y, z});
    }
    return points;
  };
  std::vector<Vec3> below = row(0);
  for (int j = 0; j < side; ++j) {
    std::vector<Vec3> above = row(j + 1);
    for (std::size_t i = 0; i + 1 < below.size(); ++i) {
      out.polygon(std::array<Vec3, 3>{below[i], below[i + 1], above[i + 1]});
      out.polygon(std::array<Vec3, 3>{below[i], above[i + 1], above[i]});
    }
    below = std::move(above);
  }
}

/// Four half as large in its corners, and so on: Sierpiński's. Two opposite corners of each face of
/// a cube are its own.
void tetrahedra(Lines& out, const Vec3& center, double half, int levels) {
  constexpr std::array<Vec3, 4> kCorners = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  if (levels > 0) {
    for (const Vec3& corner : kCorners)
      tetrahedra(out, center + corner * (half / 2), half / 2, levels - 1);
    return;
  }
  // Counterclockwise, seen from outside.
  constexpr int kFaces[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
  for (const auto& face : kFaces) {
    const auto corner = [&](int i) {
      return center + kCorners[static_cast<std::size_t>(face[i])] * half;
    };
    out.polygon(std::array<Vec3, 3>{corner(0), corner(1), corner(2)});
  }
}

/// The tetrahedron of Haines' Standard Procedural Databases, with its view and light, so that its
/// rays can be counted against published figures.
void tetra(Lines& out, int size) {
  out.view({1.02285, -3.17715, -2.17451}, {-0.004103, -0.004103, 0.216539},
           {-0.816497, -0.816497, 0.816497}, 45);
  out.light({1.87607, -18.1239, -5.00042});
  out.material(1, 0.2, 0.2, 1, 0, 0);
  tetrahedra(out, {0, 0, 0}, 1, size - 1);
}

}  // namespace

Result<void> generate_benchmark(const std::string& name, int size, std::uint32_t seed,
                                const std::string& path) {
  const Benchmark* benchmark = nullptr;
  for (const Benchmark& b : kBenchmarks)
    if (name == b.name) benchmark = &b;
  if (benchmark == nullptr) return failure("", fmt::format("there is no benchmark '{}'", name));
  if (size < benchmark->smallest || size > benchmark->largest)
    return failure("", fmt::format("size {} of {} is out of range: {} to {}", size, name,
                                   benchmark->smallest, benchmark->largest));
  Result<NewFile> file = NewFile::create(path);
  if (!file) return tl::make_unexpected(file.error());
  {
    Lines out(file->stream());
    if (name == "sphereflake") sphereflake(out, size);
    if (name == "lattice") lattice(out, size);
    if (name == "rings") rings(out, size);
    if (name == "spheres") spheres(out, size, seed);
    if (name == "terrain") terrain(out, size, seed);
    if (name == "tetra") tetra(out, size);
  }
  return file->commit();
}

}  // namespace zraka
