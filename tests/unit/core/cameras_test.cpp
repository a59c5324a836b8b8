#include "core/views/cameras.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

using core::Camera;
using core::Vec3;

namespace {

const Camera& camera(int number) {
    return core::cameras()[static_cast<std::size_t>(number)];
}

/// The coordinates without signs, ascending: what kind of place on the cube a direction is.
std::vector<double> kind_of(Vec3 d) {
    std::vector<double> k{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    std::sort(k.begin(), k.end());
    return k;
}

}  // namespace

TEST_CASE("the cameras are unit, upright and all different", "[cameras]") {
    for (int a = 0; a < core::kCameraCount; ++a) {
        CHECK(core::length(camera(a).direction) == Approx(1.0).margin(1e-12));
        CHECK(core::length(camera(a).up) == Approx(1.0).margin(1e-12));
        CHECK(core::dot(camera(a).up, camera(a).direction) == Approx(0.0).margin(1e-12));
        for (int b = 0; b < a; ++b) CHECK(core::length(camera(a).direction - camera(b).direction) > 0.3);
    }
}

TEST_CASE("the directions are those of one Catmull-Clark step on the cube, in the documented order", "[cameras]") {
    const double corner = 1.0 / std::sqrt(3.0), edge = 1.0 / std::sqrt(2.0);
    for (int c = 0; c < 8; ++c) CHECK(kind_of(camera(c).direction)[0] == Approx(corner));
    for (int c = 8; c < 14; ++c) CHECK(kind_of(camera(c).direction)[2] == Approx(1.0));
    for (int c = 14; c < 26; ++c) CHECK(kind_of(camera(c).direction)[1] == Approx(edge));
    CHECK(camera(0).direction.x < 0.0);
    CHECK(camera(1).direction.z > 0.0);
    CHECK(camera(13).direction == Vec3{0, 0, 1});
    CHECK(camera(14).direction.x == Approx(0.0).margin(1e-12));
    CHECK(camera(25).direction.z == Approx(0.0).margin(1e-12));

    // By hand, for the cube of side 2: corners go to 5/9, edge points are at 3/4, face points at 1, so the four corners
    // of a small face on +x, (5,5,5)/9, (3,3,0)/4, (1,0,0) and (3,0,3)/4, have their centroid at this:
    const Vec3 centroid = core::normalised({5.0 / 9 + 0.75 + 1.0 + 0.75, 5.0 / 9 + 0.75, 5.0 / 9 + 0.75});
    std::set<std::vector<long>> seen;
    for (int c = 26; c < core::kCameraCount; ++c) {
        const std::vector<double> kind = kind_of(camera(c).direction);
        CHECK(kind[2] == Approx(centroid.x));
        CHECK(kind[1] == Approx(centroid.y));
        CHECK(kind[0] == Approx(centroid.y));
        const Vec3 d = camera(c).direction;
        seen.insert({std::lround(9 * d.x), std::lround(9 * d.y), std::lround(9 * d.z)});
    }
    CHECK(seen.size() == 24);
}

TEST_CASE("the y axis is up in the image, and from above the front is below", "[cameras]") {
    for (int c = 0; c < core::kCameraCount; ++c) {
        if (c == 10 || c == 11) continue;
        CHECK(camera(c).project({0, 1, 0}).y > 0.1);
        CHECK(camera(c).project({0, 1, 0}).x == Approx(0.0).margin(1e-12));
    }
    const Camera above = core::camera_from({0, 5, 0});
    CHECK(above.project({0, 0, 1}).y == Approx(-1.0));
    CHECK(above.project({1, 0, 0}).x == Approx(1.0));
    const Camera front = camera(13);
    CHECK(front.project({1, 2, 3}) == core::Point{1, 2});
    CHECK(front.nearness({1, 2, 3}) == 3.0);
}

TEST_CASE("the cameras are 25 opposite pairs that see each other's mirror image", "[cameras]") {
    const Vec3 p{0.3, -0.5, 0.7};
    for (int c = 0; c < core::kCameraCount; ++c) {
        const int other = core::opposite_camera(c);
        CHECK(other != c);
        CHECK(core::opposite_camera(other) == c);
        CHECK(core::length(camera(c).direction + camera(other).direction) < 1e-12);
        CHECK(camera(other).project(p).x == Approx(-camera(c).project(p).x).margin(1e-12));
        CHECK(camera(other).project(p).y == Approx(camera(c).project(p).y).margin(1e-12));
    }
}

TEST_CASE("one camera of each pair represents it, from above, in front, or from the right", "[cameras]") {
    const auto& chosen = core::representative_cameras();
    CHECK(std::is_sorted(chosen.begin(), chosen.end()));
    std::set<int> covered;
    for (const int c : chosen) {
        covered.insert(c);
        covered.insert(core::opposite_camera(c));
        CHECK(camera(c).direction.y > -1e-9);
        CHECK(core::representative_of(c) == c);
        CHECK(core::representative_of(core::opposite_camera(c)) == c);
    }
    CHECK(covered.size() == 50);
    CHECK(std::count(chosen.begin(), chosen.end(), 13) == 1);  // +z
    CHECK(std::count(chosen.begin(), chosen.end(), 9) == 1);   // +x
}
