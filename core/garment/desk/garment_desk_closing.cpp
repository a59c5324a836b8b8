// What follows a new line: ends are joined, crossings get vertices, the middle closes, and outlines become pieces.

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/garment/desk/desk_notes.hpp"
#include "core/garment/desk/desk_steps.hpp"
#include "core/garment/desk/garment_desk.hpp"
#include "core/garment/desk/middle_line.hpp"
#include "core/garment/desk/network_paths.hpp"
#include "core/garment/desk/pick.hpp"
#include "core/garment/desk/region_names.hpp"

namespace core {
namespace {

using Kind = DesignStep::Kind;

}  // namespace

/// Loose ends that a new line passes are joined to it, as they would be had it been there first.
void GarmentDesk::join_ends(DesignRunner& next, std::vector<DesignStep>& saved) const {
    for (const OpenEnd& end : open_ends(next.network(), next.layer())) {
        if (end.nearest == end.line || end.nearest.empty() || end.gap_cm > settings_only_.network.snap_cm) continue;
        DesignStep step = step_of(Kind::Join);
        step.at = end.place;
        step.lines = {end.nearest};
        if (Result<DesignStep> done = next.take(step); done) {
            saved.push_back(std::move(*done));
            return join_ends(next, saved);  // the other ends again: lines were split
        }
    }
}

/// New lines get vertices where they cross others, or themselves. Where that cannot be the lines stay as they are.
void GarmentDesk::meet_lines(DesignRunner& next, std::vector<DesignStep>& saved) const {
    constexpr int kMost = 32;  // crossings of one stroke
    const std::string name = saved.front().kind == Kind::Line ? saved.front().name : std::string();
    std::vector<Vec3> refused;
    for (int k = 0; k < kMost && !name.empty(); ++k) {
        const std::optional<LineCrossing> found =
            first_crossing(next.network(), next.layer(), name, next.obstacle(), refused);
        if (!found) return;
        DesignStep step = step_of(Kind::Meet);
        step.lines = {next.network().piece_name(found->line), next.network().piece_name(found->other)};
        step.at = found->at;
        step.to = found->to;
        if (Result<DesignStep> done = next.take(step); done)
            saved.push_back(std::move(*done));
        else
            refused.push_back(found->at);
    }
}

/// Lines in the middle that came by themselves give way to one that the designer draws there along them.
void GarmentDesk::give_way(DesignRunner& next, std::vector<DesignStep>& saved) const {
    if (saved.front().kind != Kind::Line) return;
    for (bool changed = true; changed;) {  // pieces of one name change their numbers as one goes
        changed = false;
        for (std::size_t i = 0; i < next.network().lines().size() && !changed; ++i) {
            const NetworkLine& line = next.network().lines()[i];
            if (!line.alive || line.layer != next.layer() || line.name.rfind(kMiddleLine, 0) != 0) continue;
            if (!runs_along(next.network(), next.layer(), saved.front().name, line.shape, next.obstacle())) continue;
            DesignStep step = step_of(Kind::Erase);
            step.lines = {next.network().piece_name(static_cast<int>(i))};
            Result<DesignStep> done = next.take(step);
            if (!done) continue;
            saved.push_back(std::move(*done));
            changed = true;
        }
    }
}

/// Where outlines are open in the middle alone: from an end there to another place of the middle, on one side of the
/// body, if a line between the two closes one.
void GarmentDesk::close_middle(DesignRunner& next, std::vector<DesignStep>& saved) const {
    std::vector<Vec3> ends, all;
    for (const OpenEnd& end : open_ends(next.network(), next.layer())) {
        if (end.place.x != 0.0) return;  // still being drawn
        ends.push_back(end.place);
    }
    for (const NetworkVertex& vertex : next.network().vertices())
        if (vertex.alive && vertex.layer == next.layer() && vertex.place.x == 0.0) all.push_back(vertex.place);
    struct Pair {
        double gap;
        Vec3 from, to;
    };
    std::vector<Pair> pairs;
    for (const Vec3& from : ends)
        for (const Vec3& to : all)
            if (from != to && is_one_side(next.obstacle(), from, to)) pairs.push_back({length(from - to), from, to});
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) { return x.gap < y.gap; });
    for (const Pair& pair : pairs) {
        DesignStep step;
        step.name = free_line_name(next.network(), kMiddleLine);
        step.stroke = middle_stroke(next.obstacle(), pair.from, pair.to);
        DesignRunner tried = next;
        Result<DesignStep> done = tried.take(step);
        if (!done) continue;
        const std::vector<OpenFace> faces = open_faces(tried.network(), tried.layer(), tried.obstacle());
        const bool closes = std::any_of(faces.begin(), faces.end(), [&](const OpenFace& face) {
            return std::any_of(face.ring.begin(), face.ring.end(), [&](LineUse use) {
                return tried.network().lines()[static_cast<std::size_t>(use.line)].name == step.name;
            });
        });
        if (!closes) continue;
        saved.push_back(std::move(*done));
        next = std::move(tried);
        return close_middle(next, saved);
    }
}

/// A region that lines part, as it was.
struct GarmentDesk::WholeRegion {
    NetworkRegion region;
    std::optional<ClothMaterial> material;
};

/// Regions for the outlines that are closed now. Parts of one that was there are of the same cloth and keep its
/// corners.
void GarmentDesk::close_regions(DesignRunner& next, std::vector<DesignStep>& saved, DeskReply& reply) const {
    std::map<std::string, WholeRegion> parted;
    for (const OpenFace& face : open_faces(next.network(), next.layer(), next.obstacle())) {
        DesignStep step = step_of(Kind::Region);
        step.lines = names_of_ring(next.network(), next.layer(), face.ring);
        step.alpha = settings_.alpha;
        const WholeRegion* whole = nullptr;
        if (face.part_of.empty()) {
            step.name = name_for_region(next.network(), face.ring, next.obstacle());
        } else if (const auto known = parted.find(face.part_of); known != parted.end()) {
            step.name = free_region_name(next.network(), face.part_of);
            whole = &known->second;
        } else {
            step.name = step.region = face.part_of;
            WholeRegion was{*next.network().find_region(face.part_of), std::nullopt};
            if (const auto m = next.look().materials.find(face.part_of); m != next.look().materials.end())
                was.material = m->second;
            whole = &parted.emplace(face.part_of, std::move(was)).first->second;
        }
        if (whole != nullptr) {
            step.alpha = whole->region.alpha;
            step.parts = whole->region.parts;
        }
        Result<DesignStep> done = next.take(step);
        if (done) {
            saved.push_back(std::move(*done));
            if (whole != nullptr) keep_look(next, saved, step.name, *whole);
        } else {
            reply.notes.push_back(note_of_step(step, next, done.error(), ring_line(next.network(), face.ring).front()));
        }
    }
}

/// Corners and cloth of a part are those of the whole; where a new line meets its edge corners are found.
void GarmentDesk::keep_look(DesignRunner& next, std::vector<DesignStep>& saved, const std::string& part,
                            const WholeRegion& whole) const {
    const auto take = [&](const DesignStep& step) {
        if (Result<DesignStep> done = next.take(step); done) saved.push_back(std::move(*done));
    };
    if (whole.material && next.look().materials.count(part) == 0) {
        DesignStep step = region_step(Kind::Material, part);
        step.material = *whole.material;
        take(step);
    }
    std::set<int> lines, vertices;  // of the whole's edge
    for (const LineUse use : whole.region.ring) {
        const NetworkLine& line = next.network().lines()[static_cast<std::size_t>(use.line)];
        lines.insert(use.line);
        vertices.insert({line.from, line.to});
    }
    const NetworkRegion own = *next.network().find_region(part);
    std::vector<std::pair<int, bool>> other;  // vertices that are found to be corners and were none, and the reverse
    for (std::size_t i = 0; i < own.ring.size(); ++i) {
        const LineUse use = own.ring[i], before = own.ring[(i + own.ring.size() - 1) % own.ring.size()];
        const NetworkLine& line = next.network().lines()[static_cast<std::size_t>(use.line)];
        const int vertex = use.reversed ? line.to : line.from;
        if (lines.count(use.line) == 0 || lines.count(before.line) == 0 || vertices.count(vertex) == 0) continue;
        const bool was = whole.region.corners.count(vertex) != 0;
        if (was != (own.corners.count(vertex) != 0)) other.emplace_back(vertex, was);
    }
    for (const bool on : {true, false}) {  // those to come first: two must stay
        for (const auto& [vertex, was] : other) {
            if (was != on) continue;
            DesignStep step = region_step(Kind::Corner, part);
            step.at = next.network().vertices()[static_cast<std::size_t>(vertex)].place;
            step.on = on;
            take(step);
        }
    }
}

}  // namespace core
