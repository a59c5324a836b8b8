#include "core/mannequin/mannequin.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "core/mesh/crossings.hpp"
#include "core/mesh/surface_net.hpp"
#include "support/random_body.hpp"

using core::BodyPart;
using core::Measure;

namespace {

/// Made once: it is the slow part.
const core::Mannequin& size_38() {
    static const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    return body;
}

bool says(core::BodyMeasures measures, Measure which, double cm, const char* words) {
    measures[which] = cm;
    const auto checked = core::check_measures(measures);
    return !checked && checked.error().message.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a mannequin has the measures asked for, is closed and does not pass through itself", "[mannequin]") {
    for (const core::Mannequin& body : {size_38(), *core::make_mannequin(support::random_body(3))}) {
        CHECK(body.closed);
        CHECK(core::is_closed_manifold(body.mesh));
        CHECK(core::self_crossings(body.mesh).empty());
        for (const core::ReachedMeasure& g : body.girths) {
            CAPTURE(g.name, g.asked_cm);
            CHECK(std::abs(g.reached_cm - g.asked_cm) <= 0.2);
            CHECK(core::tape_length(body.mesh, g.plane) == Approx(g.reached_cm));
        }
        for (const core::ReachedMeasure& h : body.heights) {
            CAPTURE(h.name, h.asked_cm);
            CHECK(std::abs(h.reached_cm - h.asked_cm) <= 0.3);
        }
        CHECK(body.girths.size() >= 10);
        CHECK(body.heights.size() == 6);
    }
}

TEST_CASE("it stands on the floor, faces +z and is the same left and right", "[mannequin]") {
    const core::QuadMesh& mesh = size_38().mesh;
    double low = 1e9, toe = -1e9, heel = 1e9;
    std::map<std::tuple<long, long, long>, int> balance;
    for (const core::Vec3& v : mesh.vertices) {
        low = std::min(low, v.y);
        if (v.y < 5.0) toe = std::max(toe, v.z), heel = std::min(heel, v.z);
        const auto key = std::tuple(std::lround(std::abs(v.x) * 1e5), std::lround(v.y * 1e5), std::lround(v.z * 1e5));
        balance[key] += v.x > 0.0 ? 1 : v.x < 0.0 ? -1 : 0;
    }
    CHECK(low == 0.0);
    CHECK(toe > 10.0);
    CHECK(heel < -3.0);
    for (const auto& [key, sum] : balance) CHECK(sum == 0);
}

TEST_CASE("every part of the body is there, each where it belongs", "[mannequin]") {
    const core::Mannequin& body = size_38();
    std::array<core::Vec3, core::kBodyPartCount> sum{};
    std::array<int, core::kBodyPartCount> count{};
    REQUIRE(body.part_of_quad.size() == body.mesh.quads.size());
    for (std::size_t q = 0; q < body.mesh.quads.size(); ++q) {
        const auto part = static_cast<std::size_t>(body.part_of_quad[q]);
        sum[part] = sum[part] + body.mesh.vertices[body.mesh.quads[q][0]];
        ++count[part];
    }
    const auto middle = [&](BodyPart part) {
        const auto k = static_cast<std::size_t>(part);
        REQUIRE(count[k] > 50);
        return sum[k] * (1.0 / count[k]);
    };
    CHECK(middle(BodyPart::ArmLeft).x > 20.0);
    CHECK(middle(BodyPart::ArmRight).x < -20.0);
    CHECK(middle(BodyPart::LegLeft).x > 5.0);
    CHECK(middle(BodyPart::LegRight).x < -5.0);
    CHECK(middle(BodyPart::Head).y > middle(BodyPart::Neck).y);
    CHECK(middle(BodyPart::Neck).y > middle(BodyPart::Torso).y);
    CHECK(middle(BodyPart::Torso).y > middle(BodyPart::Hips).y);
    CHECK(middle(BodyPart::Hips).y > middle(BodyPart::LegLeft).y);
}

TEST_CASE("landmarks lie on the surface", "[mannequin]") {
    const core::Mannequin& body = size_38();
    for (const core::Landmark& l : body.landmarks) {
        if (l.name == "crotch") continue;  // its depth is not known, only its height
        double nearest = 1e9;
        for (const core::Vec3& v : body.mesh.vertices) nearest = std::min(nearest, core::length(v - l.place));
        CAPTURE(l.name);
        CHECK(nearest < 1.3);
    }
}

TEST_CASE("the same measures give the same mesh", "[mannequin]") {
    CHECK(core::make_mannequin(*core::measures_of_size("38"))->mesh.vertices == size_38().mesh.vertices);
}

TEST_CASE("sizes and measures by name", "[body_measures]") {
    CHECK((*core::measures_of_size("36"))[Measure::Hip] == 92.0);
    CHECK((*core::measures_of_size("39"))[Measure::Bust] == 90.0);
    CHECK((*core::measures_of_size("44"))[Measure::Waist] == 84.0);
    CHECK(core::measures_of_size("m")->figure == core::Figure::Man);
    for (const char* size : {"", "35", "45", "4x", "xl", "-38"}) {
        const auto none = core::measures_of_size(size);
        REQUIRE_FALSE(none);
        CHECK(none.error().message.find("36 to 44") != std::string::npos);
    }
    core::BodyMeasures m = *core::measures_of_size("m");
    REQUIRE(core::set_measure(m, "chest", 104.5));
    CHECK(m[Measure::Bust] == 104.5);
    CHECK(core::set_measure(m, "elbow", 20).error().message.find("under_bust") != std::string::npos);
    CHECK_FALSE(core::set_measure(m, "waist", std::numeric_limits<double>::quiet_NaN()));
    CHECK_FALSE(core::set_measure(m, "waist", -3));
}

TEST_CASE("measures that make no body are refused, by name", "[body_measures]") {
    const core::BodyMeasures woman = *core::measures_of_size("40");
    CHECK(core::check_measures(woman));
    CHECK(says(woman, Measure::Waist, 20, "waist is 20 cm"));
    CHECK(says(woman, Measure::CrotchHeight, 90, "crotch_height (90 cm) and hip_height"));
    CHECK(says(woman, Measure::UnderBust, 95, "under_bust"));
    CHECK(says(woman, Measure::NapeToWaist, 54.9, "nape_to_waist"));
    CHECK(says(woman, Measure::Stature, std::numeric_limits<double>::quiet_NaN(), "stature"));
    core::BodyMeasures bad = woman;
    bad[Measure::Thigh] = 89;
    CHECK(core::make_mannequin(bad).error().code == core::ErrorCode::BadArgument);
}
