#include "db/codec/bits.hpp"

#include <bit>

namespace db {

namespace {

constexpr int kLongestPrefix = 32;

/// 0, -1, 1, -2 … become 0, 1, 2, 3 …
std::uint64_t folded(std::int64_t value) {
    return static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
}

}  // namespace

int bits_for(std::size_t count) {
    return count <= 1 ? 0 : std::bit_width(count - 1);
}

void BitWriter::bits(std::uint64_t value, int count) {
    for (int i = count - 1; i >= 0; --i) {
        byte_ = byte_ << 1 | static_cast<unsigned>(value >> i & 1U);
        if (++used_ == 8) finish();
    }
}

void BitWriter::golomb(std::int64_t value, int k) {
    const std::uint64_t scaled = (folded(value) >> k) + 1;
    const int width = std::bit_width(scaled);
    bits(0, width - 1);
    bits(scaled, width);
    bits(folded(value), k);
}

int BitWriter::golomb_bits(std::int64_t value, int k) {
    return 2 * static_cast<int>(std::bit_width((folded(value) >> k) + 1)) - 1 + k;
}

void BitWriter::finish() {
    if (used_ == 0) return;
    out_.u8(static_cast<std::uint8_t>(byte_ << (8 - used_)));
    byte_ = 0;
    used_ = 0;
}

unsigned BitReader::bit() {
    if (left_ == 0) {
        byte_ = in_.u8();
        left_ = 8;
    }
    return byte_ >> --left_ & 1U;
}

std::uint64_t BitReader::bits(int count) {
    std::uint64_t value = 0;
    for (int i = 0; i < count; ++i) value = value << 1 | bit();
    return in_.failed() ? 0 : value;
}

std::int64_t BitReader::golomb(int k) {
    int zeros = 0;
    while (bit() == 0) {
        if (++zeros > kLongestPrefix) in_.fail("a number in it is badly written");
        if (in_.failed()) return 0;
    }
    const std::uint64_t scaled = std::uint64_t{1} << zeros | bits(zeros);
    const std::uint64_t value = (scaled - 1) << k | bits(k);
    return in_.failed() ? 0 : static_cast<std::int64_t>(value >> 1 ^ (~(value & 1) + 1));
}

void BitReader::finish() {
    if (bits(left_) != 0) in_.fail("bits are left over");
}

}  // namespace db
