#pragma once
// One device, its thread, and the queue between that thread and the one that draws.

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "input/sources/pen_source.hpp"
#include "input/sources/spsc_queue.hpp"

namespace input {

/// Four seconds at 266 Hz: more than the longest pause that a program may make and still be called alive.
inline constexpr std::size_t kQueueEvents = 1024;

/// Reads from one device until it is gone or the reader ends. What is read goes into the queue.
class DeviceReader {
  public:
    using Queue = SpscQueue<SourceEvent>;

    virtual ~DeviceReader() = default;
    DeviceReader(const DeviceReader&) = delete;
    DeviceReader& operator=(const DeviceReader&) = delete;

    /// Starts the thread; once. Attached is the first event.
    void start();
    /// Ends the thread and waits for it: a derived class calls this in its destructor, before its members go.
    void stop();

    [[nodiscard]] const TraceDevice& device() const { return device_; }
    /// Only the thread that draws.
    [[nodiscard]] Queue& queue() { return queue_; }
    /// The device is gone and nothing more comes.
    [[nodiscard]] bool ended() const { return ended_.load(std::memory_order_acquire); }

  protected:
    DeviceReader(TraceDevice device, Clock clock, std::size_t queue_events)
        : device_(std::move(device)), clock_(std::move(clock)), queue_(queue_events) {}

    enum class Step { Read, Nothing, Gone };
    /// Waits a tenth of a second at most for the device and pushes what came. On the reader's thread.
    virtual Step step() = 0;

    void push(const SourceEvent& event) { queue_.push(event); }
    [[nodiscard]] std::int64_t now_ns() const { return clock_(); }

  private:
    void run(const std::stop_token& stop);
    void push_change(SourceEventKind kind);

    TraceDevice device_;
    Clock clock_;
    Queue queue_;
    std::atomic<bool> ended_{false};
    std::jthread thread_;
};

/// The readers of a source, and the rest of PenSource made of them.
class ReaderSet {
  public:
    void add(std::unique_ptr<DeviceReader> reader);
    /// Whether the device still reads.
    [[nodiscard]] bool alive(std::uint32_t number) const;
    /// Ends the reader of this device number.
    void remove(std::uint32_t number);
    void drain(std::vector<SourceEvent>& out);
    [[nodiscard]] TraceDevice device(std::uint32_t number) const;
    [[nodiscard]] std::uint64_t lost() const;
    void problem(std::string sentence);
    [[nodiscard]] std::vector<std::string> take_problems();
    /// Ends all.
    void clear();

  private:
    mutable std::mutex mutex_;  ///< over the list, not over the queues: attaching is rare
    std::vector<std::unique_ptr<DeviceReader>> readers_;
    std::vector<std::unique_ptr<DeviceReader>> leaving_;  ///< ended, still to be drained
    std::vector<TraceDevice> known_;
    std::vector<std::string> problems_;
    std::uint64_t lost_before_ = 0;
};

}  // namespace input
