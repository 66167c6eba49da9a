// inspect.h — a dialect file with its mistakes, for whoever looks at the file rather than uses it.
#pragma once

#include <optional>
#include <string>

#include "base/xml.h"
#include "nc/dialect.h"

namespace kadr::nc {

struct InspectedDialect {
    std::optional<Dialect> dialect;  // nothing: there is no such file, or it cannot be read at all
    bool has_mistakes = true;        // reported; then the dialect is good for looking on only
    XmlElement root;                 // what stands in the file itself, if there is a dialect
};

/// Loads a dialect as `load_dialect` does, but gives it with its mistakes, for further checks.
InspectedDialect inspect_dialect(const std::string& name_or_file, const SearchPath& folders,
                                 Sources& sources, DiagnosticSink& sink);

}  // namespace kadr::nc
