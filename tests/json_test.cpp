// SPDX-License-Identifier: Apache-2.0
#include "core/json.hpp"

#include <gtest/gtest.h>

namespace zraka {
namespace {

TEST(JsonText, LeavesNothingThatSteersATerminal) {
  const std::string odd = "č \x1b[31m \x7f \u009b \u061c \u202e \u2066 \uFFFD 😀";
  const Json json = {{"name", odd}};
  const std::string text = json.dump();
  EXPECT_EQ(text, R"({"name":"č \u001b[31m \u007f \u009b \u061c \u202e \u2066 )"
                  "\uFFFD 😀\"}");
  Json read = Json::parse(text, "").value();
  EXPECT_EQ(*read["name"].if_string(), odd) << "and says the same";
}

TEST(JsonText, IsNestedToABound) {
  const auto problem = [](const std::string& text) {
    const Result<Json> json = Json::parse(text, "a.json");
    return json ? std::string("read") : to_string(json.error().front());
  };
  EXPECT_EQ(problem(std::string(64, '[') + std::string(64, ']')), "read");
  EXPECT_EQ(problem(R"(["\\", "\"[[[", [")" + std::string(200, '{') + R"("]])"), "read");
  for (const char* bracket : {"[", "{\"a\":"}) {
    std::string deep = "\n";
    for (int i = 0; i < 100000; ++i) deep += bracket;
    const std::string column = std::to_string(1 + 64 * std::string(bracket).size());
    EXPECT_EQ(problem(deep).substr(0, 60),
              ("a.json:2:" + column + ": error: brackets are nested more than 64 deep\n  ")
                  .substr(0, 60));
  }
}

TEST(Json, SaysThatANumberIsTooLarge) {
  const Result<Json> read = Json::parse("{\"tolerance\": 1e999}", "r.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().front().message, "a number in it is too large");
}

}  // namespace
}  // namespace zraka
