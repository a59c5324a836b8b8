// The kernel's own decoding of pens against ours. run.sh says how the two halves come together.
//
//     kernel_pen make WORK [DESCRIPTOR]...   devices and reports for the virtual machine
//     kernel_pen check WORK KERNEL           what its kernel printed, compared report by report

#include <linux/input-event-codes.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>

#include "../support/hex_bytes.hpp"
#include "input/devices/make_decoder.hpp"
#include "input/parse/evdev_pen.hpp"
#include "input/parse/pen_layout.hpp"

namespace {

using input::PenLayout;
using input::PenRole;

constexpr int kReportsEach = 60;
constexpr unsigned kWacom = 0x056a, kNobody = 0x1234;

std::string hex(const std::vector<std::uint8_t>& bytes) {
    std::string out;
    char two[3];
    for (const std::uint8_t b : bytes) {
        std::snprintf(two, sizeof two, "%02x", b);
        out += two;
    }
    return out;
}

std::vector<std::uint8_t> unhex(const std::string& text) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
        bytes.push_back(static_cast<std::uint8_t>(std::stoul(text.substr(i, 2), nullptr, 16)));
    }
    return bytes;
}

void set_bits(std::vector<std::uint8_t>& bytes, std::uint32_t offset, unsigned size, std::uint32_t value) {
    for (unsigned i = 0; i < size; ++i) {
        if (((value >> i) & 1U) != 0) bytes[(offset + i) / 8] |= static_cast<std::uint8_t>(1U << ((offset + i) % 8));
    }
}

/// What the pen does at a step: comes, hovers, draws with a button now and then, leaves; then the same with its other
/// end.
struct Step {
    bool near = false, tip = false, turned = false, barrel = false;
};
Step step_of(int i, bool has_invert) {
    const bool turned = has_invert && i >= kReportsEach / 2;
    const int k = i % (kReportsEach / 2);
    if (k < 1 || k > 27) return {};
    const bool tip = k >= 6 && k < 25;
    return {true, tip, turned, !turned && tip && k % 5 == 0};
}

std::vector<std::uint8_t> report_of(const PenLayout& layout, const Step& step, std::mt19937& random) {
    std::vector<std::uint8_t> bytes(layout.bytes, 0);
    if (layout.report_id != 0) bytes[0] = layout.report_id;
    const auto axis = [&](const input::PenField& f, const std::optional<input::AxisRange>& range) {
        std::uniform_int_distribution<std::int32_t> any(range->min, range->max);
        set_bits(bytes, f.bit_offset, f.bit_size, static_cast<std::uint32_t>(any(random)));
    };
    // Where some collection of a device has pressure and no tip switch, the kernel takes more than an eighth of the
    // pressure for a touch, in all collections: pressure without a touch would be told apart for no good reason.
    const auto pressure = [&](const input::PenField& f, const input::AxisRange& range) {
        const auto eighth = static_cast<std::int32_t>(range.span() / 8);
        std::uniform_int_distribution<std::int32_t> pressing(range.min + eighth + 1, range.max);
        set_bits(bytes, f.bit_offset, f.bit_size, static_cast<std::uint32_t>(step.tip ? pressing(random) : range.min));
    };
    for (const input::PenField& f : layout.fields) {
        bool on = false;
        switch (f.role) {
            case PenRole::X:
                axis(f, layout.axes.x);
                continue;
            case PenRole::Y:
                axis(f, layout.axes.y);
                continue;
            case PenRole::Pressure:
                pressure(f, *layout.axes.pressure);
                continue;
            case PenRole::TiltX:
                axis(f, layout.axes.tilt_x);
                continue;
            case PenRole::TiltY:
                axis(f, layout.axes.tilt_y);
                continue;
            case PenRole::InRange:
                on = step.near;
                break;
            case PenRole::Tip:
                on = step.tip && !(step.turned && layout.has(PenRole::Eraser));
                break;
            case PenRole::Invert:
                on = step.near && step.turned;
                break;
            case PenRole::Eraser:
                on = step.tip && step.turned;
                break;
            case PenRole::Barrel1:
                on = step.barrel;
                break;
            default:
                continue;
        }
        if (on && !f.in_array) set_bits(bytes, f.bit_offset, 1, 1);
    }
    return bytes;
}

/// The first pen of a descriptor that the kernel has a standard for.
std::optional<PenLayout> standard_pen(const std::vector<std::uint8_t>& bytes) {
    const auto descriptor = input::parse_report_descriptor(bytes);
    if (!descriptor) return std::nullopt;
    for (PenLayout& layout : input::find_pens(*descriptor)) {
        const bool standard = layout.name.starts_with("Pen") || layout.name.starts_with("Digitizer");
        if (standard && layout.has(PenRole::Tip) && layout.has(PenRole::InRange)) return std::move(layout);
    }
    return std::nullopt;
}

/// The packets of a Wacom Intuos: the pen announces itself, draws with values that jump, and leaves; then its eraser.
/// To the first ones, which are not `fine`, the lowest bit names another pen, for which their driver would ask and
/// wait.
std::vector<std::vector<std::uint8_t>> intuos_packets(std::mt19937& random, bool fine) {
    std::vector<std::vector<std::uint8_t>> out;
    std::uniform_int_distribution<int> byte(0, 255), coarse(0, 15);
    for (const std::uint8_t eraser : {0, 8}) {
        // Model 0x822 or 0x82A, serial number 0x12345678.
        out.push_back({2, 0xC2, 0x82, static_cast<std::uint8_t>((2 + eraser) << 4 | 1), 0x23, 0x45, 0x67, 0x80, 0, 0});
        for (int i = 0; i < kReportsEach / 2; ++i) {
            const bool tip = i > 5 && i < 25;
            std::vector<std::uint8_t> p(10, 0);
            p[0] = 2;
            p[1] = static_cast<std::uint8_t>(0xA0 | (tip && i % 5 == 0 ? 2 : 0) | (tip && fine ? i & 1 : 0));
            // High bytes that differ from the ones before keep the driver's smoothing of small steps out of it.
            p[2] = static_cast<std::uint8_t>((i * 37) % 60);
            p[4] = static_cast<std::uint8_t>((i * 23) % 40);
            p[3] = static_cast<std::uint8_t>(byte(random));
            p[5] = static_cast<std::uint8_t>(byte(random));
            p[6] = static_cast<std::uint8_t>(tip ? 16 + coarse(random) * 14 : 0);
            p[7] = static_cast<std::uint8_t>((tip ? byte(random) & 0xC0 : 0) | ((i * 19) & 0x3F));
            p[8] = static_cast<std::uint8_t>((i * 29) & 0x7F);
            p[9] = static_cast<std::uint8_t>(byte(random));
            out.push_back(std::move(p));
        }
        out.push_back({2, 0x80, 0, 0, 0, 0, 0, 0, 0, 0});
    }
    return out;
}

/// The data file of the Wacom tablet that a file of the kernel's naming is of; null for any other.
const input::DeviceFile* wacom_file(const std::string& name, input::DeviceIdentity& identity) {
    const std::size_t at = name.find(":056A:");
    if (at == std::string::npos) return nullptr;
    identity.vendor = kWacom;
    identity.product = static_cast<std::uint16_t>(std::stoul(name.substr(at + 6, 4), nullptr, 16));
    return input::find_device_file(identity, input::device_files());
}

int make(const char* work, int count, char** files) {
    std::ofstream out(work);
    std::mt19937 random(20240229);
    std::set<std::vector<std::uint8_t>> seen;
    int pens = 0;
    const auto add = [&](const std::string& name, unsigned vendor, unsigned product,
                         const std::vector<std::uint8_t>& bytes,
                         const std::vector<std::vector<std::uint8_t>>& reports) {
        out << "D " << name << "#" << ++pens << " " << vendor << " " << product << " " << hex(bytes) << "\n";
        for (const auto& report : reports) out << "R " << hex(report) << "\n";
    };
    const auto reports_of = [&](const PenLayout& layout) {
        std::vector<std::vector<std::uint8_t>> reports;
        for (int i = 0; i < kReportsEach; ++i) {
            reports.push_back(report_of(layout, step_of(i, layout.has(PenRole::Invert)), random));
        }
        return reports;
    };
    const auto add_any = [&](const std::string& name, const std::vector<std::uint8_t>& bytes) {
        input::DeviceIdentity wacom;
        const input::DeviceFile* file = wacom_file(name, wacom);
        if (file == nullptr && !seen.insert(bytes).second) return;
        if (file != nullptr) {
            auto reports = file->parser == "wacom-intuos"
                               ? intuos_packets(random, file->fine)
                               : reports_of(input::make_layouts(file, std::nullopt, {}).front());
            // As long as the tablet's own reports are: the driver tells them by their length.
            const auto descriptor = input::parse_report_descriptor(bytes);
            for (auto& r : reports) {
                if (descriptor) r.resize(std::max(r.size(), descriptor->report_bytes(input::HidKind::Input, r[0])), 0);
            }
            add(name, wacom.vendor, wacom.product, bytes, reports);
        } else if (const auto layout = standard_pen(bytes)) {
            add(name, kNobody, static_cast<unsigned>(pens) + 1, bytes, reports_of(*layout));
        }
    };
    add_any("generic-pen", support::generic_pen_descriptor());
    for (int i = 0; i < count; ++i) {
        std::ifstream in(files[i], std::ios::binary);
        const std::vector<char> chars{std::istreambuf_iterator<char>(in), {}};
        std::string name = files[i];
        name = name.substr(name.rfind('/') + 1, 100);
        for (char& c : name) c = c == ' ' ? '_' : c;
        add_any(name, {chars.begin(), chars.end()});
    }
    std::printf("%d pens, about %d reports each\n", pens, kReportsEach);
    return 0;
}

/// How we decode the device: by its descriptor, or by the data file of a Wacom tablet.
std::unique_ptr<input::PenDecoder> our_decoder(unsigned vendor, unsigned product,
                                               const std::vector<std::uint8_t>& bytes) {
    if (vendor == kWacom) {
        input::DeviceIdentity identity;
        identity.vendor = kWacom;
        identity.product = static_cast<std::uint16_t>(product);
        return input::make_decoder(input::find_device_file(identity, input::device_files()), std::nullopt, {});
    }
    auto layout = standard_pen(bytes);
    if (!layout) return nullptr;
    return input::make_layout_decoder({std::move(*layout)}, "descriptor");
}

/// What the kernel said of one device.
struct KernelDevice {
    std::vector<input::EvdevDescription> nodes;
    struct Event {
        std::size_t node;
        input::EvdevEvent event;
    };
    std::vector<std::vector<Event>> reports;
};

std::map<std::string, KernelDevice> read_kernel(const char* path) {
    std::map<std::string, KernelDevice> devices;
    std::ifstream in(path);
    KernelDevice* d = nullptr;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        char kind = 0;
        words >> kind;
        if (kind == 'D' && line.size() > 2) d = &devices[line.substr(2)];
        if (d == nullptr) continue;
        if (kind == 'N') d->nodes.emplace_back();
        if (kind == 'K' && !d->nodes.empty()) {
            std::size_t key = 0;
            if (words >> key && key < 768) d->nodes.back().keys[key] = true;
        }
        if (kind == 'A' && !d->nodes.empty()) {
            std::size_t code = 0;
            input::EvdevDescription::Axis a;
            if (words >> code >> a.min >> a.max >> a.resolution && code < 64) d->nodes.back().axes[code] = a;
        }
        if (kind == 'R' && line == "R") d->reports.emplace_back();
        if (kind == 'E' && !d->reports.empty()) {
            KernelDevice::Event e{};
            if (words >> e.node >> e.event.type >> e.event.code >> e.event.value) d->reports.back().push_back(e);
        }
    }
    return devices;
}

/// The node whose position is ours; the kernel may make others for fingers and keys.
std::optional<std::size_t> pen_node(const KernelDevice& d, const input::PenAxes& axes) {
    for (std::size_t i = 0; i < d.nodes.size(); ++i) {
        const auto& n = d.nodes[i];
        const auto& x = n.axes[ABS_X];
        if (n.is_pen() && x && x->min == axes.x->min && x->max == axes.x->max) return i;
    }
    return std::nullopt;
}

std::string compare_axes(const input::PenAxes& ours, const input::PenAxes& kernels) {
    std::string faults;
    const auto one = [&](const char* name, const std::optional<input::AxisRange>& a,
                         const std::optional<input::AxisRange>& b) {
        if (!a || !b) return;
        if (a->min != b->min || a->max != b->max) faults += std::string(" ") + name + " range";
        if (a->per_unit > 0.0 && b->per_unit > 0.0 && std::abs(a->per_unit - b->per_unit) > 1.0) {
            faults += std::string(" ") + name + " resolution " + std::to_string(a->per_unit) + "/" +
                      std::to_string(b->per_unit);
        }
    };
    one("x", ours.x, kernels.x);
    one("y", ours.y, kernels.y);
    one("pressure", ours.pressure, kernels.pressure);
    one("tilt_x", ours.tilt_x, kernels.tilt_x);
    one("tilt_y", ours.tilt_y, kernels.tilt_y);
    return faults;
}

/// What differs in a report; empty for nothing. Axes that the kernel's node lacks are not looked at.
std::string compare(const input::PenReport& ours, const input::PenReport& kernels, const input::PenAxes& axes,
                    unsigned vendor) {
    // The Wacom driver averages places that lie less than eight steps apart.
    const int averaged = vendor == kWacom ? 8 : 0;
    const auto apart = [&](const std::optional<std::int32_t>& a, const std::optional<std::int32_t>& b) {
        return a.has_value() != b.has_value() || (a && std::abs(*a - *b) > averaged);
    };
    if (ours.in_range != kernels.in_range) return "in range";
    if (!ours.in_range) return "";
    if (ours.tip != kernels.tip) return "tip";
    if ((ours.tool == input::PenTool::Eraser) != (kernels.tool == input::PenTool::Eraser)) return "eraser";
    if ((ours.buttons & input::kBarrel1) != (kernels.buttons & input::kBarrel1)) return "barrel button";
    if (apart(ours.x, kernels.x)) return "x";
    if (apart(ours.y, kernels.y)) return "y";
    if (ours.pressure && axes.pressure && ours.pressure != kernels.pressure) return "pressure";
    if (ours.tilt_x && axes.tilt_x && ours.tilt_x != kernels.tilt_x) return "tilt x";
    if (ours.tilt_y && axes.tilt_y && ours.tilt_y != kernels.tilt_y) return "tilt y";
    return "";
}

int check(const char* work, const char* kernel) {
    const std::map<std::string, KernelDevice> devices = read_kernel(kernel);
    std::ifstream in(work);
    int same = 0, different = 0, not_comparable = 0;
    long reports = 0;
    std::string name;
    std::unique_ptr<input::PenDecoder> decoder;
    std::optional<std::size_t> node;
    std::optional<input::EvdevPen> pen;
    std::size_t next = 0;
    unsigned vendor = 0;
    input::PenReport ours;
    std::string fault;
    const KernelDevice* d = nullptr;
    const auto finish = [&] {
        if (name.empty()) return;
        if (!node) {
            ++not_comparable;
            const bool refused = d == nullptr || d->nodes.empty();
            std::printf("not comparable: %s (%s)\n", name.c_str(),
                        refused ? "the kernel refuses the descriptor" : "the kernel makes no node with this pen's x");
        } else if (fault.empty()) {
            ++same;
        } else {
            ++different;
            std::printf("different: %s: %s\n", name.c_str(), fault.c_str());
        }
    };
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        char kind = 0;
        words >> kind;
        if (kind == 'D') {
            finish();
            unsigned product = 0;
            std::string descriptor;
            words >> name >> vendor >> product >> descriptor;
            decoder = our_decoder(vendor, product, unhex(descriptor));
            const auto found = devices.find(name);
            d = found == devices.end() ? nullptr : &found->second;
            node = d == nullptr ? std::nullopt : pen_node(*d, decoder->axes());
            pen.reset();
            fault.clear();
            ours = {};
            next = 0;
            if (node) {
                pen.emplace(d->nodes[*node]);
                fault = compare_axes(decoder->axes(), pen->axes());
            }
        } else if (kind == 'R' && node) {
            std::string bytes;
            words >> bytes;
            if (next >= d->reports.size()) {
                fault = "reports are missing";
                continue;
            }
            for (const KernelDevice::Event& e : d->reports[next]) {
                if (e.node == *node) (void)pen->feed(e.event);
            }
            ++next;
            // A packet that is no pen's state (it announces one) changes nothing.
            const input::PenAxes* axes = nullptr;
            (void)decoder->decode(unhex(bytes), ours, axes);
            const std::string what = compare(ours, pen->report(), pen->axes(), vendor);
            if (fault.empty() && !what.empty()) fault = "report " + std::to_string(next) + ": " + what;
            ++reports;
        }
    }
    finish();
    std::printf("%d pens the same in all of %ld reports, %d different, %d not comparable\n", same, reports, different,
                not_comparable);
    return different == 0 && same > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string mode = argc > 1 ? argv[1] : "";
    if (mode == "make" && argc > 2) return make(argv[2], argc - 3, argv + 3);
    if (mode == "check" && argc == 4) return check(argv[2], argv[3]);
    std::fprintf(stderr, "kernel_pen make WORK [DESCRIPTOR]... | kernel_pen check WORK KERNEL\n");
    return 2;
}
