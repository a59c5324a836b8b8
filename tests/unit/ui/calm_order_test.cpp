#include "ui/screens/calm_order.hpp"

#include <catch2/catch.hpp>
#include <numeric>

using ui::CalmOrder;
using Models = CalmOrder::Models;

namespace {

/// 1 … 20 with the given ones first.
Models ranking(const Models& first) {
    Models all = first;
    for (std::int64_t m = 1; m <= 20; ++m) {
        if (std::find(first.begin(), first.end(), m) == first.end()) all.push_back(m);
    }
    all.resize(20);
    return all;
}

Models nine(const Models& first) {
    Models all = ranking(first);
    all.resize(9);
    return all;
}

CalmOrder showing(const Models& first) {
    CalmOrder order;
    order.see(ranking(first));
    order.rearrange();
    return order;
}

}  // namespace

TEST_CASE("empty cards are filled at once", "[calm order]") {
    CalmOrder order;
    CHECK_FALSE(order.change_due());
    order.see(ranking({}));
    CHECK(order.change_due());
    CHECK(order.rearrange() == nine({}));
    CHECK_FALSE(order.change_due());
    CHECK(order.settled());
}

TEST_CASE("neighbours that swap stay where they are, until the drawing rests", "[calm order]") {
    CalmOrder order = showing({});
    for (int i = 0; i < 5; ++i) {
        order.see(ranking({2, 1, 3}));
        CHECK_FALSE(order.change_due());
    }
    CHECK_FALSE(order.settled());
    CHECK(order.settle() == nine({2, 1, 3}));
    CHECK(order.settled());
}

TEST_CASE("a change by two has to hold for two rankings", "[calm order]") {
    CalmOrder order = showing({});
    order.see(ranking({3, 1, 2}));
    CHECK_FALSE(order.change_due());
    order.see(ranking({}));
    order.see(ranking({3, 1, 2}));
    CHECK_FALSE(order.change_due());  // not running
    order.see(ranking({3, 1, 2}));
    REQUIRE(order.change_due());
    CHECK(order.rearrange() == nine({3, 1, 2}));
}

TEST_CASE("a model that left makes room for one that came, and the others stay", "[calm order]") {
    CalmOrder order = showing({});
    const Models without_9 = ranking({1, 2, 3, 4, 5, 7, 6, 8, 15});
    order.see(without_9);
    CHECK_FALSE(order.change_due());
    order.see(without_9);
    REQUIRE(order.change_due());
    CHECK(order.rearrange() == Models{1, 2, 3, 4, 5, 6, 7, 8, 15});  // 6 and 7 only swapped: they stay
}

TEST_CASE("a newcomer that is best comes to the best card", "[calm order]") {
    CalmOrder order = showing({});
    for (int i = 0; i < 2; ++i) order.see(ranking({15}));
    REQUIRE(order.change_due());
    CHECK(order.rearrange() == nine({15}));
}

TEST_CASE("cards near the pen keep their model", "[calm order]") {
    CalmOrder order = showing({});
    for (int i = 0; i < 2; ++i) order.see(ranking({15}));
    CalmOrder::Frozen frozen{};
    frozen[4] = true;
    CHECK(order.rearrange(frozen) == Models{15, 1, 2, 3, 5, 4, 6, 7, 8});
    order.see(ranking({}));
    frozen[0] = true;
    CHECK(order.settle(frozen) == Models{15, 1, 2, 3, 5, 4, 6, 7, 8});
    CHECK_FALSE(order.settled());
    CHECK(order.settle() == nine({}));
}

TEST_CASE("a search that finds nothing once does not empty the cards; twice it does", "[calm order]") {
    CalmOrder order = showing({});
    order.see({});
    CHECK_FALSE(order.change_due());
    order.see({});
    REQUIRE(order.change_due());
    CHECK(order.rearrange().empty());
    order.see(ranking({}));
    CHECK(order.change_due());
    order.clear();
    CHECK(order.shown().empty());
}

TEST_CASE("whatever comes, every card has one model and no model two cards", "[calm order]") {
    CalmOrder order;
    std::uint32_t random = 7;
    const auto next = [&] { return random = random * 1664525U + 1013904223U, random >> 16; };
    for (int step = 0; step < 3000; ++step) {
        Models all(25);
        std::iota(all.begin(), all.end(), 1);
        for (std::size_t i = all.size(); i > 1; --i) {
            if (next() % 3 == 0) std::swap(all[i - 1], all[next() % i]);
        }
        all.resize(next() % 26);
        order.see(all);
        CalmOrder::Frozen frozen{};
        for (bool& f : frozen) f = next() % 4 == 0;
        if (order.change_due()) order.rearrange(frozen);
        if (next() % 10 == 0) order.settle(frozen);
        Models shown = order.shown();
        std::sort(shown.begin(), shown.end());
        REQUIRE(std::unique(shown.begin(), shown.end()) == shown.end());
        REQUIRE(shown.size() <= 9);
    }
}
