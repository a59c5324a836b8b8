#include <catch2/catch.hpp>

#include "core/garment/wardrobe.hpp"

using core::DesignStep;
using Kind = core::DesignStep::Kind;

namespace {

const core::Mannequin& woman() {
    static const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    return body;
}

/// A body of quite other proportions, quickly made: wider, deeper and a little taller.
core::DressForm stout() {
    core::DressForm form = core::dress_form(woman());
    const auto stretched = [](core::Vec3 p) { return core::Vec3{1.15 * p.x, 1.05 * p.y, 1.3 * p.z}; };
    for (core::Vec3& v : form.mesh.vertices) v = stretched(v);
    for (core::Landmark& l : form.landmarks) l.place = stretched(l.place);
    form.measures = *core::measures_of_size("m");
    return form;
}

}  // namespace

TEST_CASE("a design is carried to a body of other proportions with all its pieces", "[carried_design]") {
    const core::Design trousers = *core::wardrobe_design("trousers", woman());
    const auto other = core::make_garment(trousers, stout());
    REQUIRE(other);
    CHECK(other->carried);
    CHECK(other->faults.empty());
    REQUIRE(other->layers.size() == 1);
    CHECK(other->layers[0].fitted.pieces.size() == 4);
    CHECK(other->layers[0].report.deepest_before_cm < 1.0);
    CHECK(other->layers[0].report.deepest_after_cm == 0.0);
    CHECK(other->layers[0].report.self_crossings == 0);
    CHECK(other->layers[0].report.mean_stretch < 0.05);
}

TEST_CASE("regions are recorded with the parts they lie over, ends of lines with their landmarks", "[carried_design]") {
    const core::DressForm form = core::dress_form(woman());
    const core::Design saved = core::recorded(*core::wardrobe_design("trousers", woman()), form);
    for (const DesignStep& step : saved.steps) {
        if (step.kind != Kind::Region) continue;
        CHECK((step.parts & core::part_bit(core::BodyPart::LegLeft)) != 0);
        CHECK((step.parts & core::part_bit(core::BodyPart::LegRight)) == 0);
    }
    core::Design empty;
    empty.body = woman().measures;
    empty.network.snap_cm = 4.0;
    auto runner = core::DesignRunner::start(empty, form);
    REQUIRE(runner);
    DesignStep line;
    line.name = "waist";
    const core::Vec3 left = core::find_landmark(form.landmarks, "waist_left")->place,
                     front = core::find_landmark(form.landmarks, "waist_front")->place;
    line.stroke = {{*core::named_view("front"),
                    {core::DrawingTool::Kind::Body, 1.0},
                    {{front.x + 0.4, front.y + 0.5}, {0.5 * left.x, left.y}, {left.x + 0.5, left.y - 0.5}}}};
    const DesignStep snapped = runner->snapped(line, 4.0);
    CHECK(snapped.starts_at == "waist_front");
    CHECK(snapped.ends_at == "waist_left");
    REQUIRE(runner->take(snapped));
    const core::NetworkLine& drawn = runner->network().lines().front();
    CHECK(core::length(drawn.shape.back() - left) == Approx(1.0).margin(0.2));
    CHECK(core::length(drawn.shape.front() - front) == Approx(1.0).margin(0.2));
}
