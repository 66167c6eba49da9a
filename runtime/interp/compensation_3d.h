// compensation_3d.h — 3D compensation: commands of the point where the cutter touches in, commands
// of its tip out, a block later (S 5.3, motion.md §8.2, §8.3).
//
// Its flank touches a contour, or its end a surface whose normals the commands bring along. The
// tool may turn while it goes along and at corners, and so may a surface. Where they do, the tip's
// path is no line and no arc: the command tells where the cutter touches (path/contact.h), and
// motion finds the tip at every tick. Without a transformation that holds it there the path is
// given as splines. What is different on surfaces is in compensation_3d_faces.cpp.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "interp/compensated_orientation.h"
#include "interp/compensation.h"
#include "nc/block.h"
#include "path/command.h"
#include "path/curve.h"
#include "path/orient_law.h"

namespace kadr::interp {

/// The cutter as it touches.
struct Cutter3d {
    path::Contact contact;  // peripheral milling, positive to the right of the contour, or face
                            // milling; of what is touched it knows nothing
    double flank = 0;       // of face milling: between the flank and its axis, rad

    bool is_face_milling() const { return contact.kind == path::ContactKind::Face; }
};

struct Comp3dSettings {
    Cutter3d cutter;
    OrientationLimits orientation_limits;        // without a chain the tool keeps its direction
    path::Vec3 direction = path::Vec3::UnitZ();  // of the tool where the compensation begins
    bool extends_lines = false;  // at a corner around which the cutter goes, until they meet …
    double limit = 0;            // … up to this change of direction, rad; else an arc about it
    bool orients_on_arc = true;  // blocks that only orient the tool do it on the arc
    bool takes_inverse_time = false;
    int empty_blocks = 3;  // without travel that may stand in a row
};

class Compensation3d {
  public:
    bool is_on() const { return state_ != State::Off; }

    /// Compensation begins with the next line. `here` is where the tip is.
    void begin(const Comp3dSettings& settings, const AxisValues& here);
    /// From the next block on.
    void set_settings(const Comp3dSettings& settings) { settings_ = settings; }
    /// The next line leaves the contour.
    void leave();

    /// Where the executor puts a command while compensation is on.
    path::Command& next() { return fresh_.emplace_back(); }
    std::optional<CompAlarm> end_block(const nc::Block& block);
    /// What waits goes out: the contour ends here, square to it.
    std::optional<CompAlarm> flush();
    /// … and the compensation is over.
    std::optional<CompAlarm> stop();
    /// Where the tip is, when nothing waits any more.
    const AxisValues& position() const { return shown_; }
    std::vector<path::Command>& settled() { return settled_; }
    template <typename See>
    void look_at_waiting(See see) const {
        if (approach_) see(*approach_);
        if (last_) see(last_->command);
        for (const path::Command& command : waiting_) see(command);
        for (const path::Command& command : fresh_) see(command);
    }

  private:
    enum class State : std::uint8_t { Off, Starting, On, Leaving };
    using Fault = const DiagnosticRow*;  // null: none

    /// A motion along the contour, as it is programmed. Corners cut its path; the tool and the
    /// other axes do all of their part on what is left of it.
    struct TouchedMotion {
        path::Command command;
        path::Curve curve;
        path::Vec3 from_tool;  // directions at its ends
        path::Vec3 to_tool;
        AxisValues from{};      // where the contour and the rotary axes begin
        path::Contact contact;  // of face milling with its normals
        double begin = 0;       // shares of the path: what its corners leave
        double end = 1;

        double length() const { return path::length(curve); }
        double part() const { return end - begin; }
        /// Of what is left, the share at which the whole has this one …
        double share_of_part(double share) const { return (share - begin) / part(); }
        /// … and back.
        double share_of_path(double share) const { return begin + share * part(); }
        path::CurvePoint at(double share) const;
        bool is_line() const { return std::holds_alternative<path::Line>(curve); }
        bool turns() const {
            return command.motion().orient_kind > path::OrientKind::Cone ||
                   (to_tool - from_tool).norm() > 1e-12;
        }
    };
    struct Corner;  // between two of them

    /// Directions in the base system at which sides meet, seen square to both.
    struct View {
        path::Vec3 across;
        path::Vec3 along;
    };

    Fault take(path::Command& command);
    Fault take_motion(path::Command& command);
    Fault follow(path::Command& command, path::Curve curve);
    Fault check(TouchedMotion& side) const;
    Fault check_side(const TouchedMotion& side) const;
    Fault enter(const TouchedMotion& first);
    Fault join(TouchedMotion& next);
    Fault join_inside(TouchedMotion& next, const Corner& corner);
    void join_outside(TouchedMotion& next, const Corner& corner);
    Fault meet(TouchedMotion& a, TouchedMotion& b, const View& view) const;
    Fault finish();
    void extend(TouchedMotion& next, const Corner& corner);

    // compensation_3d_faces.cpp
    using TipPath = std::function<path::Vec3(double share)>;
    Fault take_surface(const path::Contact& surface, TouchedMotion& side) const;
    Fault check_inclinations(TouchedMotion& side) const;
    Fault check_bends(const TouchedMotion& side) const;
    double inclination_on(const TouchedMotion& side, double share) const;
    double least_inclination(const TouchedMotion& side, double from, double to) const;
    Fault join_surfaces(TouchedMotion& next);
    Fault join_hollow(TouchedMotion& next, const Corner& corner);
    void roll(const TouchedMotion& next, const path::Vec3& from, const path::Vec3& at);
    void roll_part(const path::Contact& contact, const TouchedMotion& next, const path::Vec3& at);
    void emit_splines(const path::Command& model, const AxisValues& from, const TipPath& tip);

    path::Vec3 tool_behind(const path::Motion& motion) const;
    bool changes_orientation(const path::Command& command) const;
    static bool keeps_kind(const TouchedMotion& side);
    static path::OrientLaw orient_law_on(const TouchedMotion& side);
    static void cut_turn(const TouchedMotion& side, path::Motion& motion);
    path::Vec3 tool_along(const path::Motion& motion, const AxisValues& from,
                          const path::Vec3& from_tool, const path::Curve& curve,
                          double share) const;
    path::Vec3 tool_on(const TouchedMotion& side, double share) const;
    path::Vec3 guide_on(const TouchedMotion& side, double share) const;
    std::optional<path::Vec3> aside_on(const TouchedMotion& side, double share) const;
    std::optional<path::Vec3> tip_on(const TouchedMotion& side, double share) const;
    AxisValues axes_on(const TouchedMotion& side, double share) const;
    path::Contact standing(const path::Vec3& guide) const;

    void emit(TouchedMotion& side);
    void emit_waiting(path::Contact contact, const path::Vec3& at);
    void emit_turn(path::Command command, path::Contact contact, const path::Vec3& at);
    void emit_arc(const path::Command& model, const path::Vec3& at, const path::Vec3& from,
                  const path::Vec3& to, double turn);
    void emit_line_to(const path::Command& model, const AxisValues& to, const path::Vec3& tool);
    void put_path(path::Command command, const path::Vec3& from, const path::Vec3& to);
    void put(path::Command command);
    CompAlarm alarm(Fault fault, const path::Command& command) const;

    State state_ = State::Off;
    Comp3dSettings settings_;
    bool cannot_orient_ = false;
    AxisValues here_{};  // programmed, behind what was taken …
    path::Vec3 tool_ = path::Vec3::UnitZ();
    AxisValues shown_{};  // … and where the tip is behind what was let go
    path::Vec3 shown_tool_ = path::Vec3::UnitZ();
    std::optional<path::Command> approach_;          // it ends where the first element has it …
    path::Vec3 approach_from_ = path::Vec3::Zero();  // … and begins here, as programmed
    std::optional<TouchedMotion> last_;
    std::vector<path::Command> waiting_;  // behind the approach or the last element: no travel
    int empty_blocks_ = 0;
    std::vector<path::Command> fresh_;
    std::vector<path::Command> settled_;
};

}  // namespace kadr::interp
