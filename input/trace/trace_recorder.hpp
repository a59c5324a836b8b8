#pragma once
// Writes a trace while pens draw, on a thread of its own: the pen's path hands events over and never waits for a disk.

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.hpp"
#include "input/sources/pen_source.hpp"

namespace input {

class TraceRecorder {
  public:
    /// Begins a new file. WriteFailed when it cannot be made; an existing file is not overwritten but refused.
    [[nodiscard]] static core::Result<std::unique_ptr<TraceRecorder>> create(const std::string& path);
    /// Writes what is left and closes.
    ~TraceRecorder();
    TraceRecorder(const TraceRecorder&) = delete;
    TraceRecorder& operator=(const TraceRecorder&) = delete;

    /// One thread only. `source` is asked for the device when one is attached. Never waits; what does not fit is
    /// counted.
    void record(const SourceEvent& event, const PenSource& source);
    void mark(std::int64_t time_ns, std::string text);

    /// Events that could not be kept because the disk was too slow, or full.
    [[nodiscard]] std::uint64_t lost() const;
    /// Records written so far.
    [[nodiscard]] std::uint64_t written() const;

  private:
    struct Impl;
    explicit TraceRecorder(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace input
