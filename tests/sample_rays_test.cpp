// SPDX-License-Identifier: Apache-2.0
// A sample's ray is the same whether it is made alone or among others, by each instruction set.
#include "render/sample_rays.hpp"

#include <gtest/gtest.h>

#include "render/isa.hpp"
#include "render/workspace.hpp"

namespace zraka {
namespace {

FrozenCamera<float> camera() {
  FrozenCamera<float> camera{};
  camera.kind = CameraKind::pinhole;
  camera.eye = {0.3f, -2, 7};
  camera.first = {-1, 0.6f, -1.7f};
  camera.right = {0.0021f, 0.0001f, 0};
  camera.down = {0, -0.0019f, 0.0003f};
  return camera;
}

constexpr std::int32_t kRays = 300;

std::vector<float> numbers_of(const RayArrays<float>& rays) {
  std::vector<float> all;
  for (const float* column : {rays.ox, rays.oy, rays.oz, rays.dx, rays.dy, rays.dz})
    all.insert(all.end(), column, column + kRays);
  return all;
}

TEST(SampleRays, AreTheSameAloneAndAmongOthers) {
  const FrozenCamera<float> from = camera();
  for (const PixelFilter filter :
       {PixelFilter::box, PixelFilter::tent, PixelFilter::gauss, PixelFilter::mitchell})
    for (const Sampling::Kind kind : {Sampling::Kind::sobol, Sampling::Kind::grid}) {
      Sampling sampling;
      sampling.kind = kind, sampling.filter = filter, sampling.seed = 5;
      sampling.count = kind == Sampling::Kind::grid ? 4 : 16;
      const SampleRays<float> samples(from, {}, sampling, false);
      ASSERT_TRUE(samples.in_batches());
      WorkspaceMemory<float> memory({.batch = kRays, .max_depth = 0});
      Workspace<float>& workspace = memory.workspace();
      std::vector<bool> negative;
      for (std::int32_t i = 0; i < kRays; ++i) {
        const auto made = samples.make(i / 16 * 37, 900 - i / 16,
                                       static_cast<std::uint32_t>(i % 16), workspace, i);
        ASSERT_NE(made, SampleRays<float>::Made::nothing);
        negative.push_back(made == SampleRays<float>::Made::negative_ray);
      }
      const std::vector<float> alone = numbers_of(workspace.levels[0].rays);
      for (const Isa isa : available_isas()) {
        if (isa == Isa::oracle) continue;
        SampleBatch batch(kRays);
        for (std::int32_t i = 0; i < kRays; i += 16)
          samples.add(i / 16 * 37, 900 - i / 16, 0,
                      static_cast<std::uint32_t>(std::min(16, kRays - i)), workspace, batch, i);
        samples.make_all(*kernel_of(isa).services, kRays, workspace, batch);
        EXPECT_EQ(numbers_of(workspace.levels[0].rays), alone)
            << name_of(isa) << ", filter " << static_cast<int>(filter);
        for (std::int32_t i = 0; i < kRays; ++i)
          ASSERT_EQ(batch.negative[static_cast<std::size_t>(i)] != 0,
                    negative[static_cast<std::size_t>(i)])
              << name_of(isa) << ", filter " << static_cast<int>(filter) << ", ray " << i;
      }
    }
}

}  // namespace
}  // namespace zraka
