#include "motion/prepare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "base/units.h"
#include "motion/axis_check.h"
#include "motion/feed.h"
#include "motion/spindle.h"
#include "motion/spline_pieces.h"
#include "motion/standing.h"

namespace kadr::motion {

namespace {

using path::Command;
using path::Op;
using path::Vec3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How a corner and the ramps beside it share the acceleration of an axis (corner.h).
constexpr double kMostRamp = 0.9;    // the jump has up to 42 % then
constexpr double kSharedRamp = 0.5;  // half and half
// Corners of equal distance below a tick weigh up to 1.125 times as much as their mean.
constexpr double kCrowding = 1.125;
constexpr double kStraight = 1e-9;  // as in corner.cpp

// Jumps of the curvature of equal distance below the width of the bell weigh up to 1.05 times as
// much as their mean.
constexpr double kBellCrowding = 1.05;
constexpr double kMostJump = 0.5;  // part of an axis' jerk that a jump of the curvature may take

// To go on after a missing feed has been reported, mm/s; slow enough to be noticed in the time.
constexpr double kFallbackFeed = 1;

// Of two speeds, relative: rounding of products, far below what a pitch shows.
constexpr double kSameSpeed = 1e-9;

/// What a corner needs to know of the piece before it.
struct CornerMemory {
    AxisRates rates{};  // dq/ds at its end
    AxisRates bends{};  // d²q/ds² at its end
    AxisTable::Loads loads;
    double length = 0;
    double speed = 0;               // limit inside
    Vec3 direction = Vec3::Zero();  // at its end
    double acceleration = 0;
    bool turns_only = false;
    bool is_bent = false;
    bool must_stop = true;  // the path comes to rest behind it
};

bool is_straight(const Segment& segment) {
    return std::holds_alternative<path::Line>(segment.curve) ||
           std::holds_alternative<path::Point>(segment.curve);
}

}  // namespace

struct Preparer::State {
    State(Stream<Command>& commands_in, const machine::Machine& machine_in,
          const AxisTable& axes_in, const PlannerOptions& options_in, DiagnosticSink& sink_in,
          PieceRing& pieces_in);

    std::size_t next();
    Piece& fresh_piece();
    const Command* next_command();
    void execute(const Command& command);

    void set_spindle(const Command& command);
    void dwell(const Command& command);
    void stand(const Command& command, SegmentKind kind, double duration);

    void move(const Command& command);
    bool is_possible(const Command& command, const Segment& segment, double length);
    void emit_spline(const Command& command, const Segment& whole, const path::Spline& spline);
    void emit_feed_parts(const Command& command, const Segment& segment, double length);
    void emit_parts(const Command& command, const Segment& whole, double length, int parts);
    void emit(const Command& command, const Segment& segment, double length);
    void report_thread_speed(const Command& command, double feed, double most);
    double wanted_feed(const Command& command, const Segment& segment, double length);
    double corner_speed(const Segment& segment, const AxisRates& in, double acceleration) const;
    void take_corner(Piece& piece) const;
    bool is_alone(const Piece& piece) const;
    double time_beside(const Piece& piece, double speed, double ramp) const;
    double shared_speed(const Piece& piece, bool alone, double ramp) const;
    double corner_acceleration_limit(const AxisRates& in) const;
    void take_bend(Piece& piece) const;
    void remember(const Piece& piece);

    void alarm_raised();

    Stream<Command>& commands;
    const machine::Machine& machine;
    const AxisTable& axes;
    const PlannerOptions& options;
    DiagnosticSink& sink;
    double tick = 0;   // s
    AxisRates jump{};  // by how much an axis may change its velocity at a corner

    std::vector<Command> batch = std::vector<Command>(kBatch);
    std::size_t batch_size = 0;
    std::size_t batch_at = 0;
    std::uint64_t commands_read = 0;
    bool has_ended = false;
    bool has_alarmed = false;
    bool feed_reported = false;

    Standing standing;
    Spindle spindle;
    AxisCheck check;
    CornerMemory last;

    PieceRing& pieces;
    std::size_t ready = 0;  // pieces of the current command
};

Preparer::State::State(Stream<Command>& commands_in, const machine::Machine& machine_in,
                       const AxisTable& axes_in, const PlannerOptions& options_in,
                       DiagnosticSink& sink_in, PieceRing& pieces_in)
    : commands(commands_in),
      machine(machine_in),
      axes(axes_in),
      options(options_in),
      sink(sink_in),
      standing(machine_in),
      check(machine_in, axes_in, options_in, sink_in),
      pieces(pieces_in) {
    tick = options.tick > 0 ? options.tick : machine.tick;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        jump[i] =
            options.velocity_jump[i] > 0 ? options.velocity_jump[i] : axes.acceleration(i) * tick;
    }
    spindle.machine_limit = machine.max_speed;
}

std::size_t Preparer::State::next() {
    ready = 0;
    while (ready == 0) {
        const Command* command = next_command();
        if (command == nullptr) return 0;
        execute(*command);
    }
    return ready;
}

/// Appended; all but the segment, the length and the limits is as on a path without a corner.
Piece& Preparer::State::fresh_piece() {
    ++ready;
    Piece& piece = pieces.push_back();
    piece.jerk = piece.entry_acceleration = piece.turning_acceleration = kInfinity;
    piece.entry_limit = 0;
    piece.ramp = piece.ramp_before = piece.jerk_share = piece.jerk_before = 1;
    return piece;
}

const Command* Preparer::State::next_command() {
    if (has_ended) return nullptr;
    if (batch_at == batch_size) {
        batch_at = 0;
        batch_size = commands.pull(batch);
        if (batch_size == 0) {
            has_ended = true;
            return nullptr;
        }
    }
    ++commands_read;
    return &batch[batch_at++];
}

void Preparer::State::execute(const Command& command) {
    switch (command.op) {
        case Op::Rapid:
        case Op::Line:
        case Op::Arc:
        case Op::Thread:
        case Op::Probe:
        case Op::Spline: move(command); return;
        case Op::Dwell: dwell(command); return;
        case Op::Spindle: set_spindle(command); return;
        case Op::SpeedLimit: spindle.limit = speed_from_rpm(command.speed); return;
        case Op::Tool: stand(command, SegmentKind::ToolChange, machine.tool_change_time); return;
        case Op::ToolLength: standing.set_tool_length(command, axes); return;
        case Op::Stop:
        case Op::OptionalStop:
        case Op::End: last.must_stop = true; return;
        // Switched while moving: a control does not stop for them.
        case Op::Coolant:
        case Op::Message: return;
    }
}

// ------------------------------------------------------------------------------ standstill

void Preparer::State::set_spindle(const Command& command) {
    feed_reported = false;
    if (command.spindle == path::SpindleMode::Orient) {
        spindle.is_turning = false;
        stand(command, SegmentKind::Orient, machine.orient_time);
        return;
    }
    spindle.is_turning = command.spindle != path::SpindleMode::Stop && command.speed > 0;
    spindle.holds_cutting_speed = command.cutting_speed;
    if (command.cutting_speed) {
        spindle.cutting_speed = feed_from_mm_min(command.speed * 1000);  // from m/min
        return;
    }
    spindle.speed = speed_from_rpm(command.speed);
    if (spindle.is_turning && machine.max_speed > 0 && spindle.speed > machine.max_speed) {
        sink.report(diag::SpindleTooFast, place_of(command, options))
            .arg(command.speed)
            .arg(round_to(rpm_from_speed(machine.max_speed), 3));
    }
}

void Preparer::State::dwell(const Command& command) {
    double duration = command.time;
    if (command.revolutions > 0) {
        const double turns = spindle.speed_at(standing.tip()[0]);
        if (turns > 0) {
            duration = command.revolutions / turns;
        } else {
            sink.report(diag::DwellWithoutSpindle, place_of(command, options))
                .arg(command.revolutions);
            alarm_raised();
        }
    }
    stand(command, SegmentKind::Dwell, duration);
}

void Preparer::State::stand(const Command& command, SegmentKind kind, double duration) {
    last.must_stop = true;
    if (!(duration > 0) || has_ended) return;
    Piece& piece = fresh_piece();
    piece.segment = standing.still();
    piece.length = 0;
    piece.segment.kind = kind;
    piece.segment.line = command.line;
    piece.segment.source = command.source;
    piece.segment.duration = duration;
    piece.segment.spindle = spindle;
    // Length 0 between two stops: speed and acceleration only have to be above zero.
    piece.speed = piece.acceleration = 1;
}

// ------------------------------------------------------------------------------ motion

void Preparer::State::move(const Command& command) {
    const Standing::Target target = standing.target_of(command);
    Segment segment = standing.still();
    segment.kind = command.op == Op::Rapid ? SegmentKind::Rapid : SegmentKind::Feed;
    segment.line = command.line;
    segment.source = command.source;
    const double length = standing.lay_path(command, target, segment);
    if (length > 0 && is_possible(command, segment, length)) {
        if (const auto* spline = std::get_if<path::Spline>(&segment.curve)) {
            emit_spline(command, segment, *spline);
        } else {
            emit_feed_parts(command, segment, length);
        }
        if (ready > 0) pieces.back(0).segment.ends_command = true;
        if (!has_ended) check.widen_travel();
    }
    if (has_ended) return;
    standing.arrive(command, target);
    if (command.exact_stop) last.must_stop = true;
}

/// False if the piece has to be left out; the reason has been reported.
bool Preparer::State::is_possible(const Command& command, const Segment& segment, double length) {
    const AxisCheck::Answer answer = check.check(command, segment, length);
    if (answer == AxisCheck::Answer::Possible) return true;
    alarm_raised();
    return answer == AxisCheck::Answer::Beyond && !has_ended;
}

/// The curvature of a span may change greatly; its pieces have each their own speed.
void Preparer::State::emit_spline(const Command& command, const Segment& whole,
                                  const path::Spline& spline) {
    Command share = command;
    for (const path::Curve& curve : evenly_bent(spline)) {
        if (has_ended) return;
        Segment piece = whole;
        piece.curve = curve;
        const double length = path::length(curve);
        // Under inverse time the time of the block is shared out by length.
        if (command.feed_mode == path::FeedMode::InverseTime)
            share.feed = command.feed * spline.length / length;
        emit_feed_parts(share, piece, length);
    }
}

void Preparer::State::emit_feed_parts(const Command& command, const Segment& segment,
                                      double length) {
    const int parts = command.op == Op::Rapid ? 1 : feed_parts(command, segment, spindle);
    if (parts == 1) {
        emit(command, segment, length);
    } else {
        emit_parts(command, segment, length, parts);
    }
}

/// A piece on which the spindle changes its speed goes as several, each with its own feed.
void Preparer::State::emit_parts(const Command& command, const Segment& whole, double length,
                                 int parts) {
    for (int i = 0; i < parts && !has_ended; ++i) {
        const double from = length * i / parts;
        const double to = i + 1 == parts ? length : length * (i + 1) / parts;
        Segment piece = whole;
        piece.curve = path::part(whole.curve, from, to);
        for (std::size_t k = 0; k < kFollowers; ++k) {
            piece.follower_start[k] += piece.follower_rate[k] * from;
        }
        emit(command, piece, to - from);
    }
}

void Preparer::State::emit(const Command& command, const Segment& segment, double length) {
    double feed = wanted_feed(command, segment, length);
    if (has_ended) return;
    const AxisRates in = axes.start_rates(segment);
    PathLimits limits = axes.limits(segment, in, feed);
    if (segment.kind == SegmentKind::Rapid) {
        // A straight line: its acceleration does not depend on the speed.
        limits.speed *= options.rapid_override;
        feed = limits.speed;
    }
    if (command.op == Op::Thread && limits.speed < feed * (1 - kSameSpeed)) {
        report_thread_speed(command, feed, limits.speed);
        if (has_ended) return;
    }
    Piece& piece = fresh_piece();
    piece.segment = segment;
    piece.segment.feed = feed;
    piece.segment.ends_command = false;
    piece.segment.spindle = spindle;
    if (segment.kind == SegmentKind::Feed && command.feed_mode == path::FeedMode::PerRevolution) {
        piece.segment.feed_per_revolution = command.feed * options.feed_override;
    }
    piece.length = length;
    piece.speed = limits.speed;
    piece.acceleration = limits.acceleration;
    piece.jerk = limits.jerk;
    piece.turning_acceleration = limits.turning_acceleration;
    piece.entry_limit = corner_speed(segment, in, limits.acceleration);
    piece.rates = in;
    piece.loads = axes.loads(segment, in);
    take_corner(piece);
    if (axes.limits_jerk()) {
        piece.entry_acceleration = corner_acceleration_limit(in);
        take_bend(piece);
    }
    remember(piece);
}

/// The axes cannot follow the spindle: the thread would get another pitch.
void Preparer::State::report_thread_speed(const Command& command, double feed, double most) {
    sink.report(diag::ThreadTooFast, place_of(command, options))
        .arg(round_to(mm_min_from_feed(feed), 3))
        .arg(round_to(mm_min_from_feed(most), 3));
    alarm_raised();
}

/// The path speed that the program asks for, override included; infinite at rapid.
double Preparer::State::wanted_feed(const Command& command, const Segment& segment, double length) {
    if (command.op == Op::Rapid) return kInfinity;
    const auto feed = path_feed(command, segment, length, spindle);
    if (!feed) {
        const bool no_feed = feed.error() == FeedFault::NoFeed;
        if (!feed_reported) {
            sink.report(no_feed ? diag::MotionWithoutFeed : diag::FeedWithoutSpindle,
                        place_of(command, options));
        }
        feed_reported = true;
        alarm_raised();
        return kFallbackFeed;
    }
    // A thread follows the spindle: neither an override nor a limit of the feed acts on it.
    if (command.op == Op::Thread) return *feed;
    const double wanted = *feed * options.feed_override;
    return machine.max_feed > 0 && !segment.turns_only ? std::min(wanted, machine.max_feed)
                                                       : wanted;
}

double Preparer::State::corner_speed(const Segment& segment, const AxisRates& in,
                                     double acceleration) const {
    if (last.must_stop) return 0;
    if (segment.turns_only != last.turns_only) return 0;  // mm/s and deg/s do not meet
    const std::size_t n = axes.size();
    if (options.corner_rule == CornerRule::AxisJump || segment.turns_only) {
        return axis_jump_speed({last.rates.data(), n}, {in.data(), n}, {jump.data(), n});
    }
    // The rule knows directions in space; axes beside X Y Z keep to the jump.
    double speed = kInfinity;
    for (std::size_t i = 0; i < n; ++i) {
        if (index(machine.axes[i].axis) < 3) continue;
        speed = std::min(speed, axis_jump_speed({&last.rates[i], 1}, {&in[i], 1}, {&jump[i], 1}));
    }
    const Vec3 direction = path::evaluate(segment.curve, 0).tangent;
    return std::min(speed,
                    junction_deviation_speed(last.direction, direction, options.junction_deviation,
                                             std::min(acceleration, last.acceleration)));
}

/// The speed at which a corner may be taken, beside the ramps on both sides of it. What is left to
/// the ramps makes the approach faster, what is left to the jump the corner: the quicker of two
/// ways to share is taken.
void Preparer::State::take_corner(Piece& piece) const {
    const bool is_jump_given =
        std::ranges::any_of(options.velocity_jump, [](double given) { return given > 0; });
    const bool is_free = options.corner_rule != CornerRule::AxisJump || is_jump_given ||
                         piece.entry_limit == 0 || std::isinf(piece.entry_limit);
    if (is_free) return;
    const bool alone = is_alone(piece);
    double ramp = kSharedRamp;
    double speed = shared_speed(piece, alone, kSharedRamp);
    if (alone) {
        const double slower = shared_speed(piece, alone, kMostRamp);
        if (time_beside(piece, slower, kMostRamp) <= time_beside(piece, speed, kSharedRamp)) {
            ramp = kMostRamp;
            speed = slower;
        }
    }
    piece.entry_limit = speed;
    piece.ramp = piece.ramp_before = ramp;
    piece.acceleration *= ramp;
}

/// Time for half of the shorter piece beside a corner that is left at this speed.
double Preparer::State::time_beside(const Piece& piece, double speed, double ramp) const {
    const double way = std::min(last.length, piece.length) / 2;
    const double most = std::min(last.speed, piece.speed);
    const double along = ramp * std::min(last.acceleration, piece.acceleration);
    const double from = std::min(speed, most);
    const double reached = std::sqrt(from * from + 2 * along * way);
    if (reached <= most) return (reached - from) / along;
    const double ramp_way = (most * most - from * from) / (2 * along);
    return (most - from) / along + (way - ramp_way) / most;
}

/// Whether no other corner comes within two ticks.
bool Preparer::State::is_alone(const Piece& piece) const {
    const double full = std::min({piece.entry_limit, last.speed, piece.speed});
    const double gain = tick * std::max(last.acceleration, piece.acceleration);
    return std::min(last.length, piece.length) >= 2 * tick * (full + gain);
}

/// … if the pieces on both sides use the part `ramp` of their acceleration.
double Preparer::State::shared_speed(const Piece& piece, bool alone, double ramp) const {
    const double full = std::min({piece.entry_limit, last.speed, piece.speed});
    const double reach = std::min(last.length, piece.length);
    const double gain = tick * std::max(last.acceleration, piece.acceleration);
    double speed = piece.entry_limit;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double change = std::abs(piece.rates[i] - last.rates[i]);
        if (change < kStraight) continue;
        const double limit = axes.acceleration(i);
        const double before = last.loads.at(i, full, ramp * last.acceleration) / limit;
        const double behind = piece.loads.at(i, full, ramp * piece.acceleration) / limit;
        const double share = jump_share(before, behind, alone);
        speed = std::min(speed, share * jump[i] / change);
        if (alone) continue;
        // v·(v + gain) = most: between this corner and the next the speed may still rise.
        const double most = share * limit * reach / (kCrowding * change);
        speed = std::min(speed, std::sqrt(gain * gain / 4 + most) - gain / 2);
    }
    return speed;
}

/// With how much acceleration along the path the corner may be passed.
double Preparer::State::corner_acceleration_limit(const AxisRates& in) const {
    double most = kInfinity;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const double change = std::abs(in[i] - last.rates[i]);
        if (change > kStraight) most = std::min(most, axes.jerk(i) * tick / change);
    }
    return most;
}

/// Where the curvature jumps, as between a line and an arc, the acceleration of the axes does at
/// any speed: from tick to tick that is a jerk. The jump gets a share of what the axes have, as
/// little as its speed needs and half at most; the pieces beside it keep the rest.
void Preparer::State::take_bend(Piece& piece) const {
    if (piece.entry_limit == 0) return;
    const bool is_bent = !is_straight(piece.segment);
    if (!is_bent && !last.is_bent) return;
    const AxisRates bends = is_bent ? axes.start_bends(piece.segment) : AxisRates{};
    double change = 0;  // of d²q/ds², in parts of the axis' jerk
    for (std::size_t i = 0; i < axes.size(); ++i) {
        change = std::max(change, std::abs(bends[i] - last.bends[i]) / axes.jerk(i));
    }
    const double speed = std::min({piece.entry_limit, last.speed, piece.speed});
    const double reach = std::min(last.length, piece.length);
    const bool is_alone = reach >= kJumpBellTicks * tick * speed;
    const double weight = (is_alone ? 1 : kBellCrowding) * change;
    const double bell = kJumpBell / tick;
    const double full = weight * speed * speed * (is_alone ? bell : std::max(bell, speed / reach));
    if (full < kStraight) return;
    if (full > kMostJump) {
        const double most = kMostJump / weight;
        const double alone = std::sqrt(most / bell);
        piece.entry_limit = is_alone ? alone : std::min(alone, std::cbrt(most * reach));
    }
    piece.jerk_share = piece.jerk_before = 1 - std::min(full, kMostJump);
    piece.jerk *= piece.jerk_share;
    piece.acceleration =
        std::min(piece.acceleration, piece.turning_acceleration * piece.jerk_share);
}

void Preparer::State::remember(const Piece& piece) {
    const Segment& segment = piece.segment;
    last.is_bent = !is_straight(segment);
    last.rates = last.is_bent ? axes.end_rates(segment) : piece.rates;
    if (axes.limits_jerk()) last.bends = last.is_bent ? axes.end_bends(segment) : AxisRates{};
    if (options.corner_rule == CornerRule::JunctionDeviation) {
        last.direction = path::evaluate(segment.curve, path::length(segment.curve)).tangent;
    }
    last.loads = piece.loads;
    last.length = piece.length;
    last.speed = piece.speed;
    last.acceleration = piece.acceleration / piece.ramp;
    last.turns_only = segment.turns_only;
    last.must_stop = false;
}

void Preparer::State::alarm_raised() {
    has_alarmed = true;
    if (options.stop_at_alarm) has_ended = true;
}

// ------------------------------------------------------------------------------ the door

Preparer::Preparer(Stream<path::Command>& commands, const machine::Machine& machine,
                   const AxisTable& axes, const PlannerOptions& options, DiagnosticSink& sink,
                   PieceRing& pieces)
    : state_(std::make_unique<State>(commands, machine, axes, options, sink, pieces)) {}
Preparer::~Preparer() = default;

std::size_t Preparer::next() { return state_->next(); }
std::uint64_t Preparer::commands() const { return state_->commands_read; }
bool Preparer::alarmed() const { return state_->has_alarmed; }
const AxisTable::Travel& Preparer::travel() const { return state_->check.travel(); }

}  // namespace kadr::motion
