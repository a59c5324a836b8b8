// The pictures of core/README.md that no recorded drawing gives: the worked figures of the thesis, drawn from outlines
// that are made here.
//
//     figures_sheet OUT_DIR
//
// figures.png: the final pieces and the skeleton of six figures. rings.png: two horned animals, one mirrored, with
// their rings of parts (thesis fig. 1.5). mythological.png: a horse and a centaur. pairs.png: matched parts of four
// pairs. airplane.png: every step of the airplane. Prints each distance.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/match/match.hpp"
#include "core/parts/describe.hpp"
#include "core/silhouette/contour.hpp"
#include "support/raster.hpp"
#include "support/shapes.hpp"
#include "ui/draw/shape_picture.hpp"

namespace {

using core::Point;
using core::Polygon;

/// By way of a silhouette, as everything else comes.
core::DescribedShape described(const Polygon& outline) {
    auto ring = core::largest_contour(support::silhouette_of(outline, 320));
    auto shape = ring ? core::describe_in_steps(*ring) : core::unexpected(ring.error());
    if (!shape) {
        std::fprintf(stderr, "figures_sheet: %s\n", shape.error().sentence().c_str());
        std::exit(1);
    }
    return std::move(*shape);
}

/// The same animal in another stance: leaning, shorter, its tail's samples raised.
Polygon in_another_stance(Polygon ring) {
    for (Point& p : ring) {
        const double tail = p.x < 0.5 && p.y > 2 ? 0.9 * (0.5 - p.x) : 0.0;
        p = {0.9 * p.x + 0.07 * p.y, 1.06 * p.y + tail};
    }
    return ring;
}

/// A hand whose fingers are shorter and further apart.
Polygon other_hand() {
    return {{0, 0},      {8, 0},    {9, 4},   {13.5, 8.2},  {12.2, 10},   {8.2, 7.4},
            {9.6, 14.6}, {7.9, 15}, {6, 8.5}, {6, 16.6},    {4.2, 16.6},  {4, 8.5},
            {2.6, 15.8}, {1, 15.4}, {2, 8.5}, {-1.6, 12.4}, {-2.8, 11.6}, {0, 6.6}};
}

/// An airplane whose wings are straighter and set further back.
Polygon other_airplane() {
    return {{9, 0},  {7.6, 1},   {2, 1.2},   {0.2, 8.6}, {-1.6, 8.6}, {-2, 1.2},    {-6, 0.9},   {-7.2, 3}, {-8.4, 3},
            {-8, 0}, {-8.4, -3}, {-7.2, -3}, {-6, -0.9}, {-2, -1.2},  {-1.6, -8.6}, {0.2, -8.6}, {2, -1.2}, {7.6, -1}};
}

struct Named {
    const char* name;
    Point place;  ///< in the outline's own coordinates
};

/// The names of the terminals: of each the one whose place lies nearest to the middle of its arc.
std::vector<std::string> names_of(const core::ShapeDescriptor& d, const std::vector<Named>& parts,
                                  const Polygon& outline, double size) {
    Point low = outline.front(), high = low;
    for (const Point& p : outline) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double scale = size / std::max(high.x - low.x, high.y - low.y);
    Point corner = d.samples.front();
    for (const Point& p : d.samples) corner = {std::min(corner.x, p.x), std::min(corner.y, p.y)};
    std::vector<std::string> names;
    const int n = static_cast<int>(d.samples.size());
    for (int t = 0; t < d.terminal_count; ++t) {
        const core::Part& part = d.parts[static_cast<std::size_t>(t)];
        const int steps = (part.end_sample - part.start_sample + n) % n;
        const Point middle = d.samples[static_cast<std::size_t>((part.start_sample + steps / 2) % n)];
        const Named* nearest = &parts.front();
        const auto away = [&](const Named& named) { return distance((named.place - low) * scale + corner, middle); };
        for (const Named& named : parts) {
            if (away(named) < away(*nearest)) nearest = &named;
        }
        names.emplace_back(nearest->name);
    }
    return names;
}

core::Match match_of(const core::ShapeDescriptor& a, const core::ShapeDescriptor& b) {
    core::Matcher matcher;
    return matcher.match(core::matchable(a), core::matchable(b));
}

void check(const core::Result<void>& written) {
    if (written) return;
    std::fprintf(stderr, "figures_sheet: %s\n", written.error().sentence().c_str());
    std::exit(1);
}

void draw_figures(const std::string& folder) {
    const std::vector<std::pair<const char*, Polygon>> figures{
        {"Star", support::star(5, 10, 4)}, {"Hand", support::hand()},   {"Bug", support::bug()},
        {"Airplane", support::airplane()}, {"Horse", support::horse()}, {"Centaur", support::centaur()}};
    std::vector<core::DescribedShape> shapes;
    std::vector<std::string> titles;
    for (const auto& [title, outline] : figures) {
        shapes.push_back(described(outline));
        titles.emplace_back(title);
    }
    check(ui::write_segmentation_sheet(shapes, titles, 6, folder + "/figures.png"));
    check(ui::write_description_picture(shapes[3], "Airplane", folder + "/airplane.png"));
}

void draw_rings(const std::string& folder) {
    const std::vector<Named> parts{{"hind leg", {0.5, 0}}, {"hind leg", {2.9, 0.2}}, {"front leg", {11, 0.1}},
                                   {"front leg", {13, 0}}, {"muzzle", {18.7, 9.5}},  {"horn", {18, 16.1}},
                                   {"horn", {14.5, 16.8}}, {"tail", {-2.2, 3}},      {"rump", {1, 10.6}}};
    std::vector<Named> mirrored_parts = parts;
    Polygon places;
    for (const Named& named : parts) places.push_back(named.place);
    places = in_another_stance(places);
    for (std::size_t i = 0; i < parts.size(); ++i) mirrored_parts[i].place = {-places[i].x, places[i].y};
    const Polygon one = support::horned(), other = support::mirrored(in_another_stance(support::horned()));
    const core::DescribedShape steps = described(one);
    check(ui::write_description_picture(steps, "A horned animal", folder + "/steps.png"));
    const core::ShapeDescriptor& a = steps.descriptor;
    const core::ShapeDescriptor b = described(other).descriptor;
    const core::Match match = match_of(a, b);
    std::printf("rings: distance %.2f%s\n", match.distance, match.reversed ? ", mirrored" : "");
    check(ui::write_ring_picture({&a, &b, &match, "One animal", "its like in another stance"},
                                 {names_of(a, parts, one, 320), names_of(b, mirrored_parts, other, 320)},
                                 folder + "/rings.png"));
}

struct Pair {
    std::string title_a, title_b;
    Polygon a, b;
};

void draw_pairs(const std::vector<Pair>& pairs, const std::string& path) {
    std::vector<core::ShapeDescriptor> shapes;
    std::vector<core::Match> matches;
    for (const Pair& pair : pairs) {
        shapes.push_back(described(pair.a).descriptor);
        shapes.push_back(described(pair.b).descriptor);
        matches.push_back(match_of(shapes[shapes.size() - 2], shapes.back()));
        std::printf("%s and %s: distance %.2f\n", pair.title_a.c_str(), pair.title_b.c_str(), matches.back().distance);
    }
    std::vector<ui::MatchPictureItem> items;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        items.push_back({&shapes[2 * i], &shapes[2 * i + 1], &matches[i], pairs[i].title_a, pairs[i].title_b});
    }
    check(ui::write_match_picture(items, path));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: figures_sheet OUT_DIR\n");
        return 2;
    }
    const std::string folder = argv[1];
    draw_figures(folder);
    draw_rings(folder);
    draw_pairs({{"Horse", "Centaur", support::horse(), support::centaur()}}, folder + "/mythological.png");
    draw_pairs(
        {{"Star", "a fuller one, turned", support::star(5, 10, 4), support::turned(support::star(5, 10, 5), 0.4)},
         {"Bug", "itself, turned", support::bug(), support::turned(support::bug(), 1.9)},
         {"Hand", "another of the other side", support::hand(), support::mirrored(other_hand())},
         {"Airplane", "another, turned", support::airplane(), support::turned(other_airplane(), -0.7)}},
        folder + "/pairs.png");
    return 0;
}
