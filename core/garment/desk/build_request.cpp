#include "core/garment/desk/build_request.hpp"

#include "core/garment/desk/pick.hpp"

namespace core {
namespace {

/// The middle of a region's outline, for a note; the origin for a name that is none.
Vec3 place_of(const Network& network, const std::string& region) {
    const NetworkRegion* found = network.find_region(region);
    if (found == nullptr) return {};
    const SpaceLine ring = ring_line(network, found->ring);
    Vec3 sum;
    for (const Vec3& p : ring) sum = sum + p;
    return ring.empty() ? sum : sum * (1.0 / static_cast<double>(ring.size()));
}

/// The deepest vertex of a layer inside what is below it, or its first.
Vec3 clash_place(const Cloth& cloth, const Obstacle& body) {
    Vec3 place;
    double least = 1e9;
    for (const Vec3& v : cloth.mesh.vertices)
        if (const double d = body.distance(v); d < least) least = d, place = v;
    return place;
}

}  // namespace

BuildResult build(const BuildRequest& request, const std::stop_token& stop) {
    BuildResult result;
    result.number = request.number;
    result.trial = request.body.has_value();
    DesignRunner state = request.state;
    if (request.body) {
        if (const Result<DesignStep> worn = state.take(*request.body); !worn)
            result.faults.push_back({DeskNote::Key::BodyUnfit, worn.error().message, {}, {}, 0.0});
    }
    if (stop.stop_requested()) return result;
    result.layers = state.finish(stop);
    result.form = {state.worn(), &state.worn()->form};
    result.complete = result.layers.size() == state.look().order.size();
    for (const BuiltLayer& layer : result.layers) {
        for (const ClothFault& fault : layer.cloth->faults)
            result.faults.push_back({DeskNote::Key::NotFilled, "Cloth could not be filled here: " + fault.error.message,
                                     place_of(state.network(), fault.region), fault.region, 0.0});
        if (std::string clash = fitting_warning(layer.cloth->report); !clash.empty())
            result.faults.push_back({DeskNote::Key::LayersTouch, std::move(clash),
                                     clash_place(layer.cloth->fitted, state.worn()->obstacle),
                                     std::to_string(layer.layer), 0.0});
    }
    return result;
}

}  // namespace core
