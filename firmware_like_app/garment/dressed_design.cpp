#include "firmware_like_app/garment/dressed_design.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/garment/texture.hpp"
#include "core/geometry/turn.hpp"
#include "core/mannequin/mannequin.hpp"

namespace app {
namespace {

using core::Vec3;

core::Result<core::DressForm> first_form(const core::Design& design) {
    const core::Result<core::Mannequin> body = core::make_mannequin(design.body);
    if (!body) return core::unexpected(body.error());
    return core::dress_form(*body);
}

void take_steps(core::DesignRunner& runner, DressedDesign& dressed) {
    for (std::size_t i = 0; i < dressed.design.steps.size(); ++i)
        if (const auto taken = runner.take(dressed.design.steps[i]); !taken) {
            dressed.garment.faults.push_back({static_cast<int>(i) + 1, taken.error().message});
            dressed.faults.push_back("step " + std::to_string(i + 1) + ": " + taken.error().message);
        }
}

/// All layers, and their cloth laid flat for fabrics.
void take_layers(const std::vector<core::BuiltLayer>& layers, DressedDesign& dressed) {
    for (const core::BuiltLayer& layer : layers) {
        dressed.garment.layers.push_back(*layer.cloth);
        core::lay_texture(dressed.garment.layers.back().fitted);
        for (const core::ClothFault& fault : layer.cloth->faults) {
            dressed.garment.faults.push_back({0, fault.region + ": " + fault.error.message});
            dressed.faults.push_back(fault.region + ": " + fault.error.message);
        }
    }
}

void take_objects(const ModelSource& models, DressedDesign& dressed) {
    for (const core::PlacedObject& object : dressed.look.objects) {
        const core::Result<core::TriangleMesh> model =
            models ? models(object.model)
                   : core::unexpected(core::ErrorCode::FileMissing, "there is no collection to take it from");
        if (model)
            dressed.objects.push_back({object.name, placed_mesh(object, *model)});
        else
            dressed.faults.push_back(object.name + ": " + model.error().sentence());
    }
}

}  // namespace

core::TriangleMesh placed_mesh(const core::PlacedObject& object, const core::TriangleMesh& model) {
    core::TriangleMesh placed = model;
    if (model.vertices.empty()) return placed;
    Vec3 low = model.vertices.front(), high = low;
    for (const Vec3& v : model.vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    const Vec3 middle = (low + high) * 0.5;
    for (Vec3& v : placed.vertices) v = object.at + core::turned((v - middle) * object.scale, object.turn);
    return placed;
}

core::Result<DressedDesign> dress(const core::Design& design, const core::FormSource& bodies, const ModelSource& models,
                                  const std::stop_token& stop) {
    const auto stopped = [] { return core::unexpected(core::ErrorCode::Cancelled, "the export was stopped"); };
    if (stop.stop_requested()) return stopped();
    const core::Result<core::DressForm> form = first_form(design);
    if (!form) return core::unexpected(form.error());
    core::Result<core::DesignRunner> runner = core::DesignRunner::start(design, *form, bodies);
    if (!runner) return core::unexpected(runner.error());
    DressedDesign dressed;
    dressed.design = design;
    take_steps(*runner, dressed);
    const std::vector<core::BuiltLayer> layers = runner->finish(stop);
    if (stop.stop_requested()) return stopped();
    dressed.garment.network = runner->network();
    dressed.look = runner->look();
    dressed.form = runner->worn()->form;
    take_layers(layers, dressed);
    take_objects(models, dressed);
    return dressed;
}

}  // namespace app
