// motion_words.h — what the words of a motion mean: where it leads, and which arc it is.
//
// They are read under a view of the state, which may be that of a block that is not executed yet.
// Nothing of the program's state is changed.
#pragma once

#include <optional>
#include <vector>

#include "base/done.h"
#include "control/frames.h"
#include "interp/axis_data.h"
#include "interp/block_actions.h"
#include "interp/reporter.h"
#include "interp/state.h"
#include "nc/block.h"
#include "nc/rules.h"
#include "nc/tables.h"
#include "path/arc.h"
#include "path/involute.h"

namespace kadr::interp {

struct MotionView {
    nc::Function motion;
    path::Plane plane;
    bool is_incremental;
    bool is_diameter_absolute;  // X is a diameter as a coordinate only
    bool is_transformed;        // the machine's axes are not those of the program
    const Position& position;
    const control::Frames& frames;
    const AxisData& axes;
    const path::VirtualAxes& virtual_axes;
    const nc::Rules& rules;
    const nc::DialectTables& tables;
    ProgrammedUnits units;

    /// The block's own motion and dimensions act.
    void take(const nc::Block& block);
};

class MotionWords {
  public:
    MotionWords(const MotionView& view, Reporter& reporter) : view_(view), reporter_(reporter) {}

    const MotionView& view() const { return view_; }
    Reporter& reporter() const { return reporter_; }

    // motion_words.cpp
    /// Where the words of the axes lead, in the programmed and in the base system; mm, deg.
    ///
    /// targets  the slots that count; they have to be given
    Target target_of(const nc::Block& block, nc::SlotMask targets) const;
    /// What the number of a word for X is multiplied with: 0.5 where it is a diameter.
    double x_scale(const nc::Block& block, bool is_distance) const;
    /// Whether a word is a distance: by itself, or as the dimensions have it.
    bool is_distance(const nc::Block& block, nc::Slot slot) const;
    /// Where the tool is, in the working plane of the programmed system.
    path::Vec2 position_in_plane() const;
    /// The point between, in the programmed system.
    path::Vec3 through_point(const nc::Block& block) const;
    /// Reports an axis that the machine has not.
    Done require_axes(const nc::Block& block, nc::SlotMask targets);
    /// Reports a position of a rotary axis, with its direction, that is not within one turn.
    Done require_rotary_approaches(const nc::Block& block);

    // arc_words.cpp: nothing if it was reported
    std::optional<path::Arc> resolve_arc(const nc::Block& block, const Target& target);
    std::optional<path::Arc> arc_by_opening(const nc::Block& block, Target& target);
    std::optional<path::Vec3> center_of_arc(const nc::Block& block, const path::Vec3& start);
    std::optional<int> turns_of(const nc::Block& block);
    void report_radius_arc(const nc::Block& block, path::ArcFault fault, const path::ArcEnds& ends);
    std::nullopt_t report_arc_words(const nc::Block& block, nc::SlotMask words);
    std::optional<path::InvoluteWords> involute_words(const nc::Block& block);
    Done take_involute_end(const nc::Block& block, const path::InvoluteWords& words,
                           Target& target);
    void report_involute(const nc::Block& block, path::InvoluteFault fault);

    // polar_words.cpp
    /// Coordinates instead of radius and angle; nothing if it was reported.
    std::optional<nc::Block> with_polar_slots(const nc::Block& block, Polar& polar);
    nc::Block at_polar(const nc::Block& block, const Polar& polar) const;
    void set_coordinate(nc::Block& block, Axis axis, double value) const;

    // polynomial_words.cpp
    struct Polynomials {
        Target target;
        std::vector<path::ControlPoint> control_points;  // homogeneous, in the programmed system
    };
    std::optional<Polynomials> polynomials_of(const nc::Block& block);

  private:
    void turn_rotary(const nc::Block& block, Target& target) const;
    double radius_of(const nc::Block& block, const path::ArcEnds& ends) const;
    void report_center_arc(const nc::Block& block, path::ArcFault fault, const path::ArcEnds& ends,
                           const path::Vec3& center);
    std::optional<Target> end_of_polynomials(const nc::Block& block);

    MotionView view_;
    Reporter& reporter_;
};

}  // namespace kadr::interp
