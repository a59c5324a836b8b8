#pragma once
// Flat patterns of a garment: what is cut from fabric to sew it.
//
//     const auto pattern = core::make_pattern(design, *garment, {});
//     core::write_pattern(folder, *pattern, …);      // core/exchange/pattern_files.hpp

#include <array>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/design.hpp"

namespace core {

struct PatternOptions {
    double seam_allowance_cm = 1.0, hem_allowance_cm = 3.0;
    int curve_steps = 4;  ///< straight pieces that an edge of a quad is drawn with
};

/// One stretch of a piece's border: along one drawn line, sewn to one other piece or to none.
struct PatternSide {
    enum class Kind { Seam, Hem, Fold };
    Kind kind = Kind::Hem;
    std::string name;          ///< of the drawn line
    std::vector<Point> line;   ///< cm, anti-clockwise along the piece, ends included
    int edges = 0;             ///< of quads; the same on both sides of a seam
    double in_space_cm = 0.0;  ///< its length on the garment
};

struct PatternNotch {
    Point at, outward;  ///< on the sew line; a unit vector away from the piece
};

struct PatternPiece {
    std::string name;
    int layer = 0;                   ///< from 0
    int copies = 1;                  ///< 2: the second one mirrored
    bool on_fold = false;            ///< cut once from doubled fabric
    std::vector<PatternSide> sides;  ///< the sew line, each side from where the one before ends
    std::vector<Point> cut_line;     ///< a ring, outside of the sew line by the allowances
    std::array<Point, 2> grain;      ///< lower end, upper end
    std::vector<PatternNotch> notches;
    double mean_strain = 0.0, high_strain = 0.0, largest_strain = 0.0;  ///< see FlatPiece
    std::vector<std::array<Point, 4>> quads;                            ///< flat, for the map of strain
    std::vector<double> strain;                                         ///< of each quad
    Point most_strained;  ///< the middle of the quad with the largest strain, slivers left out
};

/// Two sides that are sewn together. `mirrored`: to the second, mirrored copy of piece_b.
struct PatternSeam {
    std::size_t piece_a = 0, side_a = 0, piece_b = 0, side_b = 0;
    bool mirrored = false;
    double length_a_cm = 0.0, length_b_cm = 0.0;
    [[nodiscard]] double mismatch() const;  ///< difference as a share of the longer one
};

struct Pattern {
    std::string name;
    std::vector<PatternPiece> pieces;
    std::vector<PatternSeam> seams;
    std::vector<DesignFault> faults;  ///< pieces that could not be laid flat, and why
};

/// A piece with more high_strain than this wants a dart, gathers or another seam.
inline constexpr double kDartStrain = 0.1;

/// Lays the fitted pieces flat, those that are no image of another; seams keep the same length on both sides as far as
/// flatten lets them. Each seam of 4 edges or more has a notch on either side, at the same vertex. A side on the
/// symmetry plane that lies straight within a millimetre is a fold. The same garment gives the same pattern. About
/// 100 ms for 1,000 quads. ErrorCode::BadArgument for allowances that are negative, no numbers or above 10 cm and when
/// there is no piece at all.
[[nodiscard]] Result<Pattern> make_pattern(const Design& design, const Garment& garment, const PatternOptions& options);

[[nodiscard]] double line_length_cm(const std::vector<Point>& line);

}  // namespace core
