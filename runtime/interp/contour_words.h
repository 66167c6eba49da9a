// contour_words.h — what no block of a contour says, whatever reads the contour: a cycle along a
// shape (shapes.cpp), a program that wants it as a table (contours.cpp).
#pragma once

#include "nc/vocabulary.h"

namespace kadr::interp {

/// Whether the function works by itself, or changes what the places behind it mean.
inline bool leaves_contour(nc::Function function) {
    using nc::Function;
    switch (function) {
        case Function::Cycle:
        case Function::CyclePreset:
        case Function::CycleModal:
        case Function::ReferencePoint:
        case Function::ReferenceReturn:
        case Function::ReferenceCheck:
        case Function::ReferenceLeave:
        case Function::RapidOnce:
        case Function::WayOffset:
        case Function::MachineCoordinates:
        case Function::PositionReset:
        case Function::SetPosition:
        case Function::WorkOffset:
        case Function::Shift:
        case Function::ShiftAdd:
        case Function::ShiftAxes:
        case Function::ShiftAxesAdd:
        case Function::SetPositionAxes:
        case Function::Rotate:
        case Function::RotateOff:
        case Function::Scale:
        case Function::ScaleOff:
        case Function::Mirror:
        case Function::MirrorOff:
        case Function::Probe: return true;
        default: return false;
    }
}

}  // namespace kadr::interp
