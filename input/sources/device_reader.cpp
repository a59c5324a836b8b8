#include "input/sources/device_reader.hpp"

#include <algorithm>
#include <utility>

namespace input {

void DeviceReader::start() {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void DeviceReader::stop() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

void DeviceReader::run(const std::stop_token& stop) {
    push_change(SourceEventKind::Attached);
    Step last = Step::Nothing;
    while (!stop.stop_requested() && last != Step::Gone) last = step();
    push_change(SourceEventKind::Detached);
    ended_.store(true, std::memory_order_release);
}

void DeviceReader::push_change(SourceEventKind kind) {
    SourceEvent event;
    event.kind = kind;
    event.device = device_.number;
    event.time_ns = now_ns();
    push(event);
}

void ReaderSet::add(std::unique_ptr<DeviceReader> reader) {
    const std::lock_guard lock(mutex_);
    known_.push_back(reader->device());
    reader->start();
    readers_.push_back(std::move(reader));
}

void ReaderSet::remove(std::uint32_t number) {
    std::unique_ptr<DeviceReader> reader;
    {
        const std::lock_guard lock(mutex_);
        const auto found =
            std::find_if(readers_.begin(), readers_.end(), [&](const auto& r) { return r->device().number == number; });
        if (found == readers_.end()) return;
        reader = std::move(*found);
        readers_.erase(found);
    }
    reader->stop();  // without the lock: it takes up to a tenth of a second
    const std::lock_guard lock(mutex_);
    leaving_.push_back(std::move(reader));
}

bool ReaderSet::alive(std::uint32_t number) const {
    const std::lock_guard lock(mutex_);
    return std::any_of(readers_.begin(), readers_.end(),
                       [&](const auto& r) { return r->device().number == number && !r->ended(); });
}

void ReaderSet::drain(std::vector<SourceEvent>& out) {
    const std::lock_guard lock(mutex_);
    const std::size_t start = out.size();
    SourceEvent event;
    for (auto* list : {&readers_, &leaving_}) {
        for (auto& reader : *list) {
            const bool over = reader->ended();  // asked first: what it pushed before is then in the queue
            while (reader->queue().pop(event)) out.push_back(event);
            if (!over) continue;
            lost_before_ += reader->queue().lost();
            reader->stop();
            reader.reset();
        }
        std::erase_if(*list, [](const auto& reader) { return reader == nullptr; });
    }
    std::stable_sort(out.begin() + static_cast<std::ptrdiff_t>(start), out.end(),
                     [](const SourceEvent& a, const SourceEvent& b) { return a.time_ns < b.time_ns; });
}

TraceDevice ReaderSet::device(std::uint32_t number) const {
    const std::lock_guard lock(mutex_);
    for (const TraceDevice& d : known_) {
        if (d.number == number) return d;
    }
    return {};
}

std::uint64_t ReaderSet::lost() const {
    const std::lock_guard lock(mutex_);
    std::uint64_t sum = lost_before_;
    for (const auto* list : {&readers_, &leaving_}) {
        for (const auto& reader : *list) sum += reader->queue().lost();
    }
    return sum;
}

void ReaderSet::problem(std::string sentence) {
    const std::lock_guard lock(mutex_);
    if (problems_.size() < 100) problems_.push_back(std::move(sentence));
}

std::vector<std::string> ReaderSet::take_problems() {
    const std::lock_guard lock(mutex_);
    return std::exchange(problems_, {});
}

void ReaderSet::clear() {
    std::vector<std::unique_ptr<DeviceReader>> all;
    {
        const std::lock_guard lock(mutex_);
        all = std::move(readers_);
        readers_.clear();
    }
    for (auto& reader : all) reader->stop();
    const std::lock_guard lock(mutex_);
    for (auto& reader : all) leaving_.push_back(std::move(reader));
}

}  // namespace input
