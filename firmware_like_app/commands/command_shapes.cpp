// croquis describe, croquis match: one shape's parts, two shapes' correspondence.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/match/match.hpp"
#include "firmware_like_app/collection/sketch_description.hpp"
#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "ui/draw/shape_picture.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;

constexpr std::array<const char*, core::kFeatureCount> kFeatureNames{"area",        "perimeter",      "eccentricity",
                                                                     "circularity", "rectangularity", "convexity",
                                                                     "solidity",    "bending_energy", "clr"};

/// `number` is what a query and a match call the part.
ordered_json to_json(std::size_t number, const core::Part& part) {
    ordered_json features;
    for (std::size_t k = 0; k < core::kFeatureCount; ++k) features[kFeatureNames[k]] = part.features[k];
    return {{"part", number},
            {"first_terminal", part.first_terminal},
            {"terminals", part.terminal_count},
            {"from_sample", part.start_sample},
            {"to_sample", part.end_sample},
            {"salient", part.salient},
            {"features", features},
            {"signature", part.signature}};
}

std::string file_name(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

struct DescribeOptions {
    std::string shape, picture;
    bool json = false;
};

void print_description(const std::string& path, const core::DescribedShape& shape, bool as_json) {
    const core::ShapeDescriptor& d = shape.descriptor;
    if (as_json) {
        ordered_json out{{"shape", path},
                         {"samples", d.samples.size()},
                         {"terminals", d.terminal_count},
                         {"stop_points", d.stop_points},
                         {"skeletal_length", d.skeletal_length},
                         {"parts", ordered_json::array()}};
        for (std::size_t k = 0; k < d.parts.size(); ++k) out["parts"].push_back(to_json(k, d.parts[k]));
        print_json(out);
        return;
    }
    std::printf("%s: %d terminals, %zu wings, %zu stop points, skeleton %.1f long\n", path.c_str(), d.terminal_count,
                d.parts.size() - static_cast<std::size_t>(d.terminal_count), d.stop_points.size(), d.skeletal_length);
    for (std::size_t k = 0; k < d.parts.size(); ++k) {
        const core::Part& part = d.parts[k];
        const bool wing = part.terminal_count > 1;
        std::printf("  part %2zu: %s %2d", k, wing ? "wing    " : "terminal", part.first_terminal);
        if (wing) std::printf("+%d", part.terminal_count - 1);
        std::printf("\tarea %5.1f %%  perimeter %5.1f %%  eccentricity %5.2f  circularity %4.2f%s\n", part.features[0],
                    part.features[1], part.features[2], part.features[3], part.salient ? "  salient" : "");
    }
}

void run_describe(const DescribeOptions& options, CommandState& state) {
    const core::Result<SketchDescription> description = describe_file(options.shape);
    if (!description) return fail(state, description.error());
    if (!options.picture.empty()) {
        const auto written =
            ui::write_description_picture(description->shape, file_name(options.shape), options.picture);
        if (!written) return fail(state, written.error());
    }
    print_description(options.shape, description->shape, options.json);
}

struct MatchOptions {
    std::string a, b, picture;
    bool json = false;
};

void print_match(const core::Match& match, bool as_json) {
    if (as_json) {
        ordered_json out{{"distance", match.distance},     {"part_cost", match.part_cost},
                         {"outline", match.outline},       {"reversed", match.reversed},
                         {"pairs", ordered_json::array()}, {"left_out_a", match.left_out_a},
                         {"left_out_b", match.left_out_b}, {"left_out_cost", match.left_out_cost}};
        for (const core::MatchedPair& p : match.pairs) {
            out["pairs"].push_back({{"a", p.part_a},
                                    {"b", p.part_b},
                                    {"cost", p.cost()},
                                    {"features", p.features},
                                    {"signature", p.signature},
                                    {"d_e", p.d_e},
                                    {"d_be", p.d_be},
                                    {"d_a", p.d_a}});
        }
        print_json(out);
        return;
    }
    std::printf("distance %.3f; parts cost %.3f, outlines differ by %.3f%s\n", match.distance, match.part_cost,
                match.outline, match.reversed ? " (mirrored)" : "");
    for (const core::MatchedPair& p : match.pairs) {
        std::printf(
            "  part %2d and part %2d: %8.3f = features %.3f + signature %.3f + place %.3f + bending %.3f + angle "
            "%.3f\n",
            p.part_a, p.part_b, p.cost(), p.features, p.signature, p.d_e, p.d_be, p.d_a);
    }
    std::printf("  left out: %zu and %zu terminals, %.3f\n", match.left_out_a.size(), match.left_out_b.size(),
                match.left_out_cost);
}

void run_match(const MatchOptions& options, CommandState& state) {
    const core::Result<SketchDescription> a = describe_file(options.a);
    if (!a) return fail(state, a.error());
    const core::Result<SketchDescription> b = describe_file(options.b);
    if (!b) return fail(state, b.error());
    const core::ShapeDescriptor& da = a->shape.descriptor;
    const core::ShapeDescriptor& db = b->shape.descriptor;
    core::Matcher matcher;
    const core::Match match = matcher.match(core::matchable(da), core::matchable(db));
    if (!options.picture.empty()) {
        const auto written =
            ui::write_match_picture({{&da, &db, &match, file_name(options.a), file_name(options.b)}}, options.picture);
        if (!written) return fail(state, written.error());
    }
    print_match(match, options.json);
}

}  // namespace

void add_describe_command(Command cli, CommandState& state) {
    auto options = std::make_shared<DescribeOptions>();
    Command command = cli.command("describe", "The parts of one shape");
    command
        .option("SHAPE", options->shape,
                "picture, SVG, InkML, Quick-Draw line, stroke list, trace or a tablet's recording")
        .required();
    command.flag("--json", options->json, "one JSON object on standard output");
    command.option("--picture", options->picture, "write a PNG of every step");
    command.runs([options, &state] { run_describe(*options, state); });
}

void add_match_command(Command cli, CommandState& state) {
    auto options = std::make_shared<MatchOptions>();
    Command command = cli.command("match", "Distance and part correspondence of two shapes");
    command.option("A", options->a, "first shape").required();
    command.option("B", options->b, "second shape").required();
    command.flag("--json", options->json, "one JSON object on standard output");
    command.option("--picture", options->picture, "write a PNG with matched parts in the same colours");
    command.runs([options, &state] { run_match(*options, state); });
}

}  // namespace app
