#include "firmware_like_app/kiosk/operator_desk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <numbers>
#include <utility>

#include "core/exchange/mesh_reader.hpp"
#include "firmware_like_app/health/self_test.hpp"
#include "ui/draw/ink_curve.hpp"
#include "ui/screens/widgets.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;
using ui::StationAction;

constexpr std::size_t kProblemRows = 8;
constexpr std::ptrdiff_t kMostTrail = 4000;
constexpr std::int64_t kLook_us = 2'000'000;
constexpr int kStep_s = 5;
constexpr int kMostLookedAt = 20'000;  // files, when models are counted in a folder

const std::array<const char*, 3> kCurves{"soft", "normal", "firm"};
const std::array<const char*, 4> kTurns{"none", "right", "half", "left"};
const std::array<const char*, 2> kColours{"soft", "strong"};
struct IdleTime {
    const char* key;
    double least, most;
};
constexpr std::array<IdleTime, ui::kIdleTimeCount> kIdleTimes{{{"idle.ask_s", 10, 3600},
                                                               {"idle.countdown_s", 5, 120},
                                                               {"idle.empty_s", 5, 3600},
                                                               {"idle.ask_garment_s", 10, 3600}}};

double& idle_of(Config& config, std::size_t which) {
    const std::array<double*, ui::kIdleTimeCount> all{&config.idle.ask_s, &config.idle.countdown_s,
                                                      &config.idle.empty_s, &config.idle.ask_garment_s};
    return *all[which];
}

template <std::size_t N>
std::size_t place_in(const std::array<const char*, N>& names, const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::int64_t count_models(const fs::path& folder) {
    std::error_code error;
    std::int64_t models = 0;
    int looked = 0;
    for (auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
         !error && it != fs::recursive_directory_iterator() && looked < kMostLookedAt; it.increment(error), ++looked) {
        if (core::has_mesh_extension(it->path())) ++models;
    }
    return models;
}

/// "Today, 09:12" or the date as ISO 8601 has it, which every language reads.
std::string date_words(std::int64_t seconds, const ui::Strings& words) {
    const auto when = static_cast<std::time_t>(seconds), now = std::time(nullptr);
    std::tm then_tm{}, now_tm{};
    localtime_r(&when, &then_tm);
    localtime_r(&now, &now_tm);
    std::array<char, 32> text{};
    const bool today = then_tm.tm_year == now_tm.tm_year && then_tm.tm_yday == now_tm.tm_yday;
    std::strftime(text.data(), text.size(), today ? "%H:%M" : "%Y-%m-%d", &then_tm);
    return today ? ui::filled_in(words["today"], {{"t", text.data()}}) : std::string(text.data());
}

}  // namespace

OperatorDesk::OperatorDesk(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, Setup setup)
    : languages_(languages), setup_(std::move(setup)), screen_(fonts, languages) {}

void OperatorDesk::open() {
    list_.reset();
    message_ = Message::None;
    trail_.clear();
    pressure_ = scroll_ = 0;
    looked_us_ = 0;
    aligned_.reset();
    across_.reset();
    tilt_rad_.reset();
    leave();
}

void OperatorDesk::leave() {
    cancel_pointer();
    if (!std::exchange(aligning_, std::nullopt)) return;
    if (setup_.changed) setup_.changed(setup_.config);  // the alignment that was put aside
}

void OperatorDesk::cancel_pointer() {
    touch_.cancel();
    exit_since_us_.reset();
    scroll_grip_.reset();
    testing_ = false;
    last_point_.reset();
}

bool OperatorDesk::busy() const {
    return exit_since_us_.has_value() || (setup_.collection != nullptr && setup_.collection->status().importing);
}

void OperatorDesk::pointer(const ui::WindowEvent& event, const ui::StationState& state, ui::SizePx screen) {
    using Kind = ui::WindowEvent::Kind;
    if (event.pen) {
        report_times_us_.push_back(event.time_us);
        if (report_times_us_.size() > 200) report_times_us_.erase(report_times_us_.begin());
    }
    if (aligning_ && event.pen) return align_with(event, screen);
    if (event.kind == Kind::Zoom) {
        scroll_ = std::clamp(scroll_ - event.zoom * 400, 0.0, most_scroll_);
        return;
    }
    if (event.kind == Kind::Down) {
        const ui::StationPage page = build(state, screen);
        most_scroll_ = page.most_scroll;
        (void)touch_.press(page.targets, event.x, event.y);
        if (touch_.active()) {
            if (ui::station_action(touch_.pressed_item()) == StationAction::Exit) exit_since_us_ = event.time_us;
        } else if (page.test_area.contains(event.x, event.y)) {
            testing_ = true;
            last_point_.reset();
        } else {
            scroll_grip_ = event.y + scroll_;
        }
    } else if (event.kind == Kind::Up) {
        touch_.move(event.x, event.y);
        exit_since_us_.reset();
        const std::optional<ui::Intent> intent = touch_.release();
        testing_ = false;
        scroll_grip_.reset();
        if (intent && ui::station_action(intent->item) != StationAction::Exit) act(intent->item);
        return;
    } else if (event.kind != Kind::Move) {
        cancel_pointer();
        return;
    }
    touch_.move(event.x, event.y);
    if (!touch_.pressed()) exit_since_us_.reset();
    if (scroll_grip_) scroll_ = std::clamp(*scroll_grip_ - event.y, 0.0, most_scroll_);
    if (testing_) {
        pressure_ = event.pressure;
        tilt_rad_ = event.tilt_rad;
        across_ = core::Point{event.x / screen.width * 100, event.y / screen.height * 100};
        const double radius = ui::ink_radius_px(event.pressure, 9);
        const core::Point p{event.x, event.y}, from = last_point_.value_or(p);
        if (!last_point_) last_radius_ = radius;
        if (std::ssize(trail_) >= kMostTrail) trail_.erase(trail_.begin(), trail_.begin() + kMostTrail / 2);
        trail_.push_back({static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(p.x),
                          static_cast<float>(p.y), static_cast<float>(last_radius_), static_cast<float>(radius)});
        last_point_ = p;
        last_radius_ = radius;
    }
}

/// The pen goes by what the tablet says while the crosses are touched, so that an earlier alignment does no harm.
void OperatorDesk::begin_aligning() {
    aligned_.reset();
    aligning_ = Aligning{};
    Config plain = setup_.config;
    plain.tablet.align.clear();
    if (setup_.changed) setup_.changed(plain);
}

void OperatorDesk::align_with(const ui::WindowEvent& event, ui::SizePx screen) {
    using Kind = ui::WindowEvent::Kind;
    constexpr double kReach = 0.2;  // of the screen: what lies farther from the cross is for the button
    const core::Point p{event.x / screen.width, event.y / screen.height};
    const core::Point cross = cross_at(aligning_->hits.size());
    if (event.kind == Kind::Down) {
        aligning_->touch.clear();
        if (std::abs(p.x - cross.x) <= kReach && std::abs(p.y - cross.y) <= kReach) {
            aligning_->touch.push_back(p);
        } else {
            (void)touch_.press(build(state(0, event.time_us), screen).targets, event.x, event.y);
        }
    } else if (event.kind == Kind::Move) {
        touch_.move(event.x, event.y);
        if (!aligning_->touch.empty()) aligning_->touch.push_back(p);
    } else if (event.kind == Kind::Up) {
        if (const std::optional<ui::Intent> intent = touch_.release()) return act(intent->item);
        if (aligning_->touch.empty()) return;
        core::Point mean;
        for (const core::Point& q : aligning_->touch)
            mean = mean + q * (1.0 / static_cast<double>(aligning_->touch.size()));
        aligning_->touch.clear();
        aligning_->hits.push_back({cross, mean});
        if (aligning_->hits.size() == kCrossCount) finish_aligning(static_cast<double>(screen.width) / screen.height);
    } else {
        touch_.cancel();
    }
}

void OperatorDesk::finish_aligning(double aspect) {
    const AlignmentFit fit = fit_alignment(aligning_->hits, aspect);
    aligned_ = fit.fault;
    if (fit.fault != AlignmentFit::Fault::None) return leave();
    aligning_.reset();
    std::string numbers;
    for (const double v : fit.align) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%s%.6f", numbers.empty() ? "[" : ", ", v);
        numbers += text.data();
    }
    change("tablet.align", numbers + "]");
}

std::string OperatorDesk::align_words(const ui::Strings& words) const {
    if (!aligned_) return "";
    if (*aligned_ == AlignmentFit::Fault::None) return words["align_done"];
    return words[*aligned_ == AlignmentFit::Fault::Missed ? "align_failed" : "align_far_off"];
}

void OperatorDesk::update(std::int64_t now_us) {
    if (exit_since_us_ && now_us - *exit_since_us_ >= kHold_us) {
        exit_since_us_.reset();
        wish_ = Wish::Exit;
    }
    if (looked_us_ != 0 && now_us - looked_us_ < kLook_us) return;
    looked_us_ = std::max<std::int64_t>(now_us, 1);
    const CollectionStatus status = setup_.collection != nullptr ? setup_.collection->status() : CollectionStatus{};
    if (!status.importing) {
        import_began_.reset();
        per_minute_.reset();
    } else if (!import_began_) {
        import_began_ = Progress{now_us, status.done};
    } else if (now_us - import_began_->at_us >= kLook_us && status.done > import_began_->done) {
        per_minute_ = static_cast<double>(status.done - import_began_->done) * 60e6 /
                      static_cast<double>(now_us - import_began_->at_us);
    }
}

void OperatorDesk::act(std::size_t item) {
    const std::size_t index = ui::station_index(item);
    switch (ui::station_action(item)) {
        case StationAction::Close:
            wish_ = Wish::Close;
            break;
        case StationAction::Clean:
            wish_ = Wish::Clean;
            break;
        case StationAction::Restart:
            wish_ = Wish::Restart;
            break;
        case StationAction::Exit:
            break;  // held, not tapped
        case StationAction::Curve:
            change("tablet.pressure", kCurves[std::min<std::size_t>(index, 2)]);
            break;
        case StationAction::Add:
            show_folder(setup_.config.collection.add_from.empty() ? setup_.media
                                                                  : fs::path(setup_.config.collection.add_from));
            break;
        case StationAction::Update:
            if (setup_.collection != nullptr) setup_.collection->update();
            break;
        case StationAction::Stop:
            if (setup_.collection != nullptr) setup_.collection->stop();
            break;
        case StationAction::Problems:
            show_problems();
            break;
        case StationAction::FolderUp:
            if (folder_.has_parent_path()) show_folder(folder_.parent_path());
            break;
        case StationAction::Folder:
            if (first_folder_ + index < folders_.size()) show_folder(fs::path(folders_[first_folder_ + index]));
            break;
        case StationAction::AddThese:
            if (setup_.collection != nullptr) setup_.collection->add(folder_.string());
            list_.reset();
            break;
        case StationAction::LeaveList:
            list_.reset();
            break;
        case StationAction::Less:
            step(index, -1);
            break;
        case StationAction::More:
            step(index, 1);
            break;
        case StationAction::Language:
            if (index < languages_.size()) change("visitors.language", languages_[index].code());
            break;
        case StationAction::Hand:
            change("visitors.hand", index == 0 ? "left" : "right");
            break;
        case StationAction::Garment:
            change("visitors.garment", index == 0 ? "false" : "true");
            break;
        case StationAction::Shadow:
            change("visitors.shadow", index == 0 ? "false" : "true");
            break;
        case StationAction::Colours:
            change("visitors.part_colours", kColours[std::min<std::size_t>(index, 1)]);
            break;
        case StationAction::Turn:
            change("tablet.align", "[]");  // it was found the way the tablet lay before
            change("tablet.turn", kTurns[std::min<std::size_t>(index, 3)]);
            break;
        case StationAction::SelfTest:
            run_self_test();
            break;
        case StationAction::SaveReport:
            save_report();
            break;
        case StationAction::Align:
            begin_aligning();
            break;
        case StationAction::LeaveAlign:
            leave();
            break;
        case StationAction::Earlier:
            first_folder_ -= std::min(first_folder_, ui::kFolderRows);
            show_rows();
            break;
        case StationAction::Later:
            if (first_folder_ + ui::kFolderRows < folders_.size()) first_folder_ += ui::kFolderRows;
            show_rows();
            break;
    }
}

/// Takes effect at once; a file that cannot be written is said on the page, and the setting holds until the end.
void OperatorDesk::change(const std::string& key, const std::string& value) {
    if (!set_option(setup_.config, key + "=" + value)) return;
    if (setup_.changed) setup_.changed(setup_.config);
    if (setup_.config_file.empty()) return;
    if (const core::Result<void> saved = save_options(setup_.config_file, {{key, value}}); !saved) {
        message_ = Message::NotSaved;
        message_value_ = saved.error().sentence();
    }
}

void OperatorDesk::step(std::size_t which, int direction) {
    if (which >= kIdleTimes.size()) return;
    const IdleTime& time = kIdleTimes[which];
    const double next = std::clamp(idle_of(setup_.config, which) + direction * kStep_s, time.least, time.most);
    change(time.key, std::to_string(std::lround(next)));
}

void OperatorDesk::show_folder(const fs::path& folder) {
    std::error_code error;
    folder_ = fs::is_directory(folder, error) ? folder : fs::path("/");
    folders_.clear();
    for (auto it = fs::directory_iterator(folder_, fs::directory_options::skip_permission_denied, error);
         !error && it != fs::directory_iterator(); it.increment(error)) {
        std::error_code not_there;
        if (it->is_directory(not_there) && it->path().filename().string()[0] != '.') folders_.push_back(it->path());
    }
    std::sort(folders_.begin(), folders_.end());
    first_folder_ = 0;
    ui::StationState::List list;
    list.folders = true;
    list.title = folder_.string();
    list.all = folders_.size();
    list.model_files = folder_ == folder_.root_path() ? 0 : count_models(folder_);
    list_ = std::move(list);
    show_rows();
}

void OperatorDesk::show_rows() {
    if (!list_) return;
    list_->first = first_folder_;
    list_->rows.clear();
    for (std::size_t i = first_folder_; i < std::min(folders_.size(), first_folder_ + ui::kFolderRows); ++i) {
        list_->rows.push_back(folders_[i].filename().string());
    }
}

void OperatorDesk::show_problems() {
    ui::StationState::List list;
    if (setup_.collection != nullptr) {
        for (const std::string& problem : setup_.collection->status().problems) list.rows.push_back(problem);
    }
    list.rows.insert(list.rows.end(), facts_.problems.begin(), facts_.problems.end());
    list.title = std::to_string(list.rows.size());
    if (list.rows.size() > kProblemRows) list.rows.resize(kProblemRows);
    list_ = std::move(list);
}

void OperatorDesk::run_self_test() {
    int bad = 0;
    for (const Check& check : check_station(setup_.config, setup_.config_file)) bad += check.good ? 0 : 1;
    message_ = Message::Tested;
    message_value_ = std::to_string(bad);
}

std::string OperatorDesk::report_text() const {
    std::string text = "Croquis " CROQUIS_VERSION "\n";
    const auto line = [&text](const std::string& what, const std::string& value) {
        text += what + ": " + value + "\n";
    };
    const std::time_t now = std::time(nullptr);
    std::array<char, 40> date{};
    std::tm tm{};
    gmtime_r(&now, &tm);
    std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%SZ", &tm);
    line("date", date.data());
    line("place", setup_.config.station.place);
    line("running for s", std::to_string(facts_.running_s));
    line("worst frame ms", std::to_string(facts_.worst_frame_ms));
    line("renderer", facts_.renderer);
    line("memory MB", std::to_string(resident_mb()));
    line("file handles", std::to_string(open_handles()));
    for (const std::string& tablet : facts_.tablets) line("tablet", tablet);
    for (const std::string& problem : facts_.problems) line("problem", problem);
    if (setup_.collection != nullptr) {
        const CollectionStatus status = setup_.collection->status();
        line("models", std::to_string(status.models));
        line("search ms, median", std::to_string(status.median_search_ms));
        for (const std::string& problem : status.problems) line("problem", problem);
    }
    for (const Check& check : check_station(setup_.config, setup_.config_file)) {
        line(check.name,
             (check.good ? "fine, " : "look at, ") + check.found + (check.advice.empty() ? "" : "; " + check.advice));
    }
    return text;
}

void OperatorDesk::save_report() {
    fs::path folder = setup_.config.station.report_folder;
    if (folder.empty() && !setup_.config_file.empty()) folder = fs::absolute(setup_.config_file).parent_path();
    const char* home = std::getenv("HOME");
    if (folder.empty() && home != nullptr) folder = home;
    const std::time_t now = std::time(nullptr);
    std::array<char, 64> name{};
    std::tm tm{};
    localtime_r(&now, &tm);
    std::strftime(name.data(), name.size(), "croquis-report-%Y%m%d-%H%M%S.txt", &tm);
    const fs::path file = folder / name.data();
    std::ofstream out(file);
    out << report_text();
    out.flush();
    message_ = out ? Message::Saved : Message::NotSaved;
    message_value_ = file.string();
}

std::string OperatorDesk::ended_words(const CollectionStatus& status, const ui::Strings& words) const {
    if (!status.ended) return "";
    if (!status.ended->failure.empty()) return words["added_failed"] + " " + status.ended->failure;
    return ui::filled_in(words["added_done"], {{"a", ui::number_in(words, status.ended->added)},
                                               {"b", ui::number_in(words, status.ended->unchanged)},
                                               {"c", ui::number_in(words, status.ended->unreadable)}});
}

ui::StationState OperatorDesk::state(std::size_t language, std::int64_t now_us) const {
    ui::StationState s;
    const ui::Strings& words = languages_[language];
    Config config = setup_.config;
    s.language = language;
    s.place = config.station.place;
    s.tablet_there = !facts_.tablets.empty();
    if (s.tablet_there) s.tablet_name = facts_.tablets.front();
    if (report_times_us_.size() > 20 && now_us - report_times_us_.back() < 1'000'000) {
        const double span_s = static_cast<double>(report_times_us_.back() - report_times_us_.front()) / 1e6;
        if (span_s > 0) s.report_rate_hz = static_cast<double>(report_times_us_.size() - 1) / span_s;
    }
    s.pen_to_screen_ms = facts_.pen_to_screen_ms;
    s.pressure = pressure_;
    if (tilt_rad_) s.tilt_deg = std::round(*tilt_rad_ * 180 / std::numbers::pi);
    s.across = across_;
    s.trail = trail_;
    s.can_align = s.tablet_there;
    s.align_message = align_words(words);
    if (aligning_)
        s.align = ui::StationState::Align{aligning_->hits.size(), kCrossCount, cross_at(aligning_->hits.size())};
    s.curve = place_in(kCurves, config.tablet.pressure);
    s.turn = place_in(kTurns, config.tablet.turn);
    if (setup_.collection != nullptr) {
        const CollectionStatus status = setup_.collection->status();
        s.models = status.models;
        s.views = status.views;
        if (status.median_search_ms > 0) s.search_ms = status.median_search_ms;
        if (status.changed_s) s.changed = date_words(*status.changed_s, words);
        s.can_add = status.can_add;
        s.stale = status.state == CollectionState::Stale;
        s.importing = status.importing;
        s.done = status.done;
        s.total = status.total;
        s.minutes_left = status.minutes_left;
        s.unreadable = status.unreadable;
        s.per_minute = per_minute_;
        s.import_ended = ended_words(status, words);
    }
    s.open_list = list_;
    if (s.open_list && !s.open_list->folders && s.open_list->rows.empty()) s.open_list->title = words["problems_none"];
    for (std::size_t i = 0; i < ui::kIdleTimeCount; ++i)
        s.idle_s[i] = static_cast<int>(std::lround(idle_of(config, i)));
    for (std::size_t i = 0; i < languages_.size(); ++i) {
        if (languages_[i].code() == config.visitors.language) s.start_language = i;
    }
    s.start_left = config.visitors.hand == "left";
    s.garment = config.visitors.garment;
    s.shadow = config.visitors.shadow;
    s.colours = place_in(kColours, config.visitors.part_colours);
    s.running_s = facts_.running_s;
    s.worst_frame_ms = facts_.worst_frame_ms;
    if (s.tablet_there) s.pen_live = !facts_.pen_asleep;
    s.memory_mb = facts_.memory_mb;
    s.free_disk_gb = facts_.free_disk_gb;
    if (message_ == Message::Tested) {
        s.health_message =
            message_value_ == "0" ? words["all_well"] : ui::filled_in(words["not_well"], {{"n", message_value_}});
    } else if (message_ == Message::Saved) {
        s.health_message = ui::filled_in(words["report_saved"], {{"f", message_value_}});
    } else if (message_ == Message::NotSaved) {
        s.health_message = ui::filled_in(words["report_failed"], {{"f", message_value_}});
    }
    if (exit_since_us_) {
        s.exit_held =
            std::clamp(static_cast<double>(now_us - *exit_since_us_) / static_cast<double>(kHold_us), 0.0, 1.0);
    }
    s.scroll = std::round(scroll_);
    if (touch_.pressed() == ui::Control::Station) s.pressed = touch_.pressed_item();
    return s;
}

}  // namespace app
