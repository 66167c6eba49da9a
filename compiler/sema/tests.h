// tests.h — `test` and `property`: calls that are executed, figures, expectations.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// A `test` or `property` of the file that was asked for.
void declare_test(Check& check, std::uint32_t module, syntax::DeclId id);
/// Whether the check is in the body of a test or property.
bool is_in_test(const Check& check);
/// Reports an NC block in a test.
void report_test_block(Check& check, const SourceRange& range);
/// The ranges that the parameters of a property are drawn from.
void property_ranges(Check& check, std::uint32_t function);
/// `execute(…)`, `attempt(…)`, `text(…)` …; nothing: the name is none of a test's.
std::optional<Value> test_builtin(Check& check, std::string_view name, const syntax::Expr& expr);
/// A figure of an execution; `call` is null where it is not called.
Value figure(Check& check, const Lvalue& execution, const syntax::Expr& member,
             const syntax::Expr* call);
/// `assume`: values for which it is not so are drawn again.
void assume_statement(Check& check, const syntax::Stmt& stmt);
/// `expect`: on failure both sides are shown.
void expect_statement(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
