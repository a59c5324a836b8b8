#include "core/garment/design.hpp"

#include <catch2/catch.hpp>

#include "core/exchange/design_file.hpp"
#include "core/mesh/crossings.hpp"
#include "support/simple_body.hpp"

using core::Design;
using core::DesignStep;
using Kind = core::DesignStep::Kind;
using Tool = core::DrawingTool::Kind;

namespace {

const core::TriangleMesh& body() {
    static const core::TriangleMesh mesh = support::post(10.0, 60.0);
    return mesh;
}

core::SketchStroke stroke(const char* view, Tool tool, double offset, std::vector<core::Point> points) {
    return {{*core::named_view(view), {tool, offset}, std::move(points)}};
}

DesignStep line(const char* name, core::SketchStroke drawn) {
    DesignStep step;
    step.name = name;
    step.stroke = std::move(drawn);
    return step;
}

/// The front half of a tube around the post, from y = 20 to y = 40, that passes through the post in its middle.
Design half_tube() {
    Design design;
    design.name = "tube";
    design.body = *core::measures_of_size("38");
    design.steps = {line("top", stroke("top", Tool::PlaneXZ, 40, {{0, -12}, {6, -9}, {11.5, 0}})),
                    line("bottom", stroke("top", Tool::PlaneXZ, 20, {{0, -12}, {6, -9}, {11.5, 0}})),
                    line("side", stroke("front", Tool::PlaneXY, 0, {{11.5, 40}, {11, 30}, {11.5, 20}})),
                    line("middle", stroke("left", Tool::PlaneYZ, 0, {{-12, 40}, {-8, 30}, {-12, 20}}))};
    DesignStep region;
    region.kind = Kind::Region;
    region.name = "front";
    region.lines = {"top", "side", "bottom", "middle"};
    design.steps.push_back(region);
    return design;
}

std::string version_text(int version) {
    return "\"version\": " + std::to_string(version);
}

}  // namespace

TEST_CASE("a drawn garment is filled, mirrored and fitted to the body", "[design]") {
    for (const core::Fairing fairing : {core::Fairing::Optimised, core::Fairing::Particles}) {
        Design design = half_tube();
        design.fitting.fairing = fairing;
        const auto garment = core::make_garment(design, body());
        REQUIRE(garment);
        CHECK(garment->faults.empty());
        REQUIRE(garment->layers.size() == 1);
        const core::FinishedLayer& layer = garment->layers[0];
        CHECK(layer.fitted.pieces.size() == 2);
        CHECK(layer.report.deepest_before_cm > 0.5);
        CHECK(layer.report.deepest_after_cm == 0.0);
        CHECK(layer.report.closest_cm > 0.1);
        CHECK(layer.report.mean_stretch < 0.15);
        const auto obstacle = core::Obstacle::of_body(body());
        CHECK(core::mesh_crossings(layer.fitted.mesh, obstacle->surfaces()[0]).empty());
        CHECK_FALSE(core::mesh_crossings(layer.drawn.mesh, obstacle->surfaces()[0]).empty());
    }
}

TEST_CASE("a second layer stays outside of the first", "[design]") {
    Design design = half_tube();
    DesignStep next;
    next.kind = Kind::Layer;
    design.steps.push_back(next);
    const Design first = half_tube();
    for (DesignStep step : first.steps) {
        if (step.kind == Kind::Region) step.name = "outer";
        design.steps.push_back(step);
    }
    const auto garment = core::make_garment(design, body());
    REQUIRE(garment);
    CHECK(garment->faults.empty());
    REQUIRE(garment->layers.size() == 2);
    CHECK(core::mesh_crossings(garment->layers[0].fitted.mesh, garment->layers[1].fitted.mesh).empty());
    CHECK(garment->layers[1].report.closest_cm > 0.1);
}

TEST_CASE("faulty steps are named, the rest is made", "[design]") {
    Design design = half_tube();
    DesignStep lost = line("lost", stroke("front", Tool::Body, 0, {{0, 30}, {90, 30}}));
    design.steps.insert(design.steps.begin(), lost);
    DesignStep cut;
    cut.kind = Kind::Cut;
    cut.region = "nowhere";
    cut.name = "x";
    cut.stroke = stroke("front", Tool::Body, 0, {{0, 30}, {9, 30}});
    design.steps.push_back(cut);
    const auto garment = core::make_garment(design, body());
    REQUIRE(garment);
    REQUIRE(garment->faults.size() == 2);
    CHECK(garment->faults[0].step == 1);
    CHECK(garment->faults[0].sentence.find("line \"lost\"") != std::string::npos);
    CHECK(garment->faults[1].sentence.find("region \"nowhere\"") != std::string::npos);
    CHECK(garment->layers[0].fitted.pieces.size() == 2);
    CHECK_FALSE(core::make_garment(design, core::TriangleMesh{}));
}

TEST_CASE("a design is read back as it was written, and makes the same garment", "[design_file]") {
    Design design = half_tube();
    design.body[core::Measure::Waist] = 71.5;
    design.fitting.fairing = core::Fairing::Particles;
    DesignStep step;
    for (const Kind kind : {Kind::Cut, Kind::Hole, Kind::Remove, Kind::Corner, Kind::Alpha, Kind::Move, Kind::Weld,
                            Kind::Layer, Kind::Associate}) {
        step.kind = kind;
        step.name = "n";
        step.region = "front";
        step.at = {1, 2.5, 3};
        step.to = {0.1, 1e-7, -3};
        step.radius = 4;
        step.on = false;
        step.alpha = -0.125;
        step.parts = core::part_bit(core::BodyPart::Torso) | core::part_bit(core::BodyPart::LegRight);
        step.starts_at = "waist_left";
        step.stroke = {
            {*core::perspective_view({30, 40, 50}, {1, 2, 3}), {Tool::Temporary, 0.0}, {{0.1, 0.2}, {1, 3}}}};
        design.steps.push_back(step);
    }
    const std::string text = core::design_text(design);
    const auto read = core::parse_design(text);
    REQUIRE(read);
    const auto again = core::parse_design(core::design_text(*read));
    REQUIRE(again);
    CHECK(core::design_text(*again) == core::design_text(*read));
    CHECK(read->body.cm == design.body.cm);
    CHECK(read->steps.size() == design.steps.size());
    const Design plain = half_tube();
    const auto reread = core::parse_design(core::design_text(plain));
    REQUIRE(reread);
    CHECK(core::design_text(*reread) == core::design_text(plain));
    CHECK(core::make_garment(*reread, body())->layers[0].fitted.mesh.vertices ==
          core::make_garment(plain, body())->layers[0].fitted.mesh.vertices);
}

TEST_CASE("a design cut short or wrong is refused in one sentence", "[design_file]") {
    const std::string text = core::design_text(half_tube());
    for (const std::size_t length : {std::size_t{0}, std::size_t{1}, text.size() / 3, text.size() / 2, text.size() - 3})
        CHECK_FALSE(core::parse_design(text.substr(0, length)));
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string changed = text;
        const std::size_t at = changed.find(from);
        REQUIRE(at != std::string::npos);
        changed.replace(at, from.size(), to);
        const auto design = core::parse_design(changed);
        return design ? std::string() : design.error().message;
    };
    CHECK(with(version_text(core::kDesignVersion), version_text(99)).find("newer") != std::string::npos);
    for (const int version : {0, -1})
        CHECK(with(version_text(core::kDesignVersion), version_text(version)).find("below 1") != std::string::npos);
    CHECK(with(version_text(core::kDesignVersion), "\"version\": 4294967297").find("newer") != std::string::npos);
    CHECK(with("\"points\":[[", "\"points\":[[1e5,0],[").find("20 m") != std::string::npos);
    CHECK(with("croquis-garment", "other").find("format") != std::string::npos);
    CHECK(with("\"size\": \"38\"", "\"size\": \"99\"").find("36 to 44") != std::string::npos);
    CHECK(with("\"do\":\"line\"", "\"do\":\"fly\"").find("step 1: there is no step \"fly\"") != std::string::npos);
    CHECK(with("\"view\":\"top\"", "\"view\":\"below\"").find("below") != std::string::npos);
    CHECK(with("\"tool\":\"plane_xz\"", "\"tool\":\"nail\"").find("nail") != std::string::npos);
    CHECK(with("\"offset\":40.0", "\"offset\":\"x\"").find("offset") != std::string::npos);
    CHECK(core::read_design("/nowhere.json").error().code == core::ErrorCode::FileMissing);
}

TEST_CASE("a design of an older version is read and makes the same garment", "[design_file]") {
    const Design design = half_tube();
    const std::string current = version_text(core::kDesignVersion);
    for (int version = 1; version < core::kDesignVersion; ++version) {
        std::string text = core::design_text(design);
        REQUIRE(text.find(current) != std::string::npos);
        text.replace(text.find(current), current.size(), version_text(version));
        const auto read = core::parse_design(text);
        REQUIRE(read);
        CHECK(core::make_garment(*read, body())->layers[0].fitted.mesh.vertices ==
              core::make_garment(design, body())->layers[0].fitted.mesh.vertices);
    }
}
