// prepare_state.h — what the preparer knows between two commands. Internal to motion.
//
// Its functions are in chapters: prepare.cpp (commands, standstill, pieces of one motion),
// prepare_corners.cpp (how fast the corner between two pieces may be passed), prepare_blending.cpp
// (curves around corners), prepare_transformed.cpp (motions under the machine's transformation),
// prepare_virtual.cpp (motions in polar, cylindrical and inclined-axis coordinates),
// prepare_dynamics.cpp (how fast motions may be as programmed),
// prepare_varying_feed.cpp (feeds that change along a motion).
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "base/done.h"
#include "base/reported_once.h"
#include "motion/axis_check.h"
#include "motion/compressor.h"
#include "motion/orientation_corner.h"
#include "motion/prepare.h"
#include "motion/spindle.h"
#include "motion/standing.h"
#include "motion/transformed.h"

namespace kadr::motion {

/// What a corner needs to know of the piece before it.
struct CornerMemory {
    AxisRates rates{};  // dq/ds at its end
    AxisRates bends{};  // d²q/ds² at its end
    AxisTable::Loads loads;
    path::Dynamics dynamics;
    bool is_plain = true;  // nothing is programmed there
    double length = 0;
    double speed = 0;                           // limit inside
    path::Vec3 direction = path::Vec3::Zero();  // at its end
    double acceleration = 0;
    double jerk = std::numeric_limits<double>::infinity();
    double turning_acceleration = std::numeric_limits<double>::infinity();  // see PathLimits
    bool is_rotary_only = false;
    bool is_bent = false;
    bool can_be_cut = true;  // into parts that are as exact as the whole
    bool must_stop = true;   // the path comes to rest behind it
    double entry_speed = 0;  // mm/s, at most so fast it is where it begins (jerk limited)
    double exit_feed = std::numeric_limits<double>::infinity();  // of a varying feed
    double feed_slope = 0;  // of it by distance, in parts of the feed, 1/mm
};

inline bool is_straight(const Segment& segment) {
    return !segment.is_transformed() && (std::holds_alternative<path::Line>(segment.curve) ||
                                         std::holds_alternative<path::Point>(segment.curve));
}

/// Lines and arcs: the parts of other curves are measured anew, each to within a tolerance.
inline bool can_be_cut(const Segment& segment) {
    return is_straight(segment) ||
           (!segment.is_transformed() && std::holds_alternative<path::Helix>(segment.curve));
}

/// A motion that waits for the next one, because the corner between them may be blended.
struct HeldMotion {
    bool is_held = false;
    path::Command command;
    Segment segment;    // the whole path
    double length = 0;  // of it
    double from = 0;    // so much of it the curve around the corner before it has taken
};

/// What is known of a piece when it is emitted.
struct Emission {
    bool as_cell = false;    // if it is even enough, and no corner is beside it
    bool is_inside = false;  // of a path that goes on evenly from the piece before
    /// So far it is from either end of that path: beside a corner the axes have less.
    double margin = std::numeric_limits<double>::infinity();
    bool follows_spindle = false;  // one of many parts, each with the feed of its radius
    bool is_by_law = false;        // the feed of the command is that of the piece already …
    const VaryingFeed* varying_feed = nullptr;  // … or this one
};

/// A ramp beside a rest has on a curve that bends freely what the axes leave at each speed
/// (long_ramp.h), which is more than the limits that are known before it is planned: of the time
/// that it is reckoned to lose, passing a corner may lose no more than so much.
inline constexpr double kDoubtOfBends = 0.8;
/// What takes less than this part of the time of a stop, by the halves of the motions beside it, is
/// quicker whatever the speeds at their other ends are.
inline constexpr double kSurelyQuicker = 0.9;

/// How a corner is passed: so fast, with this part of the acceleration and of the jerk left to the
/// ramps beside it. 0: at rest.
struct CornerPassage {
    double speed = 0;
    double ramp = 1;
    double jerk_share = 1;
};

/// What ramps have beside a corner, within a tick of it: a part of what they have all along, or
/// less there alone; or they end there without acceleration.
enum class RampEnd : std::uint8_t { Whole, Zone, Smooth };

/// How to share what the axes have between the jump at a corner and the ramps beside it.
struct CornerShare {
    double speed = 0;      // of the corner
    double ramp = 1;       // part of their acceleration along the path that the ramps keep at least
    bool is_alone = true;  // no other corner comes within two ticks
    RampEnd end = RampEnd::Whole;
};

/// Of something that both sides of a corner have.
struct SidesOfCorner {
    double before = 0;
    double behind = 0;
};

/// What a corner at which the orientation changes is without the path around it.
enum class CornerAsItIs : std::uint8_t {
    Stop,
    Passed,    // or a stop, by the rules of all corners
    OfTheTip,  // likewise, and the path around it keeps the corner of the tip
};

/// What becomes of a corner at which the orientation changes.
struct OrientationAtCorner {
    std::optional<OrientationBlend> around;  // nothing: it stays
    bool rests = false;                      // … and is a stop
};

/// What is beside a corner.
struct CornerNeighbour {
    const Segment& segment;
    double length = 0;  // of the whole motion
    PathLimits limits;
};

/// So much of the path of a motion whose feed changes along it has become pieces.
struct LawProgress {
    double done = 0;
    double length = 0;
};

/// Where a motion ends.
struct EndState {
    double length = 0;                       // of its path
    path::Vec3 joints = path::Vec3::Zero();  // under a transformation, rad
};

/// A part of a motion's path, between two lengths.
struct PathPart {
    double from = 0;
    double to = 0;
};

/// What a run reports once and not again.
enum class PlanNotice : std::uint8_t {
    NoFeed,  // of a motion; anew behind a change of the spindle
    ThreadCorner,
};

struct Preparer::State {
    State(Stream<path::Command>& commands_in, const machine::Machine& machine_in,
          const AxisTable& axes_in, const PlannerOptions& options_in, DiagnosticSink& sink_in,
          PieceRing& pieces_in);

    std::size_t next();
    void finish();
    Piece& fresh_piece();
    const path::Command* next_command();
    const path::Command* next_read();
    void execute(const path::Command& command);

    void set_other_spindle(const path::Command& command);
    void check_speed(const path::Command& command);
    void set_spindle(const path::Command& command);
    void dwell(const path::Command& command);
    void issue(const path::Command& command);
    void stand(const path::Command& command, SegmentKind kind, double duration);
    Piece& emit_stand(const path::Command& command, SegmentKind kind);

    void move(const path::Command& command);
    Done check_axes(const path::Command& command, const Segment& segment, double length);
    void emit_part(const path::Command& command, const Segment& whole, double length,
                   const PathPart& part);
    void emit_transformed(const path::Command& command, const Segment& whole,
                          AxesPosition::MotionEnd& target);
    void turn_at_pole(const path::Command& command, const Segment& at, const path::Vec3& to);
    void turn_alone(const path::Command& command, const Segment& at, Axis axis, double distance);
    std::optional<LogicalAxes> emit_path(const path::Command& command, const Segment& leg,
                                         double length);
    /// prepare_virtual.cpp
    void emit_virtual(const path::Command& command, const Segment& whole,
                      AxesPosition::MotionEnd& target);
    Done emit_leg(const path::Command& command, const Segment& leg, double length,
                  path::Vec3& joints);
    void emit_curves(const path::Command& command, const Segment& whole, double length,
                     std::span<const path::Curve> curves);
    void end_command();
    void emit_feed_parts(const path::Command& command, const Segment& segment, double length);
    void emit_parts(const path::Command& command, const Segment& whole,
                    const std::vector<double>& bounds);
    /// prepare_threads.cpp
    void meet_spindle(const path::Command& command);
    void check_thread_corner(const path::Command& command, const Piece& piece);
    void emit_varying_thread(const path::Command& command, const Segment& whole, double length);
    bool allows_cells(const path::Command& command) const;
    std::vector<double> cells_in(const path::Command& command, const Segment& whole, double length);
    void emit_cells(const path::Command& command, const Segment& whole,
                    const std::vector<double>& bounds);
    void emit(const path::Command& command, const Segment& segment, double length,
              const Emission& how = {});
    void report_thread_speed(const path::Command& command, double feed, double most);
    double programmed_feed(const path::Command& command, const Segment& segment, double length);
    double wanted_feed(const path::Command& command, const Segment& segment,
                       double programmed) const;
    void ask(const path::Command& command, Piece& piece) const;
    double corner_speed(const Segment& segment, const AxisRates& in, double acceleration) const;
    void take_corner(Piece& piece) const;
    CornerShare quickest_share(const Piece& piece) const;
    bool allows_zones(const Piece& piece) const;
    double corner_zone(const Piece& piece, double speed, double ramp) const;
    bool ends_smoothly(const Piece& piece) const;
    bool burns_where_it_turns_back(const Piece& piece) const;
    bool has_own_ramps(const Piece& piece, double speed) const;
    bool is_doubtful(const Piece& piece) const;
    bool is_alone(const Piece& piece) const;
    double time_beside(const Piece& piece, const CornerShare& share) const;
    double time_between_rests(const Piece& piece, const CornerShare& share) const;
    SidesOfCorner sides_of(const Piece& piece, const CornerShare& share) const;
    SidesOfCorner loads_beside(const Piece& piece, std::size_t axis, double speed,
                               const SidesOfCorner& along) const;
    double shared_speed(const Piece& piece, const CornerShare& share) const;
    double shared_speed_at(const Piece& piece, const CornerShare& share, const SidesOfCorner& along,
                           double at) const;
    double ramp_beside(const Piece& piece, const CornerShare& share) const;
    double crowded_jump(const Piece& piece, std::size_t axis, double speed) const;
    double corner_acceleration_limit(const AxisRates& in) const;
    void take_bend(Piece& piece) const;
    bool rests_at_bend(const Piece& piece, double passed, double share) const;
    double reached_before(const Piece& piece) const;
    void remember(const Piece& piece);
    /// prepare_dynamics.cpp
    void follow_dynamics(const path::Command& command);
    void set_jumps();
    double acceleration_at_corner(std::size_t axis) const;
    double jerk_at_corner(std::size_t axis) const;
    double most_at_corner(std::size_t axis) const;
    double jerk_of_bend(std::size_t axis) const;
    double programmed_override(const path::Command& command) const;
    double feed_override(const path::Command& command) const;
    Done require_override(const path::Command& command);
    /// prepare_varying_feed.cpp
    void begin_law(double from, double length);
    bool has_law(const path::Command& command) const;
    std::optional<path::FeedPolynomial> law_on(const path::Command& command, const Segment& segment,
                                               double length) const;
    void emit_by_law(const path::Command& command, const Segment& segment, double length,
                     const Emission& how);
    void emit_law_part(path::Command& share, const Segment& segment,
                       const path::FeedPolynomial& feed, const PathPart& part, const Emission& how);
    std::optional<VaryingFeed> varying_feed_on(const PathLimits& limits,
                                               const path::FeedPolynomial& feed,
                                               double length) const;
    void take_varying_feed(Piece& piece, const AxisRates& in) const;

    std::optional<double> feed_of(const path::Command& command, const Segment& segment,
                                  double length) const;
    void rest_at_points(const path::Command& command);
    bool has_pulses() const { return machine.laser && machine.laser->pulse > 0; }
    bool can_be_blended(const path::Command& command, const Segment& segment,
                        const EndState& arrival) const;
    bool hold(const path::Command& command, const Segment& segment, const EndState& arrival,
              double from);
    void release();
    void keep_sharp();
    double round_corner(const path::Command& command, const Segment& segment,
                        const EndState& arrival);
    double blend_orientation_corner(const path::Command& command, const Segment& segment,
                                    double length);
    double time_along(std::span<const Segment> ways, const path::Command& command) const;
    bool gains_time(const OrientationBlend& around, const path::Command& command,
                    const OrientationPath& before, const OrientationPath& behind,
                    CornerAsItIs as_it_is);
    OrientationAtCorner blended_orientation(const path::Command& command,
                                            const OrientationPath& before,
                                            const OrientationPath& behind);
    std::optional<OrientationBlend> smoothed_path(const path::Command& command,
                                                  const OrientationPath& before,
                                                  const OrientationPath& behind);
    void emit_rest(const path::Command& command, const Segment& whole, double length, double from);
    bool is_one_way(const Segment& whole, const path::Vec3& to) const;  // prepare_transformed.cpp
    PathLimits limits_on(const path::Command& command, const Segment& segment, double length) const;
    double least_speed(std::span<const path::Curve> curves, const Segment& whole,
                       double most) const;
    CornerPassage corner_between(const CornerNeighbour& before, const CornerNeighbour& behind);

    void alarm_raised();

    Stream<path::Command>& commands;
    const machine::Machine& machine;
    const AxisTable& machine_axes;
    AxisTable axes;           // under what is programmed for the command
    path::Dynamics dynamics;  // which is this
    bool is_plain = true;     // nothing is programmed there
    const PlannerOptions& options;
    DiagnosticSink& sink;
    double tick = 0;   // s, of the machine
    AxisRates jump{};  // by how much an axis may change its velocity at a corner

    std::vector<path::Command> batch = std::vector<path::Command>(kBatch);
    std::size_t batch_size = 0;
    std::size_t batch_at = 0;
    std::uint64_t commands_read = 0;
    bool is_drained = false;  // no command is left to read
    bool has_ended = false;
    bool has_alarmed = false;
    ReportedOnce<PlanNotice> reported;
    bool is_threading = false;    // the latest motion is a thread …
    bool thread_goes_on = false;  // … that goes on with the one before it
    bool leaves_thread = false;   // the latest motion is none, and the one before it was
    bool burns_point = false;     // the latest motion ends with a pulse of the laser
    bool stays_sharp = false;     // the next corner: a curve around it would take longer

    AxesPosition standing;
    CommandedSpindle spindle;
    std::int64_t tool_number = 0;  // called last
    AxisCheck check;
    CornerMemory last;
    HeldMotion held;
    LawProgress lawful;
    Compressor compressor;

    std::deque<IssuedFunction> issued;  // not taken yet by the planner
    std::size_t to_issue = 0;           // so many of them wait for a piece

    PieceRing& pieces;
    std::size_t ready = 0;  // pieces of the current command
};

}  // namespace kadr::motion
