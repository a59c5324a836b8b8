#include "firmware_like_app/kiosk/search_worker.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "ui/screens/card_rail.hpp"

namespace app {
namespace {

constexpr std::size_t kGeometriesKept = 48;
constexpr int kBestMap_px = 256, kSmallMap_px = 144;

std::vector<ui::PartRegion> regions_of(const FoundModel& model) {
    std::vector<ui::PartRegion> regions;
    const bool any =
        std::any_of(model.parts.begin(), model.parts.end(), [](const FoundPart& p) { return p.colour >= 0; });
    if (!any) return regions;
    for (const FoundPart& part : model.parts) regions.push_back({part.colour, part.on_view});
    return regions;
}

}  // namespace

SearchWorker::SearchWorker(Searcher& searcher) : searcher_(searcher) {
    thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

SearchWorker::~SearchWorker() {
    thread_.request_stop();
    thread_.join();
}

std::uint64_t SearchWorker::submit(core::Drawing drawing) {
    const std::scoped_lock lock(mutex_);
    waiting_ = Job{++last_ticket_, std::move(drawing)};
    changed_.notify_all();
    return last_ticket_;
}

std::optional<PreparedAnswer> SearchWorker::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(done_, std::nullopt);
}

std::optional<PreparedAnswer> SearchWorker::wait_for(std::uint64_t ticket) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return done_ticket_ >= ticket; });
    return std::exchange(done_, std::nullopt);
}

std::uint64_t SearchWorker::searches() const {
    const std::scoped_lock lock(mutex_);
    return searches_;
}

void SearchWorker::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::optional<Job> job;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
            job = std::exchange(waiting_, std::nullopt);
        }
        PreparedAnswer answer = run(*job, stop);
        const std::scoped_lock lock(mutex_);
        done_ticket_ = answer.ticket;
        done_ = std::move(answer);
        ++searches_;
        changed_.notify_all();
    }
}

PreparedAnswer SearchWorker::run(const Job& job, const std::stop_token& stop) {
    PreparedAnswer out;
    out.ticket = job.ticket;
    try {
        out.answer = searcher_.search(job.drawing, stop);
        const std::size_t shown = std::min(out.answer.best.size(), ui::kCardCount);
        for (std::size_t i = 0; i < shown && !stop.stop_requested(); ++i) {
            const FoundModel& model = out.answer.best[i];
            if (model.mesh == nullptr || model.mesh->empty()) {
                out.cards.push_back(nullptr);  // the card shows the name alone
                continue;
            }
            out.cards.push_back(std::make_shared<const ui::CardModel>(
                ui::make_card_model(geometry_of(model), model.camera, model.mirrored, regions_of(model),
                                    i == 0 ? kBestMap_px : kSmallMap_px)));
        }
    } catch (const std::exception& e) {
        out.answer = {};
        out.cards.clear();
        out.failure = e.what();
    }
    return out;
}

std::shared_ptr<const ui::ModelGeometry> SearchWorker::geometry_of(const FoundModel& model) {
    const auto found = std::find_if(geometries_.begin(), geometries_.end(),
                                    [&](const auto& entry) { return entry.first == model.mesh.get(); });
    if (found != geometries_.end()) {
        geometries_.splice(geometries_.begin(), geometries_, found);
        return geometries_.front().second.second;
    }
    auto geometry = std::make_shared<const ui::ModelGeometry>(ui::make_model_geometry(*model.mesh));
    geometries_.emplace_front(model.mesh.get(), std::make_pair(model.mesh, geometry));
    if (geometries_.size() > kGeometriesKept) geometries_.pop_back();
    return geometry;
}

}  // namespace app
