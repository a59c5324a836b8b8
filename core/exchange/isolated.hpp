#pragma once
// Runs a piece of work in a process of its own, so that a third-party reader that crashes, never ends or eats the
// memory takes nothing of ours with it.

#include <cstddef>
#include <functional>
#include <string>

#include "core/base/result.hpp"

namespace core {

struct IsolationLimits {
    double processor_seconds = 10.0;             ///< of processor time
    std::size_t memory_bytes = 4ULL << 30;       ///< writable memory beyond what the caller holds
    std::size_t most_answer_bytes = 2ULL << 30;  ///< of the work's answer
};

/// The bytes that `work` returns, computed in a forked copy of this process; whatever else it changes is lost.
/// A crash, an exception, and an answer that is too long give BadFormat, too much memory BadMesh, too much time
/// BadFormat; a system that has no process to spare Internal; a copy ended by Ctrl-C or SIGTERM Cancelled. The copy
/// does not outlive the thread that asked. The work must not wait for other threads: the copy has none. Safe to call
/// from several threads. Costs about a millisecond more than the work itself, and memory for the answer.
[[nodiscard]] Result<std::string> run_isolated(const std::function<std::string()>& work, const IsolationLimits& limits);

}  // namespace core
