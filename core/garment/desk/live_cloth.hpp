#pragma once
// Cloth that follows a slider or a dragged vertex: the fillings of a layer with their factorisations kept, so that a
// change costs a solve and no more.
//
//     core::LiveCloth live(network, layer, mirror, finished, obstacle);
//     live.set_alpha("front", -0.1);           // one factorisation of one piece
//     live.follow(moved_network);              // the same lines elsewhere: solves of the pieces they bound
//     live.places();                           // of finished.fitted's vertices
//
// What is shown is the finished cloth moved by what the filling moved, and out of the body where that would lead into
// it: it does not jump when the drag begins, and is fitted to the body again when it rests.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/garment/design.hpp"

namespace core {

class LiveCloth {
  public:
    /// `finished` is the layer as built from this network, `below` what it must stay outside of. Pieces that cannot be
    /// filled stand still. Analyses and factorises every piece: about 40 ms for 10,000 vertices.
    LiveCloth(const Network& network, int layer, bool mirror, const FinishedLayer& finished,
              std::shared_ptr<const Obstacle> below);

    /// Clamped as PermanencePatch::set_alpha. Nothing happens for a name that is no piece of the layer.
    void set_alpha(const std::string& region, double alpha);

    /// Lines with the same numbers as before, at other places; each keeps its number of edges. Nothing happens when
    /// lines were split or came new: then the cloth must be built anew, and `false` is returned.
    bool follow(const Network& moved);

    [[nodiscard]] const std::vector<Vec3>& places() const { return places_; }

    [[nodiscard]] std::size_t pieces() const { return pieces_.size(); }

  private:
    struct Piece {
        std::string name;
        std::vector<BoundaryKey> keys;      // of its boundary, in order
        std::vector<std::uint32_t> vertex;  // of the cloth, for each of its own
        std::vector<std::uint32_t> image;   // beyond x = 0, or none
        PermanencePatch patch;
        std::vector<Vec3> now;
    };
    void show(const Piece& piece);

    std::shared_ptr<const Obstacle> below_;
    std::vector<int> edges_;  // of each line when it began
    std::vector<std::array<int, 2>> ends_;
    std::vector<Piece> pieces_;
    std::vector<Vec3> drawn_, fitted_;  // when it began
    std::vector<Vec3> places_;
};

}  // namespace core
