// The packets of Wacom's professional tablets before they described themselves. Ten bytes, numbers with the high byte
// first. The second byte says what a packet holds:
//
//     0xC0 … 0xC3  a pen comes: its serial number and the number of its model
//     0x80, 0x81   it leaves
//     0xA0 …       its state; bits 1 to 4 say of which kind: 0 to 3 pressure, 5 rotation, 10 the wheel of an airbrush
//
// The first two generations see two pens at once: the lowest bit says which of them a packet is of. Later ones have the
// lowest bit of the pressure there.

#include <algorithm>
#include <array>

#include "input/parse/pen_decoder.hpp"

namespace input {
namespace {

constexpr std::size_t kPacketBytes = 10;
constexpr std::int32_t kTouch = 10;  // steps of pressure, where Wacom's own driver sees a touch

std::int32_t big_endian(std::span<const std::uint8_t> p, std::size_t at) {
    return p[at] << 8U | p[at + 1];
}

class WacomIntuosDecoder final : public PenDecoder {
  public:
    explicit WacomIntuosDecoder(WacomIntuosOptions options) : options_(std::move(options)) {
        PenAxes& a = options_.axes;
        a.tilt_x = a.tilt_y = AxisRange{-64, 63, 57.0};
        a.rotation = AxisRange{-900, 899, 287.0};
        a.distance = AxisRange{0, 63, 0.0};
        a.wheel = AxisRange{0, 1023, 0.0};
    }

    bool decode(std::span<const std::uint8_t> p, PenReport& out, const PenAxes*& axes) override {
        if (p.size() < kPacketBytes ||
            std::find(options_.report_ids.begin(), options_.report_ids.end(), p[0]) == options_.report_ids.end()) {
            return false;
        }
        axes = &options_.axes;
        tool_ = &tools_[options_.fine ? 0U : p[1] & 1U];
        if ((p[1] & 0xfcU) == 0xc0U) return announce(p);
        if ((p[1] & 0xfeU) == 0x80U) {
            *tool_ = {};
            out = tool_->state;
            return true;
        }
        if (!tool_->announced || (p[1] & 0xe0U) != 0xa0U) return false;
        switch ((p[1] >> 1U) & 0x0fU) {
            case 0:
            case 1:
            case 2:
            case 3:
                pen(p);
                break;
            case 5:
                rotation(p);
                break;
            case 10:
                wheel(p);
                break;
            default:
                return false;
        }
        place(p);
        out = tool_->state;
        return true;
    }

    [[nodiscard]] const PenAxes& axes() const override { return options_.axes; }
    [[nodiscard]] bool reports_range() const override { return true; }
    [[nodiscard]] std::string_view name() const override { return "wacom-intuos"; }

  private:
    bool announce(std::span<const std::uint8_t> p) {
        tool_->state = {};
        tool_->state.serial =
            static_cast<std::uint32_t>((p[3] & 0x0fU) << 28U | p[4] << 20U | p[5] << 12U | p[6] << 4U | p[7] >> 4U);
        tool_->state.tool_id =
            static_cast<std::uint32_t>(p[2] << 4U | p[3] >> 4U | (p[7] & 0x0fU) << 20U | (p[8] & 0xf0U) << 12U);
        tool_->state.tool = wacom_tool(tool_->state.tool_id);
        tool_->announced = true;
        return false;  // no position yet
    }

    void place(std::span<const std::uint8_t> p) {
        std::int32_t x = big_endian(p, 2), y = big_endian(p, 4);
        if (options_.fine) {
            x = x << 1U | ((p[9] >> 1U) & 1U);
            y = y << 1U | (p[9] & 1U);
        }
        tool_->state.x = x;
        tool_->state.y = y;
        tool_->state.distance = p[9] >> 2U;
        tool_->state.in_range = true;
    }

    void pen(std::span<const std::uint8_t> p) {
        const std::int32_t eleven_bits = p[6] << 3U | (p[7] & 0xc0U) >> 5U | (p[1] & 1U);
        const bool ten = options_.axes.pressure && options_.axes.pressure->max < 2047;
        tool_->state.pressure = ten ? eleven_bits >> 1U : eleven_bits;
        tool_->state.tip = *tool_->state.pressure > kTouch;
        tool_->state.buttons = ((p[1] & 2U) != 0 ? kBarrel1 : 0) | ((p[1] & 4U) != 0 ? kBarrel2 : 0);
        tilt(p);
    }

    void rotation(std::span<const std::uint8_t> p) {
        const std::int32_t t = p[6] << 3U | ((p[7] >> 5U) & 7U);
        tool_->state.rotation = (p[7] & 0x20U) != 0 ? (t > 900 ? (t - 1) / 2 - 1350 : (t - 1) / 2 + 450) : 450 - t / 2;
    }

    void wheel(std::span<const std::uint8_t> p) {
        tool_->state.wheel = p[6] << 2U | ((p[7] >> 6U) & 3U);
        tilt(p);
    }

    void tilt(std::span<const std::uint8_t> p) {
        tool_->state.tilt_x = static_cast<std::int32_t>(((p[7] << 1U) & 0x7eU) | p[8] >> 7U) - 64;
        tool_->state.tilt_y = static_cast<std::int32_t>(p[8] & 0x7fU) - 64;
    }

    WacomIntuosOptions options_;
    struct Tool {
        PenReport state;
        bool announced = false;
    };
    std::array<Tool, 2> tools_;
    Tool* tool_ = tools_.data();  ///< of the packet that is being read
};

}  // namespace

PenTool wacom_tool(std::uint32_t tool_id) {
    switch (tool_id & 0xfffU) {
        case 0x007:
        case 0x09c:
        case 0x094:
        case 0x017:
        case 0x806:
            return PenTool::Mouse;
        case 0x096:
        case 0x097:
        case 0x006:
            return PenTool::Lens;
        case 0x112:
        case 0x902:
        case 0x912:
        case 0x913:
        case 0xd12:
            return PenTool::Airbrush;
        case 0x032:
        case 0x0fa:
        case 0x80c:
        case 0x82b:
        case 0x91b:
            return PenTool::Eraser;
        default:
            break;
    }
    return (tool_id & 0xfU) == 0xaU ? PenTool::Eraser : PenTool::Pen;  // 0x802 is a pen, 0x80A its other end
}

std::unique_ptr<PenDecoder> make_wacom_intuos_decoder(WacomIntuosOptions options) {
    return std::make_unique<WacomIntuosDecoder>(std::move(options));
}

}  // namespace input
