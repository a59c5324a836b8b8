#include "core/parts/depth.hpp"

#include <algorithm>

namespace core {

namespace {

/// The simulation: which nodes are terminals by now, and how large the compound behind each is.
class Merging {
  public:
    Merging(const Skeleton& skeleton, const ShapeParameters& p) : skeleton_(skeleton), parameters_(p) {
        for (const CatNode& node : skeleton.graph.nodes) {
            terminal_.push_back(node.kind == PieceKind::Terminal || node.kind == PieceKind::Whole ? 1 : 0);
            interior_left_ += terminal_.back() != 0 ? 0 : 1;
            junctions_left_ += node.kind == PieceKind::Junction ? 1 : 0;
        }
        iteration_.assign(terminal_.size(), -1);
    }

    /// Runs to the last interior node, which is returned; -1 when there is none.
    int run() {
        for (int k = 0; interior_left_ > 1; ++k) {
            threshold_ = parameters_.depth_threshold_first + k * parameters_.depth_threshold_step;
            for (bool merged = true; merged && interior_left_ > 1;) merged = merge_smallest(k);
        }
        for (std::size_t i = 0; i < terminal_.size(); ++i) {
            if (terminal_[i] == 0) return static_cast<int>(i);
        }
        return -1;
    }

    [[nodiscard]] const std::vector<int>& iteration() const { return iteration_; }

  private:
    struct Size {
        double area = 0.0, perimeter = 0.0;  // per cent
    };

    [[nodiscard]] const CatNode& node(int i) const { return skeleton_.graph.nodes[static_cast<std::size_t>(i)]; }
    [[nodiscard]] bool is_terminal(int i) const { return terminal_[static_cast<std::size_t>(i)] != 0; }

    /// Size of what hangs behind `chord`, seen from `from`.
    [[nodiscard]] Size size_behind(int from, int chord) const {
        const int behind = skeleton_.pieces.neighbour(from, chord, skeleton_.triangulation);
        const Arc arc = arc_behind(skeleton_.pieces, skeleton_.triangulation, behind, chord);
        return {100.0 * skeleton_.arcs.area(arc.from, arc.to) / skeleton_.arcs.area(),
                100.0 * skeleton_.arcs.length(arc.from, arc.to) / skeleton_.arcs.perimeter()};
    }

    [[nodiscard]] bool can_merge(int i) const {
        if (is_terminal(i)) return false;
        if (node(i).kind == PieceKind::Junction && junctions_left_ == 1) return false;
        int others = 0;
        for (std::size_t k = 0; k < node(i).neighbours.size(); ++k) {
            if (!is_terminal(node(i).neighbours[k])) {
                ++others;
                continue;
            }
            const Size size = size_behind(i, node(i).chords[k]);
            if (size.area >= threshold_ || size.perimeter >= threshold_) return false;
        }
        return others == 1;
    }

    /// Size of the compound that node i would become.
    [[nodiscard]] double compound_size(int i) const {
        for (std::size_t k = 0; k < node(i).neighbours.size(); ++k) {
            if (is_terminal(node(i).neighbours[k])) continue;
            const Size rest = size_behind(i, node(i).chords[k]);
            return (100.0 - rest.area) + (100.0 - rest.perimeter);
        }
        return 200.0;
    }

    /// Smaller compounds first, so that of two last neighbours the larger one remains; one node per call.
    bool merge_smallest(int k) {
        int smallest = -1;
        double size = 0.0;
        for (int i = 0; i < static_cast<int>(terminal_.size()); ++i) {
            if (!can_merge(i)) continue;
            const double candidate = compound_size(i);
            if (smallest < 0 || candidate < size) {
                smallest = i;
                size = candidate;
            }
        }
        if (smallest < 0) return false;
        terminal_[static_cast<std::size_t>(smallest)] = 1;
        iteration_[static_cast<std::size_t>(smallest)] = k;
        --interior_left_;
        junctions_left_ -= node(smallest).kind == PieceKind::Junction ? 1 : 0;
        return true;
    }

    const Skeleton& skeleton_;
    const ShapeParameters& parameters_;
    std::vector<char> terminal_;
    std::vector<int> iteration_;
    int interior_left_ = 0;
    int junctions_left_ = 0;
    double threshold_ = 0.0;
};

}  // namespace

PartTree part_tree(const Skeleton& skeleton, const ShapeParameters& parameters) {
    const auto& nodes = skeleton.graph.nodes;
    PartTree tree;
    Merging merging(skeleton, parameters);
    tree.root = merging.run();
    tree.iteration = merging.iteration();
    tree.parent.assign(nodes.size(), -1);
    tree.parent_chord.assign(nodes.size(), -1);
    tree.depth.assign(nodes.size(), -1);
    if (tree.root < 0) return tree;
    std::vector<int> top_down{tree.root};
    tree.depth[static_cast<std::size_t>(tree.root)] = 0;
    for (std::size_t k = 0; k < top_down.size(); ++k) {
        const auto here = static_cast<std::size_t>(top_down[k]);
        for (std::size_t e = 0; e < nodes[here].neighbours.size(); ++e) {
            const auto next = static_cast<std::size_t>(nodes[here].neighbours[e]);
            if (tree.depth[next] >= 0) continue;
            tree.depth[next] = tree.depth[here] + 1;
            tree.parent[next] = top_down[k];
            tree.parent_chord[next] = nodes[here].chords[e];
            top_down.push_back(static_cast<int>(next));
        }
    }
    tree.bottom_up.assign(top_down.rbegin(), top_down.rend() - 1);
    return tree;
}

}  // namespace core
