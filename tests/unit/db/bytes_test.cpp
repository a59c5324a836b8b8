#include "db/codec/bytes.hpp"

#include <catch2/catch.hpp>
#include <limits>

using db::Blob;
using db::ByteReader;
using db::ByteWriter;

namespace {

Blob bytes(std::initializer_list<int> values) {
    Blob blob;
    for (const int v : values) blob.push_back(static_cast<std::byte>(v));
    return blob;
}

}  // namespace

TEST_CASE("numbers are little-endian whatever the machine", "[bytes]") {
    ByteWriter out;
    out.u64(0x0102030405060708ULL);
    out.f32(1.0F);
    CHECK(out.bytes() == bytes({8, 7, 6, 5, 4, 3, 2, 1, 0, 0, 0x80, 0x3f}));
}

TEST_CASE("varints take the bytes they need and come back", "[bytes]") {
    const std::int64_t low = std::numeric_limits<std::int64_t>::min();
    const std::int64_t high = std::numeric_limits<std::int64_t>::max();
    for (const std::int64_t v : {low, std::int64_t{-65}, std::int64_t{-64}, std::int64_t{-1}, std::int64_t{0},
                                 std::int64_t{63}, std::int64_t{64}, high}) {
        ByteWriter out;
        out.svarint(v);
        CHECK((out.bytes().size() == 1) == (v >= -64 && v < 64));
        ByteReader in(out.bytes());
        CHECK(in.svarint() == v);
        CHECK(in.finish());
    }
}

TEST_CASE("a number has one spelling", "[bytes]") {
    const Blob longer = bytes({0x81, 0x00});
    const Blob endless = bytes({0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff});
    const Blob too_large = bytes({0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x02});
    for (const Blob& blob : {longer, endless, too_large}) {
        ByteReader in(blob);
        CHECK(in.varint() == 0);
        CHECK(in.failed());
    }
}

TEST_CASE("a count is believed only as far as bytes are left for it", "[bytes]") {
    const Blob blob = bytes({3, 1, 2, 3});
    ByteReader one_each(blob);
    CHECK(one_each.count(1) == 3);
    ByteReader two_each(blob);
    CHECK(two_each.count(2) == 0);
    CHECK(two_each.failed());
}

TEST_CASE("the first fault stays, later reads give zero", "[bytes]") {
    const Blob blob = bytes({0, 0, 0xc0, 0x7f, 5});  // NaN, then a 5
    ByteReader in(blob);
    CHECK(in.f32() == 0.0F);
    CHECK(in.u8() == 0);
    in.fail("something else");
    const core::Result<void> done = in.finish();
    REQUIRE_FALSE(done);
    CHECK(done.error().code == core::ErrorCode::Damaged);
    CHECK(done.error().message == "it is damaged (a number in it is not finite)");
}

TEST_CASE("bytes left over are a fault", "[bytes]") {
    const Blob blob = bytes({1, 2});
    ByteReader in(blob);
    CHECK(in.u8() == 1);
    CHECK_FALSE(in.finish());
}
