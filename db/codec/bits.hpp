#pragma once
// Numbers of any number of bits, packed one after the other, for the tightest layouts. As bytes.hpp: the reader never
// goes past the end, and its faults are kept in the ByteReader that it reads from.

#include <cstdint>

#include "db/codec/bytes.hpp"

namespace db {

/// Bits needed for every value in [0, count): 0 for a single one.
[[nodiscard]] int bits_for(std::size_t count);

class BitWriter {
  public:
    explicit BitWriter(ByteWriter& out) : out_(out) {}
    /// The low `count` bits of the value, the highest first; at most 32.
    void bits(std::uint64_t value, int count);
    /// Exponential Golomb code of order k: short for small numbers of either sign, k bits and one more below 2^(k-1).
    void golomb(std::int64_t value, int k);
    /// Fills the last byte up with zeros.
    void finish();

    /// Bits that golomb(value, k) takes.
    [[nodiscard]] static int golomb_bits(std::int64_t value, int k);

  private:
    ByteWriter& out_;
    unsigned byte_ = 0;
    int used_ = 0;
};

class BitReader {
  public:
    explicit BitReader(ByteReader& in) : in_(in) {}
    [[nodiscard]] std::uint64_t bits(int count);
    [[nodiscard]] std::int64_t golomb(int k);
    /// A fault where the rest of the last byte is not zero.
    void finish();

  private:
    [[nodiscard]] unsigned bit();
    ByteReader& in_;
    unsigned byte_ = 0;
    int left_ = 0;
};

}  // namespace db
