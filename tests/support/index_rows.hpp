#pragma once
// All that an index says about its models, as text: two indexes are the same when this is.

#include <stdexcept>
#include <string>

#include "db/migrations/migrations.hpp"

namespace support {

/// Every row with its id and checksums. Throws with a sentence where the index cannot be read.
inline std::string index_rows(const std::string& path) {
    const auto database = db::open_collection(path, db::OpenMode::ReadOnly);
    if (!database) throw std::runtime_error(database.error().sentence());
    std::string text;
    for (const char* sql :
         {"SELECT id || ' ' || parameters || ' ' || parameters_hash || ' ' || program_version FROM build ORDER BY id",
          "SELECT id || ' ' || source_path || ' ' || name || ' ' || class_name || ' ' || content_hash || ' ' || "
          "file_size "
          "|| ' ' || build_id || ' ' || checksum FROM model ORDER BY id",
          "SELECT model_id || ' ' || number || ' ' || camera_number || ' ' || skeletal_length || ' ' || asymmetry || ' "
          "' "
          "|| checksum || ' ' || hex(camera) || ' ' || hex(outline) || ' ' || hex(descriptor) || ' ' || hex(contour) "
          "FROM view "
          "ORDER BY model_id, number",
          "SELECT model_id || ' ' || hex(mesh) FROM display_mesh ORDER BY model_id",
          "SELECT model_id || ' ' || number || ' ' || hex(png) FROM thumbnail ORDER BY model_id, number",
          "SELECT measure FROM likeness",
          "SELECT model_id || ' ' || place || ' ' || other_id || ' ' || distance || ' ' || checksum FROM neighbour "
          "ORDER BY model_id, place"}) {
        auto rows = database->prepare(sql);
        if (!rows) throw std::runtime_error(rows.error().sentence());
        for (;;) {
            const auto row = rows->step();
            if (!row) throw std::runtime_error(row.error().sentence());
            if (!*row) break;
            text += rows->text(0) + "\n";
        }
    }
    return text;
}

}  // namespace support
