// SPDX-License-Identifier: Apache-2.0
// What every field of every table has to answer to each bad value, whatever fields there are; and
// what is derived from the tables besides reading.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "core/json.hpp"
#include "formats/formats.hpp"
#include "language/facts.hpp"
#include "language/help.hpp"
#include "test_folder.hpp"

namespace zraka::language {
namespace {

/// Things that fields may name are there.
std::string answer(const std::string& text) {
  static TestFolder folder("language_tables");
  static const std::string& path =
      folder.with("a.ppm", "P3 2 2 255 0 0 0 0 0 0 0 0 0 0 0 0\n")
          .with("a.xyz", "1\n\nH 0 0 0\n1\n\nH 0 0 1\n")
          .with("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
          .path();
  const Result<ReadScene> read =
      parse_toml(text + "\n[group.any]\nshape = []\n", "s", {.folder = path});
  std::string all;
  for (const Diagnostic& d : read ? read->warnings : read.error()) all += to_string(d);
  return all;
}

std::string good_value(const Field& field, int number);

/// One of the tables that a field may be.
std::string good_table(const Field& field, const Table& table, int number) {
  std::string all = field.about.by_kind ? fmt::format("kind = {}", in_quotes(table.name)) : "";
  for (const Field& inner : table.fields)
    if (inner.key != "texture" || inner.about.required)  // in the place of a file
      all +=
          fmt::format("{}{} = {}", all.empty() ? "" : ", ", inner.key, good_value(inner, ++number));
  return "{" + all + "}";
}

/// A value that is good, another with every number.
std::string good_value(const Field& field, int number) {
  const About& about = field.about;
  const int sign = field.key == "min" ? -1 : 1;  // below max
  const auto vector = [&](int n) {
    return fmt::format("[{}, {}, {}]", sign * n, sign * n * n, sign);
  };
  switch (field.kind) {
    case FieldKind::number:
    case FieldKind::integer:
      if (field.key == "inner_radius") return "0.5";  // less than the other
      if (field.key == "priority") return "-3";
      if (field.key == "start" || field.key == "low") return "-0.5";  // less than its other end
      return std::isfinite(about.range.least) ? text_of(about.range.least + 1) : "1";
    case FieldKind::boolean:
      return "false";
    case FieldKind::vector:
      if (field.key == "focus") return "[20, 0, 0]";  // in front of the eye
      return vector(number);
    case FieldKind::color:
      return "0.5";
    case FieldKind::text:
      return about.unit == Unit::name_of_material ? "\"default\""
             : about.unit == Unit::picture        ? "\"a.ppm\""
             : about.unit == Unit::mesh           ? "\"a.obj\""
             : about.unit == Unit::particles      ? "\"a.xyz\""
             : field.key == "color_by"            ? "\"element\""
             : about.unit == Unit::name_of_glass  ? "\"bk7\""
                                                  : "\"any\"";
    case FieldKind::choice:
      return in_quotes(about.choices[0].name);
    case FieldKind::points: {
      std::string all;
      for (int i = 0; i < static_cast<int>(std::max<std::size_t>(about.fewest, 1)); ++i)
        all += (i > 0 ? ", " : "") + vector(number + i);
      return "[" + all + "]";
    }
    case FieldKind::colors:
      return about.most > 2 ? "[0, [1, 0.5, 0], \"#123456\"]" : "[0.5, \"#123456\"]";
    case FieldKind::integers: {
      std::vector<int> numbers(about.fewest, 7);
      return fmt::format("[{}]", fmt::join(numbers, ", "));
    }
    case FieldKind::numbers: {
      if (field.key == "sellmeier") return "[1, 0.25, 1, 0.0625, 0.02, 100]";
      std::vector<int> numbers(about.fewest, 1);
      return fmt::format("[{}]", fmt::join(numbers, ", "));
    }
    case FieldKind::uvs:
      return "[[0, 0.5], [1, 2], [-3, 4]]";
    case FieldKind::transform:
      return "[{scale = [1, 2, 3]}, {rotate = [0, 1, 0], by_deg = 30}, {translate = [1, 0, 0]}]";
    case FieldKind::texture:
      return "{kind = \"checker\"}";
    case FieldKind::shapes:
      return "[{kind = \"sphere\", center = [0, 0, 0], radius = 1}]";
    case FieldKind::table:
      return good_table(field, *field.tables.front(), number);
  }
  return "";
}

bool needs_something(const Table& table) {
  return std::any_of(table.fields.begin(), table.fields.end(),
                     [](const Field& field) { return field.about.required; });
}

/// Values that are wrong for a field, all that can be derived from what the table says.
std::vector<std::string> bad_values(const Field& field) {
  const Range& range = field.about.range;
  std::vector<std::string> numbers = {"nan", "inf", "-inf"};
  if (std::isfinite(range.least))
    numbers.push_back(text_of(range.above ? range.least : range.least - 1));
  if (std::isfinite(range.most))
    numbers.push_back(text_of(range.below ? range.most : range.most + 1));
  std::vector<std::string> bad = {"true", "\"no such\"", "[]",
                                  "{}",   "[[1]]",       "[\"a\", \"b\", \"c\"]"};
  const auto drop = [&](std::size_t i) { bad.erase(bad.begin() + static_cast<std::ptrdiff_t>(i)); };
  switch (field.kind) {
    case FieldKind::number:
      bad.insert(bad.end(), numbers.begin(), numbers.end());
      break;
    case FieldKind::integer:
      bad.insert(bad.end(), numbers.begin(), numbers.end());
      bad.push_back(text_of(range.least + 0.5));
      bad.push_back("99999999999999999999");
      break;
    case FieldKind::vector:
    case FieldKind::color:
      for (const std::string& number : numbers)
        for (const char* pattern : {"[{}, 0.5, 0.5]", "[0.5, {}, 0.5]", "[0.5, 0.5, {}]"})
          bad.push_back(fmt::format(fmt::runtime(pattern), number));
      bad.push_back("[0.5, 0.5]");
      bad.push_back("[0.5, 0.5, 0.5, 0.5]");
      if (field.about.unit == Unit::direction || field.about.unit == Unit::attenuation)
        bad.push_back("[0, 0, 0]");
      if (field.kind == FieldKind::vector) bad.push_back("1");
      if (field.kind == FieldKind::color)
        bad.insert(bad.end(),
                   {"\"#12345\"", "\"#1234567\"", "\"#12345g\"", "\"#+12345\"", "-1", "inf"});
      break;
    case FieldKind::points: {
      bad.insert(bad.end(), {"1", "[[1, 2, 3]]"});
      std::string points = "[0, 0, inf]";
      for (std::size_t i = 1; i < field.about.fewest; ++i) points += fmt::format(", [{}, 1, 2]", i);
      bad.push_back("[" + points + "]");
      if (field.about.most < 100) {
        std::string many;
        for (std::size_t i = 0; i <= field.about.most; ++i) many += fmt::format("[{}, 1, 2], ", i);
        bad.push_back("[" + many + "]");
      }
      break;
    }
    case FieldKind::colors:
      if (field.about.most == 2) bad.push_back("[1, 1, 1]");
      bad.insert(bad.end(), {"1", "[1]", "[1, [1, 2]]", "[1, [-1, 0, 0]]", "[1, inf]"});
      break;
    case FieldKind::numbers: {
      const std::vector<std::string> few(field.about.fewest - 1, "1"),
          infinite(field.about.fewest, "inf"), many(field.about.fewest + 1, "1");
      for (const auto& values : {few, infinite, many})
        bad.push_back(fmt::format("[{}]", fmt::join(values, ", ")));
      break;
    }
    case FieldKind::integers:
      bad.insert(bad.end(), {"[7]", "[7, 7, 7]", "[7, 7.5]", "[7, 0]", "[7, 99999]", "[7, inf]"});
      break;
    case FieldKind::uvs:
      bad.insert(bad.end(), {"1", "[[0, 0], [1, 0]]", "[[0, 0], [1, 0], [0, 1, 2]]",
                             "[[0, 0], [1, 0], [0, inf]]", "[[0, 0], [1, 0], [0, 1e300]]"});
      break;
    case FieldKind::transform:
      drop(2);  // nothing is moved
      bad.push_back("1");
      break;
    case FieldKind::texture:
      bad.push_back("1");
      break;
    case FieldKind::shapes:
      bad.push_back("1");
      if (field.about.fewest == 0) drop(2);
      break;
    case FieldKind::boolean:
      drop(0);
      bad.insert(bad.end(), {"1", "\"true\""});
      break;
    case FieldKind::text:
      if (field.about.unit != Unit::name_of_material && field.about.unit != Unit::name_of_glass)
        drop(1);
      bad.push_back("1");
      break;
    case FieldKind::choice:
      bad.insert(bad.end(), {"0", "\"\""});
      break;
    case FieldKind::table:
      if (std::none_of(field.tables.begin(), field.tables.end(),
                       [](const Table* table) { return needs_something(*table); }))
        drop(3);
      bad.push_back("1");
      break;
  }
  if (!field.tables.empty()) bad.insert(bad.end(), {"{kind = 1}", "{kind = \"no\"}", "{no = 1}"});
  return bad;
}

/// The opening of a topic, and the lines of all fields that must be there but one.
std::string rest_of(const Topic& topic, const Field& but) {
  std::string text = opening_of(topic);
  int number = 0;
  for (const Table* table : tables_of(topic))
    for (const Field& field : table->fields) {
      ++number;
      const bool needed = field.about.required || field.kind == FieldKind::boolean;
      if (needed && &field != &but)
        text += fmt::format("{} = {}\n", field.key, good_value(field, number));
    }
  return text;
}

void each_field(const auto& function) {
  for (const Topic& topic : topics())
    if (topic.kind != nullptr || topic.section->table != nullptr)
      for (const Table* table : tables_of(topic))
        for (const Field& field : table->fields) function(topic, *table, field);
}

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(LanguageTables, EveryFieldTakesAGoodValue) {
  each_field([](const Topic& topic, const Table&, const Field& field) {
    const auto takes = [&](std::string_view key, const std::string& value) {
      const std::string text = rest_of(topic, field) + fmt::format("{} = {}\n", key, value);
      EXPECT_EQ(answer(text), "") << text;
    };
    takes(field.key, good_value(field, 20));
    if (!field.about.also.empty()) takes(field.about.also, good_value(field, 20));
    for (const Table* table : field.tables) takes(field.key, good_table(field, *table, 20));
  });
}

TEST(LanguageTables, EveryFieldRefusesEveryBadValueAtItsPlace) {
  int tried = 0;
  each_field([&](const Topic& topic, const Table&, const Field& field) {
    const std::string rest = rest_of(topic, field);
    for (const std::string& value : bad_values(field)) {
      const std::string text = fmt::format("{}{} = {}\n", rest, field.key, value);
      const std::string place =
          fmt::format("s:{}:{}: error: ", lines_of(rest) + 1, field.key.size() + 4);
      const std::string words = answer(text);
      // Of what is made of tables the place may be in it, of a texture the words its own.
      const bool inside = !field.tables.empty() || field.kind == FieldKind::transform ||
                          field.kind == FieldKind::shapes;
      const std::string line = fmt::format("s:{}:", lines_of(rest) + 1);
      EXPECT_TRUE(words.starts_with(inside ? line : place)) << text << "says\n" << words;
      const bool is_texture = field.about.textured && value == "{}";
      EXPECT_NE(words.find(is_texture ? "texture" : field.key), std::string::npos) << words;
      EXPECT_NE(words, "") << text;
      ++tried;
    }
  });
  EXPECT_GT(tried, 300) << "the tables have been looked at";
}

TEST(LanguageTables, EveryFieldThatIsRequiredIsMissed) {
  each_field([](const Topic& topic, const Table&, const Field& field) {
    if (!field.about.required) return;
    const std::string words = answer(rest_of(topic, field));
    EXPECT_TRUE(words.starts_with("s:1:1: error: ")) << words;
    EXPECT_NE(words.find(fmt::format(" has no {}: expected {}, {}\n", field.key, field.about.text,
                                     expected_of(field))),
              std::string::npos)
        << words;
  });
}

TEST(LanguageTables, EveryFieldIsSuggestedForASlip) {
  each_field([](const Topic& topic, const Table&, const Field& field) {
    if (field.key.size() < 2) return;  // a, b, c are nearest to each other
    const std::string words = answer(fmt::format("{}{}x = 1\n", rest_of(topic, field), field.key));
    EXPECT_NE(words.find(fmt::format("unknown field '{}x' of ", field.key)), std::string::npos);
    EXPECT_NE(words.find(fmt::format("did you mean '{}'?\n", field.key)), std::string::npos)
        << words;
  });
}

TEST(LanguageTables, AreCompleteAndWithoutDoubles) {
  each_field([](const Topic& topic, const Table& table, const Field& field) {
    EXPECT_FALSE(field.about.text.empty()) << field.key;
    EXPECT_FALSE(field.about.text.ends_with('.')) << field.about.text;
    EXPECT_TRUE(table.text.ends_with('.')) << table.text;
    int same = 0;
    for (const Table* each : tables_of(topic))
      for (const Field& other : each->fields) same += other.key == field.key;
    EXPECT_EQ(same, 1) << field.key;
    EXPECT_EQ(field.kind == FieldKind::choice, !field.about.choices.empty()) << field.key;
    // What a type begins with is in its range.
    if (field.about.required || field.get == nullptr) return;
    const std::string value = text_of(field, field.get(table.defaults()));
    if (value.empty()) return;
    EXPECT_EQ(answer(fmt::format("{}{} = {}\n", rest_of(topic, field), field.key, value)), "");
  });
}

TEST(LanguageTables, ExplainEveryKeyword) {
  std::set<std::string_view> seen;
  for (const std::string_view keyword : keywords()) {
    EXPECT_TRUE(seen.insert(keyword).second) << keyword;
    EXPECT_TRUE(help_on(keyword)) << keyword;
  }
  each_field([](const Topic& topic, const Table& table, const Field& field) {
    const std::string text = help_on(topic.keyword).value_or("");
    EXPECT_NE(text.find("  " + std::string(field.key) + " "), std::string::npos) << text;
    const FieldFacts facts = facts_of(field, table);
    EXPECT_NE(text.find(facts.meaning.substr(0, 20)), std::string::npos) << text;
  });
  EXPECT_EQ(
      help_on("sphere").value_or("").substr(0,
                                            help_on("sphere").value_or("").find("\nsphere light")),
      "sphere: A sphere.\n\n"
      "  [[shape]]\n"
      "  kind = \"sphere\"\n"
      "  center             its centre: [x, y, z], finite numbers; required\n"
      "  radius             its radius: a number greater than 0, in scene units; required\n"
      "  texture_transform  where its textures and uv are moved to before the shape is: a list "
      "of\n"
      "                     steps: {scale = …}, {rotate = [x, y, z], by_deg = …}, {translate = "
      "[x, y,\n"
      "                     z]} or {matrix = [[…], […], […]]}\n"
      "  material   its material; what names none has the material default, or, as a part of a "
      "group or\n"
      "             of CSG, that of the whole: the name of a material, in quotes\n"
      "  name       what explain and influence call it: a text in quotes\n"
      "  transform  where it is moved to, and how it is turned and scaled: a list of steps: "
      "{scale =\n"
      "             …}, {rotate = [x, y, z], by_deg = …}, {translate = [x, y, z]} or {matrix = "
      "[[…],\n"
      "             […], […]]}\n");
  EXPECT_EQ(help_on("shpere"), std::nullopt);
}

TEST(LanguageTables, AreTheReference) {
  for (const Page& page : pages()) {
    std::ifstream file(ZRAKA_SOURCE_DIR "/docs/scene-language/" + page.name);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str(), page.text) << "to write it anew: zraka help --pages docs/scene-language";
  }
}

TEST(LanguageTables, AreASchema) {
  const Result<Json> schema = Json::parse(json_schema(), "schema");
  ASSERT_TRUE(schema) << to_string(schema.error().front());
  const std::string text = json_schema();
  each_field([&](const Topic&, const Table&, const Field& field) {
    EXPECT_NE(text.find(in_quotes(field.key) + ": {"), std::string::npos) << field.key;
  });
}

}  // namespace
}  // namespace zraka::language
