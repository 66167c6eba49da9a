// program_lines.h — the lines that a control has around a program: its name, the safety line, the
// end.
//
// Text alone, of the dialect's `<program>`; what the lines mean to the blocks between them is for
// whoever writes or reads them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nc/tables.h"

namespace kadr::nc {

struct ProgramInfo {
    std::string name;  // of the program: "bracket"
    std::int64_t number = 1;
    std::string title;  // shown behind the name where the control has room for it
    bool is_inch = false;
    std::int64_t greatest_number = 0;  // that a block has itself; those that are counted lie above
    const FunctionSet* used =
        nullptr;  // that its blocks may have; null: nobody knows, it may be any
};

/// The lines, filled in for one program, without block numbers and without the sign that ends a
/// block.
struct ProgramLines {
    std::vector<std::string> header;   // before the first block; no blocks themselves
    std::vector<std::string> start;    // blocks that stand before the program's own
    std::vector<std::string> section;  // blocks behind a tool change
    std::vector<std::string> finish;   // blocks that end a program which does not end itself
    std::vector<std::string> end;      // behind the last block; no blocks themselves
};
ProgramLines program_lines(const DialectTables& tables, const ProgramInfo& program);

}  // namespace kadr::nc
