// coverage.h — which entries of a dialect have been used by texts: what no test has tried.
#pragma once

#include <string>
#include <vector>

#include "nc/dialect.h"

namespace kadr::nc {

/// An entry of the file that a text can use.
struct DialectEntry {
    std::string name;             // as it is written: "form G04 P{time:ms}", "function SIN({a})"
    const void* place = nullptr;  // as Dialect::record notes it
};

/// The forms of this file that are read, and the operators, functions, variables and statements of
/// its language; what it inherits is tried with the file that it comes from. A code with a number,
/// `G{number+53}`, gives entries with one name.
std::vector<DialectEntry> entries_of(const Dialect& dialect);

/// Names of the entries that nothing in `used` belongs to, each once.
std::vector<std::string> unused_entries(const Dialect& dialect, const UsedEntries& used);

}  // namespace kadr::nc
