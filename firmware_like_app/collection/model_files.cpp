#include "firmware_like_app/collection/model_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>

#include "core/base/checksum.hpp"
#include "core/exchange/mesh_file_check.hpp"
#include "core/exchange/mesh_reader.hpp"

namespace app {

namespace fs = std::filesystem;

namespace {

class Search {
  public:
    void add(const std::string& path) {
        std::error_code error;
        const fs::file_status status = fs::status(path, error);
        if (status.type() == fs::file_type::directory) {
            const std::size_t before = files_.size() + unreadable_.size();
            search(path);
            if (files_.size() + unreadable_.size() == before && !holds_known_files(path)) {
                unreadable_.push_back(
                    {path,
                     "there is no 3D model in it; give a folder with OFF, OBJ, STL, PLY, glTF, DAE or "
                     "3DS files"});
            }
        } else if (fs::exists(status)) {
            files_.insert(canonical_path(path));
        } else if (status.type() == fs::file_type::not_found) {
            unreadable_.push_back({path, "there is no such file or folder; check the path"});
        } else {
            unreadable_.push_back({path, "it cannot be reached; check the permissions"});
        }
    }

    [[nodiscard]] ModelFiles take() {
        std::sort(unreadable_.begin(), unreadable_.end(),
                  [](const PassedOver& a, const PassedOver& b) { return a.file < b.file; });
        return {{files_.begin(), files_.end()}, std::move(unreadable_)};
    }

  private:
    void search(const fs::path& folder) {
        std::error_code error;
        fs::directory_iterator entries(folder, error);
        for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
            std::error_code ignored;
            const fs::directory_entry& entry = *entries;
            if (entry.is_directory(ignored) && !entry.is_symlink(ignored)) {
                search(entry.path());
            } else if (core::has_mesh_extension(entry.path()) && entry.is_regular_file(ignored)) {
                files_.insert(canonical_path(entry.path().string()));
            }
        }
        if (error) unreadable_.push_back({folder.string(), "the folder cannot be read; check its permissions"});
    }

    /// A folder named twice brings nothing new the second time, but is not empty.
    [[nodiscard]] bool holds_known_files(const std::string& folder) const {
        const std::string inside = canonical_path(folder) + "/";
        const auto next = files_.lower_bound(inside);
        return next != files_.end() && next->starts_with(inside);
    }

    std::set<std::string> files_;
    std::vector<PassedOver> unreadable_;
};

}  // namespace

std::string canonical_path(const std::string& path) {
    std::error_code error;
    const fs::path full = fs::weakly_canonical(path, error);
    std::string text = (error ? fs::path(path) : full).string();
    if (text.size() > 1 && text.ends_with('/')) text.pop_back();
    return text;
}

ModelFiles find_model_files(const std::vector<std::string>& paths) {
    Search search;
    for (const std::string& path : paths) search.add(path);
    return search.take();
}

core::Result<FileContent> content_of(const std::string& path) {
    if (const auto plain = core::check_plain_file(path, core::kLargestMeshFileBytes); !plain) {
        return core::unexpected(plain.error());
    }
    std::ifstream file(path, std::ios::binary);
    FileContent content;
    content.hash = core::fnv1a64({});
    std::vector<char> block(1 << 16);
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0) {
        const std::span<const char> read(block.data(), static_cast<std::size_t>(file.gcount()));
        content.hash = core::fnv1a64(std::as_bytes(read), content.hash);
        content.size += read.size();
    }
    if (!file.eof()) {
        return core::unexpected(core::ErrorCode::FileUnreadable, "the file cannot be read; check its permissions",
                                path);
    }
    return content;
}

}  // namespace app
