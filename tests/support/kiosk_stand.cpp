#include "tests/support/kiosk_stand.hpp"

#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "firmware_like_app/kiosk/placing.hpp"
#include "firmware_like_app/kiosk/settings.hpp"

namespace test {
namespace {

template <typename T>
T value_of(core::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().sentence());
    return std::move(*result);
}

/// Bodies are made once for all stands: that takes most of what a visit costs a test.
core::Result<core::GarmentDesk> desk_on_known_body(const std::string& label) {
    static std::mutex mutex;
    static std::map<std::string, core::DesignRunner> known;
    const std::lock_guard lock(mutex);
    core::Design design;
    design.body = value_of(core::measures_of_size(label));
    auto found = known.find(label);
    if (found == known.end()) {
        const core::DressForm form = core::dress_form(value_of(core::make_mannequin(design.body)));
        found = known.emplace(label, value_of(core::DesignRunner::start(design, form))).first;
    }
    return core::GarmentDesk::open(std::move(design), found->second);
}

}  // namespace

StandBase::StandBase()
    : context(value_of(ui::make_headless_context())),
      fonts(value_of(ui::FontSet::load())),
      languages(value_of(ui::Strings::load_all())),
      figures(make_animals()) {
    for (const char* name : {"box", "glyph", "picture", "ink", "model", "soft", "figure"}) {
        shaders.push_back(value_of(ui::Program::load(name)));
    }
}

KioskStand::KioskStand(ui::SizePx wanted, app::ShellOptions options, app::FindOptions find_options,
                       const std::filesystem::path& record, std::shared_ptr<StandBase> base,
                       app::GarmentOptions garment_options)
    : base_(base ? std::move(base) : std::make_shared<StandBase>()),
      languages(base_->languages),
      collection(&base_->figures),
      size(wanted) {
    ui::palette::choose_parts(app::part_palette_of(options.station.config));
    find_options.shadow = options.station.config.visitors.shadow;
    options.every_frame_seen = false;
    if (options.station.collection == nullptr) options.station.collection = &collection;
    find_options.language = options.language;
    find_options.hand = options.hand;
    find = value_of(app::FindMode::create(base_->fonts, languages, &collection.searcher(), find_options, size));
    garment_options.language = options.language;
    garment_options.hand = options.hand;
    garment_options.every_frame_seen = false;
    garment_options.record = record;
    if (garment_options.bodies.empty() && !garment_options.first_desk) garment_options.first_desk = desk_on_known_body;
    garment = value_of(app::GarmentMode::create(base_->fonts, languages, garment_options, size));
    options.garment = garment.get();
    shell = value_of(app::Shell::create(base_->fonts, languages, *find, &collection.searcher(), options, size, now_us));
}

void KioskStand::wait(double seconds) {
    const std::int64_t end = now_us + static_cast<std::int64_t>(seconds * 1e6);
    while (now_us < end) {
        now_us = std::min(now_us + (seconds > 5 ? 100'000 : 1'000'000 / 60), end);
        shell->update(now_us);
    }
}

void KioskStand::event(ui::WindowEvent::Kind kind, double x, double y) {
    now_us += 8'000;
    shell->pointer({kind, x, y, 1.0, now_us, false});
}

void KioskStand::tap(double x, double y) {
    event(ui::WindowEvent::Kind::Down, x, y);
    event(ui::WindowEvent::Kind::Up, x, y);
}

void KioskStand::stroke(double x0, double y0, double x1, double y1) {
    event(ui::WindowEvent::Kind::Down, x0, y0);
    for (int i = 1; i <= 10; ++i) event(ui::WindowEvent::Kind::Move, x0 + (x1 - x0) * i / 10, y0 + (y1 - y0) * i / 10);
    event(ui::WindowEvent::Kind::Up, x1, y1);
}

void KioskStand::draw_horse(double share) {
    const core::Drawing horse = make_horse_drawing();
    const ui::Rect sheet = find->layout().sheet;
    const ui::InkFrame frame = app::fit_drawing(horse, sheet.width, sheet.height, 0.14);
    std::size_t all = 0, drawn = 0;
    for (const core::Stroke& stroke : horse.strokes) all += stroke.samples.size();
    const auto wanted = static_cast<std::size_t>(share * static_cast<double>(all));
    for (const core::Stroke& stroke : horse.strokes) {
        bool first = true;
        core::Point p;
        for (const core::PenSample& s : stroke.samples) {
            if (drawn++ >= wanted) break;
            p = frame.to_px({s.x, s.y}) + core::Point{sheet.x, sheet.y};
            event(first ? ui::WindowEvent::Kind::Down : ui::WindowEvent::Kind::Move, p.x, p.y);
            first = false;
        }
        if (drawn > wanted) break;
        event(ui::WindowEvent::Kind::Up, p.x, p.y);
    }
    find->search_and_wait();
    find->settle(drawn == all);
    shell->update_ink();
}

void KioskStand::type(const std::string& digits) {
    const ui::PinScreen screen(base_->fonts, languages);
    for (const char digit : digits) {
        for (const ui::BoardTouch::Target& target : screen.targets({}, size)) {
            if (target.control != ui::Control::Digit || target.item != static_cast<std::size_t>(digit - '0')) continue;
            tap(target.rect);
            break;
        }
    }
}

void KioskStand::press_station(ui::StationAction action, std::size_t index) {
    const ui::StationPage page = shell->station_page(now_us);
    for (const ui::BoardTouch::Target& target : page.targets) {
        if (target.item == ui::station_item(action, index)) return tap(target.rect);
    }
    throw std::runtime_error("the station page has no such control now");
}

core::RgbaImage KioskStand::picture() {
    if (shell->in_garment()) garment->settle(now_us);
    shell->update_ink();
    ui::Target target(size, ui::PixelFormat::Colour);
    target.bind();
    shell->draw(now_us, false);
    return target.read_back();
}

}  // namespace test
