#include "firmware_like_app/collection/model_views.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

#include "core/contour/contour_descriptor.hpp"
#include "core/exchange/png_writer.hpp"
#include "core/match/match.hpp"
#include "core/mesh/compact.hpp"
#include "core/mesh/normalise.hpp"
#include "core/mesh/simplify.hpp"
#include "core/silhouette/contour.hpp"
#include "core/views/cameras.hpp"
#include "core/views/silhouette_render.hpp"
#include "core/views/view_choice.hpp"

namespace app {

std::string parameters_text(const ViewParameters& v) {
    constexpr int kDescriberVersion = 5;  // raise when the same parameters lead to another descriptor
    const core::ShapeParameters& p = v.shape;
    char text[512];
    std::snprintf(text, sizeof text,
                  "describer %d; px %d; longest %d; display %zu; thumbnail %dx%d; contour %d %g; window %d; extent "
                  "%g; samples %d; scale %g; "
                  "insignificant %g %g %g %g; large %g; long %g %g %g %g; bent %d %g %g; unit %g; block %d; depth %g "
                  "%g; wing %d %g",
                  kDescriberVersion, v.silhouette_px, v.longest, v.display_triangles, v.thumbnail.width_px,
                  v.thumbnail.height_px, p.contour_points, p.contour_sigma, p.window, p.extent, p.sample_size,
                  p.scale_coef, p.small_area, p.thresh_small_clr, p.thresh_any_clr, p.sharp_turn_deg, p.large_t,
                  p.small_long_t, p.small_et, p.large_long_t, p.large_et, p.n_pockets, p.size_bent_t, p.convexity_t,
                  p.signature_unit, p.junction_block_limit, p.depth_threshold_first, p.depth_threshold_step,
                  p.wing_salient_limit, p.wing_step);
    return text;
}

namespace {

/// The contour of one view in the image plane; nothing where the model shows nothing.
std::optional<core::Polygon> outline_in_plane(const core::TriangleMesh& mesh, int camera, int px) {
    const core::BinaryImage image =
        core::render_silhouette(mesh, core::cameras()[static_cast<std::size_t>(camera)], px);
    core::Result<core::Polygon> contour = core::largest_contour(image);
    if (!contour) return std::nullopt;
    for (core::Point& p : *contour) p = core::to_image_plane({p.x + 0.5, 0.5 - p.y}, px);
    return std::move(*contour);
}

}  // namespace

core::Result<void> describe_model(core::TriangleMesh mesh, const ViewParameters& parameters, db::ModelRecord& record,
                                  const std::stop_token& stop) {
    const core::Result<core::TriangleMesh> normal = core::normalised_mesh(std::move(mesh));
    if (!normal) return core::unexpected(normal.error());
    std::map<int, db::ModelView> described;
    std::vector<core::ViewCandidate> candidates;
    for (const int camera : core::representative_cameras()) {
        if (stop.stop_requested()) {
            return core::unexpected(core::ErrorCode::Cancelled, "describing the model was interrupted; try again");
        }
        std::optional<core::Polygon> outline = outline_in_plane(*normal, camera, parameters.silhouette_px);
        if (!outline) continue;
        core::Result<core::ShapeDescriptor> descriptor = core::describe(*outline, parameters.shape);
        if (!descriptor) continue;
        db::ModelView view;
        view.camera = core::cameras()[static_cast<std::size_t>(camera)];
        view.camera_number = camera;
        view.skeletal_length = descriptor->skeletal_length;
        view.outline = std::move(*outline);
        view.descriptor = std::move(*descriptor);
        candidates.push_back({camera, view.skeletal_length});
        described.emplace(camera, std::move(view));
    }
    core::Matcher matcher;
    const auto asymmetry = [&](const core::ViewCandidate& c) {
        db::ModelView& view = described.at(c.camera);
        view.asymmetry = matcher.asymmetry(core::matchable(view.descriptor, parameters.shape));
        return view.asymmetry;
    };
    const core::Result<core::ChosenViews> chosen = core::choose_views(candidates, asymmetry, parameters.longest);
    if (!chosen) return core::unexpected(chosen.error());
    record.views = {described.at(chosen->first), described.at(chosen->second)};
    for (db::ModelView& view : record.views) {
        const core::Result<core::ContourDescriptor> contour = core::describe_contour(view.outline);
        if (!contour) return core::unexpected(contour.error());
        view.contour = *contour;
        view.outline = view.descriptor.samples;
    }
    core::Result<core::TriangleMesh> display = core::simplified_mesh(*normal, parameters.display_triangles);
    if (!display) return core::unexpected(display.error());
    record.display_mesh = core::without_unused_vertices(*display);
    for (core::Vec3& v : record.display_mesh.vertices) {  // where a merged vertex lies a little outside its faces
        v = {std::clamp(v.x, -1.0, 1.0), std::clamp(v.y, -1.0, 1.0), std::clamp(v.z, -1.0, 1.0)};
    }
    for (db::ModelView& view : record.views) {
        core::Result<std::vector<std::byte>> png =
            core::png_bytes(core::render_picture(record.display_mesh, view.camera, parameters.thumbnail));
        if (!png) return core::unexpected(png.error());
        view.thumbnail = std::move(*png);
    }
    return {};
}

}  // namespace app
