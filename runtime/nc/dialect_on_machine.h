// dialect_on_machine.h — a dialect as its control is set up on a kind of machine.
//
// Controls for milling and for turning are delivered with other defaults: `lathe` of a <group>
// tells which of them act at power-on of a lathe.
#pragma once

#include "nc/dialect.h"

namespace kadr::nc {

enum class MachineKind : std::uint8_t { Mill, Lathe };

/// Loads a dialect as `load_dialect` does, with the defaults for machines of this kind.
std::optional<Dialect> load_dialect_for(MachineKind kind, const std::string& name_or_file,
                                        const SearchPath& folders, Sources& sources,
                                        DiagnosticSink& sink);

}  // namespace kadr::nc
