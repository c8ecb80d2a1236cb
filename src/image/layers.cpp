// SPDX-License-Identifier: Apache-2.0
#include <zraka/layers.hpp>

namespace zraka {

std::optional<Layer> layer_named(std::string_view name) {
  for (std::size_t i = 0; i < kLayerNames.size(); ++i)
    if (name == kLayerNames[i]) return static_cast<Layer>(i);
  return std::nullopt;
}

const Channel* Layers::find(std::string_view name) const {
  for (const Channel& channel : channels)
    if (channel.name == name) return &channel;
  return nullptr;
}

const float* Layers::alpha() const {
  const Channel* const channel = find("A");
  return channel == nullptr || channel->floats() == nullptr ? nullptr : channel->floats()->data();
}

}  // namespace zraka
