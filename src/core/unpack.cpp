// SPDX-License-Identifier: Apache-2.0
#include "core/unpack.hpp"

#include <fmt/format.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <memory>

namespace zraka {
namespace {

constexpr std::string_view kGzip = "\x1F\x8B", kZstd = "\x28\xB5\x2F\xFD";
constexpr std::size_t kBuffer = std::size_t{1} << 18;
constexpr int kGzipWindow = 15 + 16, kRawWindow = -15;

std::uint64_t most_of(std::string_view bytes) {
  return std::max<std::uint64_t>(std::uint64_t{1} << 26, 20 * std::uint64_t{bytes.size()});
}

tl::unexpected<Diagnostics> too_large(const std::string& name, std::uint64_t most) {
  return failure(name, fmt::format("becomes more than {} bytes when it is unpacked", most),
                 "unpack it first if that is right");
}
tl::unexpected<Diagnostics> damaged(const std::string& name, const char* packer) {
  return failure(name, fmt::format("is damaged or cut off: {} cannot unpack it", packer));
}

/// Streams one after the other, as gzip allows.
Result<std::string> inflate_all(std::string_view bytes, int window, std::uint64_t most,
                                const std::string& name) {
  const char* const packer = window == kRawWindow ? "deflate" : "gzip";
  z_stream stream{};
  if (inflateInit2(&stream, window) != Z_OK) return damaged(name, packer);
  const std::unique_ptr<z_stream, int (*)(z_stream*)> ending(&stream, inflateEnd);
  std::string all;
  std::size_t given = 0;
  const auto buffer = std::make_unique<Bytef[]>(kBuffer);
  for (;;) {
    if (stream.avail_in == 0) {
      const std::size_t part = std::min<std::size_t>(bytes.size() - given, std::size_t{1} << 30);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + given));
      stream.avail_in = static_cast<uInt>(part);
      given += part;
    }
    stream.next_out = buffer.get();
    stream.avail_out = static_cast<uInt>(kBuffer);
    const int status = inflate(&stream, Z_NO_FLUSH);
    const std::size_t got = kBuffer - stream.avail_out;
    all.append(reinterpret_cast<const char*>(buffer.get()), got);
    if (all.size() > most) return too_large(name, most);
    if (status == Z_STREAM_END) {
      const bool more = window == kGzipWindow && stream.avail_in >= kGzip.size() &&
                        stream.next_in[0] == 0x1F && stream.next_in[1] == 0x8B;
      if (!more) return all;
      inflateReset(&stream);
    } else if (status != Z_OK || (stream.avail_in == 0 && given == bytes.size() && got == 0)) {
      return damaged(name, packer);
    }
  }
}

Result<std::string> unpack_zstd(std::string_view bytes, const std::string& name) {
  const std::uint64_t most = most_of(bytes);
  const std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream(ZSTD_createDStream(),
                                                                             ZSTD_freeDStream);
  if (stream == nullptr) return damaged(name, "zstd");
  std::string all;
  const auto buffer = std::make_unique<char[]>(kBuffer);
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  for (;;) {
    ZSTD_outBuffer out{buffer.get(), kBuffer, 0};
    const std::size_t left = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(left) != 0) return damaged(name, "zstd");
    all.append(buffer.get(), out.pos);
    if (all.size() > most) return too_large(name, most);
    if (in.pos < in.size || out.pos == out.size) continue;
    if (left != 0) return damaged(name, "zstd");
    return all;
  }
}

}  // namespace

bool is_packed(std::string_view bytes) {
  return bytes.starts_with(kGzip) || bytes.starts_with(kZstd);
}

Result<std::string> unpacked(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with(kZstd)) return unpack_zstd(bytes, name);
  return inflate_all(bytes, kGzipWindow, most_of(bytes), name);
}

Result<std::string> inflated(std::string_view bytes, std::uint64_t size, const std::string& name) {
  Result<std::string> all = inflate_all(bytes, kRawWindow, size, name);
  if (all && all->size() != size) return damaged(name, "deflate");
  return all;
}

std::uint64_t inflated_size(std::string_view bytes, std::uint64_t most) {
  z_stream stream{};
  if (::inflateInit(&stream) != Z_OK) return 0;
  std::array<unsigned char, 1 << 16> part{};
  stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<unsigned>(bytes.size());
  std::uint64_t size = 0;
  for (int code = Z_OK; code == Z_OK && size <= most;) {
    stream.next_out = part.data();
    stream.avail_out = part.size();
    code = ::inflate(&stream, Z_NO_FLUSH);
    size += part.size() - stream.avail_out;
  }
  ::inflateEnd(&stream);
  return size;
}

}  // namespace zraka
