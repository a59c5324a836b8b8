#pragma once
// Bodies of the studio's own, in a folder of model files: listed to be chosen from, read beside the pen, and kept for
// the designs that are drawn on them.

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/garment/design.hpp"
#include "ui/screens/garment_screen.hpp"

namespace app {

class GarmentBodyFiles {
  public:
    /// `root`: the folder; empty: none are offered. Nothing above it is shown. `own_thread` false: `choose` reads
    /// before it returns.
    GarmentBodyFiles(std::filesystem::path root, bool own_thread);
    ~GarmentBodyFiles();
    GarmentBodyFiles(const GarmentBodyFiles&) = delete;
    GarmentBodyFiles& operator=(const GarmentBodyFiles&) = delete;

    [[nodiscard]] bool offered() const { return !root_.empty(); }
    /// Lists the root: folders first, then model files, by name; what begins with a dot is left out.
    void open();
    void up();
    void earlier();
    void later();
    /// A row that is shown: enters a folder, or begins to read a file.
    void choose(std::size_t row);
    /// The file that was read and can be worn, once; a fault is told by `state`.
    [[nodiscard]] std::optional<std::string> take();
    /// What was chosen is not wanted any more.
    void forget();
    [[nodiscard]] ui::BodyFiles state() const;

    /// Bodies by file: those that were read here at once, others from their file. May be called from any thread, and
    /// outlive this.
    [[nodiscard]] core::FormSource source() const;

  private:
    /// A body that was read, for every thread that asks.
    struct Shelf {
        std::mutex mutex;
        std::map<std::string, std::shared_ptr<const core::DressForm>> forms;
        [[nodiscard]] core::Result<core::DressForm> form(const std::string& file);
    };
    struct Reading;
    void list(const std::filesystem::path& folder);
    void read(const std::string& file);

    std::filesystem::path root_, folder_;
    bool own_thread_;
    std::vector<std::filesystem::path> entries_;
    std::size_t folders_ = 0, first_ = 0;
    std::string problem_;
    std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
    std::shared_ptr<Reading> reading_;
    std::jthread thread_;
};

}  // namespace app
