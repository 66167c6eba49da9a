// sketch.h — the path in plan view, drawn with braille dots, for a terminal.
#pragma once

#include <string>

#include "plot/plot_scene.h"

namespace kadr::repl {

/// `columns` characters wide at most, of two by four dots each, both axes to one scale. Rapids are
/// drawn as dots further apart. Below it stand the ranges of X and Y.
std::string sketch(const plot::PlotScene& scene, std::size_t columns);

}  // namespace kadr::repl
