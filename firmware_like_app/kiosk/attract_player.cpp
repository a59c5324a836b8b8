#include "firmware_like_app/kiosk/attract_player.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

#include "core/exchange/quickdraw_reader.hpp"
#include "core/exchange/sketch_reader.hpp"
#include "firmware_like_app/kiosk/placing.hpp"
#include "ui/gl/embedded.hpp"

namespace app {
namespace {

constexpr ui::PictureId kInk{1}, kForm{2};
constexpr double kMargin = 0.08;
constexpr double kDrift_px = 24;  // each way in an hour

/// Nobody wants to see somebody think: no lift of the pen lasts longer than this.
void shorten_lifts(core::Drawing& drawing) {
    constexpr std::int64_t kLongest_us = 500'000;
    std::int64_t cut_us = 0, before_us = 0;
    bool first = true;
    for (core::Stroke& stroke : drawing.strokes) {
        if (stroke.samples.empty()) continue;
        if (!first) cut_us += std::max<std::int64_t>(0, stroke.samples.front().time_us - before_us - kLongest_us);
        first = false;
        before_us = stroke.samples.back().time_us;
        for (core::PenSample& s : stroke.samples) s.time_us -= cut_us;
    }
}

/// Gives the samples times from 0 to `whole`, in proportion to their own, or evenly where those do not grow.
void retime(core::Drawing& drawing, std::int64_t whole) {
    shorten_lifts(drawing);
    std::int64_t first = 0, last = 0;
    std::size_t count = 0;
    for (const core::Stroke& stroke : drawing.strokes) {
        for (const core::PenSample& s : stroke.samples) {
            if (count++ == 0) first = s.time_us;
            last = std::max(last, s.time_us);
        }
    }
    std::size_t at = 0;
    for (core::Stroke& stroke : drawing.strokes) {
        for (core::PenSample& s : stroke.samples) {
            const double share = last > first
                                     ? static_cast<double>(s.time_us - first) / static_cast<double>(last - first)
                                     : static_cast<double>(at) / static_cast<double>(std::max<std::size_t>(count, 1));
            s.time_us = static_cast<std::int64_t>(share * static_cast<double>(whole));
            ++at;
        }
    }
}

core::Result<std::vector<NamedDrawing>> drawings_of(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (auto it = std::filesystem::directory_iterator(folder, error);
         !error && it != std::filesystem::directory_iterator(); it.increment(error)) {
        files.push_back(it->path());
    }
    std::sort(files.begin(), files.end());
    std::vector<NamedDrawing> drawings;
    for (const std::filesystem::path& file : files) {
        core::Result<core::Sketch> sketch = core::read_sketch(file.string());
        if (sketch && sketch->drawing && !sketch->drawing->empty())
            drawings.push_back({file.stem().string(), std::move(*sketch->drawing)});
    }
    if (!drawings.empty()) return drawings;
    return core::unexpected(core::ErrorCode::FileMissing,
                            error ? "the folder of drawings to show cannot be read (" + error.message() + ")"
                                  : "no file in the folder of drawings to show holds a drawing",
                            folder);
}

double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace

core::Result<std::vector<NamedDrawing>> attract_drawings(const std::string& folder) {
    if (!folder.empty()) return drawings_of(folder);
    std::vector<NamedDrawing> drawings;
    for (const ui::EmbeddedFile& file : ui::attract_files()) {
        core::Result<core::Drawing> drawing = core::parse_quickdraw_line(file.content);
        if (!drawing) return core::unexpected(drawing.error().code, drawing.error().message, std::string(file.name));
        drawings.push_back({std::string(file.name.substr(0, file.name.find('.'))), std::move(*drawing)});
    }
    return drawings;
}

core::Result<std::unique_ptr<AttractPlayer>> AttractPlayer::create(std::vector<NamedDrawing> drawings,
                                                                   Searcher* searcher) {
    core::Result<ui::InkLayer> ink = ui::InkLayer::create({1, 1});
    if (!ink) return core::unexpected(ink.error());
    core::Result<ui::ModelStage> stage = ui::ModelStage::create();
    if (!stage) return core::unexpected(stage.error());
    std::erase_if(drawings, [](const NamedDrawing& d) { return d.drawing.empty(); });
    for (NamedDrawing& d : drawings) retime(d.drawing, kDraw_us);
    return std::unique_ptr<AttractPlayer>(
        new AttractPlayer(std::move(drawings), searcher, std::move(*ink), std::move(*stage)));
}

AttractPlayer::AttractPlayer(std::vector<NamedDrawing> drawings, Searcher* searcher, ui::InkLayer ink,
                             ui::ModelStage stage)
    : drawings_(std::move(drawings)), ink_layer_(std::move(ink)), model_(std::move(stage)) {
    if (searcher != nullptr) worker_ = std::make_unique<SearchWorker>(*searcher);
}

void AttractPlayer::start(ui::SizePx stage, double ink_width_px, std::int64_t now_us) {
    stage_ = stage;
    ink_width_px_ = ink_width_px;
    ink_layer_.resize(stage);
    start_us_ = now_us;
    drawing_ = 0;
    begin_drawing(now_us);
}

void AttractPlayer::begin_drawing(std::int64_t now_us) {
    loop_us_ = now_us;
    drawn_.clear();
    stroke_ = sample_ = 0;
    ++epoch_;
    asked_ = answered_ = has_form_ = false;
    pictures_told_ = false;
    form_since_us_.reset();
    if (!drawings_.empty()) frame_ = fit_drawing(drawings_[drawing_].drawing, stage_.width, stage_.height, kMargin);
}

void AttractPlayer::add_samples(std::int64_t age_us) {
    const core::Drawing& drawing = drawings_[drawing_].drawing;
    while (stroke_ < drawing.strokes.size()) {
        const std::vector<core::PenSample>& samples = drawing.strokes[stroke_].samples;
        while (sample_ < samples.size() && samples[sample_].time_us <= age_us) {
            if (sample_ == 0) drawn_.emplace_back();
            drawn_.back().samples.push_back(samples[sample_++]);
            ++revision_;
        }
        if (sample_ < samples.size()) return;
        ++stroke_;
        sample_ = 0;
    }
}

void AttractPlayer::update(std::int64_t now_us, bool wait, ui::Painter& painter) {
    if (drawings_.empty()) return;
    if (now_us - loop_us_ >= kLoop_us) {
        drawing_ = (drawing_ + 1) % drawings_.size();
        begin_drawing(now_us);
    }
    const std::int64_t age_us = now_us - loop_us_;
    add_samples(age_us);
    const bool line_is_there = stroke_ == drawings_[drawing_].drawing.strokes.size();
    if (line_is_there && !asked_ && worker_) {
        asked_ = true;
        ticket_ = worker_->submit(drawings_[drawing_].drawing);
    }
    if (asked_ && !answered_) {
        std::optional<PreparedAnswer> answer = wait ? worker_->wait_for(ticket_) : worker_->take();
        if (answer && answer->ticket == ticket_) {
            answered_ = true;
            take_form(std::move(answer->answer));
        }
    }
    if (has_form_ && !form_since_us_ && age_us >= kDraw_us) form_since_us_ = now_us;
    if (std::exchange(pictures_told_, true)) return;
    painter.set_picture(kInk, &ink_layer_.texture());
    painter.set_picture(kForm, has_form_ ? &model_.texture() : nullptr);
}

void AttractPlayer::take_form(SearchAnswer answer) {
    if (answer.best.empty() || !answer.best[0].mesh || answer.best[0].mesh->empty()) return;
    const FoundModel& best = answer.best[0];
    const auto geometry = std::make_shared<const ui::ModelGeometry>(ui::make_model_geometry(*best.mesh));
    const ui::CardModel card = ui::make_card_model(geometry, best.camera, best.mirrored, {}, 1);
    const Extent drawn = extent_of(drawings_[drawing_].drawing);
    const double width = drawn.width() * frame_.scale, height = drawn.height() * frame_.scale;
    const double plane_width = std::max(card.right - card.left, 1e-6),
                 plane_height = std::max(card.top - card.bottom, 1e-6);

    // as large as the line all in all, and on its ground
    ui::StageView view;
    view.camera = best.camera;
    view.mirrored = best.mirrored;
    view.ground_up = best.camera.up;
    view.scale_px = std::sqrt(width * height / (plane_width * plane_height));
    view.scale_px = std::min({view.scale_px, stage_.width / plane_width, stage_.height / plane_height});
    const core::Point low = frame_.to_px({drawn.left, drawn.bottom}), high = frame_.to_px({drawn.right, drawn.top});
    const double middle = (card.left + card.right) / 2 * (best.mirrored ? -1 : 1);
    view.centre_px = {(low.x + high.x) / 2 - middle * view.scale_px, low.y + card.bottom * view.scale_px};
    model_.set_model(*geometry, ui::find_ground_contacts(*geometry, best.camera.up));
    model_.draw(view, stage_);
    const double bottom_px = view.centre_px.y - card.bottom * view.scale_px;
    form_box_ = {view.centre_px.x + (middle - plane_width / 2) * view.scale_px,
                 bottom_px - plane_height * view.scale_px, plane_width * view.scale_px, plane_height * view.scale_px};
    has_form_ = true;
    pictures_told_ = false;
}

ui::InkLayer::Ink AttractPlayer::ink() const {
    const bool open = !drawings_.empty() && stroke_ < drawings_[drawing_].drawing.strokes.size() && sample_ > 0;
    return {drawn_, open, epoch_, frame_, ink_width_px_};
}

int AttractPlayer::update_ink() {
    return ink_layer_.update(ink());
}

void AttractPlayer::tell_changes(ui::Painter& painter) {
    painter.picture_changed(kInk, ink_layer_.take_changed());
}

void AttractPlayer::fill(ui::AttractState& state, std::int64_t now_us) const {
    state.ink = kInk;
    state.form = kForm;
    state.inked = ink_layer_.inked();
    state.wet_ink = ui::InkLayer::wet_end(ink());
    state.ink_revision = revision_;
    state.form_box = has_form_ ? form_box_ : ui::Rect{};
    state.form_share =
        form_since_us_ ? smooth(static_cast<double>(now_us - *form_since_us_) / static_cast<double>(kForm_us)) : 0;
    const std::int64_t left_us = loop_us_ + kLoop_us - now_us;
    state.opacity = smooth(static_cast<double>(left_us) / static_cast<double>(kFade_us));
    // there and back in two hours, whole pixels
    const double hours = static_cast<double>(now_us - start_us_) / 3.6e9;
    const double swing = kDrift_px * (1 - std::abs(std::fmod(hours, 2.0) - 1));
    state.drift = {std::round(swing), std::round(swing / 2)};
}

void AttractPlayer::stop(ui::Painter& painter) {
    painter.set_picture(kInk, nullptr);
    painter.set_picture(kForm, nullptr);
    model_.clear_model();
    ink_layer_.resize({1, 1});
    drawn_.clear();
    has_form_ = false;
    form_since_us_.reset();
    ++epoch_;
}

}  // namespace app
