// line.h — a straight piece of path, and the point that remains when nothing moves.
#pragma once

#include "path/vec3.h"

namespace kadr::path {

/// A tool tip that stands while something else moves or time passes.
struct Point {
    Vec3 at = Vec3::Zero();
};

inline double length(const Point&) { return 0; }
inline Vec3 start(const Point& point) { return point.at; }
inline Vec3 end(const Point& point) { return point.at; }
inline Vec3 position(const Point& point, double) { return point.at; }
inline CurvePoint evaluate(const Point& point, double) { return {point.at}; }
inline Point part(const Point& point, double, double) { return point; }
inline Box bounds(const Point& point) { return {point.at, point.at}; }

struct Line {
    Vec3 start;
    Vec3 end;
    Vec3 direction;  // unit vector
    double length;   // mm, > 0
};

/// The straight line between two different points.
Line make_line(const Vec3& start, const Vec3& end);

inline double length(const Line& line) { return line.length; }
inline Vec3 start(const Line& line) { return line.start; }
inline Vec3 end(const Line& line) { return line.end; }
inline Vec3 position(const Line& line, double s) {
    if (s >= line.length) return line.end;
    return line.start + line.direction * (s > 0 ? s : 0.0);
}
inline CurvePoint evaluate(const Line& line, double s) {
    return {position(line, s), line.direction};
}
Line part(const Line& line, double from, double to);
Box bounds(const Line& line);

}  // namespace kadr::path
