#include "firmware_like_app/kiosk/placing.hpp"

#include <algorithm>

namespace app {

Extent extent_of(const core::Drawing& drawing) {
    Extent e;
    bool first = true;
    for (const core::Stroke& stroke : drawing.strokes) {
        for (const core::PenSample& s : stroke.samples) {
            e.left = first ? s.x : std::min(e.left, s.x);
            e.right = first ? s.x : std::max(e.right, s.x);
            e.top = first ? s.y : std::min(e.top, s.y);
            e.bottom = first ? s.y : std::max(e.bottom, s.y);
            first = false;
        }
    }
    return e;
}

ui::InkFrame fit_drawing(const core::Drawing& drawing, double width, double height, double margin) {
    const Extent e = extent_of(drawing);
    const double kept = margin * std::min(width, height);
    const double across = std::max(e.width(), 1e-9), down = std::max(e.height(), 1e-9);
    ui::InkFrame frame;
    frame.scale = std::min((width - 2 * kept) / across, (height - 2 * kept) / down);
    if (e.width() < 1e-9 && e.height() < 1e-9) frame.scale = 1;  // a dot
    frame.offset_x = width / 2 - (e.left + e.right) / 2 * frame.scale;
    frame.offset_y = height / 2 - (e.top + e.bottom) / 2 * frame.scale;
    return frame;
}

}  // namespace app
