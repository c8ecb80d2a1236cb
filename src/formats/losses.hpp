// SPDX-License-Identifier: Apache-2.0
// What a format cannot say of a scene, counted while it is written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>
#include <zraka/diagnostic.hpp>
#include <zraka/scene.hpp>

namespace zraka {

class Losses {
 public:
  void count(std::string_view what, std::uint64_t times);
  /// Where a scene of the format is rendered with other defaults than this one.
  void defaults(const Scene& scene, const RenderDefaults& of_format);
  /// What a material has, that shapes have, beyond Phong's coefficients.
  void material(const Material& material);
  /// What lights have beyond a place and a colour.
  void light(const Light& light);
  /// The lens, the sky and the shade of corners.
  void surroundings(const Scene& scene);
  /// A warning for each kind of loss.
  Diagnostics diagnostics(std::string_view format) const;

 private:
  std::vector<std::pair<std::string, std::uint64_t>> counts_;
};

}  // namespace zraka
