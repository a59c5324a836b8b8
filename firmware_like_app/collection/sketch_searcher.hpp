#pragma once
// What the kiosk finds: a drawing's best models, with the regions of matched parts on the drawing and in the model's
// view.

#include <list>
#include <memory>

#include "core/silhouette/drawing_readings.hpp"
#include "core/silhouette/unfinished.hpp"
#include "db/stores/two_view_index.hpp"
#include "firmware_like_app/collection/collection.hpp"
#include "firmware_like_app/kiosk/searcher.hpp"

namespace app {

class SketchSearcher : public Searcher {
  public:
    /// Opens the index a second time for display meshes, which are read when a model is shown first and then kept, the
    /// last few dozen of them. Errors of Collection::load.
    [[nodiscard]] static core::Result<std::unique_ptr<SketchSearcher>> open(const std::string& database, int jobs,
                                                                            int best_count);

    SearchAnswer search(const core::Drawing& drawing, std::stop_token stop) override;
    /// See core/silhouette/unfinished.hpp.
    SearchAnswer search_unfinished(const core::Drawing& drawing, std::stop_token stop) override;
    [[nodiscard]] const Collection& collection() const { return collection_; }

  private:
    SketchSearcher(Collection collection, db::TwoViewIndex index, int jobs, int best_count);
    using Readings = core::Result<std::vector<core::Silhouette>>;
    SearchAnswer find(const Readings& silhouettes, double silhouette_ms, const std::stop_token& stop);
    std::shared_ptr<const core::TriangleMesh> mesh_of(std::int64_t id);

    Collection collection_;
    db::TwoViewIndex index_;
    int jobs_;
    int best_count_;
    core::Matcher matcher_;
    core::LiveReadings live_;  // follows the drawing from search to search
    core::UnfinishedReading unfinished_;
    std::vector<std::size_t> likely_;  // what the last search found, as indices into the models
    std::list<std::pair<std::int64_t, std::shared_ptr<const core::TriangleMesh>>> meshes_;  // newest first
};

}  // namespace app
