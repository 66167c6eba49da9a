// written_shapes.h — the shapes that stand in the text for cycles along them. For the room expand
// only.
#pragma once

#include <cstdint>
#include <vector>

#include "path/contour.h"

namespace kadr::expand {

/// A shape in the text, between the numbers of its first and its last block.
struct WrittenShape {
    path::Contour elements;
    std::int32_t first = -1;
    std::int32_t last = -1;
};

struct WrittenShapes {
    std::vector<WrittenShape> all;
    std::int64_t greatest = -1;  // number in the text so far; -1: nobody has looked
};

}  // namespace kadr::expand
