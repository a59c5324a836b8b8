// The kiosk with a handful of built animals to find: for looking at the screen, and for the test of the real window.
//
//     kiosk_demo [--headless] [--windowed] [--size WxH] [--shots DIR] [--record DIR] [--replay FILE.ndjson[:LINE]]...
//                [--horse] [--left] [--language CODE] [--notice none|no-models|missing|damaged] [--slow MS]

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "firmware_like_app/kiosk/kiosk.hpp"
#include "tests/support/figures.hpp"

namespace {

app::NamedDrawing read_line(std::string file) {
    std::size_t line_number = 0;
    const std::size_t colon = file.rfind(':');
    if (colon != std::string::npos) {
        line_number = std::strtoul(file.c_str() + colon + 1, nullptr, 10);
        file.resize(colon);
    }
    std::ifstream in(file);
    std::string line;
    for (std::size_t i = 0; i <= line_number; ++i) std::getline(in, line);
    const nlohmann::json object = nlohmann::json::parse(line);
    app::NamedDrawing named{object.value("word", "drawing"), {}};
    for (const nlohmann::json& columns : object["drawing"]) {
        core::Stroke stroke;
        for (std::size_t i = 0; i < columns[0].size(); ++i) {
            const double ms = columns.size() > 2 ? columns[2][i].get<double>() : 0.0;
            stroke.samples.push_back(
                {static_cast<std::int64_t>(ms * 1000), columns[0][i].get<double>(), columns[1][i].get<double>(), 1.0});
        }
        named.drawing.strokes.push_back(std::move(stroke));
    }
    return named;
}

app::CollectionState state_of(const std::string& word) {
    if (word == "no-models") return app::CollectionState::Empty;
    if (word == "missing") return app::CollectionState::Missing;
    if (word == "damaged") return app::CollectionState::Damaged;
    return app::CollectionState::Ready;
}

}  // namespace

int main(int argc, char** argv) {
    app::KioskOptions options;
    std::vector<app::NamedDrawing> replays;
    int slow_ms = 0;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto value = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string(); };
        if (word == "--headless") options.headless = true;
        if (word == "--windowed") options.windowed = true;
        if (word == "--left") options.hand = ui::Hand::Left;
        if (word == "--horse") replays.push_back({"horse", test::make_horse_drawing()});
        if (word == "--shots") options.shots = value();
        if (word == "--record") options.record = value();
        if (word == "--language") options.language = value();
        if (word == "--notice") options.collection = state_of(value());
        if (word == "--slow") slow_ms = std::atoi(value().c_str());
        if (word == "--replay") replays.push_back(read_line(value()));
        if (word == "--size") {
            ui::SizePx size;
            if (std::sscanf(value().c_str(), "%dx%d", &size.width, &size.height) == 2) options.size = size;
        }
    }
    test::FigureSearcher searcher(test::make_animals(), std::chrono::milliseconds(slow_ms));
    const core::Result<app::KioskReport> report = app::run_kiosk(options, &searcher, std::move(replays));
    if (!report) {
        std::cerr << report.error().sentence() << '\n';
        return 1;
    }
    for (const app::ReplayReport& replay : report->replays) {
        std::cout << replay.name << ": " << replay.searches << " searches, first "
                  << (replay.names.empty() ? "none" : replay.names[0]) << '\n';
        for (const auto& shot : replay.shots) std::cout << shot.string() << '\n';
    }
    std::cout << report->frames << " frames, median " << report->median_frame_ms << " ms, worst "
              << report->worst_frame_ms << " ms, " << report->renderer << '\n';
    return 0;
}
