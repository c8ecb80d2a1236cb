// SPDX-License-Identifier: Apache-2.0
// What another program does with the installed library: spheres from an array, two pictures at
// once, one cancelled, and an error that is a value.
#include <atomic>
#include <cstdio>
#include <thread>
#include <vector>
#include <zraka/zraka.hpp>

int main() {
  std::vector<float> points;
  for (unsigned i = 0, random = 1; i < 300000; ++i, random = random * 1664525u + 1013904223u)
    points.push_back(static_cast<float>(random >> 8) / 8388608 - 1);
  zraka::Scene scene;
  scene.lights = {{.position = {2, 4, 3}}};
  scene.materials = {{.diffuse = {0.8, 0.3, 0.1}}};
  zraka::SphereArrays spheres;
  spheres.centers = {points.data(), points.size() / 3};
  spheres.radius = 0.01;
  if (!zraka::add_spheres(scene, spheres)) return 1;
  const auto renderer = zraka::Renderer::create(std::move(scene));
  if (!renderer) return 2;

  const auto draw = [&](double x, zraka::Image& image) {
    const auto view = zraka::view_at({x, 1, 4}, {0, 0, 0}, {64, 48});
    image = zraka::Image(64, 48);
    return renderer->render_into({.data = image.pixels.data()}, *view, renderer->options())
        .has_value();
  };
  zraka::Image left, right, again;
  bool other_is_good = false;
  std::thread other([&] { other_is_good = draw(-1, left); });
  const bool good = draw(1, right);
  other.join();
  if (!good || !other_is_good || !draw(-1, again) || again.pixels != left.pixels) return 3;

  const std::atomic<bool> stop{true};
  zraka::RenderOptions options = renderer->options();
  options.cancel = &stop;
  const auto cancelled = renderer->render(renderer->view(), options);
  if (cancelled) return 4;
  spheres.radius = -1;
  zraka::Scene other_scene;
  other_scene.materials.resize(1);
  const auto refused = zraka::add_spheres(other_scene, spheres);
  if (refused) return 5;
  std::printf("%s\n%s\n%s", zraka::sha256(right).c_str(), cancelled.error()[0].message.c_str(),
              zraka::to_string(refused.error()[0]).c_str());
}
