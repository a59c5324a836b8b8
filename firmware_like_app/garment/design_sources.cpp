#include "firmware_like_app/garment/design_sources.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "core/exchange/mesh_reader.hpp"
#include "core/mannequin/own_body.hpp"
#include "db/stores/two_view_index.hpp"

namespace app {
namespace {

/// The collection's list, read again when a model is asked for that it does not name: models are added meanwhile.
class IndexedModels {
  public:
    explicit IndexedModels(std::string path) : path_(std::move(path)) {}

    core::Result<core::TriangleMesh> mesh(const std::string& model) {
        auto found = find(model);
        if (found == entries_.end()) {
            if (const core::Result<void> read = read_list(); !read) return core::unexpected(read.error());
            found = find(model);
        }
        if (found == entries_.end())
            return core::unexpected(core::ErrorCode::FileMissing,
                                    "the model \"" + model + "\" is not in the collection", path_);
        return index_->load_display_mesh(found->id);
    }

  private:
    using Entries = std::vector<db::ModelEntry>;

    [[nodiscard]] Entries::const_iterator find(const std::string& model) const {
        const auto by = [&](auto member) {
            return std::find_if(entries_.begin(), entries_.end(),
                                [&](const db::ModelEntry& entry) { return entry.*member == model; });
        };
        const auto found = by(&db::ModelEntry::source_path);
        return found != entries_.end() ? found : by(&db::ModelEntry::name);
    }

    /// The file is opened anew: another may have taken its place.
    core::Result<void> read_list() {
        if (path_.empty()) return core::unexpected(core::ErrorCode::FileMissing, "there is no collection");
        core::Result<db::TwoViewIndex> index = db::TwoViewIndex::open(path_, db::OpenMode::ReadOnly);
        if (!index) return core::unexpected(index.error());
        core::Result<Entries> entries = index->list();
        if (!entries) return core::unexpected(entries.error());
        entries_ = std::move(*entries);
        index_.reset();
        index_.emplace(std::move(*index));
        return {};
    }

    std::string path_;
    std::optional<db::TwoViewIndex> index_;
    Entries entries_;
};

}  // namespace

core::FormSource bodies_by_file() {
    return [](const std::string& path) -> core::Result<core::DressForm> {
        const core::Result<core::TriangleMesh> mesh = core::read_mesh(path);
        if (!mesh) return core::unexpected(mesh.error());
        core::Result<core::TriangleMesh> stood = core::stand_body(*mesh);
        if (!stood) return core::unexpected(stood.error().code, stood.error().message, path);
        return core::dress_form(std::move(*stood));
    };
}

ModelSource models_of_index(const std::string& database) {
    return [models = std::make_shared<IndexedModels>(database)](const std::string& name) { return models->mesh(name); };
}

}  // namespace app
