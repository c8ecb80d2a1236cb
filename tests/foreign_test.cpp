// SPDX-License-Identifier: Apache-2.0
// Files of other programs are named, not mistaken for broken scenes.
#include "formats/foreign.hpp"

#include <gtest/gtest.h>

#include <zraka/formats.hpp>

namespace zraka {
namespace {

std::string refusal(std::string_view text) {
  const Result<ReadScene> read = parse_scene(text, "file");
  return read ? "it is read" : read.error().front().message;
}

TEST(ForeignFormats, AreNamed) {
  constexpr std::pair<std::string_view, std::string_view> kFiles[] = {
      {"// a scene\n#include \"colors.inc\"\n", "a POV-Ray scene"},
      {"#version 3.7;\nglobal_settings { assumed_gamma 1 }\n", "a POV-Ray scene"},
      {"\x89PNG\r\n", "a PNG picture"},
      {"\xFF\xD8\xFF\xE0", "a JPEG picture"},
      {"PK\x03\x04", "a ZIP archive"},
      {"%PDF-1.7\n", "a PDF document"}};
  for (const auto& [text, name] : kFiles)
    EXPECT_EQ(refusal(text), "is " + std::string(name) + ", which cannot be read yet");
}

TEST(ForeignFormats, AreNamedBehindAByteOrderMark) {
  EXPECT_EQ(refusal("\xEF\xBB\xBF#version 3.7;\n"),
            "is a POV-Ray scene, which cannot be read yet");
}

TEST(ForeignFormats, AreNotSeenInCommentsOfNff) {
  EXPECT_EQ(refusal("#include \"colors.inc\"\nv\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 45\n"
                    "hither 1\nresolution 8 8\nf 1 1 1 1 0 1 0 1\ns 0 0 0 0.1\n"),
            "it is read");
}

TEST(ForeignFormats, AreNoScenesOfOurs) {
  for (const std::string_view text :
       {"v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 8 8\n",
        "oko: 0,0,2:2:400:0,2,-2:0", "3,0,2:2:400:0,2,-2:0", "3\n,0,2:2:400\n:0,2,-2:0",
        "# text\ns 0 0 0 1\n", ""})
    EXPECT_EQ(foreign_format_of(text).english, "") << text;
}

}  // namespace
}  // namespace zraka
