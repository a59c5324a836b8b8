#pragma once
// The collection of a station: opened from its index, kept while models are added beside the visitors.

#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "firmware_like_app/kiosk/collection_host.hpp"

namespace app {

class KeptCollection final : public CollectionHost {
  public:
    struct Options {
        std::string database;  ///< empty: no collection, and none to add to
        /// What is new or changed in this folder is read at once; empty: nothing. An index that is not there is made.
        std::string models;
        int jobs = 1;         ///< threads that search
        int best_count = 10;  ///< nine cards, and one more to know what is just below
    };
    /// Opens at once what is there; see status() for what is missing. One search thread's worth of work is left to the
    /// visitors while models are read.
    explicit KeptCollection(Options options);
    /// Asks an import to stop and waits for it.
    ~KeptCollection() override;
    KeptCollection(const KeptCollection&) = delete;
    KeptCollection& operator=(const KeptCollection&) = delete;

    LiveSearcher& searcher() override { return searcher_; }
    CollectionStatus status() const override;
    void add(const std::string& folder) override;
    void update() override;
    void stop() override;

  private:
    void reload(bool all_is_read);
    void begin(std::vector<std::string> paths);
    void import(const std::vector<std::string>& paths, const std::stop_token& stop);

    Options options_;
    LiveSearcher searcher_;
    mutable std::mutex mutex_;
    CollectionStatus status_;
    std::jthread thread_;
};

}  // namespace app
