// SPDX-License-Identifier: Apache-2.0
// NFF, the Neutral File Format of Eric Haines' Standard Procedural Databases (docs/nff.md): large
// files are cut into blocks, which are read side by side and put together in their order.
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <memory>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "core/handover.hpp"
#include "core/text.hpp"
#include "formats/formats.hpp"
#include "formats/nff_reader.hpp"

namespace zraka {
namespace {

struct Block {
  const char *begin, *end;
  NffReader reader;
  bool shapes_only = false;
  Handover to_reader, from_reader;
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

Result<ReadScene> parse_nff(std::string_view text, const std::string& name, const Passed& passed) {
  constexpr std::size_t kBlock = std::size_t{1} << 20;
  const bool alone =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) < 2;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (!alone && text.size() > 2 * kBlock) return parse_nff_by_blocks(text, name, passed, kBlock);
  NffReader reader(text, name, passed);
  reader.read_to(text.data() + text.size());
  return reader.finish();
}

Result<ReadScene> parse_nff_by_blocks(std::string_view text, const std::string& name,
                                      const Passed& passed, std::size_t size) {
  constexpr std::size_t kBlocksAtOnce = 6;
  const char *next = text.data(), *const end = next + text.size();
  const Passed nobody = [](const char*) {};
  NffReader whole(text, name, passed);
  Handover cutting, joining;
  using Token = std::shared_ptr<Block>;
  const auto cut = [&](tbb::flow_control& flow) -> Token {
    cutting.take();
    if (next == end) {
      flow.stop();
      return nullptr;
    }
    const char* begin = next;
    next = next_block(begin, end, size);
    const std::string_view part(begin, static_cast<std::size_t>(next - begin));
    Token block(new Block{begin, next, NffReader(part, name, nobody), false, {}, {}});
    block->to_reader.give();
    cutting.give();
    return block;
  };
  const auto read = [](const Token& block) {
    block->to_reader.take();
    block->shapes_only = block->reader.read_shapes();
    block->from_reader.give();
    return block;
  };
  // What is no plain block is read again where it stands, so that every problem has its words and
  // its place.
  const auto put_together = [&](const Token& block) {
    block->from_reader.take();
    joining.take();
    const bool taken = block->shapes_only && whole.take(block->reader, block->begin, block->end);
    if (!taken) whole.read_to(block->end);
    joining.give();
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      kBlocksAtOnce, tbb::make_filter<void, Token>(filter_mode::serial_in_order, cut) &
                         tbb::make_filter<Token, Token>(filter_mode::parallel, read) &
                         tbb::make_filter<Token, void>(filter_mode::serial_in_order, put_together));
  joining.take();
#ifdef __GLIBC__
  malloc_trim(0);  // else the blocks' memory waits on the heap while the hierarchy needs it
#endif
  return whole.finish();
}

}  // namespace zraka
