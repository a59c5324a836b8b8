#include "core/views/view_choice.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <map>
#include <vector>

using core::ChosenViews;
using core::ViewCandidate;

namespace {

/// Looks asymmetries up by camera and notes who was asked for.
struct Table {
    std::map<int, double> values;
    std::vector<int> asked;
    core::Asymmetry asymmetry() {
        return [this](const ViewCandidate& view) {
            asked.push_back(view.camera);
            return values[view.camera];
        };
    }
};

}  // namespace

TEST_CASE("the longest skeleton comes first, the least symmetric of the other long ones second", "[view_choice]") {
    Table table{{{1, 0.9}, {2, 0.2}, {3, 0.5}, {4, 0.8}}, {}};
    const std::vector<ViewCandidate> views{{1, 5.0}, {2, 40.0}, {3, 30.0}, {4, 20.0}};
    CHECK(*core::choose_views(views, table.asymmetry()) == ChosenViews{2, 1});
    CHECK(*core::choose_views(views, table.asymmetry(), 3) == ChosenViews{2, 4});  // camera 1 is too short
}

TEST_CASE("asymmetry is asked for the N longest but the first only", "[view_choice]") {
    std::vector<ViewCandidate> views;
    for (int c = 0; c < 25; ++c) views.push_back({c, 100.0 - c});
    Table table;
    CHECK(core::choose_views(views, table.asymmetry()).has_value());
    CHECK(table.asked == std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9});
}

TEST_CASE("ties go to the lower camera number whatever the order of the candidates", "[view_choice]") {
    std::vector<ViewCandidate> views{{3, 7.0}, {5, 7.0}, {8, 7.0}, {9, 7.0}};
    do {
        Table table{{{3, 1.0}, {5, 0.5}, {8, 2.0}, {9, 2.0}}, {}};
        CHECK(*core::choose_views(views, table.asymmetry()) == ChosenViews{3, 8});
    } while (std::next_permutation(views.begin(), views.end(),
                                   [](const auto& a, const auto& b) { return a.camera < b.camera; }));
}

TEST_CASE("one usable view is chosen twice, none is an error", "[view_choice]") {
    Table table;
    CHECK(*core::choose_views({{17, 3.0}}, table.asymmetry()) == ChosenViews{17, 17});
    CHECK(table.asked.empty());
    CHECK(core::choose_views({}, table.asymmetry()).error().code == core::ErrorCode::BadMesh);
}

TEST_CASE("a length or asymmetry that is no number is the least", "[view_choice]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Table table{{{1, nan}, {2, -1.0}, {3, nan}}, {}};
    CHECK(*core::choose_views({{0, 9.0}, {1, 3.0}, {2, 2.0}, {3, nan}}, table.asymmetry()) == ChosenViews{0, 2});
    CHECK(*core::choose_views({{0, nan}, {3, nan}}, table.asymmetry()) == ChosenViews{0, 3});
}
