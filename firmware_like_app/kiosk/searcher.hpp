#pragma once
// What the kiosk asks of the search: one drawing in, the best models with their matched parts out.

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/point.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "core/stroke/stroke.hpp"
#include "core/views/camera.hpp"

namespace app {

/// A part that the drawing and the model share, or a part of the model that found no partner.
struct FoundPart {
    int colour = -1;           ///< 0 … 7 in order of size; -1: no partner, or the ninth and further parts
    core::Polygon on_drawing;  ///< units of the drawing, y down like its strokes; empty where it has no partner
    core::Polygon on_view;     ///< image plane of the camera, [-1, 1], y up
};

struct FoundModel {
    std::int64_t id = 0;
    std::string name;
    std::string class_name;
    std::string source;  ///< what the collection knows it by, no other model has it; empty: its name
    double distance = 0;
    std::shared_ptr<const core::TriangleMesh> mesh;  ///< normalised frame, see core/views/camera.hpp
    core::Camera camera;                             ///< the view that matched
    bool mirrored = false;                           ///< matched the mirror image: its picture is shown flipped
    std::vector<FoundPart> parts;
};

struct SearchAnswer {
    std::vector<FoundModel> best;  ///< best first; the kiosk shows nine
    std::string message_key;       ///< "too_little", "nothing_close" or empty
    double silhouette_ms = 0, describe_ms = 0, search_ms = 0;
};

/// Called from one worker thread, never twice at a time.
class Searcher {
  public:
    virtual ~Searcher() = default;
    /// The drawing is never empty. When `stop` is requested the answer is no longer wanted: return soon, with anything.
    virtual SearchAnswer search(const core::Drawing& drawing, std::stop_token stop) = 0;
    /// The same while the last stroke is still being drawn: may answer for what the drawing is about to become, and
    /// with less thought, for the next question follows at once.
    virtual SearchAnswer search_unfinished(const core::Drawing& drawing, std::stop_token stop) {
        return search(drawing, std::move(stop));
    }
};

}  // namespace app
