#include "db/stores/model_rows.hpp"

#include <cmath>
#include <tuple>
#include <utility>

#include "core/base/checksum.hpp"
#include "db/codec/camera_codec.hpp"
#include "db/codec/contour_codec.hpp"
#include "db/codec/descriptor_codec.hpp"
#include "db/codec/mesh_codec.hpp"
#include "db/codec/png_signature.hpp"
#include "db/codec/points_codec.hpp"

namespace db {

namespace {

constexpr const char* kNotAsWritten = "it is damaged (its checksum differs); build the model again";

struct EncodedView {
    Blob camera, outline, descriptor, contour;
};

struct EncodedModel {
    std::array<EncodedView, 2> views;
    Blob mesh;
};

core::Result<EncodedView> encode_view(const ModelView& view) {
    if (!std::isfinite(view.skeletal_length) || !std::isfinite(view.asymmetry) || view.camera_number < 0) {
        return core::unexpected(core::ErrorCode::BadArgument, "a view's number, length or asymmetry is out of range");
    }
    if (!view.thumbnail.empty() && !is_png(view.thumbnail)) {
        return core::unexpected(core::ErrorCode::BadArgument, "a view's thumbnail is no PNG");
    }
    core::Result<Blob> camera = encode_camera(view.camera);
    if (!camera) return core::unexpected(camera.error());
    // The samples of the descriptor are the outline of most views, and need not be stored twice.
    const bool sampled = view.outline == view.descriptor.samples;
    core::Result<Blob> outline = encode_polygon(sampled ? core::Polygon() : view.outline);
    if (!outline) return core::unexpected(outline.error());
    core::Result<Blob> descriptor = encode_descriptor(view.descriptor);
    if (!descriptor) return core::unexpected(descriptor.error());
    core::Result<Blob> contour = encode_contour(view.contour);
    if (!contour) return core::unexpected(contour.error());
    return EncodedView{std::move(*camera), std::move(*outline), std::move(*descriptor), std::move(*contour)};
}

core::Result<EncodedModel> encode_model(const ModelRecord& model) {
    const auto refused = [&](core::Error error) {
        error.where = model.source_path;
        return core::unexpected(std::move(error));
    };
    if (model.source_path.empty()) {
        return core::unexpected(core::ErrorCode::BadArgument, "the model has no source path", model.name);
    }
    EncodedModel encoded;
    for (std::size_t i = 0; i < 2; ++i) {
        core::Result<EncodedView> view = encode_view(model.views[i]);
        if (!view) return refused(view.error());
        encoded.views[i] = std::move(*view);
    }
    core::Result<Blob> mesh = encode_mesh(model.display_mesh);
    if (!mesh) return refused(mesh.error());
    encoded.mesh = std::move(*mesh);
    return encoded;
}

std::uint64_t checksum_of_record(const ModelRecord& model) {
    ByteWriter out;
    out.text(model.source_path);
    out.text(model.name);
    out.text(model.class_name);
    out.u64(model.content_hash);
    out.u64(model.file_size);
    return checksum_of(out.bytes());
}

std::uint64_t checksum_of_view(const ModelView& view) {
    ByteWriter out;
    out.varint(static_cast<std::uint64_t>(view.camera_number));
    out.f64(view.skeletal_length + 0.0);  // SQLite does not keep the sign of zero
    out.f64(view.asymmetry + 0.0);
    return checksum_of(out.bytes());
}

void bind_with_checksum(Statement& statement, const Blob& blob) {
    statement.bind(BlobView(blob)).bind(checksum_of(blob));
}

template <typename T>
void decode_blob(BlobView blob, std::uint64_t checksum, core::Result<T> (*decode)(BlobView), T& value, Damage damage,
                 std::vector<Damage>& damaged) {
    if (checksum_of(blob) != checksum) {
        damage.message = kNotAsWritten;
        damaged.push_back(std::move(damage));
        return;
    }
    core::Result<T> decoded = decode(blob);
    if (decoded) {
        value = std::move(*decoded);
        return;
    }
    damage.message = decoded.error().message;
    damaged.push_back(std::move(damage));
}

}  // namespace

std::uint64_t checksum_of(BlobView blob) {
    return core::fnv1a64(blob);
}

std::uint64_t checksum_of(const std::string& text) {
    return core::fnv1a64(std::as_bytes(std::span(text)));
}

ModelWriter::ModelWriter(const Database& database, std::array<Statement, 9> statements)
    : database_(&database),
      find_(std::move(statements[0])),
      insert_(std::move(statements[1])),
      update_(std::move(statements[2])),
      insert_view_(std::move(statements[3])),
      insert_mesh_(std::move(statements[4])),
      delete_views_(std::move(statements[5])),
      delete_mesh_(std::move(statements[6])),
      insert_thumbnail_(std::move(statements[7])),
      forget_neighbours_(std::move(statements[8])) {}

core::Result<ModelWriter> ModelWriter::prepare(const Database& database) {
    core::Result<std::array<Statement, 9>> statements = prepare_all<9>(
        database, {"SELECT id FROM model WHERE source_path = ?",
                   "INSERT INTO model (source_path, name, class_name, content_hash, file_size, build_id, checksum) "
                   "VALUES (?, ?, ?, ?, ?, ?, ?)",
                   "UPDATE model SET source_path = ?, name = ?, class_name = ?, content_hash = ?, file_size = ?, "
                   "build_id = ?, checksum = ? WHERE id = ?",
                   "INSERT INTO view (model_id, number, camera_number, skeletal_length, asymmetry, checksum, camera, "
                   "camera_checksum, outline, outline_checksum, descriptor, descriptor_checksum, contour, "
                   "contour_checksum) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
                   "INSERT INTO display_mesh (model_id, mesh, mesh_checksum) VALUES (?, ?, ?)",
                   "DELETE FROM view WHERE model_id = ?", "DELETE FROM display_mesh WHERE model_id = ?",
                   "INSERT INTO thumbnail (model_id, number, png, png_checksum) VALUES (?, ?, ?, ?)",
                   "DELETE FROM neighbour WHERE model_id = ?1 OR other_id = ?1"});
    if (!statements) return core::unexpected(statements.error());
    return ModelWriter(database, std::move(*statements));
}

namespace {

Statement& bind_model(Statement& statement, const ModelRecord& model, std::int64_t build_id) {
    return statement.bind(model.source_path)
        .bind(model.name)
        .bind(model.class_name)
        .bind(model.content_hash)
        .bind(model.file_size)
        .bind(build_id)
        .bind(checksum_of_record(model));
}

}  // namespace

core::Result<void> ModelWriter::update(std::int64_t id, const ModelRecord& model, std::int64_t build_id) {
    return bind_model(update_, model, build_id).bind(id).run();
}

core::Result<std::int64_t> ModelWriter::write_model_row(const ModelRecord& model, std::int64_t build_id) {
    const core::Result<bool> there = find_.bind(model.source_path).step();
    if (!there) return core::unexpected(there.error());
    if (!*there) {
        if (const core::Result<void> done = bind_model(insert_, model, build_id).run(); !done) {
            return core::unexpected(done.error());
        }
        return database_->last_insert_id();
    }
    const std::int64_t id = find_.integer(0);
    find_.reset();
    core::Result<void> done = update(id, model, build_id);
    if (done) done = delete_views_.bind(id).run();
    if (done) done = delete_mesh_.bind(id).run();
    if (done) done = forget_neighbours_.bind(id).run();
    if (!done) return core::unexpected(done.error());
    return id;
}

core::Result<std::int64_t> ModelWriter::write(const ModelRecord& model, std::int64_t build_id) {
    const core::Result<EncodedModel> encoded = encode_model(model);
    if (!encoded) return core::unexpected(encoded.error());
    core::Result<std::int64_t> id = write_model_row(model, build_id);
    if (!id) return id;
    for (std::size_t i = 0; i < 2; ++i) {
        const ModelView& view = model.views[i];
        insert_view_.bind(*id).bind(i).bind(view.camera_number).bind(view.skeletal_length).bind(view.asymmetry);
        insert_view_.bind(checksum_of_view(view));
        bind_with_checksum(insert_view_, encoded->views[i].camera);
        bind_with_checksum(insert_view_, encoded->views[i].outline);
        bind_with_checksum(insert_view_, encoded->views[i].descriptor);
        bind_with_checksum(insert_view_, encoded->views[i].contour);
        core::Result<void> done = insert_view_.run();
        if (done && !view.thumbnail.empty()) {
            insert_thumbnail_.bind(*id).bind(i);
            bind_with_checksum(insert_thumbnail_, view.thumbnail);
            done = insert_thumbnail_.run();
        }
        if (!done) return core::unexpected(done.error());
    }
    insert_mesh_.bind(*id);
    bind_with_checksum(insert_mesh_, encoded->mesh);
    if (const core::Result<void> done = insert_mesh_.run(); !done) return core::unexpected(done.error());
    return id;
}

ModelReader::ModelReader(std::array<Statement, 4> statements)
    : model_(std::move(statements[0])),
      view_(std::move(statements[1])),
      mesh_(std::move(statements[2])),
      thumbnail_(std::move(statements[3])) {}

core::Result<ModelReader> ModelReader::prepare(const Database& database) {
    core::Result<std::array<Statement, 4>> statements = prepare_all<4>(
        database, {"SELECT source_path, name, class_name, content_hash, file_size, build_id, checksum FROM model "
                   "WHERE id = ?",
                   "SELECT camera_number, skeletal_length, asymmetry, checksum, camera, camera_checksum, outline, "
                   "outline_checksum, descriptor, descriptor_checksum, contour, contour_checksum FROM view "
                   "WHERE model_id = ? AND number = ?",
                   "SELECT mesh, mesh_checksum FROM display_mesh WHERE model_id = ?",
                   "SELECT png, png_checksum FROM thumbnail WHERE model_id = ? AND number = ?"});
    if (!statements) return core::unexpected(statements.error());
    return ModelReader(std::move(*statements));
}

namespace {

/// The plain columns of the present row, and whether they have their checksum.
std::pair<ModelRecord, bool> record_of(std::int64_t id, const Statement& row) {
    ModelRecord model;
    model.id = id;
    model.source_path = row.text(0);
    model.name = row.text(1);
    model.class_name = row.text(2);
    model.content_hash = static_cast<std::uint64_t>(row.integer(3));
    model.file_size = static_cast<std::uint64_t>(row.integer(4));
    const bool sound = checksum_of_record(model) == static_cast<std::uint64_t>(row.integer(6));
    return {std::move(model), sound};
}

}  // namespace

std::optional<StoredModel> ModelReader::fetch(std::int64_t id, std::vector<Damage>& damaged) {
    const core::Result<bool> row = model_.bind(id).step();
    if (!row) {
        damaged.push_back({id, {}, "record", row.error().message});
        return std::nullopt;
    }
    if (!*row) return std::nullopt;
    StoredModel stored;
    std::tie(stored.record, stored.sound) = record_of(id, model_);
    build_id_ = model_.integer(5);
    model_.reset();
    for (int number = 0; number < 2; ++number) {
        stored.views[static_cast<std::size_t>(number)] = fetch_view(id, number);
    }
    return stored;
}

std::optional<ModelRecord> ModelReader::read(std::int64_t id, std::vector<Damage>& damaged) {
    std::optional<StoredModel> stored = fetch(id, damaged);
    if (!stored) return std::nullopt;
    return decode_model(std::move(*stored), damaged);
}

StoredModel::StoredView ModelReader::fetch_view(std::int64_t id, int number) {
    StoredModel::StoredView view;
    const core::Result<bool> row = view_.bind(id).bind(number).step();
    if (!row || !*row) {
        view.fault = row ? "it is missing; build the model again" : row.error().message;
        return view;
    }
    view.camera_number = view_.integer(0);
    view.skeletal_length = view_.real(1);
    view.asymmetry = view_.real(2);
    view.checksum = static_cast<std::uint64_t>(view_.integer(3));
    int column = 4;
    for (StoredModel::StoredBlob* blob : {&view.camera, &view.outline, &view.descriptor, &view.contour}) {
        const BlobView bytes = view_.blob(column);
        blob->bytes.assign(bytes.begin(), bytes.end());
        blob->checksum = static_cast<std::uint64_t>(view_.integer(column + 1));
        column += 2;
    }
    view_.reset();
    return view;
}

namespace {

void decode_view(const StoredModel::StoredView& stored, int number, ModelRecord& model, std::vector<Damage>& damaged) {
    const std::string label = "view " + std::to_string(number);
    const auto damage = [&](const std::string& part, const std::string& message = {}) {
        return Damage{model.id, model.name, part, message};
    };
    if (!stored.fault.empty()) {
        damaged.push_back(damage(label, stored.fault));
        return;
    }
    ModelView& view = model.views[static_cast<std::size_t>(number)];
    view.camera_number = static_cast<int>(stored.camera_number);
    view.skeletal_length = stored.skeletal_length;
    view.asymmetry = stored.asymmetry;
    const bool sound = stored.camera_number == view.camera_number && view.camera_number >= 0;
    if (!sound || checksum_of_view(view) != stored.checksum) damaged.push_back(damage(label, kNotAsWritten));
    const auto decode = [&](const StoredModel::StoredBlob& blob, auto decoder, auto& value, const std::string& part) {
        decode_blob(blob.bytes, blob.checksum, decoder, value, damage(part + label), damaged);
    };
    decode(stored.camera, decode_camera, view.camera, "camera of ");
    decode(stored.outline, decode_polygon, view.outline, "outline of ");
    decode(stored.descriptor, decode_descriptor, view.descriptor, "descriptor of ");
    decode(stored.contour, decode_contour, view.contour, "contour of ");
    if (view.outline.empty()) view.outline = view.descriptor.samples;
}

}  // namespace

ModelRecord decode_model(StoredModel stored, std::vector<Damage>& damaged) {
    ModelRecord model = std::move(stored.record);
    if (!stored.sound) damaged.push_back({model.id, model.name, "record", kNotAsWritten});
    for (int number = 0; number < 2; ++number) {
        decode_view(stored.views[static_cast<std::size_t>(number)], number, model, damaged);
    }
    return model;
}

std::optional<core::TriangleMesh> ModelReader::read_mesh(std::int64_t id, const std::string& name,
                                                         std::vector<Damage>& damaged) {
    const core::Result<bool> row = mesh_.bind(id).step();
    if (!row || !*row) {
        damaged.push_back(
            {id, name, "display mesh", row ? "it is missing; build the model again" : row.error().message});
        return std::nullopt;
    }
    core::TriangleMesh mesh;
    const std::size_t before = damaged.size();
    decode_blob(mesh_.blob(0), static_cast<std::uint64_t>(mesh_.integer(1)), decode_mesh, mesh,
                {id, name, "display mesh", {}}, damaged);
    mesh_.reset();
    if (damaged.size() > before) return std::nullopt;
    return mesh;
}

std::vector<std::byte> ModelReader::read_thumbnail(std::int64_t id, int number, const std::string& name,
                                                   std::vector<Damage>& damaged) {
    const auto note = [&](const std::string& message) {
        damaged.push_back({id, name, "thumbnail of view " + std::to_string(number), message});
        thumbnail_.reset();
        return std::vector<std::byte>();
    };
    const core::Result<bool> row = thumbnail_.bind(id).bind(number).step();
    if (!row) return note(row.error().message);
    if (!*row) return {};
    const BlobView png = thumbnail_.blob(0);
    if (checksum_of(png) != static_cast<std::uint64_t>(thumbnail_.integer(1)) || !is_png(png)) {
        return note(kNotAsWritten);
    }
    std::vector<std::byte> bytes(png.begin(), png.end());
    thumbnail_.reset();
    return bytes;
}

namespace {

/// The blob in `column` against the checksum in the one after it.
bool is_blob_whole(const Statement& row, int column) {
    return checksum_of(row.blob(column)) == static_cast<std::uint64_t>(row.integer(column + 1));
}

/// Whether every row that a bound statement gives passes; false as well where there are fewer than `least`.
template <typename Test>
bool all_rows(Statement& statement, int least, const Test& test) {
    bool sound = true;
    int rows = 0;
    for (;;) {
        const core::Result<bool> row = statement.step();
        if (!row || !*row) {
            sound = sound && row && rows >= least;
            break;
        }
        ++rows;
        sound = sound && test(rows);
    }
    statement.reset();
    return sound;
}

}  // namespace

bool ModelReader::is_whole(std::int64_t id) {
    model_.bind(id);
    const bool record = all_rows(model_, 1, [&](int) { return record_of(id, model_).second; });
    mesh_.bind(id);
    const bool mesh = all_rows(mesh_, 1, [&](int) { return is_blob_whole(mesh_, 0); });
    return record && mesh && is_view_whole(id, 0) && is_view_whole(id, 1);
}

bool ModelReader::is_view_whole(std::int64_t id, int number) {
    view_.bind(id).bind(number);
    const bool view = all_rows(view_, 1, [&](int) {
        ModelView v;
        v.camera_number = static_cast<int>(view_.integer(0));
        v.skeletal_length = view_.real(1);
        v.asymmetry = view_.real(2);
        return view_.integer(0) >= 0 && checksum_of_view(v) == static_cast<std::uint64_t>(view_.integer(3)) &&
               is_blob_whole(view_, 4) && is_blob_whole(view_, 6) && is_blob_whole(view_, 8) &&
               is_blob_whole(view_, 10);
    });
    thumbnail_.bind(id).bind(number);
    const bool thumbnail = all_rows(thumbnail_, 0, [&](int) { return is_blob_whole(thumbnail_, 0); });
    return view && thumbnail;
}

}  // namespace db
