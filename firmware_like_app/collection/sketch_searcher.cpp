#include "firmware_like_app/collection/sketch_searcher.hpp"

#include <algorithm>

#include "firmware_like_app/collection/sketch_description.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"

namespace app {

core::Result<std::unique_ptr<SketchSearcher>> SketchSearcher::open(const std::string& database, int jobs,
                                                                   int best_count) {
    core::Result<Collection> collection = Collection::load(database);
    if (!collection) return core::unexpected(collection.error());
    core::Result<db::TwoViewIndex> index = db::TwoViewIndex::open(database, db::OpenMode::ReadOnly);
    if (!index) return core::unexpected(index.error());
    return std::unique_ptr<SketchSearcher>(
        new SketchSearcher(std::move(*collection), std::move(*index), jobs, best_count));
}

SketchSearcher::SketchSearcher(Collection collection, db::TwoViewIndex index, int jobs, int best_count)
    : collection_(std::move(collection)), index_(std::move(index)), jobs_(jobs), best_count_(best_count) {}

std::shared_ptr<const core::TriangleMesh> SketchSearcher::mesh_of(std::int64_t id) {
    constexpr std::size_t kKept = 64;
    const auto found =
        std::find_if(meshes_.begin(), meshes_.end(), [id](const auto& entry) { return entry.first == id; });
    if (found != meshes_.end()) {
        meshes_.splice(meshes_.begin(), meshes_, found);
        return found->second;
    }
    core::Result<core::TriangleMesh> mesh = index_.load_display_mesh(id);
    auto shared = std::make_shared<const core::TriangleMesh>(mesh ? std::move(*mesh) : core::TriangleMesh{});
    meshes_.emplace_front(id, shared);
    if (meshes_.size() > kKept) meshes_.pop_back();
    return shared;
}

namespace {

core::Polygon ring_of(const core::ShapeDescriptor& shape, int part) {
    const core::Part& p = shape.parts[static_cast<std::size_t>(part)];
    const int n = static_cast<int>(shape.samples.size());
    core::Polygon ring;
    int i = p.start_sample;
    do {
        ring.push_back(shape.samples[static_cast<std::size_t>(i)]);
        i = (i + 1) % n;
    } while (i != p.end_sample);
    if (p.end_sample != p.start_sample) ring.push_back(shape.samples[static_cast<std::size_t>(p.end_sample)]);
    return ring;
}

/// Colours go to the parts of the drawing in order of size, so that the same part keeps its colour on every card.
std::vector<FoundPart> parts_of(const core::Match& match, const SketchDescription& query,
                                const core::ShapeDescriptor& view) {
    const core::ShapeDescriptor& drawn = query.shape.descriptor;
    std::vector<core::MatchedPair> pairs = match.pairs;
    const auto area = [&drawn](const core::MatchedPair& p) {
        return drawn.parts[static_cast<std::size_t>(p.part_a)].features[static_cast<std::size_t>(core::Feature::Area)];
    };
    std::stable_sort(pairs.begin(), pairs.end(),
                     [&](const core::MatchedPair& a, const core::MatchedPair& b) { return area(a) > area(b); });
    constexpr std::size_t kColours = 8;
    std::vector<FoundPart> parts;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        FoundPart part;
        part.colour = k < kColours ? static_cast<int>(k) : -1;
        part.on_drawing = ring_of(drawn, pairs[k].part_a);
        for (core::Point& p : part.on_drawing) p = query.to_drawing(p);
        part.on_view = ring_of(view, pairs[k].part_b);
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace

SearchAnswer SketchSearcher::search(const core::Drawing& drawing, std::stop_token stop) {
    const Stopwatch watch;
    const Readings readings = live_.all(drawing);
    return find(readings, watch.ms(), stop);
}

/// What the stroke is about to become counts more now than how else the drawing may be read, and the next answer is due
/// in a moment: one reading is looked for, in half the time.
SearchAnswer SketchSearcher::search_unfinished(const core::Drawing& drawing, std::stop_token stop) {
    const Stopwatch watch;
    core::Result<core::Silhouette> plain = live_.plain(drawing);
    if (!plain) return find(core::unexpected(plain.error()), watch.ms(), stop);
    auto closed = unfinished_.look_ahead(drawing, *plain);
    return find(std::vector{closed ? std::move(*closed) : std::move(*plain)}, watch.ms(), stop);
}

SearchAnswer SketchSearcher::find(const Readings& silhouettes, double silhouette_ms, const std::stop_token& stop) {
    SearchAnswer answer;
    if (!silhouettes) {
        answer.message_key = "too_little";
        return answer;
    }
    const core::Result<std::vector<SketchDescription>> readings = describe_silhouettes(*silhouettes, silhouette_ms);
    if (!readings) {
        answer.message_key = "too_little";
        return answer;
    }
    for (const SketchDescription& reading : *readings) {
        answer.silhouette_ms += reading.silhouette_ms;
        answer.describe_ms += reading.describe_ms;
    }
    const Stopwatch watch;
    const std::vector<core::ComparableShape> shapes = comparable(*readings);
    const std::vector<RankedModel> ranked =
        collection_.nearest(shapes, static_cast<std::size_t>(best_count_), jobs_, stop, likely_);
    if (stop.stop_requested()) return answer;
    likely_.clear();
    for (const RankedModel& r : ranked) likely_.push_back(r.model);
    for (const RankedModel& r : ranked) {
        const CollectionModel& model = collection_.models()[r.model];
        const auto view = static_cast<std::size_t>(r.view);
        const auto reading = static_cast<std::size_t>(r.reading);
        const core::Match match = matcher_.match(shapes[reading].parts, model.views[view].parts);
        FoundModel found;
        found.id = model.record.id;
        found.name = model.record.name;
        found.class_name = model.record.class_name;
        found.source = model.record.source_path;
        found.distance = r.distance;
        found.camera = model.record.views[view].camera;
        found.mirrored = match.reversed;
        found.parts = parts_of(match, (*readings)[reading], model.record.views[view].descriptor);
        answer.best.push_back(std::move(found));
    }
    answer.search_ms = watch.ms();
    for (FoundModel& found : answer.best) found.mesh = mesh_of(found.id);
    return answer;
}

}  // namespace app
