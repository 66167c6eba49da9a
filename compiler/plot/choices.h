// choices.h — what of a picture may be chosen.
#pragma once

#include <cstdint>

namespace kadr::plot {

/// A part of a run, s.
struct TimeWindow {
    double from = 0;
    double to = 0;  // 0: to the end
};

/// What the colours of a path stand for.
enum class PlotColor : std::uint8_t { Feed, Line };

}  // namespace kadr::plot
