// SPDX-License-Identifier: Apache-2.0
#include "image/deflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <new>

#include "core/in_parallel.hpp"
#include "core/threads.hpp"

namespace zraka {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 17;

/// Rows that are deflated for themselves.
struct Piece {
  std::vector<unsigned char> deflated;
  uLong checksum = 0;  ///< Adler's, of the rows' bytes
  std::size_t bytes = 0;
};

/// What a thread needs to deflate pieces, one after the other.
class Deflater {
 public:
  explicit Deflater(int level) {
    constexpr int kRaw = -MAX_WBITS, kMemory = 8;  // no header; zlib's default
    if (deflateInit2(&stream_, level, Z_DEFLATED, kRaw, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::bad_alloc();
  }
  ~Deflater() { deflateEnd(&stream_); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;

  /// Ends on a whole byte, so that the next piece may follow.
  Piece deflate(const Rows& rows, std::uint32_t first, std::uint32_t end) {
    Piece piece;
    piece.bytes = rows.bytes * (end - first);
    in_.resize(piece.bytes);
    for (std::uint32_t row = first; row < end; ++row)
      rows.make(row, in_.data() + rows.bytes * (row - first));
    piece.checksum = adler32_z(adler32_z(0, nullptr, 0), in_.data(), in_.size());

    deflateReset(&stream_);
    // zlib counts in 32 bits; rows are shorter, but nobody promises that.
    out_.resize(kPieceBytes);
    const unsigned char* at = in_.data();
    std::size_t left = in_.size();
    const int last_flush = end == rows.count ? Z_FINISH : Z_SYNC_FLUSH;
    do {
      const auto some = static_cast<uInt>(std::min<std::size_t>(left, 1u << 30));
      stream_.next_in = const_cast<unsigned char*>(at);  // NOLINT: zlib only reads it
      stream_.avail_in = some;
      at += some;
      left -= some;
      do {
        stream_.next_out = out_.data();
        stream_.avail_out = static_cast<uInt>(out_.size());
        ::deflate(&stream_, left == 0 ? last_flush : Z_NO_FLUSH);
        piece.deflated.insert(piece.deflated.end(), out_.data(), stream_.next_out);
      } while (stream_.avail_out == 0);
    } while (left != 0);
    return piece;
  }

 private:
  z_stream stream_{};
  std::vector<unsigned char> in_, out_;
};

/// Puts pieces together.
class Stream {
 public:
  explicit Stream(const std::function<bool(const std::vector<unsigned char>&)>& take)
      : take_(take) {}

  bool add(Piece piece, bool last) {
    std::vector<unsigned char>& part = piece.deflated;
    // Deflate with a window of 2^15 bytes, made in haste.
    if (empty_) part.insert(part.begin(), {0x78, 0x5E});
    empty_ = false;
    checksum_ = adler32_combine(checksum_, piece.checksum, static_cast<z_off_t>(piece.bytes));
    for (int shift = 24; last && shift >= 0; shift -= 8)
      part.push_back(static_cast<unsigned char>(checksum_ >> shift & 0xFF));
    return take_(part);
  }

 private:
  const std::function<bool(const std::vector<unsigned char>&)>& take_;
  uLong checksum_ = adler32_z(0, nullptr, 0);
  bool empty_ = true;
};

}  // namespace

bool deflate_rows(const Rows& rows, int level, int threads,
                  const std::function<bool(const std::vector<unsigned char>& part)>& take) {
  const auto together =
      static_cast<std::uint32_t>(std::max<std::size_t>(1, kPieceBytes / rows.bytes));
  Stream stream(take);
  // More threads than processors would only wait for each other.
  const int all = processor_count();
  const int workers = threads == 0 ? all : std::clamp(threads, 1, all);
  if (workers == 1 || rows.count <= together) {
    Deflater deflater(level);
    for (std::uint32_t first = 0; first < rows.count; first += together) {
      const std::uint32_t end = std::min(rows.count - first, together) + first;
      if (!stream.add(deflater.deflate(rows, first, end), end == rows.count)) return false;
    }
    return true;
  }

  struct Job {
    std::uint32_t first, end;
    Piece piece;
  };
  PerThread<Deflater> deflaters([level] { return Deflater(level); });
  std::uint32_t next = 0;
  std::atomic<bool> going = true;
  const auto next_job = [&]() -> WorkPiece {
    const std::uint32_t first = next;
    if (!going || first == rows.count) return nullptr;
    next += std::min(rows.count - first, together);
    return std::make_shared<Job>(Job{first, next, {}});
  };
  const auto do_job = [&](void* piece) {
    Job& job = *static_cast<Job*>(piece);
    job.piece = deflaters.local().deflate(rows, job.first, job.end);
  };
  const auto hand_over = [&](void* piece) {
    Job& job = *static_cast<Job*>(piece);
    if (going) going = stream.add(std::move(job.piece), job.end == rows.count);
  };
  in_arena(workers, [&] {
    in_order(2 * static_cast<std::size_t>(workers), next_job, do_job, hand_over);
  });
  return going;
}

}  // namespace zraka
