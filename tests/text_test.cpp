// SPDX-License-Identifier: Apache-2.0
#include "core/text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <random>
#include <zraka/diagnostic.hpp>

#include "core/base64.hpp"

namespace zraka {
namespace {

TEST(ParseNumber, TakesWhatPeopleWrite) {
  EXPECT_EQ(parse_number("1"), 1);
  EXPECT_EQ(parse_number("-0.5"), -0.5);
  EXPECT_EQ(parse_number("+2"), 2);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("1."), 1);
  EXPECT_EQ(parse_number("1e-3"), 0.001);
}

TEST(ParseNumber, TakesNothingElse) {
  for (const char* text : {"", "-", "+", ".", "abc", "1 2", "1,5", "0x10", "nan", "inf", "-inf",
                           "+-1", "--1", "1e", "1.5f"})
    EXPECT_FALSE(parse_number(text)) << text;
}

TEST(ParseNumber, IsInfiniteOutOfRangeAndZeroForTheTiny) {
  EXPECT_TRUE(std::isinf(*parse_number("1e999")));
  EXPECT_LT(*parse_number("-1e999"), 0);
  EXPECT_EQ(parse_number("1e-999"), 0);
}

TEST(ReadNumber, IsFromChars) {
  std::mt19937 random(1);
  for (int i = 0; i < 200000; ++i) {
    std::string text = random() % 2 ? "-" : "";
    const auto before = random() % 10, behind = random() % 12;
    for (auto d = before * 0; d < before; ++d) text += static_cast<char>('0' + random() % 10);
    if (random() % 4) text += '.';
    for (auto d = behind * 0; d < behind; ++d) text += static_cast<char>('0' + random() % 10);
    if (random() % 8 == 0) text += "e-" + std::to_string(random() % 30);
    text += " #ex.,\n"[random() % 7];
    double got = 0, want = 0;
    const char* stop = read_number(text.data(), text.data() + text.size(), got);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), want);
    ASSERT_EQ(stop, error == std::errc() ? end : nullptr) << text;
    if (stop == nullptr) continue;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(got), std::bit_cast<std::uint64_t>(want)) << text;
  }
}

TEST(TextPositions, CountCharactersOfUtf8) {
  const std::string text = "a\nčć x\r\ny";
  TextPositions places(text);
  EXPECT_EQ(places.at(0).line, 1u);
  const TextPosition x = places.at(text.find('x'));
  EXPECT_EQ(x.line, 2u);
  EXPECT_EQ(x.column, 4u);
  EXPECT_EQ(places.at(text.find('y')).line, 3u);
  EXPECT_EQ(places.at(0).column, 1u) << "going back works too";
}

TEST(TextPositions, CountBytesOfOtherEncodings) {
  const std::string text = "\xE8\xE6 x";  // čć in Latin-2
  EXPECT_EQ(TextPositions(text).at(3).column, 4u);
}

TEST(TextPositions, ShowTheLineWithACaret) {
  EXPECT_EQ(TextPositions("one\n\ttwo, x\nthree").excerpt(10), "\ttwo, x\n\t     ^");
  EXPECT_EQ(TextPositions("čć x").excerpt(5), "čć x\n   ^");
}

TEST(TextPositions, CutLongLinesAndHideControls) {
  const std::string text = std::string(200, 'a') + "X" + std::string(200, 'b') + "\x01";
  const std::string excerpt = TextPositions(text).excerpt(200);
  EXPECT_EQ(excerpt, "…" + std::string(60, 'a') + "X" + std::string(39, 'b') + "…\n" +
                         std::string(61, ' ') + "^");
  EXPECT_EQ(TextPositions("\x01x").excerpt(1), "\uFFFDx\n ^");
}

TEST(Shown, CutsAndCleans) {
  EXPECT_EQ(shown("a\nb\r\nc\rd"), "a\u21B5b\u21B5c\uFFFDd");
  EXPECT_EQ(shown(std::string(100, 'x')), std::string(60, 'x') + "…");
}

TEST(Shown, LeavesNothingThatSteersATerminal) {
  // ESC, DEL, CSI as a C1 control, a right-to-left override, an isolate, a mark, a separator.
  for (const char* control :
       {"\x1b", "\x7f", "\u009b", "\u202e", "\u2066", "\u200f", "\u2028", "\u061c", "\b", "\x9b"}) {
    const std::string text = std::string("a") + control + "b", want = "a\uFFFDb";
    EXPECT_EQ(shown(text), want);
    EXPECT_EQ(shown_line(text), want);
    EXPECT_EQ(shown_text(text + "\n" + text), want + "\n" + want);
    EXPECT_EQ(html_text(text), want);
    EXPECT_EQ(TextPositions(text).excerpt(0), want + "\n^");
  }
  const std::string kept = "čž → “x”\u00A0\u200B\u2030 \u2065 \u206A 😀";
  EXPECT_EQ(shown_line(kept), kept);
  EXPECT_EQ(shown_line("a\tb\nc"), "a\tb↵c");
  EXPECT_EQ(shown_text("a\tb\n\nc\n"), "a\tb\n\nc\n");
  EXPECT_EQ(html_text("<a\n&\"b\">"), "&lt;a\n&amp;&quot;b&quot;&gt;");
}

TEST(Grouped, PutsSpacesBetweenThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1234567), "1 234 567");
}

TEST(Diagnostic, ReadsLikeACompilers) {
  const Diagnostic d{Severity::warning, "a.txt", 3, 7, "something is odd", "mend it", "line\n  ^"};
  EXPECT_EQ(to_string(d), "a.txt:3:7: warning: something is odd\n  line\n    ^\n  mend it\n");
  EXPECT_EQ(to_string({.message = "no"}), "error: no\n");
}

TEST(Diagnostic, IsSafeOnATerminal) {
  EXPECT_EQ(to_string({.file = "a\x1b]0;x\x07\nb.txt",
                       .line = 1,
                       .message = "'\u202e' is odd",
                       .hint = "no \x1b[2J\nbut two lines",
                       .excerpt = "\x1b[31m\n^"}),
            "a\uFFFD]0;x\uFFFD↵b.txt:1: error: '\uFFFD' is odd\n  \uFFFD[31m\n  ^\n"
            "  no \uFFFD[2J\nbut two lines\n");
}

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE\xFD"), "//79");
}

}  // namespace
}  // namespace zraka
