// lint.h — mistakes of a dialect file that loads: what stands twice, contradicts itself, or can
// never act.
//
// The loader takes such a file, because the last entry wins and what is never read hurts nobody;
// its author meant something else. Knows the file's own elements and the finished tables.
#pragma once

#include "base/xml.h"
#include "nc/dialect.h"

namespace kadr::nc {

/// Reports what in the file itself can hardly be meant, each at its element.
///
/// root     the file's outermost element, of a file that fits the shape of a dialect
/// dialect  what the file and those that it extends hold together
void check_sense(const XmlElement& root, const Dialect& dialect, DiagnosticSink& sink);

}  // namespace kadr::nc
