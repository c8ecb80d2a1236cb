// SPDX-License-Identifier: Apache-2.0
// For programs that show pictures themselves: a scene made ready once for many pictures, and
// pictures that go where the caller's memory is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <zraka/api.hpp>
#include <zraka/render.hpp>

namespace zraka {

/// How a caller's picture lies in memory. Its pixels are written from several threads at once, each
/// once; bytes between pixels and between rows are left alone. It has to hold all of the picture.
struct PixelBuffer {
  enum class Type {
    float32,  ///< linear light
    uint8     ///< 0…255, by the profile's transfer curve, as in a PNG of 8 bits
  };
  void* data = nullptr;  ///< the upper left pixel; of any alignment
  Type type = Type::float32;
  int channels = 3;                 ///< 3: RGB, 4: RGBA
  std::ptrdiff_t pixel_stride = 0;  ///< bytes from a pixel to its right neighbour; 0: no gaps
  std::ptrdiff_t row_stride = 0;    ///< bytes from a row to the one below; 0: no gaps
};

/// What of the picture is in the buffer from now on. Called from worker threads, several at once;
/// it must not throw. Where pixels are known only at the end (adaptive samples, averaged corners,
/// transparent pictures), all come at once.
using TileDone = std::function<void(const PixelRect&)>;

/// Where a picture is seen from, and its size.
struct View {
  Camera camera;
  Resolution resolution;
};

/// As look_at of the scene language: a pinhole at `eye` that sees `target` in the middle, `fov_deg`
/// degrees over the picture's height. Fails where the eye is at the target, or `up` along the view.
ZRAKA_API Result<View> view_at(const Vec3& eye, const Vec3& target, Resolution resolution,
                               double fov_deg = 40, const Vec3& up = {0, 1, 0});

/// What a scene says of how it is rendered, as the program takes it where it is told nothing else.
ZRAKA_API RenderOptions options_of(const RenderDefaults& defaults);

/// Renders a scene into the caller's memory, where what is cropped begins at the first pixel. Fails
/// as render() does, and for a buffer that cannot be; what a failed or cancelled render has written
/// until then stays.
ZRAKA_API Result<RenderStats> render_into(const PixelBuffer& buffer, const Scene& scene,
                                          const RenderOptions& options = {},
                                          const TileDone& tile_done = {});
/// The same for a scene that nobody needs any more: its memory is free before the hierarchy's is
/// taken.
ZRAKA_API Result<RenderStats> render_into(const PixelBuffer& buffer, Scene&& scene,
                                          const RenderOptions& options = {},
                                          const TileDone& tile_done = {});

/// A scene that is ready for many pictures: another view costs no build, unless it looks at things
/// so small or so far off that floats need another place for the scene's origin (RenderStats::
/// build_seconds says it). Pictures have the bits that render() gives them. All calls may come
/// from several threads at once. Nothing is printed, no thread is kept, and where options name no
/// number of threads, those of the caller's oneTBB arena do the work.
class ZRAKA_API Renderer {
 public:
  /// Takes the scene. Fails as render() does, and for Isa::oracle.
  static Result<Renderer> create(Scene scene, const RenderOptions& options = {});
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// The scene's own view.
  View view() const;
  /// What create() was given, to change: profile, Shadows::transparent and min_contribution belong
  /// to what was made ready, and a render with others fails.
  const RenderOptions& options() const;

  Result<Rendering> render(const View& view, const RenderOptions& options) const;
  Result<Rendering> render(const View& view) const { return render(view, options()); }
  /// As the function above does.
  Result<RenderStats> render_into(const PixelBuffer& buffer, const View& view,
                                  const RenderOptions& options,
                                  const TileDone& tile_done = {}) const;

 private:
  struct Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace zraka
