#include "core/exchange/inkml_reader.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <pugixml.hpp>
#include <utility>
#include <vector>

#include "core/exchange/drawing_builder.hpp"
#include "core/exchange/file_bytes.hpp"
#include "core/exchange/xml_text.hpp"

namespace core {
namespace {

constexpr std::size_t kMaxChannels = 64;

struct Channels {
    std::size_t count = 2;
    std::size_t x = 0, y = 1;
    std::optional<std::size_t> time, force;
    double us_per_time = 1000.0;
    double largest_force = 0.0;  ///< 0: not told
};

struct RawPoint {
    double x = 0.0, y = 0.0;
    std::optional<double> time_us, force;
};

Unexpected bad(std::string why) {
    return unexpected(ErrorCode::BadFormat, std::move(why));
}

/// The first element of that name at or below `node`, in document order.
pugi::xml_node find_element(const pugi::xml_node& node, std::string_view name) {
    return node.find_node([&](const pugi::xml_node& n) { return local_name(n) == name; });
}

Result<Channels> channels_of(const pugi::xml_document& document) {
    const pugi::xml_node format = find_element(document, "traceFormat");
    if (!format) return Channels{};
    Channels channels;
    std::optional<std::size_t> x, y;
    std::size_t i = 0;
    for (const pugi::xml_node& channel : format.children()) {
        if (local_name(channel) != "channel") continue;
        const std::string_view name = channel.attribute("name").value();
        const std::string_view units = channel.attribute("units").value();
        if (name == "X") x = i;
        if (name == "Y") y = i;
        if (name == "T") {
            channels.time = i;
            channels.us_per_time = units == "s" ? 1e6 : units == "us" ? 1.0 : units == "ns" ? 1e-3 : 1000.0;
        }
        if (name == "F" || name == "P" || name == "Pressure") {
            channels.force = i;
            channels.largest_force = channel.attribute("max").as_double(0.0);
        }
        if (++i > kMaxChannels) return bad("the trace format has more than 64 channels; check the file");
    }
    if (!x || !y) return bad("the trace format has no channels X and Y; record it with a position");
    channels.count = i;
    channels.x = *x;
    channels.y = *y;
    return channels;
}

/// Reads the values of one trace, whatever their prefixes, as plain numbers.
class TraceText {
  public:
    TraceText(std::string_view text, const Channels& channels)
        : text_(text), channels_(channels), states_(channels.count) {}

    /// The points, or nothing when the text is no trace of these channels.
    std::optional<std::vector<RawPoint>> points() {
        std::vector<RawPoint> result;
        skip_space();
        while (at_ < text_.size()) {
            if (result.size() >= kMaxDrawingSamples) return std::nullopt;
            for (State& state : states_) {
                if (!read_value(state)) return std::nullopt;
            }
            result.push_back(point());
            skip_space();
            if (at_ < text_.size() && text_[at_++] != ',') return std::nullopt;
            skip_space();
        }
        return result;
    }

  private:
    struct State {
        char mode = '!';
        double value = 0.0;
        double step = 0.0;
        bool known = true;
    };

    void skip_space() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    }

    bool read_value(State& state) {
        skip_space();
        if (at_ >= text_.size()) return false;
        const char c = text_[at_];
        if (c == '*') return ++at_, true;
        if (c == '?') return ++at_, state.known = false, true;
        if (c == 'T' || c == 'F') return ++at_, state.value = c == 'T' ? 1.0 : 0.0, true;
        if (c == '!' || c == '\'' || c == '"') {
            state.mode = c;
            ++at_;
            skip_space();
        }
        double number = 0.0;
        if (at_ < text_.size() && text_[at_] == '+') ++at_;
        const auto [end, failure] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), number);
        if (failure != std::errc() || !std::isfinite(number)) return false;
        at_ = static_cast<std::size_t>(end - text_.data());
        state.step = state.mode == '"' ? state.step + number : state.mode == '\'' ? number : number - state.value;
        state.value = state.mode == '!' ? number : state.value + state.step;
        state.known = true;
        return true;
    }

    [[nodiscard]] RawPoint point() const {
        RawPoint p{states_[channels_.x].value, states_[channels_.y].value, {}, {}};
        if (channels_.time && states_[*channels_.time].known) {
            p.time_us = states_[*channels_.time].value * channels_.us_per_time;
        }
        if (channels_.force && states_[*channels_.force].known) p.force = states_[*channels_.force].value;
        return p;
    }

    std::string_view text_;
    const Channels& channels_;
    std::vector<State> states_;
    std::size_t at_ = 0;
};

/// Collects the traces below `node` in document order.
class Collector {
  public:
    explicit Collector(const Channels& channels) : channels_(channels) {}

    bool collect(const pugi::xml_node& node) {
        for (const pugi::xml_node& child : node.children()) {
            const std::string_view name = local_name(child);
            if (name == "trace") {
                if (!add_trace(child)) return false;
            } else if (name != "definitions" && !collect(child)) {
                return false;
            }
        }
        return true;
    }

    Result<Drawing> finish() && {
        double largest = channels_.largest_force;
        if (largest <= 0.0) {
            for (const auto& trace : traces_) {
                for (const RawPoint& p : trace) largest = std::max(largest, p.force.value_or(0.0));
            }
        }
        DrawingBuilder builder;
        for (const auto& trace : traces_) {
            builder.begin_stroke();
            for (const RawPoint& p : trace) {
                const auto pressure = p.force && largest > 0.0 ? std::optional(*p.force / largest) : std::nullopt;
                if (!builder.add(p.x, p.y, p.time_us, pressure)) break;
            }
        }
        return std::move(builder).finish();
    }

  private:
    bool add_trace(const pugi::xml_node& trace) {
        if (std::string_view(trace.attribute("type").value()) == "penUp") return true;
        std::optional<std::vector<RawPoint>> points = TraceText(trace.child_value(), channels_).points();
        if (!points || (total_ += points->size()) > kMaxDrawingSamples) return false;
        traces_.push_back(std::move(*points));
        return true;
    }

    const Channels& channels_;
    std::vector<std::vector<RawPoint>> traces_;
    std::size_t total_ = 0;
};

}  // namespace

Result<Drawing> parse_inkml(std::string_view text) {
    pugi::xml_document document;
    if (const Result<void> parsed = parse_xml(text, document); !parsed) return unexpected(parsed.error());
    if (local_name(document.document_element()) != "ink")
        return bad("the XML is no InkML; its first element is not <ink>");
    const Result<Channels> channels = channels_of(document);
    if (!channels) return unexpected(channels.error());
    Collector collector(*channels);
    if (!collector.collect(document)) {
        return bad(
            "a trace is no list of points of the trace format's channels, or there are more than a million points");
    }
    return std::move(collector).finish();
}

Result<Drawing> read_inkml(const std::string& path) {
    const Result<std::string> text = read_file_bytes(path);
    if (!text) return unexpected(text.error());
    Result<Drawing> drawing = parse_inkml(*text);
    if (!drawing) return unexpected(drawing.error().code, drawing.error().message, path);
    return drawing;
}

}  // namespace core
