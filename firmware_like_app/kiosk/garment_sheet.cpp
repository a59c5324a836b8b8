#include "firmware_like_app/kiosk/garment_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>

namespace app {
namespace {

using Kind = ui::SheetLine::Kind;

constexpr double kStep_cm = 0.8;  // between points whose visibility is asked for

Kind kind_of(const core::DesignStep& step) {
    if (step.kind != core::DesignStep::Kind::Line || step.stroke.empty()) return Kind::Plane;
    switch (step.stroke.back().tool.kind) {
        case core::DrawingTool::Kind::Body:
            return Kind::Body;
        case core::DrawingTool::Kind::Temporary:
            return Kind::Temporary;
        default:
            return Kind::Plane;
    }
}

std::map<std::string, Kind> kinds_of(const core::GarmentDesk& desk) {
    std::map<std::string, Kind> kinds;
    desk.each_step([&](const core::DesignStep& step) {
        if (step.kind == core::DesignStep::Kind::Line) kinds[step.name] = kind_of(step);
    });
    return kinds;
}

std::set<std::string> pieces_in_cloth(const core::GarmentDesk& desk) {
    std::set<std::string> names;
    for (const core::BuiltLayer& layer : desk.cloth()) {
        if (!layer.cloth) continue;
        for (const core::ClothPiece& piece : layer.cloth->fitted.pieces) names.insert(piece.name);
    }
    return names;
}

/// Lines of the network that bound cloth which is there, and those of one piece.
std::set<int> lines_of(const core::Network& network, const std::set<std::string>& pieces) {
    std::set<int> lines;
    for (const core::NetworkRegion& region : network.regions()) {
        if (!region.alive || pieces.count(region.name) == 0) continue;
        for (const core::LineUse use : region.ring) lines.insert(use.line);
    }
    return lines;
}

core::SpaceLine dense(const core::SpaceLine& line) {
    const double length = core::line_length(line);
    const int edges = std::clamp(static_cast<int>(std::ceil(length / kStep_cm)), 1, 600);
    return core::resampled(line, edges);
}

core::SpaceLine mirrored(core::SpaceLine line) {
    for (core::Vec3& p : line) p.x = -p.x;
    return line;
}

}  // namespace

void add_projected(std::vector<ui::SheetLine>& out, const core::SpaceLine& line, FigureViews& views, Kind kind,
                   bool selected) {
    if (line.size() < 2) return;
    ui::SheetLine run;
    run.kind = kind;
    run.selected = selected;
    for (const core::Vec3& place : dense(line)) {
        const bool hidden = views.hides(place);
        const core::Point px = views.camera().to_px(place);
        if (!run.px.empty() && hidden != run.dimmed) {
            run.px.push_back(px);  // stretches join
            out.push_back(run);
            run.px.clear();
        }
        run.dimmed = hidden;
        run.px.push_back(px);
    }
    if (run.px.size() > 1) out.push_back(std::move(run));
}

/// Edges joined to lines as long as they go on.
std::vector<core::SpaceLine> chained(const std::vector<std::array<std::uint32_t, 2>>& edges,
                                     const std::vector<core::Vec3>& places) {
    std::multimap<std::uint32_t, std::size_t> at;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        at.emplace(edges[i][0], i);
        at.emplace(edges[i][1], i);
    }
    std::vector<bool> used(edges.size());
    std::vector<core::SpaceLine> lines;
    const auto walk = [&](std::uint32_t from, std::size_t edge) {
        core::SpaceLine line{places[from]};
        for (bool on = true; on;) {
            used[edge] = true;
            from = edges[edge][0] == from ? edges[edge][1] : edges[edge][0];
            line.push_back(places[from]);
            on = false;
            const auto [first, last] = at.equal_range(from);
            if (std::distance(first, last) != 2) break;  // an end, or where lines meet
            for (auto it = first; it != last; ++it) {
                if (used[it->second]) continue;
                edge = it->second;
                on = true;
            }
        }
        lines.push_back(std::move(line));
    };
    for (const bool rings : {false, true}) {  // lines from their ends first, then what has none
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (const std::uint32_t end : edges[i]) {
                if (!used[i] && (rings || at.count(end) != 2)) walk(end, i);
            }
        }
    }
    return lines;
}

void add_cloth_edges(std::vector<ui::SheetLine>& out, const core::GarmentDesk& desk, FigureViews& views) {
    const core::DesignLook& look = desk.state().look();
    for (const core::BuiltLayer& layer : desk.cloth()) {
        const auto number = static_cast<std::size_t>(layer.layer);
        if (!layer.cloth || (number < look.layers.size() && !look.layers[number].shown)) continue;
        const core::Cloth& cloth = layer.cloth->fitted;
        const std::vector<core::Vec3>* live = views.places_of(layer.layer);
        const std::vector<core::Vec3>& places = live != nullptr ? *live : cloth.mesh.vertices;
        const core::ClothEdges edges = core::edges_of(cloth);
        for (const auto* some : {&edges.hems, &edges.seams}) {
            for (const core::SpaceLine& line : chained(*some, places)) {
                add_projected(out, line, views, Kind::Seam, false);
            }
        }
    }
}

std::vector<core::DeskNote> open_middles(const core::GarmentDesk& desk) {
    std::vector<core::DeskNote> middles;
    for (core::DeskNote& note : desk.open_places()) {
        if (note.key == core::DeskNote::Key::OpenMiddle) middles.push_back(std::move(note));
    }
    return middles;
}

SheetDrawing draw_sheet(const core::GarmentDesk& desk, FigureViews& views, const SheetWishes& wishes) {
    SheetDrawing out;
    const core::Network& network = desk.network();
    const bool mirror = desk.state().look().mirror;
    const std::map<std::string, Kind> kinds = kinds_of(desk);
    const std::set<int> in_cloth = lines_of(network, pieces_in_cloth(desk));
    add_cloth_edges(out.lines, desk, views);
    std::vector<core::Vec3> open;
    for (const core::DeskNote& note : desk.open_places()) {
        out.open_ends_px.push_back(views.camera().to_px(note.place));
        open.push_back(note.place);
    }
    if (const std::vector<core::DeskNote> middles = open_middles(desk); middles.size() > 1) {
        out.open_middle = middles.front().place;
    }
    std::set<int> strong_ends;
    for (std::size_t i = 0; i < network.lines().size(); ++i) {
        const core::NetworkLine& line = network.lines()[i];
        if (!line.alive || line.layer != desk.layer()) continue;
        const bool meshed = in_cloth.count(static_cast<int>(i)) > 0;
        const auto known = kinds.find(line.name);
        const Kind drawn = known != kinds.end() ? known->second : Kind::Plane;
        const bool selected = !wishes.selected_line.empty() && line.name == wishes.selected_line;
        if (mirror && !meshed) add_projected(out.lines, mirrored(line.shape), views, Kind::Mirrored, false);
        if (meshed && !wishes.shaping && !selected) continue;  // its cloth shows it
        add_projected(out.lines, line.shape, views, drawn, selected);
        strong_ends.insert({line.from, line.to});
    }
    for (const int v : strong_ends) {
        const core::Vec3 place = network.vertices()[static_cast<std::size_t>(v)].place;
        const bool ringed =
            std::any_of(open.begin(), open.end(), [&](const core::Vec3& p) { return core::length(p - place) < 0.5; });
        if (!ringed && !views.hides(place)) out.handles_px.push_back(views.camera().to_px(place));
    }
    return out;
}

std::vector<core::Point> projected_plane(const core::StrokePreview::Plane& plane, const ui::FigureCamera& camera,
                                         double half_cm) {
    std::vector<core::Point> corners;
    for (const auto& [u, v] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        corners.push_back(camera.to_px(plane.origin + plane.right * (u * half_cm) + plane.up * (v * half_cm)));
    }
    return corners;
}

std::vector<WaitingRegion> waiting_regions(const core::GarmentDesk& desk, const FigureViews& views) {
    std::vector<WaitingRegion> out;
    const core::Network& network = desk.network();
    const std::set<std::string> there = pieces_in_cloth(desk);
    for (const core::NetworkRegion& region : network.regions()) {
        if (!region.alive || there.count(region.name) > 0) continue;
        WaitingRegion waiting{region.name, {}};
        for (const core::LineUse use : region.ring) {
            core::SpaceLine line = network.lines()[static_cast<std::size_t>(use.line)].shape;
            if (use.reversed) std::reverse(line.begin(), line.end());
            for (const core::Vec3& place : line) waiting.outline_px.push_back(views.camera().to_px(place));
        }
        out.push_back(std::move(waiting));
    }
    return out;
}

}  // namespace app
