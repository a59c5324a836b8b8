#include "core/parts/describe.hpp"

#include "core/parts/features.hpp"
#include "core/parts/wings.hpp"

namespace core {

std::vector<int> stop_points(const std::vector<Part>& parts, int terminal_count, bool backwards) {
    std::vector<char> may_start(static_cast<std::size_t>(terminal_count), 1);
    for (const Part& part : parts) {
        for (int k = 0; k < part.terminal_count; ++k) {
            const bool at_start = backwards ? k == part.terminal_count - 1 : k == 0;
            if (!at_start) may_start[static_cast<std::size_t>((part.first_terminal + k) % terminal_count)] = 0;
        }
    }
    std::vector<int> points;
    for (int t = 0; t < terminal_count; ++t) {
        if (may_start[static_cast<std::size_t>(t)] != 0) points.push_back(t);
    }
    // Both directions cut the ring at the same place, so that a mirror image reads the same.
    if (points.empty() && terminal_count > 0) points.push_back(backwards ? terminal_count - 1 : 0);
    return points;
}

Result<DescribedShape> describe_in_steps(const Polygon& contour, const ShapeParameters& p) {
    Result<Skeleton> skeleton = skeletonise(contour, p);
    if (!skeleton) return unexpected(skeleton.error());
    DescribedShape shape;
    shape.skeleton = std::move(*skeleton);
    shape.tree = part_tree(shape.skeleton, p);
    ShapeDescriptor& d = shape.descriptor;
    d.samples = shape.skeleton.samples;
    d.skeletal_length = shape.skeleton.skeletal_length;
    d.whole = measure_part(d.samples, shape.skeleton.arcs, {0, 0}, p);
    d.parts = parts_of(shape.skeleton, shape.tree, p);
    d.terminal_count = 0;
    for (const CatNode& node : shape.skeleton.graph.nodes) d.terminal_count += node.kind == PieceKind::Terminal ? 1 : 0;
    if (d.terminal_count < 2) {
        d.parts.assign(1, d.whole);
        d.terminal_count = 1;
    }
    d.stop_points = stop_points(d.parts, d.terminal_count, false);
    return shape;
}

Result<ShapeDescriptor> describe(const Polygon& contour, const ShapeParameters& p) {
    Result<DescribedShape> shape = describe_in_steps(contour, p);
    if (!shape) return unexpected(shape.error());
    return std::move(shape->descriptor);
}

}  // namespace core
