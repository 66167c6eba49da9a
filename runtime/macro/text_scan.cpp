#include "macro/text_scan.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "macro/line_compiler.h"
#include "macro/named_shape.h"
#include "macro/program_run.h"
#include "nc/control_words.h"

namespace kadr::macro {

using nc::CallForm;
using nc::Statement;

namespace {

/// Whether calls of the cycle name blocks, labels or programs.
bool has_shape(const nc::CycleInfo& cycle) {
    return cycle.takes_shape() || names_shape(cycle) || names_contour(cycle);
}

}  // namespace

nc::SymbolTable shared(const nc::SymbolTable& symbols) {
    nc::SymbolTable out;
    for (nc::ControlSymbol symbol : symbols.all()) {
        symbol.is_shared = true;
        out.add(std::move(symbol));
    }
    return out;
}

TextScan::TextScan(const nc::Dialect& dialect, ScannedText& out, NamesOfProgram names,
                   const nc::MachineAxisNames* axis_names)
    : dialect_(dialect),
      tables_(dialect.tables()),
      out_(out),
      axis_names_(axis_names),
      lines_(dialect, out.references.file, nobody_),
      uses_(tables_, out),
      common_(std::move(names)),
      has_shapes_(std::ranges::any_of(dialect.cycles(), has_shape)) {}

void TextScan::read(nc::LineSource& source, std::uint64_t mark, const LinePosition& main) {
    mark_ = mark;
    main_ = main;
    if (!source.seek(0)) return;
    LinePosition here;
    begin_program(here);
    std::string_view line;
    bool is_too_long = false;
    while (source.next(line, is_too_long)) {
        const ProgramLine place{here, {source.offset(), here.line + 1}};
        here = place.next;
        if (!is_too_long) take_line(line, place);
    }
    end_program(here);
}

void TextScan::take_line(std::string_view line, const ProgramLine& place) {
    const nc::CallLanguage& calls = tables_.language.calls;
    const bool is_head =
        !calls.headers.empty() &&
        nc::program_of_header(calls, line, tables_.notation.ignores_case).has_value();
    const std::vector<std::string>& ends = tables_.program.end;
    if (is_head) take_head(line, place.line);
    else if (std::ranges::find(ends, line) != ends.end()) out_.index.note_end(place.line);
    lines_.begin(place.line.line);
    take_block(line, place);
}

/// The head of the text's first program, or of another one.
void TextScan::take_head(std::string_view line, const LinePosition& at) {
    out_.index.note_head(at);
    const bool is_first = !out_.programs.back().has_head && !bounds_.has_content;
    const bool is_main_behind = main_.offset != 0 && at == main_;
    if (!is_first || is_main_behind) {
        end_program(at);
        begin_program(at);
    }
    ProgramPlace& program = out_.programs.back();
    program.head = at;
    program.has_head = true;
    // Where subprograms stand in front, the text does not begin with its main program.
    if (is_first && main_.offset != 0) program.begin = at;
    TextDeclaration& declaration = out_.references.declarations[program.declaration];
    const bool ignores_case = tables_.notation.ignores_case;
    declaration.name = *nc::program_of_header(tables_.language.calls, line, ignores_case);
    const std::string_view name = *nc::name_in_header(tables_.language.calls, line, ignores_case);
    declaration.range.begin = at.offset + (at.offset == 0 ? mark_ : 0) +
                              static_cast<std::uint64_t>(name.data() - line.data());
    declaration.range.end = declaration.range.begin + name.size();
    declaration.range.line = at.line;
}

void TextScan::take_block(std::string_view line, const ProgramLine& place) {
    if (tables_.language.has_label_numbers || tables_.language.has_labels())
        take_label(line, place);
    const auto numbered = numbers_.numbered(tables_, line);
    std::string_view text = numbered ? std::string_view(numbered->text) : line;
    std::optional<ReplacedText> expanded;
    if (!own_.macros.is_empty() && nc::front_of(tables_, text).statement != Statement::DefineMacro)
        expanded = own_.macros.expanded(tables_, text);
    if (expanded) text = expanded->text;
    text = lines_.without_head(text);
    block_.reset();
    if (!takes_blocks_ && lines_.read_plain(text, block_) && !calls_shape(block_)) return;
    if (lines_.check_kind(text) != nc::LineReader::LineKind::Words) return;
    compile({text, place, byte_of(place), numbered ? &*numbered : nullptr,
             expanded ? &*expanded : nullptr});
}

void TextScan::take_label(std::string_view line, const ProgramLine& place) {
    const nc::LineFront front = nc::front_of(tables_, line);
    if (front.label.empty()) return;
    TextDeclaration label;
    label.kind = TextDeclaration::Kind::Label;
    label.name = nc::ControlWords(tables_, front.label).normal(front.label);
    label.range.begin =
        byte_of(place) + static_cast<std::uint64_t>(front.label.data() - line.data());
    label.range.end = label.range.begin + front.label.size();
    label.range.line = place.line.line;
    label.program = out_.programs.back().declaration;
    const auto index = static_cast<std::uint32_t>(out_.references.declarations.size());
    out_.index.add({label.name, -1}, {place.line, index});
    out_.references.declarations.push_back(std::move(label));
}

void TextScan::compile(const ReadLine& line) {
    nc::LineContext context;
    context.is_argument = takes_blocks_;
    context.axis_names = axis_names_;
    const auto fault = compile_block(tables_, own_.symbols, line.text, context, code_);
    const bool has_words = !code_.words.words.empty() || code_.words.comment_form != nc::kNoForm;
    if (fault || has_words || !code_.statements.empty()) lines_.bounds().note_content();
    if (fault) return keep_lost_names(line);
    uses_.take(line, code_, own_);
    if (has_shapes_ && has_words && code_.statements.empty()) take_shape(line);
    follow_modal_calls();
    const auto names =
        std::ranges::find(code_.statements, Statement::NameVariables, &nc::ControlStatement::kind);
    if (names != code_.statements.end()) numbers_.define(tables_.language, names->name);
}

/// A block that calls a cycle along a shape, if nothing of it is computed.
void TextScan::take_shape(const ReadLine& line) {
    if (!code_.computed.empty() || !code_.axes.empty() || !code_.codes.empty()) return;
    block_.reset();
    if (!lines_.read_words(line.text, code_, {}, block_) || !calls_shape(block_)) return;
    uses_.take_shape(line, code_, block_, dialect_.cycles()[block_.cycle]);
}

bool TextScan::calls_shape(const nc::Block& block) const {
    if (!has_shapes_ || block.find(nc::Function::Cycle) == nullptr) return false;
    return has_shape(dialect_.cycles()[block.cycle]);
}

/// Names that a wrong declaration should have declared: lines that use them are no mistakes.
void TextScan::keep_lost_names(const ReadLine& line) {
    const nc::ControlWords words(tables_, line.text);
    for (std::string& name : words_of_declaration(tables_, line.text)) {
        const auto is_same = [&](const auto& form) { return words.is_same(name, form.name); };
        const bool is_of_language = std::ranges::any_of(tables_.language.types, is_same) ||
                                    std::ranges::any_of(tables_.language.functions, is_same) ||
                                    tables_.find_address(name) != nc::kNoAddress;
        if (is_of_language || name.size() < 2 || own_.symbols.find(name) != nullptr) continue;
        nc::ControlSymbol symbol;
        symbol.name = std::move(name);
        own_.symbols.add(std::move(symbol));
    }
}

/// In the order of the text, which need not be that of the run.
void TextScan::follow_modal_calls() {
    for (const nc::ControlStatement& statement : code_.statements) {
        if (statement.kind == Statement::EndModal) takes_blocks_ = false;
        if (statement.kind != Statement::CallModal) continue;
        const std::int32_t form = code_.calls[statement.call].form;
        takes_blocks_ =
            form >= 0 && tables_.language.calls.calls[static_cast<std::size_t>(form)].modal ==
                             CallForm::Modal::Block;
    }
}

void TextScan::begin_program(const LinePosition& begin) {
    ProgramPlace program{begin, begin,
                         static_cast<std::uint32_t>(out_.references.declarations.size()), false,
                         begin == main_};
    TextDeclaration declaration;
    declaration.program = program.declaration;
    if (out_.programs.empty()) {
        declaration.name = nc::program_of_path(tables_.language.calls, out_.references.file,
                                               tables_.notation.ignores_case);
    }
    declaration.lines.begin = begin.offset;
    declaration.lines.line = begin.line;
    declaration.range = {begin.offset, 0, begin.line};
    out_.references.declarations.push_back(std::move(declaration));
    out_.programs.push_back(program);
    bounds_ = {out_.references.file, {}, false, false};
    lines_.bounds().enter(bounds_);
    own_ = common_;
    takes_blocks_ = false;
}

void TextScan::end_program(const LinePosition& end) {
    TextDeclaration& ended = out_.references.declarations[out_.programs.back().declaration];
    ended.lines.end = end.offset;
    if (ended.range.end == 0) ended.range.end = ended.range.begin;
    if (!is_of_definitions()) return;
    common_ = std::move(own_);
    common_.symbols = shared(common_.symbols);
}

/// Whether what the program declares is known in all of them.
bool TextScan::is_of_definitions() const {
    const auto& names = tables_.language.calls.definitions;
    const ProgramPlace& program = out_.programs.back();
    const std::string& name = out_.references.declarations[program.declaration].name;
    return std::ranges::find(names, name) != names.end();
}

// ------------------------------------------------------------------------------ blocks

namespace {

/// The numbers of the blocks at which something aims.
std::set<std::int64_t> aimed_numbers(const ScannedText& scanned) {
    std::set<std::int64_t> numbers;
    for (const OpenUse& use : scanned.open) {
        const bool is_block = use.rule != OpenUse::Rule::Program && use.target.label.empty();
        if (is_block) numbers.insert(use.target.number);
    }
    return numbers;
}

/// A target that its program has had in front.
void mark_twins(std::vector<TextDeclaration>& declarations) {
    using Kind = TextDeclaration::Kind;
    std::set<std::tuple<std::uint32_t, Kind, std::string_view>> seen;
    for (TextDeclaration& each : declarations) {
        if (each.kind != Kind::Label && each.kind != Kind::Block) continue;
        each.is_twin = !seen.emplace(each.program, each.kind, each.name).second;
    }
}

}  // namespace

void index_blocks(const nc::DialectTables& tables, nc::LineSource& source, std::uint64_t mark,
                  ScannedText& out) {
    const std::set<std::int64_t> aimed = aimed_numbers(out);
    std::vector<TextDeclaration>& declarations = out.references.declarations;
    if (!aimed.empty() && source.seek(0)) {
        LinePosition here;
        std::string_view line;
        bool is_too_long = false;
        std::size_t program = 0;
        while (source.next(line, is_too_long)) {
            const LinePosition at = std::exchange(here, {source.offset(), here.line + 1});
            while (program + 1 < out.programs.size() &&
                   declarations[out.programs[program + 1].declaration].lines.begin <= at.offset)
                ++program;
            const nc::LineFront front = nc::front_of(tables, line);
            if (!aimed.contains(front.number)) continue;
            TextDeclaration block;
            block.kind = TextDeclaration::Kind::Block;
            block.name = std::to_string(front.number);
            const std::uint64_t begin = at.offset + (at.offset == 0 ? mark : 0);
            block.range = {begin + front.number_span.begin, begin + front.number_span.end, at.line};
            block.program = out.programs[program].declaration;
            const auto index = static_cast<std::uint32_t>(declarations.size());
            out.index.add({{}, front.number}, {at, index});
            declarations.push_back(std::move(block));
        }
    }
    mark_twins(declarations);
}

}  // namespace kadr::macro
