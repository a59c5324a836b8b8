#include "firmware_like_app/kiosk/best_shadow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

constexpr int kFirstPicture = 40, kSteps = 12;
constexpr double kMoved = 0.02;  // of the shadow's size: less is not worth a fade

ui::PictureId id_of(int picture) {
    return ui::PictureId{kFirstPicture + picture};
}

bool has_moved(const ShadowShape& a, const ShadowShape& b) {
    const double limit = kMoved * std::max(a.width, a.height);
    return std::max({std::abs(a.left - b.left), std::abs(a.top - b.top), std::abs(a.left + a.width - b.left - b.width),
                     std::abs(a.top + a.height - b.top - b.height)}) > limit;
}

}  // namespace

BestShadow::BestShadow(bool beside) {
    if (beside)
        worker_ = std::make_unique<NewestWorker<Job, Ready>>(
            [](const Job& job, const std::stop_token& /*stop*/) { return make(job); });
}

BestShadow::Ready BestShadow::make(const Job& job) {
    const FoundModel& best = job.ranking->answer.best.front();
    return {job.epoch, best.id, shadow_shape(best, job.drawing)};
}

void BestShadow::see(std::shared_ptr<const PreparedAnswer> ranking, const Extent& drawing) {
    drawing_ = drawing;
    newest_ = std::move(ranking);
    const std::vector<FoundModel>& best = newest_->answer.best;
    const std::optional<std::int64_t> first = best.empty() ? std::nullopt : std::optional(best.front().id);
    held_ = first == candidate_;
    candidate_ = first;
    asked_ = false;
}

void BestShadow::update(std::int64_t now_us, bool last, ui::Painter& painter) {
    if (before_ && now_us - changed_us_ >= kFade_us) {
        painter.set_picture(id_of(before_->picture), nullptr);
        before_.reset();
    }
    if (!worker_ || before_) return;  // one change at a time
    if (auto ready = worker_->take(); ready && ready->epoch == epoch_) show(std::move(*ready), now_us, painter);
    if (!newest_ || asked_ || !(held_ || last) || before_ || now_us - asked_us_ < kEvery_us) return;
    asked_ = true;
    asked_us_ = now_us;
    if (candidate_) {
        worker_->start({epoch_, newest_, drawing_});
    } else if (now_) {
        leave(now_us, painter);
    }
}

void BestShadow::show(Ready ready, std::int64_t now_us, ui::Painter& painter) {
    core::GrayImage& coverage = ready.shape.coverage;
    if (coverage.pixels.empty()) {
        if (now_) leave(now_us, painter);
        return;
    }
    if (now_ && !has_moved(now_->place, ready.shape)) return;
    leave(now_us, painter);
    ui::Texture texture({coverage.width, coverage.height}, ui::PixelFormat::Coverage);
    texture.upload(0, 0, texture.size(), coverage.pixels);
    coverage = {};
    pictures_ = 1 - pictures_;
    now_ = Layer{std::move(texture), std::move(ready.shape), pictures_};
    painter.set_picture(id_of(pictures_), &now_->coverage);
}

/// The one that is shown begins to fade; one that fades already goes.
void BestShadow::leave(std::int64_t now_us, ui::Painter& painter) {
    if (before_) painter.set_picture(id_of(before_->picture), nullptr);
    before_ = std::exchange(now_, std::nullopt);
    if (before_) painter.set_picture(id_of(before_->picture), &before_->coverage);  // it has another place in memory
    changed_us_ = now_us;
}

void BestShadow::settle(ui::Painter& painter) {
    if (!newest_) return;
    ++epoch_;  // what is being made would come later
    if (!asked_ || worker_) {
        asked_ = true;
        leave(0, painter);
        if (candidate_) show(make({epoch_, newest_, drawing_}), 0, painter);
    }
    if (before_) painter.set_picture(id_of(before_->picture), nullptr);
    before_.reset();
    changed_us_ = -kFade_us;  // long ago on every clock
}

void BestShadow::clear(ui::Painter& painter) {
    for (const std::optional<Layer>* layer : {&now_, &before_}) {
        if (*layer) painter.set_picture(id_of((*layer)->picture), nullptr);
    }
    now_.reset();
    before_.reset();
    newest_.reset();
    candidate_.reset();
    held_ = asked_ = false;
    ++epoch_;
    if (worker_) worker_->forget();
}

std::vector<ui::ShadowPart> BestShadow::shown(std::int64_t now_us, const ui::InkFrame& frame,
                                              const ui::Rect& sheet) const {
    std::vector<ui::ShadowPart> parts;
    const double t = std::clamp(static_cast<double>(now_us - changed_us_) / static_cast<double>(kFade_us), 0.0, 1.0);
    const double come = std::floor(t * kSteps) / kSteps;
    const auto add = [&](const Layer& layer, double opacity) {
        if (opacity <= 0) return;
        const core::Point corner = frame.to_px({layer.place.left, layer.place.top});
        parts.push_back({id_of(layer.picture),
                         {corner.x + sheet.x, corner.y + sheet.y, layer.place.width * frame.scale,
                          layer.place.height * frame.scale},
                         opacity});
    };
    if (before_) add(*before_, 1 - come);
    if (now_) add(*now_, come);
    return parts;
}

}  // namespace app
