#pragma once
// The silhouette of a drawing while it is drawn: each new sample changes only what it reaches.
//
//     core::LiveSilhouette live;
//     live.follow(drawing);                                  // after each new sample, or several
//     const core::Result<core::Silhouette> s = live.silhouette();   // == core::find_silhouette(drawing, options)
//
// The very same pixels as find_silhouette makes in one go, at every step: closing.hpp says what is filled. Kept are the
// squared distance of every pixel to the nearest ink, as far as closing can reach, and for each radius one bit a pixel
// that says whether the pixel lies farther from ink than the radius. New ink lowers distances and clears bits in discs
// about its own edge. What is enclosed at each radius is found by union-find over the runs of those bit rows, which
// sees every loop that closed and every one that opened again; a few microseconds a radius, whatever happened.
//
// Three things begin anew (rebuilds() counts): the raster's scale steps when the drawing's diagonal passes a fourth
// root of two, so a drawing that grows a hundredfold has 27 steps, the first ones with hardly any ink; the drawing
// outgrows the working raster to one side; strokes were taken away, by undo or the eraser. A rebuild finds all
// distances with two passes over the raster (Meijster, Roerdink, Hesselink, "A general algorithm for computing distance
// transforms in linear time", 2000) and depends on nothing that was there before: undo gives back exactly what was.
//
// Where what is drawn last lies far off the object, the object is laid out again on its own, as find_silhouette does;
// a second raster follows it then.

#include <memory>
#include <vector>

#include "core/silhouette/closing.hpp"

namespace core {

class LiveSilhouette {
  public:
    /// closing_share times the larger of room and 1 is at most 0.4.
    explicit LiveSilhouette(const SilhouetteOptions& options = {});
    ~LiveSilhouette();
    LiveSilhouette(LiveSilhouette&&) noexcept;
    LiveSilhouette& operator=(LiveSilhouette&&) noexcept;

    /// Makes it the silhouette of this drawing. Samples after those of the last call cost what they change, plus one
    /// comparison for each sample before them; anything else is a rebuild.
    void follow(const Drawing& drawing);

    /// Of the drawing followed last. Errors of find_silhouette. Copies the object's pixels, 0.05 ms.
    [[nodiscard]] Result<Silhouette> silhouette() const;

    /// How often the raster was made anew.
    [[nodiscard]] std::uint64_t rebuilds() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace core
