#pragma once
// Steps as the desk makes them.

#include <string>

#include "core/garment/design.hpp"

namespace core {

[[nodiscard]] inline DesignStep step_of(DesignStep::Kind kind) {
    DesignStep step;
    step.kind = kind;
    return step;
}

[[nodiscard]] inline DesignStep region_step(DesignStep::Kind kind, const std::string& region) {
    DesignStep step = step_of(kind);
    step.region = region;
    return step;
}

[[nodiscard]] inline DesignStep layer_step(DesignStep::Kind kind, int layer) {
    DesignStep step = step_of(kind);
    step.layer = layer;
    return step;
}

}  // namespace core
