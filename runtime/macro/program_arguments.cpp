// program_arguments.cpp — the main program is called with arguments, as a control calls it from
// another program.
#include <algorithm>

#include "base/diagnostics/control.h"
#include "base/diagnostics/driver.h"
#include "macro/program_run.h"
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

Outcome prepare_arguments(ProgramRun& run, CompiledLine& line) {
    if (line.text.empty()) return Outcome::Nothing;
    line.context = run.context();
    run.line_compiler.compile_language(line);
    if (run.lines.faults().failed()) return Outcome::Failed;
    if (line.line.calls.size() != 1)
        return run.fail(line, diag::CallIncomplete, {0, 1}, {*run.options.call});
    const nc::Call& words = line.line.calls[0];
    PreparedCall call;
    call.unit = &run.units.main();
    if (words.form >= 0)
        call.form = &run.language.calls.calls[static_cast<std::size_t>(words.form)];
    if (call.is_macro()) {
        const Outcome done = run.call_preparation.prepare_letters(line, words, call);
        if (!goes_on(done)) return done;
        run.frame->own_level = call.level;
        run.frame->level = call.level.get();
        run.resume_frame(*run.frame);
        return Outcome::Nothing;
    }
    run.units.look_for_main_head();
    const nc::ControlStatement* const head = run.units.main().procedure();
    const std::string name(called_name(*run.options.call));
    const bool is_same = name.empty() || head == nullptr ||
                         nc::ControlWords(run.tables, name).is_same(name, head->name);
    if (!is_same) return run.fail(line, diag::ProgramMissing, {0, 1}, {'`' + name + '`'});
    const Outcome done = run.call_preparation.prepare_list(line, words, call);
    if (!goes_on(done)) return done;
    return run.call_parameters.bind(line, call, *run.frame);
}

}  // namespace

Outcome begin_with_arguments(ProgramRun& run) {
    CompiledLine line;
    line.text = call_line(run.language.calls, *run.options.call);
    line.program_line = {run.frame->here, run.frame->here};
    nc::TextBounds apart;
    apart.name = "--call";
    run.lines.bounds().enter(apart);
    run.lines.begin(1);
    DiagnosticList heard;
    run.ear.listen(&heard);
    const Outcome done = prepare_arguments(run, line);
    run.ear.listen(nullptr);
    if (run.lines.faults().failed() || line.text.empty()) {
        run.lines.faults().forget_fault();
        const auto location =
            run.lines.location(line.text.empty() ? *run.options.call : line.text, 1, {0, 1});
        const bool is_reported = !heard.all().empty();
        run.sink
            .report(diag::CallWrong,
                    is_reported ? heard.all()[0].line.value_or(location) : location)
            .arg(is_reported
                     ? heard.all()[0].message()
                     : std::string("`" + *run.options.call + "` is no list of arguments here"));
        run.lines.faults().note_fault();
        run.end();
    }
    run.lines.bounds().enter(run.frame->text);
    if (done != Outcome::Wait) run.frames[0]->is_called = true;
    return done;
}

}  // namespace kadr::macro
