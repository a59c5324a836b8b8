#pragma once
// Tablets by libinput: what a desktop would see of them. For comparison with evdev_source.hpp, which has the raw
// frames, and for tablets that only libinput's quirks make work. No raw records; libinput averages a tablet's last
// places unless its quirks say otherwise, and begins strokes at its own pressure. libinput is only in
// libinput_source.cpp.

#include <memory>
#include <string>
#include <vector>

#include "input/sources/device_reader.hpp"

namespace input {

struct LibinputSourceOptions {
    Clock clock = monotonic_clock();   ///< of attached and detached; samples have libinput's time
    DeviceNumbers* numbers = nullptr;  ///< shared by all sources of the program; must outlive the source
    std::size_t queue_events = kQueueEvents;
    std::vector<std::string> nodes{};  ///< event nodes to open; none: the seat's, with hot-plug by udev
    std::string seat = "seat0";
};

class LibinputSource final : public PenSource {
  public:
    explicit LibinputSource(LibinputSourceOptions options);
    ~LibinputSource() override;
    LibinputSource(const LibinputSource&) = delete;
    LibinputSource& operator=(const LibinputSource&) = delete;

    void drain(std::vector<SourceEvent>& out) override;
    [[nodiscard]] TraceDevice device(std::uint32_t number) const override;
    [[nodiscard]] std::uint64_t lost() const override;
    [[nodiscard]] std::vector<std::string> take_problems() override;
    [[nodiscard]] std::string_view name() const override { return "libinput"; }

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace input
