// SPDX-License-Identifier: Apache-2.0
// Reader of the atoms of mmCIF (Westbrook et al., "PDBx/mmCIF Ecosystem", 2022): the loop of the
// category _atom_site, in the syntax of STAR (Hall, 1991).
#include <fmt/format.h>

#include <cmath>

#include "particles/atoms.hpp"
#include "particles/rows.hpp"

namespace zraka {
namespace {

constexpr std::string_view kCategory = "_atom_site.";
constexpr std::size_t kNone = std::string_view::npos;

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

struct Token {
  std::string_view text;  ///< without quotes
  bool quoted = false;
  const char* at = nullptr;
};

class Tokens {
 public:
  explicit Tokens(std::string_view text)
      : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {}

  /// False at the end.
  bool next(Token& token) {
    skip_space();
    token = {{}, false, at_};
    if (at_ == end_) return false;
    if (*at_ == ';' && (at_ == begin_ || at_[-1] == '\n')) return take_field(token);
    if (*at_ == '\'' || *at_ == '"') return take_quoted(token);
    while (at_ != end_ && !is_space(*at_)) ++at_;
    token.text = {token.at, static_cast<std::size_t>(at_ - token.at)};
    return true;
  }

 private:
  void skip_space() {
    for (; at_ != end_; ++at_) {
      if (*at_ == '#') at_ = std::find(at_, end_, '\n');
      if (at_ == end_ || !is_space(*at_)) return;
    }
  }
  /// Up to a line that begins with another ;.
  bool take_field(Token& token) {
    const std::string_view rest(at_ + 1, static_cast<std::size_t>(end_ - at_ - 1));
    const std::size_t size = rest.find("\n;");
    token.text = rest.substr(0, size);
    token.quoted = true;
    at_ = size == kNone ? end_ : at_ + 1 + size + 2;
    return true;
  }
  /// A quote ends only before a space: 'O5'' is O5'.
  bool take_quoted(Token& token) {
    const char quote = *at_++;
    const char* const first = at_;
    while (at_ != end_ && *at_ != '\n' && !(*at_ == quote && (at_ + 1 == end_ || is_space(at_[1]))))
      ++at_;
    token.text = {first, static_cast<std::size_t>(at_ - first)};
    token.quoted = true;
    if (at_ != end_ && *at_ == quote) ++at_;
    return true;
  }

  const char *begin_, *at_, *end_;
};

bool is_word(const Token& token, std::string_view word) {
  return !token.quoted && token.text.size() >= word.size() &&
         std::equal(word.begin(), word.end(), token.text.begin(), [](char a, char b) {
           return a == (b >= 'A' && b <= 'Z' ? static_cast<char>(b + 32) : b);
         });
}
bool is_tag(const Token& token) {
  return !token.quoted && token.text.starts_with('_');
}

class MmcifReader {
 public:
  MmcifReader(std::string_view text, const std::string& name, const ParticleOptions& options)
      : text_(text), tokens_(text), options_(options), problems_(text, name), list_(particles_) {}

  Result<Particles> read() {
    Token token;
    bool more = tokens_.next(token);
    while (more && !problems_.any()) {
      if (is_word(token, "loop_")) {
        more = read_loop(token);
        continue;
      }
      if (is_tag(token)) {
        const std::string_view tag = token.text;
        more = tokens_.next(token);
        if (more && !is_tag(token)) look_at(tag, token);
        if (more && is_tag(token)) continue;
      }
      more = more && tokens_.next(token);
    }
    if (particles_.spheres.empty() && !problems_.any()) say_what_is_missing();
    if (problems_.any()) return problems_.failure();
    particles_.in_angstrom = true;
    return std::move(particles_);
  }

 private:
  void say_what_is_missing() {
    if (in_fractions_)
      problems_.add(text_.data(),
                    "has the atoms of a crystal in parts of its cell, which are not read",
                    "mmCIF and XYZ have them where they are: Open Babel and others convert them");
    else if (options_.frame > 1 && models_ > 0)
      problems_.add(text_.data(),
                    fmt::format("there is no model {}: there are {}", options_.frame, models_));
    else
      problems_.add(text_.data(), "has no atoms: there is no loop of _atom_site");
  }

  void look_at(std::string_view tag, const Token& value) {
    constexpr std::string_view kCell[] = {"_cell.length_a",   "_cell.length_b",
                                          "_cell.length_c",   "_cell.angle_alpha",
                                          "_cell.angle_beta", "_cell.angle_gamma"};
    for (std::size_t i = 0; i < 6; ++i)
      if (tag == kCell[i]) cell_[i] = parse_number(value.text).value_or(0);
    if (tag == kCell[5]) particles_.cell = cell_of(cell_);
  }

  /// Stands behind loop_, and then at what follows it.
  bool read_loop(Token& token) {
    std::vector<std::string_view> tags;
    bool more = false;
    while ((more = tokens_.next(token)) && is_tag(token)) tags.push_back(token.text);
    in_fractions_ = in_fractions_ || (!tags.empty() && tags[0].starts_with("_atom_site_"));
    const bool atoms = !tags.empty() && tags[0].starts_with(kCategory);
    if (atoms && !find_columns(tags)) return false;
    std::vector<Token> row(tags.size());
    std::size_t column = 0;
    for (; more; more = tokens_.next(token)) {
      if (!token.quoted && (is_tag(token) || is_word(token, "loop_") || is_word(token, "data_")))
        break;
      if (!atoms) continue;
      row[column++] = token;
      if (column < row.size()) continue;
      column = 0;
      read_atom(row);
      if (problems_.enough()) return false;
    }
    if (atoms && column != 0)
      problems_.add(row[0].at,
                    fmt::format("the last atom has {} values: expected {}", column, tags.size()));
    return more;
  }

  bool find_columns(const std::vector<std::string_view>& tags) {
    const auto find = [&](std::string_view name) {
      for (std::size_t i = 0; i < tags.size(); ++i)
        if (tags[i].starts_with(kCategory) && tags[i].substr(kCategory.size()) == name) return i;
      return kNone;
    };
    const auto either = [&](std::string_view name, std::string_view other) {
      const std::size_t found = find(name);
      return found != kNone ? found : find(other);
    };
    constexpr std::string_view kPosition[] = {"Cartn_x", "Cartn_y", "Cartn_z"};
    for (std::size_t i = 0; i < 3; ++i) {
      position_[i] = find(kPosition[i]);
      if (position_[i] == kNone) {
        problems_.add(tags[0].data(), fmt::format("_atom_site has no {}", kPosition[i]));
        return false;
      }
    }
    name_ = either("label_atom_id", "auth_atom_id");
    element_ = either("type_symbol", "label_atom_id");
    alternate_ = find("label_alt_id");
    model_ = find("pdbx_PDB_model_num");
    residue_ = either("auth_seq_id", "label_seq_id");
    chain_ = either("auth_asym_id", "label_asym_id");
    if (options_.column.empty()) return true;
    constexpr std::pair<std::string_view, std::string_view> kAliases[] = {
        {"b_factor", "B_iso_or_equiv"}, {"x", "Cartn_x"}, {"y", "Cartn_y"}, {"z", "Cartn_z"}};
    std::string_view wanted = options_.column;
    for (const auto& [alias, name] : kAliases)
      if (wanted == alias) wanted = name;
    value_ = wanted == "residue" ? residue_ : wanted == "chain" ? chain_ : find(wanted);
    if (value_ != kNone) return true;
    std::string all = "b_factor, occupancy, residue, chain";
    for (const std::string_view tag : tags)
      if (tag.starts_with(kCategory) && all.size() < 400)
        all += fmt::format(", {}", shown(tag.substr(kCategory.size())));
    problems_.add(tags[0].data(),
                  fmt::format("has no column '{}': there are {}", shown(options_.column), all));
    return false;
  }

  void read_atom(const std::vector<Token>& row) {
    const auto text = [&](std::size_t column) {
      return column == kNone ? std::string_view() : row[column].text;
    };
    if (model_ != kNone && text(model_) != current_model_) {
      current_model_ = text(model_);
      ++models_;
      if (models_ > options_.frame) particles_.has_more = true;
    }
    if (std::max<std::int64_t>(models_, 1) != options_.frame) return;
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Token& token = row[position_[i]];
      const std::optional<double> number = parse_number(token.text);
      if (!number || !(std::fabs(*number) <= 1e100))
        return problems_.add(token.at, fmt::format("'{}' is not a finite number: expected Cartn_{}",
                                                   shown(token.text), "xyz"[i]));
      numbers[i] = *number;
    }
    const std::string_view alternate = text(alternate_);
    if (!alternate.empty() && alternate != "." && alternate != "?" &&
        !list_.is_first(fmt::format("{} {}", text(chain_), text(residue_)), text(name_)))
      return;
    list_.add(species_of(text(element_)), {numbers[0], numbers[1], numbers[2]});
    if (value_ == kNone) return;
    const std::optional<double> value = parse_number(text(value_));
    particles_.values.push_back(value ? static_cast<float>(*value) : list_.number_of(text(value_)));
  }

  std::string_view text_;
  Tokens tokens_;
  const ParticleOptions& options_;
  TextProblems problems_;
  Particles particles_;
  AtomList list_;
  std::array<std::size_t, 3> position_{};
  std::size_t name_ = kNone, element_ = kNone, alternate_ = kNone, model_ = kNone, residue_ = kNone,
              chain_ = kNone, value_ = kNone;
  std::string_view current_model_;
  std::int64_t models_ = 0;
  std::array<double, 6> cell_{};
  bool in_fractions_ = false;
};

}  // namespace

bool is_mmcif(std::string_view text) {
  Tokens tokens(text.substr(0, 65536));
  Token token;
  return tokens.next(token) && is_word(token, "data_");
}

Result<Particles> parse_mmcif(std::string_view text, const std::string& name,
                              const ParticleOptions& options) {
  return MmcifReader(text, name, options).read();
}

}  // namespace zraka
