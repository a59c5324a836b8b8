#pragma once
// What the eval commands share: their options, labelled lists, and how metrics are printed.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/evaluate/retrieval_metrics.hpp"
#include "core/exchange/list_file.hpp"
#include "core/fusion/fused_match.hpp"
#include "firmware_like_app/collection/collection.hpp"
#include "firmware_like_app/commands/commands.hpp"

namespace app {

struct EvalOptions {
    std::string list, files, database;
    int ranks = 0;
    int jobs = core::core_count();
    std::optional<unsigned> shuffle;
    bool json = false;
};

/// The described files of a list, in its order.
struct DescribedList {
    std::vector<std::string> classes;
    std::vector<core::ComparableShape> shapes;
    std::vector<std::string> failures;
};

/// Names on standard error what is listed but not there. FileMissing where nothing is.
[[nodiscard]] core::Result<core::LabelledList> read_list(const EvalOptions& options);

/// Those that cannot be described are named on standard error.
[[nodiscard]] DescribedList describe_list(const std::vector<core::LabelledFile>& files, int jobs);

/// The described drawings of a list, in its order, each in all its readings.
struct DescribedSketches {
    std::vector<std::string> classes;
    std::vector<std::vector<core::ComparableShape>> sketches;
    std::vector<std::string> failures;
};
[[nodiscard]] DescribedSketches describe_sketches(const std::vector<core::LabelledFile>& files, int jobs);

/// The index, its warnings on standard error. FileMissing where it has no models.
[[nodiscard]] core::Result<Collection> load_for_eval(const std::string& database);

[[nodiscard]] nlohmann::ordered_json to_json(const core::RetrievalMetrics& metrics);

/// One line: name, then NN to AP.
void print_metrics(const std::string& name, const core::RetrievalMetrics& metrics);

void run_eval_shapes(const EvalOptions& options, CommandState& state);
void run_eval_sketches(const EvalOptions& options, CommandState& state);
void run_eval_models(const EvalOptions& options, CommandState& state);

}  // namespace app
