// numbered_spindles.cpp — machines with several spindles: which of them is the master, and words
// that name a spindle by its number.
//
// `spindle_` is the master. Whatever a word does to another one it does as to the master, while
// both have been exchanged. source: SINUMERIK reference 2.3, 3.2, 4.10
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/diagnostics/control.h"
#include "base/diagnostics/iso.h"
#include "interp/block_words.h"
#include "interp/channel.h"
#include "interp/spindles.h"
#include "interp/stages.h"
#include "nc/parameters.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;
using nc::Invocation;
using nc::parameter_of;
using nc::parameter_of_all;
using path::Command;
using path::Op;
using path::SpindleMode;

namespace {

/// The number of the spindle, in all functions that name one beside what they program for it.
constexpr std::size_t kSpindle =
    parameter_of_all<"spindle", Function::SpindleSpeed, Function::SpindleTurn,
                     Function::SpindleStand, Function::SpindleLimit, Function::SpindleBound,
                     Function::SpindleDwell>();

/// Whether a word of the block tells how the spindle with this number turns.
bool names_spindle(const Block& block, std::int64_t number) {
    const auto end = block.functions.begin() + block.function_count;
    return std::any_of(block.functions.begin(), end, [&](const Invocation& invocation) {
        return nc::has_fact(invocation.function, nc::Fact::TurnsNumbered) &&
               count_of(block, invocation, kSpindle) == number;
    });
}

}  // namespace

Spindles::Spindles(Channel& channel)
    : channel_(channel),
      machine_(channel.state.machine),
      reporter_(channel.state.reporter),
      modal_(channel.state.motion.modal),
      position_(channel.state.motion.position),
      frames_(channel.state.frame.frames),
      spindle_(channel.state.spindle.spindle),
      other_spindles_(channel.state.spindle.other_spindles),
      owes_speed_(channel.state.spindle.owes_speed),
      reported_(channel.state.reported) {}

void Spindles::set_up_spindles() {
    for (const machine::MachineSpindle& spindle : machine_.spindles)
        other_spindles_.emplace_back().number = spindle.number;
}

const ProgrammedSpindle* Spindles::spindle_at(std::int64_t number) const {
    if (number == 0 || number == spindle_.number) return &spindle_;
    const auto found = std::ranges::find(other_spindles_, number, &ProgrammedSpindle::number);
    return found == other_spindles_.end() ? nullptr : &*found;
}

bool Spindles::has_spindle(std::int64_t number) const { return spindle_at(number) != nullptr; }

/// Does `act` to the spindle that the invocation names; a number that the machine does not have is
/// reported.
template <typename Act>
void Spindles::with_spindle(const Block& block, const Invocation& invocation, Act act) {
    const std::int64_t number = count_of(block, invocation, kSpindle);
    if (number == spindle_.number) return act();
    const auto other = std::ranges::find(other_spindles_, number, &ProgrammedSpindle::number);
    if (other == other_spindles_.end()) {
        reporter_.report(diag::SpindleMissing, block, invocation.function).arg(number);
        return;
    }
    const bool owed = owes_speed_;
    std::swap(spindle_, *other);
    is_master_away_ = true;
    act();
    is_master_away_ = false;
    std::swap(spindle_, *other);
    owe_speed(owed);
}

/// What the motion side is given for the spindle whose turn it is.
path::Spindle& Spindles::put_spindle(const Block& block) {
    const Op op = is_master_away_ ? Op::OtherSpindle : Op::Spindle;
    path::Spindle& spindle = channel_.stages.put(op, block).spindle();
    spindle.number = shown_number();
    return spindle;
}

std::uint8_t Spindles::shown_number() const {
    return other_spindles_.empty() ? 0 : static_cast<std::uint8_t>(spindle_.number);
}

void Spindles::select_master(const Block& block, const Invocation& invocation) {
    const std::int64_t number = std::llround(
        block.argument(invocation, parameter_of<Function::MasterSpindle>("spindle"), 1));
    if (number == spindle_.number) return;
    const auto other = std::ranges::find(other_spindles_, number, &ProgrammedSpindle::number);
    if (other == other_spindles_.end()) {
        reporter_.report(diag::SpindleMissing, block, invocation.function).arg(number);
        return;
    }
    if (spindle_.has_cutting_speed) {
        // Which spindle would hold the cutting speed from here on is not known (unsure).
        reporter_.report(diag::MasterUnderCuttingSpeed, block, invocation.function).arg(number);
        return;
    }
    const SpeedLimits limits = speed_limits();
    std::swap(spindle_, *other);
    reported_.renew_spindle();
    reported_.exchange_bound(spindle_.speed);  // of which was reported when it was programmed
    path::Spindle& spindle = put_spindle(block);
    // One that stands at an angle does not go there again.
    const bool runs = is_running(spindle_.mode);
    spindle.mode = runs ? spindle_.mode : SpindleMode::Stop;
    spindle.speed = runs ? spindle_.commanded.speed : 0;
    spindle.has_cutting_speed = false;
    spindle.angle_deg = 0;
    put_speed_limits(block, limits);
}

void Spindles::act_on_spindle(const Block& block, const Invocation& invocation) {
    with_spindle(block, invocation, [&] {
        switch (invocation.function) {
            case Function::SpindleSpeed: {
                const double speed =
                    block.argument(invocation, parameter_of<Function::SpindleSpeed>("speed"));
                (spindle_.has_cutting_speed ? spindle_.cutting_speed : spindle_.speed) = speed;
                break;
            }
            case Function::SpindleTurn:
                turn(sense_by_code(
                    count_of(block, invocation, parameter_of<Function::SpindleTurn>("sense"))));
                break;
            case Function::SpindleLimit:
                limit_speed(
                    block, invocation.function,
                    block.argument(invocation, parameter_of<Function::SpindleLimit>("limit")));
                break;
            case Function::SpindleBound:
                bound_speed(
                    block, invocation.function,
                    block.argument(invocation, parameter_of<Function::SpindleBound>("upper")) != 0,
                    block.argument(invocation, parameter_of<Function::SpindleBound>("speed")));
                break;
            default: break;
        }
    });
}

void Spindles::update_other_spindles(const Block& block) {
    for (ProgrammedSpindle& other : other_spindles_) {
        if (!names_spindle(block, other.number)) continue;
        const double warned = reported_.exchange_bound(0);
        std::swap(spindle_, other);
        is_master_away_ = true;
        update_spindle(block);
        is_master_away_ = false;
        std::swap(spindle_, other);
        reported_.exchange_bound(warned);
    }
    for (std::size_t i = 0; i < block.function_count && !reporter_.has_ended(); ++i) {
        const Invocation& invocation = block.functions[i];
        if (invocation.function != Function::SpindleStand) continue;
        constexpr std::size_t kAngle = parameter_of<Function::SpindleStand>("angle");
        constexpr std::size_t kBy = parameter_of<Function::SpindleStand>("by");
        with_spindle(block, invocation, [&] {
            const bool is_by = invocation.has(kBy);
            stand_spindle(block, invocation.function,
                          block.argument(invocation, is_by ? kBy : kAngle), is_by);
        });
    }
}

void Spindles::dwell_by_spindle(const Block& block, const Invocation& invocation) {
    with_spindle(block, invocation, [&] {
        const double revolutions =
            block.argument(invocation, parameter_of<Function::SpindleDwell>("revolutions"));
        const double speed =
            spindle_.has_cutting_speed ? turning_speed() : spindle_.commanded.speed;
        const bool turns = is_running(spindle_.mode) && speed > 0;
        if (revolutions < 0 || !turns) {
            reporter_.report(diag::DwellInvalid, block, invocation.function)
                .arg(revolutions < 0 ? "it is negative" : "the spindle stands");
            return;
        }
        if (revolutions > 0)
            channel_.stages.put(Op::Dwell, block).dwell().time = revolutions / speed * 60;
    });
}

}  // namespace kadr::interp
