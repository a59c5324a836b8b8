#include "core/parts/wings.hpp"

#include <algorithm>

#include "core/parts/features.hpp"

namespace core {

namespace {

Arc arc_of_node(const Skeleton& s, int node, int chord) {
    return arc_behind(s.pieces, s.triangulation, node, chord);
}

/// A terminal piece and the part measured on it.
struct Tip {
    int node = 0;
    Part part;
};

std::vector<Tip> terminals_in_order(const Skeleton& s, const ShapeParameters& p) {
    std::vector<Tip> tips;
    for (std::size_t i = 0; i < s.graph.nodes.size(); ++i) {
        const CatNode& node = s.graph.nodes[i];
        if (node.kind != PieceKind::Terminal) continue;
        const int id = static_cast<int>(i);
        Part part = measure_part(s.samples, s.arcs, arc_of_node(s, id, node.chords[0]), p);
        part.salient = is_salient(s.samples, s.arcs, part, p);
        tips.push_back({id, part});
    }
    std::sort(tips.begin(), tips.end(),
              [](const Tip& a, const Tip& b) { return a.part.start_sample < b.part.start_sample; });
    for (std::size_t k = 0; k < tips.size(); ++k) tips[k].part.first_terminal = static_cast<int>(k);
    return tips;
}

}  // namespace

std::vector<Part> parts_of(const Skeleton& skeleton, const PartTree& tree, const ShapeParameters& p) {
    std::vector<Tip> tips = terminals_in_order(skeleton, p);
    const int terminal_count = static_cast<int>(tips.size());
    std::vector<int> salient(skeleton.graph.nodes.size(), 0);  // salient terminals in the subtree of each node
    std::vector<int> grouped(skeleton.graph.nodes.size(), 0);  // terminals in the subtree
    std::vector<Part> parts;
    for (const Tip& tip : tips) {
        parts.push_back(tip.part);
        salient[static_cast<std::size_t>(tip.node)] = tip.part.salient ? 1 : 0;
        grouped[static_cast<std::size_t>(tip.node)] = 1;
    }
    if (tree.root < 0) return parts;
    const auto first_terminal_from = [&](int sample) {
        const int n = skeleton.arcs.count();
        int best = 0;
        for (int k = 0; k < terminal_count; ++k) {
            const auto ahead = [&](int t) {
                return (parts[static_cast<std::size_t>(t)].start_sample - sample + n) % n;
            };
            if (ahead(k) < ahead(best)) best = k;
        }
        return best;
    };
    for (const int id : tree.bottom_up) {
        const auto node = static_cast<std::size_t>(id);
        if (skeleton.graph.nodes[node].kind != PieceKind::Terminal) {
            Part wing =
                measure_part(skeleton.samples, skeleton.arcs, arc_of_node(skeleton, id, tree.parent_chord[node]), p);
            wing.salient = is_salient(skeleton.samples, skeleton.arcs, wing, p);
            wing.first_terminal = first_terminal_from(wing.start_sample);
            wing.terminal_count = grouped[node];
            if (wing.salient) salient[node] = std::max(salient[node], 1);
            const auto repeats = [&](const Part& other) {
                return other.first_terminal == wing.first_terminal && other.terminal_count == wing.terminal_count &&
                       std::abs(other.features[1] - wing.features[1]) < p.wing_step;
            };
            if (salient[node] <= p.wing_salient_limit && std::none_of(parts.begin(), parts.end(), repeats))
                parts.push_back(wing);
        }
        const auto parent = static_cast<std::size_t>(tree.parent[node]);
        salient[parent] += salient[node];
        grouped[parent] += grouped[node];
    }
    std::stable_sort(parts.begin() + terminal_count, parts.end(), [](const Part& a, const Part& b) {
        return a.first_terminal != b.first_terminal ? a.first_terminal < b.first_terminal
                                                    : a.terminal_count < b.terminal_count;
    });
    return parts;
}

}  // namespace core
