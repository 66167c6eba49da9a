#include "motion/path_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include "machine/kinematics.h"
#include "motion/axis_table.h"
#include "motion/plain_motion.h"
#include "motion/programmed_path.h"
#include "motion/standing.h"
#include "motion/transformed.h"
#include "path/cubic.h"
#include "path/steady.h"

namespace kadr::motion {

namespace {

using path::Command;
using path::Vec3;

/// So exact are points without a tolerance, mm: rounding of long distances through the kinematics,
/// far below an increment.
constexpr double kExact = 1e-6;
/// Behind the end of a transformation the tip is where the axes are, which the planner knows by
/// following the tool and the program by solving for it: rounding of angles, at the length of an
/// arm. Mm.
constexpr double kExactBehindTurn = 1e-4;
/// … and the direction of a tool, rad. At a pole it is known less well.
constexpr double kExactDirection = 1e-5;
/// Motions with a greater tolerance may be beside each other within it, as a path that goes forth
/// and back: which end was passed is then not known, mm.
constexpr double kSureEnd = 1e-3;
/// More motions do not wait while the tip stands within the tolerance of the end of one.
constexpr std::size_t kMostWaiting = 1 << 14;
/// The tip counts as on the end of a motion while it is within its tolerance, although it may have
/// gone on; so many tolerances of distance, at most, are made up for at once.
constexpr double kBehind = 8;
/// A path may be so much longer than the distance that the tip goes within the tolerance of it.
constexpr double kLonger = 2;

bool keeps(const ProgrammedMotion& motion, const Nearness& near) {
    return near.distance <= motion.tolerance && near.inclination <= near.direction_tolerance &&
           near.off <= near.off_allowed;
}

/// How far the curve around a corner may be from the path.
double room_of(const path::Blending& blending) {
    return blending.kind == path::BlendKind::None ? 0 : blending.size;
}
double direction_error_of(const path::Blending& blending) {
    const bool is_inclined = blending.kind != path::BlendKind::None || blending.smooths_orientation;
    return is_inclined ? blending.orientation : 0;
}

/// A motion that waits for its setpoints, and the command that it is of.
struct PendingMotion {
    SourceId source;
    std::uint32_t line = 0;
    std::uint32_t system = 0;
    double length = 0;  // mm; without `motion` never too small
    double tolerance = 0;
    double inclination = 0;
    double pole = 0;
    bool is_plain = false;
    PlainMotion plain;                         // if it is
    std::unique_ptr<ProgrammedMotion> motion;  // else, or once it is asked for
};

/// Lays the commands as motions, as they are programmed.
class Layer {
  public:
    explicit Layer(const machine::Machine& machine)
        : machine_(machine), standing_(machine), axes_(machine) {
        // X, Y and Z stand in front in every machine that has them all; others take the long path.
        is_plain_ = machine.axes.size() >= 3;
        for (std::size_t i = 0; is_plain_ && i < 3; ++i)
            is_plain_ = index(machine.axes[i].axis) == i;
        if (is_plain_) followers_ = machine.axes.size() - 3;
        if (!machine.kinematics) return;
        const machine::Kinematics& kinematics = *machine.kinematics;
        // A path near a pole is led through it; one beside a gap that the axes cannot reach, beside
        // it by half as much again.
        pole_ = kinematics.pole_tolerance;
        if (kinematics.chain.orients())
            pole_ = std::max(pole_, 1.5 * machine::pole_angle_reach(kinematics.chain).lower);
    }

    /// False: it moves nothing.
    bool lay(const Command& command, PendingMotion& out) {
        if (command.op() == path::Op::ToolLength) {
            standing_.set_tool_length(command.tool_length(), axes_);
            ++system_;
        }
        if (!command.is_motion()) return false;
        const path::Motion& motion = command.motion();
        if (standing_.follow_transformation(motion)) {
            ++system_;
            was_turned_ |= motion.orient_kind != path::OrientKind::None;
        }
        const AxesPosition::MotionEnd target = standing_.target_of(motion);
        out.source = command.source;
        out.line = command.line;
        lay_path(motion, target, out);
        standing_.arrive(motion, target);
        const path::Blending behind = motion.exact_stop ? path::Blending{} : motion.blending;
        set_tolerance(motion, behind, out);
        before_ = behind;
        return out.length > 0;
    }

    /// What a closer look needs of a plain motion.
    void complete(PendingMotion& waiting) const {
        if (waiting.motion) return;
        waiting.motion = std::make_unique<ProgrammedMotion>();
        ProgrammedMotion& motion = *waiting.motion;
        motion.segment.curve = curve_of(waiting.plain);
        motion.segment.carrier = waiting.plain.carrier;
        for (std::size_t i = 0; i < followers_; ++i)
            motion.segment.follower_start[index(machine_.axes[i + 3].axis) - 3] =
                waiting.plain.standing[i];
        waiting.length = path::length(motion.segment.curve);
        motion.length = waiting.length;
        motion.system = waiting.system;
        motion.tolerance = waiting.tolerance;
        motion.inclination = waiting.inclination;
        motion.pole = waiting.pole;
    }

    /// Axes of the machine behind X, Y and Z; 0 where these do not stand in front.
    std::size_t followers() const { return followers_; }

  private:
    void lay_path(const path::Motion& motion, const AxesPosition::MotionEnd& target,
                  PendingMotion& out) const {
        lay_plain(motion, target, out);
        if (!out.is_plain) {
            out.motion = std::make_unique<ProgrammedMotion>();
            Segment& segment = out.motion->segment;
            segment = standing_.still();
            out.length = standing_.lay_path(motion, target, segment);
            find_turns(*out.motion);
            // From point to point the tip is given as without a transformation.
            out.system = 2 * system_ + (segment.goes_straight() ? 1 : 0);
            return;
        }
        out.system = 2 * system_;
        out.length = out.plain.length;
        out.plain.carrier = standing_.held();
        for (std::size_t i = 0; i < followers_; ++i)
            out.plain.standing[i] = standing_.followers()[index(machine_.axes[i + 3].axis) - 3];
    }

    /// A line, or a span that goes on towards its end, on which nothing else moves. A line without
    /// length is one as well.
    void lay_plain(const path::Motion& motion, const AxesPosition::MotionEnd& target,
                   PendingMotion& out) const {
        const bool is_line = motion.op() == path::Op::Line || motion.op() == path::Op::Rapid;
        const bool may_be = is_plain_ && (is_line || motion.op() == path::Op::Spline) &&
                            motion.orient_kind == path::OrientKind::None &&
                            !motion.virtual_axes().is_on() &&
                            target.followers == standing_.followers();
        if (!may_be) return;
        const Vec3& from = standing_.tip();
        const bool goes = (target.tip - from).norm() > kStill;
        if (is_line) {
            out.is_plain = true;
            if (goes) out.plain = plain_motion_of(path::make_line(from, target.tip));
            return;
        }
        if (!goes) return;
        if (const auto steady = path::steady_span(from, target.tip, motion.spline())) {
            out.is_plain = true;
            out.plain = plain_motion_of(*steady);
        }
    }

    /// Of curves around both of its corners, and of one that takes the place of lines.
    void set_tolerance(const path::Motion& motion, const path::Blending& behind,
                       PendingMotion& out) const {
        const double room = std::max(room_of(before_), room_of(behind));
        const bool is_distance =
            behind.kind == path::BlendKind::Distance || before_.kind == path::BlendKind::Distance;
        const double curved =
            is_distance ? room + motion.compress : std::max(room, motion.compress);
        out.tolerance = curved + (was_turned_ ? kExactBehindTurn : kExact);
        out.inclination = kExactDirection + pole_ +
                          std::max(direction_error_of(before_), direction_error_of(behind));
        out.pole = pole_;
        if (!out.motion) return;
        out.motion->length = out.length;
        out.motion->system = out.system;
        out.motion->tolerance = out.tolerance;
        out.motion->inclination = out.inclination;
        out.motion->pole = out.pole;
    }

    const machine::Machine& machine_;
    bool is_plain_ = false;
    std::size_t followers_ = 0;
    AxesPosition standing_;
    AxisTable axes_;
    path::Blending before_;
    double pole_ = 0;
    bool was_turned_ = false;
    std::uint32_t system_ = 0;
};

}  // namespace

struct PathCheck::State {
    State(const machine::Machine& machine_in, double tick_in)
        : machine(machine_in), tick(tick_in > 0 ? tick_in : machine_in.tick), layer(machine_in) {
        if (machine.kinematics) chain = &machine.kinematics->chain;
        double square = 0;
        for (const machine::MachineAxis& axis : machine.axes)
            if (!axis.is_rotary) square += axis.acceleration * axis.acceleration;
        in_a_tick = std::sqrt(square) * tick * tick;
    }

    struct Found {
        std::size_t at;
        Nearness near;
    };
    struct Nearest {
        const PendingMotion* motion = nullptr;
        Nearness near;
    };

    Done follow(const Setpoint& setpoint);
    bool follow_plain();
    bool is_next(std::size_t at, const Vec3& tip, double come) const;
    const ProgrammedMotion& motion_at(std::size_t i);
    Done go_on();
    Done search();
    std::optional<Found> find(bool is_thorough, Nearest& nearest);
    std::optional<PathDeviation> left_out_before(std::size_t at);
    void take();
    const StandingTool& tool_for(const ProgrammedMotion& motion);
    double reach() const;
    void stay(double at, const Vec3& tip_now);
    void leave(std::size_t at, double there);
    PathDeviation deviation_of(DeviationKind fault, const PendingMotion& waiting, double distance,
                               double allowed) const;
    void fail_near(const PendingMotion& waiting, const Nearness& near);

    const machine::Machine& machine;
    const machine::Chain* chain = &kNoChain;
    double tick;
    double in_a_tick = 0;  // mm, what the axes may do from rest to rest between two setpoints

    // Of whoever reads the commands.
    std::mutex mutex;
    Layer layer;
    std::vector<PendingMotion> laid;

    std::vector<PendingMotion> taken;   // from `laid`, to be given back empty
    std::deque<PendingMotion> motions;  // the first one is where the tip is
    double parameter = 0;               // the farthest there so far
    double aside = 0;                   // mm, that the tip has gone since without coming farther
    bool has_begun = false;
    const Setpoint* setpoint = nullptr;
    StandingTool tool;              // of the setpoint …
    std::uint32_t tool_system = 0;  // … in this system
    bool is_tool_known = false;
    Vec3 before = Vec3::Zero();  // the tip of the setpoint before …
    std::uint32_t system_before = 0;
    double feed_before = 0;
    double time = 0;
    std::optional<PathDeviation> deviation;
};

/// What has been read since.
void PathCheck::State::take() {
    {
        const std::lock_guard lock(mutex);
        taken.swap(laid);
    }
    for (PendingMotion& motion : taken) motions.push_back(std::move(motion));
    taken.clear();
}

const StandingTool& PathCheck::State::tool_for(const ProgrammedMotion& motion) {
    if (!is_tool_known || tool_system != motion.system) {
        tool = standing_tool(machine, *chain, motion, *setpoint);
        tool_system = motion.system;
        is_tool_known = true;
    }
    return tool;
}

/// How far the tip may have come since the setpoint before, mm. From point to point, and where it
/// is beside the path that has the feed, it may be faster than that.
double PathCheck::State::reach() const {
    const double moved = tool_system == system_before ? (tool.tip - before).norm() : 0;
    return std::max(moved, std::max(setpoint->feed, feed_before) * tick) + in_a_tick;
}

/// The tip is on the first motion still. One that goes forth and back within the tolerance of it is
/// on its path along the next ones, and nobody can see on which.
void PathCheck::State::stay(double at, const Vec3& tip_now) {
    if (at <= parameter && has_begun) aside += (tip_now - before).norm();
    parameter = std::max(parameter, at);
}

/// The tip goes on to a later motion; the next one is the first then.
void PathCheck::State::leave(std::size_t at, double there) {
    if (aside > 0) {
        double gone = there;
        for (std::size_t k = 1; k < at; ++k) gone += motion_at(k).length;
        aside = std::max(0.0, aside - gone);
    }
    motions.erase(motions.begin(), motions.begin() + static_cast<std::ptrdiff_t>(at));
    parameter = there;
}

PathDeviation PathCheck::State::deviation_of(DeviationKind fault, const PendingMotion& waiting,
                                             double distance, double allowed) const {
    return {fault, distance, allowed, time, {waiting.line, waiting.source, {}}};
}

void PathCheck::State::fail_near(const PendingMotion& waiting, const Nearness& near) {
    if (near.distance > waiting.tolerance)
        deviation = deviation_of(DeviationKind::Tip, waiting, near.distance, waiting.tolerance);
    else if (near.inclination > near.direction_tolerance)
        deviation =
            deviation_of(DeviationKind::Tool, waiting, near.inclination, near.direction_tolerance);
    else deviation = deviation_of(DeviationKind::Followers, waiting, near.off, near.off_allowed);
}

Done PathCheck::State::follow(const Setpoint& next) {
    setpoint = &next;
    time = next.time;
    is_tool_known = false;
    if (motions.empty()) return kDone;  // nothing has moved yet
    if (follow_plain()) return kDone;
    if (!go_on()) return kFailed;
    const ProgrammedMotion& here = motion_at(0);
    before = tool_for(here).tip;
    system_before = here.system;
    feed_before = next.feed;
    has_begun = true;
    return kDone;
}

/// On the motion on which the tip was, or one of the next, as far as these are plain; false: that
/// is not known.
bool PathCheck::State::follow_plain() {
    using LookResult = PlainLook::LookResult;
    if (motions.size() >= kMostWaiting) return false;
    const std::size_t followers = layer.followers();
    const double come = std::max(setpoint->feed, feed_before) * tick + in_a_tick;
    const double ahead = kLonger * come + kBehind * motions[0].tolerance + kLonger * aside;
    double passed = 0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const PendingMotion& here = motions[i];
        if (!here.is_plain || here.system != motions[0].system) return false;
        const double there = i == 0 ? parameter : 0;
        const Vec3 tip = tip_of(here.plain, *setpoint);
        const PlainLook look =
            stands(here.plain, *setpoint, followers)
                ? look_at(here.plain, tip, here.tolerance, there)
                : PlainLook{is_line(here.plain) ? LookResult::Beside : LookResult::Unknown, there};
        if (look.side == LookResult::Unknown) return false;
        if (look.side == LookResult::On) {
            if (i == 0) stay(look.parameter, tip);
            else if (is_next(i, tip, come) &&
                     travel_bound(here.plain, look.parameter) <= ahead - passed)
                leave(i, look.parameter);
            else return false;
            before = tip;
            system_before = motions.front().system;
            feed_before = setpoint->feed;
            has_begun = true;
            return true;
        }
        if (i > 0) passed += here.length;
        if (passed > ahead) return false;
    }
    return false;
}
/// Whether the ends before a plain motion are between the setpoint and the one before.
///
/// tip, come  of the setpoint, and how far the tip goes in a tick, mm
bool PathCheck::State::is_next(std::size_t at, const Vec3& tip, double come) const {
    double widest = 0;
    for (std::size_t k = 0; k < at; ++k) {
        widest = std::max(widest, motions[k].tolerance);
        if (widest > kSureEnd) break;
        const double allowed = 3 * widest + come / 2;
        const Vec3& end = end_of(motions[k].plain);
        if (!has_begun || path::distance_to_line(end, before, tip) > allowed) return false;
    }
    return true;
}

const ProgrammedMotion& PathCheck::State::motion_at(std::size_t i) {
    layer.complete(motions[i]);
    return *motions[i].motion;
}

/// On the motion on which the tip was, or one of the next.
Done PathCheck::State::go_on() {
    const ProgrammedMotion& here = motion_at(0);
    const StandingTool& there = tool_for(here);
    const double ahead = kLonger * reach() + kBehind * here.tolerance + kLonger * aside;
    const Nearness near = nearest_on(*chain, here, there, {parameter, ahead});
    if (keeps(here, near)) {
        stay(near.parameter, there.tip);
        const bool may_wait = motions.size() < kMostWaiting;
        return may_wait || motions.size() == 1 ? kDone : search();
    }
    return search();
}

/// On one of the next motions, as far as the tip may have come; then also where a motion comes near
/// once more. That is looked for as well where an end would be left out else: the tip may be on an
/// earlier motion that has turned back.
Done PathCheck::State::search() {
    Nearest nearest;
    auto found = find(false, nearest);
    auto left_out = found ? left_out_before(found->at) : std::nullopt;
    if (!found || left_out) {
        found = find(true, nearest);
        left_out = found ? left_out_before(found->at) : std::nullopt;
    }
    if (!found) {
        fail_near(*nearest.motion, nearest.near);
        return kFailed;
    }
    if (left_out) {
        deviation = left_out;
        return kFailed;
    }
    if (found->at == 0) stay(found->near.parameter, tool.tip);
    else leave(found->at, found->near.parameter);
    return kDone;
}

/// The first motion that the tip keeps to; `nearest` is where it is nearest else. Thorough: all of
/// each motion is looked at.
std::optional<PathCheck::State::Found> PathCheck::State::find(bool is_thorough, Nearest& nearest) {
    double behind = kBehind * motions[0].tolerance + kLonger * aside;
    double passed = 0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const ProgrammedMotion& motion = motion_at(i);
        const StandingTool& there = tool_for(motion);
        const double ahead = kLonger * reach() + behind;
        const SearchRange within{i == 0 ? parameter : 0, ahead};
        const auto look = is_thorough ? nearest_on_rest
                          : i == 0    ? nearest_from_behind  // go_on has looked from here on
                                      : nearest_on;
        const Nearness near = look(*chain, motion, there, within);
        const bool is_reached = i == 0 || passed + distance_to(motion, near.parameter) <= ahead;
        if (is_reached && keeps(motion, near)) return Found{i, near};
        if (nearest.motion == nullptr || near.distance <= nearest.near.distance)
            nearest = {&motions[i], near};
        behind = std::max(behind, kBehind * motion.tolerance + kLonger * aside);
        // What is left of the first one is not known in mm; it may be nothing.
        if (i > 0 && !motion.segment.is_rotary_only) passed += motion.length;
        if (passed > kLonger * reach() + behind) break;
    }
    return std::nullopt;
}

/// Where the tip would be on the motion at `at`: an end before it that is not between the setpoint
/// and the one before.
std::optional<PathDeviation> PathCheck::State::left_out_before(std::size_t at) {
    if (!has_begun) return std::nullopt;
    double widest = 0;  // so far the tip may have gone on within the tolerance of an end
    for (std::size_t i = 0; i < at; ++i) {
        const ProgrammedMotion& motion = motion_at(i);
        widest = std::max(widest, motion.tolerance);
        if (motion.system != system_before || motion.system != tool_system) continue;
        if (widest > kSureEnd) break;
        const double allowed = 3 * widest + reach() / 2;
        // The tip was there, and has come back beside its path since.
        if (i == 0 && motion.length - distance_to(motion, parameter) <= allowed) continue;
        const double off = path::distance_to_line(end_of(*chain, motion), before, tool.tip);
        if (off > allowed) return deviation_of(DeviationKind::LeftOut, motions[i], off, allowed);
    }
    return std::nullopt;
}

PathCheck::PathCheck(const machine::Machine& machine, double tick)
    : state_(std::make_unique<State>(machine, tick)) {}
PathCheck::~PathCheck() = default;

void PathCheck::read(const Command& command) {
    State& state = *state_;
    const std::lock_guard lock(state.mutex);
    PendingMotion& next = state.laid.emplace_back();
    if (!state.layer.lay(command, next)) state.laid.pop_back();
}

Done PathCheck::follow(std::span<const Setpoint> setpoints) {
    State& state = *state_;
    if (state.deviation) return kFailed;
    state.take();
    for (const Setpoint& setpoint : setpoints) {
        if (!state.follow(setpoint)) return kFailed;
    }
    return kDone;
}

void PathCheck::finish() {
    State& state = *state_;
    if (state.deviation) return;
    state.take();
    if (state.motions.empty()) return;
    PendingMotion& last = state.motions.back();
    if (!state.has_begun) {
        state.layer.complete(last);
        state.deviation = state.deviation_of(DeviationKind::End, last, last.length, 0);
        return;
    }
    if (last.system != state.system_before) return;
    const double off =
        (end_of(*state.chain, state.motion_at(state.motions.size() - 1)) - state.before).norm();
    if (off <= last.tolerance) return;
    state.deviation = state.deviation_of(DeviationKind::End, last, off, last.tolerance);
}

const std::optional<PathDeviation>& PathCheck::deviation() const { return state_->deviation; }

}  // namespace kadr::motion
