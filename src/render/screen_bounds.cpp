// SPDX-License-Identifier: Apache-2.0
#include "render/screen_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/freeze.hpp"

namespace zraka {
namespace {

constexpr std::int32_t kEverywhere = std::numeric_limits<std::int32_t>::max() / 2;

V3<double> in_double(const auto& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

double reach_of(const V3<double>& v) {
  return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
}

}  // namespace

/// From points to pixels: eye + s·(first + right·column + down·row), solved for s, s·column and
/// s·row by Cramer's rule; of an orthographic camera eye + first + right·column + down·row +
/// ahead·s, solved for s, column and row.
struct ScreenBounds::Projection {
  V3<double> eye, to_s, to_column, to_row;
  double column_margin, row_margin;
  bool parallel, usable;

  template <class R>
  Projection(const FrozenCamera<R>& camera, double width, double height, double reach)
      : eye(in_double(camera.eye)), parallel(camera.kind == CameraKind::orthographic) {
    const V3<double> first = in_double(camera.first), right = in_double(camera.right),
                     down = in_double(camera.down);
    const V3<double> ahead = parallel ? in_double(camera.ahead) : first;
    const V3<double> normal = cross(right, down);
    const double one = 1 / dot(ahead, normal);
    to_s = normal * one;
    to_column = cross(down, ahead) * one;
    to_row = cross(ahead, right) * one;
    if (parallel) eye = eye + first;
    // A ray's direction is rounded several times, by 2^-24 of what it is made of; so is the origin
    // of a parallel one, and its direction counts as far as the farthest shape. Beside that, a
    // pixel is more than doubles err here.
    const double rounding =
        0x1p-21 * (reach_of(first) + width * reach_of(right) + height * reach_of(down) +
                   (parallel ? reach_of(eye) + 4 : 0));
    const double columns = parallel ? 0 : width, rows = parallel ? 0 : height;
    column_margin = 1 + reach + rounding * (reach_of(to_column) + columns * reach_of(to_s));
    row_margin = 1 + reach + rounding * (reach_of(to_row) + rows * reach_of(to_s));
    // Where the window's plane all but holds the eye (views of 180° less a ten-thousandth),
    // rounding can turn a ray to what is behind the eye.
    usable = (parallel || rounding * reach_of(to_s) < 0.5) && std::isfinite(column_margin) &&
             std::isfinite(row_margin) && (parallel || camera.is_plain());
  }
};

void ScreenBounds::add(const Projection& camera, const float* lower, const float* upper) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double left = kInfinity, right = -kInfinity, top = kInfinity, bottom = -kInfinity;
  int before = 0, behind = 0;  // the eye
  bool finite = true;
  for (int corner = 0; corner < 8; ++corner) {
    const V3<double> point = {static_cast<double>(((corner & 1) != 0 ? upper : lower)[0]),
                              static_cast<double>(((corner & 2) != 0 ? upper : lower)[1]),
                              static_cast<double>(((corner & 4) != 0 ? upper : lower)[2])};
    const V3<double> away = point - camera.eye;
    const double s = dot(away, camera.to_s);
    before += s > 0 || camera.parallel ? 1 : 0;
    behind += s < (camera.parallel ? -0x1p-16 * (reach_of(camera.eye) + 4) : 0) ? 1 : 0;
    const double divisor = camera.parallel ? 1 : s;
    const double column = dot(away, camera.to_column) / divisor;
    const double row = dot(away, camera.to_row) / divisor;
    finite = finite && std::isfinite(column) && std::isfinite(row);
    left = std::min(left, column), right = std::max(right, column);
    top = std::min(top, row), bottom = std::max(bottom, row);
  }
  if (camera.usable && behind == 8) return;
  const auto pixel = [](double place) {
    return static_cast<std::int32_t>(std::clamp<double>(place, -kEverywhere, kEverywhere));
  };
  const bool known = camera.usable && before == 8 && finite;
  left_.push_back(known ? pixel(std::ceil(left - camera.column_margin)) : -kEverywhere);
  right_.push_back(known ? pixel(std::floor(right + camera.column_margin)) + 1 : kEverywhere);
  top_.push_back(known ? pixel(std::ceil(top - camera.row_margin)) : -kEverywhere);
  bottom_.push_back(known ? pixel(std::floor(bottom + camera.row_margin)) + 1 : kEverywhere);
}

template <class R>
ScreenBounds::ScreenBounds(const FrozenScene<R>& scene, std::uint32_t width, std::uint32_t height,
                           double reach) {
  const Projection camera(scene.camera, width, height, reach);
  if (scene.bodies.bounded < scene.bodies.count) {  // what has no bounds may be seen anywhere
    left_ = top_ = {-kEverywhere};
    right_ = bottom_ = {kEverywhere};
    return;
  }
  if (scene.hierarchy.nodes == nullptr) {
    std::vector<BuildRef> refs(static_cast<std::size_t>(kind_starts_of(scene).back()));
    refer_to(scene, refs.data());
    for (const BuildRef& ref : refs) add(camera, ref.lower, ref.upper);
    return;
  }
  const auto add_children = [&](const Node& node, const auto& inner) {
    for (int i = 0; i < kNodeWidth; ++i) {
      if (node.leaf[i] == kNoChild) continue;
      const float lower[3] = {node.lower_x[i], node.lower_y[i], node.lower_z[i]};
      const float upper[3] = {node.upper_x[i], node.upper_y[i], node.upper_z[i]};
      if (node.leaf[i] != 0 || !inner(node.child[i])) add(camera, lower, upper);
    }
  };
  const Node* nodes = scene.hierarchy.nodes;
  add_children(nodes[0], [&](std::int32_t child) {
    add_children(nodes[child], [](std::int32_t) { return false; });
    return true;
  });
}

TileRect ScreenBounds::part_of(const TileRect& tile) const {
  const std::int32_t x_end = tile.x + tile.width, y_end = tile.y + tile.height;
  std::int32_t left = x_end, right = tile.x, top = y_end, bottom = tile.y;
  for (std::size_t i = 0; i < left_.size(); ++i) {
    const bool crosses =
        left_[i] < x_end && right_[i] > tile.x && top_[i] < y_end && bottom_[i] > tile.y;
    left = crosses ? std::min(left, left_[i]) : left;
    right = crosses ? std::max(right, right_[i]) : right;
    top = crosses ? std::min(top, top_[i]) : top;
    bottom = crosses ? std::max(bottom, bottom_[i]) : bottom;
  }
  left = std::max(left, tile.x), right = std::min(right, x_end);
  top = std::max(top, tile.y), bottom = std::min(bottom, y_end);
  if (left >= right || top >= bottom) return {tile.x, tile.y, 0, 0};
  return {left, top, right - left, bottom - top};
}

template ScreenBounds::ScreenBounds(const FrozenScene<float>&, std::uint32_t, std::uint32_t,
                                    double);

}  // namespace zraka
