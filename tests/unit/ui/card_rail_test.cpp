#include "ui/screens/card_rail.hpp"

#include <catch2/catch.hpp>

namespace {

ui::CardFace face(int model) {
    return {model, "m" + std::to_string(model), "", {}, ui::PictureId{model}};
}

}  // namespace

TEST_CASE("cards fade in one after the other", "[rail]") {
    ui::CardRail rail;
    rail.set({face(1), face(2)});
    rail.update(1'000'000);
    CHECK(rail.slots(1'000'000)[0].mix == 0);
    CHECK(rail.slots(1'080'000)[0].mix == Approx(0.5));
    CHECK(rail.slots(1'080'000)[1].mix == Approx(0.25));
    CHECK(rail.slots(1'200'000)[1].mix == 1);
    CHECK_FALSE(rail.moving(1'300'000));
}

TEST_CASE("cards change at most every quarter of a second", "[rail]") {
    ui::CardRail rail;
    rail.set({face(1)});
    rail.update(1'000'000);
    rail.set({face(2)});
    rail.update(1'100'000);
    CHECK(rail.slots(1'100'000)[0].now == face(1));
    rail.set({face(3)});  // newer than the one that waited
    rail.update(1'250'000);
    CHECK(rail.slots(1'250'000)[0].now == face(3));
    CHECK(rail.slots(1'250'000)[0].before == face(1));
    CHECK_FALSE(rail.slots(1'500'000)[0].before.has_value());
}

TEST_CASE("a card that stays does not blink", "[rail]") {
    ui::CardRail rail;
    rail.set({face(1), face(2)});
    rail.update(1'000'000);
    rail.set({face(1), face(3)});
    rail.update(2'000'000);
    CHECK(rail.slots(2'000'000)[0].mix == 1);
    CHECK(rail.slots(2'000'000)[1].mix == 0);
}

TEST_CASE("settling ends every fade, and an empty ranking leaves waiting places", "[rail]") {
    ui::CardRail rail;
    rail.set({face(1)});
    rail.settle();
    CHECK(rail.slots(0)[0].now == face(1));
    CHECK(rail.slots(0)[0].mix == 1);
    CHECK(rail.shows(ui::PictureId{1}));
    rail.set({});
    rail.settle();
    CHECK_FALSE(rail.slots(0)[0].now.has_value());
    CHECK_FALSE(rail.shows(ui::PictureId{1}));
}

TEST_CASE("a frozen card changes when it is no longer", "[rail]") {
    ui::CardRail rail;
    rail.set({face(1), face(2)});
    rail.update(1'000'000);
    rail.set({face(3), face(4)});
    rail.update(2'000'000, {true});
    CHECK(rail.slots(2'000'000)[0].now == face(1));
    CHECK(rail.slots(2'000'000)[1].now == face(4));
    rail.update(3'000'000);
    CHECK(rail.slots(3'000'000)[0].now == face(3));
}
