// SPDX-License-Identifier: Apache-2.0
// NFF, the Neutral File Format of Eric Haines' Standard Procedural Databases (docs/nff.md): large
// files are cut into blocks, which are read side by side and put together in their order.

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "core/file.hpp"
#include "core/in_parallel.hpp"
#include "core/text.hpp"
#include "core/threads.hpp"
#include "core/unset_vector.hpp"
#include "formats/formats.hpp"
#include "formats/nff_reader.hpp"

namespace zraka {
namespace {

struct Block {
  UnsetVector<char> memory;  ///< of its text, where that is no part of a larger one
  std::string_view text;
  NffReader reader;
  bool shapes_only = false;
};

/// A line's begin from which on the file can be read for itself: a word of shapes or materials is
/// there, which no other statement goes on with.
bool begins_statement(const char* at, const char* end) {
  const auto is = [&](std::ptrdiff_t i, const char* any) {
    return at + i < end && std::string_view(any).find(at[i]) != std::string_view::npos;
  };
  return (is(0, "scpf") && is(1, " \t")) || (is(0, "p") && is(1, "p") && is(2, " \t"));
}

const char* next_block(const char* at, const char* end, std::size_t size) {
  if (static_cast<std::size_t>(end - at) <= size) return end;
  for (at += size; (at = std::find(at, end, '\n')) != end;)
    if (begins_statement(++at, end)) return at;
  return end;
}

/// The last line's begin within a text from which on the file can be read for itself, else 0.
std::size_t last_begin(std::string_view text) {
  const char* const end = text.data() + text.size();
  for (std::size_t at = text.size(); at > 0;) {
    at = text.rfind('\n', at - 1);
    if (at == std::string_view::npos) return 0;
    if (begins_statement(text.data() + at + 1, end)) return at + 1;
  }
  return 0;
}

bool one_thread() {
  return threads_allowed() < 2;
}

/// Reads blocks side by side, as far as they are shapes. cut() makes the next one, or none after
/// the last; join(block) gets them in their order.
template <class Cut, class Join>
void read_blocks(const Cut& cut, const Join& join) {
  constexpr std::size_t kBlocksAtOnce = 6;
  const auto read = [](void* piece) {
    auto& block = *static_cast<Block*>(piece);
    block.shapes_only = block.reader.read_shapes();
  };
  in_order(
      kBlocksAtOnce, [&] { return WorkPiece(cut()); }, read,
      [&](void* block) { join(*static_cast<Block*>(block)); });
#ifdef __GLIBC__
  malloc_trim(0);  // else the blocks' memory waits on the heap while the hierarchy needs it
#endif
}

}  // namespace

Likeness likeness_to_nff(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::string_view words = trimmed(line);
    if (!words.empty() && words.front() != '#') {
      if (words == "v" || words == "c") return Likeness::sure;
      const std::size_t end = words.find_first_of(" \t");
      if (end == std::string_view::npos) return Likeness::none;
      const std::string_view word = words.substr(0, end), rest = trimmed(words.substr(end));
      if (word == "v" || word == "b" || word == "l" || word == "f") return Likeness::sure;
      const bool shape =
          (word == "s" || word == "p" || word == "pp") &&
          std::string_view("0123456789+-.").find(rest.front()) != std::string_view::npos;
      return shape ? Likeness::sure : Likeness::none;
    }
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return Likeness::none;
}

Result<ReadScene> parse_nff(std::string_view text, const std::string& name,
                    const ReadOptions&) {
  constexpr std::size_t kBlock = std::size_t{1} << 20;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (!one_thread() && text.size() > 2 * kBlock) return parse_nff_by_blocks(text, name, kBlock);
  NffReader reader(text, name, text.size());
  reader.read_to(text.data() + text.size());
  return reader.finish();
}

Result<ReadScene> parse_nff_by_blocks(std::string_view text, const std::string& name,
                                      std::size_t size) {
  const char *next = text.data(), *const end = next + text.size();
  NffReader whole(text, name, text.size());
  const auto cut = [&]() -> std::unique_ptr<Block> {
    if (next == end) return nullptr;
    const char* begin = next;
    next = next_block(begin, end, size);
    const std::string_view part(begin, static_cast<std::size_t>(next - begin));
    return std::unique_ptr<Block>(new Block{{}, part, NffReader(part, name, part.size()), false});
  };
  // What is no plain block is read again where it stands, so that every problem has its words and
  // its place.
  read_blocks(cut, [&](const Block& block) {
    const char *begin = block.text.data(), *after = begin + block.text.size();
    if (!block.shapes_only || !whole.comes_to(begin) || !whole.take(block.reader, after))
      whole.read_to(after);
  });
  return whole.finish();
}

std::optional<ReadScene> read_nff_by_blocks(LargeFile& file, const std::string& name,
                                            std::size_t size) {
  constexpr std::size_t kMostOfBlocks = 64;  // sizes that a block may take until a statement begins
  // Of what was read; and the memory of blocks that are done, for touching new memory takes longer
  // than reading into it.
  UnsetVector<char> left;
  std::vector<UnsetVector<char>> spare;
  std::mutex sparing;
  std::atomic<bool> good = true;
  const auto view = [](const UnsetVector<char>& memory) {
    return std::string_view(memory.data(), memory.size());
  };
  const auto next_text = [&] {
    UnsetVector<char> text;
    if (const std::lock_guard lock(sparing); !spare.empty()) {
      text = std::move(spare.back());
      spare.pop_back();
    }
    text.assign(left.begin(), left.end());
    left.clear();
    for (std::size_t begin = 0; begin == 0 && text.size() < kMostOfBlocks * size;) {
      const std::size_t before = text.size();
      text.resize(before + size);
      text.resize(before + file.read(text.data() + before, size));
      if (text.size() < before + size) return text;
      begin = last_begin(view(text));
      if (begin == 0) continue;
      left.assign(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end());
      text.resize(begin);
    }
    return text;
  };

  const UnsetVector<char> memory = next_text();
  std::string_view beginning = view(memory);
  if (beginning.starts_with(kByteOrderMark)) beginning.remove_prefix(kByteOrderMark.size());
  NffReader whole(beginning, name, file.size());
  whole.read_to(beginning.data() + beginning.size());
  const auto cut = [&]() -> std::unique_ptr<Block> {
    UnsetVector<char> text = next_text();
    if (text.empty() || !good) return nullptr;
    const std::string_view part = view(text);  // stays where it is when its vector is moved
    return std::unique_ptr<Block>(
        new Block{std::move(text), part, NffReader(part, name, part.size()), false});
  };
  read_blocks(cut, [&](Block& block) {
    if (!block.shapes_only || !whole.take(block.reader)) good = false;
    const std::lock_guard lock(sparing);
    spare.push_back(std::move(block.memory));
  });
  if (!good || file.shortened() || !whole.says_nothing()) return {};
  Result<ReadScene> read = whole.finish();
  if (!read || !read->warnings.empty()) return {};
  return std::move(*read);
}

}  // namespace zraka
