#include "core/exchange/mesh_reader.hpp"

#include <assimp/DefaultIOSystem.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <exception>
#include <fstream>
#include <limits>
#include <new>
#include <string_view>
#include <utility>

#include "core/exchange/isolated.hpp"
#include "core/exchange/mesh_file_check.hpp"
#include "core/exchange/off_reader.hpp"
#include "core/exchange/zip_check.hpp"
#include "core/mesh/mesh_welder.hpp"

namespace core {
namespace {

constexpr int kDeepestNode = 1000;
constexpr unsigned kMostCorners = 20'000;  // of one face: cutting it into triangles takes their square in time
constexpr std::size_t kHeadBytes = 1 << 20;

Unexpected too_many_triangles() {
    return unexpected(ErrorCode::BadMesh, "the model has more than " + std::to_string(kMostMeshTriangles) +
                                              " triangles; simplify it first");
}

/// Lets assimp open ordinary files of bounded size only: a model may name a device or a pipe as its material.
class PlainFiles : public Assimp::DefaultIOSystem {
  public:
    bool Exists(const char* file) const override {
        return check_plain_file(file, kLargestMeshFileBytes).has_value() && DefaultIOSystem::Exists(file);
    }
    Assimp::IOStream* Open(const char* file, const char* mode) override {
        const bool reads = mode != nullptr && mode[0] == 'r';
        return reads && check_plain_file(file, kLargestMeshFileBytes) ? DefaultIOSystem::Open(file, mode) : nullptr;
    }
};

/// A colour of assimp's as bytes; glTF gives linear light, everything else the bytes' own scale.
Rgb to_rgb(const aiColor4D& colour, bool linear) {
    const auto byte = [linear](float value) {
        double v = std::isfinite(value) ? std::clamp(static_cast<double>(value), 0.0, 1.0) : 0.0;
        if (linear) v = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
        return static_cast<std::uint8_t>(std::lround(255.0 * v));
    };
    return {byte(colour.r), byte(colour.g), byte(colour.b)};
}

/// The scene that assimp made, put together node by node.
class SceneReader {
  public:
    SceneReader(const aiScene& scene, bool linear_colours) : scene_(scene), linear_(linear_colours) {}

    Result<TriangleMesh> read() {
        if (scene_.mRootNode == nullptr) return no_faces();
        if (Result<void> done = visit(*scene_.mRootNode, aiMatrix4x4{}, 0); !done) return unexpected(done.error());
        if (welder_.triangle_count() == 0) return no_faces();
        return std::move(welder_).finish();
    }

  private:
    static Unexpected no_faces() {
        return unexpected(ErrorCode::EmptyMesh, "the model has no usable faces; export it with its surface");
    }

    Result<void> visit(const aiNode& node, const aiMatrix4x4& above, int depth) {
        if (depth > kDeepestNode) return unexpected(ErrorCode::BadMesh, "the model's nodes are nested too deeply");
        const aiMatrix4x4 place = above * node.mTransformation;
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            if (node.mMeshes[i] >= scene_.mNumMeshes) continue;
            if (Result<void> done = add(*scene_.mMeshes[node.mMeshes[i]], place); !done) return done;
        }
        for (unsigned i = 0; i < node.mNumChildren; ++i) {
            if (Result<void> done = visit(*node.mChildren[i], place, depth + 1); !done) return done;
        }
        return {};
    }

    Result<void> add(const aiMesh& mesh, const aiMatrix4x4& place) {
        offered_ += mesh.mNumFaces;
        if (offered_ > kMostMeshTriangles) return too_many_triangles();
        const Rgb material = material_colour(mesh.mMaterialIndex);
        const auto corner = [&](unsigned i) {
            const aiVector3D p = place * mesh.mVertices[i];
            const bool coloured = mesh.HasVertexColors(0);
            return MeshWelder::Corner{{p.x, p.y, p.z}, coloured ? to_rgb(mesh.mColors[0][i], linear_) : material};
        };
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) continue;  // points and lines
            welder_.add(corner(face.mIndices[0]), corner(face.mIndices[1]), corner(face.mIndices[2]));
        }
        return {};
    }

    [[nodiscard]] Rgb material_colour(unsigned index) const {
        if (index >= scene_.mNumMaterials) return {};
        const aiMaterial& material = *scene_.mMaterials[index];
        aiString name;
        aiColor4D colour;
        material.Get(AI_MATKEY_NAME, name);
        if (name == aiString(AI_DEFAULT_MATERIAL_NAME)) return {};  // assimp's own, the file names none
        if (material.Get(AI_MATKEY_BASE_COLOR, colour) == AI_SUCCESS) return to_rgb(colour, linear_);
        if (material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS) return to_rgb(colour, linear_);
        return {};
    }

    const aiScene& scene_;
    bool linear_;
    std::size_t offered_ = 0;
    MeshWelder welder_;
};

/// That no face points outside its mesh, which assimp's later steps trust, and none has corners without end.
Result<void> check_indices(const aiScene& scene) {
    std::size_t corners = 0;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices > kMostCorners) {
                return unexpected(ErrorCode::BadMesh, "a face has more than " + std::to_string(kMostCorners) +
                                                          " corners; cut it into triangles first");
            }
            corners += face.mNumIndices;
            for (unsigned k = 0; k < face.mNumIndices; ++k) {
                if (mesh.mVertices != nullptr && face.mIndices[k] < mesh.mNumVertices) continue;
                return unexpected(ErrorCode::BadMesh,
                                  "a face uses a vertex that the model does not have; export it again");
            }
        }
    }
    if (corners > 4 * kMostMeshTriangles) return too_many_triangles();
    return {};
}

/// assimp's own words, as the end of one sentence of ours.
Unexpected not_readable(std::string why) {
    std::replace(why.begin(), why.end(), '\n', ' ');
    constexpr std::size_t kLongest = 160;
    if (why.size() > kLongest) why = why.substr(0, kLongest) + "…";
    const std::string message = "the model cannot be read; export it again";
    return unexpected(ErrorCode::BadFormat, why.empty() ? message : message + " (" + why + ")");
}

Result<TriangleMesh> read_with_assimp(const std::filesystem::path& path, const std::string& extension) {
    try {
        Assimp::Importer importer;
        importer.SetIOHandler(new PlainFiles);  // the importer deletes it
        importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
        if (!importer.IsExtensionSupported(extension)) {
            return unexpected(ErrorCode::UnknownFormat,
                              "this is no kind of model file that is read; export it as OBJ or glTF");
        }
        const aiScene* scene = importer.ReadFile(path.string(), 0);
        if (scene == nullptr) return not_readable(importer.GetErrorString());
        if (Result<void> sound = check_indices(*scene); !sound) return unexpected(sound.error());
        scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
        if (scene == nullptr) return not_readable(importer.GetErrorString());
        return SceneReader(*scene, extension == "gltf" || extension == "glb").read();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& failure) {
        return not_readable(failure.what());
    }
}

template <typename T>
void append(std::string& bytes, const std::vector<T>& values) {
    const std::uint64_t count = values.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

template <typename T>
bool take(std::string_view& bytes, std::vector<T>& values) {
    std::uint64_t count = 0;
    if (bytes.size() < sizeof count) return false;
    std::memcpy(&count, bytes.data(), sizeof count);
    bytes.remove_prefix(sizeof count);
    if (count > bytes.size() / sizeof(T)) return false;
    values.resize(count);
    if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
    return true;
}

/// A mesh or an error as bytes, from the process that reads to the one that asked: the code (or -1), then the rest.
std::string packed(const Result<TriangleMesh>& read) {
    std::string bytes(1, read ? '\xff' : static_cast<char>(read.error().code));
    if (!read) return bytes + read.error().message;
    append(bytes, read->vertices);
    append(bytes, read->triangles);
    append(bytes, read->colours);
    return bytes;
}

Result<TriangleMesh> unpacked(std::string_view bytes) {
    const auto damaged = [] {
        return unexpected(ErrorCode::Internal, "the reader of models gave no answer; try again");
    };
    if (bytes.empty()) return damaged();
    const char code = bytes.front();
    bytes.remove_prefix(1);
    if (code != '\xff') return unexpected(static_cast<ErrorCode>(code), std::string(bytes));
    TriangleMesh mesh;
    if (!take(bytes, mesh.vertices) || !take(bytes, mesh.triangles) || !take(bytes, mesh.colours)) return damaged();
    return mesh;
}

/// What assimp may take: much more than any sound file of that size needs, packed ones included, but no more than 4 GB
/// or half of the machine's memory.
std::size_t most_memory(std::uintmax_t file_bytes) {
    constexpr std::uintmax_t kAtLeast = 256ULL << 20, kPerByte = 64, kAtMost = 4ULL << 30;
    const long pages = sysconf(_SC_PHYS_PAGES), page_bytes = sysconf(_SC_PAGE_SIZE);
    std::uintmax_t most = std::min(kAtMost, kAtLeast + kPerByte * file_bytes);
    if (pages > 0 && page_bytes > 0) {
        most = std::min(most, static_cast<std::uintmax_t>(pages) / 2 * static_cast<std::uintmax_t>(page_bytes));
    }
    return static_cast<std::size_t>(most);
}

/// assimp in a process of its own: some damaged files send it astray for ever.
Result<TriangleMesh> read_isolated(const std::filesystem::path& path, const std::string& extension,
                                   std::uintmax_t file_bytes) {
    IsolationLimits limits;
    limits.memory_bytes = most_memory(file_bytes);
    limits.processor_seconds = 0.5 + static_cast<double>(file_bytes) / (1 << 18);
    const Result<std::string> answer = run_isolated([&] { return packed(read_with_assimp(path, extension)); }, limits);
    if (!answer) return unexpected(answer.error());
    return unpacked(*answer);
}

Result<std::string> read_head(const std::filesystem::path& path) {
    if (Result<void> plain = check_plain_file(path, kLargestMeshFileBytes); !plain) return unexpected(plain.error());
    std::ifstream file(path, std::ios::binary);
    std::string head(kHeadBytes, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (file.gcount() <= 0) {
        return unexpected(ErrorCode::FileUnreadable, "the file cannot be read; check its rights", path.string());
    }
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

Result<TriangleMesh> read_checked(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    Result<std::string> head = read_head(path);
    if (!head) return unexpected(head.error());
    std::error_code fault;
    const std::uintmax_t bytes = std::filesystem::file_size(path, fault);
    if (Result<void> fits = check_mesh_head(extension, *head, bytes, kMostMeshTriangles); !fits) {
        return unexpected(fits.error());
    }
    if (head->starts_with("PK\x03\x04")) {
        if (Result<void> zip = check_zip(path, kLargestMeshFileBytes); !zip) return unexpected(zip.error());
    }
    if (extension != "off") return read_isolated(path, extension, bytes);
    Result<std::string> text = read_plain_file(path, kLargestMeshFileBytes);
    if (!text) return unexpected(text.error());
    return read_off(*text);
}

}  // namespace

const std::vector<std::string>& mesh_extensions() {
    // Of what assimp knows: no motions, no scenes that name models, and no endings that other programs use more.
    static const std::vector<std::string> extensions{
        "3ds",  "3mf", "ac",  "ac3d",    "amf", "ase", "b3d", "blend", "cob",     "dae",  "dxf", "fbx", "glb",
        "gltf", "ifc", "iqm", "irrmesh", "lwo", "lxo", "md2", "md3",   "md5mesh", "ms3d", "nff", "obj", "off",
        "ogex", "ply", "pmx", "q3o",     "q3s", "sib", "smd", "stl",   "x",       "x3d",  "xgl", "zae", "zgl"};
    return extensions;
}

bool has_mesh_extension(const std::filesystem::path& path) {
    return std::binary_search(mesh_extensions().begin(), mesh_extensions().end(), lower_extension(path));
}

Result<TriangleMesh> read_mesh(const std::filesystem::path& path) {
    Result<TriangleMesh> mesh = read_checked(path);
    if (mesh) return mesh;
    Error error = mesh.error();
    error.where = path.string();
    return unexpected(std::move(error));
}

}  // namespace core
