#include "macro/line_uses.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "macro/fixed_targets.h"
#include "macro/named_shape.h"
#include "nc/letters.h"

namespace kadr::macro {

using nc::ControlStatement;
using nc::Span;
using nc::Statement;
using Rule = OpenUse::Rule;

TextRange ReadLine::range(Span span) const {
    if (expanded != nullptr) span = expanded->written(span);
    if (numbered != nullptr) span = numbered->written(span);
    return {begin + span.begin, begin + span.end, place.line.line};
}

nc::ControlSymbol symbol_of(const TextDeclaration& declaration) {
    nc::ControlSymbol symbol;
    symbol.name = declaration.name;
    symbol.type = declaration.type;
    symbol.dimensions = declaration.dimensions;
    return symbol;
}

void LineUses::take(const ReadLine& line, const nc::ControlLine& code, NamesOfProgram& names) {
    line_ = &line;
    code_ = &code;
    names_ = &names;
    if (line.expanded != nullptr) take_words();
    for (const ControlStatement& statement : code.statements) take(statement);
    take_variables();
}

// ------------------------------------------------------------------------------ statements

void LineUses::take(const ControlStatement& statement) {
    switch (statement.kind) {
        case Statement::Jump:
        case Statement::JumpForward:
        case Statement::JumpBackward:
        case Statement::JumpIfThere: {
            const std::uint32_t added = aim(Kind::Jump, Rule::Nearest, statement.target);
            if (added != OpenUse::kNone) out_.open[added].direction = direction_of(statement.kind);
            break;
        }
        case Statement::RepeatSection:
        case Statement::RepeatBlock: take_repeat(statement); break;
        case Statement::CallSection: take_section(statement); break;
        case Statement::Call:
        case Statement::CallModal: take_call(statement); break;
        case Statement::CallByText: take_call_by_text(statement); break;
        case Statement::Return: take_return(statement); break;
        case Statement::Procedure:
        case Statement::External: take_head(statement); break;
        case Statement::DefineMacro: take_macro(statement); break;
        case Statement::Declare:
            for (const nc::Declaration& each : statement.declarations) declare(each, statement);
            break;
        default: break;
    }
    if (statement.variable.is_given()) take_variable(Kind::Write, statement.variable.span);
    const bool is_row = statement.kind == Statement::ContourRow;
    if (statement.table.is_given())
        take_variable(is_row ? Kind::Read : Kind::Write, statement.table.span);
    for (const ControlStatement& inner : statement.inner) take(inner);
}

/// The program that a code or a name calls, the block where that begins, and what it is given.
void LineUses::take_call(const ControlStatement& statement) {
    const nc::Call& call = code_->calls[statement.call];
    const nc::CallForm* const form =
        call.form >= 0 ? &tables_.language.calls.calls[static_cast<std::size_t>(call.form)]
                       : nullptr;
    if (form == nullptr && call.name.empty()) return;  // the words of a block under a modal call
    std::uint32_t program = OpenUse::kNone;
    if (form != nullptr && !form->fixed.empty()) {
        program = call_program(Kind::Call, call.span, form->fixed, {});
    } else if (!call.name.empty()) {
        const Span& span = call.program.span.end != 0 ? call.program.span : call.span;
        program = call_program(Kind::Call, span_of_name(span, call.name), call.name, call.kind);
    } else if (call.program.is_given) {
        const auto number = fixed_number(*code_, call.program);
        const auto named = number ? program_numbered(*number, split_of(form, call)) : std::nullopt;
        if (named) {
            program = call_program(Kind::Call, span_of_number(call.program, named->name),
                                   named->name, {});
        } else {
            add_use(Kind::Call, call.program.span).outcome = TextUse::Outcome::Computed;
        }
    } else if (call.start.is_given) {  // a part of the program that runs
        aim_at_number(Kind::Call, Rule::FromHead, call.start);
        return;
    }
    take_start(call, program);
    take_arguments(call, program);
}

void LineUses::take_start(const nc::Call& call, std::uint32_t program) {
    if (!call.start.is_given) return;
    const std::uint32_t start = aim_at_number(Kind::Jump, Rule::InCalled, call.start);
    if (start != OpenUse::kNone) out_.open[start].other = program;
}

void LineUses::take_call_by_text(const ControlStatement& statement) {
    const auto path = fixed_text(*code_, statement.second);
    std::uint32_t program = OpenUse::kNone;
    if (path) {
        const nc::CallLanguage& calls = tables_.language.calls;
        const std::string name = nc::program_of_path(calls, *path, tables_.notation.ignores_case);
        program = call_program(Kind::Call, span_of_name(statement.second.span, name), name,
                               nc::kind_of_path(calls, *path, tables_.notation.ignores_case));
    } else {
        add_use(Kind::Call, statement.second.span).outcome = TextUse::Outcome::Computed;
    }
    const std::uint32_t from = aim(Kind::Jump, Rule::InCalled, statement.from);
    if (from != OpenUse::kNone) out_.open[from].other = program;
    const std::uint32_t to = aim(Kind::Jump, Rule::Behind, statement.to);
    if (to != OpenUse::kNone) out_.open[to].other = from;
}

void LineUses::take_return(const ControlStatement& statement) {
    const bool is_code = !code_->calls.empty();
    if (statement.target.kind != nc::JumpTarget::Kind::None) {
        aim(Kind::Jump, Rule::OfReturn, statement.target);
    } else if (is_code && code_->calls[statement.call].target.is_given) {
        aim_at_number(Kind::Jump, Rule::OfReturn, code_->calls[statement.call].target);
    } else {
        return;
    }
    // One that leaves several programs goes on in a caller of a caller.
    const bool is_computed = out_.references.uses.back().outcome == TextUse::Outcome::Computed;
    if (statement.count.is_given() && !is_computed)
        out_.references.uses.back().outcome = TextUse::Outcome::OfCaller;
}

void LineUses::take_repeat(const ControlStatement& statement) {
    const std::uint32_t from = aim(Kind::Repeat, Rule::Around, statement.from);
    const std::uint32_t to = aim(Kind::Repeat, Rule::Behind, statement.to);
    if (to != OpenUse::kNone) out_.open[to].other = from;
}

/// With a count above 0 a section is repeated, without one it is called.
void LineUses::take_section(const ControlStatement& statement) {
    const nc::Expression& count = statement.count;
    const nc::ControlInstruction* const step =
        count.count == 1 ? &code_->code[count.first] : nullptr;
    const bool is_number = step != nullptr && step->kind == nc::ControlInstruction::Kind::Number;
    const bool is_call = !count.is_given() || (is_number && step->number == 0);
    const bool is_repeat = is_number && step->number != 0;
    aim(is_repeat ? Kind::Repeat : Kind::Call,
        is_call     ? Rule::FromHead
        : is_repeat ? Rule::Around
                    : Rule::Counted,
        statement.from);
}

/// `PROC NAME(…)` names the program itself, and gives one without another head its name.
void LineUses::take_head(const ControlStatement& statement) {
    if (statement.kind == Statement::External) {
        call_program(Kind::Mention, statement.span, statement.name, {});
        return;
    }
    ProgramPlace& program = out_.programs.back();
    TextDeclaration& own = out_.references.declarations[program.declaration];
    const bool is_named = own.range.end != 0;
    if (!is_named) own.range = line_->range(statement.span);
    if (own.name.empty()) own.name = statement.name;
    if (is_named) {
        TextUse& use = add_use(Kind::Mention, statement.span, statement.name);
        use.outcome = TextUse::Outcome::Here;
        use.target = program.declaration;
    }
    for (const nc::ProcedureParameter& each : statement.parameters) declare(each);
}

void LineUses::take_macro(const ControlStatement& statement) {
    if (names_->macros.define(tables_, statement.name) != TextMacros::Fault::None) return;
    const std::size_t begin = line_->text.find(statement.name, statement.span.end);
    std::size_t length = 0;
    while (length < statement.name.size() &&
           (nc::is_letter(statement.name[length]) || nc::is_digit(statement.name[length])))
        ++length;
    const auto first = static_cast<std::uint32_t>(begin);
    TextDeclaration macro;
    macro.kind = TextDeclaration::Kind::Macro;
    macro.name = nc::ControlWords(tables_, line_->text).normal(statement.name.substr(0, length));
    macro.range = line_->range({first, first + static_cast<std::uint32_t>(length)});
    macro.program = out_.programs.back().declaration;
    const auto index = static_cast<std::uint32_t>(out_.references.declarations.size());
    names_->known.insert_or_assign(macro.name, KnownName{TextUse::Outcome::Here, index});
    out_.references.declarations.push_back(std::move(macro));
}

// ------------------------------------------------------------------------------ variables

void LineUses::declare(const nc::Declaration& declaration, const ControlStatement& statement) {
    TextDeclaration variable;
    variable.kind = TextDeclaration::Kind::Variable;
    variable.name = declaration.name;
    variable.range = line_->range(declaration.span);
    variable.type = statement.type;
    variable.dimensions = declaration.dimensions;
    declare(std::move(variable));
}

void LineUses::declare(const nc::ProcedureParameter& parameter) {
    TextDeclaration variable;
    variable.kind = TextDeclaration::Kind::Parameter;
    variable.name = parameter.declaration.name;
    variable.range = line_->range(parameter.declaration.span);
    variable.type = parameter.type;
    variable.is_reference = parameter.is_reference;
    variable.dimensions = parameter.declaration.dimensions;
    declare(std::move(variable));
}

void LineUses::declare(TextDeclaration declaration) {
    names_->symbols.add(symbol_of(declaration));
    declaration.program = out_.programs.back().declaration;
    const auto index = static_cast<std::uint32_t>(out_.references.declarations.size());
    names_->known.insert_or_assign(declaration.name, KnownName{TextUse::Outcome::Here, index});
    out_.references.declarations.push_back(std::move(declaration));
}

/// Variables alone, which the program that is called may set. What is worked out is read with all
/// the other code of the line.
void LineUses::take_arguments(const nc::Call& call, std::uint32_t program) {
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        const nc::CallArgument& argument = call.arguments[i];
        if (!argument.variable.is_given()) continue;
        if (!take_variable(Kind::Read, argument.variable.span) || program == OpenUse::kNone)
            continue;
        out_.arguments.push_back({static_cast<std::uint32_t>(out_.references.uses.size()) - 1,
                                  program, static_cast<std::uint32_t>(i)});
    }
}

/// All that the code of the line reads. A variable whose value and location are both in the code
/// stands there once.
void LineUses::take_variables() {
    if (names_->known.empty()) return;
    const std::vector<TextUse>& uses = out_.references.uses;
    std::size_t first = uses.size();
    while (first > 0 && uses[first - 1].range.line == line_->place.line.line) --first;
    for (const Span& span : code_->spans) {
        const std::uint64_t begin = line_->range(span).begin;
        const auto is_here = [&](const TextUse& use) {
            return use.range.begin == begin && use.kind == Kind::Read;
        };
        if (std::any_of(uses.begin() + static_cast<std::ptrdiff_t>(first), uses.end(), is_here))
            continue;
        take_variable(Kind::Read, span);
    }
}

/// Whether a name that the program has declared stands at the beginning of the piece.
bool LineUses::take_variable(Kind kind, const Span& span) {
    const nc::ControlWords words(tables_, line_->text);
    const std::string_view name = words.word_at(span.begin).text;
    const auto found = names_->known.find(words.normal(name));
    if (name.empty() || found == names_->known.end()) return false;
    TextUse& use = add_use(kind, {span.begin, span.begin + static_cast<std::uint32_t>(name.size())},
                           found->first);
    use.outcome = found->second.outcome;
    use.target = found->second.target;
    return true;
}

/// The words of the line that stand for text.
void LineUses::take_words() {
    for (const ReplacedText::Word& word : line_->expanded->words) {
        const TextRange range = line_->range(word.put);
        const std::string& name = word.name;
        const auto found = names_->known.find(name);
        if (found == names_->known.end()) continue;
        TextUse& use = add_use(Kind::Read, word.put, name);
        use.range = range;
        use.outcome = found->second.outcome;
        use.target = found->second.target;
    }
}

// ------------------------------------------------------------------------------ shapes

void LineUses::take_shape(const ReadLine& line, const nc::ControlLine& code, const nc::Block& block,
                          const nc::CycleInfo& cycle) {
    line_ = &line;
    code_ = &code;
    if (cycle.takes_shape()) {
        const std::uint32_t first = take_shape_block(block, cycle.roles.first_block);
        const std::uint32_t last = take_shape_block(block, cycle.roles.last_block);
        if (first == OpenUse::kNone || last == OpenUse::kNone) return;
        OpenUse& end = out_.open[last];
        if (end.target.number == out_.open[first].target.number) return;  // one block
        end.rule = Rule::Behind;
        end.other = first;
        return;
    }
    if ((!names_contour(cycle) && !names_shape(cycle)) || block.text.empty()) return;
    const NamedContour contour = contour_named_by(block, cycle);
    const Span all{0, static_cast<std::uint32_t>(line.text.size())};
    std::vector<std::string> labels = with_labels(contour).parts;
    std::uint32_t program = OpenUse::kNone;
    if (contour.kind == ContourSource::Program || contour.kind == ContourSource::ProgramLabels) {
        if (labels.empty()) return;
        const nc::CallLanguage& calls = tables_.language.calls;
        const bool ignores_case = tables_.notation.ignores_case;
        const std::string name = nc::program_of_path(calls, labels[0], ignores_case);
        program = call_program(Kind::Call, span_of_name(all, name), name,
                               nc::kind_of_path(calls, labels[0], ignores_case));
        labels.erase(labels.begin());
    }
    if (contour.kind == ContourSource::Program || labels.size() < 2) return;
    const bool is_named = contour.kind == ContourSource::Named;
    const auto span = [&](const std::string& label) {
        return span_of_name(all, is_named ? contour.parts[0] : label);
    };
    const std::uint32_t first = name_label(program, OpenUse::kNone, span(labels[0]), labels[0]);
    name_label(program, first, span(labels[1]), labels[1]);
}

/// program  the open use of the one with the label; OpenUse::kNone: the own one
/// first    the open use behind whose target it is looked for; OpenUse::kNone: from the head
std::uint32_t LineUses::name_label(std::uint32_t program, std::uint32_t first, const Span& span,
                                   const std::string& label) {
    const bool is_first = first == OpenUse::kNone;
    const std::string name = nc::ControlWords(tables_, line_->text).normal(label);
    const std::uint32_t added = aim(Kind::Repeat,
                                    !is_first                   ? Rule::Behind
                                    : program == OpenUse::kNone ? Rule::FromHead
                                                                : Rule::InCalled,
                                    span, LineTarget{name, -1});
    out_.open[added].other = is_first ? program : first;
    return added;
}

/// A block of the shape by its number, looked for as a jump does.
std::uint32_t LineUses::take_shape_block(const nc::Block& block, int parameter) {
    const nc::Invocation* const call = block.find(nc::Function::Cycle);
    const std::int64_t number =
        std::llround(block.argument(*call, static_cast<std::size_t>(parameter), -1));
    if (number < 0) return OpenUse::kNone;
    return aim(Kind::Repeat, Rule::Nearest, span_of_parameter(block, parameter),
               LineTarget{{}, number});
}

/// The number of the word that gives the parameter of the cycle; of no word all of the line.
Span LineUses::span_of_parameter(const nc::Block& block, int parameter) const {
    const nc::LexedLine& words = code_->words;
    for (const nc::Form& spelling : tables_.forms) {
        if (spelling.function != nc::Function::Cycle || spelling.cycle != block.cycle) continue;
        for (const nc::FormWord& form : spelling.words) {
            if (form.parameter != parameter) continue;
            const auto word = std::ranges::find(words.words, form.address, &nc::GivenWord::address);
            if (word == words.words.end()) continue;
            Span span = words.spans[static_cast<std::size_t>(word - words.words.begin())];
            while (span.begin < span.end && !nc::is_digit(line_->text[span.begin])) ++span.begin;
            return span;
        }
    }
    return {0, static_cast<std::uint32_t>(line_->text.size())};
}

// ------------------------------------------------------------------------------ what is added

TextUse& LineUses::add_use(Kind kind, const Span& span, std::string name) {
    TextUse& use = out_.references.uses.emplace_back();
    use.kind = kind;
    use.range = line_->range(span);
    use.name = std::move(name);
    use.program = out_.programs.back().declaration;
    return use;
}

OpenUse& LineUses::open(const TextUse& use, Rule rule) {
    OpenUse& added = out_.open.emplace_back();
    added.use = static_cast<std::uint32_t>(&use - out_.references.uses.data());
    added.rule = rule;
    added.from = line_->place;
    added.place = static_cast<std::uint32_t>(out_.programs.size()) - 1;
    return added;
}

std::uint32_t LineUses::aim(Kind kind, Rule rule, const nc::JumpTarget& target) {
    if (target.kind == nc::JumpTarget::Kind::None) return OpenUse::kNone;
    Span span = target.span;
    const bool is_text = target.kind == nc::JumpTarget::Kind::Computed ||
                         (span.begin < line_->text.size() && line_->text[span.begin] == '"');
    const auto fixed = fixed_target(tables_, *code_, target);
    if (fixed && is_text) span = span_of_name(span, fixed->label);
    return aim(kind, rule, span, fixed);
}

std::uint32_t LineUses::aim_at_number(Kind kind, Rule rule, const nc::CallValue& value) {
    const auto number = fixed_number(*code_, value);
    std::optional<LineTarget> target;
    if (number) target = LineTarget{{}, static_cast<std::int64_t>(*number)};
    const std::string digits = target ? std::to_string(target->number) : std::string();
    return aim(kind, rule, span_of_number(value, digits), target);
}

/// target  nothing: it is computed
std::uint32_t LineUses::aim(Kind kind, Rule rule, const Span& span,
                            const std::optional<LineTarget>& target) {
    TextUse& use = add_use(kind, span);
    if (!target) {
        use.outcome = TextUse::Outcome::Computed;
        return OpenUse::kNone;
    }
    use.name = target->label.empty() ? std::to_string(target->number) : target->label;
    OpenUse& added = open(use, rule);
    added.target = *target;
    if (!target->label.empty()) added.target.number = -1;
    return static_cast<std::uint32_t>(out_.open.size()) - 1;
}

std::uint32_t LineUses::call_program(Kind kind, const Span& span, const std::string& name,
                                     const std::string& kind_of_program) {
    OpenUse& added = open(add_use(kind, span, name), Rule::Program);
    added.kind = kind_of_program;
    return static_cast<std::uint32_t>(out_.open.size()) - 1;
}

/// Without the letter in front, and without the passes: of `P30012` the last digits.
Span LineUses::span_of_number(const nc::CallValue& value, const std::string& digits) const {
    Span span = value.span;
    const std::string_view text = line_->text;
    while (span.begin < span.end && !nc::is_digit(text[span.begin])) ++span.begin;
    if (span.begin == span.end || digits.empty()) return value.span;
    Span last = span;
    while (last.end > last.begin && !nc::is_digit(text[last.end - 1])) --last.end;
    std::uint32_t begin = last.end;
    while (begin > last.begin && nc::is_digit(text[begin - 1])) --begin;
    // Zeros in front belong to the number, if no passes stand in front of them.
    const std::string_view written = text.substr(begin, last.end - begin);
    const bool is_whole =
        written.substr(std::min(written.find_first_not_of('0'), written.size() - 1)) == digits;
    const auto length = static_cast<std::uint32_t>(digits.size());
    return {is_whole || length > last.end - begin ? begin : last.end - length, last.end};
}

/// Where the name stands in a path, a text or brackets; all of the piece if it is not in it.
Span LineUses::span_of_name(const Span& span, std::string_view name) const {
    const nc::ControlWords words(tables_, line_->text);
    for (std::uint32_t at = span.end; !name.empty() && at > span.begin; --at) {
        const auto begin = static_cast<std::int64_t>(at) - static_cast<std::int64_t>(name.size());
        if (begin < static_cast<std::int64_t>(span.begin)) break;
        const auto first = static_cast<std::uint32_t>(begin);
        if (words.is_same(line_->text.substr(first, name.size()), name)) return {first, at};
    }
    return span;
}

}  // namespace kadr::macro
