// with.h — `with`: modal state that is set back behind a body.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

ModalMask named_state(const Check& check, const syntax::Word& word);
ModalMask words_mask(Check& check, std::span<const syntax::Word> words, bool is_preserves);
Done require_least(Check& check, const nc::FunctionInfo& info,
                   std::span<const syntax::ExprId> bound, const syntax::Expr& expr);
ModalMask with_mask(Check& check, const syntax::Stmt& stmt);
Completion with_statement(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
