#pragma once
// Notices tablets that fall asleep: the cable or the radio is there, and the tablet no longer speaks.
//
// Silence tells only where speech was due. By hidraw a tablet that says when its pen leaves repeats itself for as long
// as the pen is near, even if nothing changes; so a pen that is near and gives nothing belongs to a tablet that sleeps.
// Event nodes leave out what did not change, and other tablets are silent without a pen: of those nobody can tell.

#include <cstdint>
#include <map>
#include <vector>

#include "input/sources/pen_source.hpp"

namespace input {

class SleepWatch {
  public:
    explicit SleepWatch(std::int64_t silence_ns = 2'000'000'000) : silence_ns_(silence_ns) {}

    /// Every event of a source. `device` is asked for what was attached, the rest of it for nothing.
    void see(const SourceEvent& event, const TraceDevice& device);
    /// Appends an Asleep event for each tablet that has fallen silent, once until it speaks again, in the order of
    /// their numbers, at the moment when the time ran out.
    void append_asleep(std::int64_t now_ns, std::vector<SourceEvent>& out);

  private:
    struct Watched {
        std::int64_t last_ns = 0;
        bool pen_near = false;
    };
    std::int64_t silence_ns_;
    std::map<std::uint32_t, Watched> devices_;
};

}  // namespace input
