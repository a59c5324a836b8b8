#include "firmware_like_app/garment/gallery_desk.hpp"

#include <algorithm>
#include <array>
#include <ctime>

#include "core/exchange/image_reader.hpp"
#include "firmware_like_app/garment/design_faults.hpp"
#include "ui/screens/widgets.hpp"

namespace app {
namespace {

using ui::GalleryAction;

/// "Today, 09:12" or the date as ISO 8601 has it, which every language reads.
std::string date_words(std::int64_t us, std::int64_t now_us, const ui::Strings& words) {
    const std::time_t when = us / 1'000'000, now = now_us / 1'000'000;
    std::tm then_tm{}, now_tm{};
    localtime_r(&when, &then_tm);
    localtime_r(&now, &now_tm);
    const bool today = then_tm.tm_year == now_tm.tm_year && then_tm.tm_yday == now_tm.tm_yday;
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), today ? "%H:%M" : "%Y-%m-%d", &then_tm);
    return today ? ui::filled_in(words["today"], {{"t", text.data()}}) : std::string(text.data());
}

std::int64_t clock_us(const GalleryOptions& options) {
    return options.store.now_us ? options.store.now_us() : std::int64_t{std::time(nullptr)} * 1'000'000;
}

}  // namespace

GalleryDesk::GalleryDesk(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages,
                         std::filesystem::path file, GalleryOptions options)
    : languages_(languages),
      screen_(fonts, languages),
      file_(std::move(file)),
      options_(std::move(options)),
      next_picture_(options_.first_picture) {}

bool GalleryDesk::ready() {
    if (store_) return true;
    core::Result<db::DesignStore> store = db::DesignStore::open(file_, db::OpenMode::Create, options_.store);
    if (!store && store.error().code == core::ErrorCode::WriteFailed)  // what can be read is shown
        store = db::DesignStore::open(file_, db::OpenMode::ReadOnly, options_.store);
    if (store)
        store_.emplace(std::move(*store));
    else
        state_.message = design_fault_words(store.error(), words());
    return store_.has_value();
}

void GalleryDesk::open(std::int64_t open_id, std::size_t language, ui::Hand hand) {
    state_ = {};
    state_.language = language;
    state_.hand = hand;
    state_.bin_days = options_.bin_days;
    open_id_ = open_id;
    deleted_id_ = renamed_id_ = 0;
    shown_.clear();
    pictures_.clear();
    if (!ready()) return;
    static_cast<void>(store_->purge(options_.bin_days));  // what cannot be written now goes another time
    refresh();
}

void GalleryDesk::refresh() {
    state_.cards.clear();
    entries_.clear();
    if (!store_) return;
    core::Result<std::vector<db::DesignEntry>> entries = store_->list(state_.bin ? db::Shelf::Bin : db::Shelf::Kept);
    if (!entries) {
        state_.message = design_fault_words(entries.error(), words());
        return;
    }
    entries_ = std::move(*entries);
    const std::int64_t now = clock_us(options_);
    for (const db::DesignEntry& entry : entries_)
        state_.cards.push_back({entry.name,
                                date_words(entry.deleted_us.value_or(entry.changed_us), now, words()),
                                {},
                                entry.id == open_id_});
    show_pictures();
}

void GalleryDesk::show_pictures() {
    for (std::size_t i = 0; i < state_.cards.size(); ++i) {
        const auto known = shown_.find(entries_[i].id);
        state_.cards[i].picture = known != shown_.end() ? known->second : std::nullopt;
    }
}

std::optional<ui::PictureId> GalleryDesk::read_picture(std::int64_t design) {
    const core::Result<std::vector<std::byte>> png = store_->thumbnail(design);
    if (!png || png->empty()) return std::nullopt;
    core::Result<core::RgbaImage> image = core::decode_rgba_image(*png);
    if (!image) return std::nullopt;
    const ui::PictureId picture{next_picture_++};
    pictures_.emplace_back(picture, std::move(*image));
    return picture;
}

void GalleryDesk::look(ui::SizePx screen, std::size_t most) {
    if (!store_) return;
    decltype(shown_) seen;
    for (const std::size_t i : page(screen, std::nullopt).seen) {
        const std::int64_t design = entries_[i].id;
        if (const auto known = shown_.find(design); known != shown_.end()) {
            seen.insert(*known);
        } else if (most > 0) {
            seen.emplace(design, read_picture(design));
            --most;
        }
    }
    if (seen == shown_) return;
    shown_ = std::move(seen);
    show_pictures();
}

bool GalleryDesk::shows(ui::PictureId picture) const {
    return std::any_of(shown_.begin(), shown_.end(), [&](const auto& shown) { return shown.second == picture; });
}

std::vector<std::pair<ui::PictureId, core::RgbaImage>> GalleryDesk::take_pictures() {
    return std::exchange(pictures_, {});
}

void GalleryDesk::tell(const core::Error& error, std::int64_t now_us) {
    state_.message = design_fault_words(error, words());
    state_.deleted.clear();
    shown_until_us_ = now_us + options_.undo_us;
}

/// Says what went wrong, or shows the shelf as it is now.
template <typename T>
bool GalleryDesk::did(const core::Result<T>& result, std::int64_t now_us) {
    if (!result) tell(result.error(), now_us);
    refresh();
    return result.has_value();
}

std::optional<GalleryWish> GalleryDesk::press(std::size_t item, std::int64_t now_us) {
    const std::size_t index = ui::gallery_index(item);
    const GalleryAction action = ui::gallery_action(item);
    if (action == GalleryAction::Close) return GalleryWish{GalleryWish::Kind::Close};
    if (action == GalleryAction::New) return GalleryWish{GalleryWish::Kind::New};
    if (action == GalleryAction::Key) {
        press_key(index, now_us);
        return std::nullopt;
    }
    if (action == GalleryAction::Shelf) {
        state_.bin = index == 1;
        state_.scroll = 0;
        refresh();
        return std::nullopt;
    }
    if (action == GalleryAction::UndoDelete) {
        if (store_ && deleted_id_ != 0) did(store_->restore(deleted_id_), now_us);
        state_.deleted.clear();
        return std::nullopt;
    }
    if (index >= entries_.size()) return std::nullopt;
    const db::DesignEntry entry = entries_[index];
    switch (action) {
        case GalleryAction::Open:
            return GalleryWish{GalleryWish::Kind::Open, entry.id};
        case GalleryAction::Duplicate:
            duplicate(index, now_us);
            break;
        case GalleryAction::Rename:
            renamed_id_ = entry.id;
            state_.rename = ui::NameEdit{.text = entry.name, .shift = true};
            state_.deleted.clear();
            break;
        case GalleryAction::Delete:
            if (entry.id == open_id_) break;  // it is being drawn on
            if (did(store_->remove(entry.id), now_us)) {
                deleted_id_ = entry.id;
                state_.deleted = entry.name.empty() ? words()["unnamed"] : entry.name;
                state_.message.clear();
                shown_until_us_ = now_us + options_.undo_us;
            }
            break;
        case GalleryAction::Restore:
            did(store_->restore(entry.id), now_us);
            break;
        default:
            break;
    }
    return std::nullopt;
}

void GalleryDesk::duplicate(std::size_t card, std::int64_t now_us) {
    const db::DesignEntry& entry = entries_[card];
    const std::string name = entry.name.empty() ? words()["unnamed"] : entry.name;
    did(store_->duplicate(entry.id, ui::filled_in(words()["copy_of"], {{"name", name}})), now_us);
}

void GalleryDesk::press_key(std::size_t key, std::int64_t now_us) {
    if (!state_.rename) return;
    // which keys there are does not depend on the screen's size
    const ui::KeyboardLayout layout = ui::keyboard_layout(*state_.rename, words(), {1920, 1080});
    if (key >= layout.keys.size()) return;
    switch (layout.keys[key].kind) {
        case ui::KeyboardKey::Kind::Letter:
            state_.rename->type(layout.keys[key].letter);
            break;
        case ui::KeyboardKey::Kind::Space:
            state_.rename->type(" ");
            break;
        case ui::KeyboardKey::Kind::Erase:
            state_.rename->erase();
            break;
        case ui::KeyboardKey::Kind::Shift:
            state_.rename->shift = !state_.rename->shift;
            break;
        case ui::KeyboardKey::Kind::Cancel:
            state_.rename.reset();
            break;
        case ui::KeyboardKey::Kind::Save:
            save_name(now_us);
            break;
    }
}

void GalleryDesk::save_name(std::int64_t now_us) {
    const std::string name = state_.rename->name();
    if (name.empty()) return;
    state_.rename.reset();
    if (renamed_id_ == open_id_) {  // its journal is open, and the only one to write to it
        new_name_ = name;
        for (std::size_t i = 0; i < entries_.size(); ++i)
            if (entries_[i].id == open_id_) entries_[i].name = state_.cards[i].name = name;
        return;
    }
    did(store_->rename(renamed_id_, name), now_us);
}

void GalleryDesk::scroll(double by, ui::SizePx screen) {
    const double most = page(screen, std::nullopt).most_scroll;
    state_.scroll = std::clamp(state_.scroll + by, 0.0, most);
}

void GalleryDesk::update(std::int64_t now_us) {
    if (shown_until_us_ == 0 || now_us < shown_until_us_) return;
    shown_until_us_ = 0;
    state_.deleted.clear();
    state_.message.clear();
}

ui::GalleryPage GalleryDesk::page(ui::SizePx screen, std::optional<std::size_t> pressed) const {
    ui::GalleryState shown = state_;
    shown.pressed = pressed;
    return screen_.build(shown, screen);
}

}  // namespace app
