#include "sema/naming.h"

#include <algorithm>

#include "sema/texts.h"

namespace kadr::sema {

using syntax::Stmt;
using syntax::StmtKind;

void note_statement(Check& check, const SourceRange& range) {
    if (!check.options.keeps_names) return;
    std::vector<StatementStart>& all = check.code->names.statements;
    if (!all.empty() && all.back().at == check.emit.here()) all.pop_back();
    all.push_back({check.emit.here(), range});
}

void note_statement(Check& check, const Stmt& stmt) {
    switch (stmt.kind) {
        case StmtKind::Invalid:
        case StmtKind::Empty:
        case StmtKind::Block:
        case StmtKind::Case:
        case StmtKind::Units:
        case StmtKind::While:
        case StmtKind::DoWhile: return;
        case StmtKind::For:
            if (stmt.statement[0].is_valid()) return;  // it begins
            break;
        default: break;
    }
    if (check.options.keeps_names) note_statement(check, head_range(check, stmt));
}

void drop_empty_statement(Check& check, std::uint32_t began) {
    if (!check.options.keeps_names || check.emit.here() != began) return;
    std::vector<StatementStart>& all = check.code->names.statements;
    if (!all.empty() && all.back().at == began) all.pop_back();
}

SourceRange head_range(const Check& check, const Stmt& stmt) {
    SourceRange head = stmt.range;
    std::uint32_t end = head.end;
    const auto ends_before = [&](syntax::StmtId body) {
        if (body.is_valid()) end = std::min(end, check.ast()[body].range.begin);
    };
    switch (stmt.kind) {
        case StmtKind::If:
        case StmtKind::While:
        case StmtKind::ForEach:
        case StmtKind::With: ends_before(stmt.statement[0]); break;
        case StmtKind::For: ends_before(stmt.statement[1]); break;
        case StmtKind::Switch: {
            const std::uint32_t behind = check.ast()[stmt.expression[0]].range.end;
            const std::string_view rest =
                check.sources.text(SourceRange{head.file, behind, head.end});
            end = behind + static_cast<std::uint32_t>(rest.find(')') + 1);
            break;
        }
        case StmtKind::Declaration: ends_before(check.ast()[stmt.declaration].body); break;
        default: break;
    }
    if (end <= head.begin) return head;
    head.end = end;
    const std::string_view text = check.sources.text(head);
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    if (last != std::string_view::npos)
        head.end = head.begin + static_cast<std::uint32_t>(last) + 1;
    return head;
}

namespace {

/// Whether a value of the type is one that can be shown.
bool has_form(const Check& check, Type type) {
    const TypeInfo& info = check.type_info(type);
    switch (info.kind) {
        case TypeKind::Error:
        case TypeKind::Void:
        case TypeKind::Range:
        case TypeKind::Execution: return false;
        default: return info.slots > 0;
    }
}

NamedVariable described(Check& check, const Symbol& symbol) {
    NamedVariable named;
    named.name = symbol.name;
    named.type = check.type_name(symbol.type);
    named.is_parameter = symbol.is_parameter;
    named.range = symbol.range;
    named.form = shown_form(check, symbol.type, false);
    using S = NamedVariable::Storage;
    switch (symbol.storage) {
        case Symbol::Storage::Local:
            named.storage = S::Register;
            named.first = symbol.reg;
            break;
        case Symbol::Storage::Reference:
            named.storage = S::Reference;
            named.type += '&';
            named.first = symbol.reg;
            break;
        case Symbol::Storage::Global:
            named.storage = S::Global;
            named.first = symbol.global;
            break;
        case Symbol::Storage::Constant:
            named.storage = S::Constant;
            named.constant = symbol.constant.constant;
            break;
    }
    return named;
}

}  // namespace

void note_variable(Check& check, Symbol& symbol) {
    if (!check.options.keeps_names || symbol.name.empty() || !has_form(check, symbol.type)) return;
    NamedVariable named = described(check, symbol);
    named.from = check.emit.here();
    symbol.named = static_cast<std::uint32_t>(check.code->names.variables.size());
    check.code->names.variables.push_back(std::move(named));
}

void end_variable(Check& check, const Symbol& symbol) {
    if (symbol.named == Symbol::kNotNamed) return;
    check.code->names.variables[symbol.named].to = check.emit.here();
}

void end_variables(Check& check) {
    for (const Symbol& symbol : check.scopes.all()) end_variable(check, symbol);
}

void finish_names(Check& check) {
    if (!check.options.keeps_names) return;
    CodeNames& names = check.code->names;
    names.starts.assign(check.code->instructions.size(), 0);
    for (std::uint32_t i = 0; i < names.statements.size(); ++i)
        names.starts[names.statements[i].at] = i + 1;
    for (std::uint32_t i = 0; i < check.names.global_count(); ++i) {
        const GlobalVariable& global = check.names.global(i);
        const bool is_known = global.state == GlobalVariable::State::Done;
        if (!is_known || !has_form(check, global.symbol.type)) continue;
        // Units are those of its file.
        const std::uint32_t module = std::exchange(check.here.module, global.module);
        const Units units = std::exchange(check.here.units, check.names.module(module).units);
        names.globals.push_back(described(check, global.symbol));
        check.here.module = module;
        check.here.units = units;
    }
}

}  // namespace kadr::sema
