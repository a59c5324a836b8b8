#pragma once
// Every parameter of the part descriptor and of its distance: tables 5.1 and 5.2 of the thesis, and the values that the
// thesis uses without naming. A departure from the printed value says what it gained.

namespace core {

struct ShapeParameters {
    // --- contour (not in the tables; reading notes, "Contour") ---
    int contour_points = 400;    ///< points of the even contour on which corners are sought
    double contour_sigma = 2.0;  ///< Gaussian along the contour, in those points

    // --- table 5.1 ---
    int window = 10;            ///< Window: contour points over which cornerity is taken
    double extent = 0.5;        ///< Extent: share of the window that must have less cornerity
    int sample_size = 100;      ///< SampleSize: samples of the outline
    double scale_coef = 1.125;  ///< ScaleCoef: stretch along the axis of least inertia, for the triangulation alone
    double small_area = 0.01;   ///< SmallArea: share of the shape's area
    double thresh_small_clr = 0.75;  ///< ThreshSmallCLR: a small terminal flatter than this is insignificant
    double thresh_any_clr = 0.9;     ///< ThreshAnyCLR: any terminal flatter than this is insignificant
    double large_t = 20.0;           ///< LargeT: per cent of area or perimeter that makes a part large
    double small_long_t = 5.0;       ///< SmallLongT: per cent of perimeter …
    double small_et = 2.0;           ///< SmallET: … from which this eccentricity makes a part long
    double large_long_t = 10.0;      ///< LargeLongT: per cent of perimeter …
    double large_et = 1.25;          ///< LargeET: … from which this eccentricity makes a part long
    int n_pockets = 2;               ///< NPockets: pockets between a part and its hull that make it bent
    double size_bent_t = 7.0;        ///< SizeBentT: per cent of perimeter from which a part can be bent
    double convexity_t = 0.9;        ///< ConvexityT: hull perimeter / perimeter up to which a part is bent
    double signature_unit = 100.0;   ///< the signature is in units of perimeter / this (5.4 item 10; reading notes)

    // --- used by the thesis, not named in its tables ---
    double sharp_turn_deg =
        0.0;  ///< a sample that turns clockwise by more than this exempts a terminal from insignificance
    int junction_block_limit = 10;  ///< chords of a junction block up to which all subsets are tried; above, greedy
    double depth_threshold_first = 5.0;  ///< per cent of area and perimeter merged away in the first iteration (5.3.1)
    double depth_threshold_step = 5.0;   ///< … and by how much more in each further one
    int wing_salient_limit = 2;          ///< salient parts that a wing may group (5.3.2 "no more than two")

    // --- table 5.2: weights, multiplied with the feature before differences are taken ---
    double w_area = 1.0;  ///< area and perimeter are percentages with weight 1
    double w_perimeter = 1.0;
    double w_eccentricity = 10.0;
    double w_circularity = 40.0;
    double w_rectangularity = 40.0;
    double w_convexity = 25.0;
    double w_solidity = 25.0;
    double w_bending_energy = 0.5;
    double w_chord_length_ratio = 10.0;
    double w_d_e = 100.0;
    double w_d_be = 1.0;  ///< a percentage, weight 1
    double w_d_a = 0.1;   ///< per degree
};

}  // namespace core
