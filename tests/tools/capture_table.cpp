// Tables of recordings, as Markdown: what each tablet reports and which parser reads it; then each recording that does
// not show what its name says, with the reason.
//
//     capture_table FOLDER...

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "../support/plausible_pen.hpp"

namespace {

struct Row {
    std::string name;
    support::PenAction action = support::PenAction::None;
    input::DecodedCapture decoded;
    support::Plausibility seen;
    std::string missing;
};

bool is_recording(const std::filesystem::path& path) {
    const std::string extension = path.extension().string(), whole = path.string();
    const bool text =
        extension == ".txt" && (whole.find("dump") != std::string::npos || whole.ends_with("hidrecord.txt"));
    return text || extension == ".events" || extension == ".evemu";
}

std::vector<std::string> recordings_in(const char* folder) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file() && is_recording(entry.path())) files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

Row row_of(const std::string& path, const char* root) {
    Row row;
    row.name = std::filesystem::relative(path, root).string();
    row.action = support::action_of(path);
    const core::Result<input::Capture> capture = input::read_capture(path);
    if (!capture) {
        row.missing = capture.error().message;
        return row;
    }
    row.decoded = input::decode_capture(*capture, input::find_surroundings(path));
    row.seen = support::look_at(row.decoded.samples);
    row.missing =
        row.decoded.why_none ? *row.decoded.why_none : support::what_is_missing(row.action, row.seen, row.decoded.axes);
    return row;
}

std::string range(const std::optional<input::AxisRange>& a) {
    return a ? std::to_string(a->min) + "…" + std::to_string(a->max) : "-";
}

std::string tablet_of(const Row& row) {
    const std::size_t slash = row.name.find('/');
    std::string first = row.name.substr(0, slash);
    return first == "tablets" ? row.name.substr(slash + 1) : first;
}

/// One line for a tablet and parser and range: modes of one tablet are told apart by their ranges.
void print_tablets(const std::vector<Row>& rows) {
    std::map<std::string, std::vector<const Row*>> lines;
    for (const Row& row : rows) {
        const input::PenAxes& a = row.decoded.axes;
        if (row.decoded.samples.empty()) continue;
        lines[tablet_of(row) + " | " + input::vendor_product(row.decoded.device) + " | " + row.decoded.parser + " | " +
              range(a.x) + " | " + range(a.y) + " | " + range(a.pressure) + " | " + range(a.tilt_x)]
            .push_back(&row);
    }
    std::printf(
        "| tablet | device | parser | x | y | pressure | tilt | mm | Hz | recordings "
        "|\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& [line, members] : lines) {
        std::vector<double> rates;
        for (const Row* row : members) rates.push_back(input::report_rate_hz(row->decoded.samples));
        std::sort(rates.begin(), rates.end());
        const input::PenAxes& a = members.front()->decoded.axes;
        const bool sized = a.width_mm() && a.height_mm();
        std::printf("| %s | ", line.c_str());
        if (sized) std::printf("%.0f×%.0f", *a.width_mm(), *a.height_mm());
        std::printf(" | %.0f | %zu |\n", rates[rates.size() / 2], members.size());
    }
}

void print_faults(const std::vector<Row>& rows) {
    std::printf("\n| recording | samples | what it does not show |\n|---|---|---|\n");
    for (const Row& row : rows) {
        const bool of_pen = row.action != support::PenAction::None;
        if (row.missing.empty() || (!of_pen && row.decoded.samples.empty())) continue;
        std::printf("| %s | %zu | %s |\n", row.name.c_str(), row.decoded.samples.size(), row.missing.c_str());
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<Row> rows;
    for (int i = 1; i < argc; ++i) {
        for (const std::string& file : recordings_in(argv[i])) rows.push_back(row_of(file, argv[i]));
    }
    print_tablets(rows);
    print_faults(rows);
    std::size_t shown = 0, of_pen = 0;
    for (const Row& row : rows) {
        of_pen += row.action != support::PenAction::None ? 1 : 0;
        shown += row.action != support::PenAction::None && row.missing.empty() ? 1 : 0;
    }
    std::printf("\n%zu recordings, %zu named after something done with a pen; %zu of those show it.\n", rows.size(),
                of_pen, shown);
}
