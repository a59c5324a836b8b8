#include "firmware_like_app/kiosk/station.hpp"

#include <algorithm>

namespace app {

Station::Station(const StationTimes& times, CollectionState collection, std::int64_t now_us)
    : times_(times),
      collection_(collection),
      scene_(collection == CollectionState::Ready ? Scene::Attract : Scene::Notice),
      entered_us_(now_us),
      present_us_(now_us),
      pen_moved_us_(now_us) {}

Scene Station::home() const {
    return input_ && collection_ == CollectionState::Ready && !tablet_is_missed() ? Scene::Attract : Scene::Notice;
}

void Station::go(Scene scene, std::int64_t now_us) {
    scene_ = scene;
    entered_us_ = present_us_ = now_us;
}

void Station::wipe(std::int64_t now_us) {
    ++wipes_;
    has_work_ = visited_ = false;
    go(home(), now_us);
}

std::int64_t Station::left_us(std::int64_t now_us) const {
    if (scene_ == Scene::StillThere) return std::max<std::int64_t>(0, entered_us_ + times_.countdown - now_us);
    if (scene_ == Scene::Cleaning) return std::max<std::int64_t>(0, present_us_ + times_.cleaning - now_us);
    return 0;
}

void Station::set_collection(CollectionState state, std::int64_t now_us) {
    if (state == collection_) return;
    collection_ = state;
    if (at_home() && scene_ != home()) go(home(), now_us);
}

void Station::set_tablet(bool there, std::int64_t now_us) {
    tablet_ = there;
    if (there) tablet_expected_ = true;
    if (at_home() && scene_ != home()) go(home(), now_us);
}

void Station::expect_tablet(std::int64_t now_us) {
    tablet_expected_ = true;
    if (at_home() && scene_ != home()) go(home(), now_us);
}

void Station::set_input(bool there, std::int64_t now_us) {
    input_ = there;
    if (at_home() && scene_ != home()) go(home(), now_us);
}

void Station::touched(std::int64_t now_us) {
    if (!input_) set_input(true, now_us);  // here it is
    present_us_ = pen_moved_us_ = now_us;
    visited_ = true;
}

void Station::pen_near(bool moved, std::int64_t now_us) {
    if (moved) pen_moved_us_ = now_us;
    if (now_us - pen_moved_us_ < times_.still_pen) present_us_ = now_us;
}

bool Station::wake(std::int64_t now_us) {
    if (scene_ != Scene::Attract) return false;
    visited_ = true;
    go(Scene::Work, now_us);
    return true;
}

void Station::leave_notice(std::int64_t now_us) {
    if (scene_ == Scene::Notice) go(Scene::Work, now_us);
}

void Station::open_detail(std::int64_t now_us) {
    if (scene_ == Scene::Work) go(Scene::Detail, now_us);
}

void Station::keep_drawing(std::int64_t now_us) {
    if (scene_ == Scene::Detail) {
        go(Scene::Work, now_us);
    } else if (scene_ == Scene::StillThere) {
        go(behind_, now_us);
    }
}

void Station::start_over(std::int64_t now_us) {
    if (scene_ == Scene::StillThere) wipe(now_us);
}

void Station::open_pin(std::int64_t now_us) {
    if (scene_ == Scene::Pin || scene_ == Scene::Operator || scene_ == Scene::Cleaning) return;
    if (scene_ != Scene::StillThere) behind_ = scene_;
    go(Scene::Pin, now_us);
}

void Station::leave_pin(std::int64_t now_us) {
    if (scene_ != Scene::Pin) return;
    // what was behind may have changed meanwhile: the collection is read, the tablet is back
    const bool behind_is_home = behind_ == Scene::Notice || behind_ == Scene::Attract;
    go(behind_is_home ? home() : behind_, now_us);
}

void Station::open_operator(std::int64_t now_us) {
    if (scene_ == Scene::Pin) go(Scene::Operator, now_us);
}

void Station::close_operator(std::int64_t now_us) {
    if (scene_ == Scene::Operator) wipe(now_us);
}

void Station::clean_screen(std::int64_t now_us) {
    if (scene_ == Scene::Operator) go(Scene::Cleaning, now_us);
}

void Station::tick(std::int64_t now_us) {
    const std::int64_t idle = now_us - present_us_;
    switch (scene_) {
        case Scene::Notice:
        case Scene::Attract:
            if (visited_ && idle >= times_.empty) wipe(now_us);  // a language that nobody stayed for
            break;
        case Scene::Work:
            if (!has_work_) {
                if (idle >= times_.empty) wipe(now_us);
                break;
            }
            [[fallthrough]];
        case Scene::Detail:
            if (idle < (garment_ ? times_.ask_garment : times_.ask)) break;
            behind_ = scene_;
            go(Scene::StillThere, now_us);
            break;
        case Scene::StillThere:
            if (now_us - entered_us_ >= times_.countdown) wipe(now_us);
            break;
        case Scene::Pin:
            if (idle >= times_.pin) leave_pin(now_us);
            break;
        case Scene::Operator:
            if (busy_) {
                present_us_ = now_us;
            } else if (idle >= times_.station_page) {
                wipe(now_us);
            }
            break;
        case Scene::Cleaning:
            if (idle >= times_.cleaning) go(Scene::Operator, now_us);
            break;
    }
}

}  // namespace app
