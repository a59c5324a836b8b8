#pragma once
// Makes the models of an answer ready for their cards: normals, part maps, where they stand. Needs no GL.

#include <list>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include "firmware_like_app/kiosk/searcher.hpp"
#include "ui/draw/model_geometry.hpp"

namespace app {

/// For one thread at a time. Remembers the meshes it saw last, since searches while drawing find the same ones again.
class CardPreparer {
  public:
    using Cards = std::vector<std::shared_ptr<const ui::CardModel>>;

    /// One card for each model that the screen has room for; null where a model has no mesh, so that its card shows the
    /// name alone. Stops early, with fewer cards, when that is asked for. A few milliseconds a card.
    [[nodiscard]] Cards prepare(const SearchAnswer& answer, const std::stop_token& stop = {});

  private:
    struct Known {
        std::shared_ptr<const core::TriangleMesh> mesh;
        std::shared_ptr<const ui::ModelGeometry> geometry;
    };
    std::shared_ptr<const ui::ModelGeometry> geometry_of(const FoundModel& model);
    std::list<Known> known_;  // newest first
};

}  // namespace app
