// A minute of a pen at 266 reports a second beside a busy core: how many reports are lost, and how long one is on its
// way from the read into the queue.
//
//     pen_endurance [SECONDS] [RATE]
//
// The device is a pseudo-terminal pair, as in the tests with emulated tablets: a writer sends a report each period, a
// reader thread like the sources' own blocks in poll and read, decodes and pushes; the main thread drains sixty times a
// second, as the kiosk does; one more thread keeps a core busy for each core but one. Every report carries its number,
// so that a lost one is seen whatever lost it.

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "../support/hex_bytes.hpp"
#include "input/devices/make_decoder.hpp"
#include "input/sources/device_reader.hpp"

namespace {

constexpr std::size_t kReportBytes = 10;

std::int64_t now_ns() {
    return input::monotonic_clock()();
}

/// Reads, decodes, pushes; keeps how long each took after the read.
class TimedReader final : public input::DeviceReader {
  public:
    TimedReader(int fd, std::size_t expected)
        : DeviceReader(device_one(), input::monotonic_clock(), input::kQueueEvents), fd_(fd) {
        const auto descriptor = input::parse_report_descriptor(support::generic_pen_descriptor());
        decoder_ = input::make_decoder(nullptr, *descriptor, {});
        took_ns.reserve(expected + 16);
    }
    ~TimedReader() override { stop(); }

    std::vector<std::int64_t> took_ns;  ///< to be looked at after stop()

  private:
    static input::TraceDevice device_one() {
        input::TraceDevice d;
        d.number = 1;
        return d;
    }
    Step step() override {
        pollfd p{fd_, POLLIN, 0};
        if (poll(&p, 1, 100) <= 0) return Step::Nothing;
        std::array<std::uint8_t, 640> bytes;
        const ssize_t n = read(fd_, bytes.data(), bytes.size());
        if (n <= 0) return Step::Gone;
        for (std::size_t at = 0; at + kReportBytes <= static_cast<std::size_t>(n); at += kReportBytes) {
            const std::int64_t start = ::now_ns();
            input::SourceEvent event;
            event.device = 1;
            event.time_ns = start;
            const std::span<const std::uint8_t> report_bytes(bytes.data() + at, kReportBytes);
            event.set_raw(input::RawKind::HidReport, report_bytes);
            input::PenReport report;
            const input::PenAxes* axes = nullptr;
            if (decoder_->decode(report_bytes, report, axes)) {
                event.sample = to_sample(report, *axes, event.time_ns, 1);
                event.sample_valid = true;
            }
            push(event);
            took_ns.push_back(::now_ns() - start);
        }
        return Step::Read;
    }

    int fd_;
    std::unique_ptr<input::PenDecoder> decoder_;
};

double at_share(const std::vector<std::int64_t>& sorted, double share) {
    if (sorted.empty()) return 0.0;
    const auto i = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
    return static_cast<double>(sorted[i]) * 1e-6;
}

}  // namespace

int main(int argc, char** argv) {
    const double seconds = argc > 1 ? std::atof(argv[1]) : 60.0, rate = argc > 2 ? std::atof(argv[2]) : 266.0;
    const auto total = static_cast<std::uint32_t>(seconds * rate);
    int master = -1, slave = -1;
    termios raw{};
    cfmakeraw(&raw);
    if (openpty(&master, &slave, nullptr, &raw, nullptr) != 0) return 2;

    std::atomic<bool> over{false};
    std::vector<std::jthread> busy;
    for (unsigned core = 1; core < std::max(2U, std::thread::hardware_concurrency()); ++core) {
        busy.emplace_back([&] {
            volatile double x = 1.0;
            while (!over) x = x * 1.0000001 + 1e-9;
        });
    }
    auto reader = std::make_unique<TimedReader>(slave, total);
    reader->start();
    std::jthread writer([&] {
        const auto start = std::chrono::steady_clock::now();
        for (std::uint32_t i = 0; i < total; ++i) {
            std::this_thread::sleep_until(start + std::chrono::nanoseconds(static_cast<std::int64_t>(i * 1e9 / rate)));
            // x and y carry the report's number, 15 bits each.
            const std::uint32_t x = i & 0x7fffU, y = i >> 15U;
            const std::array<std::uint8_t, kReportBytes> report{7,
                                                                0x11,
                                                                static_cast<std::uint8_t>(x),
                                                                static_cast<std::uint8_t>(x >> 8U),
                                                                static_cast<std::uint8_t>(y),
                                                                static_cast<std::uint8_t>(y >> 8U),
                                                                1,
                                                                2,
                                                                0,
                                                                0};
            if (write(master, report.data(), report.size()) != static_cast<ssize_t>(report.size())) return;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        over = true;
    });

    std::uint32_t next = 0, missing = 0, seen = 0, most_waiting = 0;
    input::SourceEvent event;
    while (!over) {
        std::this_thread::sleep_for(std::chrono::microseconds(16'667));
        most_waiting = std::max(most_waiting, static_cast<std::uint32_t>(reader->queue().size()));
        while (reader->queue().pop(event)) {
            if (event.raw_size != kReportBytes) continue;
            const auto b = event.raw_data();
            const std::uint32_t number = (b[2] | b[3] << 8U) | static_cast<std::uint32_t>(b[4] | b[5] << 8U) << 15U;
            missing += number - next;
            next = number + 1;
            ++seen;
        }
    }
    missing += total - next;
    const std::uint64_t refused = reader->queue().lost();
    reader->stop();
    std::vector<std::int64_t> took = reader->took_ns;
    std::sort(took.begin(), took.end());
    std::printf("%u reports in %.0f s at %.0f Hz: %u seen, %u lost (%llu by a full queue), at most %u waiting\n", total,
                seconds, rate, seen, missing, static_cast<unsigned long long>(refused), most_waiting);
    std::printf("read to queue: median %.4f ms, p99 %.4f ms, p99.9 %.4f ms, longest %.4f ms\n", at_share(took, 0.5),
                at_share(took, 0.99), at_share(took, 0.999), at_share(took, 1.0));
    return missing == 0 ? 0 : 1;
}
