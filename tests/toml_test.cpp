// SPDX-License-Identifier: Apache-2.0
// TOML: the tree of a text, and the answer to each way of getting it wrong.
#include "language/toml.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "language/fields.hpp"

namespace zraka::toml {
namespace {

/// A tree in one line, to compare: tables in braces, text in quotes.
std::string told(const Node& node) {
  std::string all;
  switch (node.kind) {
    case Node::Kind::table:
      for (const Node& child : node.children)
        all += fmt::format("{}{}:{}", all.empty() ? "" : " ", child.key, told(child));
      return "{" + all + "}";
    case Node::Kind::array:
      for (const Node& child : node.children) all += (all.empty() ? "" : " ") + told(child);
      return "[" + all + "]";
    case Node::Kind::text:
      return fmt::format("'{}'", node.text);
    case Node::Kind::integer:
      return fmt::format("{}", node.integer);
    case Node::Kind::number:
      return fmt::format("{}f", node.number);
    case Node::Kind::boolean:
      return node.truth ? "true" : "false";
  }
  return "";
}

/// The tree, or position and words of every problem.
std::string tree(const std::string& text) {
  const Document document = parse(text);
  std::string problems;
  for (const Problem& p : document.problems)
    problems +=
        fmt::format("{}: {}{}\n", p.position, p.message, p.hint.empty() ? "" : " | " + p.hint);
  return problems.empty() ? told(document.root) : problems;
}

TEST(Toml, HasTablesAndArraysOfTablesByTheirHeaders) {
  EXPECT_EQ(tree("a = 1\n[b]\nc = 2 # comment\n\n[b.d]\ne = 3\n"), "{a:1 b:{c:2 d:{e:3}}}");
  EXPECT_EQ(tree("[[s]]\nk = 1\n[[s]]\n[s.t]\nk = 2\r\n[[s.u]]\n[[s.u]]\nv = 3"),
            "{s:[{k:1} {t:{k:2} u:[{} {v:3}]}]}");
  EXPECT_EQ(tree("[a.b]\n[a]\nc = 1\n"), "{a:{b:{} c:1}}") << "a parent may follow";
  EXPECT_EQ(tree("[ a . \"b c\" ]\n'd.e' = 1\n"), "{a:{b c:{d.e:1}}}");
  EXPECT_EQ(tree("a.b.c = 1\na.b.d = 2\n"), "{a:{b:{c:1 d:2}}}");
  EXPECT_EQ(tree("# only\n\n  # comments"), "{}");
}

TEST(Toml, HasArraysAndInlineTablesOverSeveralLines) {
  EXPECT_EQ(tree("a = [1, [2, 3], # of\n  {b = 1, c.d = 'x'},\n]\n"),
            "{a:[1 [2 3] {b:1 c:{d:'x'}}]}");
  EXPECT_EQ(tree("a = [ ]\nb = {}\n"), "{a:[] b:{}}");
}

TEST(Toml, HasNumbers) {
  EXPECT_EQ(tree("a = +1_000\nb = -0.5e-3\nc = 0xFF\nd = 0o17\ne = 0b101\nf = 1e3\n"),
            "{a:1000 b:-0.0005f c:255 d:15 e:5 f:1000f}");
  EXPECT_EQ(tree("a = inf\nb = -inf\nc = 1e999\n"), "{a:inff b:-inff c:inff}");
  EXPECT_TRUE(std::isnan(parse("a = nan").root.children[0].number));
  EXPECT_TRUE(std::signbit(parse("a = -0.0").root.children[0].number));
  EXPECT_EQ(tree("a = 9223372036854775807\nb = 9223372036854775808\n"),
            "{a:9223372036854775807 b:9.223372036854776e+18f}");
  for (const char* wrong :
       {"01", "1.", ".5", "1e", "1__0", "1_", "0x", "0x_1", "1.e3", "--1", "1.5.2"})
    EXPECT_NE(parse(fmt::format("a = {}", wrong)).problems.size(), 0u) << wrong;
}

TEST(Toml, HasText) {
  EXPECT_EQ(tree(R"(a = "tab\t quote\" \u010D \U0001F600 \\")"), "{a:'tab\t quote\" č 😀 \\'}");
  EXPECT_EQ(tree(R"(a = 'C:\no\escape')"), R"({a:'C:\no\escape'})");
  EXPECT_EQ(tree("a = \"\"\"\nfirst\nsecond \\\n   joined\"\"\"\n"), "{a:'first\nsecond joined'}");
  EXPECT_EQ(tree("a = '''\n'quoted' ''two'' '''''\n"), "{a:''quoted' ''two'' '''}");
  EXPECT_EQ(tree("a = \"\"\nb = ''\n"), "{a:'' b:''}");
}

TEST(Toml, WrittenTextReadsAsItWas) {
  std::string all = "č \" \\ \n \r \t";
  for (char c = 1; c < 0x20; ++c) all += c;
  all += '\x7F';
  const std::string written = "a = " + language::in_quotes(all);
  const Document document = parse(written);
  ASSERT_EQ(document.root.children.size(), 1u);
  EXPECT_EQ(document.root.children[0].text, all);
}

TEST(Toml, SaysEveryProblemAndGoesOnBehindIt) {
  EXPECT_EQ(
      tree("a = glass\nb = 2024-01-02\nc = 3\n= 4\nd = \"open\n[e\nf = 1 2\ng = [1, 2\nh = 3\n"),
      "4: 'glass' is not a value | text stands in quotes: \"…\"\n"
      "14: '2024-01-02' is a date: nothing of a scene is one\n"
      "31: '=' stands here: expected a key\n"
      "39: this text is never closed | expected \" at its end\n"
      "47: the line ends: expected ']'\n"
      "54: '2' stands here: expected the end of the line\n"
      "66: 'h' stands here: expected ',' or ']'\n");
  EXPECT_EQ(
      tree("a = .5\n"),
      "4: '.5' is not a number of TOML | digits stand on both sides of a point, and no 0 before "
      "other digits\n");
  EXPECT_EQ(tree("a = 0,5\n"),
            "5: ',' stands here: expected the end of the line | numbers have a decimal point, and "
            "several stand in brackets: [1, 2, 3]\n");
  EXPECT_EQ(
      tree("a = \"\\q\""),
      "5: this backslash begins nothing that TOML knows | '…' takes backslashes as they are, in "
      "\"…\" they are written twice\n");
  EXPECT_EQ(tree("a = \"\x01\""), "5: a control character stands in a text\n");
  EXPECT_EQ(tree("a = "), "4: the file ends: expected a value\n");
  EXPECT_EQ(tree("a = [1"), "4: this '[' is never closed\n");
  EXPECT_EQ(tree("a = {b = 1"), "4: this '{' is never closed\n");
  EXPECT_EQ(tree("a = {b = 1; c = 2}"), "10: ';' stands here: expected ',' or '}'\n");
  EXPECT_EQ(tree("a = \xFF"), "0: is no text in UTF-8\n");
}

TEST(Toml, RefusesWhatStandsThereTwice) {
  const auto twice = [](const char* name, int position) {
    return fmt::format("{}: '{}' stands here for the second time | the first time was in line 1\n",
                       position, name);
  };
  EXPECT_EQ(tree("a = 1\na = 2\n"), twice("a", 6));
  EXPECT_EQ(tree("[a]\n[a]\n"), twice("a", 5));
  EXPECT_EQ(tree("a = 1\n[a]\n"), twice("a", 7));
  EXPECT_EQ(tree("a = [{}]\n[[a]]\n"), twice("a", 11)) << "an array by value is closed";
  EXPECT_EQ(tree("a = {b = 1}\na.c = 1\n"), twice("a", 12)) << "and so is a table by value";
  EXPECT_EQ(tree("a = {}\n[a.b]\n"), twice("a", 8));
  EXPECT_EQ(tree("a.b = 1\n[a]\n"), twice("a", 9));
  EXPECT_EQ(tree("[[a]]\n[a]\n"), twice("a", 7));
}

TEST(Toml, BoundsHowDeepThingsAre) {
  const std::string deep(100000, '[');
  EXPECT_EQ(tree("a = " + deep), "203: tables and arrays are more than 200 deep in each other\n");
  std::string dots = "a";
  for (int i = 0; i < 100000; ++i) dots += ".a";
  EXPECT_EQ(tree(dots + " = 1"), "0: this key has too many parts\n");
  EXPECT_EQ(tree("[" + dots + "]"), "1: this key has too many parts\n");
}

TEST(Toml, FindsKeysOfLargeTables) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += fmt::format("k{} = {}\n", i, i);
  const Document document = parse(text);
  for (int i = 0; i < 1000; ++i) {
    const Node* const node = document.root.find(fmt::format("k{}", i));
    ASSERT_NE(node, nullptr);
    EXPECT_EQ(node->integer, i);
  }
  EXPECT_EQ(document.root.find("k1000"), nullptr);
  EXPECT_EQ(parse(text + "k7 = 0\n").problems.size(), 1u);
}

}  // namespace
}  // namespace zraka::toml
