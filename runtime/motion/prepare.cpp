#include "motion/prepare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "base/units.h"
#include "motion/feed.h"
#include "motion/prepare_state.h"
#include "motion/spline_pieces.h"
#include "motion/transformed_cells.h"

namespace kadr::motion {

namespace {

using path::Command;
using path::Op;
using path::Vec3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// To go on after a missing feed has been reported, mm/s; slow enough to be noticed in the time.
constexpr double kFallbackFeed = 1;

// Of an axis' acceleration, what the bend of a piece takes before it is planned in cells; below,
// its fixed shares leave 95 % to the ramps.
constexpr double kBendForCells = 0.3;
// No cell of a spline is shorter, mm: it passes in a tick.
constexpr double kShortCell = 0.02;
// So many ticks from a corner its jump shows in the acceleration of setpoints.
constexpr double kCornerTicks = 2;
// A cell may be faster than fixed shares allow, whose speed is this part of the most there is.
constexpr double kSharedSpeed = 0.93;

// Of two speeds, relative: rounding of products, far below what a pitch shows.
constexpr double kSameSpeed = 1e-9;

}  // namespace

Preparer::State::State(Stream<Command>& commands_in, const machine::Machine& machine_in,
                       const AxisTable& axes_in, const PlannerOptions& options_in,
                       DiagnosticSink& sink_in, PieceRing& pieces_in)
    : commands(commands_in),
      machine(machine_in),
      machine_axes(axes_in),
      axes(axes_in),
      options(options_in),
      sink(sink_in),
      standing(machine_in),
      check(machine_in, axes_in, options_in, sink_in),
      pieces(pieces_in) {
    tick = machine.tick;
    set_jumps();
    spindle.machine_limit = machine.max_speed;
}

std::size_t Preparer::State::next() {
    ready = 0;
    while (ready == 0) {
        const Command* command = next_command();
        if (command == nullptr) {
            finish();
            break;
        }
        execute(*command);
    }
    return ready;
}

/// No command comes any more, at the end or behind an alarm, which is about none that waits.
void Preparer::State::finish() {
    const bool was_ended = std::exchange(has_ended, false);
    release();
    has_ended = was_ended;
}

/// Appended; all but the segment, the length and the limits is as on a path without a corner.
Piece& Preparer::State::fresh_piece() {
    ++ready;
    Piece& piece = pieces.push_back();
    piece.jerk = piece.entry_acceleration = piece.turning_acceleration = kInfinity;
    piece.entry_limit = 0;
    piece.ramp = piece.ramp_before = piece.jerk_share = piece.jerk_before = 1;
    piece.corner_zone = piece.corner_zone_before = 0;
    piece.crowd_ramp = 1;
    piece.rests_at_corner = false;
    piece.smooth_corner_jerk = 0;
    piece.is_cell = piece.is_geared = piece.has_dynamics = piece.follows_spindle = false;
    piece.feed_asked = piece.rapid_asked = kInfinity;
    piece.can_be_held = false;
    piece.varying_feed.time = 0;
    piece.issues = std::exchange(to_issue, 0);
    piece.awaits = piece.awaits_mark = false;
    return piece;
}

/// Behind the compressor, through which short lines go that the program lets it have.
const Command* Preparer::State::next_command() {
    if (has_ended) return nullptr;
    while (true) {
        if (const Command* ready_made = compressor.next()) return ready_made;
        const Command* command = next_read();
        if (command == nullptr) {
            if (compressor.is_empty()) return nullptr;
            compressor.finish();
            continue;
        }
        const bool is_taken = Compressor::can_take(*command) && !has_pulses();
        if (compressor.is_empty() && !is_taken) return command;
        compressor.take(*command, standing);
    }
}

const Command* Preparer::State::next_read() {
    if (batch_at == batch_size) {
        batch_at = 0;
        batch_size = is_drained ? 0 : commands.pull(batch);
        if (batch_size == 0) {
            is_drained = true;
            return nullptr;
        }
    }
    ++commands_read;
    return &batch[batch_at++];
}

void Preparer::State::execute(const Command& command) {
    if (!command.is_motion()) release();
    switch (command.op()) {
        case Op::Rapid:
        case Op::Line:
        case Op::Arc:
        case Op::Thread:
        case Op::Probe:
        case Op::Spline:
        case Op::Involute:
        case Op::Parametric: move(command); return;
        case Op::Dwell: dwell(command); return;
        case Op::Spindle: set_spindle(command); return;
        case Op::OtherSpindle: set_other_spindle(command); return;
        case Op::SpeedLimit:
            spindle.limit = speed_from_rpm(command.speed_limit().most);
            spindle.least = speed_from_rpm(command.speed_limit().least);
            return;
        case Op::Tool:
            tool_number = command.tool().number;
            stand(command, SegmentKind::ToolChange, machine.tool_change_time);
            return;
        case Op::ToolLength: standing.set_tool_length(command.tool_length(), axes); return;
        case Op::Stop:
        case Op::OptionalStop:
        case Op::End: last.must_stop = true; return;
        case Op::Function: issue(command); return;
        case Op::External: stand(command, SegmentKind::External, command.external().time); return;
        // The module that they are for takes them out; without one they have no effect.
        case Op::ScannerOn:
        case Op::ScannerOff:
        // Switched while moving: a control does not stop for them.
        case Op::Coolant:
        case Op::Message: return;
    }
}

// ------------------------------------------------------------------------------ standstill

void Preparer::State::set_spindle(const Command& command) {
    const path::Spindle& wanted = command.spindle();
    reported.renew(PlanNotice::NoFeed);
    if (wanted.mode == path::SpindleMode::Orient) {
        spindle.is_turning = false;
        stand(command, SegmentKind::Orient, machine.orient_time_of(wanted.number));
        return;
    }
    spindle.machine_limit = machine.max_speed_of(wanted.number);
    spindle.is_turning = wanted.mode != path::SpindleMode::Stop && wanted.speed > 0;
    spindle.is_counterclockwise = wanted.mode == path::SpindleMode::Ccw;
    spindle.holds_cutting_speed = wanted.has_cutting_speed;
    if (wanted.has_cutting_speed) {
        spindle.cutting_speed = feed_from_mm_min(wanted.speed * 1000);  // from m/min
        return;
    }
    spindle.speed = speed_from_rpm(wanted.speed);
    if (spindle.is_turning) check_speed(command);
}

void Preparer::State::check_speed(const Command& command) {
    const path::Spindle& wanted = command.spindle();
    const double most = machine.max_speed_of(wanted.number);
    if (!(most > 0) || speed_from_rpm(wanted.speed) <= most) return;
    report(sink, diag::SpindleTooFast, command, options.locate_command)
        .arg(wanted.speed)
        .arg(round_to(rpm_from_speed(most), 3));
}

/// The path waits for it where it is to stand at an angle, and does not follow it.
void Preparer::State::set_other_spindle(const Command& command) {
    const path::Spindle& wanted = command.spindle();
    if (wanted.mode == path::SpindleMode::Orient) {
        stand(command, SegmentKind::Orient, machine.orient_time_of(wanted.number));
    } else if (wanted.mode != path::SpindleMode::Stop && !wanted.has_cutting_speed) {
        check_speed(command);
    }
}

void Preparer::State::dwell(const Command& command) {
    double duration = command.dwell().time;
    if (command.dwell().revolutions > 0) {
        const double turns = spindle.speed_at(standing.tip()[0]);
        if (turns > 0) {
            duration = command.dwell().revolutions / turns;
        } else {
            report(sink, diag::DwellWithoutSpindle, command, options.locate_command)
                .arg(command.dwell().revolutions);
            alarm_raised();
        }
    }
    stand(command, SegmentKind::Dwell, duration);
}

void Preparer::State::stand(const Command& command, SegmentKind kind, double duration) {
    last.must_stop = true;
    if (!(duration > 0) || has_ended) return;
    emit_stand(command, kind).segment.duration = duration;
}

Piece& Preparer::State::emit_stand(const Command& command, SegmentKind kind) {
    Piece& piece = fresh_piece();
    piece.segment = standing.still();
    piece.length = 0;
    piece.segment.kind = kind;
    piece.segment.stage = standing.tip();
    piece.segment.line = command.line;
    piece.segment.cycle = command.cycle;
    piece.segment.source = command.source;
    piece.segment.duration = 0;
    piece.segment.spindle = spindle;
    piece.segment.tool_number = tool_number;
    // Length 0 between two stops: speed and acceleration only have to be above zero.
    piece.speed = piece.acceleration = 1;
    return piece;
}

/// An M function goes with the piece behind it, or with the stand in which it is awaited.
void Preparer::State::issue(const Command& command) {
    if (has_ended) return;
    if (command.function().step != path::FunctionStep::Await) {
        issued.push_back({command.function().code, 0, command.line});
        ++to_issue;
    }
    if (command.function().step == path::FunctionStep::Issue) return;
    last.must_stop = true;
    emit_stand(command, SegmentKind::Wait).awaits = true;
}

// ------------------------------------------------------------------------------ motion

void Preparer::State::move(const Command& command) {
    const path::Motion& motion = command.motion();
    follow_dynamics(command);
    if (standing.follow_transformation(motion)) last.must_stop = true;
    meet_spindle(command);
    if (has_pulses()) rest_at_points(command);
    AxesPosition::MotionEnd target = standing.target_of(motion);
    Segment segment = standing.still();
    segment.kind = motion.op() == Op::Rapid ? SegmentKind::Rapid : SegmentKind::Feed;
    segment.line = command.line;
    segment.cycle = command.cycle;
    segment.source = command.source;
    const double length = standing.lay_path(motion, target, segment);
    const EndState arrival{length, joints_of(axes.chain(), target.followers)};
    if (segment.is_transformed() && length > 0) {
        const double from = round_corner(command, segment, arrival);
        if (!has_ended && !hold(command, segment, arrival, from)) {
            if (has_law(command)) begin_law(0, length);
            if (from > 0) emit_rest(command, segment, length, from);
            else emit_transformed(command, segment, target);
        }
    } else if (length > 0 && check_axes(command, segment, length)) {
        const double from = round_corner(command, segment, arrival);
        if (!hold(command, segment, arrival, from)) {
            emit_part(command, segment, length, {from, length});
            end_command();
        }
        if (!has_ended) check.widen_travel();
    } else if (!has_ended && (length > 0 || motion.exact_stop)) {
        release();
    }
    if (has_ended) return;
    standing.arrive(motion, target);
    if (motion.exact_stop) last.must_stop = true;
}

/// The pulses of a laser are timed from rest to rest where nothing burns, and in the mode that
/// stops from point to point as well: no corner there takes anything from the ramps.
void Preparer::State::rest_at_points(const Command& command) {
    const bool burned = std::exchange(burns_point, command.op() != Op::Rapid && spindle.is_turning);
    const bool stops = machine.laser->mode == machine::PulseMode::Stop;
    if (burned != burns_point || (burned && stops)) last.must_stop = true;
}

/// No further piece of the command comes.
void Preparer::State::end_command() {
    if (ready > 0) pieces.back(0).segment.ends_command = true;
}

/// Not done if the piece has to be left out.
Done Preparer::State::check_axes(const Command& command, const Segment& segment, double length) {
    const AxisCheck::Answer answer = check.check(command, segment, length);
    if (answer == AxisCheck::Answer::Possible) return kDone;
    alarm_raised();
    return Done(answer == AxisCheck::Answer::Beyond && !has_ended);
}

/// A motion, or what curves around its corners leave of it; `length` is that of the whole.
void Preparer::State::emit_part(const Command& command, const Segment& whole, double length,
                                const PathPart& part) {
    if (part.to - part.from < kStill) return;
    if (has_law(command)) begin_law(part.from, length);
    const bool is_whole = part.from == 0 && part.to == length;
    const Segment segment = is_whole ? whole : part_of(whole, part.from, part.to);
    if (path::bends_freely(segment.curve) && !std::holds_alternative<path::Glide>(segment.curve)) {
        emit_curves(command, segment, length, evenly_bent(segment.curve));
    } else if (is_whole) {
        emit_feed_parts(command, segment, length);
    } else {
        emit_curves(command, segment, length, {&segment.curve, 1});
    }
}

namespace {

/// Whether a curve has a cusp between two of its pieces, or turns within so little that it cannot
/// be told from one: no corner that the program asks for, so the axes come to rest there.
bool turns_inside(const path::Curve& before, const path::Curve& behind) {
    constexpr double kGoesOn = 0.999;  // cos of an angle
    const path::Vec3 in = path::evaluate(before, path::length(before)).tangent;
    const path::Vec3 out = path::evaluate(behind, 0).tangent;  // of a Glide no unit vectors
    return in.dot(out) < kGoesOn * in.norm() * out.norm();
}

}  // namespace

/// The curvature of a span may change greatly; its pieces have each their own speed.
void Preparer::State::emit_curves(const Command& command, const Segment& whole, double length,
                                  std::span<const path::Curve> curves) {
    Command share = command;
    Segment piece = whole;
    double from = 0;
    for (const path::Curve& curve : curves) {
        if (has_ended) return;
        if (from > 0 && turns_inside(piece.curve, curve)) last.must_stop = true;
        piece.curve = curve;
        for (std::size_t k = 0; k < kFollowers; ++k) {
            piece.follower_start[k] = whole.follower_start[k] + whole.follower_rate[k] * from;
        }
        const double part = path::length(curve);
        from += part;
        // Under inverse time the time of the block is shared out by length.
        if (command.motion().feed_mode == path::FeedMode::InverseTime)
            share.motion().feed = command.motion().feed * length / part;
        emit_feed_parts(share, piece, part);
    }
}

void Preparer::State::emit_feed_parts(const Command& command, const Segment& segment,
                                      double length) {
    if (command.op() == Op::Thread && command.motion().thread().pitch_change != 0 &&
        spindle.is_turning)
        return emit_varying_thread(command, segment, length);
    if (command.op() != Op::Rapid) {
        const auto parts = feed_bounds(command.motion(), segment, length, spindle);
        if (!parts.empty()) return emit_parts(command, segment, parts);
    }
    const auto bounds =
        is_straight(segment) ? std::vector<double>{} : cells_in(command, segment, length);
    bounds.empty() ? emit(command, segment, length) : emit_cells(command, segment, bounds);
}

/// A piece on which the spindle changes its speed goes as several, each with its own feed.
void Preparer::State::emit_parts(const Command& command, const Segment& whole,
                                 const std::vector<double>& bounds) {
    for (std::size_t i = 0; i + 1 < bounds.size() && !has_ended; ++i)
        emit(command, part_of(whole, bounds[i], bounds[i + 1]), bounds[i + 1] - bounds[i],
             {.follows_spindle = true});
}

/// Whether the pieces of a motion may be cells at all.
bool Preparer::State::allows_cells(const Command& command) const {
    // The pulses of a laser time whole blocks.
    if (axes.limits_jerk() || command.op() == Op::Thread || has_pulses()) return false;
    if (has_law(command)) return false;
    // A cell has one profile of its speed, which an event would break.
    if (!options.events.empty()) return false;
    return command.motion().feed_mode == path::FeedMode::PerMinute;
}

/// Where a bent piece is cut into cells: nowhere unless its bend takes so much of an axis that
/// fixed shares would cost time.
std::vector<double> Preparer::State::cells_in(const Command& command, const Segment& whole,
                                              double length) {
    if (!allows_cells(command)) return {};
    const auto feed = path_feed(command.motion(), whole, length, spindle, &axes);
    if (!feed) return {};
    const AxisRates start = axes.start_rates(whole);
    follow_dynamics(command);
    const double wanted = *feed * feed_override(command);
    const double speed = axes.limits(whole, start, wanted).speed;
    const AxisTable::Loads loads = axes.loads(whole, start);
    double gain = 0;
    bool is_bent = false;
    for (std::size_t i = 0; i < axes.size(); ++i) {
        is_bent = is_bent || loads.bend[i] * speed * speed > kBendForCells * axes.acceleration(i);
        gain = std::max(gain, axes.acceleration(i) * tick);
    }
    if (!is_bent) return {};
    if (path::bends_freely(whole.curve)) {
        return cell_bounds(whole.curve, length, axes.linear_limits(), {wanted, kShortCell});
    }
    // A corner beside an arc wants a piece that takes two ticks.
    const double least = 2 * tick * (speed / kSharedSpeed + gain);
    auto bounds = cell_bounds(whole.curve, length, axes.linear_limits(), {wanted, least});
    if (bounds.size() < 3 || bounds[1] < least) return {};
    return bounds;
}

void Preparer::State::emit_cells(const Command& command, const Segment& whole,
                                 const std::vector<double>& bounds) {
    for (std::size_t i = 0; i + 1 < bounds.size() && !has_ended; ++i) {
        const Segment part = part_of(whole, bounds[i], bounds[i + 1]);
        emit(command, part, path::length(part.curve), {.as_cell = true});
    }
}

void Preparer::State::emit(const Command& command, const Segment& segment, double length,
                           const Emission& how) {
    if (!how.is_by_law && has_law(command)) return emit_by_law(command, segment, length, how);
    follow_dynamics(command);
    if (!require_override(command)) return;
    double programmed = programmed_feed(command, segment, length);
    if (has_ended) return;
    double feed = wanted_feed(command, segment, programmed);
    const AxisRates in = axes.start_rates(segment);
    PathLimits limits = axes.limits(segment, in, feed);
    if (segment.kind == SegmentKind::Rapid) {
        // A straight line: its acceleration does not depend on the speed.
        programmed = limits.speed * dynamics.rapid;
        limits.speed = programmed * options.rapid_override;
        feed = limits.speed;
    } else if (std::isinf(programmed)) {
        // No axis moves of which F is the speed: the others have their limits, and the overrides.
        const double most = limits.speed;
        programmed = most * std::min(1.0, programmed_override(command));
        feed = limits.speed = std::min(most, wanted_feed(command, segment, programmed));
    }
    if (command.op() == Op::Thread && limits.speed < feed * (1 - kSameSpeed)) {
        report_thread_speed(command, feed, limits.speed);
        if (has_ended) return;
    }
    Piece& piece = fresh_piece();
    piece.segment = segment;
    piece.segment.feed = feed;
    piece.segment.nominal_feed =
        segment.kind == SegmentKind::Feed ? programmed / programmed_override(command) : 0;
    piece.segment.ends_command = false;
    piece.segment.is_thread = command.op() == Op::Thread ||
                              (command.motion().keeps_feed && command.motion().ignores_hold);
    if (command.op() == Op::Thread && !thread_goes_on)
        piece.segment.thread_start = static_cast<float>(command.motion().thread().start_deg / 360);
    piece.segment.spindle = spindle;
    piece.segment.tool_number = tool_number;
    if (segment.kind == SegmentKind::Feed &&
        command.motion().feed_mode == path::FeedMode::PerRevolution) {
        piece.segment.feed_per_revolution = command.motion().feed * feed_override(command);
    }
    piece.length = length;
    piece.speed = limits.speed;
    piece.acceleration = limits.acceleration;
    piece.jerk = limits.jerk;
    piece.turning_acceleration = limits.turning_acceleration;
    piece.programmed = programmed;
    piece.follows_spindle = how.follows_spindle;
    piece.has_dynamics = static_cast<bool>(command.motion().dynamics);
    if (!options.events.empty()) ask(command, piece);
    piece.entry_limit = how.is_inside ? kInfinity : corner_speed(segment, in, limits.acceleration);
    piece.rates = in;
    piece.loads = axes.loads(segment, in);
    if (how.varying_feed != nullptr) piece.varying_feed = *how.varying_feed;
    take_corner(piece);
    if (thread_goes_on) check_thread_corner(command, piece);
    if (how.as_cell && piece.ramp == 1 && segment.is_transformed()) {
        const double most = segment.kind == SegmentKind::Rapid ? kInfinity : feed;
        const auto cell = cell_on(AxisPolynomials(axes.chain(), segment), axes.bounds(), most);
        piece.is_cell = cell && how.margin > kCornerTicks * tick * cell->speed;
        if (cell) piece.cell = *cell;
    } else if (how.as_cell && piece.ramp == 1) {
        const PathLimits followers = axes.follower_limits(segment, feed);
        const auto cell = cell_of(segment.curve, length, axes.linear_limits(), followers.speed);
        piece.is_cell = cell.has_value();
        if (cell) piece.cell = *cell;
        piece.cell.acceleration = followers.acceleration;
    }
    if (axes.limits_jerk()) {
        piece.entry_acceleration =
            std::min(piece.entry_acceleration, corner_acceleration_limit(in));
        take_bend(piece);
    }
    if (piece.varying_feed.is_on() || std::isfinite(last.exit_feed)) take_varying_feed(piece, in);
    remember(piece);
}

/// What the operator acts on while the piece is run: a thread follows the spindle, and so does a
/// tap.
void Preparer::State::ask(const Command& command, Piece& piece) const {
    piece.can_be_held = command.op() != Op::Thread && !command.motion().ignores_hold;
    if (command.op() == Op::Thread || command.motion().keeps_feed) return;
    const bool is_rapid = piece.segment.kind == SegmentKind::Rapid;
    (is_rapid ? piece.rapid_asked : piece.feed_asked) =
        is_rapid ? piece.programmed : AxisTable::path_speed(piece.segment, piece.programmed);
}

/// The axes cannot follow the spindle: the thread would get another pitch.
void Preparer::State::report_thread_speed(const Command& command, double feed, double most) {
    report(sink, diag::ThreadTooFast, command, options.locate_command)
        .arg(round_to(mm_min_from_feed(feed), 3))
        .arg(round_to(mm_min_from_feed(most), 3))
        .fix("a slower spindle cuts the same thread");
    alarm_raised();
}

/// The path speed that the program asks for, without the operator's override; infinite at rapid.
double Preparer::State::programmed_feed(const Command& command, const Segment& segment,
                                        double length) {
    if (command.op() == Op::Rapid) return kInfinity;
    const auto feed = path_feed(command.motion(), segment, length, spindle, &axes);
    if (feed) return *feed * programmed_override(command);
    const bool no_feed = feed.error() == FeedFault::NoFeed;
    if (reported.first_time(PlanNotice::NoFeed)) {
        report(sink, no_feed ? diag::MotionWithoutFeed : diag::FeedWithoutSpindle, command,
               options.locate_command);
    }
    alarm_raised();
    return kFallbackFeed;
}

double Preparer::State::wanted_feed(const Command& command, const Segment& segment,
                                    double programmed) const {
    // A thread follows the spindle: neither an override nor a limit of the feed acts on it.
    if (command.op() == Op::Thread || command.op() == Op::Rapid) return programmed;
    const double wanted = programmed * (command.motion().keeps_feed ? 1 : options.feed_override);
    return machine.max_feed > 0 && !segment.is_rotary_only ? std::min(wanted, machine.max_feed)
                                                           : wanted;
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
std::deque<IssuedFunction>& Preparer::issued() { return state_->issued; }
const AxisTable::Travel& Preparer::travel() const { return state_->check.travel(); }

}  // namespace kadr::motion
