// Designs kept, found again in the gallery, and taken away.

#include <algorithm>
#include <cmath>
#include <utility>

#include "firmware_like_app/garment/design_faults.hpp"
#include "firmware_like_app/garment/design_sources.hpp"
#include "firmware_like_app/kiosk/garment_mode.hpp"
#include "ui/screens/widgets.hpp"

namespace app {
namespace {

constexpr int kFirstGalleryPicture = 400;
constexpr std::size_t kPicturesAFrame = 2, kAllPictures = 1000;

ExportPlan plan_of(std::size_t kind) {
    ExportPlan plan;
    plan.model = kind == 0;
    plan.print_pattern = kind == 1;
    plan.cut_pattern = kind == 2;
    plan.pictures = kind == 0 ? plan.pictures : 0;
    return plan;
}

const char* fault_key(ExportFault::Kind kind) {
    switch (kind) {
        case ExportFault::Kind::NoPlace:
            return "export_no_stick";
        case ExportFault::Kind::Full:
            return "export_full";
        case ExportFault::Kind::Gone:
            return "export_gone";
        case ExportFault::Kind::ReadOnly:
            return "export_locked";
        case ExportFault::Kind::Nothing:
            return "export_nothing";
        default:
            return "export_failed";
    }
}

}  // namespace

void GarmentMode::export_as(std::size_t kind) {
    export_no_place_ = false;
    ExportJob job;
    job.design = desk_->design();
    if (job.design.name.empty()) job.design.name = "Croquis";
    job.bodies = bodies_by_file();
    if (!options_.models.empty()) job.models = models_of_index(options_.models);
    job.plan = plan_of(kind);
    if (!options_.export_to.empty()) {
        job.place = folder_place(options_.export_to);
    } else {
        const std::vector<ExportPlace> sticks = find_sticks();
        if (sticks.empty()) {
            export_no_place_ = true;
            return;
        }
        job.place = sticks.front();
    }
    (void)exporter_.start(std::move(job));
}

void GarmentMode::fill_export(ui::GarmentState& state) const {
    const ExportState now = exporter_.state();
    using Stage = ExportState::Stage;
    state.export_busy = now.stage == Stage::Dressing || now.stage == Stage::Pictures || now.stage == Stage::Writing;
    state.export_share = std::round(now.share * 100) / 100;
    if (export_no_place_) {
        state.export_message = words()["export_no_stick"];
    } else if (state.export_busy) {
        state.export_message = words()["export_working"];
    } else if (now.stage == Stage::Saved) {
        state.export_message = options_.export_to.empty()
                                   ? words()["export_saved"]
                                   : ui::filled_in(words()["export_saved_in"], {{"folder", now.folder.string()}});
    } else if (now.stage == Stage::Failed && now.fault) {
        state.export_message = words()[fault_key(now.fault->kind)];
    }
}

/// For the design's card.
void GarmentMode::keep_picture() {
    put_back();
    if (desk_ && keeper_.id() != 0) keeper_.set_thumbnail(views_.thumbnail());
}

void GarmentMode::open_gallery() {
    if (!keeper_.keeps()) return;
    if (!gallery_) {
        GalleryOptions options;
        options.first_picture = kFirstGalleryPicture;
        options.bin_days = options_.bin_days;
        gallery_ = std::make_unique<GalleryDesk>(fonts_, languages_, keeper_.file(), options);
    }
    keep_picture();
    gallery_->open(keeper_.id(), options_.language, options_.hand);
    gallery_open_ = true;
    touch_.cancel();
    hold_ = Hold::None;
}

void GarmentMode::leave_gallery() {
    gallery_open_ = false;
    for (const auto& [id, texture] : gallery_pictures_) painter_.set_picture(id, nullptr);
    gallery_pictures_.clear();
    shown_.reset();
}

/// Of the cards that are on the screen, a few a frame; those of others go.
void GarmentMode::show_gallery_pictures() {
    gallery_->look(layout_.screen, options_.every_frame_seen ? kPicturesAFrame : kAllPictures);
    for (auto& [id, picture] : gallery_->take_pictures()) {
        ui::Texture texture({picture.width, picture.height}, ui::PixelFormat::Colour);
        texture.upload(0, 0, texture.size(), picture.pixels);
        painter_.set_picture(id, &gallery_pictures_.insert_or_assign(id, std::move(texture)).first->second);
    }
    for (auto it = gallery_pictures_.begin(); it != gallery_pictures_.end();) {
        if (gallery_->shows(it->first)) {
            ++it;
            continue;
        }
        painter_.set_picture(it->first, nullptr);
        it = gallery_pictures_.erase(it);
    }
}

void GarmentMode::gallery_pointer(const ui::WindowEvent& event) {
    using Kind = ui::WindowEvent::Kind;
    const std::optional<std::size_t> pressed =
        touch_.pressed() ? std::optional<std::size_t>(touch_.pressed_item()) : std::nullopt;
    if (event.kind == Kind::Down) {
        down_px_ = last_px_ = {event.x, event.y};
        (void)touch_.press(gallery_->page(layout_.screen, pressed).targets, event.x, event.y);
    } else if (event.kind == Kind::Move) {
        touch_.move(event.x, event.y);
        if (std::abs(event.y - down_px_.y) > layout_.px(12)) gallery_->scroll(last_px_.y - event.y, layout_.screen);
        last_px_ = {event.x, event.y};
    } else if (event.kind == Kind::Up) {
        touch_.move(event.x, event.y);
        const bool dragged = std::abs(event.y - down_px_.y) > layout_.px(12);
        const std::optional<ui::Intent> intent = touch_.release();
        if (intent && !dragged) press_gallery(intent->item, event.time_us);
    } else if (event.kind == Kind::Zoom) {
        gallery_->scroll(-event.zoom * layout_.px(300), layout_.screen);
    }
}

void GarmentMode::press_gallery(std::size_t item, std::int64_t now_us) {
    const std::optional<GalleryWish> wish = gallery_->press(item, now_us);
    if (const std::optional<std::string> name = gallery_->take_new_name()) keeper_.rename(*name);
    if (!wish) return;
    leave_gallery();
    if (wish->kind == GalleryWish::Kind::New) clear_design(now_us);
    if (wish->kind == GalleryWish::Kind::Open && wish->id != keeper_.id()) open_kept(wish->id);
}

/// A kept design on the sheet, with what was undone to be done again.
void GarmentMode::open_kept(std::int64_t id) {
    put_away_.reset();  // it is in the gallery
    keep_picture();
    (void)keeper_.end();  // its last words are stored before the file is read
    const core::Result<db::OpenedDesign> kept = keeper_.load(id);
    if (!kept) {
        problem_ = design_fault_words(kept.error(), words());
        return;
    }
    core::Design whole = kept->state.design;
    const std::size_t place = db::count_acts(whole.steps);
    whole.steps.insert(whole.steps.end(), kept->state.undone.begin(), kept->state.undone.end());
    if (const core::Result<void> opened = open(whole); !opened) {
        problem_ = design_fault_words(opened.error(), words());
        return;
    }
    if (!kept->state.undone.empty()) (void)desk_->go_to(place);
    stepper_.set_quads(desk_->network().options().edge_cm);
    (void)desk_->take_journal();
    keeper_.follow(id, kept->sequence);
    if (!kept->faults.empty()) problem_ = words()["designs_damaged"];
    choose_piece();
    request_cloth();
    show_cloth();
}

}  // namespace app
