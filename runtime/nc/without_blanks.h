// without_blanks.h — a line as a control sees it for which blanks count nowhere: `GO TO 1 0` is
// GOTO10.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "nc/control_line.h"

namespace kadr::nc {

/// A line whose blanks are gone; comments stand as they were written.
struct LineWithoutBlanks {
    std::string text;
    std::vector<std::uint32_t> columns;  // of its characters in the line, and of the line's end

    /// An index in the text as the index in the line, in bytes.
    void put_back(Span& span) const;
    /// The same for all that was compiled of the text.
    void put_back(ControlLine& line) const;
};

/// Whether blanks count nowhere and stand, outside of comments, between two letters or two digits.
bool has_split_words(const DialectTables& tables, std::string_view line);

/// The line without its blanks, whatever they stand between.
LineWithoutBlanks without_blanks(const DialectTables& tables, std::string_view line);

}  // namespace kadr::nc
