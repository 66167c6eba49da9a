// Curves fitted with lines and biarcs: within the tolerance at ten thousand samples, tangents
// continuous, not more pieces than reason; derivatives and arc lengths against the oracle.
#include "path/fit.h"

#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/path/oracle_arcs.h"

namespace kadr::path::fit_test {
namespace {

constexpr double kPi = std::numbers::pi;

CurveSample at(double x, double y, double dx, double dy) {
    return {Vec3(x, y, 0), Vec3(dx, dy, 0)};
}

struct Fitted {
    Vec3 start = Vec3::Zero();
    std::vector<FitPiece> pieces;
    Contour contour;  // of plane pieces
};

Fitted fit(const ParametricCurve& curve, const FitOptions& options) {
    CurveFit fitting(curve, options);
    Fitted result;
    result.start = *fitting.start();
    Vec2 from = result.start.head<2>();
    while (const auto piece = fitting.next()) {
        result.pieces.push_back(*piece);
        const Vec2 to = piece->to.head<2>();
        result.contour.push_back({from, to, piece->center, piece->sweep});
        from = to;
    }
    EXPECT_FALSE(fitting.fault().has_value());
    return result;
}

/// Largest distance of ten thousand samples from the pieces.
double deviation(const ParametricCurve& curve, const FitOptions& options, const Fitted& fitted) {
    double worst = 0;
    for (int i = 0; i <= 10000; ++i) {
        const double t = options.from + (options.to - options.from) * i / 10000;
        const Vec2 point = curve(t)->position.head<2>();
        worst = std::max(worst, nearest(fitted.contour, point).distance);
    }
    return worst;
}

/// Largest change of direction from one piece to the next, rad.
double largest_corner(const Contour& contour) {
    double worst = 0;
    for (std::size_t i = 0; i + 1 < contour.size(); ++i) {
        const Vec2 in = end_direction(contour[i]);
        const Vec2 out = start_direction(contour[i + 1]);
        worst = std::max(worst,
                         std::fabs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out))));
    }
    return worst;
}

struct Curve {
    const char* name;
    ParametricCurve curve;
    double from, to;
    std::size_t most_arcs;  // at 5 µm
    std::size_t most_lines;
};

std::vector<Curve> curves() {
    const auto ellipse = [](double t) {
        return at(30 * std::cos(t), 20 * std::sin(t), -30 * std::sin(t), 20 * std::cos(t));
    };
    const auto spiral = [](double t) {
        const double r = 5 + 2 * t;
        return at(r * std::cos(t), r * std::sin(t), 2 * std::cos(t) - r * std::sin(t),
                  2 * std::sin(t) + r * std::cos(t));
    };
    const auto wave = [](double t) { return at(t, 3 * std::sin(t), 1, 3 * std::cos(t)); };
    const auto gear = [](double t) {  // 64 waves: samples in step with them would see nothing
        const double r = 40 + 0.5 * std::cos(64 * t);
        const double dr = -32 * std::sin(64 * t);
        return at(r * std::cos(t), r * std::sin(t), dr * std::cos(t) - r * std::sin(t),
                  dr * std::sin(t) + r * std::cos(t));
    };
    const auto circle = [](double t) {
        return at(10 * std::cos(t), 10 * std::sin(t), -10 * std::sin(t), 10 * std::cos(t));
    };
    const auto line = [](double t) { return at(100 * t, 50 * t, 100, 50); };
    // A cusp at t = 0, where the derivative is zero.
    const auto cusp = [](double t) { return at(10 * t * t * t, 10 * t * t, 30 * t * t, 20 * t); };
    return {
        {"ellipse", ellipse, 0, 2 * kPi, 40, 200},
        {"ellipse clockwise", ellipse, 2 * kPi, 0, 40, 200},
        {"spiral", spiral, 0, 6 * kPi, 60, 520},
        {"wave", wave, -10, 10, 72, 200},
        {"gear", gear, 0, 2 * kPi, 64 * 16, 64 * 40},
        {"circle", circle, 0, 2 * kPi, 2, 110},
        {"a quarter of it", circle, 0, kPi / 2, 1, 28},
        {"circle, three turns and a half", circle, 0, 7 * kPi, 8, 385},
        {"line", line, 0, 1, 1, 1},
        {"line backwards", line, 1, 0, 1, 1},
        {"cusp", cusp, -1, 1, 60, 120},
    };
}

TEST(Fit, KeepsTheTolerance) {
    for (const Curve& row : curves()) {
        for (const FitKind kind : {FitKind::Biarcs, FitKind::Lines}) {
            for (const double tolerance : {0.1, 0.005, 0.0002}) {
                SCOPED_TRACE(row.name);
                SCOPED_TRACE(tolerance);
                const FitOptions options{kind, tolerance, row.from, row.to};
                const Fitted fitted = fit(row.curve, options);
                EXPECT_LE(deviation(row.curve, options, fitted), tolerance * (1 + 1e-9) + 1e-12);
                ASSERT_FALSE(fitted.pieces.empty());
                EXPECT_EQ(fitted.pieces.back().to, row.curve(row.to)->position);
                if (tolerance != 0.005) continue;
                EXPECT_LE(fitted.pieces.size(),
                          kind == FitKind::Biarcs ? row.most_arcs : row.most_lines);
            }
        }
    }
}

TEST(Fit, LongPiecesSeeWhatIsNarrow) {
    // A straight line with one dent of a hundredth of its length.
    const auto dent = [](double t) -> std::optional<CurveSample> {
        const double u = (t - 0.7) * 200;
        const bool is_inside = std::fabs(u) < 1;
        const double rise = is_inside ? 1 - u * u : 0;
        return at(100 * t, rise * rise, 100, is_inside ? -800 * rise * u : 0);
    };
    for (const FitKind kind : {FitKind::Biarcs, FitKind::Lines}) {
        const FitOptions options{kind, 0.005, 0, 1};
        const Fitted fitted = fit(dent, options);
        EXPECT_LE(deviation(dent, options, fitted), 0.005 * (1 + 1e-9));
        EXPECT_LE(fitted.pieces.size(), 60u);
    }
}

TEST(Fit, ArcsRunIntoEachOther) {
    for (const Curve& row : curves()) {
        if (std::string_view(row.name) == "cusp") continue;
        SCOPED_TRACE(row.name);
        const Fitted fitted = fit(row.curve, {FitKind::Biarcs, 0.005, row.from, row.to});
        // Flat arcs became lines: they rise by less than a nanometre per millimetre.
        EXPECT_LT(largest_corner(fitted.contour), 2e-4);
        std::size_t arcs = 0;
        for (const Element& element : fitted.contour) {
            if (!element.is_arc()) continue;
            ++arcs;
            EXPECT_LT(std::fabs((element.to - element.center).norm() - radius(element)), 1e-9);
        }
        const bool is_straight = std::string_view(row.name).starts_with("line");
        EXPECT_EQ(2 * arcs > fitted.contour.size(), !is_straight);
    }
}

TEST(Fit, LinesInSpace) {
    // A helix: chords of a circle of radius 10, climbing.
    const auto helix = [](double t) -> std::optional<CurveSample> {
        return CurveSample{Vec3(10 * std::cos(t), 10 * std::sin(t), t),
                           Vec3(-10 * std::sin(t), 10 * std::cos(t), 1)};
    };
    const Fitted fitted = fit(helix, {FitKind::Lines, 0.01, 0, 4 * kPi});
    Vec3 from = fitted.start;
    double worst = 0;
    double t = 0;
    for (const FitPiece& piece : fitted.pieces) {
        const Vec3 delta = piece.to - from;
        for (; t < 4 * kPi && helix(t)->position.z() <= piece.to.z(); t += 1e-3) {
            const Vec3 point = helix(t)->position - from;
            worst =
                std::max(worst, (point - delta * (point.dot(delta) / delta.squaredNorm())).norm());
        }
        from = piece.to;
    }
    EXPECT_LE(worst, 0.01);
    EXPECT_GT(worst, 0.007);                // chords are as long as they may be
    EXPECT_LE(fitted.pieces.size(), 150u);  // s²/(8 r) = 0.01: 0.894 mm each, 126 mm in all
}

TEST(Fit, SaysWhatIsWrong) {
    const auto jump = [](double t) -> std::optional<CurveSample> {
        return at(t, t < 0.5 ? 0 : 3, 1, 0);
    };
    CurveFit jumping(jump, {FitKind::Biarcs, 0.01, 0, 1});
    while (jumping.next()) {
    }
    ASSERT_TRUE(jumping.fault());
    EXPECT_EQ(*jumping.fault(), FitFault::Jump);
    EXPECT_NEAR(jumping.parameter(), 0.5, 1e-6);
    const auto half = [](double t) -> std::optional<CurveSample> {
        if (t > 0.5) return std::nullopt;
        return at(t, t * t, 1, 2 * t);
    };
    CurveFit ending(half, {FitKind::Lines, 0.01, 0, 1});
    while (ending.next()) {
    }
    ASSERT_TRUE(ending.fault());
    EXPECT_EQ(*ending.fault(), FitFault::NotEvaluated);
}

TEST(Fit, CornersOfACurveAreMet) {
    // |t| has no direction at 0; the pieces on both sides end there.
    const auto corner = [](double t) -> std::optional<CurveSample> {
        return at(10 * t, 10 * std::fabs(t), 10, t < 0 ? -10 : 10);
    };
    for (const FitKind kind : {FitKind::Biarcs, FitKind::Lines}) {
        const FitOptions options{kind, 0.001, -1, 1.1};
        const Fitted fitted = fit(corner, options);
        EXPECT_LE(deviation(corner, options, fitted), 0.001);
        EXPECT_LE(fitted.pieces.size(), 120u);
    }
}

/// Splines and polynomials of the oracle: whoever evaluates them, the pieces are as long as they.
TEST(Fit, LengthsOfTheOracle) {
    std::ifstream file(KADR_ROOT "/tests/oracles/curves.json");
    const test::Json oracle = test::Json::parse(file);
    int polynomials = 0;
    for (const test::Json& entry : oracle["cases"]) {
        if (entry["type"] != "poly") continue;
        SCOPED_TRACE(entry["id"].get<std::string>());
        ++polynomials;
        const test::Json coefficients = entry["input"]["coeffs_xyz_ascending"];
        const auto curve = [&](double u) -> std::optional<CurveSample> {
            CurveSample sample;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                double value = 0;
                double slope = 0;
                for (std::size_t k = coefficients[axis].size(); k-- > 0;) {
                    slope = slope * u + value;
                    value = value * u + coefficients[axis][k].get<double>();
                }
                sample.position[static_cast<Eigen::Index>(axis)] = value;
                sample.derivative[static_cast<Eigen::Index>(axis)] = slope;
            }
            return sample;
        };
        const double from = entry["u_range"][0];
        const double to = entry["u_range"][1];
        for (const test::Json& sample : entry["expect"]["samples"]) {
            const auto here = curve(sample["u"]);
            EXPECT_LT((here->position - test::vec3(sample["C"])).norm(), 1e-9);
        }
        const double tolerance = 1e-4;
        const Fitted fitted = fit(curve, {FitKind::Lines, tolerance, from, to});
        Vec3 begin = fitted.start;
        double length = 0;
        double lost = 0;  // a chord s is shorter than its arc by 8 h²/(3 s), h the deviation
        for (const FitPiece& piece : fitted.pieces) {
            const double chord = (piece.to - begin).norm();
            length += chord;
            lost += 8 * tolerance * tolerance / (3 * chord);
            begin = piece.to;
        }
        const double expected = entry["expect"]["length"];
        EXPECT_LE(length, expected + 1e-9);
        EXPECT_GE(length, expected - 1.5 * lost - 1e-7);
    }
    EXPECT_GT(polynomials, 0);
}

/// Sums of three waves in each of two coordinates.
struct Waves {
    double amplitude[2][3];
    double frequency[2][3];
    double phase[2][3];

    std::optional<CurveSample> operator()(double t) const {
        CurveSample sample;
        for (int i = 0; i < 2; ++i) {
            for (int k = 0; k < 3; ++k) {
                const double angle = frequency[i][k] * t + phase[i][k];
                sample.position[i] += amplitude[i][k] * std::cos(angle);
                sample.derivative[i] -= amplitude[i][k] * frequency[i][k] * std::sin(angle);
            }
        }
        return sample;
    }
};

/// Largest distance of evenly spread points of 0 … 3 from the pieces of the fit.
double deviation_of_waves(const Waves& waves, const FitOptions& options) {
    const Fitted fitted = fit(waves, options);
    if (fitted.contour.empty() || length(fitted.contour) == 0) return 0;
    double worst = 0;
    for (int i = 0; i <= 2000; ++i) {
        const Vec2 point = waves(3.0 * i / 2000)->position.head<2>();
        worst = std::max(worst, nearest(fitted.contour, point).distance);
    }
    return worst;
}

TEST(Fit, HoldsTheWholeCurveAgainstThePieces) {
    // The distance from this one has a kink behind the end of an arc: points beside it are within
    // the tolerance, those between them were not.
    const Waves waves{{{-9.1, -16.66, -11.16}, {5.04, -17.7, -7.3}},
                      {{4, 1, 1}, {2, 1, 3}},
                      {{1.48, 2.88, 4.39}, {4.65, 4.46, 2.2}}};
    EXPECT_LE(deviation_of_waves(waves, {FitKind::Biarcs, 0.173, 0, 3}), 0.173 * (1 + 1e-9));
}

RC_GTEST_PROP(Fit, KeepsTheToleranceOnRandomCurves, ()) {
    Waves waves{};
    for (int i = 0; i < 2; ++i) {
        for (int k = 0; k < 3; ++k) {
            waves.amplitude[i][k] = (*rc::gen::inRange(-1000, 1001)) / 50.0;
            waves.frequency[i][k] = *rc::gen::inRange(0, 7);
            waves.phase[i][k] = (*rc::gen::inRange(0, 628)) / 100.0;
        }
    }
    const bool arcs = *rc::gen::arbitrary<bool>();
    const FitOptions options{arcs ? FitKind::Biarcs : FitKind::Lines,
                             (*rc::gen::inRange(1, 200)) / 1000.0, 0, 3};
    RC_ASSERT(deviation_of_waves(waves, options) <= options.tolerance * (1 + 1e-9));
}

}  // namespace
}  // namespace kadr::path::fit_test
