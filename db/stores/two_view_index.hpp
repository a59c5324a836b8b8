#pragma once
// The collection that a drawing searches: 3D models, each with two views (thesis chapter 7), in one SQLite file.
// It stores and returns; scoring is core's.
//
//     core::Result<db::TwoViewIndex> index = db::TwoViewIndex::open("models.db", db::OpenMode::Create, {.parameters =
//     p}); if (!index) return core::unexpected(index.error()); index->add_all(batch); // whole models only, whenever
//     the power goes core::Result<db::LoadedModels> models = index->load_views();  // in the order of ids
//
// Every blob and every row has a checksum. Use one TwoViewIndex per thread; readers go on beside one writer. Every
// function may give, besides what it names: Damaged, DatabaseFailed (another program holds the lock), WriteFailed (disk
// full, read-only).

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/contour/contour_descriptor.hpp"
#include "core/geometry/point.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "core/parts/descriptor.hpp"
#include "core/views/camera.hpp"
#include "db/sqlite/database.hpp"

namespace db {

/// One of the two views kept of a model.
struct ModelView {
    core::Camera camera;
    int camera_number = 0;  ///< among the 50 of 7.1.1, from 0
    core::Polygon outline;  ///< contour in the image plane [-1, 1] x [-1, 1], y up
    core::ShapeDescriptor descriptor;
    core::ContourDescriptor contour;   ///< of the same outline
    double skeletal_length = 0.0;      ///< 7.1.2
    double asymmetry = 0.0;            ///< 7.1.2, distance to the reversed self
    std::vector<std::byte> thumbnail;  ///< a PNG of the model from `camera`; empty: none
};

struct ModelRecord {
    std::int64_t id = 0;  ///< given by the index, from 1 in the order of insertion; ignored by add
    std::string name;
    std::string class_name;   ///< may be empty
    std::string source_path;  ///< what the model is known by: adding the same path again replaces it
    std::uint64_t content_hash = 0;
    std::uint64_t file_size = 0;  ///< bytes
    std::array<ModelView, 2> views;
    core::TriangleMesh display_mesh;  ///< normalised frame
};

/// A model without its blobs.
struct ModelEntry {
    std::int64_t id = 0;
    std::string name;
    std::string class_name;
    std::string source_path;
    std::uint64_t content_hash = 0;
    std::uint64_t file_size = 0;
    bool stale = false;  ///< described with other parameters, or by another program, than those given at open
};

/// One thing in the index that is not as it was written.
struct Damage {
    std::int64_t model_id = 0;  ///< 0: the file as a whole
    std::string model;          ///< name; empty for the file as a whole
    std::string part;  ///< "record", "view 1", "camera of view 0", "outline of …", "descriptor of …", "contour of …",
                       ///< "thumbnail of …",
                       ///< "display mesh", "file"
    std::string message;
    /// "model 7 (horse), descriptor of view 1: it is damaged (…)"
    [[nodiscard]] std::string sentence() const;
};

struct LoadedModels {
    std::vector<ModelRecord> models;  ///< whole models only, in the order of ids, without display meshes and thumbnails
    std::vector<Damage> damaged;      ///< what was passed over
};

/// A model near to another one.
struct StoredNeighbour {
    std::int64_t id = 0;
    float distance = 0.0F;

    friend bool operator==(const StoredNeighbour&, const StoredNeighbour&) = default;
};

/// The nearest others of one model, nearest first.
struct NeighbourList {
    std::int64_t model_id = 0;
    std::vector<StoredNeighbour> nearest;

    friend bool operator==(const NeighbourList&, const NeighbourList&) = default;
};

struct BuildInfo {
    std::string program_version;
    std::string parameters;
    std::uint64_t parameters_hash = 0;
    std::int64_t models = 0;  ///< described so
};

struct IndexInfo {
    int schema_version = 0;
    std::int64_t models = 0;
    std::int64_t stale_models = 0;  ///< see ModelEntry::stale
    std::int64_t bytes = 0;         ///< of the file, its log not counted
    std::vector<BuildInfo> builds;  ///< those that some model has, oldest first
};

struct IndexOptions {
    std::string parameters;  ///< of the description, in any spelling; a model described with another text is stale …
    std::string program_version = {};  ///< … and one described by another program; empty: this program
    int busy_timeout_ms = 5000;        ///< how long to wait for another program's lock
    std::int64_t max_pages = 0;        ///< largest size in pages of 16 kB; 0: as much as the disk holds
};

class TwoViewIndex {
  public:
    /// Errors of Database::open: a file that is no index, or of a newer version, is refused and not altered.
    [[nodiscard]] static core::Result<TwoViewIndex> open(const std::filesystem::path& path, OpenMode mode,
                                                         IndexOptions options = {});

    /// Adds a model, or replaces the one of the same source_path, which keeps its id. Gives the id.
    /// BadArgument, BadOutline, BadMesh for what the codecs refuse; the index is then as before.
    [[nodiscard]] core::Result<std::int64_t> add(const ModelRecord& model);
    /// The same for many in one transaction: all of them or none. Gives the ids in order. Durable when it returns;
    /// one flush to the disk each call, so some tens of models a call are much faster than one.
    [[nodiscard]] core::Result<std::vector<std::int64_t>> add_all(std::span<const ModelRecord> models);

    /// The model of a source path, if there is one.
    [[nodiscard]] core::Result<std::optional<ModelEntry>> find(const std::string& source_path) const;
    /// True when the path is in the index with this content, and not stale.
    [[nodiscard]] core::Result<bool> is_unchanged(const std::string& source_path, std::uint64_t content_hash,
                                                  std::uint64_t file_size) const;
    /// Gives a model another name and class without describing it again. BadArgument if there is no such id.
    [[nodiscard]] core::Result<void> relabel(std::int64_t id, const std::string& name, const std::string& class_name);
    /// BadArgument if there is no such id.
    [[nodiscard]] core::Result<void> remove(std::int64_t id);

    /// All models in the order of ids, without blobs.
    [[nodiscard]] core::Result<std::vector<ModelEntry>> list() const;
    /// What a search needs, of one moment. 1,000 models take some 150 ms of one core, most of it measuring their parts,
    /// which `jobs` threads share.
    [[nodiscard]] core::Result<LoadedModels> load_views(int jobs = 1) const;
    /// One whole model, its mesh and thumbnails included. BadArgument if there is no such id.
    [[nodiscard]] core::Result<ModelRecord> load(std::int64_t id) const;
    /// BadArgument if there is no such id.
    [[nodiscard]] core::Result<core::TriangleMesh> load_display_mesh(std::int64_t id) const;
    /// The PNG of view 0 or 1; empty where the model has none. BadArgument if there is no such id.
    [[nodiscard]] core::Result<std::vector<std::byte>> load_thumbnail(std::int64_t id, int view) const;

    /// By which distance the neighbour lists are measured, in any spelling; nothing in an index without such lists.
    [[nodiscard]] core::Result<std::optional<std::string>> likeness_measure() const;
    /// Makes it an index with neighbour lists of this distance. Lists of another one are thrown away.
    [[nodiscard]] core::Result<void> keep_likeness(const std::string& measure);
    /// The lists, in the order of ids. Models that were added since have none; a list is short where a model was taken
    /// out of it, or a row is damaged: both are to be measured again.
    [[nodiscard]] core::Result<std::vector<NeighbourList>> neighbour_lists() const;
    /// Replaces the lists of these models in one transaction. What names a model that is no longer there is passed
    /// over. BadArgument where a list names its own model, or its distances are not finite, below 0 or not ascending.
    [[nodiscard]] core::Result<void> store_neighbours(std::span<const NeighbourList> lists);

    /// Looks at every page, reference, checksum and blob; empty when all is well. Goes on after each find.
    [[nodiscard]] core::Result<std::vector<Damage>> check() const;
    /// The models of which a row is missing or has not the checksum it was written with, in the order of ids: those
    /// that must be described again. Faster than check, and sees less.
    [[nodiscard]] core::Result<std::vector<std::int64_t>> damaged_models() const;
    /// Gives the space of removed models back to the disk. Needs as much free space as the index has.
    [[nodiscard]] core::Result<void> vacuum();
    [[nodiscard]] core::Result<IndexInfo> info() const;
    /// A sentence when some models are stale, else nothing.
    [[nodiscard]] core::Result<std::optional<std::string>> stale() const;

  private:
    TwoViewIndex(Database database, IndexOptions options);
    [[nodiscard]] core::Result<std::int64_t> build_id();
    [[nodiscard]] core::Result<std::string> name_of(std::int64_t id) const;
    [[nodiscard]] core::Error no_such_model(std::int64_t id) const;

    Database database_;
    IndexOptions options_;
};

}  // namespace db
