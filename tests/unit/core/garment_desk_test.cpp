#include "core/garment/desk/garment_desk.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "core/exchange/design_file.hpp"
#include "core/garment/desk/pen_places.hpp"
#include "support/desk_hand.hpp"
#include "support/simple_body.hpp"

using core::DesignStep;
using core::DeskReply;
using core::DeskTool;
using core::GarmentDesk;
using support::DeskHand;
using Points = std::vector<core::Point>;

namespace {

core::DressForm post_form() {
    core::DressForm form;
    form.mesh = support::post(10.0, 60.0);
    return form;
}

core::Design empty_design() {
    core::Design design;
    design.name = "skirt";
    design.body = *core::measures_of_size("38");
    return design;
}

GarmentDesk empty_desk() {
    static const core::DesignRunner post = *core::DesignRunner::start(empty_design(), post_form());
    return GarmentDesk::open(empty_design(), post);
}

/// The lines of a skirt round the post, from y = 45 to y = 15.
DeskReply waist(DeskHand hand) {
    return hand.on_body("front", 0.6, {{0, 45}, {5, 45}, {9, 45}, {10.6, 45}});
}
DeskReply waist_back(DeskHand hand) {
    return hand.on_body("back", 0.6, {{0, 45}, {-5, 45}, {-9, 45}, {-10.6, 45}});
}
DeskReply side(DeskHand hand) {
    return hand.on_plane("front", 0.0, {{10.6, 45}, {13, 30}, {17, 15}});
}
DeskReply hem(DeskHand hand) {
    return hand.on_plane("top", 15.0, {{17, 0}, {15.7, -6.5}, {12, -12}, {6.5, -15.7}, {0, -17}});
}
DeskReply hem_back(DeskHand hand) {
    return hand.on_plane("top", 15.0, {{17, 0}, {15.7, 6.5}, {12, 12}, {6.5, 15.7}, {0, 17}});
}
DeskReply middle(DeskHand hand) {
    return hand.on_plane("left", 0.0, {{-10.6, 45}, {-13, 30}, {-17, 15}});
}
DeskReply middle_back(DeskHand hand) {
    return hand.on_plane("left", 0.0, {{10.6, 45}, {13, 30}, {17, 15}});
}

std::set<std::string> regions_of(const GarmentDesk& desk) {
    std::set<std::string> names;
    for (const core::NetworkRegion& region : desk.network().regions())
        if (region.alive) names.insert(region.name);
    return names;
}

void skirt(GarmentDesk& desk) {
    DeskHand hand(desk);
    for (auto* line : {waist, side, hem, middle, waist_back, hem_back, middle_back}) {
        const DeskReply reply = line(hand);
        INFO((reply.notes.empty() ? std::string() : reply.notes[0].sentence));
        REQUIRE(reply.changed);
        REQUIRE(reply.notes.empty());
    }
}

}  // namespace

TEST_CASE("four strokes make the front of a skirt, three more its back", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    CHECK(waist(hand).changed);
    CHECK(desk.open_places().size() == 2);
    desk.settings().closes_middle = false;
    CHECK(side(hand).changed);
    CHECK(hem(hand).changed);
    CHECK(regions_of(desk).empty());
    CHECK(middle(hand).changed);
    CHECK(regions_of(desk) == std::set<std::string>{"front"});
    CHECK(desk.open_places().empty());
    waist_back(hand), hem_back(hand);
    const std::vector<core::DeskNote> open = desk.open_places();
    REQUIRE(open.size() == 2);
    CHECK(open[0].key == core::DeskNote::Key::OpenMiddle);
    CHECK(open[0].gap_cm > 10.0);
    middle_back(hand);
    CHECK(regions_of(desk) == std::set<std::string>{"back", "front"});
    desk.build_now();
    REQUIRE(desk.cloth().size() == 1);
    CHECK(desk.cloth_faults().empty());
    CHECK(desk.cloth()[0].cloth->fitted.pieces.size() == 4);
    CHECK(desk.cloth()[0].cloth->report.deepest_after_cm == 0.0);
    CHECK(desk.history().size() == 7);
    CHECK(desk.network().inconsistency().empty());
}

TEST_CASE("outlines close whatever the order of their lines", "[garment_desk]") {
    using Draw = DeskReply (*)(DeskHand);
    std::vector<std::pair<std::string, Draw>> lines{
        {"waist", waist},
        {"side", side},
        {"hem", hem},
        {"middle", middle},
        {"across", [](DeskHand hand) {
             return hand.on_body("front", 1.5, {{0, 32}, {4, 32}, {8, 32}, {13, 32}});
         }}};
    std::vector<std::size_t> order{0, 1, 2, 3, 4};
    std::set<std::set<std::set<std::string>>> outcomes;
    int tried = 0;
    do {
        if (++tried % 7 != 0) continue;
        GarmentDesk desk = empty_desk();
        desk.settings().closes_middle = tried % 2 == 0;
        std::map<std::string, std::string> drawn;  // what each line is called
        for (const std::size_t k : order) {
            REQUIRE(lines[k].second(DeskHand(desk)).changed);
            for (const core::DesignStep& step : desk.design().steps)
                if (step.kind == core::DesignStep::Kind::Line && step.name.rfind("line", 0) == 0 &&
                    drawn.count(step.name) == 0)
                    drawn[step.name] = lines[k].first;
        }
        std::set<std::set<std::string>> rings;
        for (const core::NetworkRegion& region : desk.network().regions()) {
            if (!region.alive) continue;
            std::set<std::string> ring;
            for (const core::LineUse use : region.ring)
                ring.insert(drawn[desk.network().lines()[static_cast<std::size_t>(use.line)].name]);
            rings.insert(ring);
        }
        CHECK(rings.size() == 2);
        std::string said;
        for (const std::size_t k : order) said += lines[k].first + " ";
        for (const auto& ring : rings) {
            said += "|";
            for (const std::string& name : ring) said += " " + (name.empty() ? "middle by itself" : name);
        }
        outcomes.insert(rings);
        CAPTURE(said);
        CHECK(outcomes.size() == 1);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("all undone and done again gives the same file, byte for byte", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    DeskHand hand(desk);
    REQUIRE(hand.draw(DeskTool::Cut, "front", {{0, 34}, {6, 34}, {12, 34}}).changed);
    REQUIRE(desk.set_alpha("front", -0.1).changed);
    const std::string drawn = core::design_text(desk.design());
    const std::size_t acts = desk.history().size();
    std::vector<std::string> back;
    while (desk.can_undo()) {
        back.push_back(core::design_text(desk.design()));
        REQUIRE(desk.undo().changed);
    }
    CHECK(back.size() == acts);
    CHECK(desk.design().steps.empty());
    CHECK(desk.network().lines().empty());
    while (desk.can_redo()) {
        REQUIRE(desk.redo().changed);
        CHECK(core::design_text(desk.design()) == back.back());
        back.pop_back();
    }
    CHECK(core::design_text(desk.design()) == drawn);

    // read back it is the same design with the same history
    auto read = core::parse_design(drawn);
    REQUIRE(read);
    auto again = GarmentDesk::open(*read, post_form());
    REQUIRE(again);
    CHECK(again->faults().empty());
    CHECK(core::design_text(again->design()) == drawn);
    CHECK(again->history().size() == acts);

    // and the journal played on an empty desk gives it too
    GarmentDesk other = empty_desk();
    for (const core::JournalEvent& event : desk.take_journal()) REQUIRE(other.replay(event));
    CHECK(core::design_text(other.design()) == drawn);
}

namespace {

core::SpaceLine line_named(const GarmentDesk& desk, const std::string& name) {
    const int line = desk.network().line_named(name);
    REQUIRE(line >= 0);
    return desk.network().lines()[static_cast<std::size_t>(line)].shape;
}

void whole_skirt_sound(GarmentDesk& desk, std::size_t pieces) {
    CHECK(desk.network().inconsistency().empty());
    desk.build_now();
    for (const core::DeskNote& fault : desk.cloth_faults()) FAIL_CHECK(fault.name << ": " << fault.sentence);
    REQUIRE_FALSE(desk.cloth().empty());
    CHECK(desk.cloth()[0].cloth->fitted.pieces.size() == pieces);
}

}  // namespace

TEST_CASE("a piece is cut, gets a hole, and what was taken away stays away", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    DeskHand hand(desk);
    REQUIRE(hand.draw(DeskTool::Cut, "front", {{0, 34}, {6, 34}, {13, 34}}).changed);
    CHECK(regions_of(desk) == std::set<std::string>{"back", "front", "front 2"});
    Points ring;
    for (int k = 0; k <= 24; ++k) ring.push_back({7 + 2.5 * std::cos(k * 0.2618), 24 + 2.5 * std::sin(k * 0.2618)});
    REQUIRE(hand.draw(DeskTool::Hole, "front", ring).changed);
    CHECK(regions_of(desk).size() == 4);
    whole_skirt_sound(desk, 8);
    // the hole is not filled by the next line drawn; nor is a piece that was taken away
    REQUIRE(hand.tap(DeskTool::RemoveRegion, "back", {-8, 30}).changed);
    CHECK(regions_of(desk).count("back") == 0);
    REQUIRE(hand.on_body("front", 1.0, {{2, 52}, {8, 52}}).changed);
    CHECK(regions_of(desk).size() == 3);
    REQUIRE(desk.undo().changed);
    REQUIRE(desk.undo().changed);
    CHECK(regions_of(desk).count("back") == 1);
}

TEST_CASE("a tap of Add fills an outline that was emptied, a stroke adds a piece from edge to edge", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    DeskHand hand(desk);
    REQUIRE(hand.tap(DeskTool::Erase, "front", {14, 25.5}).changed);  // without the side the two are one piece
    CHECK(regions_of(desk).size() == 1);
    REQUIRE(desk.undo().changed);
    CHECK(regions_of(desk).size() == 2);
    REQUIRE(hand.draw(DeskTool::Cut, "front", {{0, 34}, {6, 34}, {13, 34}}).changed);
    REQUIRE(hand.draw(DeskTool::Cut, "front", {{0, 25}, {6, 25}, {14, 25}}).changed);
    const std::size_t pieces = regions_of(desk).size();
    REQUIRE(hand.tap(DeskTool::RemoveRegion, "front", {6, 30}).changed);
    REQUIRE(regions_of(desk).size() == pieces - 1);
    REQUIRE(desk.undo().changed);
    // a flounce below the hem, from its one end to the other
    REQUIRE(hand.draw(DeskTool::Add, "front", {{17, 15}, {15, 8}, {7, 6}, {2, 9}, {0, 15}}).changed);
    CHECK(regions_of(desk).size() == pieces + 1);
    const std::size_t acts = desk.history().size();
    REQUIRE(desk.undo().changed);
    CHECK(regions_of(desk).size() == pieces);
    REQUIRE(desk.redo().changed);
    CHECK(regions_of(desk).size() == pieces + 1);
    CHECK(desk.history().size() == acts);
    const DeskReply nothing = hand.tap(DeskTool::Add, "front", {40, 40});
    CHECK_FALSE(nothing.changed);
    REQUIRE(nothing.notes.size() == 1);
    CHECK(nothing.notes[0].key == core::DeskNote::Key::NothingHere);
}

TEST_CASE("corners, folds, smoothing, moving and joining change lines where the pen is", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    DeskHand hand(desk);
    const std::string before = core::design_text(desk.design());
    const std::size_t corners = desk.network().find_region("front")->corners.size();
    REQUIRE(hand.tap(DeskTool::Corner, "left", {-17, 15}).changed);
    CHECK(desk.network().find_region("front")->corners.size() == corners - 1);
    REQUIRE(hand.tap(DeskTool::Corner, "left", {-17, 15}).changed);
    CHECK(desk.network().find_region("front")->corners.size() == corners);

    const double plain = core::line_length(line_named(desk, "line 3"));
    desk.settings().wave_cm = 6.0;
    REQUIRE(hand.draw(DeskTool::Bump, "top", {{16, -5}, {12, -12}, {3, -16.7}}).changed);
    const double wavy = core::line_length(line_named(desk, "line 3"));
    CHECK(wavy > 1.15 * plain);
    REQUIRE(hand.tap(DeskTool::Smooth, "top", {12, -12}).changed);
    CHECK(core::line_length(line_named(desk, "line 3")) < 0.5 * (plain + wavy));

    const core::Vec3 corner = line_named(desk, "line 3").front();
    REQUIRE(hand.draw(DeskTool::Move, "front", {{corner.x, corner.y}, {corner.x + 3, corner.y - 2}}).changed);
    const core::Vec3 moved = line_named(desk, "line 3").front();
    CHECK(core::length(moved - corner) == Approx(std::sqrt(13.0)).margin(1e-6));
    const core::Vec3 middle = line_named(desk, "line 3").back();
    CHECK(middle.x == 0.0);
    REQUIRE(hand.draw(DeskTool::Move, "front", {{middle.x, middle.y}, {middle.x + 3, middle.y - 2}}).changed);
    CHECK(line_named(desk, "line 3").back().x == 0.0);  // the middle stays in the middle
    CHECK(line_named(desk, "line 3").back().y == Approx(middle.y - 2));
    whole_skirt_sound(desk, 4);
    while (desk.history_place() > 7) REQUIRE(desk.undo().changed);
    CHECK(core::design_text(desk.design()) == before);
}

TEST_CASE("a line that is moved near the middle leaves the middle where it is", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    desk.build_now();
    const auto in_the_middle = [&] {
        std::size_t count = 0;
        for (const core::NetworkLine& line : desk.network().lines())
            if (line.alive && line.layer == desk.layer())
                count += static_cast<std::size_t>(
                    std::count_if(line.shape.begin(), line.shape.end(), [](core::Vec3 p) { return p.x == 0.0; }));
        return count;
    };
    const std::size_t before = in_the_middle();
    REQUIRE(before > 20);
    desk.settings().tool = DeskTool::Move;
    const core::DrawingView top = *core::named_view("top");
    desk.begin(top, {6.5, -15.7});
    desk.extend(top, {7.5, -15.7});
    desk.extend(top, {9, -15.7});
    for (const core::NetworkVertex& vertex : desk.shown_network().vertices())
        CHECK((!vertex.alive || vertex.place.x >= 0.0));
    REQUIRE(desk.end().changed);
    CHECK(in_the_middle() == before);
    whole_skirt_sound(desk, 4);
    // not mirrored, the middle is a place like others
    REQUIRE(desk.undo().changed);
    REQUIRE(desk.set_mirror(false).changed);
    DeskHand hand(desk);
    REQUIRE(hand.draw(DeskTool::Move, "top", {{6.5, -15.7}, {9, -15.7}}).changed);
    CHECK(in_the_middle() < before);
}

TEST_CASE("strokes go on in another view, and in the temporary plane through the last point", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    waist(hand);
    // the side in the front view, then on in the temporary plane: a hem drawn from the front
    desk.settings().tool = DeskTool::DrawOnPlane;
    desk.settings().plane_cm = 0.0;
    const core::DrawingView front = *core::named_view("front");
    desk.begin(front, {10.6, 45});
    hand.follow(front, {{10.6, 45}, {13, 30}, {17, 15}});
    desk.pause();
    CHECK(desk.is_open());
    desk.settings().tool = DeskTool::DrawTemporary;
    desk.begin(front, {17, 15});
    hand.follow(front, {{17, 15}, {12, 3}, {4, -3}, {0, -3.5}});
    REQUIRE(desk.preview().plane);
    CHECK(core::length(desk.preview().plane->origin - core::Vec3{17, 15, 0}) < 0.3);
    REQUIRE(desk.end().changed);
    core::Vec3 last;
    for (const core::NetworkLine& line : desk.network().lines()) last = line.shape.back();
    CHECK(last.y == Approx(15.0).margin(0.1));
    CHECK(last.z == Approx(18.5).margin(0.3));
    // a line of its own, hung on the vertex under the pen
    REQUIRE(hand.draw(DeskTool::DrawTemporary, "front", {{17, 15}, {14, 20}, {9, 26}}).changed);
    CHECK(desk.network().lines().back().shape.back().z < -10.0);
    CHECK(desk.network().lines().back().shape.back().y == Approx(15.0).margin(0.3));
}

TEST_CASE("parts of a piece are of its cloth and keep its corners, by Cut, Hole or a line across", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    skirt(desk);
    REQUIRE(desk.set_material("front", {"#8c4a43", "linen"}).changed);
    // a corner half way down the side
    REQUIRE(hand.tap(DeskTool::Corner, "front", {13, 30}).changed);
    const auto corner_on = [&](const std::string& piece, double y) {
        const core::NetworkRegion& region = *desk.network().find_region(piece);
        return std::any_of(region.corners.begin(), region.corners.end(), [&](int v) {
            return std::abs(desk.network().vertices()[static_cast<std::size_t>(v)].place.y - y) < 0.5;
        });
    };
    REQUIRE(corner_on("front", 30));
    const std::size_t before = desk.history().size();
    SECTION("Cut") {
        REQUIRE(hand.draw(DeskTool::Cut, "front", {{0, 38}, {6, 38}, {12, 38}}).changed);
    }
    SECTION("a line across") {
        desk.settings().offset_cm = 1.0;
        REQUIRE(hand.draw(DeskTool::DrawOnBody, "front", {{0, 38}, {6, 38}, {11.6, 38}}).changed);
    }
    SECTION("Hole") {
        REQUIRE(hand.draw(DeskTool::Hole, "front", {{4, 36}, {8, 36}, {8, 40}, {4, 40}, {4, 36.2}}).changed);
    }
    CHECK(desk.history().size() == before + 1);
    std::size_t dyed = 0, with_corner = 0;
    for (const std::string& piece : regions_of(desk)) {
        if (piece.rfind("front", 0) != 0) continue;
        ++dyed;
        const auto material = desk.state().look().materials.find(piece);
        REQUIRE(material != desk.state().look().materials.end());
        CHECK(material->second.fabric == "linen");
        with_corner += corner_on(piece, 30) ? 1 : 0;
    }
    CHECK(dyed == 2);
    CHECK(with_corner == 1);
}

TEST_CASE("quads are as long as the designer says, in one act", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    desk.build_now();
    const std::size_t coarse = desk.cloth()[0].cloth->fitted.mesh.quads.size(), acts = desk.history().size();
    REQUIRE(desk.set_edge(2.0).changed);
    REQUIRE(desk.set_edge(1.6).changed);
    CHECK(desk.history().size() == acts + 1);
    CHECK_FALSE(desk.set_edge(1.6).changed);
    CHECK_FALSE(desk.set_edge(0.1).changed);
    CHECK(desk.set_edge(0.1).notes.size() == 1);
    CHECK(desk.network().options().edge_cm == 1.6);
    desk.build_now();
    CHECK(desk.cloth()[0].cloth->fitted.mesh.quads.size() > 2 * coarse);
    const auto read = core::parse_design(core::design_text(desk.design()));
    REQUIRE(read);
    const auto garment = core::make_garment(*read, post_form());
    REQUIRE(garment);
    CHECK(garment->layers[0].fitted.mesh.vertices == desk.cloth()[0].cloth->fitted.mesh.vertices);
    REQUIRE(desk.undo().changed);
    CHECK(desk.network().options().edge_cm == core::NetworkOptions{}.edge_cm);
    // a desk on the same body finds what was finished
    GarmentDesk other = GarmentDesk::open(*read, desk.state());
    other.build_now();
    desk.undo();
    CHECK(other.cloth()[0].cloth->fitted.mesh.vertices == garment->layers[0].fitted.mesh.vertices);
}

TEST_CASE("an outline is filled in the same way wherever its ring began", "[garment_desk]") {
    std::set<std::size_t> quads;
    for (const bool front_first : {true, false}) {
        GarmentDesk desk = empty_desk();
        DeskHand hand(desk);
        std::vector<DeskReply (*)(DeskHand)> lines{waist, side, hem, middle};
        if (!front_first) std::rotate(lines.begin(), lines.begin() + 2, lines.end());
        for (auto* line : lines) REQUIRE(line(hand).changed);
        desk.build_now();
        REQUIRE(desk.cloth()[0].cloth->fitted.pieces.size() == 2);
        quads.insert(desk.cloth()[0].cloth->fitted.mesh.quads.size());
    }
    CHECK(quads.size() == 1);
}

TEST_CASE("a line goes on from stroke to stroke, each in its own view, as one act", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    REQUIRE(waist(hand).changed);
    const core::DrawingView front = *core::named_view("front"), left = *core::named_view("left");
    CHECK_FALSE(desk.go_on(front, {30, 30}));
    // from the waist's loose end: the waist itself, first in a plane, then in another view by taps
    REQUIRE(desk.go_on(front, {10.6, 45}));
    CHECK(desk.line_going_on()->name == "line 1");
    REQUIRE(hand.on_plane("front", -1.0, {{11.0, 44}, {12.0, 40}, {12.5, 36}}).changed);
    CHECK(desk.history().size() == 1);
    CHECK(desk.goes_on());
    desk.settings().plane_cm = 12.5;
    desk.begin(left, {4.0, 33.0});
    REQUIRE(desk.end_tapped().changed);
    CHECK(desk.history().size() == 1);
    const DesignStep step = desk.design().steps.front();
    REQUIRE(step.stroke.size() == 3);
    CHECK(step.stroke[1].tool.offset == -1.0);
    CHECK(step.stroke[2].points.size() == 1);
    const core::SpaceLine line = desk.network().lines()[0].shape;
    CHECK(core::length(line.back() - core::Vec3{12.5, 33.0, -4.0}) < 0.01);
    CHECK(desk.line_going_on()->end == line.back());
    SECTION("undo takes back stroke by stroke, then the whole line") {
        REQUIRE(desk.undo().changed);
        CHECK(desk.design().steps.front().stroke.size() == 2);
        REQUIRE(desk.undo().changed);
        CHECK(desk.design().steps.front().stroke.size() == 1);
        CHECK(desk.goes_on());
        CHECK_FALSE(desk.undo().changed);  // nothing of it was drawn since it was touched
        CHECK_FALSE(desk.goes_on());
        REQUIRE(desk.undo().changed);
        CHECK(desk.design().steps.empty());
    }
    SECTION("a tap on its end finishes it; the next stroke is another line") {
        desk.begin(left, {4.0, 33.0});
        CHECK_FALSE(desk.end_tapped().changed);
        CHECK_FALSE(desk.goes_on());
        REQUIRE(side(hand).changed);
        CHECK(desk.history().size() == 2);
        // the journal plays it all again
        GarmentDesk other = empty_desk();
        for (const core::JournalEvent& event : desk.take_journal()) REQUIRE(other.replay(event));
        CHECK(core::design_text(other.design()) == core::design_text(desk.design()));
    }
    SECTION("a tap on another vertex ends it there, whatever the plane") {
        desk.settings().plane_cm = 3.0;
        desk.begin(front, {0.0, 45.0});
        REQUIRE(desk.end_tapped().changed);
        CHECK_FALSE(desk.goes_on());
        CHECK(desk.open_places().empty());
    }
    SECTION("another tool, an act and an undone act end it") {
        desk.settings().tool = DeskTool::Erase;
        desk.begin(front, {30, 30});
        (void)desk.end();
        CHECK_FALSE(desk.goes_on());
        CHECK(desk.history().size() == 1);
        REQUIRE(desk.go_on(left, {4.0, 33.0}));
        REQUIRE(desk.set_mirror(false).changed);
        CHECK_FALSE(desk.goes_on());
    }
    SECTION("a stroke that cannot be lifted is told, and the line stays and goes on") {
        desk.settings().tool = DeskTool::DrawOnBody;
        desk.begin(front, {70, 30});
        desk.extend(front, {71, 31});
        const DeskReply reply = desk.end();
        CHECK(reply.notes.size() == 1);
        CHECK(desk.goes_on());
        CHECK(desk.network().lines()[0].shape == line);
    }
}

TEST_CASE("a line begins at a vertex that was tapped, and goes on in any plane", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    REQUIRE(waist(hand).changed);
    REQUIRE(side(hand).changed);
    const core::DrawingView front = *core::named_view("front");
    // where two lines meet none goes on: a new one begins
    REQUIRE(desk.go_on(front, {10.6, 45}));
    CHECK(desk.line_going_on()->name.empty());
    CHECK_FALSE(desk.undo().changed);
    CHECK_FALSE(desk.goes_on());
    REQUIRE(desk.go_on(front, {10.6, 45}));
    const core::Vec3 vertex = desk.line_going_on()->end;
    REQUIRE(hand.on_body("back", 0.6, {{-10.0, 44}, {-6, 43}, {-3, 43}}).changed);
    const core::NetworkLine& line = desk.network().lines().back();
    CHECK(desk.network().vertices()[static_cast<std::size_t>(line.from)].place == vertex);
    CHECK(line.shape[line.shape.size() / 2].z < -5.0);  // on the back, where it was drawn
    REQUIRE(desk.undo().changed);
    CHECK(desk.goes_on());
    CHECK(desk.line_going_on()->end == vertex);
    CHECK(desk.history_place() == 2);
}

TEST_CASE("the temporary plane may be moved off its point; planes that were put keep their ends", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    REQUIRE(side(hand).changed);
    desk.settings().temporary_cm = -4.0;
    REQUIRE(hand.draw(DeskTool::DrawTemporary, "front", {{17, 15}, {12, 15}, {12, 22}}).changed);
    const core::SpaceLine line = desk.network().lines().back().shape;  // behind its sharp turn
    CHECK(line.back().y == Approx(11.0).margin(0.05));
    CHECK(line.back().z == Approx(-7.0).margin(0.05));
}

TEST_CASE("the tool that the pen came down with is the one that ends the stroke", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    desk.build_now();
    const core::DrawingView front = *core::named_view("front");
    const std::string before = core::design_text(desk.design());
    desk.settings().tool = DeskTool::Move;
    desk.begin(front, {17, 15});
    desk.extend(front, {18, 16});
    desk.settings().tool = DeskTool::Cut;
    desk.extend(front, {20, 17});
    REQUIRE(desk.end().changed);
    CHECK(desk.design().steps.back().kind == core::DesignStep::Kind::Move);
    REQUIRE(desk.undo().changed);
    desk.settings().tool = DeskTool::Cut;
    desk.begin(front, {0, 30});
    desk.settings().tool = DeskTool::DrawOnBody;
    desk.extend(front, {6, 30});
    desk.extend(front, {13, 30});
    REQUIRE(desk.end().changed);
    CHECK(desk.design().steps.back().kind == core::DesignStep::Kind::Cut);
    REQUIRE(desk.undo().changed);
    CHECK(core::design_text(desk.design()) == before);
}

TEST_CASE("what is drawn on the other half is the half's own, and a stroke across keeps its longer side",
          "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    REQUIRE(hand.on_body("front", 0.6, {{0, 45}, {-5, 45}, {-10.6, 45}}).changed);
    for (const core::Vec3& p : desk.network().lines()[0].shape) CHECK(p.x >= 0.0);
    REQUIRE(hand.on_body("front", 0.6, {{-3, 35}, {0, 35}, {5, 35}, {10, 35}}).changed);
    const core::SpaceLine across = desk.network().lines().back().shape;
    CHECK(std::min(across.front().x, across.back().x) == 0.0);
    CHECK(core::line_length(across) > 10.0);
    REQUIRE(desk.set_mirror(false).changed);
    REQUIRE(hand.on_body("front", 0.6, {{-8, 25}, {0, 25}, {8, 25}}).changed);
    CHECK(desk.network().lines().back().shape.front().x < -6.0);
}

TEST_CASE("nothing drawn is lost beside the body", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    const DeskReply half = hand.on_body("front", 0.6, {{0, 30}, {10, 30}, {80, 30}});
    CHECK(half.changed);
    REQUIRE(half.notes.size() == 1);
    CHECK(half.notes[0].key == core::DeskNote::Key::OffBody);
    CHECK(core::length(half.notes[0].place) > 10.0);
    const DeskReply beside = hand.on_body("front", 0.6, {{60, 30}, {60, 40}});
    CHECK(beside.changed);
    REQUIRE(beside.notes.size() == 1);
    CHECK(desk.network().lines().back().shape.front().x == Approx(60.0));
    const DeskReply edge_on = hand.on_plane("front", 0.0, {{20, 30}, {20.1, 30}});
    CHECK_FALSE(edge_on.changed);
    REQUIRE(edge_on.notes.size() == 1);
    CHECK(edge_on.notes[0].key == core::DeskNote::Key::TooShort);
    const DeskReply no_piece = hand.draw(DeskTool::Cut, "front", {{0, 30}, {10, 30}});
    CHECK(no_piece.notes[0].key == core::DeskNote::Key::NoRegion);
}

TEST_CASE("layers are drawn on, put in order, hidden, named; what is below is worn below", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    DeskHand hand(desk);
    REQUIRE(desk.new_layer().changed);
    CHECK(desk.layer() == 1);
    const auto pocket = [&](double offset) {
        return hand.on_body("front", offset, {{3, 30}, {9, 30}, {9, 23}, {3, 23}, {3, 30}});
    };
    const DeskReply reply = pocket(0.5);
    INFO((reply.notes.empty() ? std::string() : reply.notes[0].sentence));
    CHECK(regions_of(desk) == std::set<std::string>{"back", "front", "front 2"});
    // on the cloth of the skirt, not on the body that is 3 cm deeper
    for (const core::Vec3& p : desk.network().lines().back().shape) CHECK(std::hypot(p.x, p.z) > 12.0);
    REQUIRE(desk.rename_layer(1, "pockets").changed);
    REQUIRE(desk.show_layer(0, false).changed);
    REQUIRE(desk.rename_region("front 2", "pocket").changed);
    REQUIRE(desk.set_material("pocket", {"#334A81", "denim"}).changed);
    std::vector<core::LayerRow> rows = desk.layers();
    REQUIRE(rows.size() == 2);
    CHECK_FALSE(rows[0].shown);
    CHECK(rows[1].name == "pockets");
    CHECK(rows[1].regions == std::vector<std::string>{"pocket"});
    CHECK(desk.state().look().materials.at("pocket").fabric == "denim");
    const std::size_t acts = desk.history().size();
    REQUIRE(desk.set_materials({{"front", {"#334A81", "linen"}}, {"back", {"#334A81", "linen"}}}).changed);
    CHECK(desk.history().size() == acts + 1);  // one press, one act
    CHECK(desk.state().look().materials.at("back").fabric == "linen");
    CHECK_FALSE(desk.set_materials({}).changed);
    REQUIRE(desk.undo().changed);
    CHECK(desk.state().look().materials.count("back") == 0);
    desk.build_now();
    REQUIRE(desk.cloth().size() == 2);
    REQUIRE(desk.move_layer(1, -1).changed);
    CHECK(desk.layers()[0].layer == 1);
    REQUIRE(desk.work_on(0).changed);
    CHECK(desk.layer() == 0);
    REQUIRE(hand.draw(DeskTool::Cut, "front", {{0, 34}, {6, 34}, {13, 34}}).changed);
    CHECK(regions_of(desk).count("front 2") == 1);
    desk.build_now();
    CHECK(desk.cloth()[0].layer == 1);
    const std::string text = core::design_text(desk.design());
    const auto read = core::parse_design(text);
    REQUIRE(read);
    auto again = GarmentDesk::open(*read, post_form());
    REQUIRE(again);
    CHECK(again->faults().empty());
    CHECK(core::design_text(again->design()) == text);
    again->build_now();
    CHECK(again->cloth()[1].cloth->fitted.mesh.vertices == desk.cloth()[1].cloth->fitted.mesh.vertices);
}

TEST_CASE("objects are placed, moved, taken off, and saved", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    REQUIRE(desk.place({"bag", "m1234.off", {30, 60, 5}, 22.0, {0, 0.5, 0}}).changed);
    REQUIRE(desk.place({"bag", "m1234.off", {35, 60, 5}, 22.0, {0, 0.5, 0}}).changed);
    REQUIRE(desk.state().look().objects.size() == 1);
    CHECK(desk.state().look().objects[0].at.x == 35.0);
    const auto read = core::parse_design(core::design_text(desk.design()));
    REQUIRE(read);
    CHECK(read->steps[1].object == desk.state().look().objects[0]);
    REQUIRE(desk.unplace("bag").changed);
    CHECK(desk.state().look().objects.empty());
    CHECK_FALSE(desk.unplace("bag").changed);
    CHECK_FALSE(desk.place({"", "x", {}, 1.0, {}}).changed);
}

TEST_CASE("cloth from a worker is taken when it is newest and asked for once", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    const auto first = desk.build_request();
    REQUIRE(first);
    CHECK_FALSE(desk.build_request());
    REQUIRE(desk.set_alpha("front", -0.05).changed);
    const auto second = desk.build_request();
    REQUIRE(second);
    const core::BuildResult late = core::build(*first, {});
    CHECK(desk.accept(core::build(*second, {})));
    CHECK(desk.cloth_is_current());
    CHECK_FALSE(desk.accept(late));
    std::stop_source stopped;
    stopped.request_stop();
    REQUIRE(desk.set_alpha("front", 0.0).changed);
    const auto third = desk.build_request();
    REQUIRE(third);
    CHECK_FALSE(desk.accept(core::build(*third, stopped.get_token())));
    CHECK(desk.build_request());  // it may be asked for again
}

TEST_CASE("live cloth is what a new build fills", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    desk.build_now();
    const core::FinishedLayer before = *desk.cloth()[0].cloth;
    // where the new filling and the old fitting lead to, unless that is in the body: then outside of it
    const core::Obstacle& body = desk.state().worn()->obstacle;
    const auto check_live = [&](core::Vec3 shown, core::Vec3 led) {
        if (body.distance(led) > 0.25) CHECK(core::length(shown - led) < 1e-6);
        CHECK(body.distance(shown) > 0.1);
    };
    desk.slide_alpha("front", -0.1);
    REQUIRE(desk.live());
    const std::vector<core::Vec3> slid = *desk.live()->places;
    REQUIRE(desk.set_alpha("front", -0.1).changed);
    desk.build_now();
    CHECK_FALSE(desk.live());
    const core::FinishedLayer after = *desk.cloth()[0].cloth;
    REQUIRE(after.drawn.mesh.vertices.size() == slid.size());
    for (std::size_t v = 0; v < slid.size(); ++v) {
        const core::Vec3 fit = before.fitted.mesh.vertices[v] - before.drawn.mesh.vertices[v];
        check_live(slid[v], after.drawn.mesh.vertices[v] + fit);
    }
    // a drag
    desk.settings().tool = DeskTool::Move;
    const core::DrawingView front = *core::named_view("front");
    desk.begin(front, {17, 15});
    desk.extend(front, {17.4, 15});
    desk.extend(front, {17.5, 14.8});
    REQUIRE(desk.live());
    const std::vector<core::Vec3> dragged = *desk.live()->places;
    REQUIRE(desk.end().changed);
    desk.build_now();
    const core::FinishedLayer moved = *desk.cloth()[0].cloth;
    REQUIRE(moved.drawn.mesh.vertices.size() == dragged.size());  // no line got another number of edges
    for (std::size_t v = 0; v < dragged.size(); ++v) {
        const core::Vec3 fit = after.fitted.mesh.vertices[v] - after.drawn.mesh.vertices[v];
        check_live(dragged[v], moved.drawn.mesh.vertices[v] + fit);
    }
}

TEST_CASE("cloth that folds less while the slider is held stays outside of the body", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    skirt(desk);
    REQUIRE(desk.set_alpha("front", -0.2).changed);
    desk.build_now();
    const std::vector<core::Vec3> fitted = desk.cloth()[0].cloth->fitted.mesh.vertices;
    for (const double alpha : {-0.1, 0.0}) {
        desk.slide_alpha("front", alpha);
        REQUIRE(desk.live());
        double least = 1e9;
        for (const core::Vec3& p : *desk.live()->places) least = std::min(least, desk.state().obstacle().distance(p));
        CHECK(least > 0.1);
    }
    desk.slide_alpha("front", -0.2);  // back where it began
    double most = 0;
    for (std::size_t v = 0; v < fitted.size(); ++v)
        most = std::max(most, core::length((*desk.live()->places)[v] - fitted[v]));
    CHECK(most < 1e-6);
}

TEST_CASE("every view in perspective is read back as it was settled", "[garment_desk]") {
    int others = 0;
    for (int k = 0; k < 4000; ++k) {
        const double azimuth = 0.0015 * k, elevation = 0.0003 * (k % 3000) - 0.4, height = 160 + k % 31;
        const core::Vec3 target{0, height / 2, 0};
        const double level = 560 * std::cos(elevation);
        const core::Vec3 eye =
            target + core::Vec3{level * std::sin(azimuth), 560 * std::sin(elevation), level * std::cos(azimuth)};
        const core::DrawingView view = core::settled(*core::perspective_view(eye, target)).view;
        const core::DrawingView again =
            *core::perspective_view(view.centre + view.toward * view.eye_distance, view.centre);
        others += core::same_view(view, again) ? 0 : 1;
        CHECK(core::length(view.centre + view.toward * view.eye_distance - eye) < 1e-4);
    }
    CHECK(others == 0);
}

TEST_CASE("strokes seen in perspective are read back as they were drawn", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    core::DrawingView view = *core::perspective_view({37.3, 51.7, 120.1}, {0.3, 30.7, 0.1});
    desk.settings().tool = DeskTool::DrawOnBody;
    desk.settings().offset_cm = 0.7;
    desk.begin(view, {-2.3, 3.1});
    hand.follow(view, {{-2.3, 3.1}, {1.7, 6.3}, {4.1, -5.2}});
    REQUIRE(desk.end().changed);
    // and in a parallel view from any side, moved aside
    core::DrawingView turned = view;
    turned.eye_distance = 0.0;
    turned.centre = {1, 28, 2};
    desk.begin(turned, {-2, 3});
    hand.follow(turned, {{-2, 3}, {3, 9}});
    REQUIRE(desk.end().changed);
    const auto read = core::parse_design(core::design_text(desk.design()));
    REQUIRE(read);
    const auto again = GarmentDesk::open(*read, post_form());
    REQUIRE(again);
    REQUIRE(again->network().lines().size() == desk.network().lines().size());
    for (std::size_t i = 0; i < desk.network().lines().size(); ++i)
        CHECK(again->network().lines()[i].shape == desk.network().lines()[i].shape);
    CHECK(core::design_text(again->design()) == core::design_text(desk.design()));
}

TEST_CASE("lines drawn past each other meet where they cross, also a line with itself", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    // like a hash sign: no end is near another line
    REQUIRE(hand.on_body("front", 1.0, {{2, 20}, {2, 45}}).changed);
    REQUIRE(hand.on_body("front", 1.0, {{9, 20}, {9, 45}}).changed);
    REQUIRE(hand.on_body("front", 1.0, {{-0.5, 25}, {10.5, 25}}).changed);
    CHECK(regions_of(desk).empty());
    REQUIRE(hand.on_body("front", 1.0, {{0.5, 40}, {10.5, 40}}).changed);
    CHECK(regions_of(desk) == std::set<std::string>{"front"});
    CHECK(desk.open_places().size() == 4);  // the upright lines, 5 cm past the others
    CHECK(desk.network().inconsistency().empty());
    desk.build_now();
    CHECK(desk.cloth_faults().empty());
    while (desk.can_undo()) desk.undo();
    REQUIRE(hand.on_body("front", 1.0, {{2, 40}, {9, 30}, {9, 40}, {2, 30}, {2, 40}}).changed);
    CHECK(desk.network().inconsistency().empty());
    CHECK(regions_of(desk).size() == 2);
}

TEST_CASE("an outline that cannot be filled stays, and says where", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    skirt(desk);
    const std::size_t acts = desk.history().size();
    // the hem's end is pulled across the waist
    desk.settings().move_radius_cm = 1.0;
    REQUIRE(hand.draw(DeskTool::Move, "front", {{17, 15}, {10, 58}}).changed);
    desk.build_now();
    CHECK(desk.history().size() == acts + 1);
    CHECK(regions_of(desk).size() == 2);
    REQUIRE_FALSE(desk.cloth_faults().empty());
    for (const core::DeskNote& fault : desk.cloth_faults()) {
        CHECK_FALSE(fault.sentence.empty());
        CHECK(fault.place != core::Vec3{});
    }
}

TEST_CASE("an outline open in the middle alone is closed there, until the designer draws that line", "[garment_desk]") {
    GarmentDesk desk = empty_desk();
    DeskHand hand(desk);
    desk.settings().closes_middle = true;
    waist(hand), side(hand);
    REQUIRE(hem(hand).changed);
    CHECK(regions_of(desk) == std::set<std::string>{"front"});
    CHECK(desk.open_places().empty());
    CHECK(desk.history().size() == 3);
    const core::SpaceLine came = line_named(desk, desk.network().lines().back().name);
    for (const core::Vec3& p : came) {
        CHECK(p.x == 0.0);
        CHECK(desk.state().obstacle().distance(p) > 0.3);
    }
    waist_back(hand), hem_back(hand);
    CHECK(regions_of(desk) == std::set<std::string>{"back", "front"});
    whole_skirt_sound(desk, 4);
    REQUIRE(hand.on_plane("left", 0.0, {{-10.6, 45}, {-16, 30}, {-17, 15}}).changed);
    CHECK(regions_of(desk) == std::set<std::string>{"back", "front"});
    double most = 0.0;
    for (const core::NetworkRegion& region : desk.network().regions())
        if (region.alive && region.name == "front")
            for (const core::LineUse use : region.ring)
                for (const core::Vec3& p : desk.network().lines()[static_cast<std::size_t>(use.line)].shape)
                    if (p.x == 0.0) most = std::max(most, p.z - 10.6 - (45 - p.y) * 6.4 / 30);
    CHECK(most > 2.0);  // it is the one drawn
    whole_skirt_sound(desk, 4);
    REQUIRE(desk.undo().changed);
    CHECK(regions_of(desk) == std::set<std::string>{"back", "front"});
}
