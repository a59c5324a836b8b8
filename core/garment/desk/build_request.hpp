#pragma once
// Cloth made on another thread: a request holds all that it needs by value, a result is handed back to the desk.
//
//     if (auto request = desk.build_request()) worker.give(*request);      // the newest wins
//     core::BuildResult result = core::build(request, stop);                // on the worker
//     desk.accept(std::move(result));                                       // back on the screen's thread

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/garment/design.hpp"
#include "core/garment/desk/desk_tool.hpp"

namespace core {

struct BuildRequest {
    DesignRunner state;
    std::uint64_t number = 0;        ///< of the state of the desk; a later one has a higher number
    std::optional<DesignStep> body;  ///< a Body step to try on, while its slider moves
};

struct BuildResult {
    std::uint64_t number = 0;
    bool complete = false;                  ///< false when it was stopped
    bool trial = false;                     ///< for BuildRequest::body
    std::vector<BuiltLayer> layers;         ///< inner ones first
    std::vector<DeskNote> faults;           ///< NotFilled and LayersTouch, with the piece or layer and the place
    std::shared_ptr<const DressForm> form;  ///< that it is worn by
};

/// Some 100 ms for a layer of 10,000 vertices that changed; layers that did not change cost nothing. Looks at `stop`
/// between layers.
[[nodiscard]] BuildResult build(const BuildRequest& request, const std::stop_token& stop);

}  // namespace core
