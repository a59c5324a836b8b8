#include "firmware_like_app/kiosk/search_worker.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "firmware_like_app/kiosk/card_worker.hpp"
#include "tests/support/figures.hpp"

using namespace std::chrono_literals;

namespace {

core::Drawing drawing_of(int strokes) {
    core::Drawing drawing;
    for (int i = 0; i < strokes; ++i) drawing.strokes.push_back({{{0, 0, i * 10.0, 1}, {1, 200, i * 10.0, 1}}});
    return drawing;
}

/// Notes how many strokes each search saw; takes its time until told to go on.
class SlowSearcher : public app::Searcher {
  public:
    app::SearchAnswer search(const core::Drawing& drawing, std::stop_token stop) override {
        {
            const std::scoped_lock lock(mutex_);
            seen_.push_back(drawing.strokes.size());
        }
        started_.store(true);
        while (!go_on_.load() && !stop.stop_requested()) std::this_thread::sleep_for(1ms);
        app::SearchAnswer answer;
        answer.search_ms = static_cast<double>(drawing.strokes.size());
        return answer;
    }
    void wait_until_started() const {
        while (!started_.load()) std::this_thread::sleep_for(1ms);
    }
    void let_go() { go_on_.store(true); }
    std::vector<std::size_t> seen() {
        const std::scoped_lock lock(mutex_);
        return seen_;
    }

  private:
    std::mutex mutex_;
    std::vector<std::size_t> seen_;
    std::atomic<bool> started_ = false, go_on_ = false;
};

class ThrowingSearcher : public app::Searcher {
  public:
    app::SearchAnswer search(const core::Drawing& /*drawing*/, std::stop_token /*stop*/) override {
        throw std::runtime_error("the index went away");
    }
};

}  // namespace

TEST_CASE("the newest drawing wins and submitting never waits", "[worker]") {
    SlowSearcher searcher;
    app::SearchWorker worker(searcher);
    worker.submit(drawing_of(1));
    searcher.wait_until_started();
    std::uint64_t last = 0;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 2; i <= 100; ++i) last = worker.submit(drawing_of(i));  // the pen goes on while the search runs
    CHECK(std::chrono::steady_clock::now() - start < 1s);
    CHECK_FALSE(worker.take());
    searcher.let_go();
    const auto answer = worker.wait_for(last);
    REQUIRE(answer);
    CHECK(answer->ticket == last);
    CHECK(answer->answer.search_ms == 100);
    CHECK(searcher.seen() == std::vector<std::size_t>{1, 100});  // those between were never searched
    CHECK(worker.searches() == 2);
}

TEST_CASE("ending asks a running search to stop", "[worker]") {
    SlowSearcher searcher;
    const auto start = std::chrono::steady_clock::now();
    {
        app::SearchWorker worker(searcher);
        worker.submit(drawing_of(1));
        searcher.wait_until_started();
        worker.submit(drawing_of(2));
    }
    CHECK(std::chrono::steady_clock::now() - start < 2s);
    CHECK(searcher.seen().size() == 1);
}

TEST_CASE("a searcher that fails is reported and the worker goes on", "[worker]") {
    ThrowingSearcher searcher;
    app::SearchWorker worker(searcher);
    for (int i = 1; i <= 3; ++i) {
        const auto answer = worker.wait_for(worker.submit(drawing_of(i)));
        REQUIRE(answer);
        CHECK(answer->failure == "the index went away");
        CHECK(answer->cards.empty());
    }
}

TEST_CASE("an answer tells how long its drawing waited and how long all took", "[worker]") {
    SlowSearcher searcher;
    app::SearchWorker worker(searcher);
    worker.submit(drawing_of(1));
    searcher.wait_until_started();
    const std::uint64_t second = worker.submit(drawing_of(2));
    std::this_thread::sleep_for(20ms);
    searcher.let_go();
    const auto answer = worker.wait_for(second);
    REQUIRE(answer);
    CHECK(answer->waited_ms >= 20);
    CHECK(answer->ready_ms >= answer->waited_ms);
}

TEST_CASE("cards are made ready beside the search", "[worker]") {
    test::FigureSearcher searcher(test::make_animals());
    app::CardWorker cards;
    CHECK_FALSE(cards.busy());
    app::PreparedAnswer wanted;
    wanted.ticket = 7;
    wanted.answer = searcher.search(test::make_horse_drawing(), {});
    cards.start(wanted);
    CHECK(cards.busy());
    std::optional<app::PreparedAnswer> answer;
    for (int i = 0; i < 5000 && !answer; ++i) {
        std::this_thread::sleep_for(1ms);
        answer = cards.take();
    }
    REQUIRE(answer);
    CHECK_FALSE(cards.busy());
    CHECK(answer->ticket == 7);
    REQUIRE(answer->cards.size() == 9);
    for (std::size_t i = 0; i < 9; ++i) {
        CHECK(answer->cards[i]->geometry->corner_count() > 1000);
        const bool matched = answer->answer.best[i].name != "badger";
        CHECK((answer->cards[i]->part_map.width > 0) == matched);
    }
}

TEST_CASE("a searcher is told when the last stroke is still being drawn", "[worker]") {
    class Noting : public app::Searcher {
      public:
        app::SearchAnswer search(const core::Drawing& /*drawing*/, std::stop_token /*stop*/) override {
            return {{}, "whole"};
        }
        app::SearchAnswer search_unfinished(const core::Drawing& /*drawing*/, std::stop_token /*stop*/) override {
            return {{}, "unfinished"};
        }
    } searcher;
    app::SearchWorker worker(searcher);
    CHECK(worker.wait_for(worker.submit(drawing_of(1), true))->answer.message_key == "unfinished");
    CHECK(worker.wait_for(worker.submit(drawing_of(1)))->answer.message_key == "whole");
}

TEST_CASE("nothing comes of drawings that were put away", "[worker]") {
    SlowSearcher searcher;
    app::SearchWorker worker(searcher);
    worker.submit(drawing_of(1));
    searcher.wait_until_started();
    const std::uint64_t waiting = worker.submit(drawing_of(2));
    worker.forget();
    CHECK_FALSE(worker.wait_for(waiting));  // nobody is kept waiting for them
    searcher.let_go();
    const auto next = worker.wait_for(worker.submit(drawing_of(3)));
    REQUIRE(next);
    CHECK(next->answer.search_ms == 3);
    CHECK(searcher.seen() == std::vector<std::size_t>{1, 3});
    worker.forget();
    CHECK_FALSE(worker.take());
}
