// plot_scene.h — what a plot shows: the path of a run, thinned to what the eye can tell apart.
//
// Collects planned motion of a program of any length in bounded memory. Knows nothing of paper,
// colours or SVG; plot_svg.h draws it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "motion/segment.h"

namespace kadr::plot {

/// A box around points, mm; empty while lower > upper.
struct SceneBox {
    path::Vec3 lower = path::Vec3::Constant(1e300);
    path::Vec3 upper = path::Vec3::Constant(-1e300);

    bool is_empty() const { return lower.x() > upper.x(); }
    void add(const path::Vec3& point);
    void add(const SceneBox& other);
    double largest_side() const;
};

/// One piece of path; it begins where the piece before it ends.
struct PlotPiece {
    enum class Kind : std::uint8_t { Jump, Rapid, Feed };  // Jump: not drawn, the path begins anew

    path::Vec3 to = path::Vec3::Zero();
    Kind kind = Kind::Feed;
    std::int32_t arc = -1;  // index into PlotScene::arcs; -1: straight
    double shade = 0;       // what it is coloured by: the feed asked for or a line number
};

struct PlotArc {
    path::Vec3 center = path::Vec3::Zero();
    path::Vec3 normal = path::Vec3::UnitZ();
    double sweep = 0;  // rad, counter-clockwise about the normal
};

/// The point of an arc after a share of its sweep; radius and height go evenly from start to end.
path::Vec3 point_on_arc(const PlotArc& arc, const path::Vec3& from, const path::Vec3& to,
                        double share);

class PlotScene {
  public:
    /// Adds a piece of motion; what does not move the tool tip is ignored. `shade` is what its
    /// colour stands for.
    void add(const motion::Segment& segment, double shade);

    std::span<const PlotPiece> pieces() const { return pieces_; }
    const PlotArc& arc(const PlotPiece& piece) const {
        return arcs_[static_cast<std::size_t>(piece.arc)];
    }
    const SceneBox& feed_box() const { return feed_box_; }
    const SceneBox& rapid_box() const { return rapid_box_; }

  private:
    void append(const PlotPiece& piece);
    void thin();
    void thin_to(double tolerance, bool keeps_shades);

    std::vector<PlotPiece> pieces_;
    std::vector<PlotArc> arcs_;
    SceneBox feed_box_;
    SceneBox rapid_box_;
    path::Vec3 at_ = path::Vec3::Zero();
    bool has_begun_ = false;  // `at_` holds
    double tolerance_ = 0;
};

}  // namespace kadr::plot
