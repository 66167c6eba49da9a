// output_names.h — holds the names of outputs against each other and against the source.
#pragma once

#include <initializer_list>
#include <span>
#include <string>

#include "base/diagnostic.h"
#include "base/done.h"

namespace kadr::driver {

/// No output is the source and no two are the same file; empty names are nobody's.
Done require_outputs_apart(const Files& files, const std::string& source,
                           std::span<const std::string> outputs, DiagnosticSink& sink);

}  // namespace kadr::driver
