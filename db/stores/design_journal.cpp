#include "db/stores/design_journal.hpp"

#include <utility>

#include "db/codec/png_signature.hpp"

namespace db {

DesignJournal::DesignJournal(std::filesystem::path path, std::int64_t design_id, std::int64_t sequence,
                             DesignJournalOptions options)
    : path_(std::move(path)),
      design_id_(design_id),
      options_(std::move(options)),
      appended_(sequence),
      acknowledged_(sequence),
      thread_([this] { run(); }) {}

DesignJournal::~DesignJournal() {
    wait(options_.last_words);
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    work_.notify_all();
    thread_.join();
}

std::optional<std::int64_t> DesignJournal::append(JournalEntry entry) {
    {
        const std::lock_guard lock(mutex_);
        if (waiting_.entries.size() >= options_.most_waiting) return std::nullopt;
        if (waiting_.entries.empty()) waiting_.first = appended_ + 1;
        waiting_.entries.push_back(std::move(entry));
        waiting_.last = ++appended_;
    }
    work_.notify_all();
    return appended_;
}

std::int64_t DesignJournal::keep(DesignState state) {
    {
        const std::lock_guard lock(mutex_);
        waiting_.entries.clear();
        waiting_.whole = std::move(state);
        waiting_.last = ++appended_;
        waiting_.whole_at = appended_;
    }
    work_.notify_all();
    return appended_;
}

void DesignJournal::set_thumbnail(std::vector<std::byte> png) {
    if (!is_png(png)) return;
    {
        const std::lock_guard lock(mutex_);
        waiting_.thumbnail = std::move(png);
    }
    work_.notify_all();
}

std::optional<core::Error> DesignJournal::fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
}

bool DesignJournal::wait(std::chrono::milliseconds most) {
    std::unique_lock lock(mutex_);
    return stored_.wait_for(lock, most, [this] { return waiting_.empty() && !storing_; });
}

void DesignJournal::run() {
    for (;;) {
        Batch batch;
        {
            std::unique_lock lock(mutex_);
            work_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
            if (waiting_.empty() || (ending_ && fault_)) break;
            batch = std::exchange(waiting_, {});
            storing_ = true;
        }
        const core::Result<void> stored = store(batch);
        std::unique_lock lock(mutex_);
        storing_ = false;
        if (stored) {
            fault_.reset();
            stored_.notify_all();
            continue;
        }
        fault_ = stored.error();
        give_back(std::move(batch));
        work_.wait_for(lock, options_.retry, [this] { return ending_; });
    }
    // all of it is stored already: where this fails, the next end tries again
    if (!store_) return;
    const core::Result<std::int64_t> length = store_->entries_since_snapshot(design_id_);
    if (length && *length >= options_.compact_after) static_cast<void>(store_->compact(design_id_));
}

/// What could not be stored waits before what came since; unless that is the whole design. Called under the lock.
void DesignJournal::give_back(Batch batch) {
    if (waiting_.thumbnail) batch.thumbnail = std::move(waiting_.thumbnail);
    if (waiting_.whole) {
        waiting_.thumbnail = std::move(batch.thumbnail);
        return;
    }
    if (batch.entries.empty()) batch.first = waiting_.first;
    for (JournalEntry& entry : waiting_.entries) batch.entries.push_back(std::move(entry));
    if (waiting_.last > 0) batch.last = waiting_.last;
    waiting_ = std::move(batch);
}

/// Takes out of the batch what is on the disk.
core::Result<void> DesignJournal::store(Batch& batch) {
    if (!store_) {
        core::Result<DesignStore> opened = DesignStore::open(path_, OpenMode::ReadWrite, options_.store);
        if (!opened) return core::unexpected(opened.error());
        store_.emplace(std::move(*opened));
    }
    if (batch.whole) {
        if (core::Result<void> kept = store_->keep(design_id_, *batch.whole, batch.whole_at); !kept) return kept;
        batch.whole.reset();
        acknowledged_.store(batch.whole_at, std::memory_order_release);
    }
    if (!batch.entries.empty()) {
        if (core::Result<void> done = store_->append(design_id_, batch.first, batch.entries); !done) return done;
        batch.entries.clear();
        acknowledged_.store(batch.last, std::memory_order_release);
    }
    if (batch.thumbnail) {
        if (core::Result<void> done = store_->set_thumbnail(design_id_, *batch.thumbnail); !done) return done;
        batch.thumbnail.reset();
    }
    return {};
}

}  // namespace db
