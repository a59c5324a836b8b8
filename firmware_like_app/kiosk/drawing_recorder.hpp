#pragma once
// Keeps what visitors draw, as traces that can be replayed and queried again.

#include <filesystem>
#include <string>

#include "core/base/result.hpp"
#include "core/stroke/stroke.hpp"

namespace app {

/// One of NAME-0001.trace, NAME-0002.trace … that the folder does not have: the first, or where some were taken out the
/// first behind others that are there. Looks at few files however many there are: stations record for months.
[[nodiscard]] std::filesystem::path next_free(const std::filesystem::path& folder, const std::string& name);

class DrawingRecorder {
  public:
    /// An empty folder name keeps nothing.
    explicit DrawingRecorder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Writes the drawing (places, pressure and times, to the bit) to the next free drawing-NNNN.trace. An empty
    /// drawing is passed over. ErrorCode::WriteFailed naming the file.
    [[nodiscard]] core::Result<void> keep(const core::Drawing& drawing);

  private:
    std::filesystem::path folder_;
};

}  // namespace app
