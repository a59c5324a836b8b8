#include "db/codec/compact_descriptor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry/point_grid.hpp"
#include "core/geometry/polygon.hpp"
#include "core/parts/describe.hpp"
#include "core/parts/rounding.hpp"
#include "db/codec/bits.hpp"

namespace db {

namespace {

using core::Part;
using core::ShapeDescriptor;

constexpr std::size_t kMostSamples = 512;
constexpr std::size_t kMostParts = 255;
constexpr int kMostOrder = 15;
constexpr double kLargest = 536870912.0;  // 2^29: the coarsest grid has few enough steps for any box within

/// Grid lines of one sample.
using Lines = std::array<std::int64_t, 2>;

std::vector<Lines> lines_of(const core::Polygon& samples, int exponent) {
    std::vector<Lines> lines;
    for (const core::Point& p : samples) {
        lines.push_back({static_cast<std::int64_t>(core::grid_line(p.x, exponent)),
                         static_cast<std::int64_t>(core::grid_line(p.y, exponent))});
    }
    return lines;
}

/// Where the two samples before number i > 0 lead to.
Lines expected(const std::vector<Lines>& lines, std::size_t i) {
    const Lines& last = lines[i - 1];
    if (i == 1) return last;
    return {2 * last[0] - lines[i - 2][0], 2 * last[1] - lines[i - 2][1]};
}

/// Distances of all samples but the first from where they are expected.
std::vector<std::int64_t> surprises(const std::vector<Lines>& lines) {
    std::vector<std::int64_t> all;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const Lines guess = expected(lines, i);
        all.push_back(lines[i][0] - guess[0]);
        all.push_back(lines[i][1] - guess[1]);
    }
    return all;
}

int best_order(const std::vector<std::int64_t>& values) {
    int best = 0;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (int k = 0; k <= kMostOrder; ++k) {
        std::size_t bits = 0;
        for (const std::int64_t v : values) bits += static_cast<std::size_t>(BitWriter::golomb_bits(v, k));
        if (bits >= least) continue;
        least = bits;
        best = k;
    }
    return best;
}

void write_arc(BitWriter& bits, const Part& part, int sample_bits) {
    bits.bits(static_cast<std::uint64_t>(part.start_sample), sample_bits);
    bits.bits(static_cast<std::uint64_t>(part.end_sample), sample_bits);
    bits.bits(part.salient ? 1 : 0, 1);
}

void read_arc(BitReader& bits, Part& part, int sample_bits) {
    part.start_sample = static_cast<int>(bits.bits(sample_bits));
    part.end_sample = static_cast<int>(bits.bits(sample_bits));
    part.salient = bits.bits(1) == 1;
}

/// What stands before the bits.
struct Head {
    std::size_t samples = 0, terminals = 0, wings = 0;
    int exponent = 0, order = 0;
    Lines first{};
    bool own_stop_points = false;
    double skeletal_length = 0.0;
};

Head read_head(ByteReader& in) {
    Head head;
    head.samples = static_cast<std::size_t>(in.integer(kMostSamples));
    head.exponent = in.u8() + core::kFinestGrid;
    head.order = in.u8();
    head.first = {in.svarint(), in.svarint()};
    head.terminals = static_cast<std::size_t>(in.integer(kMostParts));
    head.wings = static_cast<std::size_t>(in.integer(kMostParts));
    const std::uint8_t own = in.u8();
    head.own_stop_points = own == 1;
    head.skeletal_length = static_cast<double>(in.f32());
    const bool sound = head.samples >= 3 && head.exponent <= core::kCoarsestGrid && head.order <= kMostOrder &&
                       head.terminals >= 1 && head.terminals + head.wings <= kMostParts && own <= 1;
    if (!sound) in.fail("a number in it is out of range");
    return head;
}

/// The samples on their grid; a fault where their box is larger than rounding leaves it.
core::Polygon read_samples(ByteReader& in, BitReader& bits, const Head& head) {
    std::vector<Lines> lines{head.first};
    Lines low = head.first, high = head.first;
    while (lines.size() < head.samples && !in.failed()) {
        Lines next = expected(lines, lines.size());
        for (std::size_t axis = 0; axis < 2; ++axis) {
            next[axis] += bits.golomb(head.order);
            low[axis] = std::min(low[axis], next[axis]);
            high[axis] = std::max(high[axis], next[axis]);
            const bool inside = low[axis] >= -core::kFarthestGridLine && high[axis] <= core::kFarthestGridLine &&
                                high[axis] - low[axis] <= core::kOutlineSteps;
            if (!inside) in.fail("a point in it is out of range");
        }
        lines.push_back(next);
    }
    core::Polygon samples;
    for (const Lines& line : lines) {
        samples.push_back({std::ldexp(static_cast<double>(line[0]), head.exponent),
                           std::ldexp(static_cast<double>(line[1]), head.exponent)});
        const bool inside = std::abs(samples.back().x) <= kLargest && std::abs(samples.back().y) <= kLargest;
        if (!inside) in.fail("a point in it is out of range");
    }
    return samples;
}

void read_parts(ByteReader& in, BitReader& bits, const Head& head, ShapeDescriptor& shape) {
    const int sample_bits = bits_for(head.samples), terminal_bits = bits_for(head.terminals);
    shape.terminal_count = static_cast<int>(head.terminals);
    shape.parts.resize(head.terminals + head.wings);
    for (std::size_t i = 0; i < shape.parts.size(); ++i) {
        Part& part = shape.parts[i];
        part.first_terminal = static_cast<int>(i);
        if (i >= head.terminals) {
            part.first_terminal = static_cast<int>(bits.bits(terminal_bits));
            part.terminal_count = static_cast<int>(bits.bits(terminal_bits)) + 1;
        }
        read_arc(bits, part, sample_bits);
        const bool sound = part.first_terminal < shape.terminal_count && part.terminal_count <= shape.terminal_count &&
                           part.start_sample < static_cast<int>(head.samples) &&
                           part.end_sample < static_cast<int>(head.samples);
        if (!sound) in.fail("a part names terminals or samples that are not there");
    }
}

}  // namespace

bool fits_compact(const ShapeDescriptor& d) {
    const auto terminals = static_cast<std::size_t>(std::max(d.terminal_count, 0));
    if (d.samples.size() > kMostSamples || d.parts.size() > kMostParts || terminals < 1 || terminals > d.parts.size()) {
        return false;
    }
    for (std::size_t i = 0; i < terminals; ++i) {
        if (d.parts[i].first_terminal != static_cast<int>(i) || d.parts[i].terminal_count != 1) return false;
    }
    const auto near = [](core::Point p) { return std::abs(p.x) <= kLargest && std::abs(p.y) <= kLargest; };
    return std::all_of(d.samples.begin(), d.samples.end(), near);
}

void write_compact(ByteWriter& out, const ShapeDescriptor& d) {
    const int exponent = core::finest_grid(d.samples, core::kOutlineSteps);
    const std::vector<Lines> lines = lines_of(d.samples, exponent);
    const std::vector<std::int64_t> values = surprises(lines);
    const int order = best_order(values);
    const auto terminals = static_cast<std::size_t>(d.terminal_count);
    const bool own_stop_points = d.stop_points != core::stop_points(d.parts, d.terminal_count, false);
    out.varint(d.samples.size());
    out.u8(static_cast<std::uint8_t>(exponent - core::kFinestGrid));
    out.u8(static_cast<std::uint8_t>(order));
    out.svarint(lines.front()[0]);
    out.svarint(lines.front()[1]);
    out.varint(terminals);
    out.varint(d.parts.size() - terminals);
    out.u8(own_stop_points ? 1 : 0);
    out.f32(static_cast<float>(d.skeletal_length));
    BitWriter bits(out);
    for (const std::int64_t v : values) bits.golomb(v, order);
    const int sample_bits = bits_for(d.samples.size()), terminal_bits = bits_for(terminals);
    for (std::size_t i = 0; i < d.parts.size(); ++i) {
        if (i >= terminals) {
            bits.bits(static_cast<std::uint64_t>(d.parts[i].first_terminal), terminal_bits);
            bits.bits(static_cast<std::uint64_t>(d.parts[i].terminal_count) - 1, terminal_bits);
        }
        write_arc(bits, d.parts[i], sample_bits);
    }
    for (int t = 0; own_stop_points && t < d.terminal_count; ++t) {
        bits.bits(std::binary_search(d.stop_points.begin(), d.stop_points.end(), t) ? 1 : 0, 1);
    }
    bits.finish();
}

ShapeDescriptor read_compact(ByteReader& in) {
    ShapeDescriptor shape;
    const Head head = read_head(in);
    if (in.failed()) return shape;
    shape.skeletal_length = head.skeletal_length;
    BitReader bits(in);
    shape.samples = read_samples(in, bits, head);
    if (in.failed()) return shape;
    read_parts(in, bits, head, shape);
    for (int t = 0; head.own_stop_points && t < shape.terminal_count; ++t) {
        if (bits.bits(1) == 1) shape.stop_points.push_back(t);
    }
    bits.finish();
    if (in.failed()) return shape;
    if (!head.own_stop_points) shape.stop_points = core::stop_points(shape.parts, shape.terminal_count, false);
    if (!(core::signed_area(shape.samples) > 0.0) || !core::measure_again(shape)) in.fail("it encloses no area");
    return shape;
}

}  // namespace db
