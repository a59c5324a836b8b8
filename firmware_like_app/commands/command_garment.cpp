// croquis garment fill: the quads of one region of cloth.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "core/exchange/obj_writer.hpp"
#include "core/exchange/region_reader.hpp"
#include "core/garment/region.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "firmware_like_app/commands/commands.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;

struct FillOptions {
    std::string region, out;
    double alpha = core::kCoonsAlpha;
    bool json = false;
};

struct FillTimes {
    double topology_ms = 0.0, solve_ms = 0.0;
};

void print_fill(const core::FilledRegion& filled, const FillTimes& times, bool as_json) {
    const core::QuadDiscCounts& counts = filled.topology.counts;
    if (!as_json) {
        std::printf("%zu vertices, %zu quads, irregular: %d inside, %d on the boundary; alpha %g; %.2f + %.2f ms\n",
                    filled.mesh.vertices.size(), filled.mesh.quads.size(), counts.irregular_interior,
                    counts.irregular_boundary, filled.alpha, times.topology_ms, times.solve_ms);
        return;
    }
    ordered_json valences = ordered_json::object();
    for (std::size_t valence = 3; valence < counts.interior_by_valence.size(); ++valence)
        valences[std::to_string(valence)] = counts.interior_by_valence[valence];
    const ordered_json out{{"vertices", filled.mesh.vertices.size()},
                           {"quads", filled.mesh.quads.size()},
                           {"irregular_interior", counts.irregular_interior},
                           {"irregular_boundary", counts.irregular_boundary},
                           {"valences", valences},
                           {"alpha", filled.alpha},
                           {"ms", {{"topology", times.topology_ms}, {"solve", times.solve_ms}}}};
    std::printf("%s\n", out.dump().c_str());
}

core::Result<core::FilledRegion> fill(const FillOptions& options, FillTimes& times) {
    const core::Result<core::RegionOutline> outline = core::read_region(options.region);
    if (!outline) return core::unexpected(outline.error());
    const auto blame = [&](const core::Error& error) {
        return core::unexpected(error.code, error.message, options.region);
    };
    const core::Result<std::vector<core::Vec3>> ring = core::outline_ring(*outline);
    if (!ring) return blame(ring.error());
    const Stopwatch topology_watch;
    core::Result<core::RegionTopology> topology = core::outline_topology(*outline);
    if (!topology) return blame(topology.error());
    times.topology_ms = topology_watch.ms();
    const Stopwatch solve_watch;
    core::FilledRegion filled = core::fill_ring(std::move(*topology), *ring, options.alpha);
    times.solve_ms = solve_watch.ms();
    return filled;
}

void run_fill(const FillOptions& options, CommandState& state) {
    FillTimes times;
    const core::Result<core::FilledRegion> filled = fill(options, times);
    if (!filled) return fail(state, filled.error());
    if (const auto written = core::write_obj_file(options.out, filled->mesh); !written)
        return fail(state, written.error());
    print_fill(*filled, times, options.json);
}

}  // namespace

void add_garment_commands(CLI::App& cli, CommandState& state) {
    CLI::App* garment = cli.add_subcommand("garment", "Cloth from outlines");
    garment->require_subcommand(1);
    auto options = std::make_shared<FillOptions>();
    CLI::App* command = garment->add_subcommand("fill", "Quad mesh of one region");
    command->add_option("REGION", options->region, "JSON: {\"sides\": [[[x, y, z], ...], ...]}, sides in order")
        ->required();
    command->add_option("--out", options->out, "the OBJ file to write")->required();
    command
        ->add_option("--alpha", options->alpha,
                     "-0.25: the boundary's shape reaches far in (discrete Coons); 0: flat (harmonic)")
        ->check(CLI::Range(-0.25, 0.0))
        ->capture_default_str();
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &state] { run_fill(*options, state); });
}

}  // namespace app
