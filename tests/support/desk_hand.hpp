#pragma once
// A hand at the garment desk: strokes through few points, as a test says them.

#include <string>
#include <vector>

#include "core/garment/desk/garment_desk.hpp"

namespace support {

class DeskHand {
  public:
    explicit DeskHand(core::GarmentDesk& desk) : desk_(desk) {}

    /// Through these points, a sample every half centimetre.
    core::DeskReply draw(core::DeskTool tool, const char* view, const std::vector<core::Point>& through) {
        desk_.settings().tool = tool;
        const core::DrawingView seen = *core::named_view(view);
        desk_.begin(seen, through.front());
        follow(seen, through);
        return desk_.end();
    }
    core::DeskReply on_plane(const char* view, double at, const std::vector<core::Point>& through) {
        desk_.settings().plane_cm = at;
        return draw(core::DeskTool::DrawOnPlane, view, through);
    }
    core::DeskReply on_body(const char* view, double offset, const std::vector<core::Point>& through) {
        desk_.settings().offset_cm = offset;
        return draw(core::DeskTool::DrawOnBody, view, through);
    }
    core::DeskReply tap(core::DeskTool tool, const char* view, core::Point at) {
        desk_.settings().tool = tool;
        return desk_.tap(*core::named_view(view), at);
    }
    void follow(const core::DrawingView& view, const std::vector<core::Point>& through) {
        for (std::size_t i = 0; i + 1 < through.size(); ++i) {
            const int steps = std::max(1, static_cast<int>(2.0 * core::distance(through[i], through[i + 1])));
            for (int k = 1; k <= steps; ++k)
                desk_.extend(view, through[i] + (through[i + 1] - through[i]) * (static_cast<double>(k) / steps));
        }
    }

    /// The stroke of a step, sample by sample, as the pen would draw it.
    core::DeskReply replay(const core::SketchStroke& stroke, core::DeskTool otherwise) {
        bool first = true;
        for (const core::StrokePart& part : stroke) {
            set(part.tool, otherwise);
            if (first)
                desk_.begin(part.view, part.points.front());
            else
                desk_.pause(), desk_.begin(part.view, part.points.front());
            for (std::size_t k = 1; k < part.points.size(); ++k) desk_.extend(part.view, part.points[k]);
            first = false;
        }
        return desk_.end();
    }

  private:
    void set(core::DrawingTool tool, core::DeskTool otherwise) {
        const bool plane = tool.kind != core::DrawingTool::Kind::Body;
        desk_.settings().tool = otherwise != core::DeskTool::DrawOnBody ? otherwise
                                : plane                                 ? core::DeskTool::DrawOnPlane
                                                                        : core::DeskTool::DrawOnBody;
        if (plane)
            desk_.settings().plane_cm = tool.offset;
        else
            desk_.settings().offset_cm = tool.offset;
    }

    core::GarmentDesk& desk_;
};

}  // namespace support
