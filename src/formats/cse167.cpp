// SPDX-License-Identifier: Apache-2.0
// Scenes of UCSD's course CSE 167x (.test): a command a line, transforms on a stack, materials as
// they are when a shape comes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/take_word.hpp"
#include "core/text.hpp"
#include "formats/formats.hpp"
#include "formats/placed_shapes.hpp"
#include "formats/vectors.hpp"
#include "language/transforms.hpp"
#include "scene/bounds_of.hpp"
#include "scene/view.hpp"

namespace zraka {
namespace {

class Cse167Reader {
 public:
  Cse167Reader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<ReadScene> read();

 private:
  using Numbers = std::array<double, 10>;
  struct Command {
    std::string_view word;
    std::size_t numbers;
    void (Cse167Reader::*run)(const Numbers& n);
  };
  static const Command* command_of(std::string_view word);

  void read_line(std::string_view line);
  void set_size(const Numbers& n);
  void set_depth(const Numbers& n);
  void set_camera(const Numbers& n);
  void add_sphere(const Numbers& n);
  void add_vertex(const Numbers& n) { vertices_.push_back({n[0], n[1], n[2]}); }
  void add_vertex_normal(const Numbers& n);
  void add_triangle(const Numbers& n);
  void add_smooth_triangle(const Numbers& n);
  void translate(const Numbers& n) { apply({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {n[0], n[1], n[2]}}); }
  void scale(const Numbers& n) { apply({{n[0], 0, 0}, {0, n[1], 0}, {0, 0, n[2]}, {}}); }
  void rotate(const Numbers& n);
  void push(const Numbers&);
  void pop(const Numbers&);
  void add_directional(const Numbers& n);
  void add_point(const Numbers& n);
  void set_attenuation(const Numbers& n);
  void set_ambient(const Numbers& n) { ambient_ = color(n), has_material_ = false; }
  void set_diffuse(const Numbers& n) { material_.diffuse = color(n), has_material_ = false; }
  void set_specular(const Numbers& n) { material_.specular = color(n), has_material_ = false; }
  void set_emission(const Numbers& n) { emission_ = color(n), has_material_ = false; }
  void set_shininess(const Numbers& n);
  void ignore(const Numbers&) {}

  static Color color(const Numbers& n) {
    return {std::max(n[0], 0.0), std::max(n[1], 0.0), std::max(n[2], 0.0)};
  }
  /// The last step of a stack is the first that a point goes through.
  void apply(const Transform& step) { stack_.back() = then(step, stack_.back()); }
  std::uint32_t material();
  bool may_place();
  template <class Point>
  bool corners(const Numbers& n, const std::vector<Point>& of, std::array<Point, 3>& found);
  void fail(std::string message) {
    constexpr std::size_t kEnough = 100;
    if (errors_.size() < kEnough)
      errors_.push_back({.file = name_, .line = line_, .message = std::move(message)});
  }
  void warn(std::string message) {
    for (const Diagnostic& said : read_.warnings)
      if (said.message == message) return;
    read_.warnings.push_back({.severity = Severity::warning,
                              .file = name_,
                              .line = line_,
                              .message = std::move(message)});
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t line_ = 0;
  ReadScene read_;
  Scene& scene_ = read_.scene;
  PlacedShapes shapes_{scene_};
  Diagnostics errors_;
  std::vector<Transform> stack_{Transform{}};
  std::vector<Vec3> vertices_;
  std::vector<std::array<Vec3, 2>> normal_vertices_;
  std::optional<Numbers> camera_;
  Vec3 attenuation_{1, 0, 0};
  Color ambient_{0.2, 0.2, 0.2}, emission_{};
  Material material_{.diffuse = {}, .shininess = 1, .highlight = Highlight::blinn};
  bool has_material_ = false;
  std::size_t current_ = 0;
};

const Cse167Reader::Command* Cse167Reader::command_of(std::string_view word) {
  using Self = Cse167Reader;
  static constexpr Command kCommands[] = {
      {"vertex", 3, &Self::add_vertex},
      {"tri", 3, &Self::add_triangle},
      {"sphere", 4, &Self::add_sphere},
      {"vertexnormal", 6, &Self::add_vertex_normal},
      {"trinormal", 3, &Self::add_smooth_triangle},
      {"translate", 3, &Self::translate},
      {"scale", 3, &Self::scale},
      {"rotate", 4, &Self::rotate},
      {"pushTransform", 0, &Self::push},
      {"popTransform", 0, &Self::pop},
      {"ambient", 3, &Self::set_ambient},
      {"diffuse", 3, &Self::set_diffuse},
      {"specular", 3, &Self::set_specular},
      {"shininess", 1, &Self::set_shininess},
      {"emission", 3, &Self::set_emission},
      {"size", 2, &Self::set_size},
      {"maxdepth", 1, &Self::set_depth},
      {"camera", 10, &Self::set_camera},
      {"directional", 6, &Self::add_directional},
      {"point", 6, &Self::add_point},
      {"attenuation", 3, &Self::set_attenuation},
      {"maxverts", 1, &Self::ignore},
      {"maxvertnorms", 1, &Self::ignore},
      {"output", 0, &Self::ignore},
  };
  for (const Command& command : kCommands)
    if (command.word == word) return &command;
  return nullptr;
}

void Cse167Reader::read_line(std::string_view line) {
  const std::string_view word = take_word(line);
  if (word.empty() || word.starts_with('#')) return;
  const Command* const command = command_of(word);
  if (command == nullptr)
    return warn(fmt::format("'{}' is no command of these scenes: it is left out", shown(word)));
  Numbers numbers{};
  for (std::size_t i = 0; i < command->numbers; ++i) {
    const std::string_view digits = take_word(line);
    const std::optional<double> value = parse_number(digits);
    if (!value || !std::isfinite(*value))
      return fail(digits.empty()
                      ? fmt::format("{} has {} numbers: expected {}", word, i, command->numbers)
                      : fmt::format("'{}' is not a finite number: expected number {} of "
                                    "{} of {}",
                                    shown(digits), i + 1, command->numbers, word));
    numbers[i] = *value;
  }
  (this->*command->run)(numbers);
}

void Cse167Reader::set_size(const Numbers& n) {
  if (!(n[0] >= 1 && n[1] >= 1) || n[0] != std::floor(n[0]) || n[1] != std::floor(n[1]) ||
      n[0] * n[1] > static_cast<double>(kMaxPixels))
    return fail(
        fmt::format("size is {} {}: expected whole numbers, 1 or more, of at most {} pixels", n[0],
                    n[1], kMaxPixels));
  scene_.resolution = {static_cast<std::uint32_t>(n[0]), static_cast<std::uint32_t>(n[1])};
}

void Cse167Reader::set_depth(const Numbers& n) {
  scene_.defaults.max_depth =
      static_cast<int>(std::clamp(n[0], 0.0, static_cast<double>(kMaxDepth)));
}

void Cse167Reader::set_camera(const Numbers& n) {
  if (!(n[9] > 0 && n[9] < 180))
    return fail(fmt::format("the camera's angle is {}: expected degrees between 0 and 180", n[9]));
  if (!look_at({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, n[9], 1))
    return fail("the camera is where it looks at, or its up is along the view");
  camera_ = n;
}

void Cse167Reader::rotate(const Numbers& n) {
  const Vec3 axis{n[0], n[1], n[2]};
  if (axis == Vec3{}) return fail("the axis of rotate is 0 0 0");
  apply(language::rotation(axis, n[3]));
}

void Cse167Reader::push(const Numbers&) {
  constexpr std::size_t kMostPushed = 1000;
  if (stack_.size() >= kMostPushed)
    return fail(fmt::format("more than {} transforms are pushed", kMostPushed));
  stack_.push_back(stack_.back());
}

void Cse167Reader::pop(const Numbers&) {
  if (stack_.size() > 1)
    stack_.pop_back();
  else
    warn("popTransform without a pushTransform is left out");
}

void Cse167Reader::add_directional(const Numbers& n) {
  const Vec3 to_light{n[0], n[1], n[2]};
  if (to_light == Vec3{}) return fail("the direction of a light is 0 0 0");
  Light light;
  light.kind = LightKind::directional;
  light.direction = to_light * -1;
  light.color = {n[3], n[4], n[5]};
  scene_.lights.push_back(light);
}

void Cse167Reader::add_point(const Numbers& n) {
  scene_.lights.push_back(
      {.position = {n[0], n[1], n[2]}, .color = {n[3], n[4], n[5]}, .attenuation = attenuation_});
}

void Cse167Reader::set_attenuation(const Numbers& n) {
  if (n[0] < 0 || n[1] < 0 || n[2] < 0 || !(n[0] + n[1] + n[2] > 0))
    return fail("attenuation wants three numbers of 0 or more, not all 0");
  attenuation_ = {n[0], n[1], n[2]};
}

void Cse167Reader::set_shininess(const Numbers& n) {
  material_.shininess = std::max(n[0], 0.0);
  has_material_ = false;
}

/// (ambient + emission) + Σ light·(diffuse·N·L + specular·(N·H)^n) + specular·mirrored.
std::uint32_t Cse167Reader::material() {
  if (!has_material_) {
    Material m = material_;
    m.ambient = {ambient_.r + emission_.r, ambient_.g + emission_.g, ambient_.b + emission_.b};
    m.reflection = m.specular;
    // Those who write such scenes say the same again and again.
    constexpr std::size_t kLookBack = 16;
    std::size_t i = scene_.materials.size();
    const std::size_t first = i > kLookBack ? i - kLookBack : 0;
    while (i > first && scene_.materials[i - 1] != m) --i;
    if (i == first) scene_.materials.push_back(m), i = scene_.materials.size();
    current_ = i - 1;
    has_material_ = true;
  }
  return static_cast<std::uint32_t>(current_);
}

bool Cse167Reader::may_place() {
  if (inverse(stack_.back())) return true;
  warn("shapes that a transform makes flat are left out");
  return false;
}

void Cse167Reader::add_sphere(const Numbers& n) {
  if (!(n[3] > 0))
    return fail(fmt::format("the radius of a sphere is {}: expected more than 0", n[3]));
  if (may_place()) shapes_.add_sphere({n[0], n[1], n[2]}, n[3], material(), stack_.back());
}

void Cse167Reader::add_vertex_normal(const Numbers& n) {
  normal_vertices_.push_back({Vec3{n[0], n[1], n[2]}, Vec3{n[3], n[4], n[5]}});
}

template <class Point>
bool Cse167Reader::corners(const Numbers& n, const std::vector<Point>& of,
                           std::array<Point, 3>& found) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(n[i] >= 0) || n[i] != std::floor(n[i]) || !(n[i] < static_cast<double>(of.size())))
      return fail(fmt::format("vertex {} is not there: so far there are {}", n[i], of.size())),
             false;
    found[i] = of[static_cast<std::size_t>(n[i])];
  }
  return true;
}

void Cse167Reader::add_triangle(const Numbers& n) {
  std::array<Vec3, 3> p;
  if (corners(n, vertices_, p) && may_place())
    shapes_.add_triangle(Triangle{p[0], p[1], p[2]}, material(), stack_.back());
}

void Cse167Reader::add_smooth_triangle(const Numbers& n) {
  std::array<std::array<Vec3, 2>, 3> p;
  if (corners(n, normal_vertices_, p) && may_place())
    shapes_.add_triangle(SmoothTriangle{p[0][0], p[1][0], p[2][0], p[0][1], p[1][1], p[2][1]},
                         material(), stack_.back());
}

Result<ReadScene> Cse167Reader::read() {
  scene_.defaults = {.profile = ProfileName::tachyon, .max_depth = 5};
  scene_.ambient_light = {1, 1, 1};
  while (!text_.empty()) {
    const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
    const std::string_view line = text_.substr(0, end);
    const bool is_pair = text_.substr(end, 2) == "\r\n";
    text_.remove_prefix(std::min(end + (is_pair ? 2 : 1), text_.size()));
    ++line_;
    read_line(line);
  }
  line_ = 0;
  if (camera_) {
    const Numbers& n = *camera_;
    scene_.camera =
        *look_at({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, n[9],
                 static_cast<double>(scene_.resolution.width) / scene_.resolution.height);
  } else if (errors_.empty()) {
    fail("the scene has no camera: expected camera with ten numbers");
  }
  if (!errors_.empty()) return tl::make_unexpected(std::move(errors_));
  return std::move(read_);
}

}  // namespace

Likeness likeness_to_cse167(std::string_view text) {
  constexpr int kMostLines = 200;
  for (int i = 0; i < kMostLines && !text.empty(); ++i) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string_view word = take_word(line);
    if (word.empty() || word.starts_with('#')) continue;
    const int numbers = word == "size" ? 2 : word == "camera" ? 10 : word == "maxdepth" ? 1 : 0;
    for (int k = 0; k < numbers; ++k)
      if (!parse_number(take_word(line))) return Likeness::none;
    return numbers > 0 ? Likeness::sure : Likeness::none;
  }
  return Likeness::none;
}

Result<ReadScene> parse_cse167(std::string_view text, const std::string& name, const ReadOptions&) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return Cse167Reader(text, name).read();
}

}  // namespace zraka
