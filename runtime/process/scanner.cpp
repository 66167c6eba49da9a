#include "process/scanner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "base/diagnostics/machine.h"
#include "base/numbers.h"
#include "base/units.h"
#include "motion/feed.h"

namespace kadr::process {

namespace {

using motion::Segment;
using motion::SegmentKind;
using path::Command;
using path::Op;
using path::Vec3;

constexpr std::size_t kSegmentBatch = 32;

// The rounding of frames; points nearer than a millionth of a millimetre are one.
constexpr double kSamePlace = 1e-6;
// Where a path has its first and its last direction, in parts of it.
constexpr double kEnd = 1e-6;

/// Direction of a path in the plane at a point of its length; zero if it has none there.
Vec2 direction_at(const path::Curve& curve, double place) {
    const Vec2 tangent = path::evaluate(curve, place).tangent.head<2>();
    const double norm = tangent.norm();
    return norm > 0 ? Vec2(tangent / norm) : Vec2(Vec2::Zero());
}

/// "Z", or the first other axis that leaves its position.
std::string moved_axis(const motion::AxesPosition::MotionEnd& target, const Segment& standing,
                       const Vec3& tip, const path::Box& box) {
    if (box.upper.z() - tip.z() > kSamePlace || tip.z() - box.lower.z() > kSamePlace) return "Z";
    for (std::size_t i = 0; i < motion::kFollowers; ++i) {
        if (std::abs(target.followers[i] - standing.follower_start[i]) > kSamePlace)
            return std::string(kAxisNames[i + 3]);
    }
    return {};
}

}  // namespace

// ------------------------------------------------------------------------------ in front

ScannerCommands::ScannerCommands(Stream<Command>& commands, const machine::Machine& machine,
                                 const motion::PlannerOptions& options, DiagnosticSink& sink,
                                 ScanLists& lists)
    : commands_(commands),
      scanner_(*machine.scanner),
      options_(options),
      sink_(sink),
      lists_(lists),
      axes_(machine),
      field_(scanner_),
      builder_(scanner_),
      axes_at_(machine),
      beam_at_(machine) {
    spindle_.machine_limit = machine.max_speed;
    for (const machine::ModuleRow& row : machine.pipeline.modules) {
        if (row.module == machine::kScannerModule) serves_.push_back(row.command);
    }
}

// One pull takes from the stream behind once at most if it puts anything out: an alarm about a
// command has to find the commands behind it not looked at.
std::size_t ScannerCommands::pull(std::span<Command> out) {
    origins_.clear();
    batch_first_ = put_;
    std::size_t written = 0;
    while (written < out.size()) {
        if (!ready_.empty()) {
            out[written++] = std::move(ready_.front());
            ready_.pop_front();
            origins_.push_back(taken_);
            continue;
        }
        if (has_ended_) break;
        if (refusal_) {
            if (written > 0) break;
            refusal_();
            has_ended_ = has_alarmed_ = true;
            break;
        }
        if (batch_at_ == batch_size_) {
            if (written > 0) break;
            batch_at_ = 0;
            batch_size_ = commands_.pull(batch_);
            if (batch_size_ == 0) {
                if (!builder_.is_empty()) put_list(Command{}, builder_.finish());
                has_ended_ = true;
                continue;
            }
        }
        if (take(out[written])) {
            ++written;
            origins_.push_back(taken_);
        }
    }
    put_ += written;
    return written;
}

std::uint64_t ScannerCommands::taken_for(std::uint64_t count) const {
    if (count <= batch_first_ || origins_.empty()) return taken_;
    return origins_[std::min<std::size_t>(count - batch_first_, origins_.size()) - 1];
}

/// The next command of the batch. False: `out` did not get it.
bool ScannerCommands::take(Command& out) {
    Command& command = batch_[batch_at_++];
    ++taken_;
    if (command.op() == Op::ScannerOn) {
        if (!is_on_) switch_on();
        is_lent_ = false;
        return false;
    }
    if (std::ranges::find(serves_, command.op()) != serves_.end() && !is_on_) {
        switch_on();
        is_lent_ = true;
    } else if (is_lent_ && command.is_motion() && !refusal_ &&
               std::ranges::find(serves_, command.op()) == serves_.end()) {
        return_axes(command);
    }
    if (is_on_) {
        scan(command);
        return false;
    }
    if (command.op() == Op::ScannerOff) return false;
    follow(command);
    if (!ready_.empty()) {  // behind the list that was closed for it
        ready_.push_back(std::move(command));
        return false;
    }
    out = std::move(command);
    return true;
}

/// The axes' own command, as the planner will take it.
void ScannerCommands::follow(const Command& command) {
    if (command.is_motion())
        axes_at_.arrive(command.motion(), axes_at_.target_of(command.motion()));
    if (command.op() == Op::ToolLength) axes_at_.set_tool_length(command.tool_length(), axes_);
    follow_spindle(command);
}

void ScannerCommands::follow_spindle(const Command& command) {
    if (command.op() == Op::SpeedLimit) {
        spindle_.limit = speed_from_rpm(command.speed_limit().most);
        spindle_.least = speed_from_rpm(command.speed_limit().least);
    }
    if (command.op() != Op::Spindle) return;
    const path::Spindle& wanted = command.spindle();
    spindle_.is_turning = wanted.mode != path::SpindleMode::Stop &&
                          wanted.mode != path::SpindleMode::Orient && wanted.speed > 0;
    spindle_.holds_cutting_speed = wanted.has_cutting_speed;
    if (wanted.has_cutting_speed) spindle_.cutting_speed = feed_from_mm_min(wanted.speed * 1000);
    else spindle_.speed = speed_from_rpm(wanted.speed);
}

/// The axes' next motion goes from where the stage stands to its own end.
void ScannerCommands::return_axes(const Command& command) {
    if (!builder_.is_empty()) put_list(command, builder_.finish());
    is_on_ = is_lent_ = false;
}

void ScannerCommands::switch_on() {
    is_on_ = true;
    beam_at_ = axes_at_;
}

void ScannerCommands::switch_off(const Command& command) {
    const double away = (beam_at_.tip() - axes_at_.tip()).norm();
    if (away > kSamePlace) {
        refuse([this, command, away] {
            motion::report(sink_, diag::ScannerAway, command, options_.locate_command)
                .arg(round_to(away, 6))
                .fix("jump to the position where the scanner was switched on");
        });
    }
    if (!builder_.is_empty()) put_list(command, builder_.finish());
    is_on_ = false;
}

/// A command while the scanner is on.
void ScannerCommands::scan(const Command& command) {
    switch (command.op()) {
        case Op::Rapid:
        case Op::Line:
        case Op::Arc:
        case Op::Spline:
        case Op::Involute:
        case Op::Parametric: scan_path(command); break;
        case Op::Dwell: scan_dwell(command); break;
        case Op::Thread: refuse_busy(command, "a thread"); break;
        case Op::Probe: refuse_busy(command, "probing"); break;
        case Op::Tool: refuse_busy(command, "another tool"); break;
        case Op::ToolLength: refuse_busy(command, "a tool length"); break;
        case Op::ScannerOn: break;
        case Op::ScannerOff: switch_off(command); break;
        case Op::Spindle:
        case Op::OtherSpindle:
        case Op::SpeedLimit:
        case Op::Coolant:
        case Op::Function:
        case Op::Stop:
        case Op::OptionalStop:
        case Op::Message:
        case Op::End:
        case Op::External:
            if (!builder_.is_empty()) put_list(command, builder_.finish());
            follow_spindle(command);
            ready_.push_back(command);
            break;
    }
    if (refusal_ && !builder_.is_empty()) put_list(command, builder_.finish());
    if (builder_.size() >= scanner_.list_size) put_list(command, builder_.cut());
}

void ScannerCommands::scan_path(const Command& command) {
    if (command.motion().machine_coordinates)
        return refuse_busy(command, "a position in machine coordinates");
    const motion::AxesPosition::MotionEnd target = beam_at_.target_of(command.motion());
    ScanMotion motion;
    motion.segment = still(command);
    const double length = beam_at_.lay_path(command.motion(), target, motion.segment);
    if (!require_own_axes(command, motion.segment, target)) return;
    beam_at_.arrive(command.motion(), target);
    if (!(length > 0)) return;
    const path::Curve& curve = motion.segment.curve;
    motion.first_direction = direction_at(curve, kEnd * length);
    motion.last_direction = direction_at(curve, (1 - kEnd) * length);
    if (command.op() != Op::Rapid) return mark(command, std::move(motion), length);
    motion.segment.kind = SegmentKind::Jump;
    motion.segment.feed = scanner_.jump_speed;
    motion.vectors = {field_.end_of(curve, axes_at_.tip())};
    const Vec2 from = field_.field_of(path::start(curve), axes_at_.tip());
    motion.duration = (motion.vectors.front().field - from).norm() / scanner_.jump_speed;
    put_motion(command, std::move(motion), 0);
}

void ScannerCommands::mark(const Command& command, ScanMotion motion, double length) {
    const auto feed = motion::path_feed(command.motion(), motion.segment, length, spindle_);
    if (!feed) {
        const bool no_feed = feed.error() == motion::FeedFault::NoFeed;
        return refuse([this, command, no_feed] {
            motion::report(sink_, no_feed ? diag::MotionWithoutFeed : diag::FeedWithoutSpindle,
                           command, options_.locate_command);
        });
    }
    const double speed = std::min(*feed, scanner_.mark_speed);
    motion.segment.kind = SegmentKind::Mark;
    motion.segment.feed = *feed;
    motion.vectors = field_.vectors(motion.segment.curve, axes_at_.tip());
    motion.duration = length / speed;
    put_motion(command, std::move(motion), speed);
}

void ScannerCommands::put_motion(const Command& command, ScanMotion motion, double speed) {
    for (const FieldStep& step : motion.vectors) {
        const double outside = field_.outside(step.field);
        if (outside == 0) continue;
        const Vec3 point =
            path::position(motion.segment.curve, step.share * path::length(motion.segment.curve));
        return refuse([this, command, point, outside] {
            motion::report(sink_, diag::ScannerField, command, options_.locate_command)
                .arg(round_to(point.x(), 3))
                .arg(round_to(point.y(), 3))
                .arg(round_to(outside, 3));
        });
    }
    builder_.add(std::move(motion), speed);
}

void ScannerCommands::scan_dwell(const Command& command) {
    double time = command.dwell().time;
    if (command.dwell().revolutions > 0) {
        const double turns = spindle_.speed_at(axes_at_.tip()[0]);
        if (!(turns > 0)) {
            return refuse([this, command] {
                motion::report(sink_, diag::DwellWithoutSpindle, command, options_.locate_command)
                    .arg(command.dwell().revolutions);
            });
        }
        time = command.dwell().revolutions / turns;
    }
    builder_.stand(still(command), time, spindle_.is_turning);
}

/// The beam where it is, nothing moving.
Segment ScannerCommands::still(const Command& command) const {
    Segment segment = beam_at_.still();
    segment.kind = SegmentKind::External;
    segment.line = command.line;
    segment.cycle = command.cycle;
    segment.source = command.source;
    return segment;
}

/// No axis may move that is not the scanner's.
Done ScannerCommands::require_own_axes(const Command& command, const Segment& segment,
                                       const motion::AxesPosition::MotionEnd& target) {
    const std::string axis =
        moved_axis(target, segment, beam_at_.tip(), path::bounds(segment.curve));
    if (axis.empty()) return kDone;
    refuse([this, command, axis] {
        motion::report(sink_, diag::ScannerAxis, command, options_.locate_command).arg(axis);
    });
    return kFailed;
}

void ScannerCommands::refuse_busy(const Command& command, const char* what) {
    refuse([this, command, what] {
        motion::report(sink_, diag::ScannerBusy, command, options_.locate_command).arg(what);
    });
}

/// The axes stand while a list runs.
void ScannerCommands::put_list(const Command& command, ScanList list) {
    if (!(list.duration > 0)) return;
    Command standing(Op::External);
    standing.external().time = list.duration;
    standing.line = list.pieces.empty() ? command.line : list.pieces.front().line;
    standing.source = list.pieces.empty() ? command.source : list.pieces.front().source;
    lists_.push_back(std::move(list));
    ready_.push_back(std::move(standing));
}

// ------------------------------------------------------------------------------ behind

ScannerSegments::ScannerSegments(Stream<Segment>& planned, ScanLists& lists, Look look)
    : planned_(planned), lists_(lists), look_(std::move(look)), batch_(kSegmentBatch) {}

std::size_t ScannerSegments::pull(std::span<Segment> out) {
    std::size_t written = 0;
    while (written < out.size() && next(out[written])) ++written;
    return written;
}

bool ScannerSegments::next(Segment& out) {
    if (list_at_ == list_.pieces.size()) {
        if (batch_at_ == batch_size_) {
            batch_at_ = 0;
            batch_size_ = planned_.pull(batch_);
            if (batch_size_ == 0) return false;
        }
        const Segment& segment = batch_[batch_at_++];
        if (segment.kind != SegmentKind::External || lists_.empty()) {
            out = segment;
            return true;
        }
        begin(segment);
    }
    Segment& piece = list_.pieces[list_at_++];
    piece.start_time += standing_.start_time;
    piece.stage = path::start(standing_.curve);
    piece.spindle = standing_.spindle;
    record(piece);
    out = piece;
    return true;
}

void ScannerSegments::begin(const Segment& standing) {
    standing_ = standing;
    list_ = std::move(lists_.front());
    lists_.pop_front();
    list_at_ = 0;
    KADR_ASSERT(!list_.pieces.empty(), "a list that lasts has pieces");
    ++figures_.lists;
    figures_.time += list_.duration;
    if (look_) look_({list_, standing.start_time, path::start(standing.curve)});
}

void ScannerSegments::record(const Segment& piece) {
    figures_.pulses += piece.train.count;
    const double length = path::arc_length(piece.curve);
    if (piece.kind == SegmentKind::Jump) {
        ++figures_.jumps;
        figures_.jump_time += piece.duration;
        figures_.jump_length += length;
    }
    if (piece.kind == SegmentKind::Mark) {
        ++figures_.marks;
        figures_.mark_time += piece.duration;
        figures_.mark_length += length;
    }
}

}  // namespace kadr::process
