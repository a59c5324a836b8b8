#pragma once
// Keeps what visitors draw, as files that can be replayed and queried again.

#include <filesystem>

#include "core/base/result.hpp"
#include "core/stroke/stroke.hpp"

namespace app {

class DrawingRecorder {
  public:
    /// An empty folder name keeps nothing.
    explicit DrawingRecorder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Writes the drawing as one Quick-Draw line (x, y, milliseconds for every stroke) to the next free
    /// drawing-NNNN.ndjson. An empty drawing is passed over. ErrorCode::WriteFailed naming the file.
    [[nodiscard]] core::Result<void> keep(const core::Drawing& drawing);

  private:
    std::filesystem::path folder_;
    int next_ = 1;
};

}  // namespace app
