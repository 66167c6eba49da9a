#include "sema/queries.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "base/identifier.h"
#include "nc/tables.h"
#include "nc/vocabulary.h"
#include "sema/builtins.h"

namespace kadr::sema {

using syntax::Decl;
using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;

namespace {

using Kind = DeclaredSymbol::Kind;

bool covers(const SourceRange& range, std::uint32_t byte) {
    return range.begin <= byte && byte <= range.end;
}

std::uint32_t length_of(const SourceRange& range) { return range.end - range.begin; }

const CheckedFile* file_of(const Checked& checked, FileId file) {
    const auto found = std::ranges::find_if(
        checked.files, [&](const CheckedFile& other) { return other.ast->file == file; });
    return found == checked.files.end() ? nullptr : &*found;
}

/// The name at the end of a text: `depth` of `holes[2].depth`.
std::string_view last_name(std::string_view text) {
    std::size_t begin = text.size();
    while (begin > 0 && is_name_part(text[begin - 1])) --begin;
    return text.substr(begin);
}

/// The name at the beginning: `hole` of `hole[]`, `depth` of `depth: 3mm`.
std::string_view first_name(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size() && is_name_part(text[end])) ++end;
    return text.substr(0, end);
}

SourceRange begin_of(const SourceRange& range, std::size_t length) {
    return {range.file, range.begin, range.begin + static_cast<std::uint32_t>(length)};
}

/// Where the name itself stands in an expression that means a symbol.
SourceRange name_range(const Expr& expr, const Sources& sources) {
    const std::string_view text = sources.text(expr.range);
    if (expr.kind == ExprKind::Member) {
        const auto length = static_cast<std::uint32_t>(last_name(text).size());
        return {expr.range.file, expr.range.end - length, expr.range.end};
    }
    if (expr.kind == ExprKind::Argument) return begin_of(expr.range, first_name(text).size());
    return expr.range;
}

/// Calls `take` with every occurrence of a name in one file.
template <typename Take>
void for_each_occurrence(const Checked& checked, const CheckedFile& file, const Sources& sources,
                         Take&& take) {
    const syntax::Ast& ast = *file.ast;
    for (std::size_t i = 0; i < ast.expressions.size(); ++i) {
        const SymbolId symbol = file.expressions[i].symbol;
        if (symbol.is_valid()) take(Occurrence{name_range(ast.expressions[i], sources), symbol});
    }
    for (std::size_t i = 0; i < ast.types.size(); ++i) {
        const SourceRange& range = ast.types[i].range;
        const SymbolId symbol = file.types[i];
        if (symbol.is_valid())
            take(Occurrence{begin_of(range, first_name(sources.text(range)).size()), symbol});
    }
    for (const WordUse& word : file.words) take(Occurrence{word.range, word.symbol});
    for (const SymbolId symbol : file.declarations) {
        if (symbol.is_valid()) take(Occurrence{checked[symbol].range, symbol, true});
    }
}

bool is_of_file(Kind kind) {
    switch (kind) {
        case Kind::Function:
        case Kind::Cycle:
        case Kind::Program:
        case Kind::Curve:
        case Kind::Struct:
        case Kind::Enum:
        case Kind::EnumMember: return true;
        case Kind::Variable:
        case Kind::Contour:  // of a file, if it has no scope
        case Kind::Parameter:
        case Kind::Test:
        case Kind::Property:
        case Kind::Member: return false;
    }
    return false;
}

/// Whether a name can be used at this byte of this file.
bool is_visible(const Checked& checked, const DeclaredSymbol& symbol, std::uint32_t file,
                std::uint32_t byte) {
    const bool is_local = symbol.scope.file.is_valid();
    if (is_local) return symbol.file == file && covers(symbol.scope, byte);
    const bool is_global = symbol.kind == Kind::Variable || symbol.kind == Kind::Contour;
    if (!is_of_file(symbol.kind) && !is_global) return false;
    if (symbol.file == file || symbol.file == checked.prelude) return true;
    const auto& imports = checked.files[file].imports;
    return std::ranges::find(imports, symbol.file, &ImportedFile::file) != imports.end();
}

/// What a name means at a position; not valid: nothing that the program declares.
SymbolId visible(const Checked& checked, std::string_view name, std::uint32_t file,
                 std::uint32_t byte) {
    SymbolId found;
    for (std::uint32_t i = 0; i < checked.symbols.size(); ++i) {
        const DeclaredSymbol& symbol = checked.symbols[i];
        if (symbol.name != name || !is_visible(checked, symbol, file, byte)) continue;
        const bool is_nearer = symbol.scope.file.is_valid() || !found.is_valid();
        if (is_nearer) found = {i};
    }
    return found;
}

std::string with_type(const Checked& checked, const DeclaredSymbol& symbol) {
    return checked.types.name(symbol.type) + ' ' + symbol.name;
}

std::string parameters_of(const Checked& checked, const DeclaredSymbol& function) {
    const CheckedFile& file = checked.files[function.file];
    const syntax::Ast& ast = *file.ast;
    std::string all;
    for (const syntax::DeclId id : ast.decls(ast[function.decl].parameters)) {
        const SymbolId parameter = file.declarations[id.index];
        if (!parameter.is_valid()) continue;
        if (!all.empty()) all += ", ";
        all += with_type(checked, checked[parameter]);
    }
    return '(' + all + ')';
}

/// The function whose parentheses are open at the end of a text; empty: none are.
std::string_view open_call(std::string_view text) {
    int depth = 0;
    for (std::size_t i = text.size(); i-- > 0;) {
        if (text[i] == ';' || text[i] == '{' || text[i] == '}') return {};
        if (text[i] == ')') ++depth;
        if (text[i] == '(' && depth-- == 0) return last_name(text.substr(0, i));
    }
    return {};
}

class Proposals {
  public:
    Proposals(const Checked& checked, std::uint32_t file, std::uint32_t byte)
        : checked_(checked), file_(file), byte_(byte) {}

    void add(Proposal::Kind kind, std::string_view text, SymbolId symbol = {}) {
        if (!text.empty()) all_.push_back({kind, std::string(text), symbol});
    }
    void add_members(Type type);
    void add_visible();
    void add_parameters(std::string_view function);
    void add_language(const syntax::KeywordTable* keywords);
    std::vector<Proposal> take();

  private:
    const Checked& checked_;
    std::uint32_t file_;
    std::uint32_t byte_;
    std::vector<Proposal> all_;
};

void Proposals::add_members(Type type) {
    const TypeTable& types = checked_.types;
    if (types[type].kind == TypeKind::Struct) {
        for (const Member& member : types.struct_of(type).members)
            add(Proposal::Kind::Member, member.name, member.symbol);
        return;
    }
    for (const std::string_view name : members_of(types, type)) add(Proposal::Kind::Member, name);
}

void Proposals::add_visible() {
    for (std::uint32_t i = 0; i < checked_.symbols.size(); ++i) {
        const DeclaredSymbol& symbol = checked_.symbols[i];
        const bool can_be_named = symbol.kind != Kind::Program;  // nobody calls it
        if (can_be_named && is_visible(checked_, symbol, file_, byte_))
            add(Proposal::Kind::Symbol, symbol.name, {i});
    }
}

void Proposals::add_parameters(std::string_view function) {
    const SymbolId symbol = visible(checked_, function, file_, byte_);
    if (symbol.is_valid()) {
        const CheckedFile& file = checked_.files[checked_[symbol].file];
        for (const syntax::DeclId id :
             file.ast->decls((*file.ast)[checked_[symbol].decl].parameters))
            add(Proposal::Kind::Argument, file.ast->text((*file.ast)[id].name),
                file.declarations[id.index]);
        return;
    }
    if (const auto command = nc::find_function(function)) {
        for (const nc::Parameter& parameter : nc::info(*command).parameters)
            add(Proposal::Kind::Argument, parameter.name);
    }
}

void Proposals::add_language(const syntax::KeywordTable* keywords) {
    for (const std::string_view name : builtin_names()) add(Proposal::Kind::Builtin, name);
    for (const nc::FunctionInfo& info : nc::all_functions()) {
        const bool is_callable =
            info.function != nc::Function::Cycle && !nc::is_no_command(info.function);
        if (is_callable) add(Proposal::Kind::Command, info.name);
    }
    for (const nc::Address& address : checked_.files[file_].dialect->tables().addresses)
        add(Proposal::Kind::Address, address.name);
    if (keywords == nullptr) return;
    for (const auto& [lexeme, canonical] : keywords->canonical)
        add(Proposal::Kind::Keyword, lexeme);
}

std::vector<Proposal> Proposals::take() {
    const auto order = [](const Proposal& a, const Proposal& b) {
        return std::tie(a.text, a.kind, a.symbol.index) < std::tie(b.text, b.kind, b.symbol.index);
    };
    std::ranges::sort(all_, order);
    const auto is_same = [](const Proposal& a, const Proposal& b) {
        return a.text == b.text && a.kind == b.kind;
    };
    all_.erase(std::unique(all_.begin(), all_.end(), is_same), all_.end());
    return std::move(all_);
}

/// What stands before a point: the type of an expression, or an enum by its name.
void add_behind_point(Proposals& proposals, const Checked& checked, const CheckedFile& file,
                      std::uint32_t number, std::string_view before) {
    const auto end = static_cast<std::uint32_t>(before.size());
    const std::string_view name = last_name(before);
    const bool is_name_alone =
        !name.empty() && !before.substr(0, before.size() - name.size()).ends_with('.');
    const SymbolId symbol = is_name_alone ? visible(checked, name, number, end) : SymbolId{};
    if (symbol.is_valid()) {
        const DeclaredSymbol& declared = checked[symbol];
        if (declared.kind == Kind::Enum) {
            for (const auto& [member, value] : checked.types.enum_of(declared.type).members)
                proposals.add(Proposal::Kind::Member, member);
            return;
        }
        return proposals.add_members(declared.type);
    }
    if (is_name_alone && name == "position") {
        for (const std::string_view member : position_members())
            proposals.add(Proposal::Kind::Member, member);
    } else if (is_name_alone && name == "state") {
        for (const std::string_view member : state_members())
            proposals.add(Proposal::Kind::Member, member);
    } else if (const ExprId id = expression_at(*file.ast, end); id.is_valid()) {
        proposals.add_members(file.expressions[id.index].type);
    }
}

}  // namespace

std::optional<Occurrence> symbol_at(const Checked& checked, const Sources& sources, FileId file,
                                    std::uint32_t byte) {
    const CheckedFile* found = file_of(checked, file);
    if (found == nullptr) return std::nullopt;
    std::optional<Occurrence> nearest;
    for_each_occurrence(checked, *found, sources, [&](const Occurrence& occurrence) {
        if (!covers(occurrence.range, byte)) return;
        const bool is_nearer = !nearest || length_of(occurrence.range) < length_of(nearest->range);
        if (is_nearer) nearest = occurrence;
    });
    return nearest;
}

std::vector<Occurrence> occurrences_of(const Checked& checked, const Sources& sources,
                                       SymbolId symbol) {
    std::vector<Occurrence> all;
    for (const CheckedFile& file : checked.files) {
        const std::size_t first = all.size();
        for_each_occurrence(checked, file, sources, [&](const Occurrence& occurrence) {
            if (occurrence.symbol == symbol) all.push_back(occurrence);
        });
        std::ranges::sort(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), {},
                          [](const Occurrence& occurrence) { return occurrence.range.begin; });
    }
    return all;
}

ExprId expression_at(const syntax::Ast& ast, std::uint32_t byte) {
    ExprId nearest;
    for (std::uint32_t i = 0; i < ast.expressions.size(); ++i) {
        const Expr& expr = ast.expressions[i];
        if (expr.kind == ExprKind::Invalid || !covers(expr.range, byte)) continue;
        const bool is_nearer =
            !nearest.is_valid() || length_of(expr.range) < length_of(ast[nearest].range);
        if (is_nearer) nearest = {i};
    }
    return nearest;
}

std::string type_at(const Checked& checked, const Sources& sources, FileId file,
                    std::uint32_t byte) {
    const CheckedFile* found = file_of(checked, file);
    if (found == nullptr) return {};
    const auto occurrence = symbol_at(checked, sources, file, byte);
    const bool is_declared = occurrence && occurrence->is_declaration;
    const ExprId id = is_declared ? ExprId{} : expression_at(*found->ast, byte);
    const Type type = is_declared     ? checked[occurrence->symbol].type
                      : id.is_valid() ? found->expressions[id.index].type
                                      : types::kError;
    return type == types::kError ? std::string() : checked.types.name(type);
}

std::string describe(const Checked& checked, SymbolId id) {
    const DeclaredSymbol& symbol = checked[id];
    switch (symbol.kind) {
        case Kind::Variable:
        case Kind::Parameter:
        case Kind::Member: return (symbol.is_const ? "const " : "") + with_type(checked, symbol);
        case Kind::Contour: return "contour " + symbol.name;
        case Kind::Function: return with_type(checked, symbol) + parameters_of(checked, symbol);
        case Kind::Cycle: return "cycle " + symbol.name + parameters_of(checked, symbol);
        case Kind::Program: return "program " + symbol.name + parameters_of(checked, symbol);
        case Kind::Curve: return "curve " + symbol.name + parameters_of(checked, symbol);
        case Kind::Test: return "test \"" + symbol.name + '"';
        case Kind::Property: return "property \"" + symbol.name + '"';
        case Kind::Struct: return "struct " + symbol.name;
        case Kind::Enum: return "enum " + symbol.name;
        case Kind::EnumMember: return checked.types.name(symbol.type) + '.' + symbol.name;
    }
    return {};
}

std::vector<Proposal> proposals_at(const Checked& checked, const Sources& sources,
                                   const syntax::KeywordTable* keywords, FileId file,
                                   std::uint32_t byte) {
    const CheckedFile* found = file_of(checked, file);
    if (found == nullptr) return {};
    const auto number = static_cast<std::uint32_t>(found - checked.files.data());
    Proposals proposals(checked, number, byte);
    std::string_view before = sources.text(file).substr(0, byte);
    before.remove_suffix(last_name(before).size());
    if (before.ends_with('.')) {
        before.remove_suffix(1);
        add_behind_point(proposals, checked, *found, number, before);
        return proposals.take();
    }
    if (const std::string_view call = open_call(before); !call.empty())
        proposals.add_parameters(call);
    proposals.add_visible();
    proposals.add_language(keywords);
    return proposals.take();
}

}  // namespace kadr::sema
