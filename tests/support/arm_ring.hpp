#pragma once
// Descriptors whose matching can be worked out on paper: parts on the arms of a cross, told apart by their area alone.

#include <algorithm>
#include <vector>

#include "core/parts/describe.hpp"
#include "support/shapes.hpp"

namespace support {

/// One terminal: an arm of the cross (0 right, 1 up, 2 left, 3 down) and its area.
struct ArmTerminal {
    int arm = 0;
    double area = 0.0;
};

/// A wing over `count` terminals from `first` on.
struct ArmWing {
    int first = 0;
    int count = 2;
    double area = 0.0;
};

/// On the cross of reach 5 and width 2, whose perimeter is 40 and whose inner corners are the samples 1, 4, 7 and 10.
/// All features but the area are 0 and so is the signature: with weight 1 two parts are at the distance of their areas,
/// and a part's norm is its area. Arms ascend.
inline core::ShapeDescriptor arm_ring(const std::vector<ArmTerminal>& terminals,
                                      const std::vector<ArmWing>& wings = {}) {
    core::ShapeDescriptor shape;
    shape.samples = cross(5, 2);
    shape.terminal_count = static_cast<int>(terminals.size());
    const auto add = [&](int first, int count, int first_arm, int last_arm, double area) {
        core::Part part;
        part.first_terminal = first;
        part.terminal_count = count;
        part.start_sample = 1 + 3 * first_arm;
        part.end_sample = (4 + 3 * last_arm) % 12;
        part.features[static_cast<std::size_t>(core::Feature::Area)] = static_cast<float>(area);
        shape.parts.push_back(part);
    };
    for (std::size_t t = 0; t < terminals.size(); ++t) {
        add(static_cast<int>(t), 1, terminals[t].arm, terminals[t].arm, terminals[t].area);
    }
    for (const ArmWing& wing : wings) {
        const auto last = static_cast<std::size_t>((wing.first + wing.count - 1) % shape.terminal_count);
        add(wing.first, wing.count, terminals[static_cast<std::size_t>(wing.first)].arm, terminals[last].arm,
            wing.area);
    }
    shape.stop_points = core::stop_points(shape.parts, shape.terminal_count, false);
    return shape;
}

}  // namespace support
