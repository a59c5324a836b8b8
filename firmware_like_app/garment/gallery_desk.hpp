#pragma once
// The gallery at work: what is kept, on the screen's cards; touches in, wishes out. No GL and no thread; the mode shows
// the screen and uploads the pictures. Reads and writes the file of designs on the calling thread, some milliseconds a
// touch, while nobody draws.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/silhouette/image.hpp"
#include "db/stores/design_store.hpp"
#include "ui/screens/gallery_screen.hpp"

namespace app {

struct GalleryOptions {
    int bin_days = 30;
    int first_picture = 400;  ///< numbers of the cards' pictures begin here and are given once
    std::int64_t undo_us = 8'000'000;
    db::DesignStoreOptions store = {};
};

/// What the visitor wants of the mode.
struct GalleryWish {
    enum class Kind { Close, New, Open };
    Kind kind = Kind::Close;
    std::int64_t id = 0;  ///< Open
};

class GalleryDesk {
  public:
    /// Both must outlive it.
    GalleryDesk(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, std::filesystem::path file,
                GalleryOptions options = {});

    /// Reads what is kept; `open_id`: the design on the sheet, 0 for none. What lies in the bin too long goes. A file
    /// that cannot be read gives an empty gallery with a sentence.
    void open(std::int64_t open_id, std::size_t language, ui::Hand hand);

    /// `item` of Control::Gallery that was released. A name changed here of the design on the sheet is told by
    /// take_new_name.
    std::optional<GalleryWish> press(std::size_t item, std::int64_t now_us);
    /// The design on the sheet got another name.
    [[nodiscard]] std::optional<std::string> take_new_name() { return std::exchange(new_name_, std::nullopt); }
    /// Pixels, positive: what lies below comes into sight.
    void scroll(double by, ui::SizePx screen);
    /// Ends what is shown for a time.
    void update(std::int64_t now_us);
    /// Reads the pictures of cards that are on the screen, `most` of them, some milliseconds each, and lets go of those
    /// of cards that are there no more: a gallery of thousands opens as quickly as one of a few, and holds no more.
    void look(ui::SizePx screen, std::size_t most);
    /// Whether a card shows the picture of that number.
    [[nodiscard]] bool shows(ui::PictureId picture) const;

    [[nodiscard]] ui::GalleryPage page(ui::SizePx screen, std::optional<std::size_t> pressed) const;
    [[nodiscard]] const ui::GalleryState& state() const { return state_; }

    /// Pictures that look() has read and that were not taken yet.
    [[nodiscard]] std::vector<std::pair<ui::PictureId, core::RgbaImage>> take_pictures();

  private:
    [[nodiscard]] bool ready();
    void refresh();
    void show_pictures();
    [[nodiscard]] std::optional<ui::PictureId> read_picture(std::int64_t design);
    void tell(const core::Error& error, std::int64_t now_us);
    template <typename T>
    bool did(const core::Result<T>& result, std::int64_t now_us);
    void duplicate(std::size_t card, std::int64_t now_us);
    void press_key(std::size_t key, std::int64_t now_us);
    void save_name(std::int64_t now_us);
    [[nodiscard]] const ui::Strings& words() const { return languages_[state_.language]; }

    const std::vector<ui::Strings>& languages_;
    ui::GalleryScreen screen_;
    std::filesystem::path file_;
    GalleryOptions options_;
    std::optional<db::DesignStore> store_;
    std::vector<db::DesignEntry> entries_;  // of the shelf, as the cards
    ui::GalleryState state_;
    std::int64_t open_id_ = 0, deleted_id_ = 0, renamed_id_ = 0, shown_until_us_ = 0;
    std::optional<std::string> new_name_;
    std::vector<std::pair<ui::PictureId, core::RgbaImage>> pictures_;
    std::map<std::int64_t, std::optional<ui::PictureId>> shown_;  // by design; nothing: it has none that can be read
    int next_picture_ = 0;
};

}  // namespace app
