#include "process/scan_list.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace kadr::process {

namespace {

using motion::Segment;
using motion::SegmentKind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A piece counts no more, however long it dwells.
constexpr double kMostPulses = 4e9;
// Of a step or a pulse period: less is rounding.
constexpr double kRounding = 1e-6;

/// The polygon delay in parts of the full one; 0 straight on, 1 at a turning back.
double turning_share(const Vec2& before, const Vec2& behind) {
    return std::clamp((1 - before.dot(behind)) / 2, 0.0, 1.0);
}

}  // namespace

double ScanListBuilder::whole_steps(double time) const {
    return std::ceil(time / scanner_.step - kRounding) * scanner_.step;
}

void ScanListBuilder::add(ScanMotion motion, double speed) {
    const bool is_mark = motion.segment.kind == SegmentKind::Mark;
    write_waiting(is_mark ? Next::Mark : Next::Other, motion.first_direction);
    waiting_ = Waiting{std::move(motion), speed};
}

void ScanListBuilder::stand(const Segment& segment, double time, bool is_exposing) {
    write_waiting(Next::Other, Vec2::Zero());
    const double duration = whole_steps(time);
    if (!(duration > 0)) return;
    list_.commands.push_back({is_exposing ? ScanCommand::Kind::Expose : ScanCommand::Kind::Wait,
                              Vec2::Zero(), duration, segment.line});
    if (is_exposing) open_beam(list_.duration);
    put_piece(segment, duration, kInfinity);
    is_beam_on_ = false;
}

ScanList ScanListBuilder::cut() {
    ScanList list = std::move(list_);
    list_ = {};
    next_pulse_ -= list.duration;
    speed_ = 0;  // every list sets its own
    return list;
}

ScanList ScanListBuilder::finish() {
    write_waiting(Next::Other, Vec2::Zero());
    return cut();
}

/// Writes the motion down that waits, and the delay between it and the next one.
void ScanListBuilder::write_waiting(Next next, const Vec2& direction) {
    const machine::ScannerDelays& delays = scanner_.delays;
    if (!waiting_) {
        // No jump in front whose delay the beam could use: it comes with the motion.
        if (next == Next::Mark && delays.laser_on < 0 && !is_beam_on_) open_beam(list_.duration);
        return;
    }
    const Waiting waiting = std::move(*waiting_);
    waiting_.reset();
    write_motion(waiting);
    const Segment& segment = waiting.motion.segment;
    if (segment.kind == SegmentKind::Jump) {
        const double delay = whole_steps(delays.jump);
        if (next == Next::Mark && delays.laser_on < 0)
            open_beam(list_.duration + delay + delays.laser_on);
        write_delay(segment, delay, kInfinity);
    } else if (next == Next::Mark) {
        const double share =
            delays.polygon_turning ? turning_share(waiting.motion.last_direction, direction) : 1;
        write_delay(segment, whole_steps(share * delays.polygon), kInfinity);
    } else {
        write_delay(segment, whole_steps(delays.mark), list_.duration + delays.laser_off);
        is_beam_on_ = false;
    }
}

void ScanListBuilder::write_motion(const Waiting& waiting) {
    const ScanMotion& motion = waiting.motion;
    Segment piece = motion.segment;
    const bool is_mark = piece.kind == SegmentKind::Mark;
    if (is_mark && waiting.speed != speed_) {
        list_.commands.push_back(
            {ScanCommand::Kind::MarkSpeed, Vec2::Zero(), waiting.speed, piece.line});
        speed_ = waiting.speed;
    }
    const double duration = std::max(whole_steps(motion.duration), scanner_.step);
    double before = 0;
    for (const FieldStep& step : motion.vectors) {
        const bool is_last = &step == &motion.vectors.back();
        const auto kind = !is_mark  ? ScanCommand::Kind::Jump
                          : is_last ? ScanCommand::Kind::Mark
                                    : ScanCommand::Kind::Micro;
        list_.commands.push_back({kind, step.to, (step.share - before) * duration, piece.line});
        before = step.share;
    }
    if (is_mark && !is_beam_on_)
        open_beam(list_.duration + std::max(0.0, scanner_.delays.laser_on));
    const double length = path::length(piece.curve);
    const double speed = length / duration;
    piece.profile = {};
    piece.profile.length = length;
    piece.profile.entry_speed = piece.profile.peak_speed = piece.profile.exit_speed = speed;
    piece.profile.cruising = duration;
    put_piece(std::move(piece), duration, kInfinity);
}

void ScanListBuilder::write_delay(const Segment& behind, double time, double beam_off) {
    if (!(time > 0)) return;
    Segment piece = behind;
    piece.kind = SegmentKind::External;
    piece.curve = path::Point{path::end(behind.curve)};
    piece.profile = {};
    piece.feed = 0;
    put_piece(std::move(piece), time, beam_off);
}

/// `beam_off`: when the beam goes, from the list's start.
void ScanListBuilder::put_piece(Segment piece, double duration, double beam_off) {
    piece.start_time = list_.duration;
    piece.duration = duration;
    list_.duration += duration;
    piece.train = {};
    const double end = std::min(list_.duration, beam_off);
    if (is_beam_on_ && scanner_.pulse > 0 && next_pulse_ < end) {
        const double period = 1 / scanner_.pulse;
        const double count =
            std::min(std::ceil((end - next_pulse_) / period - kRounding), kMostPulses);
        piece.train = {static_cast<std::uint32_t>(count), next_pulse_ - piece.start_time, period};
        next_pulse_ += count * period;
    }
    list_.pieces.push_back(std::move(piece));
}

void ScanListBuilder::open_beam(double time) {
    is_beam_on_ = true;
    next_pulse_ = time;
}

}  // namespace kadr::process
