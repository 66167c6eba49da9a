// load_pipeline.h — the element <pipeline> of a machine file.
#pragma once

#include "base/diagnostic.h"
#include "base/xml.h"
#include "machine/machine.h"

namespace kadr::machine {

/// Every mistake is reported with its location. Whether a module is linked into the program is not
/// known here: who runs it looks (process/command_modules.h).
///
/// machine  everything else of the file, which the pipeline refers to
Pipeline read_pipeline(const XmlElement& element, const Machine& machine, DiagnosticSink& sink);

}  // namespace kadr::machine
