#include "firmware_like_app/collection/ordered_work.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "firmware_like_app/collection/memory_gate.hpp"

using namespace std::chrono_literals;

TEST_CASE("results are taken in order, whatever the number of jobs", "[ordered_work]") {
    for (const int jobs : {1, 2, 7}) {
        std::vector<std::size_t> taken;
        app::work_in_order(
            50, jobs, 8,
            [](std::size_t i) {
                if (i % 5 == 0) std::this_thread::sleep_for(200us);
                return i * i;
            },
            [&](std::size_t i, std::size_t result) {
                CHECK(result == i * i);
                taken.push_back(i);
                return true;
            });
        REQUIRE(taken.size() == 50);
        CHECK(std::is_sorted(taken.begin(), taken.end()));
    }
}

TEST_CASE("no piece is begun too far ahead", "[ordered_work]") {
    std::atomic<std::size_t> begun = 0;
    std::size_t taken = 0;
    app::work_in_order(
        60, 3, 5,
        [&](std::size_t i) {
            ++begun;
            return i;
        },
        [&](std::size_t, std::size_t) {
            std::this_thread::sleep_for(100us);
            CHECK(begun.load() <= taken + 5);
            ++taken;
            return true;
        });
    CHECK(taken == 60);
}

TEST_CASE("when one is enough no more is taken, and all threads end", "[ordered_work]") {
    for (const int jobs : {1, 4}) {
        std::size_t taken = 0;
        app::work_in_order(
            1000, jobs, 16, [](std::size_t i) { return i; }, [&](std::size_t, std::size_t) { return ++taken < 10; });
        CHECK(taken == 10);
    }
    app::work_in_order(
        0, 4, 16, [](std::size_t i) { return i; }, [](std::size_t, std::size_t) { return false; });
}

TEST_CASE("large work is let in alone, small work together", "[memory_gate]") {
    app::MemoryGate gate(100);
    std::atomic<int> inside = 0, most_small = 0;
    std::atomic<bool> shared_with_large = false;
    std::vector<std::jthread> threads;
    for (int k = 0; k < 12; ++k) {
        threads.emplace_back([&, large = k % 4 == 0] {
            const app::MemoryGate::Pass pass(gate, large ? 500 : 30);
            const int now = ++inside;
            if (large && now > 1) shared_with_large = true;
            if (now > most_small.load()) most_small = now;
            std::this_thread::sleep_for(1ms);
            if (large && inside.load() > 1) shared_with_large = true;
            --inside;
        });
    }
    threads.clear();
    CHECK_FALSE(shared_with_large.load());
    CHECK(most_small.load() <= 3);
}
