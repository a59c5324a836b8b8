#include "core/exchange/isolated.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

using core::ErrorCode;
using core::run_isolated;

TEST_CASE("isolated work gives its answer and changes nothing here", "[isolated]") {
    int calls = 0;
    const auto answer = run_isolated([&calls] { return ++calls, std::string(300000, 'x'); }, {});
    REQUIRE(answer.has_value());
    CHECK(*answer == std::string(300000, 'x'));
    CHECK(calls == 0);
    CHECK(run_isolated([] { return std::string(); }, {})->empty());
}

TEST_CASE("isolated work that crashes, throws or never ends gives an error", "[isolated]") {
    const auto crash = run_isolated([]() -> std::string { std::abort(); }, {});
    CHECK(crash.error().code == ErrorCode::BadFormat);
    CHECK_THAT(crash.error().message, Catch::Contains("damaged"));
    const auto thrown = run_isolated([]() -> std::string { throw std::runtime_error("no"); }, {});
    CHECK_THAT(thrown.error().message, Catch::Contains("damaged"));
    const auto no_memory = run_isolated([]() -> std::string { throw std::bad_alloc(); }, {});
    CHECK(no_memory.error().code == ErrorCode::BadMesh);
    core::IsolationLimits limits;
    limits.processor_seconds = 0.1;
    volatile bool forever = true;
    const auto endless = run_isolated(
        [&forever] {
            while (forever) {
            }
            return std::string();
        },
        limits);
    CHECK_THAT(endless.error().message, Catch::Contains("time"));
}

TEST_CASE("isolated work that is ended by hand says nothing about its input", "[isolated]") {
    for (const int signal : {SIGINT, SIGTERM}) {
        const auto ended = run_isolated([signal] { return std::raise(signal), std::string(); }, {});
        CHECK(ended.error().code == ErrorCode::Cancelled);
    }
}
