// feed_spindle.cpp — feed, cutting speed and spindle, with their limits; coolant.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/diagnostics/iso.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/spindles.h"
#include "interp/stages.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::Slot;
using path::Command;
using path::Op;
using path::SpindleMode;

void Spindles::program_speed(const Block& block) {
    (spindle_.has_cutting_speed ? spindle_.cutting_speed : spindle_.speed) = block.at(Slot::Speed);
}

void Spindles::leave_cutting_speed() {
    if (!spindle_.has_cutting_speed) return;
    spindle_.has_cutting_speed = false;
    const double speed = turning_speed();
    if (std::isfinite(speed)) spindle_.speed = speed;  // in the centre without a limit: as before
}

double Spindles::turning_speed() const {
    const double diameter = 2 * std::abs(position_.here()[index(Axis::X)]);
    const double most = machine_.max_speed_of(spindle_.number);
    double highest = most > 0 ? rpm_from_speed(most) : std::numeric_limits<double>::infinity();
    if (highest_speed() > 0) highest = std::min(highest, highest_speed());
    const double mm_min = 1000 * spindle_.cutting_speed;
    return std::min(std::max(mm_min / (std::numbers::pi * diameter), spindle_.least), highest);
}

void Spindles::limit_speed(const Block& block, Function function, double limit) {
    if (!(limit > 0)) {
        reporter_.report(diag::SpeedLimitInvalid, block, function).arg(limit);
        return;
    }
    const SpeedLimits before = speed_limits();
    spindle_.limit = limit;
    put_speed_limits(block, before);
}

double Spindles::highest_speed() const {
    if (spindle_.limit == 0 || spindle_.most == 0) return std::max(spindle_.limit, spindle_.most);
    return std::min(spindle_.limit, spindle_.most);
}

/// What bounds the spindle under constant cutting speed.
SpeedLimits Spindles::speed_limits() const { return {spindle_.least, highest_speed()}; }

/// A command where a function of the block has changed the bounds.
void Spindles::put_speed_limits(const Block& block, const SpeedLimits& before) {
    const SpeedLimits now = speed_limits();
    // Of another spindle it matters when that is the master.
    if (now == before || is_master_away_) return;
    path::SpeedLimit& limit = channel_.stages.put(Op::SpeedLimit, block).speed_limit();
    limit.most = now.most;
    limit.least = now.least;
}

void Spindles::bound_speed(const Block& block, Function function, bool is_upper, double bound) {
    if (bound < 0 || (is_upper && bound == 0)) {
        reporter_.report(diag::SpeedLimitInvalid, block, function).arg(bound);
        return;
    }
    const SpeedLimits before = speed_limits();
    (is_upper ? spindle_.most : spindle_.least) = bound;
    put_speed_limits(block, before);
}

/// The programmed speed within the bounds of the spindle, rpm; reported once of each speed.
double Spindles::bounded_speed(const Block& block) {
    const double wanted = spindle_.speed;
    if (!(wanted > 0)) return wanted;
    double speed = std::max(wanted, spindle_.least);
    if (spindle_.most > 0) speed = std::min(speed, spindle_.most);
    if (speed != wanted && reported_.first_time_of_bound(wanted))
        reporter_.report(diag::SpeedBounded, block).arg(wanted).arg(speed);
    return speed;
}

void Spindles::update_spindle(const Block& block) {
    owe_speed(false);
    const bool runs = is_running(spindle_.mode);
    const bool is_bounded = runs && !spindle_.has_cutting_speed;
    const double speed = spindle_.has_cutting_speed ? spindle_.cutting_speed
                         : is_bounded               ? bounded_speed(block)
                                                    : spindle_.speed;
    const ProgrammedSpindle::Commanded now{spindle_.mode, runs ? speed : 0,
                                           runs && spindle_.has_cutting_speed};
    if (now == spindle_.commanded) return;
    if (runs && !(speed > 0)) reporter_.report(diag::SpindleWithoutSpeed, block);
    spindle_.commanded = now;
    path::Spindle& spindle = put_spindle(block);
    spindle.mode = now.mode;
    spindle.speed = now.speed;
    spindle.has_cutting_speed = now.has_cutting_speed;
    spindle.angle_deg = 0;
}

void Spindles::orient_spindle(const Block& block, const Invocation& invocation) {
    constexpr std::size_t kAngle = parameter_of<Function::SpindleOrient>("angle");
    constexpr std::size_t kBy = parameter_of<Function::SpindleOrient>("by");
    const bool is_by = invocation.has(kBy);
    stand_spindle(block, invocation.function, block.argument(invocation, is_by ? kBy : kAngle),
                  is_by);
}

/// is_by  the angle counts from where the spindle stands
void Spindles::stand_spindle(const Block& block, Function function, double angle, bool is_by) {
    if (is_by) {
        if (spindle_.mode != SpindleMode::Orient) {
            reporter_.report(diag::SpindleAngleUnknown, block, function);
            return;
        }
        angle = std::fmod(spindle_.angle_deg + angle, 360);
        if (angle < 0) angle += 360;
    }
    if (block.is_of_cycle() && !block.context->taps) check_edge_turns(block);
    spindle_.angle_deg = angle;
    turn(SpindleMode::Orient);
    spindle_.commanded = {SpindleMode::Orient, 0, false};
    path::Spindle& spindle = put_spindle(block);
    spindle.mode = SpindleMode::Orient;
    spindle.speed = 0;
    spindle.has_cutting_speed = false;
    spindle.angle_deg = angle;
}

/// A boring cycle is about to take the edge off the wall.
void Spindles::check_edge_turns(const Block& block) {
    const path::Vec3 across = path::unit(path::axes_of(modal_.plane).first);
    const path::Vec3 turned = frames_.total().direction(across).normalized();
    constexpr double kTurned = 1e-6;
    if ((turned - across).norm() < kTurned && !frames_.is_mirrored(modal_.plane)) return;
    if (!reported_.first_time(RunNotice::TurnedEdge)) return;
    reporter_.report(diag::EdgeNotTurned, block)
        .arg(frames_.is_mirrored(modal_.plane) ? "mirrored" : "turned");
}

}  // namespace kadr::interp
