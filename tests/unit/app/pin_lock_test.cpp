#include "firmware_like_app/kiosk/pin_lock.hpp"

#include <catch2/catch.hpp>

namespace {

constexpr std::int64_t kSecond = 1'000'000;

bool enter(app::PinLock& lock, const std::string& digits, std::int64_t now_us) {
    bool open = false;
    for (const char digit : digits) open = lock.enter(digit, now_us);
    return open;
}

}  // namespace

TEST_CASE("the right digits open, others and parts do not", "[pin]") {
    app::PinLock lock("246810");
    CHECK(lock.length() == 6);
    CHECK_FALSE(enter(lock, "24681", 0));
    CHECK(lock.entered() == 5);
    lock.erase();
    CHECK(lock.entered() == 4);
    CHECK(enter(lock, "10", 0));
    CHECK(lock.entered() == 0);
    CHECK_FALSE(enter(lock, "246811", 0));
    CHECK(lock.was_wrong());
    CHECK_FALSE(lock.enter('x', 0));
    CHECK(lock.entered() == 0);
    CHECK(enter(lock, "246810", 0));
    CHECK_FALSE(lock.was_wrong());
}

TEST_CASE("three wrong tries wait 30 seconds, each further one twice as long, an hour at most", "[pin]") {
    app::PinLock lock("1234");
    std::int64_t now = 0;
    enter(lock, "0000", now);
    enter(lock, "0000", now);
    CHECK(lock.wait_s(now) == 0);
    for (const std::int64_t wait : {30, 60, 120, 240, 480, 960, 1920, 3600, 3600}) {
        enter(lock, "0000", now);
        CHECK(lock.wait_s(now) == wait);
        CHECK_FALSE(enter(lock, "1234", now));  // not even the right one
        now += wait * kSecond - 1;
        CHECK(lock.wait_s(now) == 1);
        now += 1;
        CHECK(lock.wait_s(now) == 0);
    }
    CHECK(enter(lock, "1234", now));
    enter(lock, "0000", now);
    CHECK(lock.wait_s(now) == 0);  // the wrong tries are forgotten
}
