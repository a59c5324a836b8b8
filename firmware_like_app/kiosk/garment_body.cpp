#include "firmware_like_app/kiosk/garment_body.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using core::Measure;

struct Slider {
    Measure measure;
    const char* key;
};
constexpr std::array<Slider, ui::kBodySliders> kSliders{{{Measure::Bust, "bust"},
                                                         {Measure::Waist, "waist"},
                                                         {Measure::Hip, "hip"},
                                                         {Measure::Neck, "neck"},
                                                         {Measure::Biacromial, "shoulder"},
                                                         {Measure::ArmLength, "arm_length"},
                                                         {Measure::WaistHeight, "waist_height"}}};
constexpr double kBeyond = 0.08;       // of the smallest and largest size
constexpr std::size_t kFirstSize = 1;  // 38

struct Range {
    double least = 0, most = 0;
};

Range range_of(Measure measure) {
    Range range{1e9, 0};
    for (const std::string& size : GarmentBody::sizes()) {
        const double cm = (*core::measures_of_size(size))[measure];
        range.least = std::min(range.least, cm);
        range.most = std::max(range.most, cm);
    }
    return {std::floor(range.least * (1 - kBeyond)), std::ceil(range.most * (1 + kBeyond))};
}

}  // namespace

const std::vector<std::string>& GarmentBody::sizes() {
    static const std::vector<std::string> all{"36", "38", "40", "42", "44", "m"};
    return all;
}

GarmentBody::GarmentBody() {
    choose_size(kFirstSize);
}

void GarmentBody::set(const core::BodyMeasures& measures) {
    measures_ = measures;
    if (const std::optional<std::size_t> found = size()) last_size_ = *found;
}

void GarmentBody::choose_size(std::size_t size) {
    last_size_ = std::min(size, sizes().size() - 1);
    measures_ = *core::measures_of_size(sizes()[last_size_]);
}

void GarmentBody::slide(std::size_t slider, double share) {
    const Range range = range_of(kSliders[slider].measure);
    set_measure(slider, range.least + (range.most - range.least) * std::clamp(share, 0.0, 1.0));
}

bool GarmentBody::write(std::size_t slider, double cm) {
    if (slider >= kSliders.size()) return false;
    const Range range = range_of(kSliders[slider].measure);
    if (!(cm >= range.least && cm <= range.most)) return false;
    set_measure(slider, cm);
    return true;
}

/// To the tenth of a centimetre.
void GarmentBody::set_measure(std::size_t slider, double wanted_cm) {
    const Measure measure = kSliders[slider].measure;
    const double before = measures_[measure], cm = std::round(wanted_cm * 10) / 10;
    measures_[measure] = cm;
    if (measure == Measure::Bust && before > 0) measures_[Measure::UnderBust] *= cm / before;
}

std::optional<std::size_t> GarmentBody::size() const {
    for (std::size_t i = 0; i < sizes().size(); ++i) {
        const core::BodyMeasures of_size = *core::measures_of_size(sizes()[i]);
        if (of_size.figure == measures_.figure && of_size.cm == measures_.cm) return i;
    }
    return std::nullopt;
}

ui::BodyDrawer GarmentBody::drawer() const {
    ui::BodyDrawer drawer;
    drawer.sizes = sizes();
    drawer.size = size();
    drawer.last_size = last_size_;
    for (std::size_t i = 0; i < kSliders.size(); ++i) {
        const Range range = range_of(kSliders[i].measure);
        drawer.measures[i] = {kSliders[i].key, measures_[kSliders[i].measure], range.least, range.most};
    }
    return drawer;
}

}  // namespace app
