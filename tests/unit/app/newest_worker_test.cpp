#include "firmware_like_app/kiosk/newest_worker.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <new>
#include <optional>
#include <semaphore>
#include <thread>

namespace {

using namespace std::chrono_literals;

/// Doubles numbers; each job says that it has begun, and waits for leave to end.
struct Doubler {
    std::counting_semaphore<> begun{0}, leave{0};
    app::NewestWorker<int, int> worker{[this](const int& number, const std::stop_token& /*stop*/) {
        begun.release();
        leave.acquire();
        return 2 * number;
    }};

    /// What comes within ten seconds.
    std::optional<int> wait() {
        for (int i = 0; i < 10'000; ++i) {
            if (auto result = worker.take()) return result;
            std::this_thread::sleep_for(1ms);
        }
        return std::nullopt;
    }
};

}  // namespace

TEST_CASE("a result comes once", "[newest worker]") {
    Doubler doubler;
    doubler.leave.release();
    doubler.worker.start(21);
    CHECK(doubler.wait() == 42);
    CHECK_FALSE(doubler.worker.take());
}

TEST_CASE("of jobs that wait the newest is done", "[newest worker]") {
    Doubler doubler;
    doubler.worker.start(1);
    doubler.begun.acquire();
    for (int number : {2, 3, 4}) doubler.worker.start(number);
    doubler.leave.release(2);
    doubler.begun.acquire();  // the second to run
    std::optional<int> last = doubler.wait();
    if (last == 2) last = doubler.wait();
    CHECK(last == 8);
    CHECK_FALSE(doubler.begun.try_acquire());
}

TEST_CASE("nothing comes of what was forgotten: what ran, what waited, what was done", "[newest worker]") {
    Doubler doubler;
    SECTION("it ran, another waited") {
        doubler.worker.start(1);
        doubler.begun.acquire();
        doubler.worker.start(2);
        doubler.worker.forget();
    }
    SECTION("it was done") {
        doubler.worker.start(1);
        doubler.leave.release();
        doubler.worker.start(5);
        doubler.begun.acquire();
        doubler.worker.forget();
    }
    doubler.leave.release(5);
    doubler.worker.start(50);
    CHECK(doubler.wait() == 100);
    CHECK_FALSE(doubler.worker.take());
}

TEST_CASE("a worker is busy until its result is taken, forgotten, or fails to come", "[newest worker]") {
    app::NewestWorker<int, int> worker([](const int& number, const std::stop_token& /*stop*/) {
        if (number < 0) throw std::bad_alloc();
        return number;
    });
    const auto ends = [&] {
        for (int i = 0; i < 10'000 && worker.busy(); ++i) std::this_thread::sleep_for(1ms);
        return !worker.busy();
    };
    CHECK_FALSE(worker.busy());
    worker.start(-1);
    CHECK(ends());
    CHECK_FALSE(worker.take());
    worker.start(7);
    std::optional<int> result;
    for (int i = 0; i < 10'000 && !result; ++i) {
        CHECK(worker.busy());
        result = worker.take();
        std::this_thread::sleep_for(1ms);
    }
    CHECK(result == 7);
    CHECK_FALSE(worker.busy());
    worker.start(8);
    worker.forget();
    CHECK_FALSE(worker.busy());
}
