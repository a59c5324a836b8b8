#pragma once
// A bounded queue between one writing and one reading thread, without locks: neither ever waits for the other.
//
// A full queue refuses the new element and counts it: what was read first stays, and nothing is lost in silence.

#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace input {

template <typename T>
class SpscQueue {
    static_assert(std::is_trivially_copyable_v<T>, "elements are copied without a thought");

  public:
    /// `capacity` is a power of two.
    explicit SpscQueue(std::size_t capacity) : slots_(capacity), mask_(capacity - 1) {
        assert(capacity > 0 && (capacity & mask_) == 0);
    }

    /// Only the writing thread. False, and counted, when the queue is full.
    bool push(const T& value) {
        const std::size_t head = head_.load(std::memory_order_relaxed);
        if (head - tail_.load(std::memory_order_acquire) == slots_.size()) {
            lost_.fetch_add(1, std::memory_order_relaxed);
            return false;
        }
        slots_[head & mask_] = value;
        head_.store(head + 1, std::memory_order_release);
        return true;
    }

    /// Only the reading thread. False when the queue is empty.
    bool pop(T& value) {
        const std::size_t tail = tail_.load(std::memory_order_relaxed);
        if (tail == head_.load(std::memory_order_acquire)) return false;
        value = slots_[tail & mask_];
        tail_.store(tail + 1, std::memory_order_release);
        return true;
    }

    /// Elements refused so far; any thread.
    [[nodiscard]] std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }
    /// Elements that wait; exact only for a thread that uses the queue.
    [[nodiscard]] std::size_t size() const {
        return head_.load(std::memory_order_acquire) - tail_.load(std::memory_order_acquire);
    }

  private:
    std::vector<T> slots_;
    std::size_t mask_;
    alignas(64) std::atomic<std::size_t> head_{0};
    alignas(64) std::atomic<std::size_t> tail_{0};
    alignas(64) std::atomic<std::uint64_t> lost_{0};
};

}  // namespace input
