// Short lines as a CAM system writes them, from the text to the setpoints, in every mode of the
// compressor: the tool keeps within the tolerance of the lines, passes every vertex within it, and
// its path is as long as they are.
//
// The chord error of the lines is 0.3 to 3 times the tolerance, as it is where the CAM system has
// been given the same one: there curves through the vertices just keep to it, or just do not.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interp/interpreter.h"
#include "macro/program.h"
#include "motion/pipeline.h"
#include "path/vec3.h"
#include "tests/nc/nc_testing.h"

namespace kadr::interp::compressed_chains_test {

using macro::NcProgram;
namespace {

using path::Vec3;

constexpr int kChains = 1000;
constexpr double kRounding = 1e-6;  // mm

struct Chain {
    std::vector<Vec3> points;  // three decimals; the first one is zero
    double tolerance = 0;      // mm
    double sharpest = 0;       // radius of the curve that it is of, mm
};

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double between(double from, double to) {
        return from + (to - from) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    /// The logarithm evenly.
    double factor(double from, double to) {
        return std::exp(between(std::log(from), std::log(to)));
    }
    bool is_heads() { return (engine_() & 1) != 0; }

  private:
    std::mt19937_64 engine_;
};

Vec3 rounded(const Vec3& point) { return (point * 1000).array().round() / 1000; }

/// Lines along a curve whose curvature swings about a mean, or grows as that of a spiral, in a
/// plane or rising; of one length, or each as long as the chord error lets it be.
Chain random_chain(Random& random) {
    Chain chain;
    chain.tolerance = std::round(random.factor(0.004, 0.05) * 1000) / 1000;
    const double chord_error = chain.tolerance * random.factor(0.3, 3);
    const double swing = random.is_heads() ? random.between(0, 0.9) : 0;
    const double growth = random.between(-0.3, 0.3);
    const double sharper = (1 + swing) * (1 + std::max(growth, 0.0));
    // A rounded corner of the angle θ shortens a path of such corners by θ²/12: with 0.3 rad by
    // 0.75 %. θ² is 8·error/radius.
    const double radius =
        std::max(random.factor(2, 40), 8 * chord_error * sharper / (0.3 * 0.3) * sharper);
    const double wave = random.between(0.3, 3) / radius;  // rad/mm
    const double rise = random.is_heads() ? random.between(-0.3, 0.3) : 0;
    const bool is_even = random.is_heads();
    const auto lines = static_cast<int>(random.between(20, 90));
    chain.sharpest = radius / sharper;
    Vec3 at = Vec3::Zero();
    double turn = random.between(0, 2 * std::numbers::pi);
    double distance = 0;
    chain.points = {at};
    for (int i = 0; i < lines; ++i) {
        const double share = static_cast<double>(i) / lines;
        const double bend = (1 + growth * share) * (1 + swing * std::sin(wave * distance)) / radius;
        // The sagitta of a chord of the length L is L²/8r.
        const double length = std::min(
            std::sqrt(8 * chord_error / (is_even ? 1 / radius : std::max(bend, 1e-3))), 10.0);
        constexpr int kSteps = 20;
        for (int k = 0; k < kSteps; ++k) {
            const double step = length / kSteps;
            turn += bend * step;
            at += step * Vec3(std::cos(turn), std::sin(turn), rise);
        }
        distance += length;
        if (rounded(at) != chain.points.back()) chain.points.push_back(rounded(at));
    }
    return chain;
}

std::string text_of(const Chain& chain, const std::string& head) {
    std::string text = head + "S6000 M3\nF3000\n";
    for (std::size_t i = 1; i < chain.points.size(); ++i) {
        const Vec3& to = chain.points[i];
        text += fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f}\n", to.x(), to.y(), to.z());
    }
    return text + "M30\n";
}

const machine::Machine& mill() {
    static const machine::Machine kMill = [] {
        Sources sources;
        DiagnosticList messages;
        auto machine =
            machine::load_machine("mill", {KADR_ROOT "/runtime/machines"}, sources, messages);
        EXPECT_TRUE(machine.has_value());
        return *machine;
    }();
    return kMill;
}

struct Walked {
    std::vector<Vec3> tips;
    std::size_t lines = 0;  // of the text that setpoints have: a curve has that of its last line
};

Walked walked(const nc::Dialect& dialect, const machine::Machine& machine,
              const std::string& text) {
    DiagnosticList messages;
    nc::testing::OneText source(text);
    NcProgram program(dialect, source, "chain", {}, messages);
    Interpreter interpreter(dialect, machine, program, &program, nullptr, {}, messages);
    program.follow(interpreter);
    motion::Planner planner(interpreter, machine, {}, messages);
    motion::Sampler sampler(planner, machine);
    Walked walked;
    std::uint32_t line = 0;
    std::vector<motion::Setpoint> batch(256);
    while (const std::size_t count = sampler.pull(batch)) {
        for (std::size_t i = 0; i < count; ++i) {
            walked.tips.push_back(batch[i].tip);
            if (std::exchange(line, batch[i].line) != batch[i].line) ++walked.lines;
        }
    }
    EXPECT_FALSE(messages.has_errors());
    return walked;
}

double distance(const Vec3& point, const Vec3& from, const Vec3& to) {
    const Vec3 delta = to - from;
    const double square = delta.squaredNorm();
    const double share = square > 0 ? std::clamp((point - from).dot(delta) / square, 0.0, 1.0) : 0;
    return (point - from - share * delta).norm();
}

/// The farthest of the places from the lines. Both run the same way: each place is looked for
/// beside that of the place before, on so much more of the lines as the places are apart, twice.
double farthest(const std::vector<Vec3>& places, const std::vector<Vec3>& lines) {
    double most = 0;
    std::size_t at = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double apart = k == 0 ? 0 : (places[k] - places[k - 1]).norm();
        double least = std::numeric_limits<double>::infinity();
        double passed = 0;
        const std::size_t before = at;
        for (std::size_t i = before > 2 ? before - 2 : 0;
             i + 1 < lines.size() && passed <= 2 * apart + 0.5; ++i) {
            const double off = distance(places[k], lines[i], lines[i + 1]);
            if (off < least) at = i;
            least = std::min(least, off);
            if (i > before) passed += (lines[i + 1] - lines[i]).norm();
        }
        most = std::max(most, least);
    }
    return most;
}

double length_of(const std::vector<Vec3>& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    return length;
}

struct Mode {
    const char* name;
    const char* dialect;
    std::string (*head)(int chain, double tolerance);
};

std::string with_corners(int chain, double tolerance, const char* compressor) {
    constexpr const char* kCorners[] = {"G64", "G642", "G645"};
    return fmt::format("G17 G90 {} {} CTOL={}\n", kCorners[chain % 3], compressor, tolerance);
}

class CompressedChains : public ::testing::TestWithParam<Mode> {};

TEST_P(CompressedChains, KeepToTheTolerance) {
    const Mode& mode = GetParam();
    const nc::Dialect& dialect = nc::testing::shipped(mode.dialect);
    Random random(26);
    std::size_t lines = 0;
    std::size_t seen = 0;
    for (int i = 0; i < kChains; ++i) {
        const Chain chain = random_chain(random);
        machine::Machine machine = mill();
        machine.compressor_tolerance = chain.tolerance;
        const std::string text = text_of(chain, mode.head(i, chain.tolerance));
        const auto [tips, curves_and_lines] = walked(dialect, machine, text);
        lines += chain.points.size() - 1;
        seen += curves_and_lines;
        ASSERT_EQ(tips.back(), chain.points.back()) << text;
        ASSERT_LE(farthest(tips, chain.points), chain.tolerance + kRounding) << text;
        // Between two setpoints, at most 0.05 mm apart, the tool goes on a bow.
        const double bow = 0.05 * 0.05 / chain.sharpest;
        ASSERT_LE(farthest(chain.points, tips), chain.tolerance + bow) << text;
        ASSERT_NEAR(length_of(tips) / length_of(chain.points), 1, 0.01) << text;
    }
    // Half of the chains have a chord error below the tolerance: these become curves of several
    // lines. Else it would be no feat to keep to them.
    EXPECT_LT(static_cast<double>(seen), 0.65 * static_cast<double>(lines));
}

INSTANTIATE_TEST_SUITE_P(
    Modes, CompressedChains,
    ::testing::Values(
        Mode{"COMPON", "sinumerik",
             [](int chain, double tolerance) { return with_corners(chain, tolerance, "COMPON"); }},
        Mode{
            "COMPCURV", "sinumerik",
            [](int chain, double tolerance) { return with_corners(chain, tolerance, "COMPCURV"); }},
        Mode{"COMPCAD", "sinumerik",
             [](int chain, double tolerance) { return with_corners(chain, tolerance, "COMPCAD"); }},
        Mode{"CYCLE832", "sinumerik",
             [](int, double tolerance) {
                 return fmt::format("G17 G90\nCYCLE832({},1)\n", tolerance);
             }},
        Mode{"SmoothInterpolation", "fanuc",
             [](int, double) { return std::string("G17 G90\nG05.1 Q2 X0 Y0 Z0\n"); }}),
    [](const auto& mode) { return std::string(mode.param.name); });

/// A spiral of lines of 6.5 degrees, whose chord error passes the tolerance on the way: 216.45 mm.
TEST(CompressedSpiral, IsAsLongAsItsLines) {
    Chain chain;
    chain.tolerance = 0.02;
    std::string text = "G17 G90 G64 COMPON CTOL=0.02\nS6000 M3\nF4000\n";
    const auto point = [](int i) {
        const double angle = 6.5 * i * std::numbers::pi / 180;
        const double radius = 10 + 6.5 * i * 0.002777778;
        return rounded(radius * Vec3(std::cos(angle), std::sin(angle), 0));
    };
    for (int i = 0; i <= 166; ++i) chain.points.push_back(point(i));
    for (const Vec3& to : chain.points)
        text += fmt::format("{} X{:.3f} Y{:.3f}\n", &to == &chain.points[0] ? "G0" : "G1", to.x(),
                            to.y());
    auto [tips, curves_and_lines] =
        walked(nc::testing::shipped("sinumerik"), mill(), text + "M30\n");
    const Vec3& start = chain.points[0];
    tips.erase(tips.begin(), std::find_if(tips.begin(), tips.end(), [&](const Vec3& tip) {
                   return (tip - start).norm() < 0.02 || tip.y() > 0;
               }));
    EXPECT_LE(farthest(tips, chain.points), chain.tolerance + kRounding);
    EXPECT_LE(farthest(chain.points, tips), chain.tolerance + 0.02);
    EXPECT_NEAR(length_of(chain.points), 216.45, 0.01);
    EXPECT_NEAR(length_of(tips), 216.45, 0.5);
    EXPECT_LE(curves_and_lines, 94u);
}

}  // namespace
}  // namespace kadr::interp::compressed_chains_test
