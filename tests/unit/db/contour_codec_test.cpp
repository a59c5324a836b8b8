#include "db/codec/contour_codec.hpp"

#include <limits>

#include "db_fixtures.hpp"
#include "hostile_blob.hpp"
#include "support/random_contour.hpp"

using core::ContourDescriptor;

namespace {

ContourDescriptor round_trip(const ContourDescriptor& descriptor) {
    return fixture::value(db::decode_contour(fixture::value(db::encode_contour(descriptor))));
}

}  // namespace

TEST_CASE("a contour descriptor comes back in every bit", "[contour_codec]") {
    fixture::Random random(31);
    for (int i = 0; i < 100; ++i) {
        const ContourDescriptor written = support::random_contour(random);
        CHECK(round_trip(written) == written);
    }
    CHECK(round_trip(ContourDescriptor{}) == ContourDescriptor{});
}

TEST_CASE("a contour descriptor takes less than 2 kB", "[contour_codec]") {
    fixture::Random random(32);
    CHECK(fixture::value(db::encode_contour(support::random_contour(random))).size() == 1670);
}

TEST_CASE("a contour descriptor that breaks its promises is not stored", "[contour_codec]") {
    fixture::Random random(33);
    ContourDescriptor descriptor = support::random_contour(random);
    REQUIRE(db::encode_contour(descriptor));
    SECTION("a height beyond the greatest") {
        descriptor.frames[3][7] = static_cast<std::int8_t>(core::kGreatestHeight + 1);
    }
    SECTION("a distance ahead beyond the least") {
        descriptor.frames[core::kFrameChannels - 1][0] = static_cast<std::int8_t>(-core::kGreatestAhead - 1);
    }
    SECTION("a negative complexity") {
        descriptor.complexity = -0.001F;
    }
    SECTION("a complexity above 1") {
        descriptor.complexity = 1.001F;
    }
    SECTION("a complexity that is no number") {
        descriptor.complexity = std::numeric_limits<float>::quiet_NaN();
    }
    const core::Result<db::Blob> refused = db::encode_contour(descriptor);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == core::ErrorCode::BadArgument);
}

TEST_CASE("a contour descriptor of a later layout, or another kind of blob, is refused in words", "[contour_codec]") {
    db::Blob blob = fixture::value(db::encode_contour(ContourDescriptor{}));
    blob[1] = std::byte{200};
    CHECK(fixture::sentence(db::decode_contour(blob)).find("layout is not known") != std::string::npos);
    blob[1] = std::byte{1};
    blob[0] = std::byte{'D'};
    CHECK_FALSE(db::decode_contour(blob));
}

TEST_CASE("a contour blob cut off or changed gives an error or a sound descriptor", "[contour_codec][hostile]") {
    fixture::Random random(34);
    const db::Blob blob = fixture::value(db::encode_contour(support::random_contour(random)));
    fixture::try_every_cut_and_flip<ContourDescriptor>(blob, db::decode_contour, db::encode_contour,
                                                       std::equal_to<ContourDescriptor>());
}
