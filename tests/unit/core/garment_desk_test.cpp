#include "core/garment/desk/garment_desk.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "core/exchange/design_file.hpp"
#include "support/desk_hand.hpp"
#include "support/simple_body.hpp"

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

GarmentDesk empty_desk() {
    core::Design design;
    design.name = "skirt";
    design.body = *core::measures_of_size("38");
    auto desk = GarmentDesk::open(design, post_form());
    REQUIRE(desk);
    return std::move(*desk);
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
    CHECK(side(hand).changed);
    CHECK(hem(hand).changed);
    CHECK(regions_of(desk).empty());
    CHECK(middle(hand).changed);
    CHECK(regions_of(desk) == std::set<std::string>{"front"});
    CHECK(desk.open_places().empty());
    waist_back(hand), hem_back(hand);
    const std::vector<core::DeskNote> open = desk.open_places();
    REQUIRE(open.size() == 2);
    CHECK(open[0].key == "open_middle");
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
        std::map<std::string, std::string> drawn;  // what each line is called
        for (const std::size_t k : order) {
            REQUIRE(lines[k].second(DeskHand(desk)).changed);
            for (const core::DesignStep& step : desk.design().steps)
                if (step.kind == core::DesignStep::Kind::Line && drawn.count(step.name) == 0)
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
        outcomes.insert(rings);
    } while (std::next_permutation(order.begin(), order.end()));
    CHECK(outcomes.size() == 1);
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
