#pragma once
// Every parameter of the part descriptor and of its distance: tables 5.1 and 5.2 of the thesis, and the values that the
// thesis uses without naming. A departure from the printed value says what it gained.

namespace core {

struct ShapeParameters {
    // --- contour (not in the tables; reading notes, "Contour") ---
    /// Points of the even contour on which corners are sought. At 400 a corner lies up to an eight hundredth of the
    /// perimeter off, and copies of half the size find their original less often.
    int contour_points = 1200;
    double contour_sigma = 6.0;  ///< Gaussian along the contour, in those points

    // --- table 5.1 ---
    /// Window: contour points over which cornerity is taken. The table says 10, of a contour of unnamed length; of 20
    /// to 40, 24 and 26 are best: 190.2 for the parts of Kimia-99 and Kimia-216, 189.4 at 30.
    int window = 24;
    double extent = 0.5;        ///< Extent: share of the window that must have less cornerity
    int sample_size = 100;      ///< SampleSize: samples of the outline
    double scale_coef = 1.125;  ///< ScaleCoef: stretch along the axis of least inertia, for the triangulation alone
    double small_area = 0.01;   ///< SmallArea: share of the shape's area
    /// ThreshSmallCLR: a small terminal flatter than this is insignificant. The table says 0.75; 0.7 to 0.72 gain 0.6
    /// in the sum of Kimia-99 and Kimia-216.
    double thresh_small_clr = 0.7;
    /// ThreshAnyCLR: any terminal flatter than this is insignificant. The table says 0.9; with 0.95 the sum of Kimia-99
    /// and Kimia-216 goes from 189.5 to 190.3.
    double thresh_any_clr = 0.95;
    double large_t = 20.0;          ///< LargeT: per cent of area or perimeter that makes a part large
    double small_long_t = 5.0;      ///< SmallLongT: per cent of perimeter …
    double small_et = 2.0;          ///< SmallET: … from which this eccentricity makes a part long
    double large_long_t = 10.0;     ///< LargeLongT: per cent of perimeter …
    double large_et = 1.25;         ///< LargeET: … from which this eccentricity makes a part long
    int n_pockets = 2;              ///< NPockets: pockets between a part and its hull that make it bent
    double size_bent_t = 7.0;       ///< SizeBentT: per cent of perimeter from which a part can be bent
    double convexity_t = 0.9;       ///< ConvexityT: hull perimeter / perimeter up to which a part is bent
    double signature_unit = 100.0;  ///< the signature is in units of perimeter / this (5.4 item 10; reading notes)

    // --- used by the thesis, not named in its tables ---
    /// A sample that turns clockwise by more than this exempts a terminal from insignificance (5.2.2). At 0 the ripple
    /// of pixels exempts as well: 169.8 instead of 171.0 for the parts alone; 10 to 30 do not differ.
    double sharp_turn_deg = 20.0;
    int junction_block_limit = 10;  ///< chords of a junction block up to which all subsets are tried; above, greedy
    double depth_threshold_first = 5.0;  ///< per cent of area and perimeter merged away in the first iteration (5.3.1)
    double depth_threshold_step = 5.0;   ///< … and by how much more in each further one
    /// Per cent of the perimeter by which a wing must differ from a part with the same terminals, or it is no choice of
    /// its own. Without it there are a third more parts, at twice the time and 0.1 less; from 4 to 10 it makes no
    /// difference, at 15 it costs 0.7.
    double wing_step = 8.0;
    int wing_salient_limit = 2;  ///< salient parts that a wing may group (5.3.2 "no more than two")

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
