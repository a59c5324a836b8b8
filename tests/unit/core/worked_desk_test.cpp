// The worked designs drawn by the pen at the desk, against the engine's own.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "core/exchange/design_file.hpp"
#include "core/garment/wardrobe.hpp"
#include "support/desk_hand.hpp"

using core::DesignStep;
using core::DeskTool;
using Kind = DesignStep::Kind;

namespace {

const core::Mannequin& woman() {
    static const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    return body;
}
const core::DressForm& form() {
    static const core::DressForm made = core::dress_form(woman());
    return made;
}

/// The strokes of a design by the pen; regions close by themselves.
core::GarmentDesk drawn_at_desk(const core::Design& design) {
    core::Design start = design;
    start.steps.clear();
    auto desk = core::GarmentDesk::open(start, form());
    REQUIRE(desk);
    support::DeskHand hand(*desk);
    desk->settings().to_landmarks = false;
    desk->settings().cuts_on_body = true;
    for (const DesignStep& step : design.steps) {
        core::DeskReply reply;
        if (step.kind == Kind::Line)
            reply = hand.replay(step.stroke, DeskTool::DrawOnBody);
        else if (step.kind == Kind::Cut || step.kind == Kind::Hole)
            reply = hand.replay(step.stroke, step.kind == Kind::Cut ? DeskTool::Cut : DeskTool::Hole);
        else if (step.kind == Kind::Layer)
            reply = desk->new_layer();
        else
            continue;
        INFO(step.name << (reply.notes.empty() ? std::string() : ": " + reply.notes[0].sentence));
        CHECK(reply.changed);
        CHECK(reply.notes.empty());
    }
    return std::move(*desk);
}

double distance_to(const core::QuadMesh& mesh, core::Vec3 p) {
    double least = 1e9;
    for (const core::Quad& q : mesh.quads)
        for (const auto& t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
            const core::Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
            const core::Vec3 n = core::cross(b - a, c - a);
            if (core::length(a - p) > least + 12.0) continue;
            // onto the plane when inside, else to its edges
            const double d = core::dot(p - a, n) / std::max(1e-12, core::length(n));
            const core::Vec3 on = p - core::normalised(n) * d;
            const bool inside = core::dot(core::cross(b - a, on - a), n) >= 0 &&
                                core::dot(core::cross(c - b, on - b), n) >= 0 &&
                                core::dot(core::cross(a - c, on - c), n) >= 0;
            if (inside) {
                least = std::min(least, std::abs(d));
                continue;
            }
            for (const auto& [u, v] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
                least = std::min(least, core::nearest_on_line({u, v}, p).distance);
        }
    return least;
}

double farthest(const core::QuadMesh& a, const core::QuadMesh& b) {
    double most = 0.0;
    for (std::size_t v = 0; v < a.vertices.size(); v += 3) most = std::max(most, distance_to(b, a.vertices[v]));
    return most;
}

}  // namespace

TEST_CASE("worked designs drawn by the pen are the engine's", "[worked_desk]") {
    for (const char* name : {"dress", "outfit", "jacket"}) {
        DYNAMIC_SECTION(name) {
            const core::Design design = *core::wardrobe_design(name, woman());
            const auto engine = core::make_garment(design, form());
            REQUIRE(engine);
            core::GarmentDesk desk = drawn_at_desk(design);
            desk.build_now();
            REQUIRE(desk.cloth().size() == engine->layers.size());
            for (std::size_t k = 0; k < engine->layers.size(); ++k) {
                const core::Cloth &own = desk.cloth()[k].cloth->fitted, &other = engine->layers[k].fitted;
                const auto quads = [](const core::Cloth& cloth) {
                    std::multiset<std::size_t> counts;
                    for (const core::ClothPiece& piece : cloth.pieces) counts.insert(piece.count);
                    return counts;
                };
                CHECK(quads(own) == quads(other));
                const double most = std::max(farthest(own.mesh, other.mesh), farthest(other.mesh, own.mesh));
                WARN(name << " layer " << k + 1 << ": " << own.pieces.size() << " pieces, " << own.mesh.quads.size()
                          << " quads, surfaces at most " << most << " cm apart");
                CHECK(most <= 0.5);
            }
        }
    }
}
