#pragma once
// Makes cloth on a thread of its own while the pen goes on. The newest request wins: one is at work, one waits.

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/garment/desk/build_request.hpp"

namespace app {

struct BuiltGarment {
    core::BuildResult result;
    /// For each layer of the result the fitted cloth with its texture coordinates; null where none were asked for.
    std::vector<std::shared_ptr<const core::Cloth>> textured;
};

class GarmentBuilder {
  public:
    struct Job {
        core::BuildRequest request;
        std::vector<int> woven;  ///< layers whose fabric has a pattern: these are laid flat, which costs as much again
    };
    /// `own_thread` false: submit does the work before it returns.
    explicit GarmentBuilder(bool own_thread);
    /// Stops between layers and waits for it.
    ~GarmentBuilder();
    GarmentBuilder(const GarmentBuilder&) = delete;
    GarmentBuilder& operator=(const GarmentBuilder&) = delete;

    void submit(Job job);
    /// The newest that is done, once. Nothing comes of one that there was no memory for.
    [[nodiscard]] std::optional<BuiltGarment> take();
    /// Until nothing waits and nothing is at work.
    void wait();
    /// What is at work or waiting is of a design that is gone: its result is dropped.
    void forget();
    [[nodiscard]] bool busy() const;

  private:
    void work(const std::stop_token& stop);
    [[nodiscard]] BuiltGarment run(const Job& job, const std::stop_token& stop);
    [[nodiscard]] std::shared_ptr<const core::Cloth> textured(const std::shared_ptr<const core::FinishedLayer>& layer);

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Job> waiting_;
    std::optional<BuiltGarment> done_;
    bool working_ = false;
    std::uint64_t epoch_ = 0;
    /// Of the last result, so that layers which did not change are not laid flat again.
    std::map<const core::FinishedLayer*,
             std::pair<std::shared_ptr<const core::FinishedLayer>, std::shared_ptr<const core::Cloth>>>
        kept_;
    std::jthread thread_;
};

}  // namespace app
