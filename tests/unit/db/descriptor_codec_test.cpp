#include "db/codec/descriptor_codec.hpp"

#include <limits>

#include "db_fixtures.hpp"
#include "hostile_blob.hpp"

using core::ShapeDescriptor;
using fixture::Random;

namespace {

ShapeDescriptor round_trip(const ShapeDescriptor& descriptor) {
    return fixture::value(db::decode_descriptor(fixture::value(db::encode_descriptor(descriptor))));
}

}  // namespace

TEST_CASE("a descriptor comes back exactly, its samples on their grid", "[descriptor]") {
    Random random(11);
    for (int i = 0; i < 300; ++i) {
        const ShapeDescriptor written =
            fixture::random_descriptor(random, fixture::whole(random, 1, 30), fixture::whole(random, 0, 20));
        const ShapeDescriptor once = round_trip(written);
        ShapeDescriptor expected = written;
        expected.samples = once.samples;
        CHECK(once == expected);
        for (std::size_t k = 0; k < written.samples.size(); ++k) {
            CHECK(core::distance(once.samples[k], written.samples[k]) < 2000.0 / 65534.0);
        }
        CHECK(round_trip(once) == once);
    }
}

TEST_CASE("a shape without parts has its whole and its samples", "[descriptor]") {
    Random random(12);
    ShapeDescriptor round = fixture::random_descriptor(random, 1, 0);
    round.parts.clear();
    round.stop_points.clear();
    round.terminal_count = 0;
    CHECK(round_trip(round).whole == round.whole);
    CHECK(round_trip(ShapeDescriptor{}) == ShapeDescriptor{});
}

TEST_CASE("24 parts take 2.7 kB at most", "[descriptor]") {
    Random random(13);
    for (int i = 0; i < 20; ++i) {
        CHECK(fixture::value(db::encode_descriptor(fixture::random_descriptor(random, 16, 8))).size() <= 2765);
    }
}

TEST_CASE("a descriptor that breaks its promises is not stored", "[descriptor]") {
    Random random(14);
    ShapeDescriptor descriptor = fixture::random_descriptor(random, 5, 2);
    descriptor.stop_points = {0, 3};
    REQUIRE(db::encode_descriptor(descriptor));
    SECTION("a part at a terminal that is not there") {
        descriptor.parts[2].first_terminal = 5;
    }
    SECTION("a part with too many terminals") {
        descriptor.parts[2].terminal_count = 6;
    }
    SECTION("a part at a sample that is not there") {
        descriptor.parts[6].end_sample = 100;
    }
    SECTION("a negative sample") {
        descriptor.parts[6].start_sample = -1;
    }
    SECTION("more terminals than parts") {
        descriptor.terminal_count = 8;
    }
    SECTION("stop points out of order") {
        descriptor.stop_points = {3, 0};
    }
    SECTION("a stop point without terminal") {
        descriptor.stop_points = {5};
    }
    SECTION("a feature that is not finite") {
        descriptor.parts[1].features[3] = std::numeric_limits<float>::quiet_NaN();
    }
    SECTION("a length that is not finite") {
        descriptor.skeletal_length = std::numeric_limits<double>::infinity();
    }
    const core::Result<db::Blob> refused = db::encode_descriptor(descriptor);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == core::ErrorCode::BadArgument);
}

TEST_CASE("a descriptor of a later layout is refused in words", "[descriptor]") {
    db::Blob blob = fixture::value(db::encode_descriptor(ShapeDescriptor{}));
    blob[1] = std::byte{200};
    CHECK(fixture::sentence(db::decode_descriptor(blob)).find("layout is not known") != std::string::npos);
}

TEST_CASE("a descriptor blob cut off or changed gives an error or a sound descriptor", "[descriptor][hostile]") {
    Random random(15);
    const db::Blob blob = fixture::value(db::encode_descriptor(fixture::random_descriptor(random, 4, 2, 20)));
    fixture::try_every_cut_and_flip<ShapeDescriptor>(blob, db::decode_descriptor, db::encode_descriptor,
                                                     std::equal_to<>());
}

TEST_CASE("bytes at random are no descriptor", "[descriptor][hostile]") {
    Random random(16);
    for (int i = 0; i < 20000; ++i) {
        db::Blob blob(static_cast<std::size_t>(fixture::whole(random, 2, 400)));
        for (std::byte& b : blob) b = static_cast<std::byte>(random());
        blob[0] = std::byte{'D'};
        blob[1] = std::byte{1};
        if (db::decode_descriptor(blob)) FAIL("random bytes were taken for a descriptor");
    }
}
