#include "ui/screens/card_rail.hpp"

#include <algorithm>
#include <utility>

namespace ui {

void CardRail::set(std::vector<CardFace> ranking) {
    waiting_ = std::move(ranking);
}

void CardRail::update(std::int64_t now_us, const std::array<bool, kCardCount>& frozen) {
    if (waiting_ && ready(now_us)) apply(now_us, false, frozen);
}

void CardRail::settle() {
    apply(changed_us_, true, {});
    for (Place& place : places_) {
        place.before.reset();
        place.since_us = -1'000'000'000;
    }
}

void CardRail::apply(std::int64_t now_us, bool at_once, const std::array<bool, kCardCount>& frozen) {
    if (!waiting_) return;
    std::int64_t delay_us = 0;
    bool held_back = false;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        std::optional<CardFace> face;
        if (i < waiting_->size()) face = (*waiting_)[i];
        Place& place = places_[i];
        if (face == place.now) continue;
        if (frozen[i] && place.now) {
            held_back = true;
            continue;
        }
        place.before = std::move(place.now);
        place.now = std::move(face);
        place.since_us = now_us + delay_us;
        if (!at_once) {
            delay_us += kStagger_us;
            changed_us_ = now_us;
        }
    }
    if (!held_back) waiting_.reset();
}

std::array<CardSlot, kCardCount> CardRail::slots(std::int64_t now_us) const {
    std::array<CardSlot, kCardCount> out;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Place& place = places_[i];
        const double mix = static_cast<double>(now_us - place.since_us) / static_cast<double>(kFade_us);
        out[i] = {place.now, mix < 1 ? place.before : std::nullopt, std::clamp(mix, 0.0, 1.0)};
    }
    return out;
}

bool CardRail::moving(std::int64_t now_us) const {
    return waiting_.has_value() || std::any_of(places_.begin(), places_.end(),
                                               [&](const Place& place) { return now_us - place.since_us < kFade_us; });
}

bool CardRail::shows(PictureId picture) const {
    const auto is = [&](const std::optional<CardFace>& face) { return face && face->picture == picture; };
    const auto in = [&](const CardFace& face) { return face.picture == picture; };
    return std::any_of(places_.begin(), places_.end(), [&](const Place& p) { return is(p.now) || is(p.before); }) ||
           (waiting_ && std::any_of(waiting_->begin(), waiting_->end(), in));
}

}  // namespace ui
