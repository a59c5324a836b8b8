#include "firmware_like_app/kiosk/card_preparer.hpp"

#include <algorithm>

#include "ui/screens/card_rail.hpp"

namespace app {
namespace {

constexpr std::size_t kMeshesKept = 48;
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

CardPreparer::Cards CardPreparer::prepare(const SearchAnswer& answer, const std::stop_token& stop) {
    Cards cards;
    const std::size_t shown = std::min(answer.best.size(), ui::kCardCount);
    for (std::size_t i = 0; i < shown && !stop.stop_requested(); ++i) {
        const FoundModel& model = answer.best[i];
        if (model.mesh == nullptr || model.mesh->empty()) {
            cards.push_back(nullptr);
            continue;
        }
        cards.push_back(std::make_shared<const ui::CardModel>(ui::make_card_model(
            geometry_of(model), model.camera, model.mirrored, regions_of(model), i == 0 ? kBestMap_px : kSmallMap_px)));
    }
    return cards;
}

std::shared_ptr<const ui::ModelGeometry> CardPreparer::geometry_of(const FoundModel& model) {
    const auto found =
        std::find_if(known_.begin(), known_.end(), [&](const Known& known) { return known.mesh == model.mesh; });
    if (found != known_.end()) {
        known_.splice(known_.begin(), known_, found);
        return known_.front().geometry;
    }
    known_.push_front({model.mesh, std::make_shared<const ui::ModelGeometry>(ui::make_model_geometry(*model.mesh))});
    std::shared_ptr<const ui::ModelGeometry> geometry = known_.front().geometry;
    if (known_.size() > kMeshesKept) known_.pop_back();
    return geometry;
}

}  // namespace app
