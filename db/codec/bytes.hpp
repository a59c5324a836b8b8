#pragma once
// Little-endian bytes, written and read one value at a time. The reader is for bytes that anybody may have made: it
// never reads past the end, never trusts a count, and remembers its first fault, so that a chain of reads is asked
// once:
//
//     ByteReader in(blob);
//     const std::uint64_t n = in.count(4);   // refused unless n * 4 bytes are left
//     for (…; i < n; ++i) values.push_back(in.f32());
//     if (core::Result<void> done = in.finish(); !done) return core::unexpected(done.error());

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace db {

using Blob = std::vector<std::byte>;
using BlobView = std::span<const std::byte>;

/// The first byte of every blob says what it holds, the second one which layout, counted from 1.
enum class BlobKind : std::uint8_t { Camera = 'C', Contour = 'O', Descriptor = 'D', Mesh = 'M', Polygon = 'P' };

class ByteWriter {
  public:
    ByteWriter() = default;
    explicit ByteWriter(BlobKind kind);  ///< the caller writes the layout's number next
    ByteWriter(BlobKind kind, std::uint8_t version);

    void u8(std::uint8_t value);
    void u64(std::uint64_t value);
    void f32(float value);
    void f64(double value);
    /// Seven bits a byte, low ones first: 1 byte below 128, at most 10.
    void varint(std::uint64_t value);
    /// Small numbers of either sign are short: 0, -1, 1, -2 … become 0, 1, 2, 3 …
    void svarint(std::int64_t value);
    /// The length, then the bytes.
    void text(const std::string& value);

    [[nodiscard]] const Blob& bytes() const { return bytes_; }
    [[nodiscard]] Blob take() { return std::move(bytes_); }

  private:
    Blob bytes_;
};

class ByteReader {
  public:
    explicit ByteReader(BlobView bytes) : bytes_(bytes) {}

    /// Reads the two bytes in front; gives the version, or 0 and a fault when the kind is another or it is newer.
    [[nodiscard]] std::uint8_t header(BlobKind kind, std::uint8_t newest_version);

    // After the first fault each of these gives 0.
    [[nodiscard]] std::uint8_t u8();
    [[nodiscard]] float f32();             ///< NaN and infinity are faults
    [[nodiscard]] double f64();            ///< NaN and infinity are faults
    [[nodiscard]] std::uint64_t varint();  ///< more bytes than needed, or more than 64 bits, are faults
    [[nodiscard]] std::int64_t svarint();
    /// A varint that must lie in [0, limit].
    [[nodiscard]] int integer(int limit);
    /// How many elements follow. A fault unless `bytes_each` bytes for each of them are still there, so that memory
    /// set aside for them is bounded by the size of the blob.
    [[nodiscard]] std::size_t count(std::size_t bytes_each);

    /// Notes a fault found by the caller, e.g. "index out of range". The first one counts.
    void fail(const char* what);
    [[nodiscard]] bool failed() const { return fault_ != nullptr; }
    [[nodiscard]] bool at_end() const { return position_ == bytes_.size(); }
    /// Damaged if there was a fault, or if bytes are left over.
    [[nodiscard]] core::Result<void> finish();

  private:
    template <std::size_t Size>
    [[nodiscard]] std::uint64_t little_endian();
    BlobView bytes_;
    std::size_t position_ = 0;
    const char* fault_ = nullptr;
};

}  // namespace db
