#pragma once
// One model <-> its rows in `model`, `view`, `thumbnail` and `display_mesh`, checksums included. Of use
// inside db/stores only.

#include <array>
#include <optional>
#include <vector>

#include "db/codec/bytes.hpp"
#include "db/stores/two_view_index.hpp"

namespace db {

/// Writes whole models. The caller holds the transaction.
class ModelWriter {
  public:
    [[nodiscard]] static core::Result<ModelWriter> prepare(const Database& database);
    /// Encodes first, so a model that is refused has touched nothing. Gives the id.
    [[nodiscard]] core::Result<std::int64_t> write(const ModelRecord& model, std::int64_t build_id);
    /// Writes the plain columns of a model that is there.
    [[nodiscard]] core::Result<void> update(std::int64_t id, const ModelRecord& model, std::int64_t build_id);

  private:
    ModelWriter(const Database& database, std::array<Statement, 9> statements);
    [[nodiscard]] core::Result<std::int64_t> write_model_row(const ModelRecord& model, std::int64_t build_id);

    const Database* database_;
    Statement find_, insert_, update_, insert_view_, insert_mesh_, delete_views_, delete_mesh_, insert_thumbnail_,
        forget_neighbours_;
};

/// A model's rows as they lie in the file, nothing of it decoded yet.
struct StoredModel {
    struct StoredBlob {
        Blob bytes;
        std::uint64_t checksum = 0;
    };
    struct StoredView {
        std::string fault;  ///< why there is none; empty where there is
        std::int64_t camera_number = 0;
        double skeletal_length = 0.0, asymmetry = 0.0;
        std::uint64_t checksum = 0;
        StoredBlob camera, outline, descriptor, contour;
    };
    ModelRecord record;  ///< the plain columns
    bool sound = true;   ///< these have their checksum
    std::array<StoredView, 2> views;
};

/// The plain columns and both views; what is damaged is appended. Most of the time that reading a model takes, and for
/// any thread.
[[nodiscard]] ModelRecord decode_model(StoredModel stored, std::vector<Damage>& damaged);

/// Reads models part by part, noting what is damaged and going on. Never throws a whole model away for its mesh.
class ModelReader {
  public:
    [[nodiscard]] static core::Result<ModelReader> prepare(const Database& database);

    /// The rows of a model for decode_model; nothing if there is no such model, or its row cannot be read, which is
    /// appended.
    [[nodiscard]] std::optional<StoredModel> fetch(std::int64_t id, std::vector<Damage>& damaged);
    /// Both in one.
    [[nodiscard]] std::optional<ModelRecord> read(std::int64_t id, std::vector<Damage>& damaged);
    [[nodiscard]] std::optional<core::TriangleMesh> read_mesh(std::int64_t id, const std::string& name,
                                                              std::vector<Damage>& damaged);
    /// A view's PNG; empty where there is none or it is damaged.
    [[nodiscard]] std::vector<std::byte> read_thumbnail(std::int64_t id, int number, const std::string& name,
                                                        std::vector<Damage>& damaged);
    /// Whether all rows of a model are there with the checksums they were written with. Decodes nothing, so it is fast:
    /// 1 ms for ten models.
    [[nodiscard]] bool is_whole(std::int64_t id);
    /// Of the model that was read last.
    [[nodiscard]] std::int64_t build_id() const { return build_id_; }

  private:
    explicit ModelReader(std::array<Statement, 4> statements);
    [[nodiscard]] bool is_view_whole(std::int64_t id, int number);
    [[nodiscard]] StoredModel::StoredView fetch_view(std::int64_t id, int number);

    Statement model_, view_, mesh_, thumbnail_;
    std::int64_t build_id_ = 0;
};

[[nodiscard]] std::uint64_t checksum_of(BlobView blob);
[[nodiscard]] std::uint64_t checksum_of(const std::string& text);

/// Prepares several statements at once, or gives the first failure.
template <std::size_t N>
[[nodiscard]] core::Result<std::array<Statement, N>> prepare_all(const Database& database,
                                                                 const std::array<const char*, N>& sql) {
    std::vector<Statement> statements;
    for (const char* text : sql) {
        core::Result<Statement> statement = database.prepare(text);
        if (!statement) return core::unexpected(statement.error());
        statements.push_back(std::move(*statement));
    }
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
        return std::array<Statement, N>{std::move(statements[I])...};
    }
    (std::make_index_sequence<N>());
}

}  // namespace db
