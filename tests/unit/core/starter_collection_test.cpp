#include "core/starter/starter_collection.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/exchange/ply_writer.hpp"

namespace {

const std::vector<core::StarterModel>& collection() {
    static const std::vector<core::StarterModel> models = core::starter_collection();
    return models;
}

core::Vec3 extent(const core::TriangleMesh& mesh) {
    core::Vec3 low = mesh.vertices.front(), high = low;
    for (const core::Vec3 v : mesh.vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    return high - low;
}

double enclosed_volume(const core::TriangleMesh& mesh) {
    double six = 0.0;
    for (const auto& t : mesh.triangles)
        six += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]]));
    return six / 6.0;
}

/// Edges that are not passed as often one way as the other; vertices at one place count as one.
std::size_t open_edges(const core::TriangleMesh& mesh) {
    const core::Vec3 size = extent(mesh);
    const double grid = 4e5 / std::max({size.x, size.y, size.z});
    const auto steps = [&](double value) { return static_cast<std::uint64_t>(std::lround(value * grid) + (1 << 20)); };
    std::unordered_map<std::uint64_t, std::uint32_t> places;
    std::vector<std::uint32_t> place;
    for (const core::Vec3 v : mesh.vertices) {
        const std::uint64_t key = (steps(v.x) << 42) ^ (steps(v.y) << 21) ^ steps(v.z);
        place.push_back(places.try_emplace(key, static_cast<std::uint32_t>(places.size())).first->second);
    }
    std::vector<std::pair<std::uint64_t, int>> passes;  // (edge, which way)
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = place[t[k]], b = place[t[(k + 1) % 3]];
            if (a != b) passes.push_back({std::min(a, b) << 32 | std::max(a, b), a < b ? 1 : -1});
        }
    std::sort(passes.begin(), passes.end());
    std::size_t open = 0;
    for (std::size_t i = 0; i < passes.size();) {
        int balance = 0;
        const std::uint64_t edge = passes[i].first;
        for (; i < passes.size() && passes[i].first == edge; ++i) balance += passes[i].second;
        open += balance != 0;
    }
    return open;
}

}  // namespace

// One case with sections: the collection is made once for all of them.
TEST_CASE("the starter collection", "[starter]") {
    SECTION("the starter collection has enough to find") {
        std::map<std::string, int> by_class;
        for (const core::StarterModel& m : collection()) ++by_class[m.class_name];
        CHECK(by_class.size() >= 40);
        for (const auto& [name, count] : by_class) {
            INFO(name);
            CHECK(count >= 5);
        }
        // What the recorded drawings show, and what goes with garments.
        for (const char* name : {"horse", "airplane", "chair", "guitar", "shoe", "hat", "eyeglasses", "purse"})
            CHECK(by_class.contains(name));
    }

    SECTION("starter models have unique names and their classes stand together") {
        std::set<std::string> names, finished;
        std::string current;
        for (const core::StarterModel& m : collection()) {
            INFO(m.name);
            CHECK(names.insert(m.name).second);
            if (m.class_name != current) {
                CHECK(finished.insert(m.class_name).second);
                current = m.class_name;
            }
        }
    }

    SECTION("starter models are sound meshes with colours") {
        for (const core::StarterModel& m : collection()) {
            INFO(m.class_name << ": " << m.name);
            const core::TriangleMesh& mesh = m.mesh;
            REQUIRE(mesh.triangles.size() >= 100);
            CHECK(mesh.triangles.size() <= 20000);
            REQUIRE(mesh.colours.size() == mesh.vertices.size());
            CHECK(std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](core::Vec3 v) {
                return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
            }));
            CHECK(std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
                return std::max({t[0], t[1], t[2]}) < mesh.vertices.size();
            }));
            const core::Vec3 size = extent(mesh);
            CHECK(std::max({size.x, size.y, size.z}) < 5.0);
            CHECK(std::max({size.x, size.y, size.z}) > 0.4);
            CHECK(std::min({size.x, size.y, size.z}) > 0.01);
        }
    }

    SECTION("most starter models are light") {
        const auto light = std::count_if(collection().begin(), collection().end(),
                                         [](const auto& m) { return m.mesh.triangles.size() < 8000; });
        CHECK(light * 10 >= std::ssize(collection()) * 7);
    }

    SECTION("starter models are closed and face outward") {
        for (const core::StarterModel& m : collection()) {
            INFO(m.class_name << ": " << m.name);
            CHECK(open_edges(m.mesh) == 0);
            CHECK(enclosed_volume(m.mesh) > 0.0);
        }
    }

    SECTION("and the check for closedness finds a hole and a turned face") {
        core::TriangleMesh mesh = collection().front().mesh;
        SECTION("a hole") {
            mesh.triangles.pop_back();
        }
        SECTION("a turned face") {
            std::swap(mesh.triangles.back()[0], mesh.triangles.back()[1]);
        }
        CHECK(open_edges(mesh) == 3);
    }

    SECTION("models of one class differ in proportion, not only in scale") {
        std::map<std::string, std::vector<std::pair<core::Vec3, std::string>>> seen;
        for (const core::StarterModel& m : collection()) {
            const core::Vec3 size = extent(m.mesh);
            const core::Vec3 shape = size * (1.0 / length(size));
            for (const auto& [other, name] : seen[m.class_name]) {
                INFO(m.name << " and " << name);
                CHECK(length(shape - other) > 1e-3);
            }
            seen[m.class_name].push_back({shape, m.name});
        }
    }

    SECTION("the starter collection is written with a list of classes, the second time as the first") {
        const auto folder = std::filesystem::temp_directory_path() / "croquis_starter_test" / "models";
        std::filesystem::remove_all(folder);
        REQUIRE(core::write_starter_collection(folder));
        std::ifstream list(folder / "starter.list");
        std::size_t lines = 0;
        for (std::string line; std::getline(list, line); ++lines) {
            REQUIRE(lines < collection().size());
            const std::size_t tab = line.find('\t');
            REQUIRE(tab != std::string::npos);
            CHECK(line.substr(tab + 1) == collection()[lines].class_name);
            std::ostringstream first;  // the folder's models were made anew
            REQUIRE(core::write_ply(first, collection()[lines].mesh));
            std::ifstream written(folder / line.substr(0, tab), std::ios::binary);
            CHECK(first.str() == std::string(std::istreambuf_iterator<char>(written), {}));
        }
        CHECK(lines == collection().size());
        std::filesystem::remove_all(folder.parent_path());
    }
}

TEST_CASE("a folder that cannot be made is named", "[starter]") {
    const auto result = core::write_starter_collection("/proc/no-such-place/starter");
    REQUIRE_FALSE(result);
    CHECK(result.error().code == core::ErrorCode::WriteFailed);
    CHECK(result.error().where == "/proc/no-such-place/starter");
}
