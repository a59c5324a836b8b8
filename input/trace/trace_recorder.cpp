#include "input/trace/trace_recorder.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <mutex>
#include <thread>

#include "input/sources/spsc_queue.hpp"

namespace input {
namespace {

/// Half a minute at 266 Hz, for a disk that sleeps.
constexpr std::size_t kQueued = 8192;
constexpr auto kNap = std::chrono::milliseconds(20);

/// Writes all of it; false when the disk refuses.
bool write_all(int fd, std::string_view text) {
    while (!text.empty()) {
        const ssize_t n = write(fd, text.data(), text.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
}

}  // namespace

struct TraceRecorder::Impl {
    int fd = -1;
    SpscQueue<SourceEvent> queue{kQueued};
    std::mutex mutex;  ///< over devices and markers, which are rare
    std::deque<TraceDevice> devices;
    std::deque<TraceMarker> markers;
    std::atomic<std::uint64_t> written{0}, refused{0};
    std::jthread thread;

    void run(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            if (!write_waiting()) std::this_thread::sleep_for(kNap);
        }
        while (write_waiting()) {
        }
    }

    bool write_waiting() {
        std::vector<TraceRecord> records;
        SourceEvent event;
        while (records.size() < 4096 && queue.pop(event)) append_records(event, device_of(event), records);
        {
            const std::lock_guard lock(mutex);
            while (!markers.empty()) {
                records.emplace_back(std::move(markers.front()));
                markers.pop_front();
            }
        }
        std::string text;
        for (const TraceRecord& r : records) text += trace_line(r);
        if (text.empty()) return false;
        if (write_all(fd, text)) {
            written += records.size();
        } else {
            refused += records.size();
        }
        return true;
    }

    TraceDevice device_of(const SourceEvent& event) {
        if (event.kind != SourceEventKind::Attached) return {};
        const std::lock_guard lock(mutex);
        for (auto it = devices.begin(); it != devices.end(); ++it) {
            if (it->number != event.device) continue;
            TraceDevice d = std::move(*it);
            devices.erase(it);
            return d;
        }
        return {};
    }
};

TraceRecorder::TraceRecorder(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {
    impl_->thread = std::jthread([p = impl_.get()](const std::stop_token& stop) { p->run(stop); });
}

core::Result<std::unique_ptr<TraceRecorder>> TraceRecorder::create(const std::string& path) {
    auto impl = std::make_unique<Impl>();
    impl->fd = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0644);
    if (impl->fd < 0) {
        const bool there = errno == EEXIST;
        return core::unexpected(core::ErrorCode::WriteFailed,
                                there ? std::string("there is such a file already; give another name")
                                      : std::string("this cannot be written (") + std::strerror(errno) + ")",
                                path);
    }
    if (!write_all(impl->fd, trace_header())) {
        close(impl->fd);
        return core::unexpected(core::ErrorCode::WriteFailed, "this cannot be written; is the disk full?", path);
    }
    return std::unique_ptr<TraceRecorder>(new TraceRecorder(std::move(impl)));
}

TraceRecorder::~TraceRecorder() {
    impl_->thread.request_stop();
    impl_->thread.join();
    close(impl_->fd);
}

void TraceRecorder::record(const SourceEvent& event, const PenSource& source) {
    if (event.kind == SourceEventKind::Attached) {
        const std::lock_guard lock(impl_->mutex);
        impl_->devices.push_back(source.device(event.device));
    }
    impl_->queue.push(event);
}

void TraceRecorder::mark(std::int64_t time_ns, std::string text) {
    const std::lock_guard lock(impl_->mutex);
    impl_->markers.push_back({time_ns, std::move(text)});
}

std::uint64_t TraceRecorder::lost() const {
    return impl_->queue.lost() + impl_->refused.load();
}

std::uint64_t TraceRecorder::written() const {
    return impl_->written.load();
}

}  // namespace input
