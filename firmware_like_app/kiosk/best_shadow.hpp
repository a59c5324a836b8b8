#pragma once
// The faint shadow of the best match under the ink: which one, where, and how it changes. It is calm: another model has
// to be the best of two rankings running, and each change takes a cross-fade of 400 ms.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "firmware_like_app/kiosk/newest_worker.hpp"
#include "firmware_like_app/kiosk/search_worker.hpp"
#include "firmware_like_app/kiosk/shadow_shape.hpp"
#include "ui/draw/ink_curve.hpp"
#include "ui/draw/painter.hpp"
#include "ui/screens/find_screen.hpp"

namespace app {

class BestShadow {
  public:
    static constexpr std::int64_t kFade_us = 400'000, kEvery_us = 250'000;  ///< shapes are made no more often

    /// `beside`: shapes are made on another thread; else, and when settle() asks for them, at once.
    explicit BestShadow(bool beside);

    /// A new ranking, and the box of all ink. Nothing in it: the shadow leaves.
    void see(std::shared_ptr<const PreparedAnswer> ranking, const Extent& drawing);
    /// Once a frame: takes what is ready, begins a fade. `last`: the newest ranking will stay, as no pen is down.
    void update(std::int64_t now_us, bool last, ui::Painter& painter);
    /// The shadow of the newest ranking at once, without fading.
    void settle(ui::Painter& painter);
    /// At once without any, as for another drawing.
    void clear(ui::Painter& painter);
    /// What is seen: the one that leaves before the one that comes. Opacity goes in twelfths, so that a fade draws no
    /// more frames than the eye needs.
    [[nodiscard]] std::vector<ui::ShadowPart> shown(std::int64_t now_us, const ui::InkFrame& frame,
                                                    const ui::Rect& sheet) const;

  private:
    struct Job {
        std::uint64_t epoch = 0;
        std::shared_ptr<const PreparedAnswer> ranking;
        Extent drawing;
    };
    struct Ready {
        std::uint64_t epoch = 0;
        std::int64_t model = 0;
        ShadowShape shape;
    };
    struct Layer {
        ui::Texture coverage;
        ShadowShape place;  ///< without its pixels
        int picture = 0;
    };
    [[nodiscard]] static Ready make(const Job& job);
    void show(Ready ready, std::int64_t now_us, ui::Painter& painter);
    void leave(std::int64_t now_us, ui::Painter& painter);

    std::unique_ptr<NewestWorker<Job, Ready>> worker_;
    std::shared_ptr<const PreparedAnswer> newest_;
    Extent drawing_;
    std::optional<std::int64_t> candidate_;  // best of the newest ranking
    bool held_ = false, asked_ = false;      // of the ranking before, too; this ranking's shape was asked for
    std::uint64_t epoch_ = 0;                // what is made for an older one is not shown
    std::optional<Layer> now_, before_;
    std::int64_t changed_us_ = 0, asked_us_ = 0;
    int pictures_ = 0;
};

}  // namespace app
