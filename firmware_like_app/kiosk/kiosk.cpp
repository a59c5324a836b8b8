#include "firmware_like_app/kiosk/kiosk.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <utility>

#include "core/exchange/design_file.hpp"
#include "core/exchange/png_writer.hpp"
#include "firmware_like_app/health/self_test.hpp"
#include "firmware_like_app/kiosk/drawing_recorder.hpp"
#include "firmware_like_app/kiosk/find_mode.hpp"
#include "firmware_like_app/kiosk/live_searcher.hpp"
#include "firmware_like_app/kiosk/settings.hpp"
#include "firmware_like_app/kiosk/shell.hpp"
#include "firmware_like_app/kiosk/surface.hpp"

namespace app {
namespace {

constexpr std::array<int, 4> kMarks{25, 50, 75, 100};  // per cent of the ink
constexpr std::array<int, 3> kEarly{40, 60, 80};
constexpr std::size_t kEarlyShown = 10;
constexpr std::int64_t kReplayRest_us = 2'500'000;  // in a window, for people to see the result
constexpr ui::SizePx kDefaultSize{1920, 1080};
constexpr std::int64_t kCollectionLook_us = 250'000, kInputLook_us = 2'000'000;
constexpr std::int64_t kDay_us = 86'400'000'000;

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Letters, digits, dot, dash and underscore; anything else would make a file name awkward.
std::string file_part(const std::string& name) {
    std::string out;
    for (const char c : name) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_';
        out += plain ? c : '-';
    }
    return out.substr(0, 80);
}

class Loop {
  public:
    Loop(const KioskOptions& options, std::vector<NamedDrawing> replays, Surface& surface, FindMode& find,
         GarmentMode& garment, Shell& shell, const std::vector<ui::Strings>& languages, PenDesk& pens,
         CollectionHost& collection)
        : options_(options),
          replays_(std::move(replays)),
          surface_(surface),
          find_(find),
          garment_(garment),
          shell_(shell),
          languages_(languages),
          pens_(pens),
          collection_(collection),
          player_(replays_, options.headless ? 0 : kReplayRest_us),
          recorder_(options.record) {
        report_.renderer = ui::renderer_name();
    }

    core::Result<KioskReport> run() {
        if (replays_.empty() && options_.garments.empty() && options_.headless) return still_picture();
        start_us_ = surface_.now_us();
        if (!replays_.empty()) shell_.open_sheet(start_us_);
        for (const GarmentReplay& garment : options_.garments) play(garment);
        start_us_ = surface_.now_us();
        while (!ended_ && failure_.has_value()) {
            point();
            replay();
            show();
            if (player_.ended() &&
                (options_.headless || (options_.end_after_replays && !(replays_.empty() && options_.garments.empty()))))
                break;
        }
        if (!options_.headless) record();
        if (!failure_) return core::unexpected(failure_.error());
        finish_times();
        return std::move(report_);
    }

  private:
    core::Result<KioskReport> still_picture() {
        report_.replays.emplace_back();
        find_.settle(true);
        shoot("sheet");
        if (!failure_) return core::unexpected(failure_.error());
        finish_times();
        return std::move(report_);
    }

    /// All that pointed since the last call: once a frame, and while a stroke is drawn also between frames, so that its
    /// search need not wait for the next one.
    void point() {
        const std::vector<ui::WindowEvent> events =
            pens_.merge(surface_.poll(), surface_.size(), shell_.sheet(), surface_.now_us());
        for (const ui::WindowEvent& event : events) {
            if (event.pen && event.kind == ui::WindowEvent::Kind::Move) not_shown_us_.push_back(event.time_us);
            handle(event);
        }
        shell_.set_tablet(!pens_.tablets().empty(), surface_.now_us());
        if (pens_.pen_near()) shell_.pen_near(false, surface_.now_us());
        find_.look_ahead(pens_.predicted());
        for (std::string& problem : pens_.take_problems()) tell_problem(std::move(problem));
        report_.pen_reports_lost = pens_.lost();
    }

    void handle(const ui::WindowEvent& event) {
        using Kind = ui::WindowEvent::Kind;
        switch (event.kind) {
            case Kind::Close:
                ended_ = true;
                break;
            case Kind::Escape:
                ended_ = ended_ || options_.escape_exits;
                break;
            case Kind::Resized:
                shell_.resize(surface_.size(), event.time_us);
                frame_due_ = true;
                break;
            case Kind::Exposed:
            case Kind::FocusGained:
                frame_due_ = true;  // what the screen shows may be gone
                break;
            case Kind::FocusLost:
            case Kind::Cancel:
                shell_.cancel_pointer(event.time_us);
                break;
            case Kind::Down:
            case Kind::Move:
            case Kind::Up:
            case Kind::Leave:
            case Kind::TakeBack:
            case Kind::Zoom:
                if (player_.ended()) pointer(event);
                break;
        }
    }

    void pointer(const ui::WindowEvent& event) {
        note_drawing();
        shell_.pointer(event);
        if (find_.sketch().empty()) record();
    }

    void update() {
        if (!options_.record.empty()) note_drawing();
        look_at_collection();
        shell_.update(surface_.now_us());
        report_.restart = shell_.restart_wanted();
        ended_ = ended_ || shell_.exit_wanted() || report_.restart;
        if (surface_.shows_frames()) shell_.update_ink();
        if (!options_.headless && find_.sketch().empty()) record();
    }

    /// How long the pen's reports took to the screen, the last 200 of them. What changed nothing there does not count.
    void note_shown(bool drawn) {
        for (const std::int64_t time_us : not_shown_us_) {
            if (!drawn) break;
            to_screen_ms_[to_screen_count_++ % to_screen_ms_.size()] =
                static_cast<double>(surface_.now_us() - time_us) * 1e-3;
        }
        not_shown_us_.clear();
    }

    [[nodiscard]] std::optional<double> pen_to_screen_ms() const {
        if (to_screen_count_ < to_screen_ms_.size() / 4) return std::nullopt;
        auto ms = to_screen_ms_;
        const auto end = ms.begin() + static_cast<std::ptrdiff_t>(std::min(to_screen_count_, ms.size()));
        const auto middle = ms.begin() + (end - ms.begin()) / 2;
        std::nth_element(ms.begin(), middle, end);
        return *middle;
    }

    /// For the station page.
    void tell_facts() {
        StationFacts facts;
        const std::int64_t now_us = surface_.now_us();
        if (now_us - day_start_us_ > kDay_us) {
            day_start_us_ = now_us;
            worst_today_ms_ = 0;
        }
        facts.running_s = (now_us - start_us_) / 1'000'000;
        facts.worst_frame_ms = worst_today_ms_;
        facts.renderer = report_.renderer;
        facts.pen_to_screen_ms = pen_to_screen_ms();
        for (const DeskTablet& tablet : pens_.tablets()) {
            facts.tablets.push_back(tablet.name);
            facts.pen_asleep = facts.pen_asleep || tablet.asleep;
        }
        facts.problems = report_.problems;
        facts.memory_mb = memory_mb_;
        facts.free_disk_gb = free_disk_gb_;
        shell_.set_facts(std::move(facts));
    }

    void look_at_collection() {
        if (surface_.now_us() - collection_seen_us_ < kCollectionLook_us) return;
        collection_seen_us_ = surface_.now_us();
        const CollectionStatus status = collection_.status();
        tell_facts();
        if (surface_.now_us() - input_seen_us_ >= kInputLook_us) {
            input_seen_us_ = surface_.now_us();
            const std::string& database = options_.config.collection.database;
            memory_mb_ = resident_mb();
            free_disk_gb_ = free_disk_gb(database.empty() ? "." : database);
            shell_.set_no_input(pens_.tablets().empty() ? surface_.no_input_code() : "", surface_.now_us());
        }
        shell_.set_collection(status.state, {status.done, status.total, status.minutes_left}, surface_.now_us());
    }

    void note_drawing() {
        if (find_.sketch().empty() || find_.sketch().revision() == noted_revision_) return;
        noted_revision_ = find_.sketch().revision();
        last_drawing_ = find_.sketch().drawing();
    }

    /// Keeps what a visitor drew when the sheet is emptied, by the visitor or by time, or the kiosk ends. A folder that
    /// is full costs the recording, never the station; it is told once until drawings can be kept again.
    void record() {
        note_drawing();
        if (last_drawing_.empty()) return;
        pens_.mark("the sheet was emptied");
        const core::Result<void> kept = recorder_.keep(std::exchange(last_drawing_, {}));
        if (!kept && recording_works_) tell_problem(kept.error().sentence());
        recording_works_ = kept.has_value();
    }

    void tell_problem(std::string problem) {
        if (report_.problems.size() < 100) report_.problems.push_back(std::move(problem));
    }

    void replay() {
        const std::int64_t now_us = surface_.now_us();
        while (const std::optional<ReplayEvent> event = player_.next(now_us - start_us_)) {
            shell_.pen_near(true, now_us);  // a replay is a visitor: the sheet is not wiped under it
            replay_event(*event, now_us);
            if (!failure_) return;
        }
    }

    void replay_event(const ReplayEvent& event, std::int64_t now_us) {
        switch (event.kind) {
            case ReplayEvent::Kind::DrawingStarts:
                report_.replays.push_back({});
                report_.replays.back().name = replays_[event.drawing].name;
                searches_before_ = find_.searches();
                next_mark_ = 0;
                early_.clear();
                find_.start_sheet_for(replays_[event.drawing].drawing);
                break;
            case ReplayEvent::Kind::Down:
                find_.begin_stroke(event.sample, now_us);
                break;
            case ReplayEvent::Kind::Move:
                find_.extend_stroke(event.sample);
                break;
            case ReplayEvent::Kind::Up:
                find_.end_stroke(now_us);
                if (options_.headless && !options_.early_looks) find_.search_and_wait();
                break;
            case ReplayEvent::Kind::DrawingEnds:
                find_.search_and_wait();
                while (next_mark_ < kMarks.size()) mark();
                finish_replay();
                return;
        }
        if (options_.early_looks) look_early(event.ink_share);
        // the last mark waits for the end, where the pen has lifted
        while (next_mark_ + 1 < kMarks.size() && event.ink_share * 100 >= kMarks[next_mark_]) mark();
    }

    /// Notes the first models when enough ink is there.
    void look_early(double ink_share) {
        while (early_.size() < kEarly.size() && ink_share * 100 >= kEarly[early_.size()]) {
            find_.search_and_wait();
            early_.emplace_back();
            const PreparedAnswer* ranking = find_.ranking();
            if (ranking == nullptr) continue;
            for (const FoundModel& model : ranking->answer.best) {
                if (early_.back().size() < kEarlyShown) early_.back().push_back(model.id);
            }
        }
    }

    /// A garment drawn again, event by event in its own time, then its design beside the pictures.
    void play(const GarmentReplay& replay) {
        if (!failure_ || ended_) return;
        const std::int64_t start_us = surface_.now_us();
        report_.replays.emplace_back();
        report_.replays.back().name = replay.name;
        shell_.open_sheet(start_us);
        shell_.open_garment(true, start_us);
        garment_.wipe(language_named(replay.start.language), replay.start.hand);
        std::size_t next = 0, mark = 0, placed = 0;
        const auto place_due = [&] {
            for (; placed < replay.placed.size() && replay.placed[placed].before <= next; ++placed)
                garment_.place(replay.placed[placed].object, surface_.now_us());
        };
        while (next < replay.events.size() && failure_ && !ended_) {
            const std::int64_t now_us = surface_.now_us();
            shell_.pen_near(true, now_us);
            for (; next < replay.events.size() && start_us + replay.events[next].time_us <= now_us; ++next) {
                place_due();
                play(replay.events[next], replay.start.screen, start_us);
            }
            for (const ui::WindowEvent& event : surface_.poll()) handle(event);
            show();
            const std::size_t done = next * 100 / replay.events.size();
            if (!garment_.pen_is_down() && mark < kMarks.size() && done >= static_cast<std::size_t>(kMarks[mark])) {
                while (mark < kMarks.size() && done >= static_cast<std::size_t>(kMarks[mark])) ++mark;
                shoot_garment(replay.name, kMarks[mark - 1]);
            }
        }
        place_due();
        if (mark < kMarks.size() || replay.events.empty()) shoot_garment(replay.name, kMarks.back());
        keep_design(replay.name);
    }

    /// An event as if it happened now, on a screen of this size.
    void play(ui::WindowEvent event, ui::SizePx screen, std::int64_t start_us) {
        event.time_us += start_us;
        const double sx = static_cast<double>(surface_.size().width) / screen.width;
        const double sy = static_cast<double>(surface_.size().height) / screen.height;
        if (event.kind != ui::WindowEvent::Kind::Zoom || event.finger) {
            event.x *= sx;
            event.y *= sy;
        }
        event.shift_x *= sx;
        event.shift_y *= sy;
        if (event.kind == ui::WindowEvent::Kind::Cancel) return shell_.cancel_pointer(event.time_us);
        shell_.pointer(event);
    }

    /// A turn of the loop without its input.
    void show() {
        update();
        const bool drawn = surface_.shows_frames() && (frame_due_ || shell_.changed(surface_.now_us()));
        if (drawn) {
            draw_frame();
            frame_due_ = false;
        }
        const std::function<void()> look = [this] {
            point();
            find_.search_news();
        };
        const auto meanwhile = [this, drawn] {
            note_shown(drawn);
            shell_.use_spare_time();
        };
        surface_.next_frame(drawn, meanwhile, find_.sketch().open() ? look : std::function<void()>());
    }

    void shoot_garment(const std::string& name, int percent) {
        if (options_.shots.empty() || !options_.headless) return;
        garment_.settle(surface_.now_us());
        std::array<char, 16> end{};
        std::snprintf(end.data(), end.size(), "-%03d", percent);
        shoot(file_part(name) + end.data());
    }

    void keep_design(const std::string& name) {
        garment_.settle(surface_.now_us());
        ReplayReport& report = report_.replays.back();
        const core::Design design = garment_.design();
        report.steps = static_cast<int>(design.steps.size());
        for (const core::NetworkRegion& region : garment_.desk().network().regions()) report.pieces += region.alive;
        if (options_.shots.empty()) return;
        report.design = options_.shots / (file_part(name) + ".design.json");
        std::ofstream file(report.design, std::ios::binary);
        file << core::design_text(design);
        file.close();
        if (file) return;
        failure_ =
            core::unexpected(core::ErrorCode::WriteFailed,
                             "the design cannot be written; check that the folder has room", report.design.string());
    }

    [[nodiscard]] std::size_t language_named(const std::string& code) const {
        for (std::size_t i = 0; i < languages_.size(); ++i) {
            if (languages_[i].code() == code) return i;
        }
        return 0;
    }

    void mark() {
        const int percent = kMarks[next_mark_++];
        if (options_.shots.empty()) return;
        find_.search_and_wait();
        find_.settle(percent == 100);
        std::array<char, 16> end{};
        std::snprintf(end.data(), end.size(), "-%03d", percent);
        shoot(file_part(report_.replays.back().name) + end.data());
    }

    void shoot(const std::string& name) {
        if (options_.shots.empty()) return;
        std::array<char, 16> number{};
        std::snprintf(number.data(), number.size(), "%04d-", ++shots_);
        const std::filesystem::path path = options_.shots / (number.data() + name + ".png");
        shell_.update_ink();
        draw_frame();
        failure_ = core::write_png(path, surface_.read_back());
        if (failure_) report_.replays.back().shots.push_back(path);
    }

    void finish_replay() {
        ReplayReport& replay = report_.replays.back();
        replay.searches = static_cast<int>(find_.searches() - searches_before_);
        replay.failure = find_.search_failure();
        const PreparedAnswer* last = find_.ranking();
        if (last == nullptr) return;
        for (const FoundModel& model : last->answer.best) {
            replay.ids.push_back(model.id);
            replay.names.push_back(model.name);
        }
        for (std::size_t i = 0; i < early_.size() && !replay.ids.empty(); ++i) {
            replay.end_seen[i] = std::find(early_[i].begin(), early_[i].end(), replay.ids[0]) != early_[i].end();
        }
        replay.message_key = last->answer.message_key;
        replay.silhouette_ms = last->answer.silhouette_ms;
        replay.describe_ms = last->answer.describe_ms;
        replay.search_ms = last->answer.search_ms;
    }

    void draw_frame() {
        const auto start = std::chrono::steady_clock::now();
        const bool flip = surface_.bind();
        shell_.draw(surface_.now_us(), flip, surface_.kept());
        const double ms = ms_since(start);
        report_.worst_frame_ms = std::max(report_.worst_frame_ms, ms);
        worst_today_ms_ = std::max(worst_today_ms_, ms);
        ++report_.frames;
        ++frame_ms_[static_cast<std::size_t>(std::clamp(ms * 4, 0.0, frame_ms_.size() - 1.0))];
    }

    void finish_times() {
        std::int64_t seen = 0;
        for (std::size_t i = 0; i < frame_ms_.size(); ++i) {
            seen += frame_ms_[i];
            if (seen * 2 < report_.frames || report_.frames == 0) continue;
            report_.median_frame_ms = (static_cast<double>(i) + 0.5) / 4;
            return;
        }
    }

    const KioskOptions& options_;
    std::vector<NamedDrawing> replays_;
    Surface& surface_;
    FindMode& find_;
    GarmentMode& garment_;
    Shell& shell_;
    const std::vector<ui::Strings>& languages_;
    PenDesk& pens_;
    CollectionHost& collection_;
    std::int64_t collection_seen_us_ = -kCollectionLook_us, input_seen_us_ = -kInputLook_us;
    ReplayPlayer player_;
    DrawingRecorder recorder_;
    bool recording_works_ = true;
    core::Drawing last_drawing_;
    std::uint64_t noted_revision_ = 0;
    KioskReport report_;
    core::Result<void> failure_;
    std::vector<std::int64_t> not_shown_us_;  // pen reports since the last frame
    std::array<double, 200> to_screen_ms_{};
    std::size_t to_screen_count_ = 0;
    std::int64_t start_us_ = 0, day_start_us_ = 0;
    double worst_today_ms_ = 0, memory_mb_ = 0, free_disk_gb_ = 0;
    std::uint64_t searches_before_ = 0;
    std::size_t next_mark_ = 0;
    std::vector<std::vector<std::int64_t>> early_;
    int shots_ = 0;
    bool ended_ = false;
    bool frame_due_ = true;
    std::array<std::int64_t, 2000> frame_ms_{};  // how many frames took each quarter of a millisecond
};

core::Result<std::unique_ptr<Surface>> open_surface(const KioskOptions& options) {
    if (options.headless) {
        const ui::SizePx usual = options.garments.empty() ? kDefaultSize : options.garments.front().start.screen;
        return make_headless_surface(options.size.value_or(usual));
    }
    ui::WindowOptions window;
    window.size = options.size.value_or(kDefaultSize);
    window.full_screen = !options.windowed;
    return open_window_surface(window);
}

core::Result<std::unique_ptr<PenDesk>> open_pens(const KioskOptions& options, input::DeviceNumbers& numbers) {
    PenDeskOptions desk;
    desk.pipeline = options.pens;
    desk.tablet_changed = options.tablet_changed;
    if (options.headless) return PenDesk::create(nullptr, numbers, std::move(desk));
    if (!options.record.empty()) desk.trace = next_free(options.record, "pointers");
    return PenDesk::create(options.tablets ? open_desk_tablets(numbers) : nullptr, numbers, std::move(desk));
}

core::Result<void> make_folder(const std::filesystem::path& folder) {
    if (folder.empty()) return {};
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error) return {};
    return core::unexpected(core::ErrorCode::WriteFailed, "the folder cannot be made (" + error.message() + ")",
                            folder.string());
}

}  // namespace

core::Result<KioskReport> run_kiosk(const KioskOptions& options, CollectionHost& collection,
                                    std::vector<NamedDrawing> replays) {
    if (options.headless && replays.empty() && options.garments.empty() && options.shots.empty()) {
        return core::unexpected(core::ErrorCode::BadArgument,
                                "a kiosk without a screen needs something to do; give --replay, --shots or both");
    }
    for (const std::filesystem::path& folder : {options.shots, options.record}) {
        if (const core::Result<void> made = make_folder(folder); !made) return core::unexpected(made.error());
    }
    core::Result<std::vector<ui::Strings>> languages = ui::Strings::load_all(options.languages_folder);
    if (!languages) return core::unexpected(languages.error());
    const auto language = std::find_if(languages->begin(), languages->end(),
                                       [&](const ui::Strings& s) { return s.code() == options.language; });
    if (language == languages->end()) {
        return core::unexpected(core::ErrorCode::BadArgument,
                                "there are no words in the language \"" + options.language + "\"; use en, fr or de");
    }
    core::Result<ui::FontSet> fonts = ui::FontSet::load();
    if (!fonts) return core::unexpected(fonts.error());
    core::Result<std::unique_ptr<Surface>> surface = open_surface(options);
    if (!surface) return core::unexpected(surface.error());

    FindOptions find_options;
    find_options.language = static_cast<std::size_t>(language - languages->begin());
    find_options.hand = options.hand;
    find_options.shadow = options.config.visitors.shadow;
    ui::palette::choose_parts(part_palette_of(options.config));
    find_options.every_frame_seen = !options.headless;
    find_options.search_while_drawing = !options.headless;
    find_options.spare_time = true;
    core::Result<std::unique_ptr<FindMode>> find =
        FindMode::create(*fonts, *languages, &collection.searcher(), find_options, (*surface)->size());
    if (!find) return core::unexpected(find.error());
    GarmentOptions garment_options;
    garment_options.language = find_options.language;
    garment_options.hand = options.hand;
    garment_options.every_frame_seen = !options.headless;
    garment_options.record = options.record;
    if (!options.headless) garment_options.designs = options.config.garment.designs;
    garment_options.export_to = options.config.garment.export_to;
    garment_options.bodies = options.config.garment.bodies;
    garment_options.fabrics = options.config.garment.fabrics;
    garment_options.models = options.config.collection.database;
    garment_options.bin_days = static_cast<int>(options.config.garment.bin_days);
    core::Result<std::unique_ptr<GarmentMode>> garment =
        GarmentMode::create(*fonts, *languages, garment_options, (*surface)->size());
    if (!garment) return core::unexpected(garment.error());
    if (options.config.visitors.garment && !options.headless) (*garment)->prepare();
    ShellOptions shell_options;
    shell_options.garment = garment->get();
    shell_options.garment_offered = options.config.visitors.garment;
    shell_options.times = options.times;
    shell_options.collection = collection.status().state;
    shell_options.language = find_options.language;
    shell_options.hand = options.hand;
    shell_options.attract = options.attract;
    shell_options.attract_folder = options.config.visitors.attract_drawings;
    shell_options.pin = options.config.station.pin;
    shell_options.station.config = options.config;
    shell_options.station.config_file = options.config_file;
    shell_options.station.collection = &collection;
    PenDesk* pens_in_use = nullptr;
    shell_options.station.changed = [&pens_in_use](const Config& config) {
        if (pens_in_use != nullptr) pens_in_use->set_pipeline(pens_of(config));
    };
    shell_options.every_frame_seen = !options.headless;
    core::Result<std::unique_ptr<Shell>> shell = Shell::create(*fonts, *languages, **find, &collection.searcher(),
                                                               shell_options, (*surface)->size(), (*surface)->now_us());
    if (!shell) return core::unexpected(shell.error());
    if (options.expect_tablet) (*shell)->expect_tablet((*surface)->now_us());
    input::DeviceNumbers numbers;
    core::Result<std::unique_ptr<PenDesk>> pens = open_pens(options, numbers);
    if (!pens) return core::unexpected(pens.error());
    pens_in_use = pens->get();
    return Loop(options, std::move(replays), **surface, **find, **garment, **shell, *languages, **pens, collection)
        .run();
}

core::Result<KioskReport> run_kiosk(const KioskOptions& options, Searcher* searcher,
                                    std::vector<NamedDrawing> replays) {
    FixedCollection collection(searcher, options.collection);
    return run_kiosk(options, collection, std::move(replays));
}

}  // namespace app
