// Draws the gallery with worked designs in it, in all its states:
//
//     gallery_view FOLDER    gallery-*.png at 1920 x 1080 and 1280 x 800, right- and left-handed, in three languages

#include <cstdio>
#include <filesystem>
#include <list>
#include <stdexcept>
#include <string>

#include "core/exchange/png_writer.hpp"
#include "core/garment/wardrobe.hpp"
#include "firmware_like_app/garment/gallery_desk.hpp"
#include "firmware_like_app/garment/turntable.hpp"
#include "ui/draw/painter.hpp"
#include "ui/gl/headless_context.hpp"

namespace {

namespace fs = std::filesystem;
using ui::GalleryAction;

template <typename T>
T value(core::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().sentence());
    return std::move(*result);
}

void need(const core::Result<void>& result) {
    if (!result) throw std::runtime_error(result.error().sentence());
}

constexpr std::int64_t kDay_us = 86'400'000'000, kNow_us = 20'000 * kDay_us;

/// A file of designs with pictures, some of them under other names.
void fill(const fs::path& file) {
    std::int64_t now_us = kNow_us - 9 * kDay_us;
    db::DesignStore store =
        value(db::DesignStore::open(file, db::OpenMode::Create, {.now_us = [&] { return now_us; }}));
    const core::Mannequin body = value(core::make_mannequin(value(core::measures_of_size("38"))));
    for (const std::string& name : core::wardrobe_names()) {
        core::Design design = value(core::wardrobe_design(name, body));
        app::Turntable table = value(app::Turntable::create(value(app::dress(design))));
        if (name == "jacket") design.name = "Evening jacket with a collar and two pockets, second try";
        const std::int64_t id = value(store.create(design));
        if (name != "trousers") need(store.set_thumbnail(id, value(core::png_bytes(table.picture(1, 12, {360, 480})))));
        now_us += kDay_us + kDay_us / 3;
    }
    value(store.create({}));
}

class View {
  public:
    View(fs::path folder, const ui::FontSet& fonts, const std::vector<ui::Strings>& languages)
        : folder_(std::move(folder)),
          fonts_(fonts),
          languages_(languages),
          painter_(value(ui::Painter::create(fonts))) {}

    void draw(const std::string& name, std::size_t language, ui::Hand hand, const std::vector<std::size_t>& presses) {
        app::GalleryDesk desk(fonts_, languages_, folder_ / "designs.db",
                              {.bin_days = 30, .store = {.now_us = [] { return kNow_us; }}});
        desk.open(2, language, hand);
        for (const std::size_t item : presses) static_cast<void>(desk.press(item, 0));
        for (auto& [id, image] : desk.take_pictures()) {
            textures_.emplace_back(ui::SizePx{image.width, image.height}, ui::PixelFormat::Colour);
            textures_.back().upload(0, 0, {image.width, image.height}, image.pixels);
            painter_.set_picture(id, &textures_.back());
        }
        for (const ui::SizePx size : {ui::SizePx{1920, 1080}, ui::SizePx{1280, 800}, ui::SizePx{1080, 1920}}) {
            const ui::Target target(size, ui::PixelFormat::Colour);
            target.bind();
            ui::clear(1, 1, 1, 1, false);
            painter_.paint(desk.page(size, std::nullopt).list, size, false);
            const fs::path file = folder_ / ("gallery-" + name + "-" + std::to_string(size.width) + "x" +
                                             std::to_string(size.height) + ".png");
            need(core::write_png(file, target.read_back()));
            std::printf("%s\n", file.c_str());
        }
    }

  private:
    fs::path folder_;
    const ui::FontSet& fonts_;
    const std::vector<ui::Strings>& languages_;
    ui::Painter painter_;
    std::list<ui::Texture> textures_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::fprintf(stderr, "gallery_view FOLDER\n"), 2;
    const fs::path folder = argv[1];
    try {
        fs::create_directories(folder);
        for (const char* end : {"", "-wal", "-shm"}) fs::remove((folder / "designs.db").string() + end);
        fill(folder / "designs.db");  // makes contexts of its own
        const auto context = value(ui::make_headless_context());
        const auto fonts = value(ui::FontSet::load());
        const auto languages = value(ui::Strings::load_all());
        View view(folder, fonts, languages);
        const auto key = [](std::size_t k) { return ui::gallery_item(GalleryAction::Key, k); };
        view.draw("kept", 0, ui::Hand::Right, {});
        view.draw("kept-left-de", 2, ui::Hand::Left, {});
        view.draw("rename-fr", 1, ui::Hand::Right, {ui::gallery_item(GalleryAction::Rename, 1)});
        view.draw("rename-de", 2, ui::Hand::Right,
                  {ui::gallery_item(GalleryAction::Rename, 1), key(36), key(11), key(12), key(13)});
        view.draw("deleted", 0, ui::Hand::Right, {ui::gallery_item(GalleryAction::Delete, 2)});
        view.draw("bin", 0, ui::Hand::Right, {ui::gallery_item(GalleryAction::Shelf, 1)});
        view.draw("bin-empty-fr", 1, ui::Hand::Left,
                  {ui::gallery_item(GalleryAction::Shelf, 1), ui::gallery_item(GalleryAction::Restore, 0),
                   ui::gallery_item(GalleryAction::Shelf, 1)});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
