// program_arguments.cpp — the main program is called with arguments, as a control calls it from
// another program.
#include <algorithm>

#include "base/diagnostics/control.h"
#include "base/diagnostics/driver.h"
#include "macro/program_state.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::CallForm;

namespace {

/// The name that stands for the program, which is known without it.
constexpr std::string_view kNamed = "KADR_CALL";

/// A line of the control that makes the call; empty: it has none with arguments.
std::string call_line(const nc::CallLanguage& calls, std::string_view arguments) {
    const std::size_t first = std::min(arguments.find_first_not_of(" \t"), arguments.size());
    const std::size_t bracket = arguments.find('(');
    const bool has_names = std::ranges::any_of(
        calls.calls, [](const CallForm& form) { return form.is_name && form.code == "{name}"; });
    // `NAME(1,2)` or `(1,2)`; nothing calls a procedure without arguments.
    if (has_names && (bracket < arguments.size() || first == arguments.size())) {
        return std::string(kNamed) +
               std::string(bracket < arguments.size() ? arguments.substr(bracket) : "");
    }
    if (bracket < arguments.size()) return {};  // a comment, where no call has a list
    const auto macro = std::ranges::find_if(calls.calls, [](const CallForm& form) {
        return form.kind == CallForm::Kind::Macro && form.modal == CallForm::Modal::None &&
               form.program != '\0' && !form.is_name && !form.any_number && form.fixed.empty();
    });
    if (macro == calls.calls.end()) return {};
    return macro->code + ' ' + macro->program + "1 " + std::string(arguments);
}

/// The name in front of the list of arguments; empty: there is none.
std::string_view called_name(std::string_view arguments) {
    const std::size_t first = arguments.find_first_not_of(" \t");
    const std::size_t bracket = arguments.find('(');
    if (first >= bracket || bracket == std::string_view::npos) return {};
    const std::string_view name = arguments.substr(first, bracket - first);
    return name.substr(0, name.find_last_not_of(" \t") + 1);
}

}  // namespace

Program::State::Outcome Program::State::begin_with_arguments() {
    CompiledLine line;
    line.text = call_line(language.calls, *options.call);
    line.place = {frame->here, frame->here};
    nc::TextState apart;
    apart.name = "--call";
    lines.enter(apart);
    lines.begin(1);
    DiagnosticList heard;
    ear.listen(&heard);
    const Outcome done = prepare_arguments(line);
    ear.listen(nullptr);
    if (lines.failed() || line.text.empty()) {
        lines.forget_fault();
        const auto place = lines.place(line.text.empty() ? *options.call : line.text, 1, {0, 1});
        const bool is_told = !heard.all().empty();
        sink.report(diag::CallWrong, is_told ? heard.all()[0].line.value_or(place) : place)
            .arg(is_told ? heard.all()[0].message()
                         : std::string("`" + *options.call + "` is no list of arguments here"));
        lines.note_fault();
        has_ended = true;
    }
    lines.enter(frame->text);
    if (done != Outcome::Wait) frames[0]->is_called = true;
    return done;
}

Program::State::Outcome Program::State::prepare_arguments(CompiledLine& line) {
    if (line.text.empty()) return Outcome::Nothing;
    line.context = context();
    compile_language(line);
    if (lines.failed()) return Outcome::Failed;
    if (line.line.calls.size() != 1)
        return fail(line, diag::CallIncomplete, {0, 1}, {*options.call});
    const nc::Call& words = line.line.calls[0];
    PreparedCall call;
    call.unit = &units.main();
    if (words.form >= 0) call.form = &language.calls.calls[static_cast<std::size_t>(words.form)];
    if (call.is_macro()) {
        const Outcome done = prepare_letters(line, words, call);
        if (!goes_on(done)) return done;
        frame->own_level = call.level;
        frame->level = call.level.get();
        resume_frame(*frame);
        return Outcome::Nothing;
    }
    units.look_for_main_head();
    const nc::ControlStatement* const head = units.main().procedure();
    const std::string name(called_name(*options.call));
    const bool is_same =
        name.empty() || head == nullptr || nc::ControlWords(tables, name).is_same(name, head->name);
    if (!is_same) return fail(line, diag::ProgramMissing, {0, 1}, {'`' + name + '`'});
    const Outcome done = prepare_list(line, words, call);
    if (!goes_on(done)) return done;
    return bind_parameters(line, call, *frame);
}

}  // namespace kadr::macro
