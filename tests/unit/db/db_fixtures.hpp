#pragma once
// What the tests of the database share: a folder of their own, random values from a seed, and how to compare them.

#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "core/geometry/point.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "core/parts/descriptor.hpp"
#include "core/views/camera.hpp"
#include "db/stores/two_view_index.hpp"

namespace fixture {

/// A new folder that goes away with the value.
class TemporaryFolder {
  public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

using Bytes = std::vector<char>;
[[nodiscard]] Bytes read_bytes(const std::filesystem::path& path);
void write_bytes(const std::filesystem::path& path, const Bytes& bytes);
/// Every file of the folder with its bytes, sorted by name.
[[nodiscard]] std::vector<std::pair<std::string, Bytes>> snapshot(const std::filesystem::path& folder);

using Random = std::mt19937_64;
[[nodiscard]] int whole(Random& random, int low, int high);
[[nodiscard]] double real(Random& random, double low, double high);

[[nodiscard]] core::Polygon random_outline(Random& random, int points, double radius);
[[nodiscard]] core::ShapeDescriptor random_descriptor(Random& random, int terminals, int wings, int samples = 100);
[[nodiscard]] core::Camera random_camera(Random& random);
[[nodiscard]] core::TriangleMesh random_mesh(Random& random, int vertices, int triangles, bool coloured);
/// The model number `n` of a collection: the same n gives the same model.
[[nodiscard]] db::ModelRecord random_model(int n);

/// Equal but for the rounding of points that the codecs promise: what comes back for `written`.
[[nodiscard]] db::ModelRecord as_stored(const db::ModelRecord& written);
[[nodiscard]] bool same_views(const db::ModelRecord& a, const db::ModelRecord& b);
[[nodiscard]] bool same_mesh(const core::TriangleMesh& a, const core::TriangleMesh& b);

/// The sentence of a failed result; the test fails where there is no failure.
template <typename T>
std::string sentence(const core::Result<T>& result) {
    REQUIRE_FALSE(result);
    INFO(result.error().sentence());
    return result.error().sentence();
}

/// The value; the test fails with the sentence where there is none.
template <typename T>
T value(core::Result<T> result) {
    if (!result) FAIL(result.error().sentence());
    return std::move(*result);
}
inline void ok(const core::Result<void>& result) {
    if (!result) FAIL(result.error().sentence());
}

}  // namespace fixture
