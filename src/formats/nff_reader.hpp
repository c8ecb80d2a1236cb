// SPDX-License-Identifier: Apache-2.0
// Reads NFF statement by statement, all of a text or a block of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/text.hpp"
#include "formats/formats.hpp"

namespace zraka {

class NffReader {
 public:
  /// `whole` is the size of the file that the text is the beginning of.
  NffReader(std::string_view text, const std::string& name, std::uint64_t whole)
      : at_(text.data()),
        end_(at_ + text.size()),
        text_(text),
        name_(name),
        places_(text),
        whole_(whole) {}

  /// Reads the statements that begin before `stop`, on to the end of the last of them.
  void read_to(const char* stop);
  /// Reads the text as a block of shapes and materials that follows upon others. False if it has
  /// anything else in it, a problem among that.
  bool read_shapes();
  /// Takes over what a block holds that follows upon what was read so far, and whose read_shapes()
  /// was true. This reader goes on at `after`, unless the block is no part of its text. False if
  /// no material precedes the block.
  bool take(const NffReader& block, const char* after = nullptr);
  /// Whether nothing but space is left before `place`; goes there.
  bool comes_to(const char* place);
  /// Whether nothing was found that one would have to be told.
  bool says_nothing() const { return errors_.empty() && warnings_.empty(); }
  bool has_enough() const { return errors_.size() >= kEnoughErrors; }
  Result<ReadScene> finish();

 private:
  /// A file with more problems than this is something else than NFF.
  static constexpr std::size_t kEnoughErrors = 100;

  using Row = std::array<double, 8>;
  struct RowHash {
    std::size_t operator()(const Row& row) const {
      std::size_t hash = 0;
      for (const double v : row) hash = hash * 1099511628211u ^ std::hash<double>()(v);
      return hash;
    }
  };

  void add(Severity severity, const char* at, std::string message, std::string hint = {});
  void warn_once(bool& said, const char* at, std::string message);
  bool fail(const char* at, std::string message, std::string hint = {}) {
    add(Severity::error, at, std::move(message), std::move(hint));
    return false;
  }
  void skip_space();
  std::string_view word_at(const char* at) const;
  bool number(double& value, const char* what);
  bool vector(Vec3& v, const char* what);
  bool number_on_line();
  bool read_entity(std::string_view word);
  bool read_view();
  bool read_light();
  bool read_material();
  bool read_sphere();
  bool read_cone();
  bool read_polygon(bool with_normals);
  void look_ahead();
  void set_scene_up();
  std::uint32_t material_of(const Row& row);

  const char *at_, *end_;
  std::string_view text_;
  std::string name_;
  TextPositions places_;
  std::uint64_t whole_, taken_ = 0, looked_ahead_ = 0;  ///< bytes
  Scene scene_;
  Diagnostics errors_, warnings_;
  bool viewed_ = false, view_failed_ = false;
  bool inside_out_said_ = false, too_bright_said_ = false;
  bool has_globals_ = false;  ///< a view, a background or a light
  std::vector<std::size_t> plain_lights_;
  Vec3 from_, to_, up_;
  double angle_ = 45;
  std::optional<std::uint32_t> material_;
  std::unordered_map<Row, std::uint32_t, RowHash> materials_;
  std::vector<Row> rows_;  ///< of the materials, in their order
};

}  // namespace zraka
