#include "db_fixtures.hpp"

#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "core/base/checksum.hpp"
#include "db/codec/descriptor_codec.hpp"
#include "db/codec/mesh_codec.hpp"
#include "db/codec/points_codec.hpp"
#include "db/migrations/migrations.hpp"
#include "support/random_contour.hpp"

namespace fixture {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "croquis-db-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) FAIL("no temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::permissions(path_, fs::perms::owner_all, ignored);
    fs::remove_all(path_, ignored);
}

Bytes read_bytes(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const fs::path& path, const Bytes& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    REQUIRE(file.flush());
}

std::vector<std::pair<std::string, Bytes>> snapshot(const fs::path& folder) {
    std::vector<std::pair<std::string, Bytes>> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        files.emplace_back(entry.path().filename().string(), read_bytes(entry.path()));
    }
    std::sort(files.begin(), files.end());
    return files;
}

int whole(Random& random, int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

double real(Random& random, double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1.0p-53);
}

core::Polygon random_outline(Random& random, int points, double radius) {
    core::Polygon ring;
    const double bumps = whole(random, 2, 7);
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / points;
        const double r = radius * (0.6 + 0.3 * std::sin(bumps * angle) + real(random, 0.0, 0.1));
        ring.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return ring;
}

namespace {

float random_float(Random& random) {
    switch (whole(random, 0, 9)) {
        case 0:
            return 0.0F;
        case 1:
            return static_cast<float>(real(random, -1e-30, 1e-30));
        case 2:
            return static_cast<float>(real(random, -1e30, 1e30));
        default:
            return static_cast<float>(real(random, 0.0, 100.0));
    }
}

core::Part random_part(Random& random, int first, int count, int samples) {
    core::Part part;
    part.first_terminal = first;
    part.terminal_count = count;
    part.start_sample = whole(random, 0, samples - 1);
    part.end_sample = whole(random, 0, samples - 1);
    part.salient = whole(random, 0, 1) == 1;
    for (float& f : part.features) f = random_float(random);
    for (float& f : part.signature) f = random_float(random);
    return part;
}

}  // namespace

core::ShapeDescriptor random_descriptor(Random& random, int terminals, int wings, int samples) {
    core::ShapeDescriptor descriptor;
    descriptor.samples = random_outline(random, samples, real(random, 20.0, 900.0));
    descriptor.terminal_count = terminals;
    for (int i = 0; i < terminals; ++i) descriptor.parts.push_back(random_part(random, i, 1, samples));
    for (int i = 0; i < wings; ++i) {
        descriptor.parts.push_back(
            random_part(random, whole(random, 0, terminals - 1), whole(random, 1, terminals), samples));
    }
    for (int i = 0; i < terminals; ++i) {
        if (whole(random, 0, 2) == 0) descriptor.stop_points.push_back(i);
    }
    descriptor.whole = random_part(random, 0, std::max(terminals, 1), samples);
    descriptor.skeletal_length = real(random, 0.0, 5000.0);
    return descriptor;
}

core::Camera random_camera(Random& random) {
    core::Camera camera;
    camera.direction = core::normalised({real(random, -1, 1), real(random, -1, 1), real(random, 0.1, 1)});
    const core::Vec3 side = core::cross(core::Vec3{0.0, 1.0, 0.0}, camera.direction);
    camera.up = core::normalised(core::cross(camera.direction, side));
    return camera;
}

core::TriangleMesh random_mesh(Random& random, int vertices, int triangles, bool coloured) {
    core::TriangleMesh mesh;
    core::Rgb colour;
    for (int i = 0; i < vertices; ++i) {
        mesh.vertices.push_back({real(random, -1, 1), real(random, -1, 1), real(random, -1, 1)});
        if (whole(random, 0, 4) == 0) colour.r = static_cast<std::uint8_t>(whole(random, 0, 255));
        if (coloured) mesh.colours.push_back(colour);
    }
    for (int i = 0; i < triangles; ++i) {
        const auto corner = [&] { return static_cast<std::uint32_t>(whole(random, 0, vertices - 1)); };
        mesh.triangles.push_back({corner(), corner(), corner()});
    }
    return mesh;
}

db::ModelRecord random_model(int n) {
    Random random(static_cast<std::uint64_t>(n) + 1);
    db::ModelRecord model;
    model.name = "model " + std::to_string(n);
    model.class_name = n % 3 == 0 ? "" : "class " + std::to_string(n % 3);
    model.source_path = "models/m" + std::to_string(n) + ".off";
    model.content_hash = random();
    model.file_size = random() >> 30;
    for (db::ModelView& view : model.views) {
        view.camera = random_camera(random);
        view.camera_number = whole(random, 0, 49);
        view.descriptor = random_descriptor(random, whole(random, 2, 12), whole(random, 0, 6));
        view.outline = random_outline(random, 100, 1.0);
        view.contour = support::random_contour(random);
        view.skeletal_length = real(random, 0.0, 10.0);
        view.asymmetry = real(random, 0.0, 3.0);
        for (const int byte : {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, n, 7}) {
            view.thumbnail.push_back(static_cast<std::byte>(byte));
        }
    }
    model.display_mesh = random_mesh(random, 60, 100, n % 2 == 0);
    return model;
}

db::ModelRecord as_stored(const db::ModelRecord& written) {
    db::ModelRecord model = written;
    for (db::ModelView& view : model.views) {
        view.outline = value(db::decode_polygon(value(db::encode_polygon(view.outline))));
        view.descriptor = value(db::decode_descriptor(value(db::encode_descriptor(view.descriptor))));
    }
    model.display_mesh = value(db::decode_mesh(value(db::encode_mesh(model.display_mesh))));
    return model;
}

bool same_views(const db::ModelRecord& a, const db::ModelRecord& b) {
    const auto same_view = [](const db::ModelView& v, const db::ModelView& w) {
        return v.camera.direction == w.camera.direction && v.camera.up == w.camera.up &&
               v.camera_number == w.camera_number && v.outline == w.outline && v.descriptor == w.descriptor &&
               v.contour == w.contour && v.skeletal_length == w.skeletal_length && v.asymmetry == w.asymmetry;
    };
    return a.name == b.name && a.class_name == b.class_name && a.source_path == b.source_path &&
           a.content_hash == b.content_hash && a.file_size == b.file_size && same_view(a.views[0], b.views[0]) &&
           same_view(a.views[1], b.views[1]);
}

bool same_mesh(const core::TriangleMesh& a, const core::TriangleMesh& b) {
    return a.vertices == b.vertices && a.triangles == b.triangles && a.colours == b.colours;
}

}  // namespace fixture
