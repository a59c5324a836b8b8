#include "firmware_like_app/kiosk/garment_keeper.hpp"

#include <utility>

#include "core/exchange/png_writer.hpp"

namespace app {

void GarmentKeeper::take(core::GarmentDesk& desk) {
    std::vector<core::JournalEvent> events = desk.take_journal();
    if (!keeps() || events.empty()) return;
    if (!journal_) {  // a design of its own, as it is after its first act
        core::Result<db::DesignStore> store = db::DesignStore::open(file_, db::OpenMode::Create);
        const core::Result<std::int64_t> made =
            store ? store->create(desk.design()) : core::Result<std::int64_t>(core::unexpected(store.error()));
        if (!made) {
            problem_ = made.error();
            return;
        }
        problem_.reset();
        follow(*made, 0);
        return;
    }
    for (core::JournalEvent& event : events) {
        if (journal_->append(db::JournalEntry::of(std::move(event)))) continue;
        journal_->keep({desk.design(), {}});  // the queue is full: the whole design needs none
        return;
    }
}

void GarmentKeeper::follow(std::int64_t id, std::int64_t sequence) {
    journal_.reset();
    journal_ = std::make_unique<db::DesignJournal>(file_, id, sequence);
    id_ = id;
}

std::optional<std::int64_t> GarmentKeeper::end() {
    journal_.reset();
    problem_.reset();
    const std::int64_t kept = std::exchange(id_, 0);
    return kept != 0 ? std::optional<std::int64_t>(kept) : std::nullopt;
}

void GarmentKeeper::set_thumbnail(const core::RgbaImage& picture) {
    if (!journal_) return;
    if (core::Result<std::vector<std::byte>> png = core::png_bytes(picture)) journal_->set_thumbnail(std::move(*png));
}

void GarmentKeeper::rename(const std::string& name) {
    if (!journal_) return;
    db::JournalEntry entry;
    entry.kind = db::JournalEntry::Kind::Rename;
    entry.name = name;
    (void)journal_->append(std::move(entry));
}

core::Result<db::OpenedDesign> GarmentKeeper::load(std::int64_t id) const {
    core::Result<db::DesignStore> store = db::DesignStore::open(file_, db::OpenMode::ReadOnly);
    if (!store) return core::unexpected(store.error());
    return store->load(id);
}

std::optional<core::Error> GarmentKeeper::problem() const {
    if (problem_ || !journal_) return problem_;
    return journal_->fault();
}

}  // namespace app
