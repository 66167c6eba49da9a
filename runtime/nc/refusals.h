// refusals.h — which forms of a dialect could not write what was given, and why: for the author of
// the file, who expected one of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/source.h"

namespace kadr::nc {

struct DialectTables;
struct Form;

struct Refusal {
    std::string pattern;  // the form's first line
    SourceRange range;    // of the form, in the file
    std::string why;      // "`dwell` is 0.5, not 0"
};

/// The form with the reasons why it was passed over.
///
/// wrong   parameters that it does not take as they are, a bit each
/// given   … those of all that have a value
/// values  index parameter; shorter where nobody knows them
Refusal refusal_of(const DialectTables& tables, const Form& form, std::uint32_t wrong,
                   std::uint32_t given, std::span<const double> values);

/// Parameters that are given, and that the values which the form fixes or takes (`when`) exclude.
std::uint32_t excluded_values(const Form& form, std::uint32_t given,
                              std::span<const double> values);

}  // namespace kadr::nc
