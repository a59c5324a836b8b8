#include "core/exchange/pattern_files.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

namespace core {
namespace {

using Json = nlohmann::ordered_json;

/// Micrometres are enough, and the same on every machine.
double mm(double cm) {
    return std::round(cm * 1e4) / 1e3;
}
double rounded(double value) {
    return std::round(value * 1e6) / 1e6;
}

Json points_mm(const std::vector<Point>& points) {
    Json list = Json::array();
    for (const Point p : points) list.push_back({mm(p.x), mm(p.y)});
    return list;
}

const char* name_of(PatternSide::Kind kind) {
    return kind == PatternSide::Kind::Seam ? "seam" : kind == PatternSide::Kind::Fold ? "fold" : "hem";
}

Json to_json(const PatternPiece& piece) {
    Json sides = Json::array(), notches = Json::array();
    for (const PatternSide& side : piece.sides)
        sides.push_back({{"line", side.name},
                         {"kind", name_of(side.kind)},
                         {"edges", side.edges},
                         {"length_mm", mm(line_length_cm(side.line))},
                         {"on_garment_mm", mm(side.in_space_cm)},
                         {"points", points_mm(side.line)}});
    for (const PatternNotch& notch : piece.notches) notches.push_back({mm(notch.at.x), mm(notch.at.y)});
    Json json{{"name", piece.name},
              {"layer", piece.layer + 1},
              {"copies", piece.copies},
              {"on_fold", piece.on_fold},
              {"strain",
               {{"mean", rounded(piece.mean_strain)},
                {"high", rounded(piece.high_strain)},
                {"largest", rounded(piece.largest_strain)}}},
              {"sides", std::move(sides)},
              {"cut_line", points_mm(piece.cut_line)},
              {"grain", points_mm({piece.grain[0], piece.grain[1]})},
              {"notches", std::move(notches)}};
    if (piece.high_strain > kDartStrain)
        json["dart_wanted_at"] = {mm(piece.most_strained.x), mm(piece.most_strained.y)};
    return json;
}

Result<void> write_file(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
        return unexpected(ErrorCode::WriteFailed, "The file cannot be written; check the folder and the free space.",
                          path.string());
    return {};
}

}  // namespace

std::string pattern_json(const Pattern& pattern) {
    Json pieces = Json::array(), seams = Json::array();
    for (const PatternPiece& piece : pattern.pieces) pieces.push_back(to_json(piece));
    for (const PatternSeam& seam : pattern.seams)
        seams.push_back(
            {{"a", {{"piece", pattern.pieces[seam.piece_a].name}, {"side", seam.side_a}}},
             {"b",
              {{"piece", pattern.pieces[seam.piece_b].name}, {"side", seam.side_b}, {"mirrored_copy", seam.mirrored}}},
             {"line", pattern.pieces[seam.piece_a].sides[seam.side_a].name},
             {"edges", pattern.pieces[seam.piece_a].sides[seam.side_a].edges},
             {"length_a_mm", mm(seam.length_a_cm)},
             {"length_b_mm", mm(seam.length_b_cm)},
             {"mismatch", rounded(seam.mismatch())}});
    const Json document{{"format", "croquis-pattern"},
                        {"version", 1},
                        {"name", pattern.name},
                        {"pieces", std::move(pieces)},
                        {"seams", std::move(seams)}};
    return document.dump(1, ' ') + "\n";
}

Result<std::vector<std::string>> write_pattern_folder(const std::filesystem::path& folder, const Pattern& pattern) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    const PatternSheet sheet = lay_out_sheet(pattern, kFabricWidth_cm);
    std::vector<std::pair<std::string, std::string>> files{{"pattern.svg", sheet_svg(sheet)},
                                                           {"pattern.dxf", pattern_dxf(pattern, sheet)},
                                                           {"seams.json", pattern_json(pattern)},
                                                           {"strain.svg", strain_svg(pattern, sheet)}};
    for (const PaperSize& paper : {kA4, kA3, kLetter}) {
        Result<std::string> pdf = sheet_pdf(sheet, paper);
        if (!pdf) return unexpected(pdf.error().code, pdf.error().message, folder.string());
        files.emplace_back(std::string("pattern-") + paper.name + ".pdf", std::move(*pdf));
    }
    std::vector<std::string> paths;
    for (const auto& [name, bytes] : files) {
        const std::filesystem::path path = folder / name;
        if (const Result<void> written = write_file(path, bytes); !written) return unexpected(written.error());
        paths.push_back(path.string());
    }
    return paths;
}

}  // namespace core
