// declared_names.h — what the files of a program declare at their top, and who sees it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "sema/names.h"

namespace kadr::sema {

class DeclaredNames {
  public:
    std::uint32_t add_module(const syntax::Ast& ast, const nc::Dialect& dialect);
    std::optional<std::uint32_t> module_of(const syntax::Ast& ast) const;
    ModuleScope& module(std::uint32_t index) { return modules_[index]; }
    const ModuleScope& module(std::uint32_t index) const { return modules_[index]; }
    std::uint32_t module_count() const { return static_cast<std::uint32_t>(modules_.size()); }
    void import(std::uint32_t module, std::uint32_t imported);
    /// Whether this is the first time that somebody asks: then the prelude is to be loaded.
    bool ask_for_prelude() { return !std::exchange(was_asked_, true); }
    /// The file whose names are everybody's.
    void set_prelude(std::uint32_t module) { prelude_ = module; }
    std::optional<std::uint32_t> prelude() const { return prelude_; }

    /// What a name means in a file: its own, those of its imports, those of the prelude. Null:
    /// nothing of a file.
    const Name* find(std::uint32_t module, std::string_view name) const;
    /// What all the imports of a file mean by a name.
    std::vector<const Name*> imported(std::uint32_t module, std::string_view name) const;
    /// The files whose names a file sees, itself first.
    std::vector<std::uint32_t> visible_modules(std::uint32_t module) const;

    std::uint32_t add_function(FunctionDecl function);
    FunctionDecl& function(std::uint32_t index) { return functions_[index]; }
    const FunctionDecl& function(std::uint32_t index) const { return functions_[index]; }
    std::span<const FunctionDecl> functions() const { return functions_; }
    std::uint32_t function_count() const { return static_cast<std::uint32_t>(functions_.size()); }
    /// The body of a function is to be checked: somebody calls it.
    void want(std::uint32_t function);
    const std::vector<std::uint32_t>& wanted() const { return wanted_; }

    std::uint32_t add_global(std::uint32_t module, syntax::DeclId decl);
    GlobalVariable& global(std::uint32_t index) { return globals_[index]; }
    const GlobalVariable& global(std::uint32_t index) const { return globals_[index]; }
    std::uint32_t global_count() const { return static_cast<std::uint32_t>(globals_.size()); }

    /// The file of the library that has the body of a cycle which is a block somewhere.
    void set_cycle_module(nc::CycleId cycle, std::uint32_t module) {
        cycle_modules_[cycle] = module;
    }
    std::optional<std::uint32_t> cycle_module(nc::CycleId cycle) const;
    bool has_cycle_blocks() const { return !cycle_modules_.empty(); }

  private:
    std::vector<ModuleScope> modules_;  // 0: the file that was asked for
    std::vector<FunctionDecl> functions_;
    std::vector<GlobalVariable> globals_;
    std::vector<std::uint32_t> wanted_;  // functions, in the order in which they were wanted
    std::optional<std::uint32_t> prelude_;
    bool was_asked_ = false;  // for the prelude
    std::map<nc::CycleId, std::uint32_t> cycle_modules_;
};

}  // namespace kadr::sema
