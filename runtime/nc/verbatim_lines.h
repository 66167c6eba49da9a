// verbatim_lines.h — lines of a control's own language that the dialect knows by their letters,
// with numbers between them.
#pragma once

#include <string_view>

#include "nc/block.h"
#include "nc/number_text.h"
#include "nc/tables.h"

namespace kadr::nc {

/// Whether the line is one; then the block, which is empty before, has its function.
///
/// units  in which the numbers stand
bool read_verbatim(const DialectTables& tables, const TextUnits& units, std::string_view line,
                   Block& block);

}  // namespace kadr::nc
