#include "process/drive_run.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace kadr::process {

namespace {

using motion::Segment;
using motion::SegmentKind;
using path::Vec3;

constexpr double kTurn = 2 * std::numbers::pi;

// "Speed reached" of a spindle, as controls have it before a first cut.
constexpr double kReached = 0.05;
// After this time, and so many times what was planned, a spindle does not get there any more.
constexpr double kPatience = 10;  // s
constexpr double kPatienceTimes = 20;
// A plan that stays below its feed is limited by the axes, not by the spindle.
constexpr double kLimited = 1 - 1e-6;
// Closer to the end of a path that ends at rest nothing is left to go, mm.
constexpr double kArrived = 1e-7;

}  // namespace

DriveRun::DriveRun(const machine::Machine& machine, double period, Look look)
    : drives_(machine.drives.value_or(machine::Drives{})), look_(std::move(look)) {
    per_sample_ = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(std::ceil(period / longest_step(drives_))));
    step_ = period / static_cast<double>(per_sample_);
}

void DriveRun::add(const Segment& segment) {
    if (has_stalled_) return;
    if (!has_begun_) begin(segment);
    line_ = segment.line;
    const bool moves = motion::is_motion(segment.kind) && !segment.is_rotary_only;
    const bool is_cut = segment.kind == SegmentKind::Feed;
    const bool begins_cut = moves && is_cut && !was_cutting_;
    if (begins_cut) side_ = radius() < 0 ? -1 : 1;
    set_spindle(segment);
    was_cutting_ = moves && is_cut;
    if (!moves) {
        stand(segment.duration);
        return;
    }
    if (begins_cut && segment.feed_per_revolution > 0) wait_for_speed();
    if (!has_stalled_) walk(segment);
}

void DriveRun::begin(const Segment& segment) {
    point_ = path::start(segment.curve);
    for (std::size_t i = 0; i < axes_.size(); ++i) axes_[i].position = point_[static_cast<int>(i)];
    has_begun_ = true;
    show();
}

void DriveRun::set_spindle(const Segment& segment) {
    const motion::CommandedSpindle& to = segment.spindle;
    const bool is_new = to.is_turning != commanded_.is_turning ||
                        to.holds_cutting_speed != commanded_.holds_cutting_speed ||
                        to.cutting_speed != commanded_.cutting_speed ||
                        to.speed != commanded_.speed || to.limit != commanded_.limit ||
                        to.least != commanded_.least;
    commanded_ = to;
    follows_radius_ = to.is_turning && to.holds_cutting_speed && segment.kind == SegmentKind::Feed;
    if (is_new || follows_radius_) wanted_ = kTurn * to.speed_at(radius());
}

void DriveRun::stand(double duration) {
    const auto count = static_cast<std::int64_t>(std::llround(duration / step_));
    for (std::int64_t i = 0; i < count; ++i) step(nullptr, point_, Vec3::Zero());
}

void DriveRun::wait_for_speed() {
    const auto most = static_cast<std::int64_t>(kPatience / step_);
    for (std::int64_t i = 0; i < most; ++i) {
        if (std::abs(spindle_.speed - wanted_) <= kReached * wanted_) return;
        along_ = rest_ = 0;
        step(nullptr, point_, Vec3::Zero());
    }
    has_stalled_ = true;
}

/// What the program asks for at the real speed of the spindle.
double DriveRun::asked_feed(const Segment& segment) const {
    if (segment.feed_per_revolution == 0) return segment.feed;
    return segment.feed_per_revolution * spindle_.speed / kTurn;
}

double DriveRun::feed() const {
    return std::hypot(axes_[0].velocity, axes_[1].velocity, axes_[2].velocity);
}

/// The path speed that the command goes for; corners and ends are the caller's matter.
double DriveRun::target_speed(const Segment& segment) const {
    if (segment.kind == SegmentKind::Rapid) return segment.profile.peak_speed;
    const double asked = asked_feed(segment);
    const bool is_limited = segment.profile.peak_speed < segment.feed * kLimited;
    return is_limited ? std::min(asked, segment.profile.peak_speed) : asked;
}

void DriveRun::walk(const Segment& segment) {
    const motion::Profile& plan = segment.profile;
    const double length = plan.length;
    // The tip jumps where another tool length begins to act; the axes do not.
    const Vec3 jump = path::start(segment.curve) - point_;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        axes_[i].position += jump[static_cast<int>(i)];
    }
    const bool ends_at_rest = plan.exit_speed == 0;
    const double most = kPatience + kPatienceTimes * segment.duration;
    double at = std::min(rest_, length);
    double time = 0;
    rest_ = 0;
    while (true) {
        const double left = length - at;
        const double change = plan.acceleration * step_;
        along_ += std::clamp(target_speed(segment) - along_, -change, change);
        if (plan.braking > 0) {
            const double most_here = std::sqrt(plan.exit_speed * plan.exit_speed +
                                               2 * plan.deceleration * std::max(0.0, left));
            along_ = std::min(along_, most_here);
        }
        at += along_ * step_;
        const bool is_over = at >= length - (ends_at_rest ? kArrived : 0);
        if (is_over && ends_at_rest) {
            at = length;
            along_ = 0;
        }
        const path::CurvePoint point = path::evaluate(segment.curve, std::min(at, length));
        step(&segment, point.position, along_ * point.tangent);
        if (is_over) break;
        time += step_;
        if (time > most) {
            has_stalled_ = true;
            return;
        }
    }
    rest_ = at - length;
}

/// One step of both drives, with the command of the axes at `point`; null: nothing is run.
void DriveRun::step(const Segment* segment, const Vec3& point, const Vec3& velocity) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        const int k = static_cast<int>(i);
        axes_[i] = advanced(drives_.feed, axes_[i], {point[k], velocity[k]}, step_);
    }
    point_ = point;
    if (segment != nullptr && follows_radius_) wanted_ = kTurn * commanded_.speed_at(radius());
    load_ = segment != nullptr ? load(*segment) : 0;
    spindle_ = advanced(drives_.spindle, spindle_, wanted_, load_, step_);
    if (++steps_ % per_sample_ == 0) show();
}

/// Torque of the cut: the force follows the thickness of the chip, and that the real feed. Behind
/// the centre there is nothing left to cut.
double DriveRun::load(const Segment& segment) const {
    if (segment.kind != SegmentKind::Feed || radius() * side_ <= 0) return 0;
    const double asked = asked_feed(segment);
    if (!(asked > 0)) return 0;
    return drives_.cutting_force * std::abs(radius()) / 1000 * std::min(1.0, feed() / asked);
}

void DriveRun::show() {
    DriveSample sample;
    sample.time = static_cast<double>(steps_) * step_;
    sample.tip = {axes_[0].position, axes_[1].position, axes_[2].position};
    sample.wanted_speed = wanted_;
    sample.speed = spindle_.speed;
    sample.current = spindle_.current;
    sample.load = load_;
    sample.feed = feed();
    sample.line = line_;
    look_(sample);
}

}  // namespace kadr::process
