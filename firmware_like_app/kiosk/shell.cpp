#include "firmware_like_app/kiosk/shell.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "firmware_like_app/kiosk/settings.hpp"

namespace app {
namespace {

constexpr std::int64_t kCornerHold_us = 3'000'000;
constexpr double kCorner_px = 120;  // of the design

ui::SizePx whole(const ui::Rect& rect) {
    return {std::max(1, static_cast<int>(rect.width)), std::max(1, static_cast<int>(rect.height))};
}

/// The desk's setup, which tells the shell and then whoever gave it of every change.
OperatorDesk::Setup station_setup(const ShellOptions& options, std::function<void(const Config&)> take) {
    OperatorDesk::Setup setup = options.station;
    setup.changed = [take = std::move(take), told = options.station.changed](const Config& config) {
        take(config);
        if (told) told(config);
    };
    return setup;
}

}  // namespace

core::Result<std::unique_ptr<Shell>> Shell::create(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages,
                                                   FindMode& find, Searcher* searcher, const ShellOptions& options,
                                                   ui::SizePx screen, std::int64_t now_us) {
    core::Result<ui::Painter> painter = ui::Painter::create(fonts);
    if (!painter) return core::unexpected(painter.error());
    core::Result<std::vector<NamedDrawing>> drawings = attract_drawings(options.attract_folder);
    if (!drawings) return core::unexpected(drawings.error());
    core::Result<std::unique_ptr<AttractPlayer>> attract = AttractPlayer::create(std::move(*drawings), searcher);
    if (!attract) return core::unexpected(attract.error());
    core::Result<DetailView> detail = DetailView::create(fonts, languages);
    if (!detail) return core::unexpected(detail.error());
    return std::unique_ptr<Shell>(new Shell(fonts, languages, find, options, screen, std::move(*painter),
                                            std::move(*attract), std::move(*detail), now_us));
}

Shell::Shell(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, FindMode& find,
             const ShellOptions& options, ui::SizePx screen, ui::Painter painter,
             std::unique_ptr<AttractPlayer> attract, DetailView detail, std::int64_t now_us)
    : languages_(languages),
      find_(find),
      options_(options),
      screen_(screen),
      station_(options.times, options.collection, now_us),
      painter_(std::move(painter)),
      attract_(std::move(attract)),
      detail_(std::move(detail)),
      attract_screen_(fonts, languages),
      notice_screen_(fonts, languages),
      still_screen_(fonts, languages),
      pin_screen_(fonts, languages),
      pin_lock_(options.pin),
      desk_(fonts, languages, station_setup(options, [this](const Config& config) { take_settings(config); })) {
    detail_.set_frames_are_seen(options.every_frame_seen);
    find_.offer_garment(garment_offered());
    go_on(now_us);
    entered(now_us);
}

void Shell::resize(ui::SizePx screen, std::int64_t now_us) {
    if (screen.width < 1 || screen.height < 1 || screen == screen_) return;
    screen_ = screen;
    find_.resize(screen);
    if (options_.garment != nullptr) options_.garment->resize(screen);
    touch_.cancel();
    if (detail_.is_open()) detail_.resize(screen, mode().hand(), painter_);
    if (scene_ == Scene::Attract) entered(now_us);
}

/// Follows the station after anything that may have changed its scene.
void Shell::go_on(std::int64_t now_us) {
    if (station_.wipes() != wipes_) {
        wipes_ = station_.wipes();
        find_.wipe(options_.language, options_.hand);
        if (options_.garment != nullptr) options_.garment->wipe(options_.language, options_.hand);
        in_garment_ = false;
        station_.set_garment(false);
    }
    if (!options_.attract && station_.scene() == Scene::Attract) station_.wake(now_us);
    note_board();
    if (station_.scene() != scene_) entered(now_us);
}

/// The scene is another one: what the last one needed goes, what this one needs comes.
void Shell::entered(std::int64_t now_us) {
    touch_.cancel();
    scene_ = station_.scene();
    if (scene_ == Scene::Attract) {
        const ui::AttractLayout layout = ui::attract_layout(screen_, languages_.size());
        attract_->start(whole(layout.stage), layout.scale.scale * 9, now_us);
    } else {
        attract_->stop(painter_);
    }
    if (scene_ != Scene::Work) mode().cancel_pointer(now_us);
    if (station_.behind() != Scene::Detail) detail_.close(painter_);
    detail_.cancel_pointer();
    pin_lock_.clear();
    if (scene_ == Scene::Operator) {
        desk_.open();
    } else {
        desk_.leave();
    }
}

/// What the operator sets holds from the next visitor on; times at once.
void Shell::take_settings(const Config& config) {
    options_.times = times_of(config);
    station_.set_times(options_.times);
    options_.hand = hand_of(config);
    options_.garment_offered = config.visitors.garment;
    find_.offer_garment(garment_offered());
    find_.show_shadow(config.visitors.shadow);
    if (part_palette_of(config) != ui::palette::chosen_parts()) {
        ui::palette::choose_parts(part_palette_of(config));
        find_.recolour();
        detail_.recolour();
    }
    for (std::size_t i = 0; i < languages_.size(); ++i) {
        if (languages_[i].code() == config.visitors.language) options_.language = i;
    }
}

void Shell::enter_digit(char digit, std::int64_t now_us) {
    if (pin_lock_.enter(digit, now_us)) station_.open_operator(now_us);
}

void Shell::take_wishes(std::int64_t now_us) {
    const std::optional<OperatorDesk::Wish> wish = desk_.take_wish();
    if (!wish) return;
    switch (*wish) {
        case OperatorDesk::Wish::Close:
            station_.close_operator(now_us);
            break;
        case OperatorDesk::Wish::Clean:
            station_.clean_screen(now_us);
            break;
        case OperatorDesk::Wish::Restart:
            restart_wanted_ = true;
            break;
        case OperatorDesk::Wish::Exit:
            exit_wanted_ = true;
            break;
    }
}

void Shell::open_detail(const FindMode::OpenedCard& card, std::int64_t now_us) {
    const std::shared_ptr<const PreparedAnswer> answer = find_.shared_answer();
    if (!answer) return;
    const std::vector<FoundModel>& best = answer->answer.best;
    const auto model = std::find_if(best.begin(), best.end(), [&](const FoundModel& m) { return m.id == card.model; });
    if (model == best.end()) return;  // a newer answer has come meanwhile, and its cards are about to
    detail_.offer_wear(garment_offered());
    detail_.open(answer, static_cast<std::size_t>(model - best.begin()), find_.sketch().drawing(), card.picture,
                 screen_, mode().hand(), now_us, painter_);
    station_.open_detail(now_us);
}

void Shell::note_board() {
    std::string key = ui::board_key(notice());
    if (station_.tablet_is_missed() && station_.collection() == CollectionState::Ready) key = "tablet_lost_board";
    find_.set_board_key(std::move(key));
}

ui::Notice Shell::notice() const {
    if (!station_.input_is_there()) return ui::Notice::NoInput;
    switch (station_.collection()) {
        case CollectionState::Building:
            return ui::Notice::Building;
        case CollectionState::Empty:
            return ui::Notice::NoModels;
        case CollectionState::Missing:
            return ui::Notice::CollectionMissing;
        case CollectionState::Damaged:
            return ui::Notice::CollectionDamaged;
        case CollectionState::Stale:
            return ui::Notice::CollectionStale;
        case CollectionState::Ready:
            break;
    }
    return station_.tablet_is_missed() ? ui::Notice::NoTablet : ui::Notice::None;
}

bool Shell::mode_has_input() const {
    return station_.scene() == Scene::Work;
}

/// Find has one size for its drawing.
bool Shell::mode_zooms() const {
    return mode_has_input() && in_garment_;
}

Mode& Shell::mode() const {
    if (in_garment_) return *options_.garment;
    return find_;
}

/// Each mode keeps its work; language and hand go along.
void Shell::open_garment(bool garment, std::int64_t now_us) {
    if (garment == in_garment_ || (garment && !garment_offered())) return;
    const std::size_t language = mode().language();
    const ui::Hand hand = mode().hand();
    mode().cancel_pointer(now_us);
    in_garment_ = garment;
    mode().set_language(language);
    mode().set_hand(hand);
    if (garment) options_.garment->prepare();
    station_.set_garment(garment);
    shown_.reset();
}

void Shell::follow_mode_wishes(std::int64_t now_us) {
    if (find_.take_garment_wish()) open_garment(true, now_us);
    if (options_.garment != nullptr && options_.garment->take_find_wish()) open_garment(false, now_us);
}

/// The board's outer corner, where nothing else can be touched for long.
ui::Rect Shell::corner() const {
    const double side = std::max(64.0, find_.layout().px(kCorner_px));
    const bool at_right = mode().hand() == ui::Hand::Left && find_.layout().sheet.y == 0;
    return {at_right ? screen_.width - side : 0.0, 0, side, side};
}

void Shell::watch_corner(const ui::WindowEvent& event) {
    using Kind = ui::WindowEvent::Kind;
    const bool inside = corner().contains(event.x, event.y);
    if (event.kind == Kind::Down && inside) corner_since_us_ = event.time_us;
    if (!tip_down_ || !inside) corner_since_us_.reset();
}

void Shell::pointer(const ui::WindowEvent& event) {
    using Kind = ui::WindowEvent::Kind;
    const bool ends = event.kind == Kind::Up || event.kind == Kind::Leave || event.kind == Kind::TakeBack;
    if (event.kind == Kind::Down) tip_down_ = true;
    if (ends) tip_down_ = false;
    if (event.kind == Kind::Move && !tip_down_) {
        if (event.pen) pen_near(true, event.time_us);
    } else {
        station_.touched(event.time_us);
    }
    watch_corner(event);
    if (swallow_) {
        swallow_ = !ends;
        return;
    }
    const Scene scene = station_.scene();
    if (event.kind == Kind::Zoom && scene != Scene::Detail && scene != Scene::Operator && !mode_zooms()) return;
    if (scene == Scene::Cleaning) return;
    if (mode_has_input()) {
        mode().pointer(event);
        if (const auto card = find_.take_opened_card()) open_detail(*card, event.time_us);
        follow_mode_wishes(event.time_us);
    } else if (station_.scene() == Scene::Detail) {
        if (const auto control = detail_.pointer(event, painter_)) act({*control, 0}, event.time_us);
    } else if (scene == Scene::Operator) {
        desk_.pointer(event, desk_.state(mode().language(), event.time_us), screen_);
        take_wishes(event.time_us);
    } else if (event.kind == Kind::Down) {
        press(event);
    } else if (event.kind == Kind::Move) {
        touch_.move(event.x, event.y);
    } else if (event.kind == Kind::Up) {
        release(event);
    } else {
        touch_.cancel();
    }
    go_on(event.time_us);
}

void Shell::press(const ui::WindowEvent& event) {
    if (const auto intent = touch_.press(targets(event.time_us), event.x, event.y)) act(*intent, event.time_us);
    if (touch_.active()) return;
    if (station_.scene() == Scene::Attract) {
        // the tip that wakes does not draw
        station_.wake(event.time_us);
        swallow_ = true;
    } else if (station_.scene() == Scene::StillThere) {
        // the stroke that answers is a stroke
        station_.keep_drawing(event.time_us);
        go_on(event.time_us);
        if (mode_has_input()) mode().pointer(event);
        if (station_.scene() == Scene::Detail) (void)detail_.pointer(event, painter_);
    }
}

void Shell::release(const ui::WindowEvent& event) {
    touch_.move(event.x, event.y);
    if (const auto intent = touch_.release()) act(*intent, event.time_us);
}

void Shell::act(const ui::Intent& intent, std::int64_t now_us) {
    switch (intent.control) {
        case ui::Control::Language:
            mode().set_language(intent.item);
            break;
        case ui::Control::HandSwitch:
            mode().set_hand(mode().hand() == ui::Hand::Right ? ui::Hand::Left : ui::Hand::Right);
            break;
        case ui::Control::StartDrawing:
            station_.leave_notice(now_us);
            if (notice() == ui::Notice::NoModels) open_garment(true, now_us);
            break;
        case ui::Control::KeepDrawing:
            station_.keep_drawing(now_us);
            break;
        case ui::Control::Wear:
            wear(now_us);
            break;
        case ui::Control::Digit:
            enter_digit(static_cast<char>('0' + intent.item), now_us);
            break;
        case ui::Control::EraseDigit:
            pin_lock_.erase();
            break;
        case ui::Control::Cancel:
            station_.leave_pin(now_us);
            break;
        case ui::Control::StartOver:
            station_.start_over(now_us);
            break;
        default:
            break;
    }
}

/// The result that is open goes on the figure, and the visitor with it.
void Shell::wear(std::int64_t now_us) {
    if (!garment_offered() || !detail_.is_open()) return;
    const FoundModel found = detail_.found();
    station_.keep_drawing(now_us);
    go_on(now_us);
    open_garment(true, now_us);
    options_.garment->wear(found, now_us);
}

void Shell::cancel_pointer(std::int64_t now_us) {
    corner_since_us_.reset();
    swallow_ = tip_down_ = false;
    cancel_touches(now_us);
}

/// What is pressed does nothing any more.
void Shell::cancel_touches(std::int64_t now_us) {
    touch_.cancel();
    mode().cancel_pointer(now_us);
    detail_.cancel_pointer();
    desk_.cancel_pointer();
}

void Shell::pen_near(bool moved, std::int64_t now_us) {
    station_.pen_near(moved, now_us);
    if (station_.wake(now_us)) go_on(now_us);
}

void Shell::open_sheet(std::int64_t now_us) {
    station_.leave_notice(now_us);
    station_.wake(now_us);
    go_on(now_us);
}

void Shell::set_collection(CollectionState state, const CollectionProgress& progress, std::int64_t now_us) {
    progress_ = progress;
    station_.set_collection(state, now_us);
    go_on(now_us);
}

void Shell::set_tablet(bool there, std::int64_t now_us) {
    station_.set_tablet(there, now_us);
    go_on(now_us);
}

void Shell::set_no_input(const std::string& code, std::int64_t now_us) {
    if (code == no_input_code_) return;
    no_input_code_ = code;
    station_.set_input(code.empty(), now_us);
    go_on(now_us);
}

void Shell::expect_tablet(std::int64_t now_us) {
    station_.expect_tablet(now_us);
    go_on(now_us);
}

void Shell::update(std::int64_t now_us) {
    if (tip_down_) station_.touched(now_us);
    station_.set_has_work(find_.has_work() || (options_.garment != nullptr && options_.garment->has_work()));
    if (corner_since_us_ && now_us - *corner_since_us_ >= kCornerHold_us) {
        corner_since_us_.reset();
        swallow_ = tip_down_;
        cancel_touches(now_us);
        station_.open_pin(now_us);
    }
    if (scene_ == Scene::Operator) {
        desk_.update(now_us);
        take_wishes(now_us);
        station_.set_busy(desk_.busy());
    }
    station_.tick(now_us);
    go_on(now_us);
    find_.update(now_us);
    if (options_.garment != nullptr) options_.garment->update(now_us);
    if (scene_ == Scene::Detail) detail_.update(now_us);
    if (scene_ == Scene::Attract) attract_->update(now_us, !options_.every_frame_seen, painter_);
}

void Shell::use_spare_time() {
    find_.use_spare_time();
    if (scene_ == Scene::Detail) detail_.use_spare_time(painter_);
}

int Shell::update_ink() {
    if (scene_ == Scene::Detail) detail_.draw_model(painter_);
    return scene_ == Scene::Attract ? attract_->update_ink() : mode().update_ink();
}

ui::AttractState Shell::attract_state(std::int64_t now_us) const {
    ui::AttractState state;
    state.language = mode().language();
    if (touch_.pressed() == ui::Control::Language) state.pressed_language = touch_.pressed_item();
    attract_->fill(state, now_us);
    return state;
}

ui::NoticeState Shell::notice_state() const {
    ui::NoticeState state;
    state.notice = notice();
    state.garment = garment_offered();
    state.language = mode().language();
    state.pressed = touch_.pressed();
    state.pressed_item = touch_.pressed_item();
    state.code = no_input_code_;
    state.done = progress_.done;
    state.total = progress_.total;
    state.minutes_left = progress_.minutes_left;
    return state;
}

ui::PinState Shell::pin_state(std::int64_t now_us) const {
    ui::PinState state;
    state.language = mode().language();
    state.length = pin_lock_.length();
    state.entered = pin_lock_.entered();
    state.wrong = pin_lock_.was_wrong();
    state.wait_s = pin_lock_.wait_s(now_us);
    state.pressed = touch_.pressed();
    state.pressed_item = touch_.pressed_item();
    return state;
}

ui::StillThereState Shell::still_there_state(std::int64_t now_us) const {
    ui::StillThereState state;
    state.language = mode().language();
    state.pressed = touch_.pressed();
    const std::int64_t left_us = station_.left_us(now_us);
    state.seconds = static_cast<int>((left_us + 999'999) / 1'000'000);
    // the ring moves by its width, not by every frame
    const double share = static_cast<double>(left_us) /
                         static_cast<double>(std::max<std::int64_t>(
                             1, scene_ == Scene::Cleaning ? station_.times().cleaning : station_.times().countdown));
    state.share = std::round(share * 240) / 240;
    return state;
}

std::vector<ui::BoardTouch::Target> Shell::targets(std::int64_t now_us) const {
    switch (station_.scene()) {
        case Scene::Attract:
            return attract_screen_.targets(screen_);
        case Scene::Notice:
            return notice_screen_.targets(notice_state(), find_.layout());
        case Scene::StillThere:
            return still_screen_.targets(still_there_state(now_us), screen_);
        case Scene::Pin:
            return pin_screen_.targets(pin_state(now_us), screen_);
        default:
            return {};
    }
}

Shell::Shown Shell::shown_at(std::int64_t now_us) const {
    Shown shown{scene_, screen_, mode().hand(), std::monostate{}};
    if (scene_ == Scene::Attract) shown.state = attract_state(now_us);
    if (scene_ == Scene::Notice) shown.state = notice_state();
    if (scene_ == Scene::Detail) shown.state = detail_.state(mode().language(), now_us);
    if (scene_ == Scene::Pin) shown.state = pin_state(now_us);
    if (scene_ == Scene::Operator) shown.state = desk_.state(mode().language(), now_us);
    if (scene_ == Scene::StillThere || scene_ == Scene::Cleaning) shown.state = still_there_state(now_us);
    return shown;
}

bool Shell::changed(std::int64_t now_us) const {
    if (!shown_ || !(shown_at(now_us) == *shown_)) return true;
    return mode_has_input() && mode().changed(now_us);
}

/// A frame of the shell's own, or what changed in it.
void Shell::draw_own(ui::DrawList list, bool flip, bool kept) {
    if (!kept || drawn_ != Drawn::Own) painter_.forget_frame();
    drawn_ = Drawn::Own;
    painter_.paint_changes(std::move(list), screen_, flip);
}

/// What changed in the sheet of Find; any other mode whole, and what lies over it.
void Shell::draw_mode(std::int64_t now_us, bool flip, bool kept, const ui::DrawList& over) {
    if (&mode() != &find_) {
        drawn_ = Drawn::Nothing;
        mode().draw(now_us, flip);
        if (!over.commands.empty()) painter_.paint(over, screen_, flip);
        return;
    }
    if (!kept || drawn_ != Drawn::Find) find_.forget_frame();
    drawn_ = Drawn::Find;
    find_.draw_changes(now_us, flip, over);
}

void Shell::draw_still_there(const ui::StillThereState& state, std::int64_t now_us, bool flip, bool kept) {
    const ui::DrawList over = still_screen_.draw(state, screen_);
    if (station_.behind() != Scene::Detail) return draw_mode(now_us, flip, kept, over);
    ui::DrawList list = detail_.draw(detail_.state(mode().language(), now_us));
    list.commands.insert(list.commands.end(), over.commands.begin(), over.commands.end());
    draw_own(std::move(list), flip, kept);
}

void Shell::draw(std::int64_t now_us, bool flip, bool kept) {
    shown_ = shown_at(now_us);
    const SceneState& state = shown_->state;
    switch (scene_) {
        case Scene::Attract:
            attract_->tell_changes(painter_);
            draw_own(attract_screen_.draw(std::get<ui::AttractState>(state), screen_), flip, kept);
            break;
        case Scene::Notice:
            draw_own(notice_screen_.draw(std::get<ui::NoticeState>(state), find_.layout()), flip, kept);
            break;
        case Scene::StillThere:
            draw_still_there(std::get<ui::StillThereState>(state), now_us, flip, kept);
            break;
        case Scene::Pin:
            draw_own(pin_screen_.draw(std::get<ui::PinState>(state), screen_), flip, kept);
            break;
        case Scene::Operator:
            draw_own(desk_.build(std::get<ui::StationState>(state), screen_).list, flip, kept);
            break;
        case Scene::Cleaning: {
            const auto& left = std::get<ui::StillThereState>(state);
            draw_own(pin_screen_.draw_cleaning(left.language, left.share, left.seconds, screen_), flip, kept);
            break;
        }
        case Scene::Detail:
            draw_own(detail_.draw(std::get<ui::DetailState>(state)), flip, kept);
            break;
        default:
            draw_mode(now_us, flip, kept);
            break;
    }
}

}  // namespace app
