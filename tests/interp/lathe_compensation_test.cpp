// Nose radius compensation of lathes: the tip that goes out, and the nose that must touch the
// contour and never cut into it. Rules: sinumerik.md 5.2, fanuc.md 4.2 and 4.3; the places of the
// tip are those of both.
#include <cmath>
#include <numbers>
#include <random>

#include "text_bench.h"

namespace kadr::interp::lathe_compensation_test {
namespace {

using path::Command;
using path::Op;
using path::Vec2;

constexpr double kTolerance = 0.001;  // mm

machine::Machine lathe(double radius, int tip) {
    machine::Machine machine = mill();
    machine.is_lathe = true;
    machine.work_offsets.clear();
    machine.tools.clear();
    machine::ToolData& tool = machine.tools.emplace_back();
    tool.number = 1;
    tool.radius = radius;
    tool.tip = tip;
    return machine;
}

/// Ends of the motions, X as a diameter: `30,2 24,0`.
std::string tips_of(const Ran& ran) {
    std::string out;
    for (const Command& command : ran.commands) {
        if (!command.is_motion()) continue;
        const auto rounded = [](double value) { return std::round(value * 1000) / 1000 + 0.0; };
        char text[64];
        std::snprintf(text, sizeof text, "%s%g,%g", out.empty() ? "" : " ",
                      rounded(2 * command.motion().to[0]), rounded(command.motion().to[2]));
        out += text;
    }
    return out;
}

struct Control {
    const char* name;
    const char* start;
    const char* end;
};
const Control kControls[] = {
    {"sinumerik", "G18 G90 G94 DIAMON\nT=\"1\" D1\nM6\nS500 M3\n", "M30\n"},
    {"fanuc-lathe", "%\nO1\nG18 G98\nT0101\nS500 M03\n", "M30\n%\n"},
};

TEST(LatheCompensation, TheTipTouchesXAndZ) {
    for (const Control& control : kControls) {
        SCOPED_TRACE(control.name);
        const auto run = [&](const std::string& text, int tip) {
            const Ran ran = read(control.name, control.start + text + control.end, lathe(1, tip));
            EXPECT_EQ(alarms(ran), "");
            return tips_of(ran);
        };
        // Along a cylinder of 20 mm the tip is on it; the approach ends where the nose's centre is
        // across from the first point.
        EXPECT_EQ(run("G0 X30. Z5.\nG42 G1 X20. Z2. F100.\nZ-10.\nG40 X30.\n", 3),
                  "30,5 20,1 20,-11 30,-10");
        // With the centre programmed it stands off by the radius.
        EXPECT_EQ(run("G0 X30. Z5.\nG42 G1 X20. Z2. F100.\nZ-10.\nG40 X30.\n", 9),
                  "30,5 22,2 22,-10 30,-10");
        // In a bore the tip is at X+, the contour on the other side.
        EXPECT_EQ(run("G0 X10. Z5.\nG41 G1 X20. Z2. F100.\nZ-10.\nG40 X10.\n", 2),
                  "10,5 20,1 20,-11 10,-10");
    }
}

// ------------------------------------------------------------------------------ brute force

/// An element of the contour in Z and X (a radius).
struct Element {
    Vec2 from;
    Vec2 to;
    Vec2 center = Vec2::Zero();
    double sweep = 0;  // 0: a line
};

double distance_to(const Element& element, const Vec2& point) {
    if (element.sweep == 0) {
        const Vec2 along = element.to - element.from;
        const double t =
            std::clamp((point - element.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        return (point - element.from - t * along).norm();
    }
    const Vec2 arm = point - element.center;
    const Vec2 first = element.from - element.center;
    double angle = std::atan2(first.x() * arm.y() - first.y() * arm.x(), first.dot(arm));
    if (element.sweep < 0) angle = -angle;
    if (angle < 0) angle += 2 * std::numbers::pi;
    if (angle <= std::abs(element.sweep)) return std::abs(arm.norm() - first.norm());
    return std::min((point - element.from).norm(), (point - element.to).norm());
}

double rounded(double value) { return std::round(value * 1000) / 1000; }

struct Part {
    std::vector<Element> elements;
    std::string words;  // of the elements
};

/// From the face towards the chuck, rising and falling: lines, and arcs of a quarter turn at most.
Part random_part(std::mt19937& random, double radius) {
    std::uniform_real_distribution<double> part(0, 1);
    Part result;
    Vec2 at{0, 15};
    char text[128];
    for (int i = 0; i < 8; ++i) {
        const double length = radius * (3 + 4 * part(random));
        const double angle = (2 * part(random) - 1) * std::numbers::pi / 5;  // off the axis
        Element element;
        element.from = at;
        element.to = {rounded(at.x() - length * std::cos(angle)),
                      rounded(at.y() + length * std::sin(angle))};
        const bool is_arc = part(random) < 0.5;
        if (!is_arc) {
            std::snprintf(text, sizeof text, "G1 X%.3f Z%.3f\n", 2 * element.to.y(),
                          element.to.x());
        } else {
            const Vec2 chord = element.to - element.from;
            const double of_arc = rounded(std::max(chord.norm(), 3 * radius));
            const bool is_clockwise = part(random) < 0.5;  // in Z-X
            const double height = std::sqrt(of_arc * of_arc - chord.squaredNorm() / 4);
            const Vec2 left = Vec2{-chord.y(), chord.x()}.normalized();
            element.center =
                (element.from + element.to) / 2 + left * height * (is_clockwise ? -1 : 1);
            element.sweep = 2 * std::asin(chord.norm() / 2 / of_arc) * (is_clockwise ? -1 : 1);
            std::snprintf(text, sizeof text, "%s X%.3f Z%.3f %s%.3f\n", is_clockwise ? "G2" : "G3",
                          2 * element.to.y(), element.to.x(), "@", of_arc);
        }
        result.words += text;
        result.elements.push_back(element);
        at = element.to;
    }
    return result;
}

/// Places on the way of a command, in Z and X.
std::vector<Vec2> places_on(const Command& command, const Vec2& from) {
    constexpr int kPlaces = 40;
    const Vec2 to{command.motion().to[2], command.motion().to[0]};
    std::vector<Vec2> points;
    for (int i = 0; i <= kPlaces; ++i) {
        const double t = static_cast<double>(i) / kPlaces;
        if (command.op() != Op::Arc) {
            points.push_back(from + t * (to - from));
            continue;
        }
        const Vec2 center{command.motion().arc().center[2], command.motion().arc().center[0]};
        const bool is_left = command.motion().arc().normal.y() > 0;
        const double angle = t * command.motion().arc().sweep * (is_left ? 1 : -1);
        const Vec2 arm = from - center;
        points.push_back(center + Vec2{arm.x() * std::cos(angle) - arm.y() * std::sin(angle),
                                       arm.x() * std::sin(angle) + arm.y() * std::cos(angle)});
    }
    return points;
}

TEST(LatheCompensation, TheNoseTouchesTheContourAndNeverCutsIntoIt) {
    std::mt19937 random(20261122);
    for (int round = 0; round < 120; ++round) {
        const double radius = 0.4 + 0.4 * (round % 3);
        const int tip = 1 + round % 9;
        const Control& control = kControls[round % 2];
        const Part part = random_part(random, radius);
        std::string words = part.words;
        for (char& c : words) {
            if (c == '@') c = 'R';
        }
        if (round % 2 == 0) {
            for (std::size_t at = words.find('R'); at != std::string::npos;
                 at = words.find('R', at + 3))
                words.replace(at, 1, "CR=");
        }
        char text[160];
        std::snprintf(text, sizeof text, "G0 X%.3f Z%.3f\nG42 G1 X%.3f Z%.3f F100.\n", 60.0, 20.0,
                      2 * part.elements.front().from.y(), part.elements.front().from.x());
        const std::string program =
            std::string(control.start) + text + words + "G40 X90.\n" + control.end;
        SCOPED_TRACE(std::string(control.name) + " tip " + std::to_string(tip) + "\n" + program);
        const Ran ran = read(control.name, program, lathe(radius, tip));
        // A random contour may have a corner that is too narrow: the control says so.
        if (ran.alarmed) continue;
        // Where the centre of the nose is, seen from the tip: as the machine file tells of `tip`.
        constexpr double kZ[] = {0, -1, 1, 1, -1, -1, 0, 1, 0, 0};
        constexpr double kX[] = {0, -1, -1, 1, 1, 0, -1, 0, 1, 0};
        const Vec2 center = radius * Vec2{kZ[tip], kX[tip]};
        Vec2 from = Vec2::Zero();
        int number = 0;
        std::vector<const Command*> motions;
        for (const Command& command : ran.commands) {
            if (command.is_motion()) motions.push_back(&command);
        }
        ASSERT_GE(motions.size(), 4u);
        std::vector<bool> is_touched(part.elements.size());
        for (const Command* command : motions) {
            const bool is_on_contour = number > 1 && number + 1 < static_cast<int>(motions.size());
            for (const Vec2& point : places_on(*command, from)) {
                if (number == 0) break;
                double least = 1e9;
                for (std::size_t i = 0; i < part.elements.size(); ++i) {
                    const double apart = distance_to(part.elements[i], point + center);
                    least = std::min(least, apart);
                    if (apart <= radius + kTolerance) is_touched[i] = true;
                }
                // The ways to the contour and from it are straight, whatever lies beside them.
                if (!is_on_contour) continue;
                EXPECT_GE(least, radius - kTolerance) << "motion " << number;
                // SINUMERIK goes around corners, so the nose stays at the contour.
                if (round % 2 == 0) {
                    EXPECT_LE(least, radius + kTolerance) << "motion " << number;
                }
            }
            from = {command->motion().to[2], command->motion().to[0]};
            ++number;
        }
        for (std::size_t i = 0; i < is_touched.size(); ++i) {
            EXPECT_TRUE(is_touched[i]) << "element " << i;
        }
        if (HasFailure()) return;
    }
}

TEST(LatheCompensation, AToolWithoutATipIsWarnedOf) {
    const std::string text = "G0 X30 Z5\nG42 G1 X20 Z2 F100\nZ-10\nG40 X30\n";
    const Ran ran = read("sinumerik", kControls[0].start + text + "M30\n", lathe(1, 0));
    EXPECT_EQ(alarms(ran), "K5250");
    EXPECT_EQ(tips_of(ran), "30,5 22,2 22,-10 30,-10");
}

}  // namespace
}  // namespace kadr::interp::lathe_compensation_test
