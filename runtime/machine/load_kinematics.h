// load_kinematics.h — the element <kinematics> of a machine file: where its rotary axes are.
#pragma once

#include <optional>
#include <span>

#include "base/diagnostic.h"
#include "base/xml.h"
#include "machine/machine.h"

namespace kadr::machine {

/// Every mistake is reported with its location.
///
/// axes     of the same file: the chain's are among them
/// returns  nothing if the chain cannot be used; it has been reported why
std::optional<Kinematics> read_kinematics(const XmlElement& element,
                                          std::span<const MachineAxis> axes, DiagnosticSink& sink);

}  // namespace kadr::machine
