// orienting.cpp — tool centre point control and the tool's direction, in the words that the target
// has for them.
//
// Some controls switch it by functions of its own and take vectors under it (SINUMERIK, AxiOMA); to
// others it is a kind of tool length compensation (FANUC's G43.5), inside of which they take
// little. The language is the same for both: directions are those of the workpiece, and switching
// moves no axis.
#include "expand/orienting.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics/expand.h"
#include "base/numbers.h"
#include "expand/blocks.h"
#include "expand/faults.h"
#include "expand/frame_blocks.h"
#include "expand/running.h"
#include "expand/scopes.h"
#include "expand/unknown.h"
#include "nc/tables.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using path::Vec3;

namespace {

ToolTaken tool_taken(Done done) { return done ? ToolTaken::Done : ToolTaken::Failed; }

std::optional<double> length_number(const Running& run);
Done begin_tcp(Running& run, std::span<const nc::Invocation> said, SourceId source,
               std::uint32_t at, unsigned depth);
void say_offset_again(Running& run, SourceId source, std::uint32_t at, unsigned depth);
Done choose_orient_interpolation(Running& run, nc::Function orientation, SourceId source,
                                 std::uint32_t at, unsigned depth);
Done end_tcp(Running& run, SourceId source, std::uint32_t at, unsigned depth);
Done require_leading_tool(Running& run, std::uint32_t at);

/// Digits behind the point of a unit vector that hold a direction to 1e-7 rad, a tenth of what a
/// millimetre is off at the end of a long tool.
constexpr int kDirectionDigits = 7;

/// Controls have nine digits.
constexpr double kMostDigits = 1e9;

/// Components of a unit vector that are nothing but rounding.
constexpr double kNoComponent = 1e-12;

constexpr AxisMask kRotary = bit(Axis::A) | bit(Axis::B) | bit(Axis::C);

bool names_rotary(const sema::Plan& plan) {
    const auto is_rotary = [](std::size_t slot) {
        return slot < kAxes && (kRotary >> slot & 1u) != 0;
    };
    return (plan.given & kRotary) != 0 ||
           std::ranges::any_of(plan.fillings, [&](const sema::Filling& filling) {
               return !filling.is_argument && is_rotary(filling.index);
           });
}

/// Digits behind the point that the control writes of a direction.
int digits_of(const nc::DialectTables& tables) {
    for (const nc::FormId id : tables.forms_of[static_cast<std::size_t>(Function::ToolVector)]) {
        const nc::Form& form = tables.forms[id];
        if (!form.is_written) continue;
        for (const nc::FormWord& word : form.words)
            if (word.kind == nc::FormWord::Kind::Value)
                return tables.addresses[word.address].format.decimals;
    }
    return kDirectionDigits;
}

/// The direction in numbers that the control writes without loss: as it was programmed if they are,
/// else of a length that shows enough digits.
Vec3 written(const Vec3& programmed, int digits) {
    const double unit = std::pow(10.0, digits);
    const auto is_whole = [&](double value) {
        return round_to(value, digits) == value && std::fabs(value) * unit < kMostDigits;
    };
    if (is_whole(programmed.x()) && is_whole(programmed.y()) && is_whole(programmed.z()))
        return programmed;
    Vec3 direction = programmed.normalized();
    for (Eigen::Index i = 0; i < 3; ++i)
        if (std::fabs(direction[i]) < kNoComponent) direction[i] = 0;
    return direction * std::pow(10.0, std::max(0, kDirectionDigits - digits));
}

}  // namespace

void put_function(Running& run, Function function, std::span<const ArgumentValue> arguments,
                  SourceId source, std::uint32_t at, unsigned depth) {
    if (run.status.has_failed() || !require_room(run, at)) return;
    Block& block = next_block(run, source);
    std::size_t count = 0;
    for (const ArgumentValue& argument : arguments) count = std::max(count, argument.parameter + 1);
    nc::Invocation* invocation = block.add(function, count);
    for (const auto& [parameter, value] : arguments)
        if (value == value) block.set_argument(*invocation, parameter, value);
    run.modal.take_block(block, run.target.rules());
    if (run.options.trace) keep_trace(run, at, depth, source);
}

ToolTaken take_tool(Running& run, const sema::Plan& plan, const Instruction& instruction,
                    std::uint32_t at) {
    const SourceId source = statement_of(instruction);
    for (const nc::Invocation& invocation : plan.functions) {
        const Function function = invocation.function;
        switch (function) {
            case Function::TcpOn:
                return tool_taken(begin_tcp(run, plan.functions, source, at, instruction.c));
            case Function::TcpOff: return tool_taken(end_tcp(run, source, at, instruction.c));
            case Function::OrientGreatCircle:
            case Function::OrientAxes:
                if (run.target.can_write(function) || !run.target.can_write(Function::TcpVector))
                    break;
                return tool_taken(
                    choose_orient_interpolation(run, function, source, at, instruction.c));
            case Function::ToolVector:
                if (!require_leading_tool(run, at)) return ToolTaken::Failed;
                break;
            default: break;
        }
        const bool is_outside =
            run.modal.tcp.acts() &&
            (nc::has_fact(function, nc::Fact::OutsideTcp) ||
             (run.modal.tcp.is_length() && (nc::has_fact(function, nc::Fact::AlarmUnderTcpLength) ||
                                            nc::has_fact(function, nc::Fact::OutsideTcpLength))));
        if (is_outside) return tool_taken(refuse_under_tcp(run, nc::info(function).name, at));
    }
    if (run.modal.tcp.is_length() && names_rotary(plan))
        return tool_taken(refuse_under_tcp(run, "a position of a rotary axis", at));
    return ToolTaken::Nothing;
}

Done refuse_under_tcp(Running& run, std::string_view what, std::uint32_t at) {
    DiagnosticBuilder builder = fault(run, diag::InsideTcp, at);
    builder.arg(what).arg(run.target.name());
    note_statement(run, builder, run.modal.by(Group::Transformation), "it began here");
    builder.fix("end it before: `tcp(off)`");
    return kFailed;
}

namespace {

/// Why tool centre point control cannot begin here; empty: it can.
std::string tcp_hindrance(const Running& run) {
    if (run.modal.tilt.acts()) return "inside of a tilted plane";
    if (nc::has_fact(run.modal[Group::RadiusComp], nc::Fact::CompSide))
        return "under cutter radius compensation";
    if (run.target.can_write(Function::TcpOn)) return "";
    // What follows is of controls to which it is a kind of tool length.
    const control::ProgramFrame& frame = run.modal.frame.now();
    if (frame.angle_deg != 0 || frame.has_scale() || frame.has_mirror())
        return "inside of a rotation, a scale or a mirror";
    if (!length_number(run))
        return "without a tool, whose length " + std::string(run.target.name()) + " takes for it";
    if (run.modal.position.is_turned())
        return "where the rotary axes have turned: " + std::string(run.target.name()) +
               " counts from how the table lies here, others from position 0";
    return "";
}

/// The number of the offset that has the tool's length.
std::optional<double> length_number(const Running& run) {
    if (run.modal[Group::LengthComp] == Function::LengthCompOn && run.modal.length.offset())
        return run.modal.length.offset();
    return run.modal.tool.in();
}

/// call         functions of the block; those beside TcpOn choose interpolation and systems
Done begin_tcp(Running& run, std::span<const nc::Invocation> call, SourceId source,
               std::uint32_t at, unsigned depth) {
    const bool is_lost = run.modal.lost.has(Group::Transformation);
    if (run.modal.tcp.acts() && !is_lost) return kDone;
    const bool has_own = run.target.can_write(Function::TcpOn);
    if (!has_own && !run.target.can_write(Function::TcpVector)) {
        fault(run, diag::TcpMissing, at).arg(run.target.name());
        return kFailed;
    }
    if (const std::string why = tcp_hindrance(run); !why.empty()) {
        DiagnosticBuilder builder = fault(run, diag::TcpBegin, at);
        builder.arg(why);
        if (run.modal.position.is_turned() && !has_own)
            builder.fix("bring the rotary axes to 0 before: `G0 A=0 C=0`");
        return kFailed;
    }
    Function orientation = run.modal[Group::OrientInterpolation];
    for (const nc::Invocation& invocation : call)
        if (nc::info(invocation.function).group == Group::OrientInterpolation)
            orientation = invocation.function;
    if (has_own) {
        put_function(run, Function::TcpOn, {}, source, at, depth);
        say_offset_again(run, source, at, depth);
        if (run.target.rules().transformation_wants_offset) put_frame_again(run, source, at, depth);
        for (const nc::Invocation& invocation : call) {
            if (invocation.function != Function::TcpOn && run.target.can_write(invocation.function))
                put_function(run, invocation.function, {}, source, at, depth);
        }
        return Done(!run.status.has_failed());
    }
    run.modal.tcp.begin_as_length(*length_number(run), run.modal[Group::LengthComp]);
    run.modal.assume(Group::Transformation, Function::TcpOn, source);
    return choose_orient_interpolation(run, orientation, source, at, depth);
}

/// Whether the switch takes the work offset off is a matter of the machine: programmed behind it,
/// it acts on each.
void say_offset_again(Running& run, SourceId source, std::uint32_t at, unsigned depth) {
    if (!run.target.rules().transformation_wants_offset) return;
    if (run.modal.lost.has(Group::WorkOffsets)) return;
    take_offset_of_head(run, run.modal);
    if (run.modal[Group::WorkOffsets] == Function::None && run.modal.owed.work_offset() == 0)
        return;
    const double offset =
        run.modal.owed.work_offset() != 0 ? run.modal.owed.work_offset() : run.modal.work_offset;
    constexpr std::size_t kNumber = nc::parameter_of<Function::WorkOffset>("number");
    put_function(run, Function::WorkOffset, {{kNumber, offset}}, source, at, depth);
}

/// Great circles or the rotary axes in proportion, on a control that programs it with the length.
Done choose_orient_interpolation(Running& run, Function orientation, SourceId source,
                                 std::uint32_t at, unsigned depth) {
    run.modal.assume(Group::OrientInterpolation, orientation);
    if (run.modal.tcp.kind() != TcpKind::Length) return kDone;
    const double plane = orientation == Function::OrientAxes ? 0 : 1;
    constexpr std::size_t kOffset = nc::parameter_of<Function::TcpVector>("offset");
    constexpr std::size_t kPlane = nc::parameter_of<Function::TcpVector>("plane");
    put_function(run, Function::TcpVector, {{kOffset, run.modal.tcp.offset()}, {kPlane, plane}},
                 source, at, depth);
    return Done(!run.status.has_failed());
}

/// No axis moves. A control to which it is a kind of tool length goes over to the plain length: to
/// end it alone would travel the length towards the part.
Done end_tcp(Running& run, SourceId source, std::uint32_t at, unsigned depth) {
    if (run.modal.tcp.kind() != TcpKind::Length) {
        run.modal.tcp.end();
        if (run.target.can_write(Function::TcpOff))
            put_function(run, Function::TcpOff, {}, source, at, depth);
        return Done(!run.status.has_failed());
    }
    if (run.modal.tcp.is_inclined()) {
        fault(run, diag::TcpLeaning, at)
            .arg(run.target.name())
            .fix("let it stand along Z before: `orient(k: 1)`");
        return kFailed;
    }
    constexpr std::size_t kOffset = nc::parameter_of<Function::LengthCompOn>("offset");
    put_function(run, Function::LengthCompOn, {{kOffset, run.modal.tcp.offset()}}, source, at,
                 depth);
    run.modal.tcp.end();
    run.modal.assume(Group::LengthComp, run.modal.tcp.before());
    run.modal.assume(Group::Transformation, Function::TcpOff, source);
    return Done(!run.status.has_failed());
}

}  // namespace

Done set_back_tcp(Running& run, const ModalState& before, SourceId source, std::uint32_t at,
                  unsigned depth) {
    const Function was = before[Group::Transformation];
    if (was == run.modal[Group::Transformation] && before.tcp.kind() == run.modal.tcp.kind())
        return kDone;
    if (was == Function::None) {
        fault(run, diag::StateUnknown, at).arg(nc::group_name(Group::Transformation));
        return kFailed;
    }
    return before.tcp.kind() == TcpKind::Off ? end_tcp(run, source, at, depth)
                                             : begin_tcp(run, {}, source, at, depth);
}

namespace {

/// A direction of the tool acts here.
Done require_leading_tool(Running& run, std::uint32_t at) {
    const bool is_lost = run.modal.lost.has(Group::Transformation);
    if (is_lost)
        return refuse_lost_state(run, "whether tool centre point control acts",
                                 "say `tcp(on)` before it", at);
    if (run.modal.tcp.acts() || run.modal[Group::LengthComp] == Function::TcpVector) return kDone;
    fault(run, diag::OrientAlone, at).fix("say `tcp(on)` before it");
    return kFailed;
}

}  // namespace

Done settle_direction(Running& run, Block& block, std::uint32_t at) {
    constexpr std::size_t kComponent = nc::parameter_of<Function::ToolVector>("component");
    constexpr std::size_t kValue = nc::parameter_of<Function::ToolVector>("value");
    const auto each = [&](const auto& act) {
        for (std::size_t i = 0; i < block.function_count; ++i) {
            nc::Invocation& part = block.functions[i];
            if (part.function != Function::ToolVector) continue;
            const double component = block.argument(part, kComponent, -1);
            if (component >= 0 && component <= 2) act(part, static_cast<Eigen::Index>(component));
        }
    };
    Vec3 programmed = Vec3::Zero();
    each([&](const nc::Invocation& part, Eigen::Index i) {
        programmed[i] = block.argument(part, kValue);
    });
    if (programmed.norm() < kNoComponent) {
        fault(run, diag::OrientZero, at);
        return kFailed;
    }
    const Vec3 direction = written(programmed, digits_of(run.target.tables()));
    each([&](nc::Invocation& part, Eigen::Index i) {
        block.set_argument(part, kValue, direction[i]);
    });
    const double aside = std::hypot(direction.x(), direction.y());
    run.modal.tcp.incline(!(direction.z() > 0) || aside > kNoComponent * direction.z());
    run.modal.position.turn(true);
    run.modal.position.lose(kRotary);
    run.modal.put_motion(block);
    return kDone;
}

Done check_leading(Running& run, const Block& block, std::uint32_t at) {
    const Function motion = run.modal[Group::Motion];
    if (motion == Function::None || nc::has_fact(motion, nc::Fact::Straight)) return kDone;
    const bool moves = (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0;
    if (!moves && block.find(Function::ToolVector) != nullptr) {
        fault(run, diag::OrientMotion, at).arg(nc::info(motion).name);
        return kFailed;
    }
    if (!moves || run.modal.tcp.kind() != TcpKind::Length) return kDone;
    fault(run, diag::TcpMotion, at)
        .arg(nc::info(motion).name)
        .arg(run.target.name())
        .fix(
            "lines within a tolerance: `follow(…, tolerance: 5um, arcs: false)` "
            "of a curve");
    return kFailed;
}

}  // namespace kadr::expand
