// compensation.h — cutter radius compensation: commands of the programmed contour in, commands of
// the cutter's centre out, a block or more later.
//
// What a corner becomes is path/radius_comp.h, the path to the contour compensation_paths.h.
// Elements wait in compensated_contour.h, what is settled of them goes out by cutter_path.h. Here
// is the order of things in a program: how the cutter comes to the contour and leaves it, blocks
// without motion in the plane, pauses.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "interp/compensated_contour.h"
#include "interp/compensated_orientation.h"
#include "interp/compensation_plane.h"
#include "interp/cutter_path.h"
#include "nc/block.h"
#include "nc/rules.h"
#include "path/command.h"
#include "path/frame.h"
#include "path/radius_comp.h"

namespace kadr::interp {

struct CompSettings {
    path::CompRules corners;
    nc::CompStart start = nc::CompStart::Normal;
    nc::CompFeed feed = nc::CompFeed::Contour;
    bool radius_changes_in_lines =
        false;                        // an arc under another radius is a fault; else its side steps
    bool takes_inverse_time = false;  // F of the block as it is programmed
    int empty_blocks = 3;             // without motion in the plane that may stand in a row
    bool more_empty_is_fault = true;  // else the cutter goes to the normal before them
    OrientationLimits orientation_limits;  // of a transformation
    /// Turns the working plane, where it is one of two axes, to where it lies in the base system;
    /// taken over where the compensation begins.
    path::Mat3 lie = path::Mat3::Identity();
};

/// What was wrong, and where: the command of the block.
struct CompAlarm {
    const DiagnosticRow* row = nullptr;
    SourceId source;
    std::uint32_t line = 0;
};

class Compensation {
  public:
    bool is_on() const { return state_ != State::Off; }

    /// Compensation begins with the next motion in the plane. `here` is where the tool is.
    ///
    /// distance  radius of the cutter and allowance, mm, positive left of the contour
    void begin(const CompSettings& settings, path::Plane plane, double distance,
               const AxisValues& here);
    /// From the next motion on; a line takes it over along its path.
    void set_distance(double distance) { distance_ = distance; }
    /// Of a lathe's tool: from the centre of its nose to the tip, which is what is programmed, in
    /// the plane, mm. The contour is led so far aside that beside it the tip goes, and not the
    /// centre.
    void set_aside(const path::Vec2& aside);
    void set_settings(const CompSettings& settings);
    double distance() const { return distance_; }
    /// The next motion in the plane leaves the contour; if a direction is given, from where the
    /// contour would meet the path beside a line into it.
    ///
    /// open_end  what becomes of a last element that the cutter does not fit into
    void leave(const std::optional<path::Vec2>& direction = std::nullopt,
               path::OpenEnd open_end = path::OpenEnd::None);
    /// Compensation is over at once: what waits is let go of, and the cutter stays where it is.
    std::optional<CompAlarm> stop();
    /// Where the cutter is, when nothing waits any more.
    AxisValues position() const { return in_plane().out_of(cutter_.position()); }
    path::Plane plane() const { return in_plane().plane(); }
    const path::Mat3& lie() const { return in_plane().lie(); }

    /// The motions of the block that follows leave the cutter as far beside the contour as it is.
    void keep_vector() { keeps_vector_ = true; }
    /// The contour so far ends on its normal; from there on the tool goes as far beside what is
    /// programmed as it is then, until `resume`. Nothing happens before the contour has begun.
    std::optional<CompAlarm> pause();
    /// Before the next motion in the plane a line leads to the normal at its start.
    void resume();
    /// The line so far ends where it is programmed; the next one leads from there straight to the
    /// corner at its end, where the cutter is beside the contour again. Nothing happens before the
    /// contour has begun.
    std::optional<CompAlarm> let_go();
    /// The contour so far ends on its normal; the next line leads from there to its corner. Nothing
    /// happens before the contour has begun.
    std::optional<CompAlarm> begin_again();
    /// The cutter goes on an arc about the corner at which it is: to the normal of the next motion,
    /// or of a direction. `motion` gives feed and source of the arc.
    std::optional<CompAlarm> round_corner(const path::Command& motion,
                                          const std::optional<path::Vec2>& direction);
    /// The path to the contour, whose first element comes next; it may be no path at all.
    void begin_smooth_approach(path::Command motion);

    /// Where the executor puts a command while compensation is on.
    path::Command& next() { return fresh_.emplace_back(); }
    /// Takes what a block has put. `here` is where the tool is behind it, not compensated; `block`
    /// gives the source for a block that has put nothing.
    std::optional<CompAlarm> end_block(const AxisValues& here, const nc::Block& block);
    /// What the program's end, or a motion in machine coordinates, lets go of.
    std::optional<CompAlarm> flush();
    /// Commands that are settled, in order. The caller clears them.
    std::vector<path::Command>& settled() { return cutter_.settled(); }
    /// Calls `see` for every command that waits, in order: about where the cutter will go, as far
    /// from what is programmed as it is now.
    template <typename See>
    void look_at_waiting(See see) const {
        const auto see_beside = [&](const path::Command& command) {
            see(in_plane().out_of(cutter_.as_far_beside(command)));
        };
        contour_.look_at_waiting(see_beside);
        for (const path::Command& command : fresh_) see_beside(in_plane().into(command));
    }

  private:
    enum class State : std::uint8_t { Off, Starting, On, Leaving };
    /// A path to the contour that waits for the first element.
    struct Approach {
        double distance = 0;       // so far beside its start it goes, mm
        bool is_straight = false;  // whatever the settings are
    };
    using Fault = const DiagnosticRow*;  // null: none

    Fault take(path::Command& command, const AxisValues& behind);
    Fault take_in_machine_coordinates(path::Command& command, const AxisValues& behind);
    Fault take_motion(path::Command& command);
    Fault approach(path::Command& command);
    void begin_approach(path::Command& command, bool is_straight);
    Fault follow(path::Command& command);
    Fault depart(path::Command& command);
    Fault depart_from_end(path::Command& command);
    Fault end_approach(const path::Element& first, double distance);
    void lead_approach(const path::Element& first, double distance, bool is_curved);
    Fault push(const path::Element& element, CutterMotion motion);
    Fault follow_kept(path::Command& command);
    Fault follow_paused(path::Command& command);
    void come_back(const path::Command& command, const path::Element& element);
    Fault finish(const std::optional<path::Vec2>& direction = std::nullopt, bool is_open = false);
    bool is_on_contour() const { return state_ == State::On || state_ == State::Leaving; }
    bool moves_on(const path::Motion& motion) const;
    void feed_along(path::Motion& motion) const;
    path::Element element_of(const path::Motion& motion) const;
    const CompPlane& in_plane() const { return cutter_.plane(); }
    CompAlarm alarm(Fault fault, const path::Command& command) const;

    State state_ = State::Off;
    CompSettings settings_;
    double distance_ = 0;
    path::Vec2 aside_ = path::Vec2::Zero();
    AxisValues here_{};  // programmed, in the system of the plane
    CompensatedContour contour_;
    CutterPath cutter_;
    std::optional<Approach> approach_;
    bool keeps_vector_ = false;
    bool is_paused_ = false;
    bool comes_back_ = false;  // behind a pause: by a line to the contour
    bool is_let_go_ = false;   // the next element is a line from where the cutter is
    std::optional<path::Vec2> leave_direction_;
    int empty_blocks_ = 0;
    std::vector<path::Command> fresh_;
};

}  // namespace kadr::interp
