#pragma once
// The same work on many items, on several threads, with results that do not depend on how many.

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace core {

/// Cores of this machine, 1 at least.
[[nodiscard]] inline int core_count() {
    const unsigned n = std::thread::hardware_concurrency();
    return n == 0 ? 1 : static_cast<int>(n);
}

/// Calls work(item, worker) for every item in [0, count), each once, on `jobs` threads of which the caller is one.
/// Items are handed out in order; worker in [0, jobs) names the thread, for working memory of its own. Results must go
/// to places that belong to the item. `work` must not throw.
inline void parallel_for(std::size_t count, int jobs, const std::function<void(std::size_t item, int worker)>& work) {
    std::atomic<std::size_t> next{0};
    const auto run = [&](int worker) {
        for (std::size_t item = next++; item < count; item = next++) work(item, worker);
    };
    std::vector<std::jthread> others;
    for (int worker = 1; worker < jobs && static_cast<std::size_t>(worker) < count; ++worker) {
        others.emplace_back(run, worker);
    }
    run(0);
}

}  // namespace core
