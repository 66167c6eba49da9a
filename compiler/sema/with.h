// with.h — `with`: modal state that is set back behind a body.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// The state that a word of `with` or `preserves` names by itself (F, S, FRAMES); 0: none.
ModalMask named_state(const Check& check, const syntax::Word& word);
/// The modal groups that words belong to; words that are not modal are reported.
ModalMask words_mask(Check& check, std::span<const syntax::Word> words, bool is_preserves);
/// Reports a call that names no axis, or no factor, where one at least is needed.
Done require_least(Check& check, const nc::FunctionInfo& info,
                   std::span<const syntax::ExprId> bound, const syntax::Expr& expr);
/// What a `with` sets back behind its body.
ModalMask with_mask(Check& check, const syntax::Stmt& stmt);
/// `with (…) { }`.
Completion with_statement(Check& check, const syntax::Stmt& stmt);

}  // namespace kadr::sema
