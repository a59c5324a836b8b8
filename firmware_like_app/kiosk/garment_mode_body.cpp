// Measures that are written, and bodies of the studio's own.

#include <array>
#include <cstdio>
#include <utility>

#include "firmware_like_app/kiosk/garment_mode.hpp"

namespace app {

void GarmentMode::act_on_body(const ui::GarmentIntent& intent, std::int64_t now_us) {
    using A = ui::GarmentAction;
    switch (intent.action) {
        case A::TypeMeasure:
            open_pad(intent.index);
            break;
        case A::PadKey:
            press_pad(intent.index);
            break;
        case A::PadCancel:
            typed_.reset();
            break;
        case A::PadDone:
            end_pad(now_us);
            break;
        case A::OwnBody:
            body_files_.open();
            open_drawer(ui::GarmentDrawer::OwnBody);
            break;
        case A::BodyFile:
            body_files_.choose(intent.index);
            break;
        case A::BodyUp:
            body_files_.up();
            break;
        case A::BodyEarlier:
            body_files_.earlier();
            break;
        case A::BodyLater:
            body_files_.later();
            break;
        default:
            break;
    }
}

void GarmentMode::open_pad(std::size_t slider) {
    if (slider >= ui::kBodySliders) return;
    typed_ = slider;
    number_wrong_ = false;
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%.1f", body_.drawer().measures[slider].cm);
    number_ = {text.data(), true};
}

void GarmentMode::press_pad(std::size_t key) {
    number_wrong_ = false;
    if (key == ui::kPadPoint) {
        number_.point();
    } else if (key == ui::kPadErase) {
        number_.erase();
    } else if (key < ui::kPadPoint) {
        number_.type(static_cast<char>('0' + key));
    }
}

/// Kept where the slider reaches it; else the pad stays open and says so.
void GarmentMode::end_pad(std::int64_t now_us) {
    const std::optional<double> cm = number_.value();
    if (!typed_ || !cm) return;
    number_wrong_ = !body_.write(*typed_, *cm);
    if (number_wrong_) return;
    typed_.reset();
    keep_body(now_us);
}

/// A body that was chosen and read.
void GarmentMode::take_own_body(std::int64_t now_us) {
    const std::optional<std::string> file = body_files_.take();
    if (!file || !desk_) return;
    take_reply(desk_->set_own_body(*file), now_us);
    if (drawer_ == ui::GarmentDrawer::OwnBody) open_drawer(ui::GarmentDrawer::Body);
}

}  // namespace app
