#include "firmware_like_app/garment/worn_object.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "core/mannequin/mannequin.hpp"
#include "firmware_like_app/garment/dressed_design.hpp"

using core::Vec3;

namespace {

const core::DressForm& figure() {
    static const core::DressForm form = core::dress_form(*core::make_mannequin(*core::measures_of_size("38")));
    return form;
}

/// A box, in a unit of its own and off its origin, longest along x.
core::TriangleMesh box() {
    core::TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.vertices.push_back({5 + 0.4 * (k & 1), 3 + 0.1 * ((k >> 1) & 1), -2 + 0.2 * ((k >> 2) & 1)});
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 6, 5}, {5, 6, 7}};
    return mesh;
}

struct Bounds {
    Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
};
Bounds worn(const char* class_name, const core::DressForm& form, core::Camera camera = {}) {
    const core::PlacedObject object = app::put_on({"Thing", "models/thing.off", class_name, camera}, box(), form, {});
    Bounds out;
    for (const Vec3& v : app::placed_mesh(object, box()).vertices) {
        out.low = {std::min(out.low.x, v.x), std::min(out.low.y, v.y), std::min(out.low.z, v.z)};
        out.high = {std::max(out.high.x, v.x), std::max(out.high.y, v.y), std::max(out.high.z, v.z)};
    }
    return out;
}

}  // namespace

TEST_CASE("what is found goes where it is worn, in a size that suits it", "[worn object]") {
    CHECK(app::longest_side(box()) == Approx(0.4));
    const Bounds hat = worn("hats", figure());
    CHECK(hat.high.x - hat.low.x == Approx(30));
    CHECK(hat.low.y < 168);
    CHECK(hat.high.y > 168);
    CHECK(std::abs(hat.low.x + hat.high.x) < 1);
    const Bounds glasses = worn("Eye_glasses", figure());
    CHECK(glasses.low.y > 145);
    CHECK(glasses.high.z > 5);  // before the face
    const Bounds shoe = worn("shoe", figure());
    CHECK(shoe.low.y == Approx(0).margin(1e-9));
    CHECK(shoe.high.x < 30);
    CHECK(shoe.high.z - shoe.low.z == Approx(28));  // drawn from the side, it points forward
    const Bounds bag = worn("bag", figure());
    CHECK(bag.low.x > 10);  // in the left hand
    CHECK(bag.high.y < 100);
    CHECK(bag.low.y >= 0);
    CHECK(worn("rucksack", figure()).high.z < 0);
    CHECK(worn("chat", figure()).low.x == Approx(bag.low.x));  // no hat: carried
}

TEST_CASE("it stands as it was drawn, whatever its file calls up", "[worn object]") {
    core::Camera from_above;  // the drawing saw its z up and its -y towards itself
    from_above.direction = {0, -1, 0};
    from_above.up = {0, 0, 1};
    const Bounds bag = worn("bag", figure(), from_above);
    CHECK(bag.high.x - bag.low.x == Approx(34));
    CHECK(bag.high.y - bag.low.y == Approx(17));
    CHECK(bag.high.z - bag.low.z == Approx(8.5));
}

TEST_CASE("a body without landmarks wears things as well; names are not given twice", "[worn object]") {
    core::DressForm bare;
    bare.mesh = figure().mesh;
    const Bounds bag = worn("bag", bare);
    CHECK(bag.low.x > 10);
    CHECK(bag.low.y >= 0);
    const app::FoundObject found{"Bag", "bag.off", "bag", {}};
    core::PlacedObject first = app::put_on(found, box(), figure(), {});
    core::PlacedObject second = app::put_on(found, box(), figure(), {first});
    CHECK(first.name == "Bag");
    CHECK(second.name == "Bag 2");
    CHECK(app::put_on(found, box(), figure(), {first, second}).name == "Bag 3");
    CHECK(first.model == "bag.off");
    const core::PlacedObject nothing = app::put_on({"", "x", "", {}}, {}, figure(), {});
    CHECK(nothing.scale == 1);
    CHECK_FALSE(nothing.name.empty());
}
