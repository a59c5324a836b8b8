#include "core/mannequin/body_finder.hpp"

#include <catch2/catch.hpp>

#include "core/garment/body_warp.hpp"
#include "core/garment/part_surface.hpp"
#include "core/mannequin/dress_form.hpp"
#include "support/simple_body.hpp"

using core::Vec3;

namespace {

const core::Mannequin& body(const char* size) {
    static const core::Mannequin woman = *core::make_mannequin(*core::measures_of_size("38")),
                                 man = *core::make_mannequin(*core::measures_of_size("m"));
    return std::string(size) == "38" ? woman : man;
}

}  // namespace

TEST_CASE("landmarks and parts are found on a mesh alone, near where the mannequin has them", "[body_finder]") {
    for (const char* size : {"38", "m"}) {
        const core::DressForm known = core::dress_form(body(size));
        const auto found = core::find_body(known.mesh);
        REQUIRE(found);
        REQUIRE(found->landmarks.size() == known.landmarks.size());
        for (const core::Landmark& l : known.landmarks) {
            INFO(size << " " << l.name);
            const core::Landmark* other = core::find_landmark(found->landmarks, l.name);
            REQUIRE(other != nullptr);
            CHECK(core::length(other->place - l.place) < 8.0);
        }
        REQUIRE(found->part_of_triangle.size() == known.part_of_triangle.size());
        std::size_t same = 0;
        for (std::size_t t = 0; t < found->part_of_triangle.size(); ++t)
            same += found->part_of_triangle[t] == known.part_of_triangle[t] ? 1 : 0;
        CHECK(same > found->part_of_triangle.size() * 85 / 100);
    }
}

TEST_CASE("a post has neither", "[body_finder]") {
    CHECK_FALSE(core::find_body(support::post(10.0, 160.0)));
    CHECK_FALSE(core::find_body({}));
    const core::DressForm form = core::dress_form(support::post(10.0, 160.0));
    CHECK(form.landmarks.empty());
    CHECK(core::PartSurface(form).empty());
}

TEST_CASE("a warp takes each landmark to its namesake", "[body_warp]") {
    const auto& from = body("38").landmarks;
    const auto& to = body("m").landmarks;
    const auto warp = core::BodyWarp::between(from, to);
    REQUIRE(warp);
    for (const core::Landmark& landmark : from)
        if (const core::Landmark* l = core::find_landmark(to, landmark.name))
            CHECK(core::length((*warp)(landmark.place) - l->place) < 1e-6);
    const auto same = core::BodyWarp::between(from, from);
    REQUIRE(same);
    CHECK(core::length((*same)({30, 90, 10}) - Vec3{30, 90, 10}) < 1e-6);
    CHECK_FALSE(core::BodyWarp::between(from, {{"nape", {}}}));
    std::vector<core::Landmark> flat = from;
    for (core::Landmark& l : flat) l.place.z = 0.0;
    CHECK_FALSE(core::BodyWarp::between(flat, to));
}

TEST_CASE("the parts under a piece of cloth, and their nearest places", "[part_surface]") {
    const core::PartSurface parts(core::dress_form(body("38")));
    const core::PartSet left_leg = core::part_bit(core::BodyPart::LegLeft),
                        right_leg = core::part_bit(core::BodyPart::LegRight);
    std::vector<Vec3> tube;
    for (int k = 0; k < 20; ++k) tube.push_back({12.0 + 10.0 * std::cos(k), 40.0, 10.0 * std::sin(k)});
    CHECK(parts.parts_under(tube) == left_leg);
    const auto near = parts.nearest({-11, 40, 0}, ~core::PartSet{0}, 40.0);
    REQUIRE(near);
    CHECK(near->part == core::BodyPart::LegRight);
    const auto own = parts.nearest({-11, 40, 0}, left_leg, 40.0);
    REQUIRE(own);
    CHECK(own->place.x > 0.0);
    CHECK(own->distance > near->distance);
    CHECK_FALSE(parts.nearest({-11, 40, 0}, left_leg, 3.0));
    CHECK(core::mirrored_parts(left_leg | core::part_bit(core::BodyPart::Hips)) ==
          (right_leg | core::part_bit(core::BodyPart::Hips)));
    CHECK(core::names_of_parts(left_leg) == std::vector<std::string>{"leg_left"});
    CHECK(*core::part_named("leg_right") == core::BodyPart::LegRight);
    CHECK(core::part_named("tail").error().message.find("leg_left") != std::string::npos);
}
