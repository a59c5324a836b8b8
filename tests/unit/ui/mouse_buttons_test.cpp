#include "ui/gl/mouse_buttons.hpp"

#include <catch2/catch.hpp>

TEST_CASE("the first button counts until it goes up, and a mouse that hovers afterwards holds none", "[mouse]") {
    ui::MouseButtons buttons;
    CHECK_FALSE(buttons.is_other());
    CHECK(buttons.change(3, true));
    CHECK(buttons.is_other());
    CHECK_FALSE(buttons.change(1, true));  // the right one is held already
    CHECK_FALSE(buttons.change(1, false));
    CHECK(buttons.is_other());
    CHECK(buttons.change(3, false));
    CHECK(buttons.is_other());  // what ends is what the right one did
    buttons.settle();
    CHECK_FALSE(buttons.is_other());
    CHECK(buttons.change(1, true));
    CHECK_FALSE(buttons.is_other());
    CHECK_FALSE(buttons.change(3, false));
    CHECK(buttons.change(1, false));
    CHECK_FALSE(buttons.is_other());
}

TEST_CASE("a button that was lost to another window is up", "[mouse]") {
    ui::MouseButtons buttons;
    CHECK(buttons.change(2, true));
    buttons.forget();
    CHECK_FALSE(buttons.is_other());
    CHECK_FALSE(buttons.change(2, false));
    CHECK(buttons.change(1, true));
}
