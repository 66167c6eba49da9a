#include "plot/plot_scene.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include <Eigen/Geometry>

namespace kadr::plot {

namespace {

using path::Vec3;

// Pieces kept at most: about 20 MB, and more than a screen can show.
constexpr std::size_t kMaxPieces = 200'000;
// First thinning: a share of the whole picture that is a quarter of a pixel at 1000 pixels.
constexpr double kFirstTolerance = 1.0 / 4000;
// From here on, as a share of the picture, neighbours of different colour are joined too.
constexpr double kColorsGone = 1.0 / 500;
// Points between two kept ones that are held against the straight line; a longer run is cut.
constexpr std::size_t kRun = 64;
constexpr double kContinuous = 1e-6;  // mm between pieces that follow each other

double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
    const Vec3 along = to - from;
    const double length2 = along.squaredNorm();
    if (length2 == 0) return (point - from).norm();
    const double share = std::clamp((point - from).dot(along) / length2, 0.0, 1.0);
    return (point - (from + share * along)).norm();
}

}  // namespace

void SceneBox::add(const Vec3& point) {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
}

void SceneBox::add(const SceneBox& other) {
    if (other.is_empty()) return;
    add(other.lower);
    add(other.upper);
}

double SceneBox::largest_side() const { return is_empty() ? 0.0 : (upper - lower).maxCoeff(); }

Vec3 point_on_arc(const PlotArc& arc, const Vec3& from, const Vec3& to, double share) {
    const Vec3 start = from - arc.center;
    const Vec3 end = to - arc.center;
    const double height_start = start.dot(arc.normal);
    const double height_end = end.dot(arc.normal);
    const Vec3 spoke = start - height_start * arc.normal;
    const double radius_start = spoke.norm();
    if (radius_start == 0) return from + share * (to - from);
    const double radius_end = (end - height_end * arc.normal).norm();
    const double angle = share * arc.sweep;
    const double radius = radius_start + share * (radius_end - radius_start);
    const double height = height_start + share * (height_end - height_start);
    const Vec3 turned = std::cos(angle) * spoke + std::sin(angle) * arc.normal.cross(spoke);
    return arc.center + turned * (radius / radius_start) + height * arc.normal;
}

void PlotScene::add(const motion::Segment& segment, double shade) {
    const bool moves = motion::is_motion(segment.kind) || motion::is_external(segment.kind);
    if (!moves || path::length(segment.curve) == 0) return;
    PlotPiece piece;
    piece.to = path::end(segment.curve);
    piece.shade = shade;
    const bool is_idle =
        segment.kind == motion::SegmentKind::Rapid || segment.kind == motion::SegmentKind::Jump;
    piece.kind = is_idle ? PlotPiece::Kind::Rapid : PlotPiece::Kind::Feed;
    // Where a program starts from is the operator's matter: the picture starts where its first
    // rapid arrives.
    const bool is_approach = !has_begun_ && piece.kind == PlotPiece::Kind::Rapid;
    const Vec3 from = is_approach ? piece.to : path::start(segment.curve);
    // Another tool has its tip elsewhere, without a path between.
    const bool begins_anew = !has_begun_ || (from - at_).norm() > kContinuous;
    has_begun_ = true;
    at_ = piece.to;
    if (begins_anew) append({.to = from, .kind = PlotPiece::Kind::Jump, .shade = shade});
    if (is_approach) return;
    const path::Box bounds = path::bounds(segment.curve);
    SceneBox& box = piece.kind == PlotPiece::Kind::Rapid ? rapid_box_ : feed_box_;
    box.add(bounds.lower);
    box.add(bounds.upper);
    if (const auto* helix = std::get_if<path::Helix>(&segment.curve)) {
        piece.arc = static_cast<std::int32_t>(arcs_.size());
        arcs_.push_back({helix->base, helix->normal, helix->sweep});
    }
    if (path::bends_freely(segment.curve)) {
        constexpr int kChords = 8;  // of a piece that bends little
        const double length = path::length(segment.curve);
        PlotPiece chord = piece;
        for (int i = 1; i < kChords; ++i) {
            chord.to = path::position(segment.curve, length * i / kChords);
            append(chord);
        }
    }
    append(piece);
}

void PlotScene::append(const PlotPiece& piece) {
    if (pieces_.size() >= kMaxPieces) thin();
    // Only a path that jumps more often than it moves cannot be thinned; its end is left out.
    if (pieces_.size() < kMaxPieces) pieces_.push_back(piece);
}

void PlotScene::thin() {
    SceneBox all = feed_box_;
    all.add(rapid_box_);
    const double side = std::max(all.largest_side(), 1e-6);
    tolerance_ = std::max(tolerance_, side * kFirstTolerance);
    while (true) {
        thin_to(tolerance_, tolerance_ < side * kColorsGone);
        if (pieces_.size() <= kMaxPieces / 2 || tolerance_ > 2 * side) return;
        tolerance_ *= 2;
    }
}

// Runs of straight pieces of one look become one piece as long as no point between is further from
// it than the tolerance. Arcs that are smaller than the tolerance become straight.
void PlotScene::thin_to(double tolerance, bool keeps_shades) {
    std::vector<PlotPiece> kept;
    std::vector<PlotArc> kept_arcs;
    std::vector<Vec3> between;
    Vec3 from = Vec3::Zero();  // where the latest kept piece begins
    for (PlotPiece piece : pieces_) {
        const Vec3 start = kept.empty() ? piece.to : kept.back().to;
        if (piece.arc >= 0) {
            const PlotArc& arc = this->arc(piece);
            if (2 * (start - arc.center).norm() > tolerance) {
                piece.arc = static_cast<std::int32_t>(kept_arcs.size());
                kept_arcs.push_back(arc);
            } else {
                piece.arc = -1;
            }
        }
        const bool may_join = !kept.empty() && piece.arc < 0 && kept.back().arc < 0 &&
                              piece.kind != PlotPiece::Kind::Jump &&
                              piece.kind == kept.back().kind && between.size() < kRun &&
                              (!keeps_shades || piece.shade == kept.back().shade);
        const bool joins = may_join && distance_to_segment(start, from, piece.to) <= tolerance &&
                           std::all_of(between.begin(), between.end(), [&](const Vec3& point) {
                               return distance_to_segment(point, from, piece.to) <= tolerance;
                           });
        if (joins) {
            between.push_back(start);
            kept.back().to = piece.to;
        } else {
            between.clear();
            from = start;
            kept.push_back(piece);
        }
    }
    pieces_ = std::move(kept);
    arcs_ = std::move(kept_arcs);
}

}  // namespace kadr::plot
