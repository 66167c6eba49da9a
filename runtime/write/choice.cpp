#include "write/choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/assert.h"
#include "base/diagnostics/dialect.h"
#include "nc/builder_codes.h"
#include "nc/frame_words.h"
#include "nc/quoted.h"
#include "nc/refusals.h"

namespace kadr::write {

namespace {

/// Groups whose active member is not written again. Spindle, coolant, work offset and length
/// compensation are: a tool change, an operator or another program may have changed them.
constexpr bool is_quiet_group(Group group) {
    switch (group) {
        case Group::Motion:
        case Group::Plane:
        case Group::Units:
        case Group::Distance:
        case Group::FeedMode:
        case Group::SpeedMode:
        case Group::RadiusComp:
        case Group::PathMode:
        case Group::CycleMode:
        case Group::CycleReturn:
        case Group::CompStart:
        case Group::CompCorner:
        case Group::CompCheck:
        case Group::Diameter:
        case Group::Compressor:
        case Group::Transformation:
        case Group::OrientInterpolation:
        case Group::OrientAngles:
        case Group::OrientSystem:
        case Group::CompKind:
        case Group::CompOrientation:
        case Group::Spinning:
        case Group::DataInput: return true;
        case Group::NonModal:
        case Group::LengthComp:
        case Group::WorkOffsets:
        case Group::Spindle:
        case Group::Coolant: return false;
    }
    return false;
}

}  // namespace

Choice FormChooser::choose(const Block& block) {
    Choice choice;
    // Forms that write several functions at once come first, so that nothing is written twice.
    for (const bool with_others : {true, false}) {
        for (std::size_t i = 0; i < block.function_count; ++i) {
            const Invocation& invocation = block.functions[i];
            const auto function = static_cast<std::size_t>(invocation.function);
            if (tables_.given_with_others[function] != with_others || (choice.done >> i & 1u) != 0)
                continue;
            // Where cycles are modal by themselves, no word says it.
            const bool has_no_word = invocation.function == Function::CycleModal &&
                                     tables_.rules.modal_cycles &&
                                     block.find(Function::Cycle) != nullptr;
            if (has_no_word || is_suppressed(invocation.function)) {
                choice.done |= 1u << i;
                continue;
            }
            if (is_left_to_machine(invocation)) {
                leave_to_machine(block, invocation);
                choice.done |= 1u << i;
                continue;
            }
            choice.forms[i] = choose_form(block, invocation);
            if (choice.forms[i] == kNoForm) {
                choice.done |= 1u << i;
                continue;
            }
            const Form& form = tables_.forms[choice.forms[i]];
            for (std::size_t j = 0; j < block.function_count; ++j) {
                const Function other = block.functions[j].function;
                const bool is_given =
                    j != i && (other == form.function ||
                               std::ranges::find(form.sets, other) != form.sets.end());
                if (is_given && !form.sets.empty()) choice.done |= 1u << j;
            }
        }
    }
    return choice;
}

bool FormChooser::is_suppressed(Function function) const {
    const Group group = info(function).group;
    // Where the letters tell it, no code does.
    if (group == Group::Distance && tables_.has_incremental_letters) return true;
    return is_quiet_group(group) && modal_.text[index_of(group)] == function &&
           (!options_.verbose_modal || !text_.has_code(function));
}

/// Whether X is a diameter, on a control that has neither a code for it nor a rule: its text is the
/// same, and right where the machine is set so.
bool FormChooser::is_left_to_machine(const Invocation& invocation) const {
    return info(invocation.function).group == Group::Diameter &&
           !text_.has_code(Function::DiameterOn) && !text_.has_code(Function::DiameterOff) &&
           tables_.power_on[index_of(Group::Diameter)] == Function::None;
}

void FormChooser::leave_to_machine(const Block& block, const Invocation& invocation) {
    if (messages_.first_time(block, info(invocation.function).name)) {
        const bool is_diameter = invocation.function == Function::DiameterOn;
        messages_.report(diag::DiameterLeft, block)
            .arg(tables_.name)
            .arg(is_diameter ? "diameter" : "radius")
            .fix("for a lathe take the dialect of one, as `fanuc-lathe` is");
    }
    state_.assume(invocation.function);
}

/// Why the form cannot write what was given, or lacks what it needs.
FormChooser::Misfit FormChooser::misfit(const Form& form, const Block& block,
                                        const Invocation& invocation) const {
    Misfit misfit;
    std::uint32_t said = 0;
    int first_name = -1;  // parameter of the first word that names an axis
    bool names_axis = false;
    const auto argument = [&](int parameter, double fallback) {
        return block.argument(invocation, static_cast<std::size_t>(parameter), fallback);
    };
    const auto expect = [&](int parameter, bool is_right) {
        if (!is_right) misfit.parameters |= 1u << parameter;
    };
    const auto look = [&](const auto& self, const std::vector<FormWord>& words) -> void {
        for (const FormWord& word : words) {
            self(self, word.arguments);
            if (word.parameter < 0) continue;
            said |= 1u << word.parameter;
            if (word.tail_parameter >= 0) {
                said |= 1u << word.tail_parameter;
                expect(word.tail_parameter, (invocation.given >> word.tail_parameter & 1u) != 0);
            }
            // The word's presence is all that the control takes: another value would be lost.
            const bool is_given = (invocation.given >> word.parameter & 1u) != 0;
            if (word.is_named_only) {
                expect(word.parameter, argument(word.parameter, 0) == 0);
                if (first_name < 0) first_name = word.parameter;
                names_axis |= is_given;
            }
            const bool has_text = !block.text.empty() && (word.kind == FormWord::Kind::Text ||
                                                          word.kind == FormWord::Kind::Quoted);
            expect(word.parameter, is_given || has_text || word.is_optional || word.has_default);
        }
    };
    look(look, form.words);
    for (const std::vector<FormWord>& line : form.extra) look(look, line);
    look(look, form.lead);
    // Without an axis the code stands alone, and means nothing or something else.
    if (first_name >= 0) expect(first_name, names_axis);
    for (const int parameter : form.implied) said |= 1u << parameter;
    if (form.spindle_parameter >= 0) said |= 1u << form.spindle_parameter;
    for (const int parameter : form.drops) said |= 1u << parameter;
    for (const auto& [parameter, value] : form.fixed) {
        said |= 1u << parameter;
        const bool is_given = (invocation.given >> parameter & 1u) != 0;
        const bool may_lack =
            tables_.parameters(form)[static_cast<std::size_t>(parameter)].is_optional;
        expect(parameter, is_given ? argument(parameter, 0) == value : may_lack);
    }
    for (const Constraint& c : form.when) {
        const double value = argument(c.parameter, c.least);
        expect(c.parameter, value >= c.least && value <= c.most);
    }
    if (form.is_by_number) {
        constexpr int kNumber = parameter_of<Function::MachineFunction>("number");
        const double number = argument(kNumber, 0);
        expect(kNumber, is_builder_code(tables_, form.words[0].address, number));
    }
    misfit.parameters |= invocation.given & ~said;
    misfit.lacking = misfit.parameters & ~invocation.given;
    for (const Function needed : form.during) {
        const Group group = info(needed).group;
        // What the text does not agree upon with the program is written again in this block.
        const bool is_restored = group == Group::Distance && (block.given & kTargetSlots) != 0 &&
                                 modal_.meant[index_of(group)] == needed;
        const bool is_programmed = group == Group::Motion &&
                                   text_.effective_motion(block) == needed &&
                                   (block.motion == needed || (block.given & kTargetSlots) != 0);
        // In its own line the block programs it for the form, or the contrary.
        const bool is_alone = form.owns_block || form.owns_line;
        const Function own = is_alone ? Function::None : programmed_in(block, group);
        const bool is_active = own != Function::None ? own == needed
                                                     : modal_.text[index_of(group)] == needed ||
                                                           is_restored || is_programmed;
        if (!is_active) misfit.state = needed;
    }
    return misfit;
}

/// Whether the further functions of a form are wanted by the block or in force anyway.
bool FormChooser::holds(const Form& form, const Block& block, Function asked,
                        bool allow_unknown) const {
    const auto is_fine = [&](Function also) {
        if (also == asked || block.find(also) != nullptr || block.motion == also) return true;
        const Group group = info(also).group;
        for (std::size_t i = 0; i < block.function_count; ++i) {
            if (info(block.functions[i].function).group == group)
                return false;  // the block wants another
        }
        const Function active = modal_.text[index_of(group)];
        return active == also || (allow_unknown && active == Function::None);
    };
    return is_fine(form.function) && std::ranges::all_of(form.sets, is_fine);
}

/// `M98`, `M99`: what a source has in the place of the control's calls. False: the code is none.
static bool say_call(DiagnosticBuilder& builder, const std::string& text,
                     const DialectTables& tables) {
    const auto& calls = tables.language.calls.calls;
    const auto call = std::ranges::find(calls, text, &nc::CallForm::code);
    if (call == calls.end()) return false;
    const bool is_end =
        call->kind == nc::CallForm::Kind::Return || call->kind == nc::CallForm::Kind::EndModal;
    builder.note("`" + text + "` " + (is_end ? "ends a call" : "calls a program") +
                 " on this control");
    builder.fix(is_end ? "a cycle or a function ends with its `}`, and `return;` leaves it"
                       : "what is called is a cycle or a function, by its name: `name(5mm);`");
    return true;
}

/// What the control has for a code that a program wants for the builder's, and how a dialect gives
/// it to him.
static void say_whose(DiagnosticBuilder& builder, double number, const DialectTables& tables,
                      FormId any) {
    const FormWord& word = tables.forms[any].words[0];
    const CodeStart* code = tables.find_code(word.address, number);
    const std::string text = "M" + std::to_string(std::llround(number));
    if (say_call(builder, text, tables)) return;
    std::string file = "`extends=\"" + tables.name + "\"`";
    if (code != nullptr && !code->forms.empty()) {
        const std::string own(info(tables.forms[code->forms.front()].function).name);
        if (own.empty()) {  // `M97`: read, and without effect on what is executed
            builder.note("`" + text + "` has a meaning of its own on this control");
            return;
        }
        builder.note("`" + text + "` is `" + own + "` on this control");
        file += ", takes it away with `<remove commands=\"" + own + "\"/>`";
    }
    for (const Form& form : tables.forms) {
        const bool has_it = !form.lead.empty() && form.lead[0].kind == FormWord::Kind::Fixed &&
                            form.lead[0].address == word.address && form.lead[0].number == number;
        if (!has_it || form.function != Function::Cycle) continue;
        file += ", says the forms of `" + tables.cycles[form.cycle].name + "` without `lead=\"" +
                text + "…\"`";
        break;
    }
    builder.fix("where `" + text +
                "` is the machine builder's, a dialect of this machine says so: a file that " +
                file + " and has the number in its `<command name=\"machine_function\">`");
}

FormId FormChooser::choose_form(const Block& block, const Invocation& invocation) {
    const bool is_cycle = invocation.function == Function::Cycle;
    KADR_ASSERT(!is_cycle || block.cycle < tables_.forms_of_cycle.size(),
                "a cycle of the common list");
    const auto& candidates = is_cycle
                                 ? tables_.forms_of_cycle[block.cycle]
                                 : tables_.forms_of[static_cast<std::size_t>(invocation.function)];
    // Nobody has switched on what the control does not have.
    if (candidates.empty() && invocation.function == Function::CompressOff) return kNoForm;
    Function blocking = Function::None;  // acts where it must not
    std::optional<Misfit> nearest;
    for (const bool allow_unknown : {false, true}) {
        for (const FormId id : candidates) {
            const Form& form = tables_.forms[id];
            // Parameters belong to the form's own function.
            const bool is_own = form.function == invocation.function;
            if (is_own) {
                const Misfit why = misfit(form, block, invocation);
                if (!why.is_none()) {
                    if (options_.refusals != nullptr) note_refusal(form, block, invocation, why);
                    if (!nearest || why.count() < nearest->count()) nearest = why;
                    continue;
                }
            }
            const Function around = acting_around(form, block);
            if (around != Function::None) blocking = around;
            else if (holds(form, block, invocation.function, allow_unknown)) return id;
        }
    }
    const std::string_view name = info(invocation.function).name;
    if (blocking != Function::None) {
        const bool is_frame = has_fact(invocation.function, Fact::ChangesFrame) &&
                              has_fact(blocking, Fact::ChangesFrame);
        const bool follows = is_frame && modal_.frame.is_refused;
        if (is_frame) state_.refuse_frame();
        if (messages_.fails_first_time(block, name) && !follows) {
            DiagnosticBuilder builder = messages_.report(diag::WriterFrameOrder, block);
            builder.arg(tables_.name).arg(name).arg(info(blocking).name);
            if (info(blocking).group == Group::RadiusComp)
                builder.fix(has_fact(invocation.function, Fact::SetsFrame)
                                ? "begin and end frames outside of the compensation: `G40` first"
                                : "end the compensation first: `G40`");
            if (blocking == Function::CuttingSpeedOn)
                builder.fix("end constant cutting speed first: `G97` with an S");
            if (blocking == Function::FeedInverseTime)
                builder.fix("end inverse time first: `G94` or `G95` with an F");
        }
        // Go on as if it were programmed: F and S behind it are no mistakes of their own.
        const Group group = info(invocation.function).group;
        if (group == Group::FeedMode || group == Group::SpeedMode)
            state_.assume(invocation.function);
        return kNoForm;
    }
    std::string what = quoted(name);
    if (is_cycle) what = "the cycle " + quoted(tables_.cycles[block.cycle].name);
    if (!candidates.empty()) {
        const Form& any = tables_.forms[candidates.front()];
        what += nearest ? misfit_words(tables_.parameters(any), *nearest)
                        : " with these values or in this modal state";
    }
    if (invocation.function != Function::MachineFunction || candidates.empty()) {
        messages_.cannot_express(block, what);
    } else if (messages_.fails_first_time(block, what)) {
        DiagnosticBuilder builder = messages_.report(diag::CannotExpress, block);
        builder.arg(tables_.name).arg(what);
        const double number =
            block.argument(invocation, parameter_of<Function::MachineFunction>("number"));
        say_whose(builder, number, tables_, candidates.front());
    }
    return kNoForm;
}

/// Informs whoever looks on that the form was passed over.
void FormChooser::note_refusal(const Form& form, const Block& block, const Invocation& invocation,
                               const Misfit& misfit) const {
    std::array<double, kMaxArguments> values{};
    const std::size_t count = std::min(tables_.parameters(form).size(), values.size());
    for (std::size_t i = 0; i < count; ++i) values[i] = block.argument(invocation, i, 0);
    Refusal refusal = refusal_of(tables_, form, misfit.parameters, invocation.given,
                                 std::span(values).first(count));
    if (misfit.state != Function::None) {
        if (!refusal.why.empty()) refusal.why += ", ";
        refusal.why += quoted(info(misfit.state).name) + " is not active";
    }
    options_.refusals->push_back(std::move(refusal));
}

/// " with this `back`": what the control does not take as it was given; " unless `absolute` is
/// active": when it does not take it.
std::string FormChooser::misfit_words(std::span<const Parameter> parameters, const Misfit& misfit) {
    std::string words;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if ((misfit.parameters >> i & 1u) == 0) continue;
        const bool is_lacking = (misfit.lacking >> i & 1u) != 0;
        words += words.empty() ? " " : " and ";
        words += (is_lacking ? "without " : "with this ") + quoted(parameters[i].name);
    }
    if (misfit.state != Function::None)
        words += " unless " + quoted(info(misfit.state).name) + " is active";
    return words;
}

/// Whether the block itself asks for an end of the function, which the form writes with its own.
bool FormChooser::ends_by_itself(const Form& form, const Block& block, Function around) {
    const Group group = info(around).group;
    const Function own = programmed_in(block, group);
    const auto is_of_group = [&](Function function) { return info(function).group == group; };
    return group != Group::NonModal && own != Function::None && own != around &&
           std::ranges::any_of(form.sets, is_of_group);
}

/// The function that acts and that the form must not stand inside of; None: there is none.
Function FormChooser::acting_around(const Form& form, const Block& block) const {
    for (const Function around : form.outside) {
        if (ends_by_itself(form, block, around)) continue;
        const Activity activity = text_.activity_of(around);
        // Behind raw text nobody knows, and the control reports it if it acts; but what a frame
        // means depends on those around it.
        if (activity == Activity::Yes) return around;
        if (activity == Activity::Unknown && has_fact(form.function, Fact::SetsFrame))
            return around;
    }
    return Function::None;
}

}  // namespace kadr::write
