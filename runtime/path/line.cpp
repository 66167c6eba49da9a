#include "path/line.h"

#include "base/assert.h"

namespace kadr::path {

Line make_line(const Vec3& start, const Vec3& end) {
    const Vec3 delta = end - start;
    const double length = delta.norm();
    KADR_ASSERT(length > 0, "a line needs two different points");
    return {start, end, delta / length, length};
}

Line part(const Line& line, double from, double to) {
    // The direction stays the whole line's: a short piece would compute a worse one.
    return {position(line, from), position(line, to), line.direction, to - from};
}

Box bounds(const Line& line) {
    return {line.start.cwiseMin(line.end), line.start.cwiseMax(line.end)};
}

}  // namespace kadr::path
