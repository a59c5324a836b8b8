// How stable shapes are under what does not change them: of every shape of a list, copies are made (moved, with ink and
// page exchanged, traced from another point, mirrored, turned in 12 steps, half, twice and four times as large), and
// each copy queries all originals.
//
//     stability_report LIST [EVERY]      LIST: path<TAB>class; only every EVERY-th shape is copied
//
// Prints for each copy how often both descriptors are identical, and how often the original is the nearest of all by
// the parts, by the contour and by both; "or repeat": by both, where a repeat of the original counts as the original.
// Sets hold the same drawing turned, scaled or mirrored under several names, and a copy is as near to these as to its
// own.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/exchange/image_reader.hpp"
#include "core/exchange/list_file.hpp"
#include "core/fusion/fused_match.hpp"
#include "core/silhouette/contour.hpp"
#include "support/picture_copies.hpp"

namespace {

core::GrayImage mask_of(const core::GrayImage& image) {
    const core::BinaryImage object = core::object_mask(image);
    core::GrayImage mask(object.width, object.height);
    for (std::size_t i = 0; i < object.pixels.size(); ++i) mask.pixels[i] = object.pixels[i] != 0 ? 255 : 0;
    return mask;
}

using support::inverted;
using support::moved;
using support::turned;

core::Result<core::Polygon> outline_of(const core::GrayImage& image) {
    return core::largest_contour(core::object_mask(image));
}

struct Copies {
    std::string name;
    int made = 0, identical = 0, by_parts = 0, by_contour = 0, by_both = 0, or_repeat = 0;
};

/// Whether the parts are the same and the samples differ by a whole shift alone.
bool identical(const core::OutlineReadings& of_a, const core::OutlineReadings& of_b) {
    if (of_a.contour != of_b.contour) return false;
    const core::ShapeDescriptor &a = of_a.parts, &b = of_b.parts;
    if (a.parts != b.parts || a.stop_points != b.stop_points || a.samples.size() != b.samples.size()) return false;
    const core::Point shift = b.samples.front() - a.samples.front();
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
        if (core::distance(a.samples[i] + shift, b.samples[i]) > 1e-9) return false;
    }
    return true;
}

class Report {
  public:
    explicit Report(const std::vector<core::Polygon>& outlines) {
        for (const core::Polygon& outline : outlines) {
            const auto described = core::read_outline(outline);
            readings_.push_back(described ? *described : core::OutlineReadings{});
            shapes_.push_back(core::comparable(readings_.back()));
        }
    }

    void try_copy(const std::string& name, std::size_t original, const core::Polygon& outline) {
        Copies& copies = of(name);
        ++copies.made;
        const auto described = core::read_outline(outline);
        if (!described) return;
        copies.identical += identical(readings_[original], *described) ? 1 : 0;
        const core::ComparableShape shape = core::comparable(*described);
        copies.by_parts += nearest(original, [&](const core::ComparableShape& s, double limit) {
            return matcher_.parts().distance(shape.parts, s.parts, limit);
        });
        copies.by_contour += nearest(original, [&](const core::ComparableShape& s, double limit) {
            return matcher_.contour().distance(shape.contour, s.contour, limit);
        });
        const auto by_both = [&](const core::ComparableShape& s, double limit) {
            return matcher_.distance(shape, s, limit);
        };
        copies.by_both += nearest(original, by_both);
        copies.or_repeat += nearest(original, by_both, true);
    }

    void print() const {
        Copies sum{"all"};
        for (const Copies& c : all_) {
            print(c);
            sum.made += c.made;
            sum.identical += c.identical;
            sum.by_parts += c.by_parts;
            sum.by_contour += c.by_contour;
            sum.by_both += c.by_both;
            sum.or_repeat += c.or_repeat;
        }
        print(sum);
    }

  private:
    static void print(const Copies& c) {
        const auto share = [&](int n) { return 100.0 * n / c.made; };
        std::printf(
            "%-14s %5d copies  identical %6.2f %%  nearest by parts %6.2f  contour %6.2f  both %6.2f  or repeat %6.2f "
            "%%\n",
            c.name.c_str(), c.made, share(c.identical), share(c.by_parts), share(c.by_contour), share(c.by_both),
            share(c.or_repeat));
    }
    /// 1 when nothing is nearer than the original, but for repeats of it where they count.
    template <class Distance>
    int nearest(std::size_t original, const Distance& distance, bool repeats_count = false) const {
        constexpr double kRepeat = 0.05;  // between classes the median is 1
        const double own = distance(shapes_[original], std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < shapes_.size(); ++i) {
            if (i == original || distance(shapes_[i], own) >= own) continue;
            if (!repeats_count || matcher_.distance(shapes_[original], shapes_[i], kRepeat) >= kRepeat) return 0;
        }
        return 1;
    }
    Copies& of(const std::string& name) {
        for (Copies& c : all_) {
            if (c.name == name) return c;
        }
        all_.push_back({name});
        return all_.back();
    }
    std::vector<core::OutlineReadings> readings_;
    std::vector<core::ComparableShape> shapes_;
    std::vector<Copies> all_;
    mutable core::FusedMatcher matcher_;  // its workspace
};

void try_copies(Report& report, std::size_t i, const core::GrayImage& mask) {
    const auto with = [&](const std::string& name, const core::GrayImage& image) {
        const auto outline = outline_of(image);
        if (outline) report.try_copy(name, i, *outline);
    };
    with("moved", moved(mask, 17, 5));
    with("inverted", inverted(moved(mask, 20, 20)));
    core::Polygon later = *outline_of(mask);
    std::rotate(later.begin(), later.begin() + static_cast<std::ptrdiff_t>(later.size() / 3), later.end());
    report.try_copy("other start", i, later);
    with("mirrored", turned(mask, 0, 1, true));
    for (int k = 1; k < 12; ++k) with("turned " + std::to_string(30 * k), turned(mask, 30.0 * k, 1, false));
    for (const double scale : {0.5, 2.0, 4.0}) {
        with("scaled " + std::to_string(scale).substr(0, 3), turned(mask, 0, scale, false));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: stability_report LIST [EVERY]\n");
        return 2;
    }
    const auto list = core::read_list_file(argv[1], std::nullopt);
    if (!list) {
        std::fprintf(stderr, "%s\n", list.error().sentence().c_str());
        return 1;
    }
    const std::size_t every = argc > 2 ? static_cast<std::size_t>(std::max(1, std::atoi(argv[2]))) : 1;
    std::vector<core::GrayImage> masks;
    std::vector<core::Polygon> outlines;
    for (const auto& file : list->files) {
        const auto image = core::read_gray_image(file.path);
        if (!image) continue;
        // A page around it, so that the polarity is never in doubt.
        masks.push_back(moved(mask_of(*image), 20, 20));
        const auto outline = outline_of(masks.back());
        outlines.push_back(outline ? *outline : core::Polygon{});
    }
    Report report(outlines);
    for (std::size_t i = 0; i < masks.size(); i += every) try_copies(report, i, masks[i]);
    report.print();
    return 0;
}
