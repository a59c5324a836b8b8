#include "firmware_like_app/kiosk/find_mode.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "firmware_like_app/kiosk/placing.hpp"
#include "ui/draw/coverage.hpp"

namespace app {
namespace {

constexpr ui::PictureId kInkPicture{1};
constexpr int kFirstWash = 10;
constexpr std::int64_t kWashRest_us = 700'000, kWashIn_us = 240'000, kWashStagger_us = 30'000, kWashOut_us = 80'000;
constexpr std::int64_t kClearedOffer_us = 8'000'000;
constexpr double kReplayMargin = 0.12;  // of the sheet's smaller side
constexpr double kFineWidth = 0.5;      // of the normal line
constexpr double kFrozenReach_px = 200;
constexpr double kEraserReach_px = 12;  // of the design: half the ring

ui::PictureId wash_id(std::size_t part) {
    return ui::PictureId{kFirstWash + static_cast<int>(part)};
}

/// From the sheet to the screen.
void move_by(std::vector<ui::InkPiece>& pieces, const ui::Rect& sheet) {
    const auto x = static_cast<float>(sheet.x), y = static_cast<float>(sheet.y);
    for (ui::InkPiece& piece : pieces) {
        piece.x0 += x;
        piece.x1 += x;
        piece.y0 += y;
        piece.y1 += y;
    }
}

ui::SizePx sheet_size(const ui::FindLayout& layout) {
    return {std::max(1, static_cast<int>(layout.sheet.width)), std::max(1, static_cast<int>(layout.sheet.height))};
}

}  // namespace

core::Result<std::unique_ptr<FindMode>> FindMode::create(const ui::FontSet& fonts,
                                                         const std::vector<ui::Strings>& languages, Searcher* searcher,
                                                         const FindOptions& options, ui::SizePx screen) {
    core::Result<ui::Painter> painter = ui::Painter::create(fonts);
    if (!painter) return core::unexpected(painter.error());
    core::Result<ui::InkLayer> ink = ui::InkLayer::create({1, 1});
    if (!ink) return core::unexpected(ink.error());
    core::Result<CardPictures> pictures = CardPictures::create();
    if (!pictures) return core::unexpected(pictures.error());
    return std::unique_ptr<FindMode>(new FindMode(fonts, languages, searcher, options, screen, std::move(*painter),
                                                  std::move(*ink), std::move(*pictures)));
}

FindMode::FindMode(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, Searcher* searcher,
                   const FindOptions& options, ui::SizePx screen, ui::Painter painter, ui::InkLayer ink,
                   CardPictures pictures)
    : fonts_(fonts),
      languages_(languages),
      options_(options),
      layout_(ui::find_layout(screen, options.hand)),
      screen_(fonts, languages),
      painter_(std::move(painter)),
      ink_layer_(std::move(ink)),
      pictures_(std::move(pictures)),
      shadow_(options.every_frame_seen) {
    if (searcher != nullptr) worker_ = std::make_unique<SearchWorker>(*searcher);
    if (searcher != nullptr && options.every_frame_seen) card_worker_ = std::make_unique<CardWorker>();
    ink_layer_.resize(sheet_size(layout_));
    painter_.set_picture(kInkPicture, &ink_layer_.texture());
    start_over_frame();
}

void FindMode::start_over_frame() {
    frame_ = {layout_.scale, 0, 0};
}

void FindMode::resize(ui::SizePx screen) {
    if (screen.width < 1 || screen.height < 1 || screen == layout_.screen) return;
    relayout(screen, options_.hand);
}

void FindMode::relayout(ui::SizePx screen, ui::Hand hand) {
    const ui::FindLayout before = layout_;
    options_.hand = hand;
    layout_ = ui::find_layout(screen, hand);
    const double ratio = std::min(layout_.sheet.width / before.sheet.width, layout_.sheet.height / before.sheet.height);
    frame_.offset_x = (frame_.offset_x - before.sheet.width / 2) * ratio + layout_.sheet.width / 2;
    frame_.offset_y = (frame_.offset_y - before.sheet.height / 2) * ratio + layout_.sheet.height / 2;
    frame_.scale *= ratio;
    if (sketch_.empty()) start_over_frame();
    ink_layer_.resize(sheet_size(layout_));
    painter_.set_picture(kInkPicture, &ink_layer_.texture());
    if (screen == before.screen) return;  // only the hand changed: cards and wash keep their size
    pictures_.reset(painter_);
    if (answer_) show_answer();
    make_wash();
}

core::PenSample FindMode::sample_of(const ui::WindowEvent& event) const {
    const core::Point p = frame_.from_px({event.x - layout_.sheet.x, event.y - layout_.sheet.y});
    return {event.time_us - drawing_start_us_.value_or(event.time_us), p.x, p.y, event.pressure};
}

void FindMode::pointer(const ui::WindowEvent& event) {
    using Kind = ui::WindowEvent::Kind;
    if (event.button && !event.pen) return;  // the mouse's other button turns what can be turned; ink cannot
    const bool on_sheet = layout_.sheet.contains(event.x, event.y);
    pointer_px_ = core::Point{event.x, event.y};
    eraser_near_ = event.pen && event.eraser && event.kind != Kind::Leave;
    if (event.kind == Kind::Down) {
        touch(event, on_sheet);
    } else if (event.kind == Kind::Move) {
        touch_.move(event.x, event.y);
        draw_or_erase(event);
    } else if (event.kind == Kind::Up) {
        draw_or_erase(event);
        if (pen_ == Pen::Drawing) end_stroke(event.time_us);
        if (pen_ == Pen::Erasing) end_erasing(event.time_us);
        touch_.move(event.x, event.y);
        if (const auto intent = touch_.release()) act(*intent, event.time_us);
        if (event.finger) pointer_px_.reset();
    } else if (event.kind == Kind::TakeBack) {
        take_back(event.time_us);
    } else if (event.kind == Kind::Leave) {
        pointer_px_.reset();
    }
    pen_hovers_ = event.pen && pen_ == Pen::Up && pointer_px_.has_value();
    if (pen_ != Pen::Drawing) ahead_.reset();
}

void FindMode::touch(const ui::WindowEvent& event, bool on_sheet) {
    if (!on_sheet) {
        if (const auto intent = touch_.press(targets(event.time_us), event.x, event.y)) act(*intent, event.time_us);
    } else if (event.eraser || tool_ == ui::Tool::Eraser) {
        pen_ = Pen::Erasing;
        erase(event);
    } else {
        if (sketch_.empty() && !sketch_.can_undo()) drawing_start_us_ = event.time_us;
        begin_stroke(sample_of(event), event.time_us);
    }
}

void FindMode::draw_or_erase(const ui::WindowEvent& event) {
    if (pen_ == Pen::Drawing) extend_stroke(sample_of(event));
    if (pen_ == Pen::Erasing) erase(event);
}

void FindMode::look_ahead(const std::optional<ui::WindowEvent>& predicted) {
    ahead_.reset();
    if (predicted && sketch_.open()) ahead_ = sample_of(*predicted);
}

void FindMode::cancel_pointer(std::int64_t now_us) {
    touch_.cancel();
    pointer_px_.reset();
    ahead_.reset();
    pen_hovers_ = eraser_near_ = false;
    if (pen_ == Pen::Drawing) end_stroke(now_us);
    if (pen_ == Pen::Erasing) end_erasing(now_us);
}

void FindMode::end_erasing(std::int64_t now_us) {
    pen_ = Pen::Up;
    sketch_.end_erasing();
    sheet_changed(now_us);
}

void FindMode::take_back(std::int64_t now_us) {
    touch_.cancel();
    pointer_px_.reset();
    if (pen_ == Pen::Up) return;
    pen_ = Pen::Up;
    sketch_.take_back();
    sheet_changed(now_us);
}

void FindMode::erase(const ui::WindowEvent& event) {
    const core::Point p = frame_.from_px({event.x - layout_.sheet.x, event.y - layout_.sheet.y});
    if (sketch_.erase_at(p, layout_.px(kEraserReach_px) / frame_.scale)) sheet_changed(event.time_us);
}

void FindMode::begin_stroke(const core::PenSample& sample, std::int64_t now_us) {
    pen_ = Pen::Drawing;
    pen_down_us_ = now_us;
    cleared_ = false;
    wash_settled_ = false;
    if (wash_since_us_ && !wash_out_us_) wash_out_us_ = now_us;
    sketch_.begin(sample, fine_pen_ ? kFineWidth : 1.0);
}

void FindMode::extend_stroke(const core::PenSample& sample) {
    if (sketch_.open()) sketch_.extend(sample);
}

void FindMode::end_stroke(std::int64_t now_us) {
    pen_ = Pen::Up;
    pen_up_us_ = now_us;
    sketch_.end();
    sheet_changed(now_us);
}

void FindMode::start_sheet_for(const core::Drawing& drawing) {
    sketch_.forget();
    pen_ = Pen::Up;
    drop_results();
    frame_ = fit_drawing(drawing, layout_.sheet.width, layout_.sheet.height, kReplayMargin);
}

void FindMode::set_hand(ui::Hand hand) {
    if (hand != options_.hand) relayout(layout_.screen, hand);
}

void FindMode::wipe(std::size_t language, ui::Hand hand) {
    touch_.cancel();
    pen_ = Pen::Up;
    pen_hovers_ = eraser_near_ = false;
    ahead_.reset();
    pointer_px_.reset();
    drawing_start_us_.reset();
    cleared_ = false;
    opened_card_.reset();
    garment_wanted_ = false;
    tool_ = ui::Tool::Pen;
    fine_pen_ = false;
    sketch_.forget();
    drop_results();
    pictures_.reset(painter_);
    rail_.settle();
    search_failure_.clear();
    options_.language = language;
    set_hand(hand);
    start_over_frame();
}

void FindMode::act(const ui::Intent& intent, std::int64_t now_us) {
    switch (intent.control) {
        case ui::Control::Pen:
            if (tool_ == ui::Tool::Pen) fine_pen_ = !fine_pen_;  // the pen again: its other width
            tool_ = ui::Tool::Pen;
            break;
        case ui::Control::Eraser:
            tool_ = ui::Tool::Eraser;
            break;
        case ui::Control::UndoClear:
        case ui::Control::Undo:
            sketch_.undo();
            cleared_ = false;
            sheet_changed(now_us);
            break;
        case ui::Control::Redo:
            sketch_.redo();
            sheet_changed(now_us);
            break;
        case ui::Control::New:
            sketch_.clear();
            tool_ = ui::Tool::Pen;
            cleared_ = true;
            cleared_us_ = now_us;
            sheet_changed(now_us);
            break;
        case ui::Control::Language:
            options_.language = intent.item;
            break;
        case ui::Control::Mode:
            garment_wanted_ = intent.item == 1;
            break;
        case ui::Control::HandSwitch:
            relayout(layout_.screen, options_.hand == ui::Hand::Right ? ui::Hand::Left : ui::Hand::Right);
            break;
        case ui::Control::Card:
            if (const std::optional<ui::CardFace> face = rail_.slots(now_us)[intent.item].now) {
                opened_card_ = OpenedCard{face->model, layout_.card_pictures[intent.item]};
            }
            break;
        default:
            break;  // of other screens
    }
}

void FindMode::sheet_changed(std::int64_t now_us) {
    pen_up_us_ = now_us;
    if (sketch_.empty()) {
        drop_results();
    } else {
        submit();
    }
}

void FindMode::submit() {
    if (!worker_) return;
    submitted_revision_ = sketch_.revision();
    last_ticket_ = worker_->submit(sketch_.drawing(), sketch_.open());
    last_ticket_revision_ = submitted_revision_;
}

void FindMode::drop_results() {
    oldest_ticket_ = last_ticket_ + 1;
    if (worker_) worker_->forget();
    if (card_worker_) card_worker_->forget();
    ranking_.reset();
    answer_.reset();
    shadow_.clear(painter_);
    order_.clear();
    rail_.set({});
    drop_wash();
    wash_since_us_.reset();
    wash_out_us_.reset();
    wash_settled_ = false;
    submitted_revision_ = sketch_.revision();
}

void FindMode::accept(PreparedAnswer answer) {
    if (answer.ticket < oldest_ticket_) return;
    if (!answer.failure.empty()) search_failure_ = answer.failure;
    ui::CalmOrder::Models models;
    for (const FoundModel& model : answer.answer.best) models.push_back(model.id);
    order_.see(models);
    ranking_ = std::make_shared<const PreparedAnswer>(std::move(answer));
    if (options_.shadow) shadow_.see(ranking_, extent_of(sketch_.drawing()));
}

/// The models in the order of the cards, as the newest answer has them; one that it has no more as the cards have it.
PreparedAnswer FindMode::arranged(const ui::CalmOrder::Models& models) const {
    PreparedAnswer out;
    out.ticket = ranking_->ticket;
    out.answer.message_key = ranking_->answer.message_key;
    for (const std::int64_t id : models) {
        for (const PreparedAnswer* from : {ranking_.get(), answer_.get()}) {
            if (from == nullptr) continue;
            const std::vector<FoundModel>& best = from->answer.best;
            const auto found = std::find_if(best.begin(), best.end(), [&](const FoundModel& m) { return m.id == id; });
            if (found == best.end()) continue;
            out.answer.best.push_back(*found);
            break;
        }
    }
    return out;
}

/// Cards near the pen do not change under it.
ui::CalmOrder::Frozen FindMode::frozen_cards() const {
    ui::CalmOrder::Frozen frozen{};
    if (!pointer_px_) return frozen;
    const double reach = layout_.px(kFrozenReach_px);
    for (std::size_t i = 0; i < frozen.size(); ++i) {
        const ui::Rect& r = layout_.cards[i];
        const double dx = std::max({r.x - pointer_px_->x, 0.0, pointer_px_->x - r.right()});
        const double dy = std::max({r.y - pointer_px_->y, 0.0, pointer_px_->y - r.bottom()});
        frozen[i] = dx * dx + dy * dy < reach * reach;
    }
    return frozen;
}

/// Brings the newest ranking to the cards when that is due and nothing else is on the way there.
void FindMode::change_cards(std::int64_t now_us) {
    if (!card_worker_) return;
    if (auto ready = card_worker_->take(); ready && ready->ticket >= oldest_ticket_) {
        answer_ = std::make_shared<const PreparedAnswer>(std::move(*ready));
        show_answer();
    }
    const bool on_the_way = card_worker_->busy() || pictures_.busy() || !rail_.ready(now_us);
    if (on_the_way || !ranking_ || ranking_->ticket == shown_ranking_) return;
    const bool resting = pen_ == Pen::Up && ranking_->ticket == last_ticket_;
    if (!order_.change_due() && !resting && answer_) return;
    const ui::CalmOrder::Frozen frozen = frozen_cards();
    shown_ranking_ = ranking_->ticket;
    card_worker_->start(arranged(resting ? order_.settle(frozen) : order_.rearrange(frozen)));
}

void FindMode::recolour() {
    if (!answer_ || !ranking_) return;
    if (card_worker_) {
        shown_ranking_ = 0;  // change_cards brings it once more
        return;
    }
    auto plain = std::make_shared<PreparedAnswer>(*answer_);
    plain->cards.clear();
    answer_ = std::move(plain);
    show_answer();
}

void FindMode::show_answer() {
    answer_is_shown_ = false;
    if (options_.every_frame_seen) make_answer_visible();
}

void FindMode::make_answer_visible() {
    if (answer_is_shown_ || !answer_) return;
    answer_is_shown_ = true;
    if (answer_->cards.empty() && !answer_->answer.best.empty()) {
        auto with_cards = std::make_shared<PreparedAnswer>(*answer_);
        with_cards->cards = preparer_.prepare(with_cards->answer);
        answer_ = std::move(with_cards);
    }
    pictures_.start(answer_, fonts_, layout_);
    make_wash();
}

void FindMode::drop_wash() {
    for (std::size_t i = 0; i < wash_.size(); ++i) painter_.set_picture(wash_id(i), nullptr);
    wash_.clear();
}

void FindMode::make_wash() {
    drop_wash();
    if (!answer_ || answer_->answer.best.empty()) return;
    std::vector<const FoundPart*> parts;
    for (const FoundPart& part : answer_->answer.best[0].parts) {
        if (part.colour >= 0 && part.colour < ui::palette::kPartCount) parts.push_back(&part);
    }
    std::stable_sort(parts.begin(), parts.end(), [](const auto* a, const auto* b) { return a->colour < b->colour; });
    const ui::SizePx size = sheet_size(layout_);
    for (const FoundPart* part : parts) {
        core::Polygon ring;
        for (const core::Point& p : part->on_drawing) ring.push_back(frame_.to_px(p));
        const ui::CoverageImage fill = ui::fill_polygon(ring, size.width, size.height);
        if (fill.coverage.pixels.empty()) continue;
        ui::Texture texture({fill.coverage.width, fill.coverage.height}, ui::PixelFormat::Coverage);
        texture.upload(0, 0, texture.size(), fill.coverage.pixels);
        const ui::Rect place{static_cast<double>(fill.x), static_cast<double>(fill.y),
                             static_cast<double>(fill.coverage.width), static_cast<double>(fill.coverage.height)};
        wash_.push_back({std::move(texture), place, part->colour});
    }
    for (std::size_t i = 0; i < wash_.size(); ++i) painter_.set_picture(wash_id(i), &wash_[i].coverage);
}

bool FindMode::wash_is_current() const {
    return answer_ && answer_->ticket == last_ticket_ && last_ticket_revision_ == sketch_.revision();
}

void FindMode::search_news() {
    if (!worker_ || !options_.search_while_drawing || pen_ != Pen::Drawing || sketch_.empty()) return;
    if (sketch_.revision() != submitted_revision_) submit();
}

void FindMode::update(std::int64_t now_us) {
    if (cleared_ && now_us - cleared_us_ > kClearedOffer_us) cleared_ = false;
    search_news();
    if (worker_) {
        if (auto answer = worker_->take()) accept(std::move(*answer));
    }
    const bool last = pen_ == Pen::Up && ranking_ && ranking_->ticket == last_ticket_;
    shadow_.update(now_us, last, painter_);
    change_cards(now_us);
    if (!options_.spare_time) use_spare_time();
    if (auto faces = pictures_.take_finished()) rail_.set(std::move(*faces));
    rail_.update(now_us, frozen_cards());
    pictures_.keep_only_shown(rail_, painter_);

    if (wash_out_us_ && now_us - *wash_out_us_ >= kWashOut_us) {
        wash_out_us_.reset();
        wash_since_us_.reset();
    }
    const bool resting = pen_ == Pen::Up && now_us - pen_up_us_ >= kWashRest_us;
    if (resting && !wash_since_us_ && wash_is_current() && !wash_.empty()) wash_since_us_ = now_us;
}

void FindMode::use_spare_time() {
    pictures_.paint(1, painter_);
}

void FindMode::search_and_wait() {
    if (!worker_ || sketch_.empty()) return;
    if (submitted_revision_ != sketch_.revision() || last_ticket_ < oldest_ticket_) submit();
    if (!ranking_ || ranking_->ticket < last_ticket_) {
        if (auto answer = worker_->wait_for(last_ticket_)) accept(std::move(*answer));
    }
    if (!ranking_ || (answer_ && answer_->ticket >= last_ticket_ && order_.settled())) return;
    if (pictures_.busy()) pictures_.reset(painter_);
    shown_ranking_ = ranking_->ticket;
    answer_ = std::make_shared<const PreparedAnswer>(arranged(order_.settle()));
    show_answer();
}

void FindMode::settle(bool resting) {
    make_answer_visible();
    shadow_.settle(painter_);
    pictures_.paint(static_cast<int>(ui::kCardCount), painter_);
    if (auto faces = pictures_.take_finished()) rail_.set(std::move(*faces));
    rail_.settle();
    pictures_.keep_only_shown(rail_, painter_);
    wash_settled_ = resting && wash_is_current();
    wash_out_us_.reset();
    if (!wash_settled_) wash_since_us_.reset();
}

double FindMode::wash_opacity(std::size_t part, std::int64_t now_us) const {
    if (wash_settled_) return 1;
    if (!wash_since_us_) return 0;
    const std::int64_t age_us = now_us - *wash_since_us_ - kWashStagger_us * static_cast<std::int64_t>(part);
    const double in = std::clamp(static_cast<double>(age_us) / static_cast<double>(kWashIn_us), 0.0, 1.0);
    if (!wash_out_us_) return in;
    const double out = static_cast<double>(now_us - *wash_out_us_) / static_cast<double>(kWashOut_us);
    return in * std::clamp(1 - out, 0.0, 1.0);
}

ui::InkLayer::Ink FindMode::ink() const {
    return {sketch_.drawing().strokes, sketch_.open(), sketch_.epoch(), frame_, layout_.ink_width_px, sketch_.widths()};
}

int FindMode::update_ink() {
    return ink_layer_.update(ink());
}

std::vector<ui::InkPiece> FindMode::ahead_ink() const {
    std::vector<ui::InkPiece> pieces;
    if (!ahead_ || !sketch_.open()) return pieces;
    const std::vector<core::PenSample>& samples = sketch_.drawing().strokes.back().samples;
    std::vector<core::PenSample> end(samples.end() - std::min<std::ptrdiff_t>(2, std::ssize(samples)), samples.end());
    end.push_back(*ahead_);
    ui::append_ink_span(end, end.size() - 2, frame_, ink().width_of(sketch_.widths().size() - 1), pieces);
    move_by(pieces, layout_.sheet);
    return pieces;
}

ui::FindState FindMode::state(std::int64_t now_us) const {
    ui::FindState s;
    const ui::Strings& words = languages_[options_.language];
    s.language = options_.language;
    s.modes = garment_offered_;
    s.tool = eraser_near_ || pen_ == Pen::Erasing ? ui::Tool::Eraser : tool_;
    s.fine_pen = fine_pen_;
    s.can_undo = sketch_.can_undo();
    s.can_redo = sketch_.can_redo();
    s.sheet_empty = sketch_.empty();
    s.sheet_cleared = cleared_ && sketch_.empty();
    const bool nothing = !answer_ || answer_->answer.message_key.empty();
    s.board_message = words[nothing ? options_.board_key : answer_->answer.message_key];
    s.cards = rail_.slots(now_us);
    if (options_.shadow) s.shadows = shadow_.shown(now_us, frame_, layout_.sheet);
    for (std::size_t i = 0; i < wash_.size(); ++i) {
        const ui::Rect& r = wash_[i].in_sheet;
        s.wash.push_back({wash_id(i),
                          {r.x + layout_.sheet.x, r.y + layout_.sheet.y, r.width, r.height},
                          wash_[i].colour,
                          wash_opacity(i, now_us)});
    }
    s.ink = kInkPicture;
    s.inked = ink_layer_.inked();
    s.ink_revision = sketch_.revision();
    s.wet_ink = ui::InkLayer::wet_end(ink());
    move_by(s.wet_ink, layout_.sheet);
    s.ahead_ink = ahead_ink();
    if (s.tool == ui::Tool::Eraser && pointer_px_ && layout_.sheet.contains(pointer_px_->x, pointer_px_->y)) {
        s.eraser_px = pointer_px_;
    } else if (pen_hovers_) {
        s.pen_px = pointer_px_;
    }
    s.pressed = touch_.pressed();
    s.pressed_item = touch_.pressed_item();
    return s;
}

std::vector<ui::BoardTouch::Target> FindMode::targets(std::int64_t now_us) const {
    return screen_.targets(state(now_us), layout_);
}

FindMode::Shown FindMode::shown_at(std::int64_t now_us) const {
    return {state(now_us), layout_.screen, options_.hand, answer_ ? answer_->ticket : 0};
}

bool FindMode::changed(std::int64_t now_us) const {
    return !shown_ || !(shown_at(now_us) == *shown_);
}

void FindMode::draw(std::int64_t now_us, bool flip) {
    painter_.forget_frame();
    draw_changes(now_us, flip);
}

void FindMode::draw_changes(std::int64_t now_us, bool flip, const ui::DrawList& over) {
    shown_ = shown_at(now_us);
    painter_.picture_changed(kInkPicture, ink_layer_.take_changed());
    ui::DrawList list = screen_.draw(shown_->state, layout_);
    list.commands.insert(list.commands.end(), over.commands.begin(), over.commands.end());
    painter_.paint_changes(std::move(list), layout_.screen, flip);
}

}  // namespace app
