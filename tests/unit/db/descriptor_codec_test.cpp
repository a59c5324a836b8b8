#include "db/codec/descriptor_codec.hpp"

#include <limits>
#include <numeric>

#include "core/parts/describe.hpp"
#include "core/parts/rounding.hpp"
#include "db/codec/points_codec.hpp"
#include "db_fixtures.hpp"
#include "hostile_blob.hpp"

using core::ShapeDescriptor;
using fixture::Random;

namespace {

ShapeDescriptor round_trip(const ShapeDescriptor& descriptor) {
    return fixture::value(db::decode_descriptor(fixture::value(db::encode_descriptor(descriptor))));
}

/// Descriptors as a model's views have them: of random outlines.
std::vector<ShapeDescriptor> described(Random& random, int shapes) {
    std::vector<ShapeDescriptor> all;
    while (shapes-- > 0) {
        const core::Polygon outline = fixture::random_outline(random, 80, fixture::real(random, 0.3, 120.0));
        all.push_back(fixture::value(core::describe(outline)));
    }
    return all;
}

std::uint8_t layout_of(const ShapeDescriptor& descriptor) {
    return std::to_integer<std::uint8_t>(fixture::value(db::encode_descriptor(descriptor))[1]);
}

}  // namespace

TEST_CASE("a described shape is stored compactly and comes back rounded, in every bit", "[descriptor]") {
    Random random(17);
    for (const ShapeDescriptor& written : described(random, 12)) {
        REQUIRE(layout_of(written) == 2);
        const ShapeDescriptor once = round_trip(written);
        CHECK(once == core::rounded(written));
        CHECK(round_trip(once) == once);
    }
}

TEST_CASE("a reading takes 200 bytes on average", "[descriptor]") {
    Random random(18);
    const std::vector<ShapeDescriptor> all = described(random, 20);
    std::size_t bytes = 0;
    for (const ShapeDescriptor& d : all) bytes += fixture::value(db::encode_descriptor(d)).size();
    CHECK(bytes / all.size() <= 200);
}

TEST_CASE("stop points other than those of the parts are kept", "[descriptor]") {
    Random random(19);
    ShapeDescriptor descriptor = described(random, 1).front();
    descriptor.stop_points.resize(static_cast<std::size_t>(descriptor.terminal_count));
    std::iota(descriptor.stop_points.begin(), descriptor.stop_points.end(), 0);
    REQUIRE(layout_of(descriptor) == 2);
    CHECK(round_trip(descriptor).stop_points == descriptor.stop_points);
    descriptor.stop_points.clear();
    CHECK(round_trip(descriptor).stop_points.empty());
}

TEST_CASE("what the compact layout cannot hold is stored in full", "[descriptor]") {
    Random random(20);
    ShapeDescriptor descriptor = described(random, 1).front();
    SECTION("a feature of another making") {
        descriptor.parts.front().features[0] += 1.0F;
        CHECK(round_trip(descriptor).parts == descriptor.parts);
    }
    SECTION("terminals out of order") {
        std::swap(descriptor.parts[0], descriptor.parts[1]);
        CHECK(round_trip(descriptor).parts == descriptor.parts);
    }
    SECTION("a shape without parts") {
        descriptor.parts.clear();
        descriptor.stop_points.clear();
        descriptor.terminal_count = 0;
        CHECK(round_trip(descriptor).whole == descriptor.whole);
    }
    CHECK(layout_of(descriptor) == 1);
}

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

TEST_CASE("a compact blob cut off or changed gives an error or a sound descriptor", "[descriptor][hostile]") {
    const core::Polygon outline{{0, 0}, {9, 0}, {9, 4}, {5, 4}, {5, 11}, {3, 11}, {3, 4}, {0, 4}};
    const ShapeDescriptor small = fixture::value(core::describe(outline, {.sample_size = 24}));
    REQUIRE(layout_of(small) == 2);
    fixture::try_every_cut_and_flip<ShapeDescriptor>(fixture::value(db::encode_descriptor(small)),
                                                     db::decode_descriptor, db::encode_descriptor, std::equal_to<>());
}

TEST_CASE("bytes at random are no descriptor", "[descriptor][hostile]") {
    Random random(16);
    for (int i = 0; i < 20000; ++i) {
        db::Blob blob(static_cast<std::size_t>(fixture::whole(random, 2, 400)));
        for (std::byte& b : blob) b = static_cast<std::byte>(random());
        blob[0] = std::byte{'D'};
        blob[1] = static_cast<std::byte>(1 + i % 2);
        const auto decoded = db::decode_descriptor(blob);
        if (decoded && !db::encode_descriptor(*decoded)) FAIL("random bytes were taken for what cannot be written");
        if (decoded && blob[1] == std::byte{1}) FAIL("random bytes were taken for a descriptor");
    }
}
