#include "sema/declared_names.h"

#include <algorithm>
#include <utility>

namespace kadr::sema {

namespace {

const Name* own_name(const ModuleScope& scope, std::string_view name) {
    const auto found = scope.names.find(name);
    return found == scope.names.end() ? nullptr : &found->second;
}

}  // namespace

std::uint32_t DeclaredNames::add_module(const syntax::Ast& ast, const nc::Dialect& dialect) {
    ModuleScope scope;
    scope.ast = &ast;
    scope.dialect = &dialect;
    modules_.push_back(std::move(scope));
    return module_count() - 1;
}

std::optional<std::uint32_t> DeclaredNames::module_of(const syntax::Ast& ast) const {
    for (std::uint32_t i = 0; i < modules_.size(); ++i) {
        if (modules_[i].ast == &ast) return i;
    }
    return std::nullopt;
}

void DeclaredNames::import(std::uint32_t module, std::uint32_t imported) {
    std::vector<std::uint32_t>& imports = modules_[module].imports;
    if (std::ranges::find(imports, imported) == imports.end()) imports.push_back(imported);
}

const Name* DeclaredNames::find(std::uint32_t module, std::string_view name) const {
    const ModuleScope& scope = modules_[module];
    if (const Name* own = own_name(scope, name)) return own;
    for (const std::uint32_t import : scope.imports) {
        if (const Name* found = own_name(modules_[import], name)) return found;
    }
    return prelude_ ? own_name(modules_[*prelude_], name) : nullptr;
}

std::vector<const Name*> DeclaredNames::imported(std::uint32_t module,
                                                 std::string_view name) const {
    std::vector<const Name*> all;
    for (const std::uint32_t import : modules_[module].imports) {
        if (const Name* found = own_name(modules_[import], name)) all.push_back(found);
    }
    return all;
}

std::vector<std::uint32_t> DeclaredNames::visible_modules(std::uint32_t module) const {
    std::vector<std::uint32_t> all = {module};
    all.insert(all.end(), modules_[module].imports.begin(), modules_[module].imports.end());
    if (prelude_) all.push_back(*prelude_);
    return all;
}

std::uint32_t DeclaredNames::add_function(FunctionDecl function) {
    functions_.push_back(std::move(function));
    return function_count() - 1;
}

void DeclaredNames::want(std::uint32_t function) {
    if (functions_[function].is_wanted) return;
    functions_[function].is_wanted = true;
    wanted_.push_back(function);
}

std::uint32_t DeclaredNames::add_global(std::uint32_t module, syntax::DeclId decl) {
    globals_.push_back({GlobalVariable::State::Unchecked, module, decl, {}});
    return global_count() - 1;
}

std::optional<std::uint32_t> DeclaredNames::cycle_module(nc::CycleId cycle) const {
    const auto found = cycle_modules_.find(cycle);
    return found == cycle_modules_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace kadr::sema
