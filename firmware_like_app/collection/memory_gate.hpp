#pragma once
// Keeps large pieces of work from being done at the same time.

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace app {

/// Lets work in as long as the sizes of all that is inside stay within a limit; what is larger than the limit is let in
/// alone. Those that wait are let in in any order.
class MemoryGate {
  public:
    explicit MemoryGate(std::uint64_t limit) : limit_(limit) {}

    /// Inside from its making to its end.
    class Pass {
      public:
        Pass(MemoryGate& gate, std::uint64_t size) : gate_(gate), size_(size) {
            std::unique_lock lock(gate_.mutex_);
            gate_.left_.wait(lock, [&] { return gate_.inside_ == 0 || gate_.used_ + size_ <= gate_.limit_; });
            gate_.used_ += size_;
            ++gate_.inside_;
        }
        Pass(const Pass&) = delete;
        Pass& operator=(const Pass&) = delete;
        ~Pass() {
            const std::lock_guard lock(gate_.mutex_);
            gate_.used_ -= size_;
            --gate_.inside_;
            gate_.left_.notify_all();
        }

      private:
        MemoryGate& gate_;
        std::uint64_t size_;
    };

  private:
    std::uint64_t limit_;
    std::uint64_t used_ = 0;
    std::size_t inside_ = 0;
    std::mutex mutex_;
    std::condition_variable left_;
};

}  // namespace app
