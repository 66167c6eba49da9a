// blocks.cpp — blocks: plans filled with values; texts.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/assert.h"
#include "base/diagnostics/dialect.h"
#include "base/diagnostics/expand.h"
#include "base/diagnostics/iso.h"
#include "base/readable.h"
#include "expand/feed_words.h"
#include "expand/numbers.h"
#include "expand/state.h"
#include "nc/frame_words.h"
#include "nc/tables.h"
#include "syntax/ast.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using sema::Filling;

namespace {

constexpr double kMmPerMeter = 1000;
constexpr nc::SlotMask kPointSlots = 7;  // X, Y, Z
constexpr std::uint32_t kOfCycles = sema::custom::kCyclePosition | sema::custom::kPlaces;

}  // namespace

/// The instruction that made the value of a word; its location is the word, not the whole block.
std::uint32_t Expander::State::word_of(const Filling& filling, std::uint32_t at) const {
    const Instruction& emit = code.instructions[at];
    if (emit.op != OpCode::Emit) return at;  // a feed of `follow`
    const sema::Plan& plan = code.plans[static_cast<std::size_t>(emit.immediate.pair.first)];
    const auto value = static_cast<std::uint16_t>(emit.a + (&filling - plan.fillings.data()));
    const SourceRange block = code.locations[at];
    for (std::uint32_t i = at; i-- > 0;) {
        const SourceRange location = code.locations[i];
        const bool is_inside = location.file == block.file && location.begin >= block.begin &&
                               location.end <= block.end;
        if (!is_inside) break;
        if (code.instructions[i].a == value) return i;
    }
    return at;
}

Done Expander::State::require_room(std::uint32_t at) {
    if (is_in_curve) [[unlikely]] {
        fault(diag::CurveBlock, at);
        return kFailed;
    }
    if (blocks_left > 0) {
        --blocks_left;
        return kDone;
    }
    fault(diag::BlockLimit, at)
        .arg(static_cast<std::int64_t>(options.limits.blocks))
        .fix("if it is to make more, raise the limit: `--max-blocks " +
             std::to_string(10 * options.limits.blocks) + '`');
    return kFailed;
}

Block& Expander::State::next_block(SourceId source) {
    Block* block = nullptr;
    if (!recordings.empty()) [[unlikely]] {
        block = &kept_block;
    } else if (batch_count < batch_size && waiting.empty()) {
        block = &batch[batch_count++];
    } else {
        waiting.emplace_back();
        block = &waiting.back();
    }
    block->reset();
    block->source = source;
    return *block;
}

void Expander::State::drop_block(const Block& block) {
    if (&block == &kept_block) return;
    if (!waiting.empty()) waiting.pop_back();
    else --batch_count;
}

Done Expander::State::emit(const Instruction& instruction, const sema::Slot* registers,
                           std::uint32_t at) {
    const sema::Plan& plan = code.plans[static_cast<std::size_t>(instruction.immediate.pair.first)];
    if (!recordings.empty()) [[unlikely]] {
        if (!require_room(at)) return kFailed;
        return keep_plan(plan, instruction, registers, at);
    }
    if (plan.planes != nc::kAllPlanes && !require_plane_of_source(plan, at)) [[unlikely]]
        return kFailed;
    if (is_between_positions() && !require_between_positions(plan, instruction, at)) [[unlikely]]
        return kFailed;
    if (!plan.functions.empty() || modal.tcp != ModalState::Tcp::Off) {
        const ToolTaken said = take_tool(plan, instruction, at);
        if (said != ToolTaken::Nothing) return Done(said == ToolTaken::Done);
    }
    if (!plan.functions.empty() && is_about_tilted_plane(plan)) [[unlikely]]
        return emit_tilted_plane(plan, instruction, registers, at);
    if (!plan.functions.empty() && needs_frame(plan)) [[unlikely]]
        return emit_frame(plan, instruction, registers, at);
    return emit_block(plan, instruction, registers, at);
}

Done Expander::State::emit_block(const sema::Plan& plan, const Instruction& instruction,
                                 const sema::Slot* registers, std::uint32_t at) {
    if (!require_room(at)) return kFailed;
    if (modal.due_offset != 0) [[unlikely]]
        say_offset(plan, instruction, at);
    if (modal.diameter_due != Function::None && plan.skip_level >= 0) [[unlikely]] {
        const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
        say_diameter_alone(source, at, instruction.c);
    }
    if (modal.is_position_due) [[unlikely]]
        write_position(plan, instruction, at);
    if (modal.unplaced != 0 && instruction.b == 0 && is_whole_circle(plan)) [[unlikely]] {
        const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
        if (!write_positions(source, at, instruction.c)) return kFailed;
    }
    const std::size_t in_batch = batch_count;
    if (fill_plan(plan, instruction, registers, at)) {
        if (plan.customs == 0) [[likely]]
            return kDone;
        if ((plan.customs & sema::custom::kReference) != 0)
            go_over_position(
                SourceId{static_cast<std::uint32_t>(instruction.immediate.pair.second)});
        const Block& block = batch_count > in_batch ? batch[batch_count - 1] : waiting.back();
        const bool is_empty =
            block.function_count == 0 && block.given == 0 && block.motion == Function::None;
        if (!is_empty) return kDone;
        // All that it programmed the target does by itself.
        if (batch_count > in_batch) --batch_count;
        else waiting.pop_back();
        if (options.trace) traces.pop_back();
        return kDone;
    }
    // A block that could not be finished is not delivered.
    if (batch_count > in_batch) batch_count = in_batch;
    else waiting.pop_back();
    return kFailed;
}

Done Expander::State::fill_plan(const sema::Plan& plan, const Instruction& instruction,
                                const sema::Slot* registers, std::uint32_t at) {
    if (plan.skip_level < 0) [[likely]]
        return fill_block(plan, instruction, registers, at);
    // Nobody knows here whether the operator lets the block run.
    const ModalState without = modal;
    if (!fill_block(plan, instruction, registers, at)) return kFailed;
    modal.join(without, SourceId{static_cast<std::uint32_t>(instruction.immediate.pair.second)});
    return kDone;
}

/// A control may have a frame that the language has not: its own words are its own matter.
static bool is_frame_of_language(const sema::Plan& plan) {
    return (plan.customs & sema::custom::kFrameOfSource) == 0 &&
           std::ranges::any_of(plan.functions, [](const nc::Invocation& invocation) {
               return nc::has_fact(invocation.function, nc::Fact::AddsToFrame);
           });
}

/// What does not depend on values that are calculated.
static inline void copy_constants(const sema::Plan& plan, int default_skip, Block& block) {
    block.motion = plan.motion;
    block.given = plan.given;
    block.incremental = plan.incremental;
    block.absolute = plan.absolute;
    block.argument_count = plan.argument_count;
    block.skip_level = plan.skip_level == syntax::kDefaultSkipLevel
                           ? static_cast<std::int8_t>(default_skip)
                           : plan.skip_level;
    block.cycle = plan.cycle;
    block.number = plan.number;
    block.feed_along_arc = (plan.customs & sema::custom::kFeedOfArc) != 0;
    block.feed_of_all_axes = (plan.customs & sema::custom::kFeedOfAxes) != 0;
    block.length_waits = (plan.customs & sema::custom::kLengthMoves) == 0;
    block.function_count = static_cast<std::uint8_t>(plan.functions.size());
    for (std::size_t i = 0; i < plan.functions.size(); ++i) block.functions[i] = plan.functions[i];
    for (const auto& [place, value] : plan.arguments) block.arguments[place] = value;
    for (const auto& [place, value] : plan.values) block.values[place] = value;
}

Done Expander::State::fill_block(const sema::Plan& plan, const Instruction& instruction,
                                 const sema::Slot* registers, std::uint32_t at) {
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    Block& block = next_block(source);
    if ((plan.customs & kOfCycles) != 0) [[unlikely]]
        active_cycle.motion = modal[Group::Motion];
    copy_constants(plan, target.tables().notation.default_skip, block);
    // Values of functions before those of F and S: the feed mode decides what F means.
    const sema::Slot* values = registers + instruction.a;
    if (modal.has_ended && recordings.empty()) [[unlikely]]
        warn_after_end(at);
    bool owes_behind = false;
    if (block.function_count == 0 && block.motion != Function::None) {  // nearly all of them
        if (plan.customs != 0 && !adapt(block, plan, at)) [[unlikely]]
            return kFailed;
        owes_behind = modal.take_functions(block, target.rules());
        const bool is_thread = block.motion == Function::Thread;
        if (is_thread && modal[Group::Diameter] == Function::None && options.warns_of_cuts)
            warn_of_radius(block, at);
    } else if (block.function_count != 0) {
        for (std::size_t i = 0; i < plan.fillings.size(); ++i) {
            if (plan.fillings[i].is_argument && !fill(block, plan.fillings[i], values[i], at))
                return kFailed;
        }
        if (plan.customs != 0 && !adapt(block, plan, at)) [[unlikely]]
            return kFailed;
        if (!check_mirror(block, plan, at) || !settle_frame(block, at)) return kFailed;
        if (options.warns_of_cuts) warn_of_plane(block, at);
        const Function motion = plan.motion != Function::None ? plan.motion : modal[Group::Motion];
        owes_behind = modal.take_functions(block, target.rules());
        if (modal.frame_fault != control::FrameFormFault::None && is_frame_of_language(plan))
            return refuse_frame(modal.frame_fault, at);
        const bool has_rapid = (plan.customs & sema::custom::kMachineRapid) != 0;
        if (target.rules().machine_coordinates_rapid && !has_rapid && motion != Function::Rapid &&
            block.find(Function::MachineCoordinates) != nullptr) [[unlikely]] {
            fault(diag::MachineAtFeed, at)
                .arg(target.name())
                .arg(nc::info(motion).name)
                .fix("write `G0` in the block");
            return kFailed;
        }
        if (target.rules().shift_in_diameter) scale_frame_x(block, 2);
        if (modal[Group::Diameter] == Function::None && options.warns_of_cuts)
            warn_of_radius(block, at);
        if (has_rapid && motion != Function::Rapid) {
            modal.assume(Group::Motion, motion);
            modal.restate_motion = true;
        }
    }
    if ((plan.customs & sema::custom::kFeedCounts) != 0 &&
        modal[Group::FeedMode] == Function::FeedPerRevolution) [[unlikely]] {
        const auto feed = std::ranges::find(plan.fillings, Filling::Form::FeedBare, &Filling::form);
        fault(diag::SourceNoPoint, feed == plan.fillings.end() ? at : word_of(*feed, at))
            .arg("F")
            .arg("the control of this source")
            .arg("in hundredths of mm/rev")
            .fix("write the point");
        return kFailed;
    }
    for (std::size_t i = 0; i < plan.fillings.size(); ++i) {
        if (!plan.fillings[i].is_argument && !fill(block, plan.fillings[i], values[i], at))
            return kFailed;
    }
    if (instruction.b != 0) {
        const sema::Slot* point = registers + (instruction.b - 1);
        for (unsigned i = 0; i < 3; ++i) {
            if (point[i].number != point[i].number) continue;
            if (!is_sane(point[i].number)) {
                math_fault(sema::MathFault::Overflow, at);
                return kFailed;
            }
            block.set(static_cast<nc::Slot>(i), point[i].number);
        }
        if ((block.given & kPointSlots) == 0) {
            not_given("the target", at);
            return kFailed;
        }
    }
    if ((plan.customs & kOfCycles) != 0 && recordings.empty() && !take_position(block, plan, at))
        [[unlikely]] {
        return kFailed;
    }
    if (modal.restate_motion && block.motion == Function::None &&
        (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0) {
        block.motion = modal[Group::Motion];
        modal.restate_motion = false;
    }
    if (recordings.empty()) {
        if ((modal.is_edge_off || modal.is_feed_deleted) && !check_move(block, at)) [[unlikely]]
            return kFailed;
        const bool owes_incremental = modal.owes_incremental;
        if ((modal.adapts() & block.given) != 0 && !adapt_increments(block, plan, at)) [[unlikely]]
            return kFailed;
        if (owes_incremental && block.find(Function::Absolute) == nullptr) [[unlikely]]
            return_to_increments(block);
    }
    if (block.function_count != 0 &&
        !(check_cutting_speed(block, at) && check_tool_change(block, at)))
        return kFailed;
    if (modal.comp_choice != ModalState::kNoChoice && recordings.empty() &&
        !require_sure_compensation(block, at)) [[unlikely]]
        return kFailed;
    if (modal.is_compensation_due() && !check_pitch(block, at)) [[unlikely]]
        return kFailed;
    if ((plan.customs & sema::custom::kReference) != 0) say_reference(block);
    if (modal.is_stretched && nc::is_arc(modal[Group::Motion]) &&
        (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0 &&
        modal.frame.is_stretched(modal[Group::Plane])) {
        fault(diag::ArcUnderScale, at);
        return kFailed;
    }
    if ((modal.lost | modal.restate) != 0 && !settle_unknown(block, at)) [[unlikely]]
        return kFailed;
    if (nc::is_arc(modal[Group::Motion]) && recordings.empty() && !require_radius(block, at))
        return kFailed;
    if (modal.tcp != ModalState::Tcp::Off && !check_leading(block, at)) return kFailed;
    if (modal.diameter_due != Function::None && recordings.empty()) [[unlikely]]
        say_diameter(block);
    if (options.warns_of_cuts && !modal.reported.has_reported(ProgramNotice::Rapid) &&
        recordings.empty())
        check_rapid(block, at);
    modal.take_words(block);
    if (owes_behind) [[unlikely]]
        modal.take_behind(block, target.rules());
    if (recordings.empty() && is_cut_doubtful() && !check_cut(block, at)) [[unlikely]]
        return kFailed;
    if (options.trace) keep_trace(at, instruction.c, source);
    return kDone;
}

Done Expander::State::fill(Block& block, const Filling& filling, sema::Slot value,
                           std::uint32_t at) {
    double number = value.number;
    switch (filling.form) {
        case Filling::Form::Text:
            block.text = heap.text(value.integer);
            block.functions[filling.invocation].given |= 1u << filling.parameter;
            return kDone;
        case Filling::Form::Count:
            if (value.integer == sema::kNotGivenInteger) {
                not_given({}, word_of(filling, at));
                return kFailed;
            }
            number = static_cast<double>(value.integer);
            break;
        case Filling::Form::FeedBare:
        case Filling::Form::Feed:
        case Filling::Form::FeedPerTime:
        case Filling::Form::FeedPerTurn:
        case Filling::Form::FeedInverse: return fill_feed(block, filling, number, at);
        case Filling::Form::SpeedBare:
        case Filling::Form::Speed:
        case Filling::Form::SpeedPerTime:
        case Filling::Form::SpeedCutting: return fill_speed(block, filling, number, at);
        case Filling::Form::Diameter:
            if (!modal.is_diameter) number /= 2;
            break;
        case Filling::Form::Plain: break;
    }
    if (!is_sane(number)) {
        if (number != number) not_given({}, word_of(filling, at));
        else math_fault(sema::MathFault::Overflow, at);
        return kFailed;
    }
    if (filling.is_argument) {
        block.arguments[filling.index] = number;
        block.functions[filling.invocation].given |= 1u << filling.parameter;
    } else {
        block.set(static_cast<nc::Slot>(filling.index), number);
    }
    return kDone;
}

Done Expander::State::fill_feed(Block& block, const Filling& filling, double value,
                                std::uint32_t at) {
    if (value != value) {
        not_given("F", word_of(filling, at));
        return kFailed;
    }
    if (modal.lost != 0 && !require_feed_mode(word_of(filling, at))) [[unlikely]]
        return kFailed;
    const Function mode = modal[Group::FeedMode];
    Filling::Form form = filling.form;
    if (form == Filling::Form::Feed) {
        const bool second = sema::is_second_form(value);
        if (second) value /= sema::kSecondForm;
        form = second ? Filling::Form::FeedPerTurn : Filling::Form::FeedPerTime;
    }
    Function needed = mode;
    switch (form) {
        case Filling::Form::FeedPerTime:
            needed = Function::FeedPerMinute;
            value *= kMinute;
            break;
        case Filling::Form::FeedPerTurn: needed = Function::FeedPerRevolution; break;
        case Filling::Form::FeedInverse:
            needed = Function::FeedInverseTime;
            value *= kMinute;
            break;
        default:
            if (mode != Function::FeedInverseTime) value *= filling.factor;
            break;
    }
    if (needed != mode) {
        DiagnosticBuilder builder = fault(diag::FeedMode, word_of(filling, at));
        builder.arg(feed_word(needed)).arg(feed_word(mode));
        const SourceId by = modal.changed_by[static_cast<std::size_t>(Group::FeedMode)];
        if (by.is_valid() && by.index < code.statements.size())
            builder.note(code.statements[by.index], "the feed mode was set here");
        builder.fix(std::string("say `") + feed_code(needed) + "` before it, or give the feed in " +
                    feed_unit(mode));
        return kFailed;
    }
    if (!is_sane(value)) {
        math_fault(sema::MathFault::Overflow, at);
        return kFailed;
    }
    if (!(value > 0)) {
        const std::string feed = mode == Function::FeedInverseTime ? readable(value)
                                 : mode == Function::FeedPerRevolution
                                     ? quantity_text(value, sema::kFeedPerTurn)
                                     : quantity_text(value / kMinute, sema::kFeedPerTime);
        fault(diag::FeedZero, word_of(filling, at)).arg(feed);
        return kFailed;
    }
    block.set(nc::Slot::Feed, neat(value));
    return kDone;
}

Done Expander::State::fill_speed(Block& block, const Filling& filling, double value,
                                 std::uint32_t at) {
    if (value != value) {
        not_given("S", word_of(filling, at));
        return kFailed;
    }
    if (modal.lost != 0 && !require_speed_mode(word_of(filling, at))) [[unlikely]]
        return kFailed;
    const bool is_cutting = modal[Group::SpeedMode] == Function::CuttingSpeedOn;
    Filling::Form form = filling.form;
    if (form == Filling::Form::Speed) {
        const bool second = sema::is_second_form(value);
        if (second) value /= sema::kSecondForm;
        form = second ? Filling::Form::SpeedCutting : Filling::Form::SpeedPerTime;
    }
    if (form == Filling::Form::SpeedBare) {
        if (is_cutting) value *= filling.factor;
    } else if (is_cutting != (form == Filling::Form::SpeedCutting)) {
        fault(diag::SpeedMode, word_of(filling, at))
            .arg(is_cutting ? "a spindle speed" : "a cutting speed")
            .arg(is_cutting ? "on" : "off");
        return kFailed;
    } else {
        value *= is_cutting ? kMinute / kMmPerMeter : kMinute;
    }
    if (!is_sane(value)) {
        math_fault(sema::MathFault::Overflow, at);
        return kFailed;
    }
    if (is_cutting && value == 0) {
        fault(diag::CuttingSpeedZero, word_of(filling, at));
        return kFailed;
    }
    block.set(nc::Slot::Speed, neat(value));
    return kDone;
}

double Expander::State::state_value(sema::StateValue which) const {
    if (which == sema::StateValue::Feed) {
        if (!modal.has_feed) return sema::kNotGivenNumber;
        switch (modal[Group::FeedMode]) {
            case Function::FeedPerRevolution: return modal.feed * sema::kSecondForm;
            case Function::FeedPerMinute: return modal.feed / kMinute;
            default: return sema::kNotGivenNumber;
        }
    }
    if (!modal.has_speed) return sema::kNotGivenNumber;
    if (modal[Group::SpeedMode] == Function::CuttingSpeedOn) {
        return modal.speed * kMmPerMeter / kMinute * sema::kSecondForm;
    }
    return modal.speed / kMinute;
}

std::int64_t Expander::State::spindle_code() const {
    const Function spindle = modal[Group::Spindle];
    return spindle == Function::None ? sema::kNotGivenInteger : nc::code_of_spindle(spindle);
}

Done Expander::State::emit_text(const Instruction& instruction, const sema::Slot* registers,
                                std::uint32_t at) {
    if (!recordings.empty()) return refuse_in_contour("a text", at);
    if (is_between_positions() && instruction.b == 1) return refuse_beside_cycle("raw text", at);
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    // A copy: making blocks does not move texts, but nothing should depend on that.
    const std::string text = heap.text(registers[instruction.a].integer);
    const bool is_raw = instruction.b == 1;
    if (is_raw && modal.diameter_due != Function::None)
        say_diameter_alone(source, at, instruction.c);
    std::string_view rest = text;
    do {
        if (!require_room(at)) return kFailed;
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        Block& block = next_block(source);
        block.kind = is_raw ? Block::Kind::Raw : Block::Kind::Comment;
        if (is_raw) block.text = line;
        else block.comment = line;
        if (options.trace) keep_trace(at, instruction.c, source);
    } while (!rest.empty());
    if (!is_raw) return kDone;
    modal.forget(source);
    // No word of this control tells what X is, so no text changes it.
    if (target.tables().forms_of[static_cast<std::size_t>(Function::DiameterOff)].empty())
        modal.lost &= ~sema::group_bit(Group::Diameter);
    return kDone;
}

}  // namespace kadr::expand
