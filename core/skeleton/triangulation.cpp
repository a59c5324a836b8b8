#include "core/skeleton/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <exception>
#include <map>
#include <utility>

namespace core {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<char, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

/// Marks every face outside the constrained ring, from the infinite face inwards.
void mark_outside(Cdt& cdt) {
    for (auto face = cdt.all_faces_begin(); face != cdt.all_faces_end(); ++face) face->info() = 0;
    std::vector<Cdt::Face_handle> open{cdt.infinite_face()};
    open.front()->info() = 1;
    while (!open.empty()) {
        const Cdt::Face_handle face = open.back();
        open.pop_back();
        for (int i = 0; i < 3; ++i) {
            const Cdt::Face_handle next = face->neighbor(i);
            if (face->is_constrained(i) || next->info() != 0) continue;
            next->info() = 1;
            open.push_back(next);
        }
    }
}

std::vector<std::array<int, 3>> inner_triangles(const Polygon& ring) {
    Cdt cdt;
    std::vector<Cdt::Vertex_handle> handles;
    handles.reserve(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
        handles.push_back(
            cdt.insert(Kernel::Point_2(ring[i].x, ring[i].y), i > 0 ? handles.back()->face() : Cdt::Face_handle()));
        handles.back()->info() = static_cast<int>(i);
    }
    for (std::size_t i = 0; i < handles.size(); ++i)
        cdt.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
    mark_outside(cdt);
    std::vector<std::array<int, 3>> triangles;
    for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
        if (face->info() != 0) continue;
        std::array<int, 3> t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::sort(t.begin(), t.end());
        triangles.push_back(t);
    }
    std::sort(triangles.begin(),
              triangles.end());  // CGAL's order depends on the order of insertion only, ours on nothing
    return triangles;
}

bool on_outline(int u, int v, int n) {
    return v == u + 1 || (u == 0 && v == n - 1);
}

Triangulation with_chords(const std::vector<std::array<int, 3>>& triangles, int n) {
    Triangulation out;
    std::map<std::pair<int, int>, int> index;
    for (const auto& t : triangles) {
        for (const auto& [u, v] : {std::pair{t[0], t[1]}, std::pair{t[1], t[2]}, std::pair{t[0], t[2]}}) {
            if (!on_outline(u, v, n)) index.emplace(std::pair{u, v}, 0);
        }
    }
    for (auto& [ends, id] : index) {
        id = static_cast<int>(out.chords.size());
        out.chords.push_back({ends.first, ends.second, -1, -1});
    }
    const auto chord_of = [&](int u, int v) { return on_outline(u, v, n) ? -1 : index.at({u, v}); };
    for (const auto& t : triangles) {
        const int id = static_cast<int>(out.triangles.size());
        const Triangle triangle{t, {chord_of(t[0], t[1]), chord_of(t[1], t[2]), chord_of(t[0], t[2])}};
        // The third vertex of (0,1) and of (1,2) lies outside the arc u → v, that of (0,2) inside.
        if (triangle.chords[0] >= 0) out.chords[static_cast<std::size_t>(triangle.chords[0])].outer = id;
        if (triangle.chords[1] >= 0) out.chords[static_cast<std::size_t>(triangle.chords[1])].outer = id;
        if (triangle.chords[2] >= 0) out.chords[static_cast<std::size_t>(triangle.chords[2])].inner = id;
        out.triangles.push_back(triangle);
    }
    return out;
}

}  // namespace

Result<Triangulation> triangulate(const Polygon& ring) {
    if (ring.size() < 3) return unexpected(ErrorCode::BadOutline, "an outline needs three samples at least");
    try {
        const std::vector<std::array<int, 3>> triangles = inner_triangles(ring);
        if (triangles.size() + 2 != ring.size()) {
            return unexpected(ErrorCode::BadOutline,
                              "the outline crosses or touches itself and cannot be triangulated");
        }
        return with_chords(triangles, static_cast<int>(ring.size()));
    } catch (const std::exception&) {  // CGAL reports crossing constraints so
        return unexpected(ErrorCode::BadOutline, "the outline crosses itself and cannot be triangulated");
    }
}

std::vector<int> chords_along_outline(const Triangulation& triangulation, int sample_count) {
    const int n = sample_count;
    std::vector<std::vector<std::pair<int, int>>> at(static_cast<std::size_t>(n));  // (steps ahead, chord)
    for (std::size_t c = 0; c < triangulation.chords.size(); ++c) {
        const Chord& chord = triangulation.chords[c];
        at[static_cast<std::size_t>(chord.u)].emplace_back(chord.v - chord.u, static_cast<int>(c));
        at[static_cast<std::size_t>(chord.v)].emplace_back(chord.u - chord.v + n, static_cast<int>(c));
    }
    std::vector<int> order;
    order.reserve(triangulation.chords.size() * 2);
    for (auto& fan : at) {
        std::sort(fan.begin(), fan.end(), std::greater<>());
        for (const auto& [ahead, chord] : fan) order.push_back(chord);
    }
    return order;
}

}  // namespace core
