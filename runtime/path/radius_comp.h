// radius_comp.h — the path of a cutter's centre beside a contour, element by element, as a control
// computes it.
//
// A control sees the contour block by block: where an element ends beside it depends on the one
// that follows, and on nothing farther away than its look-ahead. What to do at a corner that opens
// differs from control to control and is a rule here. For the exact offset of a contour that is
// known as a whole, which no control computes, see contour_offset.h.
#pragma once

#include <cstddef>
#include <deque>
#include <numbers>
#include <optional>
#include <vector>

#include "path/contour.h"

namespace kadr::path {

/// What joins two elements at a corner around which the cutter goes.
enum class OutsideCorner : std::uint8_t {
    Arc,           // of the cutter's radius about the corner
    Intersection,  // both sides are extended until they meet
    Square,        // both sides are extended by the cutter's radius, and a line joins them
};

/// How the first or the last element is lengthened to meet another one, if it ends beside the
/// contour before it does: by the circle of the cutter's radius about the contour's end there, or
/// by its tangent. The cutter then comes to that other element, or leaves it, where they meet.
enum class OpenEnd : std::uint8_t { None, Arc, Line };

struct CompRules {
    OutsideCorner outside = OutsideCorner::Arc;
    /// How far the middle of such an arc is moved towards where both sides would meet, 0 … 1: an
    /// arc, a conic tangent to both sides, their intersection.
    double pointed = 0;
    /// Changes of direction beyond this angle, rad, are joined by `sharp` instead.
    double limit = std::numbers::pi;
    OutsideCorner sharp = OutsideCorner::Arc;
    /// Where an arc ends or begins at the corner, its tangent is extended; else there is always an
    /// arc about the corner.
    bool extends_tangents = false;
    /// Elements that are looked at before one is let go, 1 or more. From 2 on a side that runs into
    /// an earlier one is a fault.
    std::size_t look_ahead = 1;
    bool leaves_out = false;  // an element that the cutter cannot enter; needs a look-ahead of 2
    OpenEnd open_end = OpenEnd::None;
};

enum class CompFault : std::uint8_t {
    ArcTooSmall,     // the cutter does not fit into the arc
    NoIntersection,  // the sides of a corner that closes do not meet
    Reversed,        // an element beside this one would be travelled backwards
    Bottleneck,      // the cutter comes back to where it would cut into an earlier element
};

/// A piece of the cutter's path.
struct CompPiece {
    Element element;        // a full turn at most; a line without length if nothing is left of it
    std::size_t index = 0;  // of the contour's element that it runs beside
    bool is_inserted = false;  // at the corner before that element
    /// Above 0: between the ends of the element a conic, a rational Bézier curve of degree two with
    /// this weight of its middle control point, which is `apex`.
    double weight = 0;
    Vec2 apex = Vec2::Zero();
};
/// The point of a conic piece at a parameter 0 … 1.
Vec2 conic_at(const CompPiece& piece, double u);

class RadiusComp {
  public:
    explicit RadiusComp(const CompRules& rules) : rules_(rules) {}

    /// Rules for the corners from the next one on.
    void set_rules(const CompRules& rules) { rules_ = rules; }

    /// The next element of the contour; it begins where the last one ended.
    ///
    /// distance  of the cutter's centre, mm, positive to the left of travel. A line takes over a
    ///           new distance evenly along its length: the corner before it is that of the old
    ///           distance, the corner behind it that of the new one (F 4.3, S 5.2). An arc has
    ///           the new distance from its start on
    std::optional<CompFault> push(const Element& element, double distance, std::size_t index);
    /// The element that the last fault is about.
    std::size_t fault_at() const { return fault_at_; }
    /// The corner in front of the next element gets an arc about it whatever the rules are; at one
    /// that closes, where that would cut into the contour, it is a bottleneck.
    void round_next_corner() { rounds_next_ = true; }
    /// The next element is the first one; where it does not fit, the rules' open end counts.
    void begin_open() { starts_open_ = true; }
    /// No further element: the cutter ends on the normal at the end of the last one.
    std::optional<CompFault> finish();
    /// … and where the last element does not fit, by the rules' open end.
    std::optional<CompFault> finish_open();
    /// … or where the side meets the one beside a line from there in this direction, be it shorter
    /// or longer for that; on the normal where they do not meet.
    std::optional<CompFault> finish_towards(const Vec2& direction);

    /// Pieces that will not change any more, in the order of travel. The caller clears them.
    std::vector<CompPiece>& pieces() { return pieces_; }

    /// Where the cutter begins: on the normal at the start of the first element.
    static Vec2 start_of(const Element& element, double distance);

  private:
    /// An element beside the contour's, between the ends that its neighbours leave to it.
    struct OffsetElement {
        Element contour;
        Element path;               // from normal to normal, everywhere as far off as at its end
        double distance = 0;        // at its end
        Vec2 aside = Vec2::Zero();  // how much farther off it is at its start
        double from = 0;  // how much is taken away at its start and at its end, mm or rad, …
        double to = 0;    // … below zero where it is extended
        std::size_t index = 0;
        std::vector<CompPiece> before;  // inserted in front of it
        bool is_apart = false;          // it does not meet the one before it, anywhere
    };

    std::optional<CompFault> join(OffsetElement& a, OffsetElement& b);
    std::optional<CompFault> join_inside(OffsetElement& a, OffsetElement& b,
                                         const Vec2& corner) const;
    void join_outside(OffsetElement& a, OffsetElement& b, double turn, bool rounds) const;
    void join_by_conic(OffsetElement& a, OffsetElement& b, double turn) const;
    static void insert(OffsetElement& side, const Element& element);
    std::optional<CompFault> settle();
    bool leaves_out_reversed();
    bool runs_into_earlier(std::size_t done) const;
    static bool cuts_into(const OffsetElement& side, const OffsetElement& other);
    static Element path_of(const OffsetElement& side);
    static std::vector<Element> elements_of(const OffsetElement& side);
    void release(std::size_t kept);
    static bool fits(const OffsetElement& side);
    bool leave_earlier();
    bool begin_later(const OffsetElement& first);
    std::optional<CompFault> settle_start();

    CompRules rules_;
    std::deque<OffsetElement> sides_;
    std::size_t fault_at_ = 0;
    bool rounds_next_ = false;
    bool starts_open_ = false;               // the first of `sides_` may be left out
    std::optional<OffsetElement> left_out_;  // … and has been: the elements from there on
    std::size_t count_left_out_ = 0;         // do not reach the path to the contour
    std::vector<CompPiece> pieces_;
};

}  // namespace kadr::path
