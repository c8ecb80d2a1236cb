// SPDX-License-Identifier: Apache-2.0
// Files as they come: packed, with line ends of old Macs or in UTF-16, of every format of scenes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <zraka/zraka.hpp>

#include "equal_scenes.hpp"

namespace zraka {
namespace {

namespace fs = std::filesystem;

struct NamedText {
  const char* name;
  std::string text;
};

std::string file(const char* path) {
  std::ifstream stream(std::string(ZRAKA_SOURCE_DIR "/") + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// One of each format.
std::vector<NamedText> texts() {
  return {
      {"a.nff", file("scenes/nff/benzene.nff")},
      {"b.txt", file("scenes/lab/input.txt")},
      {"c.dat", file("scenes/tachyon/water.dat")},
      {"d.gltf", file("scenes/gltf/octahedra.gltf")},
      {"e.xyz", file("docs/examples/caffeine.xyz")},
      {"f.toml", "[[shape]]\nkind = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1  # a comment\n"},
      {"g.obj", "# a comment\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"h.off", "OFF\n# a comment\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"i.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 "
       "1\nendloop\nendfacet\nendsolid\n"},
      {"j.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
       "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 "
       "0\n0 1 0\n3 0 1 2\n"},
      {"k.yml", "# a comment\n- add: camera\n  width: 9\n  height: 9\n- add: sphere\n"},
      {"l.test", "# a comment\nsize 9 9\ncamera 0 0 4 0 0 0 0 1 0 30\nsphere 0 0 0 1\n"}};
}

std::string little(std::uint64_t value, std::size_t bytes) {
  std::string raw(bytes, '\0');
  for (std::size_t i = 0; i < bytes; ++i) raw[i] = static_cast<char>(value >> (8 * i) & 0xFF);
  return raw;
}

/// As gzip's and zstd's formats have what nothing makes smaller.
std::string as_gzip(const std::string& text) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char c : text) {
    crc ^= static_cast<unsigned char>(c);
    for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320 : 0);
  }
  return std::string("\x1F\x8B\x08\0\0\0\0\0\0\x03", 10) + "\1" + little(text.size(), 2) +
         little(~text.size(), 2) + text + little(~crc, 4) + little(text.size(), 4);
}
std::string as_zstd(const std::string& text) {
  return "\x28\xB5\x2F\xFD\xA0" + little(text.size(), 4) + little(text.size() << 3 | 1, 3) + text;
}

std::string as_utf16(const std::string& text, bool big_endian) {
  std::string wide = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) {
    if (big_endian) wide += '\0';
    wide += c;
    if (!big_endian) wide += '\0';
  }
  return wide;
}

/// In a folder that is there as long as the test.
class MessyFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "messy-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  void TearDown() override { fs::remove_all(folder_); }
  Result<ReadScene> read(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return read_scene((folder_ / name).string());
  }
  fs::path folder_;
};

TEST_F(MessyFiles, AreUnpacked) {
  for (const auto& [name, text] : texts()) {
    SCOPED_TRACE(name);
    const Result<ReadScene> plain = read(name, text);
    ASSERT_TRUE(plain) << to_string(plain.error()[0]);
    for (const auto& [ending, bytes] :
         {std::pair(".gz", as_gzip(text)), std::pair(".zst", as_zstd(text))}) {
      const Result<ReadScene> packed = read(std::string(name) + ending, bytes);
      ASSERT_TRUE(packed) << to_string(packed.error()[0]);
      expect_equal(plain->scene, packed->scene);
    }
  }
}

TEST_F(MessyFiles, HaveAnyLineEnds) {
  for (const auto& [name, text] : texts()) {
    SCOPED_TRACE(name);
    const Result<ReadScene> plain = read(name, text);
    std::string old = text, two;
    std::replace(old.begin(), old.end(), '\n', '\r');
    for (const char c : text) two += c == '\n' ? "\r\n" : std::string(1, c);
    const Result<ReadScene> windows = read(name, two);
    ASSERT_TRUE(windows) << to_string(windows.error()[0]);
    expect_equal(plain->scene, windows->scene);
    // The same, or a word about it.
    if (const Result<ReadScene> mac = read(name, old))
      expect_equal(plain->scene, mac->scene);
    else
      EXPECT_FALSE(mac.error()[0].message.empty());
  }
}

TEST_F(MessyFiles, AreNoUtf16) {
  for (const auto& [name, text] : texts())
    for (const bool big_endian : {false, true}) {
      SCOPED_TRACE(name);
      const Result<ReadScene> wide = read(name, as_utf16(text, big_endian));
      ASSERT_FALSE(wide);
      EXPECT_NE(to_string(wide.error()[0]).find("UTF-16"), std::string::npos)
          << to_string(wide.error()[0]);
    }
}

TEST_F(MessyFiles, MayBeginWithAByteOrderMark) {
  for (const auto& [name, text] : texts()) {
    SCOPED_TRACE(name);
    const Result<ReadScene> plain = read(name, text), marked = read(name, "\xEF\xBB\xBF" + text);
    ASSERT_TRUE(marked) << to_string(marked.error()[0]);
    expect_equal(plain->scene, marked->scene);
  }
}

}  // namespace
}  // namespace zraka
