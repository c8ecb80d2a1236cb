// SPDX-License-Identifier: Apache-2.0
// A scene that is ready for many pictures, and pictures in the caller's memory.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <utility>
#include <zraka/renderer.hpp>

#include "core/threads.hpp"
#include "render/isa.hpp"
#include "render/pixel_buffer.hpp"
#include "render/render_prepared.hpp"
#include "scene/freeze_camera.hpp"
#include "scene/view.hpp"

namespace zraka {
namespace {

/// Eyes may be so far from the frame's centre, in its unit, without another build: the shapes reach
/// to 1.
constexpr float kRoom = 8;

/// How far from the frame's centre rays can begin, as the hierarchy's margins take it.
float reach_of(const FrozenCamera<float>& camera) {
  return std::max({std::fabs(camera.eye.x), std::fabs(camera.eye.y), std::fabs(camera.eye.z)}) +
         camera.beyond;
}

/// What was made ready for a view, and for which others it will do.
struct Ready {
  PreparedScene<float> prepared;
  float room = 0;
  double build_seconds = 0;
};

struct Largest {
  double sphere = 0;    ///< radius
  double triangle = 0;  ///< Bounds::reach(), at most
  bool cones = false;
};

Largest largest_of(const Scene& scene) {
  Largest largest;
  for (const Object<Sphere>& sphere : scene.spheres)
    largest.sphere = std::max(largest.sphere, sphere.shape.radius);
  const auto look = [&](const auto& triangles) {
    for (const auto& object : triangles) {
      const auto& t = object.shape;
      for (const Vec3& corner : {t.b, t.c})
        largest.triangle =
            std::max({largest.triangle, 2 * std::fabs(corner.x - t.a.x),
                      2 * std::fabs(corner.y - t.a.y), 2 * std::fabs(corner.z - t.a.z)});
    }
  };
  look(scene.triangles);
  look(scene.smooth_triangles);
  largest.cones = !scene.cones.empty();
  return largest;
}

bool same_profile(const Profile& a, const Profile& b) {
  return a.pixel_centers == b.pixel_centers && a.average_corners == b.average_corners &&
         a.clamp_levels == b.clamp_levels && a.index_is_ratio == b.index_is_ratio &&
         a.mirror_when_total == b.mirror_when_total && a.filter_surfaces == b.filter_surfaces &&
         a.sky_beyond == b.sky_beyond;
}

/// Whether what was frozen in one frame is what would be frozen in the other: the same place and
/// unit, and the same choices by how wide the picture is (has_ground_sphere(), pieces_of()).
bool same_scene(const Frame& a, const Frame& b, const Largest& largest) {
  if (!(a.center == b.center) || a.scale != b.scale || a.reach != b.reach ||
      a.eye_shift != b.eye_shift)
    return false;
  if (a.width_seen == b.width_seen) return true;
  const auto within = [](double size, const Frame& frame) {
    return size <= kMostWidths * frame.width_seen;
  };
  return within(largest.sphere, a) == within(largest.sphere, b) && within(largest.triangle, a) &&
         within(largest.triangle, b) && (!largest.cones || b.width_seen >= a.width_seen);
}

TileOfImage into_buffer(const PixelBuffer& buffer, const RenderOptions& options,
                        const TileDone& tile_done) {
  if (options.transparent) return {};  // alpha comes at the end
  return [&](const Image& image, const TileRect& part) {
    write_pixels(image, part, nullptr, options.profile.transfer, buffer);
    if (tile_done)
      tile_done({static_cast<std::uint32_t>(part.x), static_cast<std::uint32_t>(part.y),
                 static_cast<std::uint32_t>(part.width), static_cast<std::uint32_t>(part.height)});
  };
}

/// Of a picture that has alpha, all at once.
void write_transparent(const Rendering& rendering, const PixelBuffer& buffer,
                       const RenderOptions& options, const TileDone& tile_done) {
  const Image& image = rendering.image;
  write_pixels(
      image,
      {0, 0, static_cast<std::int32_t>(image.width), static_cast<std::int32_t>(image.height)},
      rendering.layers.alpha(), options.profile.transfer, buffer);
  if (tile_done) tile_done({0, 0, image.width, image.height});
}

Diagnostics check_buffer(const PixelBuffer& buffer, const Resolution& size,
                         const RenderOptions& options) {
  return check_buffer(buffer, options.crop ? options.crop->width : size.width,
                      options.crop ? options.crop->height : size.height);
}

/// What work() returns, or why it cannot.
template <class Work>
auto without_exceptions(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return failure("", "not enough memory for this picture");
  } catch (const std::exception& reason) {
    return failure("", fmt::format("internal error: {}", reason.what()));
  }
}

}  // namespace

struct Renderer::Impl {
  mutable std::mutex preparing;  ///< guards what is below, but for options and largest
  mutable Scene scene;
  RenderOptions options;
  Largest largest;
  View own_view;
  mutable std::shared_ptr<const Ready> ready;

  /// The view's own camera in what is ready for it.
  struct ForView {
    std::shared_ptr<const Ready> ready;
    FrozenScene<float> frozen;
    double build_seconds = 0;                ///< 0: nothing was built
    std::unique_ptr<FrozenOptics> optics{};  ///< with the view's fog
  };

  Result<ForView> prepare_for(const View& view, const RenderOptions& wanted) const {
    const std::lock_guard lock(preparing);
    // While it waits for others' parts, this thread must not begin another picture, which would
    // want the same lock.
    std::optional<Result<ForView>> prepared;
    undisturbed([&] { prepared = prepare_alone(view, wanted); });
    return std::move(*prepared);
  }

  Result<ForView> prepare_alone(const View& view, const RenderOptions& wanted) const {
    // The scene's shapes have been looked at.
    Scene empty;
    empty.camera = view.camera;
    empty.resolution = view.resolution;
    if (Diagnostics problems = check_request(ready == nullptr ? scene : empty, wanted);
        !problems.empty())
      return tl::make_unexpected(std::move(problems));
    scene.camera = view.camera;
    scene.resolution = view.resolution;
    if (ready != nullptr) {
      const Frame frame = frame_of(scene);
      if (same_scene(ready->prepared.frame, frame, largest)) {
        const FrozenCamera<float> camera = freeze_camera<float>(scene, options.profile, frame);
        if (reach_of(camera) <= ready->room) {
          ForView found{ready, ready->prepared.store->scene};
          found.frozen.camera = camera;
          if (found.frozen.optics != nullptr) {
            found.optics = std::make_unique<FrozenOptics>(*found.frozen.optics);
            found.optics->fog = freeze_fog(scene, frame);
            found.frozen.optics = found.optics.get();
          }
          return found;
        }
      }
      if (Diagnostics problems = check_request(scene, wanted); !problems.empty())
        return tl::make_unexpected(std::move(problems));
    }
    const auto start = std::chrono::steady_clock::now();
    auto made = std::make_shared<Ready>();
    RenderOptions until_cancelled = options;
    until_cancelled.cancel = wanted.cancel;
    made->prepared = prepare_with_room<float>(scene, until_cancelled, kRoom);
    if (is_cancelled(wanted)) return failure("", "the render was cancelled");
    made->room = reach_of(made->prepared.store->scene.camera);
    made->room = std::max(made->room, kRoom);
    made->build_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ready = made;
    return ForView{made, made->prepared.store->scene, made->build_seconds};
  }

  Result<Rendering> render(const View& view, const RenderOptions& wanted,
                           const TileOfImage& tile_done) const {
    if (!same_profile(wanted.profile, options.profile) ||
        (wanted.shadows == Shadows::transparent) != (options.shadows == Shadows::transparent) ||
        (wanted.min_contribution > 0) != (options.min_contribution > 0))
      return failure("",
                     "the renderer was made for another profile, or other shadows or contributions",
                     "create one with these options, or start from Renderer::options()");
    const Result<Isa> isa = choose_isa(wanted.isa);
    if (!isa) return tl::make_unexpected(isa.error());
    if (*isa == Isa::oracle)
      return failure("", "a renderer has no oracle", "render() asks it for a single picture");
    Result<Rendering> rendering;
    with_threads(wanted.threads, [&] {
      Result<ForView> found = prepare_for(view, wanted);
      if (!found) {
        rendering = tl::make_unexpected(std::move(found.error()));
        return;
      }
      const PreparedScene<float>& prepared = found->ready->prepared;
      RenderStats& stats = rendering->stats;
      stats.isa = *isa;
      stats.threads = threads_for(wanted.threads);
      stats.build_seconds = found->build_seconds;
      stats.scene_bytes = prepared.store->bytes();
      stats.accel_bytes = prepared.hierarchy.nodes.size() * sizeof(Node) +
                          prepared.hierarchy.rank.size() * sizeof(std::int32_t);
      if (!render_prepared(&scene, prepared, found->frozen, kernel_of(*isa), wanted,
                           view.resolution, stats.threads, {}, tile_done, *rendering))
        rendering = failure("", "the render was cancelled");
    });
    return rendering;
  }
};

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create(Scene scene, const RenderOptions& options) {
  return without_exceptions([&]() -> Result<Renderer> {
    auto impl = std::make_unique<Impl>();
    impl->own_view = {scene.camera, scene.resolution};
    impl->scene = std::move(scene);
    impl->options = options;
    impl->largest = largest_of(impl->scene);
    Diagnostics problems;
    with_threads(options.threads, [&] {
      if (const auto found = impl->prepare_for(impl->own_view, options); !found)
        problems = found.error();
    });
    if (!problems.empty()) return tl::make_unexpected(std::move(problems));
    return Renderer(std::move(impl));
  });
}

View Renderer::view() const {
  return impl_->own_view;
}

const RenderOptions& Renderer::options() const {
  return impl_->options;
}

Result<Rendering> Renderer::render(const View& view, const RenderOptions& options) const {
  return without_exceptions([&] { return impl_->render(view, options, {}); });
}

Result<RenderStats> Renderer::render_into(const PixelBuffer& buffer, const View& view,
                                          const RenderOptions& options,
                                          const TileDone& tile_done) const {
  return without_exceptions([&]() -> Result<RenderStats> {
    if (Diagnostics problems = check_buffer(buffer, view.resolution, options); !problems.empty())
      return tl::make_unexpected(std::move(problems));
    const Result<Rendering> rendering =
        impl_->render(view, options, into_buffer(buffer, options, tile_done));
    if (!rendering) return tl::make_unexpected(rendering.error());
    if (options.transparent) write_transparent(*rendering, buffer, options, tile_done);
    return rendering->stats;
  });
}

namespace {

template <class SceneRef>
Result<RenderStats> any_into(const PixelBuffer& buffer, SceneRef&& scene,
                             const RenderOptions& options, const TileDone& tile_done) {
  return without_exceptions([&]() -> Result<RenderStats> {
    if (Diagnostics problems = check_buffer(buffer, scene.resolution, options); !problems.empty())
      return tl::make_unexpected(std::move(problems));
    const Result<Rendering> rendering = render_with_tiles(std::forward<SceneRef>(scene), options,
                                                          into_buffer(buffer, options, tile_done));
    if (!rendering) return tl::make_unexpected(rendering.error());
    if (options.transparent) write_transparent(*rendering, buffer, options, tile_done);
    return rendering->stats;
  });
}

}  // namespace

Result<RenderStats> render_into(const PixelBuffer& buffer, const Scene& scene,
                                const RenderOptions& options, const TileDone& tile_done) {
  return any_into(buffer, scene, options, tile_done);
}

Result<RenderStats> render_into(const PixelBuffer& buffer, Scene&& scene,
                                const RenderOptions& options, const TileDone& tile_done) {
  return any_into(buffer, std::move(scene), options, tile_done);
}

RenderOptions options_of(const RenderDefaults& defaults) {
  RenderOptions options;
  options.profile = profile_of(defaults.profile);
  options.terms.shadows = defaults.shadows != Shadows::off;
  options.max_depth = defaults.max_depth;
  options.shadows = defaults.shadows;
  options.min_contribution = defaults.min_contribution;
  options.wavelengths = defaults.wavelengths;
  options.sampling = defaults.sampling;
  return options;
}

Result<View> view_at(const Vec3& eye, const Vec3& target, Resolution resolution, double fov_deg,
                     const Vec3& up) {
  if (!(fov_deg > 0 && fov_deg < 180))
    return failure(
        "", fmt::format("a field of view of {} degrees: expected more than 0 and less than 180",
                        fov_deg));
  if (resolution.width == 0 || resolution.height == 0)
    return failure("", "the picture has no pixels");
  const std::optional<Camera> camera =
      look_at(eye, target, up, fov_deg, double{1} * resolution.width / resolution.height);
  if (!camera)
    return failure("", "this looks nowhere",
                   "the eye must not be at the target, and up not along the view");
  return View{*camera, resolution};
}

}  // namespace zraka
