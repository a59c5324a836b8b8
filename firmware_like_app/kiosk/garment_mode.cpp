#include "firmware_like_app/kiosk/garment_mode.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "firmware_like_app/garment/design_sources.hpp"
#include "firmware_like_app/kiosk/drawing_recorder.hpp"
#include "ui/screens/widgets.hpp"

namespace app {
namespace {

constexpr std::int64_t kClearedOffer_us = 8'000'000;

core::Result<core::GarmentDesk> empty_desk(const std::string& size, const core::FormSource& bodies) {
    core::Design design;
    const core::Result<core::BodyMeasures> measures = core::measures_of_size(size);
    if (!measures) return core::unexpected(measures.error());
    design.body = *measures;
    core::Result<core::Mannequin> body = core::make_mannequin(design.body);
    if (!body) return core::unexpected(body.error());
    return core::GarmentDesk::open(std::move(design), core::dress_form(*body), bodies);
}

}  // namespace

core::Result<std::unique_ptr<GarmentMode>> GarmentMode::create(const ui::FontSet& fonts,
                                                               const std::vector<ui::Strings>& languages,
                                                               const GarmentOptions& options, ui::SizePx screen) {
    core::Result<ui::Painter> painter = ui::Painter::create(fonts);
    if (!painter) return core::unexpected(painter.error());
    core::Result<FigureViews> views = FigureViews::create();
    if (!views) return core::unexpected(views.error());
    return std::unique_ptr<GarmentMode>(
        new GarmentMode(fonts, languages, options, screen, std::move(*painter), std::move(*views)));
}

GarmentMode::GarmentMode(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages,
                         const GarmentOptions& options, ui::SizePx screen, ui::Painter painter, FigureViews views)
    : fonts_(fonts),
      languages_(languages),
      options_(options),
      layout_(ui::garment_layout(screen, options.hand)),
      screen_(fonts, languages),
      painter_(std::move(painter)),
      views_(std::move(views)),
      builder_(options.every_frame_seen),
      drape_(options.every_frame_seen),
      objects_(options.model_source     ? options.model_source
               : options.models.empty() ? ModelSource{}
                                        : models_of_index(options.models)),
      body_files_(options.bodies, options.every_frame_seen),
      own_fabrics_(read_own_fabrics(options.fabrics)),
      keeper_(options.designs) {
    views_.lay_out(layout_, painter_);
    views_.set_quads(quads_);
    make_fabric_tiles();
}

GarmentMode::~GarmentMode() = default;

// ---- the desk

void GarmentMode::prepare() {
    if (desk_ || coming_.valid() || !failure_.empty()) return;
    coming_ =
        std::async(std::launch::async,
                   [make = options_.first_desk, size = options_.size,
                    source = body_files_.source()]() -> core::Result<core::GarmentDesk> {
                       try {
                           return make ? make(size) : empty_desk(size, source);
                       } catch (const std::exception& error) {  // out of memory
                           return core::unexpected(core::ErrorCode::Internal,
                                                   std::string("the figure cannot be made (") + error.what() + ")");
                       }
                   });
}

/// Waits for the body of an empty design, when it is needed before it is there.
void GarmentMode::ready_desk() {
    if (desk_) return;
    prepare();
    if (!coming_.valid()) return;
    core::Result<core::GarmentDesk> desk = coming_.get();
    if (!desk) {
        failure_ = desk.error().sentence();
        return;
    }
    desk_.emplace(std::move(*desk));
    body_.set(desk_->state().settings().body);
    stepper_.set_quads(desk_->network().options().edge_cm);
    drawing_due_ = true;
    request_cloth();
    show_cloth();
}

core::GarmentDesk& GarmentMode::desk() {
    ready_desk();
    return *desk_;
}

core::Design GarmentMode::design() {
    return desk().design();
}

namespace {

/// Whether a design begins on the body that is worn now.
bool is_worn(const core::Design& design, const core::DesignRunner& now) {
    const std::optional<core::BodyMeasures>& worn = now.worn()->form.measures;
    return worn && worn->figure == design.body.figure && worn->cm == design.body.cm;
}

core::Result<core::GarmentDesk> desk_of(const core::Design& design, const core::GarmentDesk* now,
                                        core::FormSource source) {
    if (now != nullptr && is_worn(design, now->state())) return core::GarmentDesk::open(design, now->state());
    const core::Result<core::Mannequin> body = core::make_mannequin(design.body);
    if (!body) return core::unexpected(body.error());
    return core::GarmentDesk::open(design, core::dress_form(*body), std::move(source));
}

}  // namespace

core::Result<void> GarmentMode::open(const core::Design& design) {
    core::Result<core::GarmentDesk> desk = desk_of(design, desk_ ? &*desk_ : nullptr, body_files_.source());
    if (!desk) return core::unexpected(desk.error());
    put_back();
    builder_.forget();
    coming_ = {};
    desk_.emplace(std::move(*desk));
    body_.set(desk_->state().settings().body);
    stepper_.set_quads(desk_->network().options().edge_cm);
    textured_.clear();
    choose_piece();
    objects_.choose("");
    line_.clear();
    notes_.clear();
    problem_.clear();
    drawing_due_ = true;
    request_cloth();
    show_cloth();
    return {};
}

void GarmentMode::request_cloth() {
    if (!desk_ || hold_ == Hold::Measure) return;  // a body that is tried on stays until the slider is let go
    if (std::optional<core::BuildRequest> request = desk_->build_request()) {
        builder_.submit({std::move(*request), woven_layers()});
    }
}

void GarmentMode::take_cloth() {
    std::optional<BuiltGarment> built = builder_.take();
    if (!built || !desk_) return;
    if (!desk_->accept(std::move(built->result))) return;
    textured_ = std::move(built->textured);
    show_cloth();
}

ui::FabricLook GarmentMode::look_of(const std::string& piece, int layer) const {
    ui::FabricLook look;
    look.colour = ui::Colour::hex(ui::kSwatches[static_cast<std::size_t>(layer) % 5]);
    const auto& materials = desk_->state().look().materials;
    const auto found = materials.find(piece);
    if (found == materials.end()) return look;
    look.colour = ui::colour_of(found->second.colour, look.colour);
    look.fabric = ui::fabric_of(found->second.fabric);
    for (const OwnFabric& own : own_fabrics_.fabrics) {
        if (own.picture == found->second.fabric) look.picture = own.picture;
    }
    return look;
}

/// Layers with a patterned piece.
std::vector<int> GarmentMode::woven_layers() const {
    std::vector<int> layers;
    for (const core::NetworkRegion& region : desk_->network().regions()) {
        if (!region.alive) continue;
        const ui::FabricLook look = look_of(region.name, region.layer);
        if (look.fabric != ui::Fabric::Plain || !look.picture.empty()) {
            layers.push_back(region.layer);
        }
    }
    return layers;
}

/// The cloth as the desk has it, in its fabrics, on the figure it is worn by.
void GarmentMode::show_cloth() {
    FigureDress dress;
    dress.body_shown = body_shown_;
    dress.form = desk_->form();
    const core::DesignLook& look = desk_->state().look();
    const std::vector<core::BuiltLayer>& layers = desk_->cloth();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        FigureDress::Layer layer;
        layer.layer = layers[i].layer;
        layer.cloth = layers[i].cloth;
        const auto number = static_cast<std::size_t>(layer.layer);
        layer.shown = number >= look.layers.size() || look.layers[number].shown;
        if (i < textured_.size()) layer.textured = textured_[i];
        if (layer.cloth) {
            const std::vector<core::ClothPiece>& pieces = layer.cloth->fitted.pieces;
            for (const core::ClothPiece& piece : pieces) {
                const std::string& name =
                    piece.mirror_of >= 0 ? pieces[static_cast<std::size_t>(piece.mirror_of)].name : piece.name;
                layer.looks.push_back(look_of(name, layer.layer));
            }
        }
        dress.layers.push_back(std::move(layer));
    }
    views_.set_dress(std::move(dress));
    if (drape_.on()) views_.set_places(hanging_);
    show_objects();
    live_due_ = true;
    drawing_due_ = true;
}

/// Cloth that follows the pen or the slider.
void GarmentMode::follow_live() {
    if (!live_due_ || !desk_ || drape_.on()) return;
    live_due_ = false;
    const std::optional<core::GarmentDesk::Live> live = desk_->live();
    if (live && live->places != nullptr) {
        views_.set_places(live->layer, live->places);
    } else {
        views_.set_places(-1, nullptr);
    }
}

namespace {

const char* words_key(core::DeskNote::Key key) {
    using Key = core::DeskNote::Key;
    switch (key) {
        case Key::OutlineOpen:
            return "note_open";
        case Key::OpenMiddle:
            return "note_middle";
        case Key::OffBody:
            return "off_the_figure";
        case Key::NoPoint:
            return "no_point";
        case Key::PlaneEdgeOn:
            return "edge_on";
        case Key::TooShort:
            return "stroke_too_short";
        case Key::NotAcross:
            return "not_across";
        case Key::NotFilled:
            return "note_not_filled";
        case Key::LayersTouch:
            return "note_touch";
        case Key::NoRegion:
        case Key::NothingHere:
            return "nothing_here";
        case Key::BodyUnfit:
            return "body_unfit";
        case Key::Refused:
            break;
    }
    return "not_done";
}

}  // namespace

void GarmentMode::note(const core::DeskNote& note) {
    using Key = core::DeskNote::Key;
    const bool at_place = note.key == Key::OutlineOpen || note.key == Key::OpenMiddle || note.key == Key::NotFilled ||
                          note.key == Key::LayersTouch;
    if (at_place)
        notes_.emplace_back(note, words_key(note.key));
    else
        problem_ = words()[words_key(note.key)];
}

/// The slider changes the piece that was chosen; where there is none on this layer, the newest.
void GarmentMode::choose_piece() {
    if (!piece_for_folds().empty()) return;
    piece_.clear();
    for (const core::NetworkRegion& region : desk_->network().regions()) {
        if (region.alive && region.layer == desk_->layer()) piece_ = region.name;
    }
}

/// Between two ends on the middle plane: straight, and outside of the body where that bulges. False where there is no
/// other end on this side.
bool GarmentMode::close_middle(const core::DeskNote& from, std::int64_t now_us) {
    const core::DeskNote* to = nullptr;
    const std::vector<core::DeskNote> middles = open_middles(*desk_);
    for (const core::DeskNote& other : middles) {
        const double apart = core::length(other.place - from.place);
        const bool same_side = other.place.z * from.place.z >= 0;
        if (apart < 1 || !same_side) continue;
        if (to == nullptr || apart < core::length(to->place - from.place)) to = &other;
    }
    if (to == nullptr) return false;
    const core::DrawingView side = *core::named_view("left");
    core::DeskSettings& settings = desk_->settings();
    settings.tool = core::DeskTool::DrawOnPlane;
    settings.plane_cm = 0.0;
    const int steps = std::max(4, static_cast<int>(core::length(to->place - from.place)));
    for (int i = 0; i <= steps; ++i) {
        core::Vec3 place = from.place + (to->place - from.place) * (static_cast<double>(i) / steps);
        if (i > 0 && i < steps) {
            const core::FieldSample field = desk_->state().obstacle().sample(place);
            const double off = stepper_.offset_cm() - field.distance;
            if (off > 0) place = place + field.gradient * off;
        }
        place.x = 0;
        if (i == 0) {
            desk_->begin(side, side.project(place));
        } else {
            desk_->extend(side, side.project(place));
        }
    }
    const core::DeskReply reply = desk_->end();
    settings.plane_cm.reset();
    take_reply(reply, now_us);
    return true;
}

/// What an act brought: notes, a tape, another design.
void GarmentMode::take_reply(const core::DeskReply& reply, std::int64_t now_us) {
    (void)now_us;
    notes_.clear();
    problem_.clear();
    tape_ = reply.tape;
    for (const core::DeskNote& n : reply.notes) note(n);
    if (reply.changed) {
        cleared_ = false;
        stepper_.set_quads(desk_->network().options().edge_cm);
        choose_piece();
        keeper_.take(*desk_);
        request_cloth();
        show_cloth();
    }
    drawing_due_ = true;
    live_due_ = true;
}

void GarmentMode::update(std::int64_t now_us) {
    if (!desk_) {
        // the body of an empty design is made meanwhile; who draws waits for it, who looks does not
        if (!coming_.valid() || coming_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        ready_desk();
        if (!desk_) return;
    }
    repeat_until(now_us);
    if (cleared_ && now_us - cleared_us_ > kClearedOffer_us) cleared_ = false;  // Undo still brings it back
    if (gallery_open_) {
        gallery_->update(now_us);
        show_gallery_pictures();
    }
    if (std::exchange(body_due_, false)) try_body();
    request_cloth();
    take_cloth();
    take_own_body(now_us);
    follow_drape(now_us);
    follow_live();
}

int GarmentMode::update_ink() {
    if (desk_) follow_live();
    const bool moves = (hold_ != Hold::None && hold_ != Hold::Board) || (drape_.on() && drape_.moving());
    views_.set_moving(options_.every_frame_seen && moves);
    // also while the figure of an empty design is on its way: the last visitor's must not be seen until it comes
    if (views_.draw()) painter_.set_picture(FigureViews::kFigure, &views_.figure_texture());
    if (desk_) project();
    return 0;
}

void GarmentMode::settle(std::int64_t now_us) {
    ready_desk();
    if (!desk_) return;
    request_cloth();
    builder_.wait();
    update(now_us);
    follow_live();
    views_.set_moving(false);
    views_.draw_all();
    painter_.set_picture(FigureViews::kFigure, &views_.figure_texture());
    project();
}

void GarmentMode::project() {
    if (!drawing_due_ && projected_geometry_ == views_.geometry()) return;
    drawing_due_ = false;
    projected_geometry_ = views_.geometry();
    using T = ui::GarmentTool;
    SheetWishes wishes;
    wishes.shaping =
        tool_ == T::Move || tool_ == T::Weld || tool_ == T::Corner || tool_ == T::Smooth || tool_ == T::Bump;
    const core::LineGoingOn* going = desk_->line_going_on();
    wishes.selected_line = going != nullptr ? going->name : line_;
    drawing_ = hanging_wanted_ ? SheetDrawing{} : draw_sheet(*desk_, views_, wishes);
    make_washes();
}

bool GarmentMode::changed(std::int64_t now_us) const {
    return views_.due() || drawing_due_ || projected_geometry_ != views_.geometry() || !shown_ ||
           !(shown_at(now_us) == *shown_);
}

GarmentMode::Shown GarmentMode::shown_at(std::int64_t now_us) const {
    Shown shown{state(now_us), std::nullopt, layout_.screen, layout_.hand};
    if (gallery_open_) {
        shown.gallery = gallery_->state();
        if (touch_.pressed()) shown.gallery->pressed = touch_.pressed_item();
    }
    return shown;
}

void GarmentMode::draw(std::int64_t now_us, bool flip) {
    shown_ = shown_at(now_us);
    if (shown_->gallery) {
        painter_.paint(gallery_->page(layout_.screen, shown_->gallery->pressed).list, layout_.screen, flip);
        return;
    }
    painter_.paint(screen_.draw(shown_->state, layout_), layout_.screen, flip);
}

// ---- around visitors

bool GarmentMode::has_work() const {
    return desk_ && (desk_->can_undo() || desk_->can_redo() || desk_->is_open() || put_away_);
}

void GarmentMode::wipe(std::size_t language, ui::Hand hand) {
    put_back();
    objects_.forget();
    body_files_.forget();
    typed_.reset();
    recorder_.reset();
    recording_failed_ = false;
    keep_picture();
    (void)keeper_.end();
    if (gallery_open_) leave_gallery();
    export_no_place_ = false;
    exporter_.forget();
    touch_.cancel();
    hold_ = Hold::None;
    pointer_px_.reset();
    stroke_px_.clear();
    const bool worked = desk_ && (has_work() || desk_->state().settings().body.cm != GarmentBody().measures().cm);
    tool_ = ui::GarmentTool::OnBody;
    page_ = 0;
    stepper_ = GarmentStepper();
    quads_ = body_shown_ = true;
    history_shown_ = false;
    drawer_ = ui::GarmentDrawer::None;
    body_ = GarmentBody();
    body_problem_.clear();
    problem_.clear();
    notes_.clear();
    tape_.reset();
    piece_.clear();
    line_.clear();
    cleared_ = find_wanted_ = erasing_ = eraser_near_ = pen_hovers_ = body_due_ = false;
    repeat_us_.reset();
    put_away_.reset();
    put_away_id_ = 0;
    scroll_px_ = 0;
    drawing_ = {};
    drop_washes();
    options_.language = language;
    views_.reset_cameras();
    views_.show(ui::GarmentView::Front);
    views_.set_quads(quads_);
    if (worked) {
        builder_.forget();
        textured_.clear();
        desk_.reset();
        prepare();
        views_.set_objects({});
        views_.set_dress({});
    } else if (desk_) {
        show_cloth();  // the body, where the last visitor hid it
    }
    set_hand(hand);
    shown_.reset();
    drawing_due_ = true;
}

void GarmentMode::resize(ui::SizePx screen) {
    if (screen.width < 1 || screen.height < 1 || screen == layout_.screen) return;
    relayout(screen, options_.hand);
}

void GarmentMode::set_hand(ui::Hand hand) {
    if (hand != options_.hand) relayout(layout_.screen, hand);
}

void GarmentMode::relayout(ui::SizePx screen, ui::Hand hand) {
    options_.hand = hand;
    layout_ = ui::garment_layout(screen, hand);
    views_.lay_out(layout_, painter_);
    scroll_px_ = 0;
    drawing_due_ = true;
}

}  // namespace app
