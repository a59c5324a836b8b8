#include "core/skeleton/cat_graph.hpp"

#include <algorithm>
#include <functional>

namespace core {

namespace {

Point centroid_of(const Polygon& samples, const Triangulation& t, const Piece& piece) {
    const Point origin = samples.front();
    double area = 0.0;
    Point moment;
    for (const int id : piece.triangles) {
        const auto& v = t.triangles[static_cast<std::size_t>(id)].vertices;
        const Point a = samples[static_cast<std::size_t>(v[0])] - origin;
        const Point b = samples[static_cast<std::size_t>(v[1])] - origin;
        const Point c = samples[static_cast<std::size_t>(v[2])] - origin;
        const double w = std::abs(cross(b - a, c - a));
        area += w;
        moment = moment + (a + b + c) * (w / 3.0);
    }
    return area > 0.0 ? origin + moment * (1.0 / area) : origin;
}

}  // namespace

CatGraph cat_graph(const Polygon& samples, const Triangulation& triangulation, const Segmentation& s) {
    CatGraph graph;
    const auto middle = [&](int chord) {
        const Chord& c = triangulation.chords[static_cast<std::size_t>(chord)];
        return midpoint(samples[static_cast<std::size_t>(c.u)], samples[static_cast<std::size_t>(c.v)]);
    };
    for (std::size_t i = 0; i < s.pieces.size(); ++i) {
        const Piece& piece = s.pieces[i];
        const int id = static_cast<int>(i);
        CatNode node{piece.kind(), {}, piece.chords, centroid_of(samples, triangulation, piece)};
        for (const int chord : piece.chords) node.neighbours.push_back(s.neighbour(id, chord, triangulation));
        if (node.kind == PieceKind::Sleeve) {
            graph.skeleton.push_back({id, middle(piece.chords[0]), middle(piece.chords[1])});
        } else {
            for (const int chord : piece.chords) graph.skeleton.push_back({id, middle(chord), node.centroid});
        }
        graph.nodes.push_back(std::move(node));
    }
    return graph;
}

double skeletal_length(const CatGraph& graph) {
    std::vector<std::vector<double>> of_node(graph.nodes.size());
    for (const SkeletalSegment& s : graph.skeleton) {
        of_node[static_cast<std::size_t>(s.node)].push_back(distance(s.from, s.to));
    }
    double total = 0.0;
    for (auto& lengths : of_node) {
        std::sort(lengths.begin(), lengths.end(), std::greater<>());
        if (lengths.size() > 3) lengths.resize(3);
        for (const double l : lengths) total += l;
    }
    return total;
}

}  // namespace core
