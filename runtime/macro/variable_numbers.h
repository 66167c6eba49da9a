// variable_numbers.h — names that a program has made stand for the numbers of variables.
//
// They are put in before a line is read, so nothing behind knows of them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "macro/replaced_text.h"
#include "nc/tables.h"

namespace kadr::macro {

class VariableNumbers {
  public:
    /// `500[WIDTH,DEPTH]`: the names stand for #500, #501 … from here on. A fault has no span.
    /// source: F 6.6
    std::optional<nc::LineFault> define(const nc::Language& language, std::string_view text);
    /// The line with the numbers: `[#WIDTH]=5`, `X[#WIDTH]`. Nothing: it has no such name.
    std::optional<ReplacedText> numbered(const nc::DialectTables& tables,
                                         std::string_view line) const;

  private:
    std::map<std::string, std::int64_t, std::less<>> names_;
};

}  // namespace kadr::macro
