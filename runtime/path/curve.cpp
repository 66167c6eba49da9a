#include "path/curve.h"

namespace kadr::path {

double length(const Curve& curve) {
    return std::visit([](const auto& kind) { return length(kind); }, curve);
}

double arc_length(const Curve& curve) {
    if (const auto* glide = std::get_if<Glide>(&curve)) return arc_length(*glide);
    return length(curve);
}

Vec3 start(const Curve& curve) {
    return std::visit([](const auto& kind) { return start(kind); }, curve);
}

Vec3 end(const Curve& curve) {
    return std::visit([](const auto& kind) { return end(kind); }, curve);
}

Vec3 position(const Curve& curve, double s) {
    return std::visit([s](const auto& kind) { return position(kind, s); }, curve);
}

CurvePoint evaluate(const Curve& curve, double s) {
    return std::visit([s](const auto& kind) { return evaluate(kind, s); }, curve);
}

Curve part(const Curve& curve, double from, double to) {
    return std::visit([=](const auto& kind) { return Curve(part(kind, from, to)); }, curve);
}

Box bounds(const Curve& curve) {
    return std::visit([](const auto& kind) { return bounds(kind); }, curve);
}

}  // namespace kadr::path
