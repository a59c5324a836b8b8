#include "db/codec/bits.hpp"

#include <catch2/catch.hpp>
#include <limits>

using db::BitReader;
using db::BitWriter;
using db::ByteReader;
using db::ByteWriter;

TEST_CASE("bits are packed from the highest on and filled up with zeros", "[bits]") {
    ByteWriter out;
    BitWriter bits(out);
    bits.bits(0b101, 3);
    bits.bits(0b0110011, 7);
    bits.finish();
    bits.finish();
    CHECK(out.bytes() == db::Blob{std::byte{0b10101100}, std::byte{0b11000000}});
}

TEST_CASE("numbers of every size and order come back", "[bits]") {
    const std::int64_t far = std::int64_t{1} << 30;
    for (int k = 0; k <= 15; ++k) {
        ByteWriter out;
        BitWriter writer(out);
        int size = 0;
        std::vector<std::int64_t> values{0, 1, -1, 7, -8, 100, -1000, 65535, far, -far};
        for (const std::int64_t v : values) {
            writer.golomb(v, k);
            size += BitWriter::golomb_bits(v, k);
        }
        writer.finish();
        CHECK(out.bytes().size() == static_cast<std::size_t>(size + 7) / 8);
        ByteReader in(out.bytes());
        BitReader reader(in);
        for (const std::int64_t v : values) CHECK(reader.golomb(k) == v);
        reader.finish();
        CHECK(in.finish());
    }
}

TEST_CASE("as many bits as a number of values needs", "[bits]") {
    CHECK(db::bits_for(0) == 0);
    CHECK(db::bits_for(1) == 0);
    CHECK(db::bits_for(2) == 1);
    CHECK(db::bits_for(100) == 7);
    CHECK(db::bits_for(128) == 7);
    CHECK(db::bits_for(129) == 8);
}

TEST_CASE("bits that run out, never end or are left over are faults", "[bits]") {
    const db::Blob zeros(20, std::byte{0});
    ByteReader endless(zeros);
    CHECK(BitReader(endless).golomb(3) == 0);
    CHECK_FALSE(endless.finish());

    ByteReader cut(db::BlobView(zeros).first(1));
    BitReader nine(cut);
    CHECK(nine.bits(9) == 0);
    CHECK(cut.failed());

    const db::Blob one{std::byte{0b11000001}};
    ByteReader left(one);
    BitReader reader(left);
    CHECK(reader.bits(2) == 3);
    reader.finish();
    CHECK_FALSE(left.finish());
}
