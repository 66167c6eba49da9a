// naming.h — writes down which variable a register holds and where statements begin
// (CodeNames), if somebody wants to know.
#pragma once

#include "sema/checking.h"

namespace kadr::sema {

/// A statement begins at the next instruction. One that has no instructions is forgotten by
/// `drop_empty_statement`.
void note_statement(Check& check, const SourceRange& range);
/// The same for one of the tree; nothing if it does nothing itself, as a block, or begins behind
/// what stands in its head, as a `while`, which the loops note.
void note_statement(Check& check, const syntax::Stmt& stmt);
/// Behind a statement that began at this instruction.
void drop_empty_statement(Check& check, std::uint32_t began);
/// The head of a statement with a body, else all of it.
SourceRange head_range(const Check& check, const syntax::Stmt& stmt);

/// From here on the variable has its value. Gives the symbol its entry.
void note_variable(Check& check, Symbol& symbol);
/// Its scope ends.
void end_variable(Check& check, const Symbol& symbol);
/// The function ends, and with it all that is open.
void end_variables(Check& check);
/// Globals of all files, and which instructions begin statements; once everything is checked.
void finish_names(Check& check);

}  // namespace kadr::sema
