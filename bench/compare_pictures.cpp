// SPDX-License-Identifier: Apache-2.0
// compare_pictures OURS THEIRS: how far a rival's PNG is from ours, as JSON. Theirs may have a
// column and a row more, then it holds the corners of our pixels and is averaged first.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <zraka/image.hpp>

namespace {

using zraka::Image;

/// A pixel differs if a component does by more than this, of 1.
constexpr float kSeen = 16.0f / 255;

Image means_of_corners(const Image& corners) {
  Image image(corners.width - 1, corners.height - 1);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const float *above = corners.row(y), *below = corners.row(y + 1);
    for (std::size_t i = 0; i < std::size_t{3} * image.width; ++i)
      image.row(y)[i] = (above[i] + above[i + 3] + below[i] + below[i + 3]) * 0.25f;
  }
  return image;
}

int fail(const zraka::Diagnostics& problems) {
  for (const zraka::Diagnostic& problem : problems) fmt::print(stderr, "{}", to_string(problem));
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: compare_pictures OURS.png THEIRS.png\n");
    return 2;
  }
  const auto our_file = zraka::read_image(argv[1]);
  if (!our_file) return fail(our_file.error());
  auto their_file = zraka::read_image(argv[2]);
  if (!their_file) return fail(their_file.error());
  const Image* ours = &our_file->image;
  Image* theirs = &their_file->image;
  if (theirs->width == ours->width + 1 && theirs->height == ours->height + 1)
    *theirs = means_of_corners(*theirs);
  if (theirs->width != ours->width || theirs->height != ours->height) {
    fmt::print(stderr, "{}: error: is {}×{}, ours {}×{}\n", argv[2], theirs->width, theirs->height,
               ours->width, ours->height);
    return 1;
  }
  std::size_t different = 0;
  double sum = 0;
  for (std::size_t i = 0; i < ours->pixels.size(); i += 3) {
    float most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float difference = std::fabs(ours->pixels[i + c] - theirs->pixels[i + c]);
      sum += static_cast<double>(difference);
      most = std::fmax(most, difference);
    }
    if (most > kSeen) ++different;
  }
  const double values = static_cast<double>(ours->pixels.size());
  fmt::print("{{\"different\": {:.6f}, \"mean\": {:.6f}}}\n",
             3 * static_cast<double>(different) / values, sum / values);
}
