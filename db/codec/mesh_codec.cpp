#include "db/codec/mesh_codec.hpp"

#include <algorithm>
#include <cmath>

namespace db {

namespace {

using core::Rgb;
using core::TriangleMesh;
using core::Vec3;

constexpr std::uint8_t kMeshVersion = 1;
constexpr std::int64_t kSteps = 32767;  // from 0 to 1
constexpr double kLargest = 1.0 + 1e-6;

const char* fault_of(const TriangleMesh& mesh) {
    const auto inside = [](double value) { return std::abs(value) <= kLargest; };  // false for NaN
    for (const Vec3& v : mesh.vertices) {
        if (!(inside(v.x) && inside(v.y) && inside(v.z))) return "a vertex lies outside the normalised frame";
    }
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t index : triangle) {
            if (index >= mesh.vertices.size()) return "a triangle names a vertex that is not there";
        }
    }
    if (!mesh.colours.empty() && mesh.colours.size() != mesh.vertices.size()) return "some vertices have no colour";
    return nullptr;
}

std::int64_t to_step(double value) {
    return std::llround(std::clamp(value, -1.0, 1.0) * static_cast<double>(kSteps));
}

void write_vertices(ByteWriter& out, const TriangleMesh& mesh) {
    std::array<std::int64_t, 3> last{};
    out.varint(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) {
        const std::array<std::int64_t, 3> next{to_step(v.x), to_step(v.y), to_step(v.z)};
        for (std::size_t axis = 0; axis < 3; ++axis) out.svarint(next[axis] - last[axis]);
        last = next;
    }
}

void read_vertices(ByteReader& in, TriangleMesh& mesh) {
    std::array<std::int64_t, 3> at{};
    mesh.vertices.resize(in.count(3));
    for (Vec3& v : mesh.vertices) {
        for (std::int64_t& value : at) {
            const std::int64_t step = in.svarint();
            const bool inside = std::abs(step / 2) <= kSteps && std::abs(value + step) <= kSteps;
            if (!inside) in.fail("a vertex in it is out of range");
            if (in.failed()) return;
            value += step;
        }
        const auto steps = static_cast<double>(kSteps);
        v = {static_cast<double>(at[0]) / steps, static_cast<double>(at[1]) / steps,
             static_cast<double>(at[2]) / steps};
    }
}

/// The first corner by its distance from the previous triangle's, the others by their distance from the first.
void write_triangles(ByteWriter& out, const TriangleMesh& mesh) {
    std::int64_t last = 0;
    out.varint(mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        const auto first = static_cast<std::int64_t>(triangle[0]);
        out.svarint(first - last);
        out.svarint(static_cast<std::int64_t>(triangle[1]) - first);
        out.svarint(static_cast<std::int64_t>(triangle[2]) - first);
        last = first;
    }
}

void read_triangles(ByteReader& in, TriangleMesh& mesh) {
    const auto vertices = static_cast<std::int64_t>(mesh.vertices.size());
    const auto corner = [&](std::int64_t from) {
        const std::int64_t step = in.svarint();
        const bool inside = step >= -vertices && step <= vertices && from + step >= 0 && from + step < vertices;
        if (!inside) in.fail("a triangle in it names a vertex that is not there");
        return inside ? from + step : 0;
    };
    std::int64_t last = 0;
    mesh.triangles.resize(in.count(3));
    for (auto& triangle : mesh.triangles) {
        const std::int64_t first = corner(last);
        const std::int64_t second = corner(first);
        const std::int64_t third = corner(first);
        if (in.failed()) return;
        triangle = {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second),
                    static_cast<std::uint32_t>(third)};
        last = first;
    }
}

/// Runs of vertices of one colour; a first byte of 0 means that the mesh has no colours.
void write_colours(ByteWriter& out, const TriangleMesh& mesh) {
    out.u8(mesh.colours.empty() ? 0 : 1);
    for (auto run = mesh.colours.begin(); run != mesh.colours.end();) {
        const auto end = std::find_if(run, mesh.colours.end(), [run](Rgb colour) { return !(colour == *run); });
        out.varint(static_cast<std::uint64_t>(end - run));
        out.u8(run->r);
        out.u8(run->g);
        out.u8(run->b);
        run = end;
    }
}

void read_colours(ByteReader& in, TriangleMesh& mesh) {
    const std::uint8_t coloured = in.u8();
    if (coloured > 1 || (coloured == 1 && mesh.vertices.empty())) in.fail("a yes or no in it is neither");
    if (coloured == 0) return;
    mesh.colours.reserve(mesh.vertices.size());
    while (!in.failed() && mesh.colours.size() < mesh.vertices.size()) {
        const std::uint64_t length = in.varint();
        Rgb colour;
        colour.r = in.u8();
        colour.g = in.u8();
        colour.b = in.u8();
        if (length == 0 || length > mesh.vertices.size() - mesh.colours.size()) in.fail("its colours do not add up");
        if (!in.failed()) mesh.colours.insert(mesh.colours.end(), length, colour);
    }
}

}  // namespace

core::Result<Blob> encode_mesh(const TriangleMesh& mesh) {
    if (const char* fault = fault_of(mesh); fault != nullptr) {
        return core::unexpected(core::ErrorCode::BadMesh, std::string("the display mesh is not sound: ") + fault);
    }
    ByteWriter out(BlobKind::Mesh, kMeshVersion);
    write_vertices(out, mesh);
    write_triangles(out, mesh);
    write_colours(out, mesh);
    return out.take();
}

core::Result<TriangleMesh> decode_mesh(BlobView blob) {
    ByteReader in(blob);
    TriangleMesh mesh;
    if (in.header(BlobKind::Mesh, kMeshVersion) != 0) {
        read_vertices(in, mesh);
        read_triangles(in, mesh);
        read_colours(in, mesh);
    }
    if (const core::Result<void> done = in.finish(); !done) return core::unexpected(done.error());
    return mesh;
}

}  // namespace db
