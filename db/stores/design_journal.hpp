#pragma once
// Writes what is done to one design, beside the pen: append returns at once, a thread of its own stores and flushes.
//
//     db::DesignJournal journal(path, opened.id, opened.sequence);
//     journal.append(db::JournalEntry::of(event));   // returns its number
//     if (journal.acknowledged() >= number) …                                   // survives a power cut
//
// What was appended while the disk was busy is stored with one flush. Where the disk refuses (full, pulled out),
// entries stay in the queue and are tried again every second; fault() says why. The queue is bounded: append that finds
// it full takes nothing, and keep() then hands over the whole design, which needs no entries.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "db/stores/design_store.hpp"

namespace db {

struct DesignJournalOptions {
    std::size_t most_waiting = 4096;             ///< entries
    std::chrono::milliseconds retry{1000};       ///< after the disk refused
    std::int64_t compact_after = 200;            ///< entries since the snapshot, when the journal ends
    std::chrono::milliseconds last_words{3000};  ///< how long the destructor waits for a disk that refuses
    DesignStoreOptions store = {};
};

/// All functions may be called from any one thread; acknowledged() and fault() from every thread.
class DesignJournal {
  public:
    /// `sequence`: of the design's last entry, as load gave it. The file is opened by the thread.
    DesignJournal(std::filesystem::path path, std::int64_t design_id, std::int64_t sequence,
                  DesignJournalOptions options = {});
    /// Stores what waits, unless the disk refuses for last_words.
    ~DesignJournal();
    DesignJournal(const DesignJournal&) = delete;
    DesignJournal& operator=(const DesignJournal&) = delete;

    /// Gives the entry's number; nothing when the queue is full. Some microseconds, never waits for the disk.
    [[nodiscard]] std::optional<std::int64_t> append(JournalEntry entry);
    /// The whole design as it is now: takes the place of everything that waits, and shortens the journal. Also what
    /// stores changes that no entry tells.
    std::int64_t keep(DesignState state);
    /// A new picture of it, stored when the steps before it are; the newest wins. What is no PNG is passed over.
    void set_thumbnail(std::vector<std::byte> png);

    /// The number up to which everything is on the disk.
    [[nodiscard]] std::int64_t acknowledged() const { return acknowledged_.load(std::memory_order_acquire); }
    /// Of the entry appended last.
    [[nodiscard]] std::int64_t appended() const { return appended_; }
    /// Why storing does not go on; nothing while it does.
    [[nodiscard]] std::optional<core::Error> fault() const;
    /// Waits until everything is on the disk, or that long. True when it is.
    bool wait(std::chrono::milliseconds most);

  private:
    struct Batch {
        std::optional<DesignState> whole;
        std::vector<JournalEntry> entries;
        std::optional<std::vector<std::byte>> thumbnail;
        std::int64_t whole_at = 0, first = 0, last = 0;  ///< numbers
        [[nodiscard]] bool empty() const { return !whole && entries.empty() && !thumbnail; }
    };
    void run();
    void give_back(Batch batch);
    [[nodiscard]] core::Result<void> store(Batch& batch);

    const std::filesystem::path path_;
    const std::int64_t design_id_;
    const DesignJournalOptions options_;
    std::int64_t appended_;
    std::atomic<std::int64_t> acknowledged_;

    mutable std::mutex mutex_;
    std::condition_variable work_, stored_;
    Batch waiting_;         // entries first … last follow `whole`
    bool storing_ = false;  // a batch is out with the thread
    bool ending_ = false;
    std::optional<core::Error> fault_;

    std::optional<DesignStore> store_;  // of the thread
    std::thread thread_;                // last: starts when all else is there
};

}  // namespace db
