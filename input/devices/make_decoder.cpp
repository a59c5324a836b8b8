#include "input/devices/make_decoder.hpp"

#include <algorithm>

#include "input/devices/uclogic_strings.hpp"

namespace input {
namespace {

std::optional<PenAxes> axes_of_strings(AxesFrom from, const UsbStrings& strings) {
    const auto take = [&](std::uint8_t index, auto read) -> std::optional<PenAxes> {
        const auto found = strings.find(index);
        if (found == strings.end()) return std::nullopt;
        return read(found->second);
    };
    if (from == AxesFrom::String200) return take(200, axes_of_string_200);
    if (from == AxesFrom::String100 || from == AxesFrom::SizeOfString100) return take(100, axes_of_string_100);
    return std::nullopt;
}

/// Fills the axes of `to` that are missing.
void complete(PenAxes& to, const PenAxes& from) {
    for (const auto& [name, range] : kNamedAxes) {
        if (!(to.*range)) to.*range = from.*range;
    }
}

/// No axis without a field.
void drop_unused(PenLayout& layout) {
    const auto keep = [&](std::optional<AxisRange>& axis, PenRole role) {
        if (!layout.has(role)) axis.reset();
    };
    keep(layout.axes.pressure, PenRole::Pressure);
    keep(layout.axes.tilt_x, PenRole::TiltX);
    keep(layout.axes.tilt_y, PenRole::TiltY);
    keep(layout.axes.rotation, PenRole::Rotation);
    keep(layout.axes.distance, PenRole::Distance);
    keep(layout.axes.wheel, PenRole::Wheel);
}

void set_size(PenAxes& axes, const std::optional<std::array<double, 2>>& size_mm) {
    if (!size_mm) return;
    if (axes.x) axes.x->per_unit = axes.x->span() / (*size_mm)[0];
    if (axes.y) axes.y->per_unit = axes.y->span() / (*size_mm)[1];
}

/// The size that a string gives, put on ranges that have none.
void lend_size(PenAxes& to, const PenAxes& sized) {
    const auto lend = [](std::optional<AxisRange>& a, const std::optional<AxisRange>& b) {
        if (a && b && a->per_unit == 0.0 && b->per_unit > 0.0) a->per_unit = a->span() * b->per_unit / b->span();
    };
    lend(to.x, sized.x);
    lend(to.y, sized.y);
}

/// Tablets that still report as mice leave out their size, but their strings tell it.
void lend_size_of_strings(PenAxes& axes, const UsbStrings& strings) {
    for (const AxesFrom from : {AxesFrom::String200, AxesFrom::String100}) {
        if (const auto told = axes_of_strings(from, strings)) lend_size(axes, *told);
    }
}

PenLayout from_file(const FileLayout& file_layout, const std::vector<PenLayout>& described, const UsbStrings& strings) {
    PenLayout layout = file_layout.layout;
    const std::optional<PenAxes> told = axes_of_strings(file_layout.axes_from, strings);
    const bool only_size = file_layout.axes_from == AxesFrom::SizeOfString100;
    if (told && !only_size) complete(layout.axes, *told);
    for (const PenLayout& d : described) {
        if (d.report_id == layout.report_id) complete(layout.axes, d.axes);
    }
    if (told) complete(layout.axes, *told);
    if (told && only_size) lend_size(layout.axes, *told);
    drop_unused(layout);
    return layout;
}

}  // namespace

std::vector<PenLayout> make_layouts(const DeviceFile* file, const std::optional<ReportDescriptor>& descriptor,
                                    const UsbStrings& strings) {
    std::vector<PenLayout> described;
    if (descriptor) described = find_pens(*descriptor);
    std::vector<PenLayout> layouts;
    if (file != nullptr) {
        for (const FileLayout& l : file->layouts) layouts.push_back(from_file(l, described, strings));
    }
    const std::size_t of_file = layouts.size();
    for (const PenLayout& d : described) {
        const bool named = std::any_of(layouts.begin(), layouts.begin() + static_cast<std::ptrdiff_t>(of_file),
                                       [&](const PenLayout& l) { return l.report_id == d.report_id; });
        if (!named) layouts.push_back(d);
    }
    for (PenLayout& l : layouts) lend_size_of_strings(l.axes, strings);
    if (file != nullptr) {
        for (PenLayout& l : layouts) {
            complete(l.axes, file->axes);
            drop_unused(l);
            set_size(l.axes, file->size_mm);
        }
    }
    return layouts;
}

std::unique_ptr<PenDecoder> make_decoder(const DeviceFile* file, const std::optional<ReportDescriptor>& descriptor,
                                         const UsbStrings& strings) {
    if (file != nullptr && file->parser == "wacom-intuos") {
        WacomIntuosOptions options;
        options.axes = file->axes;
        options.fine = file->fine;
        set_size(options.axes, file->size_mm);
        return make_wacom_intuos_decoder(std::move(options));
    }
    std::vector<PenLayout> layouts = make_layouts(file, descriptor, strings);
    if (layouts.empty()) return nullptr;
    const bool fields = file != nullptr && !file->layouts.empty();
    return make_layout_decoder(std::move(layouts), fields ? "fields" : "descriptor");
}

}  // namespace input
