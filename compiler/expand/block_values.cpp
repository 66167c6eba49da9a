#include "expand/block_values.h"

#include <string>

#include "base/diagnostics/expand.h"
#include "base/readable.h"
#include "expand/faults.h"
#include "expand/feed_words.h"
#include "expand/numbers.h"
#include "expand/text_format.h"
#include "expand/unknown.h"

namespace kadr::expand {

using nc::Block;
using nc::Function;
using nc::Group;
using sema::Filling;

namespace {

constexpr double kMmPerMeter = 1000;

Done fill_speed(Running& run, Block& block, const Filling& filling, double value,
                std::uint32_t at) {
    if (value != value) {
        not_given(run, "S", word_of(run, filling, at));
        return kFailed;
    }
    if (run.modal.lost.what() != 0 && !require_speed_mode(run, word_of(run, filling, at)))
        [[unlikely]]
        return kFailed;
    const bool is_cutting = run.modal[Group::SpeedMode] == Function::CuttingSpeedOn;
    Filling::Form form = filling.form;
    if (form == Filling::Form::Speed) {
        const bool second = sema::is_second_form(value);
        if (second) value /= sema::kSecondForm;
        form = second ? Filling::Form::SpeedCutting : Filling::Form::SpeedPerTime;
    }
    if (form == Filling::Form::SpeedBare) {
        if (is_cutting) value *= filling.factor;
    } else if (is_cutting != (form == Filling::Form::SpeedCutting)) {
        fault(run, diag::SpeedMode, word_of(run, filling, at))
            .arg(is_cutting ? "a spindle speed" : "a cutting speed")
            .arg(is_cutting ? "on" : "off");
        return kFailed;
    } else {
        value *= is_cutting ? kMinute / kMmPerMeter : kMinute;
    }
    if (!is_sane(value)) {
        math_fault(run, sema::MathFault::Overflow, at);
        return kFailed;
    }
    if (is_cutting && value == 0) {
        fault(run, diag::CuttingSpeedZero, word_of(run, filling, at));
        return kFailed;
    }
    block.set(nc::Slot::Speed, neat(value));
    return kDone;
}

}  // namespace

std::uint32_t word_of(const Running& run, const Filling& filling, std::uint32_t at) {
    const Instruction& emit = run.code.instructions[at];
    if (emit.op != OpCode::Emit) return at;  // a feed of `follow`
    const sema::Plan& plan = run.code.plans[static_cast<std::size_t>(emit.immediate.pair.first)];
    const auto value = static_cast<std::uint16_t>(emit.a + (&filling - plan.fillings.data()));
    const SourceRange block = run.code.locations[at];
    for (std::uint32_t i = at; i-- > 0;) {
        const SourceRange location = run.code.locations[i];
        const bool is_inside = location.file == block.file && location.begin >= block.begin &&
                               location.end <= block.end;
        if (!is_inside) break;
        if (run.code.instructions[i].a == value) return i;
    }
    return at;
}

Done fill(Running& run, Block& block, const Filling& filling, sema::Slot value, std::uint32_t at) {
    double number = value.number;
    switch (filling.form) {
        case Filling::Form::Text:
            block.text = run.vm.heap.text(value.integer);
            block.functions[filling.invocation].given |= 1u << filling.parameter;
            return kDone;
        case Filling::Form::Count:
            if (value.integer == sema::kNotGivenInteger) {
                not_given(run, {}, word_of(run, filling, at));
                return kFailed;
            }
            number = static_cast<double>(value.integer);
            break;
        case Filling::Form::FeedBare:
        case Filling::Form::Feed:
        case Filling::Form::FeedPerTime:
        case Filling::Form::FeedPerTurn:
        case Filling::Form::FeedInverse: return fill_feed(run, block, filling, number, at);
        case Filling::Form::SpeedBare:
        case Filling::Form::Speed:
        case Filling::Form::SpeedPerTime:
        case Filling::Form::SpeedCutting: return fill_speed(run, block, filling, number, at);
        case Filling::Form::Diameter:
            if (!run.modal.is_diameter) number /= 2;
            break;
        case Filling::Form::Plain: break;
    }
    if (!is_sane(number)) {
        if (number != number) not_given(run, {}, word_of(run, filling, at));
        else math_fault(run, sema::MathFault::Overflow, at);
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

Done fill_feed(Running& run, Block& block, const Filling& filling, double value, std::uint32_t at) {
    if (value != value) {
        not_given(run, "F", word_of(run, filling, at));
        return kFailed;
    }
    if (run.modal.lost.what() != 0 && !require_feed_mode(run, word_of(run, filling, at)))
        [[unlikely]]
        return kFailed;
    const Function mode = run.modal[Group::FeedMode];
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
        DiagnosticBuilder builder = fault(run, diag::FeedMode, word_of(run, filling, at));
        builder.arg(feed_word(needed)).arg(feed_word(mode));
        note_statement(run, builder, run.modal.by(Group::FeedMode), "the feed mode was set here");
        builder.fix(std::string("say `") + feed_code(needed) + "` before it, or give the feed in " +
                    feed_unit(mode));
        return kFailed;
    }
    if (!is_sane(value)) {
        math_fault(run, sema::MathFault::Overflow, at);
        return kFailed;
    }
    if (!(value > 0)) {
        const std::string feed = mode == Function::FeedInverseTime ? readable(value)
                                 : mode == Function::FeedPerRevolution
                                     ? quantity_text(run, value, sema::kFeedPerTurn)
                                     : quantity_text(run, value / kMinute, sema::kFeedPerTime);
        fault(run, diag::FeedZero, word_of(run, filling, at)).arg(feed);
        return kFailed;
    }
    block.set(nc::Slot::Feed, neat(value));
    return kDone;
}

double state_value(const Running& run, sema::StateValue which) {
    if (which == sema::StateValue::Feed) {
        if (!run.modal.feed.is_known()) return sema::kNotGivenNumber;
        switch (run.modal[Group::FeedMode]) {
            case Function::FeedPerRevolution: return run.modal.feed.value() * sema::kSecondForm;
            case Function::FeedPerMinute: return run.modal.feed.value() / kMinute;
            default: return sema::kNotGivenNumber;
        }
    }
    if (!run.modal.speed.is_known()) return sema::kNotGivenNumber;
    if (run.modal[Group::SpeedMode] == Function::CuttingSpeedOn) {
        return run.modal.speed.value() * kMmPerMeter / kMinute * sema::kSecondForm;
    }
    return run.modal.speed.value() / kMinute;
}

std::int64_t spindle_code(const Running& run) {
    const Function spindle = run.modal[Group::Spindle];
    return spindle == Function::None ? sema::kNotGivenInteger : nc::code_of_spindle(spindle);
}

}  // namespace kadr::expand
