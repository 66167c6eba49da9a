// What the turning cycles of the library leave behind, over many sets of parameters: never into the
// finished contour and its allowance, nothing left above it but what a cut may leave, no cut deeper
// than its step, no rapid and no back of the tool in material; the same on every control.
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/stdlib/cycle_run.h"
#include "tests/stdlib/profile.h"

namespace {

using namespace stdlib_test;
using nlohmann::json;

constexpr double kCell = 0.02;   // mm
constexpr double kExact = 0.02;  // what cells and the points on arcs may do
constexpr int kSets = 40;        // parameter sets a cycle

/// KADR_SETS=1000 looks longer.
int sets() {
    const char* wanted = std::getenv("KADR_SETS");
    return wanted == nullptr ? kSets : std::atoi(wanted);
}

double tenth(double value) { return std::round(value * 10) / 10; }

/// A shape that runs down from t, as deep as is asked for, with hollows as steep as the tool.
ProfileShape draw_shape(Dice& dice, const ProfilePoint& start, double length, double falling_deg) {
    ProfileShape shape{start, {}};
    ProfilePoint here = start;
    const double slope = std::tan(falling_deg * std::numbers::pi / 180);
    const auto to = [&](double dh, double dt, double radius = 0, bool is_left = false) {
        here = {tenth(here.h + dh), tenth(here.t - dt)};
        shape.elements.push_back({here, radius, is_left});
    };
    while (start.t - here.t < length) {
        switch (dice.number(0, falling_deg > 0 ? 7 : 4)) {
            case 0: to(0, dice.length(0.5, 12)); break;
            case 1: to(dice.length(0.1, 6), dice.length(0.1, 10)); break;
            case 2: to(dice.length(0.1, 4), 0); break;
            case 3: {
                const double r = dice.length(0.2, 5);
                to(r, r, r, true);
                break;
            }
            case 4: {
                const double r = dice.length(0.2, 5);
                to(r, r, r, false);
                break;
            }
            case 5: {
                const double deep = dice.length(0.2, 3);
                to(-deep, std::ceil(10 * deep / slope) / 10);
                to(0, dice.length(0.3, 8));
                to(dice.length(0.1, 4), dice.coin() ? 0 : dice.length(0.1, 5));
                break;
            }
            default: {
                const double r = dice.length(4, 20);
                const double wide = 2 * r * std::sin(falling_deg * std::numbers::pi / 180);
                const double w = std::floor(dice.length(0.3, 1) * wide * 10) / 10;
                if (w >= 0.2) to(0, w, r, dice.coin());
            }
        }
    }
    if (here.t == start.t) to(0, 1);
    return shape;
}

/// The shape as a contour of a program, from the face towards the chuck.
std::string contour_text(const ProfileShape& shape, const ProfileView& view) {
    const auto point_text = [&](const ProfilePoint& p) {
        const double x = 2 * view.side * (view.is_facing ? p.t : p.h);
        return "X=" + mm(x) + " Z=" + mm(view.is_facing ? p.h : p.t);
    };
    std::vector<ProfilePoint> points = {shape.start};
    for (const ProfileElement& element : shape.elements) points.push_back(element.to);
    std::vector<ProfileElement> elements = shape.elements;
    if (view.is_facing) {
        std::reverse(points.begin(), points.end());
        std::reverse(elements.begin(), elements.end());
    }
    std::string text = "{ DIAMON; G1 " + point_text(points[0]) + "; ";
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const ProfileElement& element = elements[i];
        // In a bore all turns the other way; swapped axes and the way back make up for each other.
        const bool is_left = element.is_left == (view.side > 0);
        if (element.radius == 0) text += "G1 ";
        else text += (is_left ? "G3 CR=" : "G2 CR=") + mm(element.radius) + " ";
        text += point_text(points[i + 1]) + "; ";
    }
    return text + "}";
}

std::string program_text(const std::string& contour, const std::string& call,
                         const ProfilePoint& start, const std::string& module) {
    return "import cycles." + module +
           ";\nprogram test() {\n    G18 G95 F0.2; tool(1); S800 M3;\n    G0 X=" + mm(2 * start.h) +
           " Z=" + mm(start.t) + ";\n" +
           (contour.empty() ? "" : "    contour shape = " + contour + ";\n") + "    " + call +
           ";\n    M30;\n}\n";
}

/// A part that is roughed: along the axis or across it, outside or in a bore.
struct Roughing {
    ProfileShape shape;
    ProfileView view;
    double rough_h = 0, rough_t = 0, step = 1;
    double allowance = 0, more_h = 0, more_t = 0, nose = 0, falling_deg = 0;
    bool is_along = true;
};

std::string call_of(const Roughing& r) {
    const bool facing = r.view.is_facing;
    const double d = 2 * r.view.side * (facing ? r.rough_t : r.rough_h);
    return std::string(facing ? "face_rough" : "turn_rough") + "(shape, d: " + mm(d) +
           ", step: " + mm(r.step) + ", allowance: " + mm(r.allowance) +
           ", allowance_x: " + mm(facing ? r.more_t : r.more_h) +
           ", allowance_z: " + mm(facing ? r.more_h : r.more_t) +
           ", top: " + mm(facing ? r.rough_h : r.rough_t) +
           (r.view.side < 0 ? ", where: inner" : "") + ", falling: " + json(r.falling_deg).dump() +
           "deg, nose: " + mm(r.nose) + (r.is_along ? "" : ", along: false") + ")";
}

Profile rough_part(const Roughing& r) {
    Profile part(r.shape.end().t - 20, std::max(r.rough_t, r.shape.start.t) + 30, kCell);
    part.fill(-1e9, r.rough_t, r.rough_h);
    return part;
}

void expect_clean(const Profile& part) {
    for (const std::string& fault : part.faults()) ADD_FAILURE() << fault;
}

/// Nothing of what must stay is gone, and no more than `rest` is left on it.
void expect_between(const Profile& part, const std::vector<double>& kept, double t_low,
                    double t_high, double rough_h, double rest) {
    const std::vector<double>& heights = part.heights();
    for (std::size_t i = 1; i + 1 < heights.size(); ++i) {
        const double t = part.place(i);
        const double low = std::min({kept[i - 1], kept[i], kept[i + 1]});
        const double high = std::max({kept[i - 1], kept[i], kept[i + 1]});
        if (t < t_high && heights[i] < std::min(low, rough_h) - kExact) {
            ADD_FAILURE() << "cut into what stays at " << t << ": " << heights[i] << " instead of "
                          << low;
            return;
        }
        if (t > t_low && t < t_high && heights[i] > std::min(high + rest, rough_h) + kExact) {
            ADD_FAILURE() << "left at " << t << ": " << heights[i] << " instead of " << high;
            return;
        }
    }
}

void expect_roughed(const Roughing& r) {
    const double away = r.view.side > 0 ? 10 : -3;
    const double radius = r.view.side * (r.view.is_facing ? r.rough_t : r.rough_h);
    const ProfilePoint start{tenth(radius + away), 60};
    const std::string text =
        program_text(contour_text(r.shape, r.view), call_of(r), start, "contour_turning");
    SCOPED_TRACE(text);
    const CycleRun run = run_text(text, "iso", "lathe");
    ASSERT_EQ(run.status, 0) << run.error;
    Profile part = rough_part(r);
    part.cut(run.commands, r.view, {r.nose, r.falling_deg});
    expect_clean(part);
    EXPECT_NEAR(part.x(), start.h, 1e-6) << "the cycle ends where it began";
    // A nose leaves its own shape at the walls, which the cut along the contour takes.
    if (r.nose == 0) {
        EXPECT_LE(part.deepest_cut(), r.step + kExact);
    }
    const std::vector<double> kept = part.kept(r.shape, r.allowance, r.more_h, r.more_t, r.nose);
    const double t_low = r.shape.end().t + r.allowance + r.more_t + 2 * r.nose + 0.05;
    const double t_high = std::min(r.shape.start.t - r.allowance - r.nose, r.rough_t) - 0.05;
    const double rest = r.is_along ? 0 : r.step + r.nose;
    expect_between(part, kept, t_low, t_high, r.rough_h, rest);
}

/// Parameters of all kinds; a shape that begins at `start` and is `length` long.
Roughing draw_roughing(Dice& dice, const ProfileView& view, const ProfilePoint& start,
                       double length) {
    Roughing r;
    r.view = view;
    r.falling_deg = dice.coin() ? 0 : dice.length(5, 50);
    do {
        r.shape = draw_shape(dice, start, length, r.falling_deg);
    } while (r.shape.lowest() < start.h - 5 || r.shape.highest() > start.h + 25);
    r.step = dice.length(0.4, 4);
    r.allowance = dice.coin() ? 0 : dice.length(0.1, 0.6);
    r.more_h = dice.coin() ? 0 : dice.length(0.1, 0.5);
    r.more_t = dice.coin() || r.falling_deg > 0 ? 0 : dice.length(0.1, 0.4);
    r.nose = dice.number(0, 2) > 0 ? 0 : 0.4 * dice.number(1, 3);
    r.is_along = dice.number(0, 3) > 0;
    r.rough_h = tenth(r.shape.highest() + dice.length(-4, 4));
    r.rough_t = tenth(r.shape.start.t + (dice.coin() ? 0 : dice.length(0, 2)));
    // At least a little is to be roughed.
    const Profile part = rough_part(r);
    const std::vector<double> kept = part.kept(r.shape, r.allowance, r.more_h, r.more_t, r.nose);
    double low = r.shape.highest() + 5;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const double t = part.place(i);
        if (t < r.rough_t && t < r.shape.start.t - r.allowance - r.nose)
            low = std::min(low, kept[i]);
    }
    r.rough_h = std::max(r.rough_h, tenth(low + r.nose) + 0.3);
    return r;
}

std::vector<json> motion_of(const std::vector<json>& commands) {
    std::vector<json> motion;
    for (const json& command : commands) {
        if (!command.contains("to")) continue;
        // A control may name the place once more.
        if (!motion.empty() && motion.back()["to"] == command["to"]) continue;
        motion.push_back(command);
    }
    return motion;
}

void expect_same_motion(const std::vector<json>& a, const std::vector<json>& b) {
    const std::vector<json> first = motion_of(a), second = motion_of(b);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i]["op"], second[i]["op"]) << first[i] << second[i];
        for (const char* axis : {"X", "Z"}) {
            EXPECT_NEAR(first[i]["to"][axis].get<double>(), second[i]["to"][axis].get<double>(),
                        0.0011)
                << first[i] << second[i];
        }
    }
}

/// The finishing cut leaves the contour and its allowance, but where the nose does not reach.
void expect_finished(const Roughing& r) {
    const double highest = r.shape.highest() + r.allowance;
    const ProfilePoint start{tenth(r.view.side * (highest + 3)), 60};
    const std::string call = "turn_contour(shape, allowance: " + mm(r.allowance) +
                             ", nose: " + mm(r.nose) + (r.view.side < 0 ? ", where: inner" : "") +
                             ", falling: " + json(r.falling_deg).dump() + "deg)";
    const std::string text =
        program_text(contour_text(r.shape, r.view), call, start, "contour_turning");
    SCOPED_TRACE(text);
    const CycleRun run = run_text(text, "iso", "lathe");
    ASSERT_EQ(run.status, 0) << run.error;
    Profile part(r.shape.end().t - 20, r.shape.start.t + 30, kCell);
    const std::vector<double> kept = part.kept(r.shape, r.allowance, 0, 0, r.nose);
    const std::vector<double> rough = part.kept(r.shape, r.allowance + 0.5, 0, 0, r.nose);
    // As roughing has left it: half a millimetre more.
    for (std::size_t i = 0; i < rough.size(); ++i) {
        const double t = part.place(i);
        const double half = part.cell() / 2;
        part.fill(t - half, t + half, std::min(rough[i], highest + 1));
    }
    part.cut(run.commands, r.view, {r.nose, r.falling_deg});
    expect_clean(part);
    EXPECT_NEAR(part.x(), start.h, 1e-6) << "the cycle ends where it began";
    const double t_low = r.shape.end().t + r.allowance + 2 * r.nose + 0.05;
    const double t_high = r.shape.start.t - r.allowance - r.nose - 0.05;
    expect_between(part, kept, t_low, t_high, highest + 1, 0);
}

TEST(Turning, RoughingOutside) {
    Dice dice(21);
    for (int i = 0; i < sets(); ++i)
        expect_roughed(
            draw_roughing(dice, {false, 1}, {dice.length(6, 20), 0}, dice.length(5, 50)));
}

TEST(Turning, RoughingInside) {
    Dice dice(22);
    for (int i = 0; i < sets(); ++i) {
        Roughing r =
            draw_roughing(dice, {false, -1}, {-dice.length(35, 50), 0}, dice.length(5, 50));
        expect_roughed(r);
    }
}

TEST(Turning, RoughingAcross) {
    Dice dice(23);
    for (int i = 0; i < sets(); ++i) {
        const double length = dice.length(5, 40);
        expect_roughed(draw_roughing(dice, {true, 1}, {dice.length(-40, 0), length + 60}, length));
    }
}

TEST(Turning, RoughingFromABoreOutwards) {
    Dice dice(24);
    for (int i = 0; i < sets(); ++i) {
        expect_roughed(draw_roughing(dice, {true, -1}, {dice.length(-40, 0), -dice.length(8, 20)},
                                     dice.length(5, 40)));
    }
}

TEST(Turning, Finishing) {
    Dice dice(25);
    for (int i = 0; i < sets(); ++i) {
        const bool is_outer = dice.coin();
        const double h = is_outer ? dice.length(6, 20) : -dice.length(35, 50);
        expect_finished(
            draw_roughing(dice, {false, is_outer ? 1.0 : -1.0}, {h, 0}, dice.length(5, 50)));
    }
}

/// One source, every control: what differs is what three decimals round.
TEST(Turning, SameOnEveryControl) {
    Dice dice(26);
    for (int i = 0; i < std::max(4, sets() / 8); ++i) {
        Roughing r = draw_roughing(dice, {i % 2 == 1, 1}, {i % 2 == 1 ? -20.0 : 12.0, 60}, 40);
        r.falling_deg = std::max(r.falling_deg, 1.0);
        const std::string text =
            program_text(contour_text(r.shape, r.view), call_of(r),
                         {tenth(std::max(r.rough_h, r.rough_t) + 10), 80}, "contour_turning");
        SCOPED_TRACE(text);
        const CycleRun reference = run_text(text, "sinumerik", "lathe");
        ASSERT_EQ(reference.status, 0) << reference.error;
        for (const char* dialect : {"fanuc", "axioma"}) {
            SCOPED_TRACE(dialect);
            const CycleRun run = run_text(text, dialect, "lathe");
            ASSERT_EQ(run.status, 0) << run.error;
            expect_same_motion(reference.commands, run.commands);
        }
    }
}

}  // namespace
