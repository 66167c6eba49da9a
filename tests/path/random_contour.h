// random_contour.h — contours by chance, the same ones on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "path/contour.h"

namespace kadr::path::test {

/// The same throws on every machine.
class Dice {
  public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    double between(double least, double most) {
        return least + (most - least) * static_cast<double>(engine_()) / 4294967296.0;
    }
    int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }

  private:
    std::mt19937 engine_;
};

/// From a point to a point, straight or with a bend.
inline Element any_element(Dice& dice, const Vec2& from, const Vec2& to) {
    if (dice.below(3) == 0) return line_element(from, to);
    const Vec2 across = Vec2(from.y() - to.y(), to.x() - from.x()) / 2;
    const double bend = dice.between(0.4, 4);
    const double share = dice.below(2) == 0 ? bend : -bend;
    const Vec2 center = (from + to) / 2 + across * share;
    return arc_element(from, to, center, share > 0);
}

/// A contour around the zero point, counter-clockwise, with corners of every kind. It begins and
/// ends in the middle of an element.
inline Contour any_contour(Dice& dice) {
    const int count = 4 + dice.below(5);
    std::vector<Vec2> corners;
    for (int i = 0; i < count; ++i) {
        const double heading = 2 * std::numbers::pi * (i + dice.between(-0.4, 0.4)) / count;
        corners.push_back(dice.between(5, 40) * Vec2(std::cos(heading), std::sin(heading)));
    }
    Contour contour;
    for (std::size_t i = 0; i < corners.size(); ++i)
        contour.push_back(any_element(dice, corners[i], corners[(i + 1) % corners.size()]));
    contour.insert(contour.begin(), part(contour.back(), 0.5, 1));
    contour.back() = part(contour.back(), 0, 0.5);
    return contour;
}

/// Of a cutter beside contours of this size, to one of their sides: mm, positive to the left.
inline double any_distance(Dice& dice) {
    const double distance = dice.between(0.3, 4);
    return dice.below(2) == 0 ? distance : -distance;
}

/// Whether elements meet at their ends only.
inline bool is_simple(const Contour& contour) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
        for (std::size_t j = i + 1; j < contour.size(); ++j) {
            for (const Crossing& crossing : crossings(contour[i], contour[j])) {
                const bool is_joint =
                    j == i + 1 && (crossing.point - contour[j].from).norm() < 1e-4;
                const bool closes = i == 0 && j + 1 == contour.size() &&
                                    (crossing.point - contour[i].from).norm() < 1e-4;
                if (!is_joint && !closes) return false;
            }
        }
    }
    return true;
}

}  // namespace kadr::path::test
