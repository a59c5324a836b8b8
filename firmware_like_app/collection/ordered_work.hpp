#pragma once
// Many pieces of work on several threads, their results taken in the order of the pieces by the thread that asked.

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace app {

/// Calls work(i) for i from 0 up to count - 1 on `jobs` threads, and take(i, result) on this one, in order. No piece is
/// begun that is `window` or more ahead of the one to be taken next, so that memory stays bounded. When take gives
/// false nothing is begun any more, what is being worked on is waited for and dropped, and no more is taken. What is
/// taken does not depend on the number of jobs. `work` must not throw.
template <typename Work, typename Take>
void work_in_order(std::size_t count, int jobs, std::size_t window, const Work& work, const Take& take) {
    using Result = decltype(work(std::size_t{0}));
    std::mutex mutex;
    std::condition_variable changed;
    std::map<std::size_t, Result> finished;
    std::size_t next = 0, taken = 0;
    bool ended = false;

    const auto run = [&] {
        for (;;) {
            std::unique_lock lock(mutex);
            changed.wait(lock, [&] { return ended || next >= count || next < taken + window; });
            if (ended || next >= count) return;
            const std::size_t item = next++;
            lock.unlock();
            Result result = work(item);
            lock.lock();
            finished.emplace(item, std::move(result));
            changed.notify_all();
        }
    };
    std::vector<std::jthread> workers;
    for (int k = 0; k < std::max(1, jobs) && static_cast<std::size_t>(k) < count; ++k) workers.emplace_back(run);
    while (taken < count) {
        std::unique_lock lock(mutex);
        changed.wait(lock, [&] { return finished.contains(taken); });
        auto node = finished.extract(taken);
        lock.unlock();
        const bool go_on = take(taken, std::move(node.mapped()));
        lock.lock();
        ++taken;
        ended = !go_on;
        changed.notify_all();
        if (ended) break;
    }
}

}  // namespace app
