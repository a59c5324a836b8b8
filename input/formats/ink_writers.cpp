#include "input/formats/ink_writers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <system_error>

namespace input {
namespace {

constexpr double kRadian_deg = 180.0 / std::numbers::pi;

void append(std::string& out, double value) {
    std::array<char, 40> text{};
    out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}
void append(std::string& out, std::int64_t value) {
    out += std::to_string(value);
}

bool draws(const PenStroke& s) {
    return s.tool != PenTool::Eraser && s.tool != PenTool::Lens && s.tool != PenTool::Mouse;
}

bool all_tilted(const std::vector<PenStroke>& strokes) {
    return std::all_of(strokes.begin(), strokes.end(), [](const PenStroke& stroke) {
        return !draws(stroke) || std::all_of(stroke.samples.begin(), stroke.samples.end(),
                                             [](const PenSample& s) { return s.tilt_x_rad && s.tilt_y_rad; });
    });
}

std::vector<const PenStroke*> drawn(const std::vector<PenStroke>& strokes) {
    std::vector<const PenStroke*> out;
    for (const PenStroke& s : strokes) {
        if (draws(s)) out.push_back(&s);
    }
    return out;
}

template <typename Get>
std::string list_of(const core::Stroke& stroke, Get get) {
    std::string out = "[";
    for (const core::PenSample& s : stroke.samples) {
        if (out.size() > 1) out += ',';
        append(out, get(s));
    }
    return out + "]";
}

}  // namespace

std::string inkml_text(const std::vector<PenStroke>& strokes) {
    const core::Drawing drawing = drawing_of(strokes);
    const std::vector<const PenStroke*> source = drawn(strokes);
    const bool tilted = !source.empty() && all_tilted(strokes);
    std::string out =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ink xmlns=\"http://www.w3.org/2003/InkML\">\n<traceFormat>"
        "<channel name=\"X\" type=\"decimal\" units=\"mm\"/><channel name=\"Y\" type=\"decimal\" units=\"mm\"/>"
        "<channel name=\"T\" type=\"integer\" units=\"us\"/>"
        "<channel name=\"F\" type=\"decimal\" min=\"0\" max=\"1\"/>";
    if (tilted) {
        out +=
            "<channel name=\"OTx\" type=\"decimal\" units=\"deg\"/><channel name=\"OTy\" type=\"decimal\" "
            "units=\"deg\"/>";
    }
    out += "</traceFormat>\n";
    for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
        out += "<trace>";
        for (std::size_t k = 0; k < drawing.strokes[i].samples.size(); ++k) {
            const core::PenSample& s = drawing.strokes[i].samples[k];
            if (k > 0) out += ", ";
            append(out, s.x);
            out += ' ';
            append(out, s.y);
            out += ' ';
            append(out, s.time_us);
            out += ' ';
            append(out, s.pressure);
            if (!tilted) continue;
            out += ' ';
            append(out, *source[i]->samples[k].tilt_x_rad * kRadian_deg);
            out += ' ';
            append(out, *source[i]->samples[k].tilt_y_rad * kRadian_deg);
        }
        out += "</trace>\n";
    }
    return out + "</ink>\n";
}

std::string svg_text(const std::vector<PenStroke>& strokes) {
    const core::Drawing drawing = drawing_of(strokes);
    double left = 0, top = 0, right = 1, bottom = 1;
    bool first = true;
    for (const core::Stroke& stroke : drawing.strokes) {
        for (const core::PenSample& s : stroke.samples) {
            left = first ? s.x : std::min(left, s.x);
            right = first ? s.x : std::max(right, s.x);
            top = first ? s.y : std::min(top, s.y);
            bottom = first ? s.y : std::max(bottom, s.y);
            first = false;
        }
    }
    const double margin = 0.02 * std::max({right - left, bottom - top, 1.0});
    const double width = right - left + 2 * margin, height = bottom - top + 2 * margin;
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
    append(out, width);
    out += "mm\" height=\"";
    append(out, height);
    out += "mm\" viewBox=\"";
    append(out, left - margin);
    out += ' ';
    append(out, top - margin);
    out += ' ';
    append(out, width);
    out += ' ';
    append(out, height);
    out += "\">\n<g fill=\"none\" stroke=\"#000\" stroke-width=\"";
    append(out, std::max(width, height) / 300);
    out += "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    for (const core::Stroke& stroke : drawing.strokes) {
        out += "<path d=\"M";
        for (std::size_t k = 0; k < stroke.samples.size(); ++k) {
            if (k > 0) out += " L";
            append(out, stroke.samples[k].x);
            out += ' ';
            append(out, stroke.samples[k].y);
        }
        if (stroke.samples.size() == 1) out += " l0 0";
        out += "\"/>\n";
    }
    return out + "</g>\n</svg>\n";
}

std::string quickdraw_text(const std::vector<PenStroke>& strokes) {
    std::string list;
    for (const core::Stroke& stroke : drawing_of(strokes).strokes) {
        if (!list.empty()) list += ',';
        list += '[' + list_of(stroke, [](const core::PenSample& s) { return s.x; }) + ',' +
                list_of(stroke, [](const core::PenSample& s) { return s.y; }) + ',' +
                list_of(stroke, [](const core::PenSample& s) { return static_cast<double>(s.time_us) / 1000; }) + ']';
    }
    return "{\"word\":\"\",\"drawing\":[" + list + "]}\n";
}

core::Result<void> write_whole_file(const std::string& path, const std::string& text) {
    const std::string draft = path + ".new";
    {
        std::ofstream file(draft, std::ios::binary);
        file << text;
        file.close();
        if (!file) {
            std::error_code ignored;
            std::filesystem::remove(draft, ignored);
            return core::unexpected(core::ErrorCode::WriteFailed,
                                    "this cannot be written; check that the folder is there and has room", path);
        }
    }
    std::error_code failure;
    std::filesystem::rename(draft, path, failure);
    if (!failure) return {};
    return core::unexpected(core::ErrorCode::WriteFailed, "this cannot be written (" + failure.message() + ")", path);
}

}  // namespace input
