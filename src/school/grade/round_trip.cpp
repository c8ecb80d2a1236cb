// SPDX-License-Identifier: Apache-2.0
#include "school/grade/round_trip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "image/alter.hpp"

namespace zraka {
namespace {

/// A JPEG's blocks, where colours have half as many samples.
constexpr std::uint32_t kJpegBlock = 16;

Turn undone(const Turn& turn) {
  return {turn.flipped, turn.transposed, turn.flipped_first};
}

/// A box of a picture of `width` × `height`, in the picture turned.
DrawnBox box_turned_by(DrawnBox box, const Turn& turn, std::uint32_t width, std::uint32_t height) {
  const auto flip = [&] { box = {box.left, height - box.bottom, box.right, height - box.top}; };
  if (turn.flipped_first) flip();
  if (turn.transposed) {
    box = {box.top, box.left, box.bottom, box.right};
    std::swap(width, height);
  }
  if (turn.flipped) flip();
  return box;
}

}  // namespace

RoundTrip::RoundTrip(const Fitted& fitted, const JpegTables* tables,
                     const UnpaintedLines* unpainted)
    : tables_(tables), unpainted_(unpainted) {
  part_.turn = fitted.turn;
  part_.exact = fitted.exact;
  part_.softened = fitted.softened;
  part_.repeated = fitted.repeated;
  part_.placement = fitted.placement;
  part_.width = fitted.width;
  part_.height = fitted.height;
  const bool unlike = fitted.alignment.unpainted || (!fitted.exact && !fitted.softened);
  if (tables_ == nullptr || unlike) {
    tables_ = nullptr;
    return;
  }
  if (fitted.source == nullptr) return;
  if (unpainted_ != nullptr) {
    part_.image = *fitted.source;
    return;
  }
  const GridPlacement& at = fitted.placement;
  const auto inside = [](double value, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::clamp(value, 0.0, static_cast<double>(most)));
  };
  const DrawnBox turned{inside(std::floor(at.left), fitted.width),
                        inside(std::floor(at.top), fitted.height),
                        inside(std::ceil(at.left + at.across * fitted.image.width), fitted.width),
                        inside(std::ceil(at.top + at.down * fitted.image.height), fitted.height)};
  // Blocks begin where the file does.
  const std::uint32_t width = fitted.turn.transposed ? fitted.height : fitted.width,
                      height = fitted.turn.transposed ? fitted.width : fitted.height;
  DrawnBox box = box_turned_by(turned, undone(fitted.turn), fitted.width, fitted.height);
  box = {box.left / kJpegBlock * kJpegBlock, box.top / kJpegBlock * kJpegBlock,
         std::min(width, (box.right + kJpegBlock - 1) / kJpegBlock * kJpegBlock),
         std::min(height, (box.bottom + kJpegBlock - 1) / kJpegBlock * kJpegBlock)};
  if (box.left >= box.right || box.top >= box.bottom) {
    tables_ = nullptr;
    return;
  }
  const DrawnBox part = box_turned_by(box, fitted.turn, width, height);
  part_.width = part.right - part.left;
  part_.height = part.bottom - part.top;
  part_.placement.left -= part.left;
  part_.placement.top -= part.top;
  part_.image = cropped(*fitted.source, part.left, part.top, part_.width, part_.height);
}

/// What was drawn in a box of it is another picture's.
Image RoundTrip::compressed(const Image& there, const DrawnBox& drawn) const {
  const Image handed_in = zraka::turned_by(there, undone(part_.turn));
  if (unpainted_ == nullptr)
    return zraka::turned_by(compressed_again(handed_in, *tables_), part_.turn);
  const DrawnBox box = box_turned_by(drawn, undone(part_.turn), there.width, there.height);
  const Image lines = unpainted_->unpainted(handed_in, box.left, box.top, box.right, box.bottom);
  return zraka::turned_by(unpainted_->painted(compressed_again(lines, *tables_)), part_.turn);
}

Image RoundTrip::operator()(Image image) const {
  if (tables_ == nullptr) return part_.softened ? through_scaling(image, part_) : image;
  if (part_.image.pixels.empty()) return compressed(image, {0, 0, image.width, image.height});
  const GridPlacement& at = part_.placement;
  Image there = part_.image;
  const Image drawn = scaled_into(image, part_, there.width, there.height);
  const auto clamped = [](double value, std::uint32_t most) {
    return static_cast<std::uint32_t>(
        std::clamp(std::round(value), 0.0, static_cast<double>(most)));
  };
  const std::uint32_t left = clamped(at.left, there.width), top = clamped(at.top, there.height),
                      right = clamped(at.left + at.across * image.width, there.width),
                      bottom = clamped(at.top + at.down * image.height, there.height);
  for (std::uint32_t y = top; y < bottom; ++y)
    std::copy(drawn.row(y) + std::size_t{3} * left, drawn.row(y) + std::size_t{3} * right,
              there.row(y) + std::size_t{3} * left);
  return resampled(compressed(there, {left, top, right, bottom}), at, image.width, image.height);
}

}  // namespace zraka
