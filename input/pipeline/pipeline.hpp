#pragma once
// The steps after a source, in their order, for every device that comes.
//
//     input::PenPipeline pipeline(options);
//     pipeline.attach(1, axes, reports_range);
//     for (const input::PenSample& s : from_source)
//         for (const input::PenSample& t : pipeline.feed(s)) …     // calibrated, smoothed, with a tip that draws
//     for (const input::PenSample& t : pipeline.expire(now_ns)) …  // pens that left without a word

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "input/pen_axes.hpp"
#include "input/pipeline/calibration.hpp"
#include "input/pipeline/cleaning.hpp"
#include "input/pipeline/one_euro_filter.hpp"
#include "input/pipeline/prediction.hpp"

namespace input {

class PenPipeline {
  public:
    explicit PenPipeline(const PipelineOptions& options) : options_(options) {}

    /// A tablet is there. A device that was not attached is treated as one without size that does not report range.
    void attach(std::uint32_t device, const PenAxes& axes, bool reports_range);
    /// It is gone. Gives the sample that says its pen is gone, when one was near.
    [[nodiscard]] std::optional<PenSample> detach(std::uint32_t device, std::int64_t now_ns);

    /// What is made of a sample: nothing for one that is left out.
    [[nodiscard]] std::optional<PenSample> feed(const PenSample& sample);
    /// Pens that have been silent for too long leave, in the order of their devices.
    [[nodiscard]] std::vector<PenSample> expire(std::int64_t now_ns);
    /// When expire() will have something to say, at the earliest.
    [[nodiscard]] std::optional<std::int64_t> due_ns() const;

    /// Where the device's pen will be; only for ink that is shown early.
    [[nodiscard]] std::optional<PenSample> predict(std::uint32_t device) const;

    /// Samples left out so far, of all devices.
    [[nodiscard]] std::uint64_t duplicates() const;
    [[nodiscard]] std::uint64_t out_of_order() const;

  private:
    struct Steps {
        OrderGuard order;
        ProximityTimeout proximity;
        TipThreshold tip;
        Calibration calibration;
        SmoothPlace smooth;
        PenPredictor predictor;
        bool near = false;
    };
    Steps make_steps(const PenAxes& axes, bool reports_range) const;
    [[nodiscard]] PenSample after_order(Steps& steps, const PenSample& sample) const;

    PipelineOptions options_;
    std::map<std::uint32_t, Steps> devices_;
    std::uint64_t duplicates_before_ = 0, out_of_order_before_ = 0;
};

}  // namespace input
