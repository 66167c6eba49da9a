// quadrature.h — integrals of smooth functions: arc lengths.
#pragma once

#include <cmath>

namespace kadr::path {

/// Gauss-Legendre with five points: exact for polynomials of degree nine.
template <typename Function>
double gauss(const Function& f, double from, double to) {
    constexpr double kNodes[] = {0.5384693101056831, 0.9061798459386640};
    constexpr double kWeights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    double sum = kWeights[0] * f(middle);
    for (int i = 0; i < 2; ++i) {
        const double distance = half * kNodes[i];
        sum += kWeights[i + 1] * (f(middle - distance) + f(middle + distance));
    }
    return half * sum;
}

struct Integral {
    double value = 0;
    double error = 0;  // what the last halving changed: far above the true error
};

/// Halves the interval until the halves give the same as the whole, within `tolerance`.
///
/// whole  what `gauss` gives of all of it
template <typename Function>
Integral integrate(const Function& f, double from, double to, double tolerance, double whole,
                   int depth = 0) {
    // A kink, as the speed has in a cusp, halves the error with the width; there it ends.
    constexpr int kDeepest = 30;
    const double middle = 0.5 * (from + to);
    const double left = gauss(f, from, middle);
    const double right = gauss(f, middle, to);
    const double error = std::fabs(left + right - whole);
    if (error <= tolerance || depth >= kDeepest) return {left + right, error};
    const Integral a = integrate(f, from, middle, tolerance / 2, left, depth + 1);
    const Integral b = integrate(f, middle, to, tolerance / 2, right, depth + 1);
    return {a.value + b.value, a.error + b.error};
}
template <typename Function>
Integral integrate(const Function& f, double from, double to, double tolerance) {
    return integrate(f, from, to, tolerance, gauss(f, from, to));
}

}  // namespace kadr::path
