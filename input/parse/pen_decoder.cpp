#include "input/parse/pen_decoder.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace input {
namespace {

class LayoutDecoder final : public PenDecoder {
  public:
    LayoutDecoder(std::vector<PenLayout> layouts, std::string name)
        : layouts_(std::move(layouts)), name_(std::move(name)) {
        assert(!layouts_.empty());
        const auto richness = [](const PenLayout& l) {
            return std::pair(l.axes.pressure.has_value() + l.axes.tilt_x.has_value(),
                             l.axes.x ? l.axes.x->span() : 0.0);
        };
        main_ = std::max_element(layouts_.begin(), layouts_.end(),
                                 [&](const PenLayout& a, const PenLayout& b) { return richness(a) < richness(b); });
    }

    bool decode(std::span<const std::uint8_t> report, PenReport& out, const PenAxes*& axes) override {
        for (const PenLayout& layout : layouts_) {
            if (!layout.decode(report, out)) continue;
            axes = &layout.axes;
            return true;
        }
        return false;
    }
    [[nodiscard]] const PenAxes& axes() const override { return main_->axes; }
    [[nodiscard]] bool reports_range() const override {
        return std::all_of(layouts_.begin(), layouts_.end(), [](const PenLayout& l) { return l.reports_range(); });
    }
    [[nodiscard]] std::string_view name() const override { return name_; }

  private:
    std::vector<PenLayout> layouts_;
    std::vector<PenLayout>::const_iterator main_;
    std::string name_;
};

}  // namespace

std::unique_ptr<PenDecoder> make_layout_decoder(std::vector<PenLayout> layouts, std::string name) {
    return std::make_unique<LayoutDecoder>(std::move(layouts), std::move(name));
}

}  // namespace input
