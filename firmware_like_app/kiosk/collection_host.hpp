#pragma once
// What the kiosk needs of a collection: its searcher, what there is to say of it, and adding models while it runs.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware_like_app/kiosk/live_searcher.hpp"
#include "firmware_like_app/kiosk/station.hpp"

namespace app {

struct CollectionStatus {
    CollectionState state = CollectionState::Ready;
    std::int64_t models = 0, views = 0;
    double median_search_ms = 0;            ///< of the last searches; 0: none yet
    std::optional<std::int64_t> changed_s;  ///< seconds since 1970
    bool can_add = false;                   ///< there is an index to add to

    bool importing = false;
    std::int64_t done = 0, total = 0;      ///< files of the import that runs
    std::int64_t unreadable = 0;           ///< of those that are done
    std::optional<int> minutes_left = {};  ///< nothing while that cannot be told
    /// Of the last import that ended.
    struct Ended {
        std::int64_t added = 0, unchanged = 0, unreadable = 0;
        std::string failure;  ///< a sentence; empty when it went well
    };
    std::optional<Ended> ended = {};
    std::vector<std::string> problems;  ///< files that were passed over and damaged models, one sentence each
};

class CollectionHost {
  public:
    virtual ~CollectionHost() = default;

    /// Stays the same object while collections come and go.
    [[nodiscard]] virtual LiveSearcher& searcher() = 0;
    [[nodiscard]] virtual CollectionStatus status() const = 0;
    /// Adds the models of a folder, on a thread of its own. Nothing while an import runs.
    virtual void add(const std::string& folder) = 0;
    /// Describes again what an older program described.
    virtual void update() = 0;
    /// Asks the import to stop; what was added stays.
    virtual void stop() = 0;
};

/// A collection that never changes, for tests and demonstrations. `searcher` may be null and must outlive the host.
class FixedCollection final : public CollectionHost {
  public:
    explicit FixedCollection(Searcher* searcher, CollectionState state = CollectionState::Ready)
        : searcher_(searcher != nullptr ? std::shared_ptr<Searcher>(searcher, [](Searcher*) {}) : nullptr) {
        status_.state = state;
    }
    LiveSearcher& searcher() override { return searcher_; }
    CollectionStatus status() const override { return status_; }
    void set_status(CollectionStatus status) { status_ = std::move(status); }
    void add(const std::string& folder) override { added.push_back(folder); }
    void update() override { ++updates; }
    void stop() override { ++stops; }

    std::vector<std::string> added;  ///< what was asked for
    int updates = 0, stops = 0;

  private:
    LiveSearcher searcher_;
    CollectionStatus status_;
};

}  // namespace app
