#include "sema/recorder.h"

#include <utility>

namespace kadr::sema {

void Recorder::add_file(const syntax::Ast& ast, const nc::Dialect& dialect) {
    CheckedFile file;
    file.ast = &ast;
    file.dialect = &dialect;
    file.expressions.resize(ast.expressions.size());
    file.statements.resize(ast.statements.size());
    file.declarations.resize(ast.declarations.size());
    file.types.resize(ast.types.size());
    checked_.files.push_back(std::move(file));
}

void Recorder::set_units(std::uint32_t file, Units units) { checked_.files[file].units = units; }

void Recorder::import(std::uint32_t file, const SourceRange& range, std::uint32_t imported) {
    checked_.files[file].imports.push_back({range, imported});
}

SymbolId Recorder::declare(DeclaredSymbol symbol) {
    if (dry_runs_ > 0) return {};
    const SymbolId id{static_cast<std::uint32_t>(checked_.symbols.size())};
    if (symbol.decl.is_valid()) checked_.files[symbol.file].declarations[symbol.decl.index] = id;
    checked_.symbols.push_back(std::move(symbol));
    return id;
}

void Recorder::set_type(SymbolId symbol, Type type) {
    if (symbol.is_valid()) checked_.symbols[symbol.index].type = type;
}

void Recorder::end_scope(SymbolId symbol, std::uint32_t end) {
    if (symbol.is_valid()) checked_.symbols[symbol.index].scope.end = end;
}

ExpressionFacts* Recorder::facts(std::uint32_t file, syntax::ExprId id) {
    return dry_runs_ > 0 ? nullptr : &checked_.files[file].expressions[id.index];
}

void Recorder::note_type(std::uint32_t file, syntax::ExprId id, Type type) {
    if (ExpressionFacts* facts = this->facts(file, id)) facts->type = type;
}

void Recorder::note_value(std::uint32_t file, syntax::ExprId id, const ConstantValue& constant) {
    ExpressionFacts* facts = this->facts(file, id);
    if (facts == nullptr) return;
    facts->type = constant.type;
    facts->constant = static_cast<std::uint32_t>(checked_.constants.size());
    checked_.constants.push_back(constant);
}

void Recorder::note_use(std::uint32_t file, syntax::ExprId id, SymbolId symbol) {
    if (ExpressionFacts* facts = this->facts(file, id)) facts->symbol = symbol;
}

void Recorder::note_givenness(std::uint32_t file, syntax::ExprId id, Givenness givenness) {
    if (ExpressionFacts* facts = this->facts(file, id)) facts->givenness = givenness;
}

void Recorder::note_type_use(std::uint32_t file, syntax::TypeId id, SymbolId symbol) {
    if (dry_runs_ == 0) checked_.files[file].types[id.index] = symbol;
}

void Recorder::note_word(std::uint32_t file, const SourceRange& range, SymbolId symbol) {
    if (dry_runs_ == 0) checked_.files[file].words.push_back({range, symbol});
}

void Recorder::note_plan(std::uint32_t file, syntax::StmtId id, std::uint32_t plan) {
    if (dry_runs_ > 0 || !id.is_valid()) return;
    std::uint32_t& first = checked_.files[file].statements[id.index].plan;
    if (first == StatementFacts::kNoPlan) first = plan;
}

}  // namespace kadr::sema
