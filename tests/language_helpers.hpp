// SPDX-License-Identifier: Apache-2.0
// Scenes from texts in the scene language, and what the reader says of them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <zraka/formats.hpp>

#include "equal_scenes.hpp"
#include "formats/formats.hpp"
#include "language/shapes.hpp"

namespace zraka {

inline std::string answer_to(const std::string& text, const ReadOptions& options = {}) {
  const Result<ReadScene> scene = parse_toml(text, "s.toml", options);
  std::string all;
  for (const Diagnostic& d : scene ? scene->warnings : scene.error()) all += to_string(d);
  return all;
}

/// Its first line.
inline std::string first_answer(const std::string& text, const ReadOptions& options = {}) {
  const std::string all = answer_to(text, options);
  return all.substr(0, all.find('\n'));
}

inline Scene scene_of(const std::string& text, const ReadOptions& options = {}) {
  Result<ReadScene> scene = parse_toml(text, "s.toml", options);
  if (!scene) ADD_FAILURE() << answer_to(text, options);
  return scene ? std::move(scene->scene) : Scene{};
}

/// What is read is written, and that reads as the equal scene and is written as the same text.
inline void expect_rewritten(const std::string& text, const ReadOptions& options = {}) {
  const Scene scene = scene_of(text, options);
  const std::string written = write_toml(scene).value();
  SCOPED_TRACE(written);
  const Scene again = scene_of(written, options);
  expect_equal(scene, again);
  EXPECT_EQ(scene.material_names, again.material_names);
  EXPECT_EQ(write_toml(again).value(), written);
}

/// The kinds of shapes that may be members of CSG.
inline std::string closed_kinds() {
  std::string names;
  for (const language::Kind* kind : language::kShapeFamily.kinds)
    if (kind->closed) names += (names.empty() ? "" : ", ") + std::string(kind->name);
  return names;
}

}  // namespace zraka
