#pragma once
// One result made ready to be turned: part colours lifted onto its whole surface. Tens of milliseconds, so it is done
// on a thread of its own where frames are seen.

#include <cstdint>
#include <memory>
#include <vector>

#include "ui/draw/lifted_parts.hpp"
#include "ui/draw/model_stage.hpp"

namespace app {

/// What is asked: the model of a result and its surface, as its card has it.
struct DetailJob {
    std::uint64_t ticket = 0;
    std::shared_ptr<const ui::ModelGeometry> surface;
    core::Camera camera;  ///< the view that matched
    std::vector<ui::PartRegion> parts;
};

struct PreparedDetail {
    std::uint64_t ticket = 0;
    ui::LiftedModel lifted;
    std::vector<ui::GroundContact> contacts;
};

/// 10 to 60 ms. Needs no GL.
[[nodiscard]] PreparedDetail prepare_detail(const DetailJob& job);

}  // namespace app
