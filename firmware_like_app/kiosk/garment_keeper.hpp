#pragma once
// Keeps the design that is drawn: creates it with its first act, journals what follows beside the pen.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/garment/desk/garment_desk.hpp"
#include "core/silhouette/image.hpp"
#include "db/stores/design_journal.hpp"

namespace app {

class GarmentKeeper {
  public:
    /// `file`: of designs; empty: nothing is kept, and all of this does nothing.
    explicit GarmentKeeper(std::filesystem::path file) : file_(std::move(file)) {}

    [[nodiscard]] bool keeps() const { return !file_.empty(); }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// What happened at the desk since the last call. The first act opens the file, some milliseconds; after that it
    /// never waits.
    void take(core::GarmentDesk& desk);
    /// The journal goes on with this design, which was loaded from the file.
    void follow(std::int64_t id, std::int64_t sequence);
    /// What waits is stored; what comes next is another design. Gives the design that was kept.
    std::optional<std::int64_t> end();
    void set_thumbnail(const core::RgbaImage& picture);
    void rename(const std::string& name);

    [[nodiscard]] core::Result<db::OpenedDesign> load(std::int64_t id) const;
    /// Of the design at work; 0: it is not kept yet.
    [[nodiscard]] std::int64_t id() const { return id_; }
    /// Why something could not be stored; nothing while all is well.
    [[nodiscard]] std::optional<core::Error> problem() const;

  private:
    std::filesystem::path file_;
    std::unique_ptr<db::DesignJournal> journal_;
    std::int64_t id_ = 0;
    std::optional<core::Error> problem_;
};

}  // namespace app
