// blocks.cpp — blocks: plans filled with values; texts; frames; what `with` sets back.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/assert.h"
#include "base/diagnostics/dialect.h"
#include "base/diagnostics/expand.h"
#include "base/diagnostics/iso.h"
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

constexpr double kMinute = 60;
constexpr double kMmPerMeter = 1000;
constexpr nc::SlotMask kPointSlots = 7;  // X, Y, Z
constexpr std::uint32_t kOfCycles = sema::custom::kCyclePlace | sema::custom::kPlaces;

/// Anything a control could be told; beyond it the calculation has run away.
bool is_sane(double value) { return std::fabs(value) < 1e15; }

/// 240 m/min is 240·1000/60 mm/s and comes back as 240.00000000000003: what was a short decimal
/// number before the units changed is one again.
double neat(double value) {
    const double rounded = std::nearbyint(value * 1e6) / 1e6;
    return std::fabs(rounded - value) <= 1e-15 * std::fabs(value) ? rounded : value;
}

std::string_view feed_word(Function mode) {
    switch (mode) {
        case Function::FeedPerRevolution: return "feed per revolution";
        case Function::FeedInverseTime: return "inverse time feed";
        default: return "feed per minute";
    }
}

const char* feed_code(Function mode) {
    return mode == Function::FeedPerRevolution ? "G95"
           : mode == Function::FeedInverseTime ? "G93"
                                               : "G94";
}

const char* feed_unit(Function mode) {
    return mode == Function::FeedPerRevolution ? "mm/rev"
           : mode == Function::FeedInverseTime ? "1/min"
                                               : "mm/min";
}

}  // namespace

/// The instruction that made the value of a word; its place is the word, not the whole block.
std::uint32_t Expander::State::word_of(const Filling& filling, std::uint32_t at) const {
    const Instruction& emit = code.instructions[at];
    if (emit.op != Op::Emit) return at;  // a feed of `follow`
    const sema::Plan& plan = code.plans[static_cast<std::size_t>(emit.immediate.pair.first)];
    const auto value = static_cast<std::uint16_t>(emit.a + (&filling - plan.fillings.data()));
    const SourceRange block = code.places[at];
    for (std::uint32_t i = at; i-- > 0;) {
        const SourceRange place = code.places[i];
        const bool is_inside =
            place.file == block.file && place.begin >= block.begin && place.end <= block.end;
        if (!is_inside) break;
        if (code.instructions[i].a == value) return i;
    }
    return at;
}

bool Expander::State::is_block_limit(std::uint32_t at) {
    if (is_in_curve) [[unlikely]] {
        fault(diag::CurveBlock, at);
        return true;
    }
    if (blocks_left > 0) {
        --blocks_left;
        return false;
    }
    fault(diag::BlockLimit, at)
        .arg(static_cast<std::int64_t>(options.limits.blocks))
        .fix("if it is to make more, raise the limit: `--max-blocks " +
             std::to_string(10 * options.limits.blocks) + '`');
    return true;
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

bool Expander::State::emit(const Instruction& instruction, const sema::Slot* registers,
                           std::uint32_t at) {
    const sema::Plan& plan = code.plans[static_cast<std::size_t>(instruction.immediate.pair.first)];
    if (!recordings.empty()) [[unlikely]]
        return !is_block_limit(at) && keep_plan(plan, instruction, registers, at);
    if (is_between_places() && !may_stand_between(plan, instruction, at)) [[unlikely]]
        return false;
    if (!plan.functions.empty() && needs_frame(plan)) [[unlikely]]
        return emit_frame(plan, instruction, registers, at);
    return emit_block(plan, instruction, registers, at);
}

bool Expander::State::emit_block(const sema::Plan& plan, const Instruction& instruction,
                                 const sema::Slot* registers, std::uint32_t at) {
    if (is_block_limit(at)) return false;
    if (modal.due_offset != 0) [[unlikely]]
        say_offset(plan, instruction, at);
    if (modal.diameter_due != Function::None && plan.skip >= 0) [[unlikely]] {
        const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
        say_diameter_alone(source, at, instruction.c);
    }
    if (modal.is_place_due) [[unlikely]]
        say_place(plan, instruction, at);
    const std::size_t in_batch = batch_count;
    if (fill_plan(plan, instruction, registers, at)) {
        if (plan.customs == 0) [[likely]]
            return true;
        if ((plan.customs & sema::custom::kReference) != 0)
            go_over_place(SourceId{static_cast<std::uint32_t>(instruction.immediate.pair.second)});
        const Block& block = batch_count > in_batch ? batch[batch_count - 1] : waiting.back();
        const bool is_empty =
            block.function_count == 0 && block.given == 0 && block.motion == Function::None;
        if (!is_empty) return true;
        // All that it said the target does by itself.
        if (batch_count > in_batch) --batch_count;
        else waiting.pop_back();
        if (options.trace) traces.pop_back();
        return true;
    }
    // A block that could not be finished is not delivered.
    if (batch_count > in_batch) batch_count = in_batch;
    else waiting.pop_back();
    return false;
}

bool Expander::State::fill_plan(const sema::Plan& plan, const Instruction& instruction,
                                const sema::Slot* registers, std::uint32_t at) {
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    Block& block = next_block(source);
    if ((plan.customs & kOfCycles) != 0) [[unlikely]]
        said_cycle.motion = modal[Group::Motion];
    block.motion = plan.motion;
    block.given = plan.given;
    block.incremental = plan.incremental;
    block.absolute = plan.absolute;
    block.argument_count = plan.argument_count;
    block.skip = plan.skip == syntax::kPlainSkip
                     ? static_cast<std::int8_t>(target.tables().rules.default_skip)
                     : plan.skip;
    block.cycle = plan.cycle;
    block.number = plan.number;
    block.feed_along_arc = (plan.customs & sema::custom::kFeedOfArc) != 0;
    block.function_count = static_cast<std::uint8_t>(plan.functions.size());
    for (std::size_t i = 0; i < plan.functions.size(); ++i) block.functions[i] = plan.functions[i];
    for (const auto& [place, value] : plan.arguments) block.arguments[place] = value;
    for (const auto& [place, value] : plan.values) block.values[place] = value;
    // Values of functions before those of F and S: the feed mode decides what F means.
    const sema::Slot* values = registers + instruction.a;
    if (modal.has_ended && recordings.empty()) [[unlikely]]
        warn_after_end(at);
    const bool has_functions = block.function_count > 0 || block.motion != Function::None;
    if (has_functions) {
        for (std::size_t i = 0; i < plan.fillings.size(); ++i) {
            if (plan.fillings[i].is_argument && !fill(block, plan.fillings[i], values[i], at))
                return false;
        }
        if (plan.customs != 0 && !adapt(block, plan, at)) [[unlikely]]
            return false;
        const Function motion = plan.motion != Function::None ? plan.motion : modal[Group::Motion];
        modal.take_functions(block);
        const bool says_rapid = (plan.customs & sema::custom::kMachineRapid) != 0;
        if (has_machine_rapid && !says_rapid && motion != Function::Rapid &&
            block.find(Function::MachineCoordinates) != nullptr) [[unlikely]] {
            fault(diag::MachineAtFeed, at)
                .arg(target.name())
                .arg(nc::info(motion).name)
                .fix("write `G0` in the block");
            return false;
        }
        if (has_frame_diameter) scale_frame_x(block, 2);
        if (modal[Group::Diameter] == Function::None && options.warns_of_cuts &&
            !warned_of_diameter)
            warn_of_radius(block, at);
        if (says_rapid && motion != Function::Rapid) {
            modal.active[static_cast<std::size_t>(Group::Motion)] = motion;
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
        return false;
    }
    for (std::size_t i = 0; i < plan.fillings.size(); ++i) {
        if (!plan.fillings[i].is_argument && !fill(block, plan.fillings[i], values[i], at))
            return false;
    }
    if (instruction.b != 0) {
        const sema::Slot* point = registers + (instruction.b - 1);
        for (unsigned i = 0; i < 3; ++i) {
            if (point[i].number != point[i].number) continue;
            if (!is_sane(point[i].number)) {
                math_fault(sema::MathFault::Overflow, at);
                return false;
            }
            block.set(static_cast<nc::Slot>(i), point[i].number);
        }
        if ((block.given & kPointSlots) == 0) {
            not_given("the target", at);
            return false;
        }
    }
    if ((plan.customs & kOfCycles) != 0 && recordings.empty() && !take_place(block, plan, at))
        [[unlikely]] {
        return false;
    }
    if (modal.restate_motion && block.motion == Function::None &&
        (block.given & nc::kTargetSlots) != 0) {
        block.motion = modal[Group::Motion];
        modal.restate_motion = false;
    }
    if (recordings.empty()) {
        if ((modal.is_edge_off || modal.is_feed_deleted) && !may_move(block, at)) [[unlikely]]
            return false;
        const bool owes_incremental = modal.owes_incremental;
        if (((modal.has_drift | modal.lost_drift | modal.unplaced) & block.given) != 0 &&
            !adapt_increments(block, plan, at)) [[unlikely]]
            return false;
        if (owes_incremental && block.find(Function::Absolute) == nullptr) [[unlikely]]
            return_to_increments(block);
    }
    if (has_functions && !check_cutting_speed(block, at)) return false;
    if ((plan.customs & sema::custom::kReference) != 0) say_reference(block);
    if (modal.is_stretched && nc::is_arc(modal[Group::Motion]) &&
        (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0 &&
        modal.frame.is_stretched(modal[Group::Plane])) {
        fault(diag::ArcUnderScale, at);
        return false;
    }
    if ((modal.lost | modal.restate) != 0 && !settle_unknown(block, at)) [[unlikely]]
        return false;
    if (nc::is_arc(modal[Group::Motion]) && recordings.empty() && !has_radius(block, at))
        return false;
    if (modal.diameter_due != Function::None && recordings.empty()) [[unlikely]]
        say_diameter(block);
    if (options.warns_of_cuts && !modal.warned_of_rapid && recordings.empty())
        check_rapid(block, at);
    modal.take_words(block);
    if (recordings.empty() && is_cut_doubtful() && !check_cut(block, at)) [[unlikely]]
        return false;
    // Nobody knows here whether the operator lets the block run.
    if (plan.skip >= 0) [[unlikely]]
        modal.take_skipped(block);
    if (options.trace) keep_trace(at, instruction.c, source);
    return true;
}

/// A constant cutting speed that is none, and a limit that lets no spindle turn.
bool Expander::State::check_cutting_speed(const Block& block, std::uint32_t at) {
    const nc::Invocation* limit = block.find(Function::SpeedLimit);
    if (limit != nullptr && !(block.argument(*limit, 0) > 0)) {
        fault(diag::SpeedLimitZero, at).arg(neat(block.argument(*limit, 0)));
        return false;
    }
    const bool begins = block.find(Function::CuttingSpeedOn) != nullptr;
    if (!begins || block.has(nc::Slot::Speed) || modal.has_speed || modal.had_cutting_speed ||
        modal.lost != 0)
        return true;
    const auto alarm = target.alarm(diag::CuttingSpeedMissing);
    if (!alarm) return true;
    fault(diag::CuttingSpeedNotSet, at)
        .arg(target.name())
        .arg(alarm->number.empty() ? alarm->text : alarm->number)
        .fix("say the cutting speed in the block: `G96 S180`");
    return false;
}

bool Expander::State::fill(Block& block, const Filling& filling, sema::Slot value,
                           std::uint32_t at) {
    double number = value.number;
    switch (filling.form) {
        case Filling::Form::Text:
            block.text = heap.text(value.integer);
            block.functions[filling.invocation].given |= 1u << filling.parameter;
            return true;
        case Filling::Form::Count:
            if (value.integer == sema::kNotGivenInteger) {
                not_given({}, word_of(filling, at));
                return false;
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
        return false;
    }
    if (filling.is_argument) {
        block.arguments[filling.place] = number;
        block.functions[filling.invocation].given |= 1u << filling.parameter;
    } else {
        block.set(static_cast<nc::Slot>(filling.place), number);
    }
    return true;
}

bool Expander::State::fill_feed(Block& block, const Filling& filling, double value,
                                std::uint32_t at) {
    if (value != value) {
        not_given("F", word_of(filling, at));
        return false;
    }
    if (modal.lost != 0 && !knows_feed_mode(word_of(filling, at))) [[unlikely]]
        return false;
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
        return false;
    }
    if (!is_sane(value)) {
        math_fault(sema::MathFault::Overflow, at);
        return false;
    }
    if (!(value > 0)) {
        fault(diag::FeedZero, word_of(filling, at)).arg(neat(value));
        return false;
    }
    block.set(nc::Slot::Feed, neat(value));
    return true;
}

bool Expander::State::fill_speed(Block& block, const Filling& filling, double value,
                                 std::uint32_t at) {
    if (value != value) {
        not_given("S", word_of(filling, at));
        return false;
    }
    if (modal.lost != 0 && !knows_speed_mode(word_of(filling, at))) [[unlikely]]
        return false;
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
        return false;
    } else {
        value *= is_cutting ? kMinute / kMmPerMeter : kMinute;
    }
    if (!is_sane(value)) {
        math_fault(sema::MathFault::Overflow, at);
        return false;
    }
    if (is_cutting && value == 0) {
        fault(diag::CuttingSpeedZero, word_of(filling, at));
        return false;
    }
    block.set(nc::Slot::Speed, neat(value));
    return true;
}

bool Expander::State::check_cut(const Block& block, std::uint32_t at) {
    const Function motion = modal[Group::Motion];
    const bool is_cut = motion == Function::Line || nc::is_arc(motion);
    const bool moves = (block.given & (nc::kTargetSlots | nc::kCenterSlots)) != 0;
    if (!is_cut || !moves || block.find(Function::ReferenceReturn) != nullptr) return true;
    if (modal.is_feed_lost) return feed_lost(at, frames.size());
    if (options.warns_of_cuts) warn_of_cut(at);
    return !has_failed;
}

/// A number of millimetres per minute would cut as millimetres per revolution.
bool Expander::State::feed_lost(std::uint32_t at, std::size_t depth) {
    const Function mode = modal[Group::FeedMode];
    DiagnosticBuilder builder = fault_in(diag::FeedLost, at, depth);
    builder.arg(feed_word(mode));
    const SourceId by = modal.changed_by[static_cast<std::size_t>(Group::FeedMode)];
    if (by.is_valid() && by.index < code.statements.size())
        builder.note(code.statements[by.index], "the feed mode was set here");
    builder.fix(std::string("say F in ") + feed_unit(mode) + " behind `" + feed_code(mode) + '`');
    return false;
}

/// What the interpreter finds when the text is run, said where only the text is made.
void Expander::State::warn_of_cut(std::uint32_t at, bool needs_feed) {
    if (needs_feed && !modal.has_feed && !warned_of_feed) {
        warned_of_feed = true;
        // Where the control alarms, no text is written that would; the common core has no alarms.
        if (const auto alarm = target.alarm(diag::FeedMissing)) {
            const std::string number = alarm->number.empty() ? alarm->text : alarm->number;
            fault(diag::FeedNotSet, at)
                .arg(target.name())
                .arg(number)
                .fix("give the block a feed: `F200`, or set one before it");
            return;
        }
        fault(diag::FeedNeverSet, at);
    }
    if (modal.is_spindle_turning() && modal.lacks_tool) {
        modal.lacks_tool = false;  // said once
        fault(diag::ToolNeverCalled, at);
    }
    if (!modal.is_spindle_turning() && !modal.warned_of_spindle) warn_of_spindle(at);
}

void Expander::State::warn_of_spindle(std::uint32_t at) {
    const bool is_on = modal[Group::Spindle] == Function::SpindleCw ||
                       modal[Group::Spindle] == Function::SpindleCcw;
    const DiagnosticRow& row = is_on && modal.lacks_speed
                                   ? static_cast<const DiagnosticRow&>(diag::SpindleWithoutSpeed)
                                   : diag::FeedWithSpindleStopped;
    modal.warned_of_spindle = !is_allowed(row, at);
    DiagnosticBuilder builder = fault(row, at);
    const SourceId by = modal.changed_by[static_cast<std::size_t>(Group::Spindle)];
    if (modal[Group::Spindle] == Function::SpindleStop && by.is_valid() &&
        by.index < code.statements.size())
        builder.note(code.statements[by.index], "it stands from here on");
    if (is_on && modal.lacks_speed && by.is_valid() && by.index < code.statements.size())
        builder.note(code.statements[by.index], "it is started here, without S");
}

void Expander::State::check_rapid(const Block& block, std::uint32_t at) {
    constexpr std::size_t kZ = index(Axis::Z);
    if (!block.has(nc::Slot::Z) || modal[Group::Motion] != Function::Rapid) return;
    // On a lathe, and in another plane, Z is not the way into the workpiece.
    const bool is_mill = modal[Group::Plane] == Function::PlaneXy && !modal.is_diameter;
    if (!is_mill || modal[Group::Spindle] != Function::SpindleStop || block.skip >= 0) return;
    if (block.function_count != 0 && (block.find(Function::MachineCoordinates) != nullptr ||
                                      block.find(Function::ReferenceReturn) != nullptr ||
                                      block.find(Function::Probe) != nullptr))
        return;
    const nc::SlotMask word = bit(nc::Slot::Z);
    const bool is_known = (modal.known >> kZ & 1u) != 0;
    const bool is_modal = modal[Group::Distance] == Function::Incremental;
    const bool is_way = (block.incremental & word) != 0 || (is_modal && !(block.absolute & word));
    if (is_way && !is_known) return;
    const double way = block.at(nc::Slot::Z);
    const double target_z = is_way ? modal.position[kZ] + way : way;
    if (!(target_z < 0) || (is_known && target_z >= modal.position[kZ])) return;
    modal.warned_of_rapid = !is_allowed(diag::RapidBelowPlane, at);
    fault(diag::RapidBelowPlane, at).arg(neat(target_z));
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
    switch (modal[Group::Spindle]) {
        case Function::SpindleCw: return 3;
        case Function::SpindleCcw: return 4;
        case Function::SpindleStop:
        case Function::SpindleOrient: return 5;
        default: return sema::kNotGivenInteger;
    }
}

bool Expander::State::emit_text(const Instruction& instruction, const sema::Slot* registers,
                                std::uint32_t at) {
    if (!recordings.empty()) return refuse_block("a text", at);
    if (is_between_places() && instruction.b == 1) return cycle_active("raw text", at);
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    // A copy: making blocks does not move texts, but nothing should depend on that.
    const std::string text = heap.text(registers[instruction.a].integer);
    const bool is_raw = instruction.b == 1;
    if (is_raw && modal.diameter_due != Function::None)
        say_diameter_alone(source, at, instruction.c);
    std::string_view rest = text;
    do {
        if (is_block_limit(at)) return false;
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
    if (is_raw) modal.forget(source);
    return true;
}

/// Whether the cycle turns the spindle by itself: it taps, and not in a compensating chuck.
static bool turns_spindle(std::span<const sema::ParameterInfo> parameters, std::uint32_t given,
                          std::span<const double> values) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].name == "floating") return (given >> i & 1u) == 0 || values[i] == 0;
    }
    return false;
}

/// Whether a cycle has its feed from this parameter: threads are cut with their pitch.
static bool says_feed(const sema::ParameterInfo& parameter) {
    return parameter.name == "pitch" || parameter.name == "lead" || parameter.name == "per_turn";
}

/// Strokes and shifts are scaled in the language; a control that spares them gets moves, if its own
/// program does not say the cycle.
bool Expander::State::spares_distances(nc::CycleId cycle, std::uint32_t given) const {
    if (said_cycle.is_active && said_cycle.is_running) return false;
    const nc::CycleInfo::Roles& roles = target.cycles()[cycle].roles;
    const auto is_given = [&](int role) { return role >= 0 && (given >> role & 1u) != 0; };
    return (is_given(roles.stroke) || is_given(roles.shift)) &&
           target.has_rule("cycle_distances_scaled", "no");
}

bool Expander::State::emit_cycle(nc::CycleId cycle, const sema::Slot* registers) {
    if (!options.native_cycles || !recordings.empty()) return false;
    const CallFrame& frame = frames.back();
    if (is_between_places() && frame.return_to > 0) {
        cycle_active("another cycle", frame.return_to - 1);
        return true;
    }
    const std::vector<sema::ParameterInfo>& parameters = frame.function->parameters;
    using Kind = sema::ParameterInfo::Kind;
    std::uint32_t given = 0;
    std::array<double, nc::kMaxArguments> values{};
    KADR_ASSERT(parameters.size() <= values.size(), "a cycle has more parameters than a block");
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const sema::Slot slot = registers[parameters[i].slot];
        const Kind kind = parameters[i].kind;
        const bool is_number = kind == Kind::Number || kind == Kind::Feed || kind == Kind::Speed;
        const bool is_given =
            is_number ? slot.number == slot.number : slot.integer != sema::kNotGivenInteger;
        if (!is_given) continue;
        given |= 1u << i;
        values[i] = is_number ? slot.number : static_cast<double>(slot.integer);
        if (kind != Kind::Feed && kind != Kind::Speed) continue;
        // Cycles of controls know feeds per minute and speeds in turns only.
        if (sema::is_second_form(values[i])) return false;
        values[i] = neat(values[i] * kMinute);
    }
    if (!target.has_native_cycle(cycle, given, {values.data(), parameters.size()})) return false;
    // Under inverse time F belongs to a block, and a cycle is many.
    if (modal[Group::FeedMode] == Function::FeedInverseTime) return false;
    if (modal.frame.has_scale() && spares_distances(cycle, given)) return false;
    const std::uint32_t at = frame.return_to > 0 ? frame.return_to - 1 : 0;
    if (modal.lost != 0 && !knows_for_cycle(*frame.function, given, at)) return true;
    const bool needs_feed = std::ranges::none_of(parameters, says_feed);
    if (needs_feed && modal.is_feed_lost) return !feed_lost(at, frames.size() - 1);
    if (options.warns_of_cuts && is_cut_doubtful() && !turns_spindle(parameters, given, values))
        warn_of_cut(at, needs_feed);
    if (has_failed) return true;
    if (is_block_limit(at)) return true;
    if (modal.has_ended) warn_after_end(at);
    const Instruction& call = code.instructions[at];
    const SourceId source{static_cast<std::uint32_t>(call.immediate.pair.first)};
    if (modal.diameter_due != Function::None) say_diameter_alone(source, at, frames.size() - 1);
    Block& block = next_block(source);
    nc::Invocation* invocation = block.add(Function::Cycle, parameters.size());
    KADR_ASSERT(invocation != nullptr, "a cycle has more parameters than a block holds");
    block.cycle = cycle;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if ((given >> i & 1u) != 0) block.set_argument(*invocation, i, values[i]);
    }
    // The contract of a cycle: it ends where it began, after a move at rapid.
    modal.active[static_cast<std::size_t>(Group::Motion)] = Function::Rapid;
    modal.changed_by[static_cast<std::size_t>(Group::Motion)] = source;
    modal.restate_motion = true;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if ((given >> i & 1u) == 0) continue;
        if (parameters[i].name == "initial") {
            modal.position[2] = values[i];
            modal.known = static_cast<AxisMask>(modal.known | bit(Axis::Z));
        } else if (parameters[i].name == "after") {
            modal.set_spindle(values[i], source);
        }
    }
    if (options.trace) {
        // As if the block stood at the call.
        const CallFrame callee = frames.back();
        frames.pop();
        keep_trace(at, call.c, source);
        frames.push() = callee;
    }
    return true;
}

// ---------------------------------------------------------------- frames

bool Expander::State::change_frame(const Instruction& instruction, const sema::Slot* registers,
                                   std::uint32_t at) {
    if (!recordings.empty()) return refuse_block("a frame", at);
    const sema::Slot* values = registers + instruction.a;
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    const auto change = static_cast<sema::FrameChange>(instruction.b);
    const std::size_t count = change == sema::FrameChange::Rotate  ? 4
                              : change == sema::FrameChange::Scale ? 7
                                                                   : 3;
    if (modal.lost != 0 && !knows_frame(change == sema::FrameChange::Rotate, at)) return false;
    std::array<double, 7> numbers{};
    std::array<bool, 7> is_given{};
    for (std::size_t i = 0; i < count; ++i) {
        is_given[i] = values[i].number == values[i].number;
        numbers[i] = is_given[i] ? values[i].number : 0;
        if (!is_sane(numbers[i])) {
            math_fault(sema::MathFault::Overflow, at);
            return false;
        }
    }
    const auto three = [&](std::size_t first) {
        return std::array<double, 3>{numbers[first], numbers[first + 1], numbers[first + 2]};
    };
    const std::array<bool, 3> given{is_given[0], is_given[1], is_given[2]};
    ProgramFrame next = modal.frame;
    switch (change) {
        case sema::FrameChange::Shift: next.add_shift(three(0), given); break;
        case sema::FrameChange::Rotate: {
            const FrameFault why = next.add_rotation(numbers[0], modal[Group::Plane], three(1));
            if (why == FrameFault::None) break;
            fault(why == FrameFault::Planes ? diag::FramePlanes : diag::FrameStretched, at);
            return false;
        }
        case sema::FrameChange::Scale: {
            std::array<double, 3> factors{};
            for (std::size_t i = 0; i < 3; ++i) {
                factors[i] = is_given[4 + i] ? numbers[4 + i] : is_given[0] ? numbers[0] : 1;
                if (factors[i] > 0) continue;
                fault(diag::FrameScale, at).arg(factors[i]);
                return false;
            }
            next.add_scale(factors, three(1));
            break;
        }
        case sema::FrameChange::Mirror: next.add_mirror(given); break;
    }
    write_frame(next, source, at, instruction.c);
    return !has_failed;
}

/// Where a control has no words for coordinates and distances beside each other, its writer needs
/// to know where the tool is in the new frame; so does one that says another F for a helix.
void Expander::State::say_place(const sema::Plan& plan, const Instruction& instruction,
                                std::uint32_t at) {
    const nc::SlotMask known = modal.known & nc::kTargetSlots;
    const bool moves = plan.given != 0 || !plan.fillings.empty();
    if (!moves || !recordings.empty()) return;
    modal.is_place_due = false;
    const bool counts_by_arc = (plan.customs & sema::custom::kFeedOfArc) != 0;
    const bool counts_alike = counts_by_arc == target.has_rule("helix_feed_along_arc");
    if (known == 0 || (target.has_distance_words() && counts_alike)) return;
    const SourceId source{static_cast<std::uint32_t>(instruction.immediate.pair.second)};
    Block& block = next_block(source);
    block.kind = Block::Kind::Position;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const auto slot = static_cast<nc::Slot>(i);
        if ((known & nc::bit(slot)) != 0) block.set(slot, modal.position[i]);
    }
    if (options.trace) keep_trace(at, instruction.c, source);
}

/// Frames have radii in the language; a control may take them as what X is.
void Expander::State::scale_frame_x(Block& block, double factor) const {
    if (!modal.is_diameter) return;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        nc::Invocation& invocation = block.functions[i];
        const std::optional<std::size_t> x = nc::frame_x(invocation.function);
        if (!x || (invocation.given >> *x & 1u) == 0) continue;
        block.set_argument(invocation, *x, factor * block.argument(invocation, *x));
    }
}

/// Says the way from the present frame to another one in functions that every control has: the
/// whole shift, which deletes all else, then mirrors, scale and rotation anew, in the order in
/// which FANUC takes them. An unequal scale stands inside the rotation.
void Expander::State::write_frame(const ProgramFrame& next, SourceId source, std::uint32_t at,
                                  unsigned depth) {
    const ProgramFrame from = modal.frame;
    const bool is_lost = (modal.lost & sema::kFrameBit) != 0;  // whatever acts is deleted
    if (from == next && !is_lost) return;
    const auto add = [&](Function function, std::span<const double> values,
                         std::span<const bool> given) {
        if (has_failed || is_block_limit(at)) return;
        Block& block = next_block(source);
        nc::Invocation* invocation = block.add(function, values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (given[i]) block.set_argument(*invocation, i, values[i]);
        }
        if (has_frame_diameter) scale_frame_x(block, 2);
        if (options.trace) keep_trace(at, depth, source);
    };
    const std::array<bool, 3> none{};
    // What is in force already need not be said anew, if nothing behind it has to go.
    const bool keeps_shift = from.shift == next.shift && from.is_shifted == next.is_shifted;
    const bool keeps_mirrors = !from.has_mirror() || from.is_mirrored == next.is_mirrored;
    const bool adds_only =
        keeps_shift && keeps_mirrors && from.angle_deg == 0 && !from.has_scale() && !is_lost;
    if (!adds_only) {
        std::array<bool, 3> given = next.is_shifted;
        const bool is_zero = next.shift == std::array<double, 3>{};
        if (is_zero) {
            given = none;
            // A component that was shifted before must be named to go back.
        } else {
            for (std::size_t i = 0; i < 3; ++i)
                given[i] = given[i] || from.is_shifted[i] || is_lost;
        }
        add(Function::Shift, next.shift, given);
    }
    const auto add_rotation = [&] {
        if (next.angle_deg == 0) return;
        const std::array<double, 3> center = next.inner_center();
        const bool has_center = next.has_center();
        const bool is_xy = next.plane == Function::PlaneXy;
        const bool is_zx = next.plane == Function::PlaneZx;
        add(Function::Rotate, std::array{next.inner_angle_deg(), center[0], center[1], center[2]},
            std::array{true, has_center && (is_xy || is_zx), has_center && !is_zx,
                       has_center && !is_xy});
    };
    if (next.has_mirror() && !(adds_only && from.has_mirror()))
        add(Function::Mirror, std::array<double, 3>{}, next.is_mirrored);
    if (next.is_stretched(next.plane)) add_rotation();
    if (next.has_scale()) {
        const auto& [fx, fy, fz] = next.scale;
        const bool is_equal = fx == fy && fy == fz;
        add(Function::Scale, std::array<double, 7>{fx, 0, 0, 0, fx, fy, fz},
            std::array{is_equal, false, false, false, !is_equal && fx != 1, !is_equal && fy != 1,
                       !is_equal && fz != 1});
    }
    if (!next.is_stretched(next.plane)) add_rotation();
    modal.set_frame(next, source);
    modal.lost &= ~sema::kFrameBit;
}

// ---------------------------------------------------------------- with, preserves

bool Expander::State::leave_with(SourceId source, std::uint32_t at, unsigned depth) {
    const OpenWith scope = withs.back();
    withs.pop_back();
    return set_back(scope, source, at, depth);
}

bool Expander::State::set_back(const OpenWith& scope, SourceId source, std::uint32_t at,
                               unsigned depth) {
    const ModalState& before = scope.before;
    if ((scope.mask & sema::kFrameBit) != 0) {
        write_frame(before.frame, source, at, depth);
        if (has_failed) return false;
    }
    // Another feed mode forgets F, so F goes back with it.
    sema::ModalMask mask = scope.mask;
    if ((mask & sema::group_bit(Group::FeedMode)) != 0) mask |= sema::kFeedBit;
    if ((mask & sema::group_bit(Group::SpeedMode)) != 0) mask |= sema::kSpeedBit;
    const sema::ModalMask changed = difference(before, modal, mask) & ~sema::kFrameBit;
    if (changed == 0) return true;
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        if ((changed >> i & 1u) == 0 || before.active[i] != Function::None) continue;
        fault(diag::StateUnknown, at).arg(nc::group_name(static_cast<Group>(i)));
        return false;
    }
    // Behind a `with` that set the first F there is none, and none there is behind this one.
    const sema::ModalMask no_value = before.lost_in == Loss::EndOfWith ? sema::kFeedBit : 0;
    const sema::ModalMask values =
        changed & before.lost & ~no_value & (sema::kFeedBit | sema::kSpeedBit);
    if (values != 0) {
        fault(diag::StateUnknown, at).arg((values & sema::kFeedBit) != 0 ? "F" : "S");
        return false;
    }
    if ((changed & sema::kFeedBit) != 0 && !before.has_feed) modal.forget_feed(source);
    // The same number means something else in another mode, so it goes back with the mode.
    const sema::ModalMask of_feed = sema::kFeedBit | sema::group_bit(Group::FeedMode);
    const sema::ModalMask of_speed = sema::kSpeedBit | sema::group_bit(Group::SpeedMode);
    const bool feed = (changed & of_feed) != 0 && before.has_feed;
    const bool speed = (changed & of_speed) != 0 && before.has_speed;
    const bool groups = (changed & ~(sema::kFeedBit | sema::kSpeedBit)) != 0;
    if (!groups && !feed && !speed) return true;
    if (is_block_limit(at)) return false;
    Block& block = next_block(source);
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        if ((changed >> i & 1u) == 0) continue;
        const Function member = before.active[i];
        if (static_cast<Group>(i) == Group::Motion) {
            block.motion = member;
            continue;
        }
        const std::size_t parameters = nc::info(member).parameters.size();
        nc::Invocation* invocation = block.add(member, parameters);
        if (member == Function::WorkOffset) block.set_argument(*invocation, 0, before.work_offset);
        if (member == Function::LengthCompOn && before.has_length_offset) {
            block.set_argument(*invocation, 0, before.length_offset);
        }
    }
    if (feed) block.set(nc::Slot::Feed, before.feed);
    if (speed) block.set(nc::Slot::Speed, before.speed);
    if ((changed & sema::group_bit(Group::LengthComp)) != 0 && !take_core_offsets(block, at))
        return false;
    modal.take_functions(block);
    modal.take_words(block);
    if (options.trace) keep_trace(at, depth, source);
    return true;
}

/// What a cycle preserves it also relies on: `preserves G90` called under G91 would work with
/// distances where its author wrote coordinates.
bool Expander::State::check_needs(std::uint32_t at) {
    const CallFrame& frame = frames.back();
    for (const Function needed : frame.function->needs) {
        const Function active = modal[nc::info(needed).group];
        const bool is_lost = (modal.lost & sema::group_bit(nc::info(needed).group)) != 0;
        if (active == needed || (active == Function::None && !is_lost)) continue;
        const bool is_called = frames.size() > 1 && frame.return_to > 0;
        if (is_lost) {
            const std::string name(nc::info(needed).name);
            tell_loss(is_called ? fault_in(diag::StateLost, frame.return_to - 1, frames.size() - 1)
                                : fault(diag::StateLost, at),
                      "whether `" + name + "` is active, as `" + frame.function->name + "` needs,",
                      "say `" + name + "` before it");
            return false;
        }
        DiagnosticBuilder builder =
            is_called ? fault_in(diag::StateNeeded, frame.return_to - 1, frames.size() - 1)
                      : fault(diag::StateNeeded, at);
        builder.arg(frame.function->name).arg(nc::info(needed).name).arg(nc::info(active).name);
        const SourceId by = modal.changed_by[static_cast<std::size_t>(nc::info(needed).group)];
        if (by.is_valid() && by.index < code.statements.size()) {
            builder.note(code.statements[by.index], "it was changed here last");
        }
        return false;
    }
    return true;
}

bool Expander::State::check_preserves(std::uint32_t at) {
    const OpenWith& promise = promises.back();
    if (modal.lost != 0 && !keep_promise(promise, at)) return false;
    const sema::ModalMask broken = difference(promise.before, modal, promise.mask);
    if (broken == 0) return true;
    const auto report = [&](std::string_view what, SourceId by) {
        DiagnosticBuilder builder = fault(diag::PromiseBroken, at);
        builder.arg(frames.back().function->name).arg(what);
        if (by.is_valid() && by.index < code.statements.size()) {
            builder.note(code.statements[by.index], "it was changed here last");
        }
    };
    for (std::size_t i = 0; i < nc::kGroups; ++i) {
        if ((broken >> i & 1u) == 0) continue;
        report(nc::group_name(static_cast<Group>(i)), modal.changed_by[i]);
        return false;
    }
    if ((broken & sema::kFrameBit) != 0) report("the frames", modal.frame_by);
    else if ((broken & sema::kFeedBit) != 0) report("F", modal.feed_by);
    else report("S", modal.speed_by);
    return false;
}

}  // namespace kadr::expand
