#include "db/codec/bytes.hpp"

#include <bit>
#include <cmath>

namespace db {

ByteWriter::ByteWriter(BlobKind kind) {
    u8(static_cast<std::uint8_t>(kind));
}

ByteWriter::ByteWriter(BlobKind kind, std::uint8_t version) : ByteWriter(kind) {
    u8(version);
}

void ByteWriter::u8(std::uint8_t value) {
    bytes_.push_back(static_cast<std::byte>(value));
}

void ByteWriter::u64(std::uint64_t value) {
    for (int shift = 0; shift < 64; shift += 8) u8(static_cast<std::uint8_t>(value >> shift));
}

void ByteWriter::f32(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) u8(static_cast<std::uint8_t>(bits >> shift));
}

void ByteWriter::f64(double value) {
    u64(std::bit_cast<std::uint64_t>(value));
}

void ByteWriter::varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) u8(static_cast<std::uint8_t>(value | 0x80));
    u8(static_cast<std::uint8_t>(value));
}

void ByteWriter::svarint(std::int64_t value) {
    varint(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
}

void ByteWriter::text(const std::string& value) {
    varint(value.size());
    for (const char c : value) u8(static_cast<std::uint8_t>(c));
}

template <std::size_t Size>
std::uint64_t ByteReader::little_endian() {
    if (bytes_.size() - position_ < Size) fail("it is cut off");
    if (failed()) return 0;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < Size; ++i) value |= std::to_integer<std::uint64_t>(bytes_[position_ + i]) << (8 * i);
    position_ += Size;
    return value;
}

std::uint8_t ByteReader::header(BlobKind kind, std::uint8_t newest_version) {
    const std::uint8_t found = u8();
    const std::uint8_t version = u8();
    if (found != static_cast<std::uint8_t>(kind)) fail("it holds something else");
    if (version == 0 || version > newest_version) fail("its layout is not known to this program");
    return failed() ? 0 : version;
}

std::uint8_t ByteReader::u8() {
    return static_cast<std::uint8_t>(little_endian<1>());
}

float ByteReader::f32() {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(little_endian<4>()));
    if (std::isfinite(value)) return value;
    fail("a number in it is not finite");
    return 0.0F;
}

double ByteReader::f64() {
    const auto value = std::bit_cast<double>(little_endian<8>());
    if (std::isfinite(value)) return value;
    fail("a number in it is not finite");
    return 0.0;
}

std::uint64_t ByteReader::varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 70; shift += 7) {
        const std::uint64_t byte = u8();
        const bool last = (byte & 0x80) == 0;
        if (shift == 63 && byte > 1) break;
        if (last && byte == 0 && shift > 0) break;
        value |= (byte & 0x7f) << shift;
        if (last) return failed() ? 0 : value;
    }
    fail("a number in it is badly written");
    return 0;
}

std::int64_t ByteReader::svarint() {
    const std::uint64_t value = varint();
    return static_cast<std::int64_t>(value >> 1 ^ (~(value & 1) + 1));
}

int ByteReader::integer(int limit) {
    const std::uint64_t value = varint();
    if (limit >= 0 && value <= static_cast<std::uint64_t>(limit)) return static_cast<int>(value);
    fail("a number in it is out of range");
    return 0;
}

std::size_t ByteReader::count(std::size_t bytes_each) {
    const std::uint64_t value = varint();
    if (value <= (bytes_.size() - position_) / bytes_each) return static_cast<std::size_t>(value);
    fail("it is cut off");
    return 0;
}

void ByteReader::fail(const char* what) {
    if (fault_ == nullptr) fault_ = what;
}

core::Result<void> ByteReader::finish() {
    if (!failed() && !at_end()) fail("bytes are left over");
    if (!failed()) return {};
    return core::unexpected(core::ErrorCode::Damaged, std::string("it is damaged (") + fault_ + ")");
}

}  // namespace db
