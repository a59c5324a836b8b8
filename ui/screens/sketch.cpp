#include "ui/screens/sketch.hpp"

#include <algorithm>
#include <cassert>

namespace ui {
namespace {

double distance_to_segment(core::Point p, core::Point a, core::Point b) {
    const core::Point along = b - a;
    const double squared = core::dot(along, along);
    const double t = squared > 0 ? std::clamp(core::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return core::distance(p, a + along * t);
}

bool touches(const core::Stroke& stroke, core::Point point, double reach) {
    core::Point before{stroke.samples.front().x, stroke.samples.front().y};
    for (const core::PenSample& s : stroke.samples) {
        const core::Point here{s.x, s.y};
        if (distance_to_segment(point, before, here) <= reach) return true;
        before = here;
    }
    return false;
}

}  // namespace

void Sketch::begin(const core::PenSample& sample, double width) {
    if (open_) end();
    drawing_.strokes.push_back({{sample}});
    widths_.push_back(width);
    open_ = true;
    ++revision_;
}

void Sketch::extend(const core::PenSample& sample) {
    assert(open_);
    std::vector<core::PenSample>& samples = drawing_.strokes.back().samples;
    if (samples.back().x == sample.x && samples.back().y == sample.y) return;
    samples.push_back(sample);
    ++revision_;
}

void Sketch::end() {
    if (!open_) return;
    open_ = false;
    ++revision_;
    record({true, {{drawing_.strokes.size() - 1, drawing_.strokes.back(), widths_.back()}}});
}

void Sketch::take_back() {
    if (!open_ && erasing_.strokes.empty()) return;
    if (open_) remove(drawing_.strokes.size() - 1);
    open_ = false;
    add_back(erasing_);
    erasing_ = {};
    ++epoch_;
    ++revision_;
}

void Sketch::record(Step step) {
    done_.push_back(std::move(step));
    undone_.clear();
}

bool Sketch::erase_at(core::Point point, double reach) {
    bool any = false;
    for (std::size_t i = drawing_.strokes.size(); i-- > 0;) {
        if (!touches(drawing_.strokes[i], point, reach)) continue;
        // taken out in this order, put back in the opposite one, so places stay true
        erasing_.strokes.insert(erasing_.strokes.begin(), {i, std::move(drawing_.strokes[i]), widths_[i]});
        remove(i);
        any = true;
    }
    if (any) {
        ++epoch_;
        ++revision_;
    }
    return any;
}

void Sketch::end_erasing() {
    if (!erasing_.strokes.empty()) record(std::move(erasing_));
    erasing_ = {};
}

void Sketch::clear() {
    end();
    end_erasing();
    if (empty()) return;
    Step step;
    step.strokes.reserve(drawing_.strokes.size());
    for (std::size_t i = drawing_.strokes.size(); i-- > 0;) {
        step.strokes.push_back({0, std::move(drawing_.strokes[i]), widths_[i]});
    }
    drawing_.strokes.clear();
    widths_.clear();
    ++epoch_;
    ++revision_;
    record(std::move(step));
}

void Sketch::forget() {
    const std::uint64_t epoch = epoch_ + 1, revision = revision_ + 1;
    *this = Sketch();
    epoch_ = epoch;
    revision_ = revision;
}

void Sketch::remove(std::size_t i) {
    drawing_.strokes.erase(drawing_.strokes.begin() + static_cast<std::ptrdiff_t>(i));
    widths_.erase(widths_.begin() + static_cast<std::ptrdiff_t>(i));
}

void Sketch::add_back(const Step& step) {
    for (const Step::Placed& s : step.strokes) {
        drawing_.strokes.insert(drawing_.strokes.begin() + static_cast<std::ptrdiff_t>(s.place), s.stroke);
        widths_.insert(widths_.begin() + static_cast<std::ptrdiff_t>(s.place), s.width);
    }
}

void Sketch::take_out(const Step& step) {
    std::for_each(step.strokes.rbegin(), step.strokes.rend(), [&](const auto& placed) { remove(placed.place); });
}

void Sketch::undo() {
    if (!can_undo()) return;
    Step step = std::move(done_.back());
    done_.pop_back();
    if (step.added) {
        take_out(step);
    } else {
        add_back(step);
    }
    undone_.push_back(std::move(step));
    ++epoch_;
    ++revision_;
}

void Sketch::redo() {
    if (!can_redo()) return;
    Step step = std::move(undone_.back());
    undone_.pop_back();
    if (step.added) {
        add_back(step);
    } else {
        take_out(step);
    }
    done_.push_back(std::move(step));
    ++epoch_;
    ++revision_;
}

}  // namespace ui
