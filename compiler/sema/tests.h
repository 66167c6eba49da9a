// tests.h — `test` and `property`: calls that are executed, figures, expectations.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

void declare_test(Check& check, std::uint32_t module, syntax::DeclId id);
bool is_in_test(const Check& check);
void report_test_block(Check& check, const SourceRange& range);
void property_ranges(Check& check, std::uint32_t function);
std::optional<Value> test_builtin(Check& check, std::string_view name, const syntax::Expr& expr);
/// A figure of an execution; `call` is null where it is not called.
Value figure(Check& check, const Lvalue& execution, const syntax::Expr& member,
             const syntax::Expr* call);
void assume_statement(Check& check, const syntax::Stmt& stmt);
void expect_statement(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
