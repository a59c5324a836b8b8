#include "ui/screens/number_pad.hpp"

#include <catch2/catch.hpp>

TEST_CASE("a number takes three digits, one point and a tenth", "[number pad]") {
    ui::NumberEdit edit{"88.0", true};
    CHECK(edit.value() == 88.0);
    edit.type('9');  // in place of the old number
    CHECK(edit.text == "9");
    edit.type('2');
    edit.type('x');
    edit.point();
    edit.point();
    edit.type('5');
    edit.type('7');  // a second tenth
    CHECK(edit.text == "92.5");
    CHECK(edit.value() == 92.5);
    for (int k = 0; k < 9; ++k) edit.erase();
    CHECK(edit.text.empty());
    CHECK_FALSE(edit.value());
    edit.point();
    CHECK(edit.value() == 0.0);
    edit.erase();
    edit.erase();
    for (const char digit : {'1', '2', '3', '4'}) edit.type(digit);
    CHECK(edit.value() == 123.0);
    ui::NumberEdit old{"70.0", true};
    old.erase();
    CHECK(old.text.empty());
}

TEST_CASE("keys lie in four rows of three and do not touch", "[number pad]") {
    const ui::Rect area{24, 100, 448, 560};
    const ui::NumberPadLayout pad = ui::number_pad_layout(area, 1.0);
    for (std::size_t i = 0; i < ui::kPadKeys; ++i) {
        CHECK(pad.keys[i].height >= 64);
        CHECK(pad.keys[i].y >= pad.field.bottom());
        CHECK(pad.keys[i].bottom() <= area.bottom() + 0.5);
        for (std::size_t k = 0; k < i; ++k) {
            const bool beside = pad.keys[i].right() < pad.keys[k].x || pad.keys[k].right() < pad.keys[i].x;
            const bool below = pad.keys[i].bottom() < pad.keys[k].y || pad.keys[k].bottom() < pad.keys[i].y;
            CHECK((beside || below));
        }
    }
    CHECK(pad.keys[7].y < pad.keys[1].y);
    CHECK(pad.keys[0].x == pad.keys[2].x);
}
