// Texts of random contours under cutter radius compensation, executed: what goes out keeps the
// cutter's distance from the programmed contour, measured by brute force.
#include <cstdio>
#include <limits>

#include <Eigen/Geometry>

#include "path/radius_comp.h"
#include "tests/path/random_contour.h"
#include "text_bench.h"

namespace kadr::interp::compensated_contours_test {
namespace {

using path::Contour;
using path::Element;
using path::Op;
using path::Vec2;
using path::Vec3;
using path::test::Dice;
using std::numbers::pi;

struct Control {
    const char* dialect;
    const char* start;  // with the side {0}
    path::CompRules rules;
};

const path::CompRules kArcs{.leaves_out = true};
const path::CompRules kPointed{.pointed = 0.4, .leaves_out = true};
const path::CompRules kIntersections{
    .outside = path::OutsideCorner::Intersection, .limit = 100 * pi / 180, .leaves_out = true};
const path::CompRules kSquares{.outside = path::OutsideCorner::Intersection,
                               .limit = pi / 2,
                               .sharp = path::OutsideCorner::Square,
                               .extends_tangents = true};

const std::vector<Control> kControls = {
    {"sinumerik", "T1 D1 M6\nM3 S1000 F500 CDON\n", kArcs},
    {"sinumerik", "T1 D1 M6\nM3 S1000 F500 CDON DISC=40\n", kPointed},
    {"sinumerik", "T1 D1 M6\nM3 S1000 F500 CDON G451\n", kIntersections},
    {"fanuc", "G17 G21 G90 G94 G40 G49 G80\nT1 M6\nM3 S1000 F500.\n", kSquares},
};

std::string point(const Vec2& at, char x = 'X', char y = 'Y') {
    char text[80];
    std::snprintf(text, sizeof text, "%c%.6f %c%.6f", x, at.x(), y, at.y());
    return text;
}

/// From a place on the normal at the contour's start, along it, to the normal at its end.
std::string text_of(const Contour& contour, const Control& control, double distance) {
    const bool is_fanuc = std::string(control.dialect) == "fanuc";
    const auto beside = [&](const Vec2& at, const Vec2& direction) -> Vec2 {
        return at + Vec2(-direction.y(), direction.x()) * distance;
    };
    const Element& last = contour.back();
    std::string text = control.start;
    text += "G0 " + point(beside(contour[0].from, path::start_direction(contour[0]))) + '\n';
    text += std::string(distance > 0 ? "G41" : "G42") + (is_fanuc ? " D1" : "") + " G1 " +
            point(contour[0].from) + '\n';
    for (const Element& element : contour) {
        text += !element.is_arc() ? "G1 " : element.sweep > 0 ? "G3 " : "G2 ";
        text += point(element.to);
        if (element.is_arc()) text += ' ' + point(element.center - element.from, 'I', 'J');
        text += '\n';
    }
    return text + "G40 G1 " + point(beside(last.to, path::end_direction(last))) + "\nM30\n";
}

/// What the control makes of the contour's words, which it takes to its increment: a run of the
/// same text without compensation, from behind the approach to the way out.
Contour as_read(const Contour& contour, const Control& control, double distance,
                const machine::Machine& machine) {
    std::string text = text_of(contour, control, distance);
    text.erase(text.find(distance > 0 ? "G41" : "G42"), 3);
    const Ran ran = read(control.dialect, text, machine);
    Contour all;
    Vec2 at = Vec2::Zero();
    for (const path::Command& command : ran.commands) {
        if (!command.is_motion()) continue;
        const Vec2 to(command.motion().to[0], command.motion().to[1]);
        Element element = path::line_element(at, to);
        if (command.op() == Op::Arc) {
            element.center = command.motion().arc().center.head<2>();
            element.sweep = command.motion().arc().sweep * command.motion().arc().normal.z();
        }
        all.push_back(element);
        at = to;
    }
    EXPECT_EQ(all.size(), contour.size() + 3) << text;  // to the start, to the contour, away
    if (all.size() < 4) return {};
    return {all.begin() + 2, all.end() - 1};
}

/// How far arcs end beside the circle on which they began: words on the increment.
double off_circles(const Contour& contour) {
    double most = 0;
    for (const Element& element : contour) {
        if (!element.is_arc()) continue;
        const double first = (element.from - element.center).norm();
        most = std::max(most, std::abs((element.to - element.center).norm() - first));
    }
    return most;
}

/// Every 20 µm of what is cut.
double least_distance(const Ran& ran, const Contour& contour) {
    double least = std::numeric_limits<double>::infinity();
    Vec3 at = Vec3::Zero();
    for (const path::Command& command : ran.commands) {
        if (!command.is_motion()) continue;
        const Vec3 to(command.motion().to[0], command.motion().to[1], command.motion().to[2]);
        const auto look = [&](double length, const auto& point) {
            const int count = 1 + static_cast<int>(length / 0.02);
            for (int i = 0; i <= count; ++i) {
                const Vec3 here = point(static_cast<double>(i) / count);
                least = std::min(least, path::nearest(contour, here.head<2>()).distance);
            }
        };
        if (command.op() == Op::Line) {
            look((to - at).norm(), [&](double u) -> Vec3 { return at + (to - at) * u; });
        } else if (command.op() == Op::Arc) {
            const Vec3 arm = at - command.motion().arc().center;
            look(arm.norm() * command.motion().arc().sweep, [&](double u) -> Vec3 {
                return command.motion().arc().center +
                       Eigen::AngleAxisd(command.motion().arc().sweep * u,
                                         command.motion().arc().normal) *
                           arm;
            });
        } else if (command.op() == Op::Spline) {
            const path::CubicSpan span = path::make_spline(at, to, command.motion().spline());
            look(span.length * 2,
                 [&](double u) -> Vec3 { return path::point_at(span, u).position; });
        }
        at = to;
    }
    return least;
}

std::optional<path::CompFault> fault_of(const Contour& contour, path::CompRules rules,
                                        double distance) {
    rules.look_ahead = contour.size();
    path::RadiusComp comp(rules);
    for (std::size_t i = 0; i < contour.size(); ++i)
        if (const auto fault = comp.push(contour[i], distance, i + 1)) return fault;
    return comp.finish();
}

TEST(CompensatedContours, KeepTheDistance) {
    constexpr std::uint32_t kContours = 60;
    std::uint32_t done = 0;
    int alarmed = 0;
    for (std::uint32_t seed = 1; done < kContours; ++seed) {
        Dice dice(seed);
        const Contour contour = path::test::any_contour(dice);
        const double distance = path::test::any_distance(dice);
        if (!path::test::is_simple(contour)) continue;
        ++done;
        const Control& control = kControls[seed % kControls.size()];
        const std::string text = text_of(contour, control, distance);
        SCOPED_TRACE(text);
        machine::Machine machine = mill();
        machine.work_offsets.clear();
        machine.tools[0].radius = std::abs(distance);
        const Contour meant = as_read(contour, control, distance, machine);
        const Ran ran = read(control.dialect, text, machine);
        const auto fault = fault_of(meant, control.rules, distance);
        alarmed += static_cast<int>(ran.alarmed);
        if (!fault) {
            EXPECT_EQ(alarms(ran), "") << "the cutter fits";
            EXPECT_GT(least_distance(ran, meant), std::abs(distance) - 1e-3 - off_circles(meant));
        } else if (*fault != path::CompFault::Bottleneck) {
            EXPECT_TRUE(ran.alarmed);  // a bottleneck may be farther than the control looks
        }
    }
    EXPECT_LT(alarmed, static_cast<int>(kContours) / 4) << "most of them fit";
}

/// A slot whose walls lean, in a contour that otherwise goes straight: the cutter on the left goes
/// into it. Mouth and bottom are 1 to 12 mm wide.
Contour slot(Dice& dice) {
    const double mouth = dice.between(1, 12);
    const double bottom = dice.between(1, 12);
    const double depth = dice.between(3, 15);
    const double turn = dice.between(0, 2 * pi);
    const auto turned = [&](double x, double y) -> Vec2 {
        return {x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)};
    };
    const double middle = 30;
    const std::vector<Vec2> corners = {turned(0, 0),
                                       turned(middle - mouth / 2, 0),
                                       turned(middle - bottom / 2, -depth),
                                       turned(middle + bottom / 2, -depth),
                                       turned(middle + mouth / 2, 0),
                                       turned(2 * middle, 0)};
    Contour contour;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
        contour.push_back(path::line_element(corners[i], corners[i + 1]));
    return contour;
}

/// Whether a disc of this radius can touch every element of a contour of lines, and every corner
/// that stands out, from the left without reaching over the contour: tried at many places.
bool disc_fits(const Contour& contour, double radius) {
    const auto is_free = [&](const Vec2& center) {
        return path::nearest(contour, center).distance > radius - 1e-6;
    };
    const auto beside = [&](const Vec2& at, const Vec2& direction) -> Vec2 {
        return at + Vec2(-direction.y(), direction.x()) * radius;
    };
    constexpr int kTries = 2000;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const Vec2 along = path::start_direction(contour[i]);
        bool touches = false;
        for (int k = 0; k <= kTries && !touches; ++k) {
            const Vec2 at = contour[i].from + (contour[i].to - contour[i].from) * k / kTries;
            touches = is_free(beside(at, along));
        }
        if (!touches) return false;
        if (i + 1 == contour.size()) return true;
        const Vec2 next = path::start_direction(contour[i + 1]);
        const double turn =
            std::atan2(along.x() * next.y() - along.y() * next.x(), along.dot(next));
        if (turn > 0) continue;  // the corner lies inside
        for (int k = 0; k <= 100; ++k) {
            const double angle = turn * k / 100;
            const Vec2 delta(along.x() * std::cos(angle) - along.y() * std::sin(angle),
                             along.x() * std::sin(angle) + along.y() * std::cos(angle));
            if (!is_free(beside(contour[i].to, delta))) return false;
        }
    }
    return true;
}

TEST(CompensatedContours, BottlenecksAreAlarms) {
    constexpr std::uint32_t kSlots = 160;
    int fitting = 0;
    int narrow = 0;
    int alarmed = 0;
    for (std::uint32_t seed = 1; seed <= kSlots; ++seed) {
        Dice dice(seed);
        const Contour contour = slot(dice);
        const double radius = dice.between(0.8, 4);
        const bool fits = disc_fits(contour, radius);
        if (fits != disc_fits(contour, radius * 0.98) || fits != disc_fits(contour, radius * 1.02))
            continue;  // words are rounded
        (fits ? fitting : narrow) += 1;
        const bool is_dovetail =
            (contour[2].to - contour[2].from).norm() > (contour[3].to - contour[1].from).norm();
        for (const Control& control : kControls) {
            // With bottleneck detection a bottom that the cutter cannot reach is left out, if the
            // walls meet; what is cut keeps the distance.
            const bool goes_on = control.rules.leaves_out && !is_dovetail;
            const bool has_fault = fault_of(contour, control.rules, radius).has_value();
            if (fits || !goes_on) {
                EXPECT_EQ(has_fault, !fits) << control.dialect;
            }
            if (is_dovetail)
                continue;  // both sides of its mouth are farther apart than controls look
            // From a place that stays far enough off on the increment.
            const std::string text = text_of(contour, control, radius + 0.01);
            SCOPED_TRACE(text + "radius " + std::to_string(radius));
            machine::Machine machine = mill();
            machine.work_offsets.clear();
            machine.tools[0].radius = radius;
            const Ran ran = read(control.dialect, text, machine);
            if (fits || !goes_on) {
                EXPECT_EQ(ran.alarmed, !fits) << alarms(ran);
            }
            alarmed += static_cast<int>(ran.alarmed);
            const Contour meant = as_read(contour, control, radius + 0.01, machine);
            EXPECT_GT(least_distance(ran, meant), radius - 1e-3);
        }
    }
    EXPECT_GT(fitting, 30);
    EXPECT_GT(narrow, 30);
    EXPECT_GT(alarmed, 30) << "mouths that are too narrow";
}

/// A new D on lines: the cutter's distance goes over to it along the block and is never less than
/// the smaller of both, at corners inside and outside.
TEST(CompensatedContours, AnotherRadiusOnTheWay) {
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        Dice dice(seed);
        const Control& control = kControls.back();
        Contour contour;
        Vec2 at = Vec2::Zero();
        double heading = dice.between(0, 2 * pi);
        for (int i = 0; i < 7; ++i) {
            const Vec2 to = at + dice.between(25, 40) * Vec2(std::cos(heading), std::sin(heading));
            contour.push_back(path::line_element(at, to));
            heading += dice.between(-1.2, 1.2);
            at = to;
        }
        if (!path::test::is_simple(contour)) continue;
        const double first = dice.between(1, 4);
        const double second = dice.between(1, 4);
        std::string text = text_of(contour, control, first);
        std::size_t line = text.find("G1 ", text.find("G41") + 8);
        for (int i = 0; i < 3; ++i) line = text.find("G1 ", line + 1);
        text.insert(line, "D2 ");
        char data[80];
        std::snprintf(data, sizeof data, "G10 L12 P1 R%.3f\nG10 L12 P2 R%.3f\n", first, second);
        text.insert(0, data);
        SCOPED_TRACE(text);
        machine::Machine machine = mill();
        machine.work_offsets.clear();
        const Ran ran = read(control.dialect, text, machine);
        ASSERT_TRUE(alarms(ran).empty() || alarms(ran) == "K5977") << alarms(ran);  // D2 of T1
        const double least = least_distance(ran, contour);
        EXPECT_GT(least, std::min(first, second) - 2e-3);
        EXPECT_LT(least, std::min(first, second) + 2e-3);
    }
}

}  // namespace
}  // namespace kadr::interp::compensated_contours_test
