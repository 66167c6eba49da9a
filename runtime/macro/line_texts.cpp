// line_texts.cpp — names in a line that stand for text or for numbers of variables.
#include "macro/line_texts.h"

#include <algorithm>

#include "base/diagnostics/control.h"
#include "macro/program_base.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::ControlStatement;
using nc::Statement;

Outcome LineTexts::define_macro(CompiledLine& line, const ControlStatement& statement) {
    switch (run_.frame->macros.define(run_.tables, statement.name)) {
        case TextMacros::Fault::None: break;
        case TextMacros::Fault::Form: return run_.fail(line, diag::MacroForm, statement.span);
        case TextMacros::Fault::Known:
            return run_.fail(line, diag::MacroTwice, statement.span,
                             {statement.name.substr(0, statement.name.find(' '))});
        case TextMacros::Fault::Nested:
            return run_.fail(line, diag::MacroNested, statement.span, {statement.name});
    }
    return Outcome::Nothing;
}

/// A line with the words that stand for text put in; one that defines such a word stays as it is.
std::string_view LineTexts::with_macros(std::string_view text) {
    if (auto named = names_.numbered(run_.tables, text)) {
        named_text_ = std::move(named->text);
        text = named_text_;
    }
    if (run_.frame->macros.is_empty()) return text;
    if (nc::front_of(run_.tables, text).statement == Statement::DefineMacro) return text;
    auto expanded = run_.frame->macros.expanded(run_.tables, text);
    if (!expanded) return text;
    expanded_text_ = std::move(expanded->text);
    return expanded_text_;
}

Outcome LineTexts::name_variables(CompiledLine& line, const ControlStatement& statement) {
    auto fault = names_.define(run_.language, statement.name);
    if (!fault) return Outcome::Nothing;
    fault->span = statement.span;
    return run_.fail(line, *fault);
}

}  // namespace kadr::macro
