// What the turning cycles of the library leave behind, over many sets of parameters: never into the
// finished contour and its allowance, nothing left above it but what a cut may leave, no cut deeper
// than its step, no rapid and no back of the tool in material; the same on every control.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/stdlib/cycle_run.h"
#include "tests/stdlib/profile.h"

namespace turning_test {

namespace {

using namespace stdlib_test;
using nlohmann::json;

constexpr double kCell = 0.02;   // mm
constexpr double kExact = 0.02;  // what cells and the points on arcs may do
constexpr int kSets = 24;        // parameter sets a cycle

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

/// Whether one block of the text makes several cuts.
bool has_native_cycle(const std::vector<json>& commands) {
    return std::ranges::adjacent_find(commands, [](const json& a, const json& b) {
               return a.at("op") == "line" && b.at("op") == "line" && a.at("iso") == b.at("iso");
           }) != commands.end();
}

/// dialect  whose control roughs; by moves if it has no cycle for it
void expect_roughed(const Roughing& r, const std::string& dialect = "iso") {
    const double away = r.view.side > 0 ? 10 : -3;
    const double radius = r.view.side * (r.view.is_facing ? r.rough_t : r.rough_h);
    const ProfilePoint start{tenth(radius + away), 60};
    const std::string text =
        program_text(contour_text(r.shape, r.view), call_of(r), start, "contour_turning");
    SCOPED_TRACE(text);
    const CycleRun run = run_text(text, dialect, "lathe");
    ASSERT_EQ(run.status, 0) << run.error;
    Profile part = rough_part(r);
    const bool is_native = dialect != "iso";
    EXPECT_EQ(has_native_cycle(run.commands), is_native);
    part.cut(run.commands, r.view, {r.nose, r.falling_deg, 0, is_native});
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

/// What a control's own cycle takes: a shape that only rises, cut along at last.
Roughing draw_native(Dice& dice, const ProfileView& view, const ProfilePoint& start,
                     double length) {
    Roughing r = draw_roughing(dice, view, start, length);
    while (r.falling_deg > 0 || !r.is_along) r = draw_roughing(dice, view, start, length);
    return r;
}

TEST(Turning, NativeRoughing) {
    Dice dice(27);
    const std::array dialects = {"fanuc-lathe", "fanuc-lathe-b", "fanuc-lathe-c"};
    for (int i = 0; i < sets(); ++i) {
        const std::string dialect = dialects[static_cast<std::size_t>(i / 4 % 3)];
        SCOPED_TRACE(dialect);
        const double length = dice.length(5, 40);
        const std::array<Roughing, 4> kinds = {
            draw_native(dice, {false, 1}, {dice.length(6, 20), 0}, length),
            draw_native(dice, {false, -1}, {-dice.length(35, 50), 0}, length),
            draw_native(dice, {true, 1}, {dice.length(-40, 0), length + 60}, length),
            draw_native(dice, {true, -1}, {dice.length(-40, 0), -dice.length(8, 20)}, length)};
        expect_roughed(kinds[static_cast<std::size_t>(i % 4)], dialect);
    }
}

/// What the control's cycle would do otherwise, or not at all.
TEST(Turning, WhatTheControlsCycleDoesNotTakeStaysMoves) {
    const std::string rising = "{ DIAMON; G1 X20 Z0; Z-20; X30 Z-30; Z-40; }";
    const std::string hollow = "{ DIAMON; G1 X20 Z0; Z-20; X16 Z-25; Z-30; X30; Z-40; }";
    const std::string rough = "turn_rough(shape, d: 40mm, step: 2mm";
    struct Case {
        std::string shape, call;
        bool is_native;
    };
    const std::vector<Case> cases = {
        {rising, rough + ")", true},
        {rising, "with shift(z: 1mm) { " + rough + "); }", true},
        {rising, rough + ", along: false)", false},
        {hollow, rough + ", falling: 45deg)", false},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.call);
        const CycleRun run =
            run_text(program_text(each.shape, each.call, {30, 60}, "contour_turning"),
                     "fanuc-lathe", "lathe");
        ASSERT_EQ(run.status, 0) << run.error;
        EXPECT_EQ(has_native_cycle(run.commands), each.is_native);
    }
}

/// Whether blocks are executed again that stand farther up in the text.
bool goes_back_in_text(const std::vector<json>& commands) {
    return std::ranges::adjacent_find(commands, [](const json& a, const json& b) {
               return b.at("iso") < a.at("iso");
           }) != commands.end();
}

/// Roughing and finishing, both by the control, along one shape; nothing stays on it. Returns
/// whether the finishing cut goes along the blocks of the roughing.
bool expect_finished_by_control(Roughing r) {
    r.allowance = r.nose = r.more_t = 0;
    r.rough_t = r.shape.start.t;
    const std::string call =
        call_of(r) + ";\n    turn_contour(shape" + (r.view.side < 0 ? ", where: inner)" : ")");
    const double highest = std::max(r.shape.highest(), r.rough_h);
    const ProfilePoint start{tenth(r.view.side * (highest + 4)), 60};
    const std::string text =
        program_text(contour_text(r.shape, r.view), call, start, "contour_turning");
    SCOPED_TRACE(text);
    const CycleRun run = run_text(text, "fanuc-lathe", "lathe");
    EXPECT_EQ(run.status, 0) << run.error;
    Profile part = rough_part(r);
    part.cut(run.commands, r.view, {0, 0, 0, true});
    expect_clean(part);
    EXPECT_NEAR(part.x(), start.h, 1e-6) << "the cycle ends where it began";
    const std::vector<double> kept = part.kept(r.shape, 0, 0, 0, 0);
    expect_between(part, kept, r.shape.end().t + 0.05, r.shape.start.t - 0.05, r.rough_h, 0);
    return goes_back_in_text(run.commands);
}

TEST(Turning, NativeFinishing) {
    Dice dice(28);
    int along_the_same_blocks = 0;
    for (int i = 0; i < sets() / 2; ++i) {
        const double side = i % 2 == 0 ? 1 : -1;
        const double h = side > 0 ? dice.length(6, 20) : -dice.length(35, 50);
        const Roughing r = draw_native(dice, {false, side}, {h, 0}, dice.length(5, 40));
        along_the_same_blocks += expect_finished_by_control(r) ? 1 : 0;
    }
    EXPECT_GT(along_the_same_blocks, sets() / 8);
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

// ---------------------------------------------------------------- cycles of SINUMERIK's calls

/// Roughing leaves its allowances; the whole cycle nothing on the contour.
void expect_removed(const Roughing& r, bool is_complete) {
    const int kind = (is_complete ? 9 : 1) + (r.view.is_facing ? 1 : 0) + (r.view.side < 0 ? 2 : 0);
    const std::string call =
        "stock_removal(shape, step: " + mm(r.step) + ", allowance: " + mm(r.allowance) +
        ", allowance_x: " + mm(r.view.is_facing ? r.more_t : r.more_h) +
        ", allowance_z: " + mm(r.view.is_facing ? r.more_h : r.more_t) +
        ", kind: " + json(kind + (r.is_along || is_complete ? 0 : 200)).dump() +
        ", tool_d: " + mm(2 * r.nose) + ")";
    const double radius = r.view.side * (r.view.is_facing ? r.rough_t : r.rough_h);
    const ProfilePoint start{tenth(radius + (r.view.side > 0 ? 10 : -3)), 60};
    const std::string text = program_text(contour_text(r.shape, r.view), call, start, "removal");
    SCOPED_TRACE(text);
    const CycleRun run = run_text(text, "iso", "lathe");
    ASSERT_EQ(run.status, 0) << run.error;
    Profile part = rough_part(r);
    part.cut(run.commands, r.view, {r.nose, 89, 0, true});
    expect_clean(part);
    if (r.nose == 0 && !is_complete) {
        EXPECT_LE(part.deepest_cut(), r.step + kExact);
    }
    const double allowance = is_complete ? 0 : r.allowance;
    const double more_h = is_complete ? 0 : r.more_h, more_t = is_complete ? 0 : r.more_t;
    const std::vector<double> kept = part.kept(r.shape, allowance, more_h, more_t, r.nose);
    const double t_low = r.shape.end().t + allowance + more_t + 2 * r.nose + 0.05;
    const double t_high = std::min(r.shape.start.t - allowance - r.nose, r.rough_t) - 0.05;
    expect_between(part, kept, t_low, t_high, r.rough_h, 0);
}

TEST(ControlTurning, StockRemoval) {
    Dice dice(26);
    for (int i = 0; i < sets(); ++i) {
        const bool is_facing = dice.coin(), is_outer = dice.coin();
        const double length = dice.length(5, 40);
        const double side = is_outer ? 1 : -1;
        const ProfilePoint start =
            is_facing
                ? ProfilePoint{dice.length(-40, 0), is_outer ? length + 60 : -dice.length(8, 20)}
                : ProfilePoint{is_outer ? dice.length(6, 20) : -dice.length(35, 50), 0};
        Roughing r = draw_roughing(dice, {is_facing, side}, start, length);
        // The rough part is as large as the contour.
        r.rough_h = r.shape.highest();
        r.rough_t = r.shape.start.t;
        const Profile part = rough_part(r);
        const std::vector<double> kept =
            part.kept(r.shape, r.allowance, r.more_h, r.more_t, r.nose);
        double low = r.rough_h;
        for (std::size_t k = 0; k < kept.size(); ++k) {
            const double t = part.place(k);
            if (t < r.shape.start.t - r.allowance - r.nose - 0.1 && t > r.shape.end().t + 0.1)
                low = std::min(low, kept[k]);
        }
        if (low > r.rough_h - 0.5) continue;  // there is nothing to be roughed
        // Across, the contour is finished outwards, with the other edge of the tool.
        expect_removed(r, dice.coin() && !is_facing);
    }
}

/// A groove with flanks, both edges and the ground sharp.
TEST(ControlTurning, Groove) {
    Dice dice(35);
    for (int i = 0; i < sets(); ++i) {
        const double tool_w = dice.length(1, 5), deep = dice.length(0.5, 8);
        const double allowance = dice.coin() ? 0 : 0.1;
        const double w = tenth(tool_w + 2 * allowance + (dice.coin() ? 0 : dice.length(0, 12)));
        const double d = dice.length(25, 60), step = dice.coin() ? 0 : dice.length(0.5, 3);
        const int flank = 5 * dice.number(0, 8), flank_end = 5 * dice.number(0, 8);
        const bool is_left = dice.coin();
        const double along = std::tan(flank * std::numbers::pi / 180);
        const double along_end = std::tan(flank_end * std::numbers::pi / 180);
        const double wide = w + deep * (along + along_end);
        const double z = is_left ? -wide - 3 : -3;
        const std::string call =
            "groove_cut(d: " + mm(d) + ", z: " + mm(z) + ", w: " + mm(w) + ", deep: " + mm(deep) +
            ", flank: " + json(flank).dump() + "deg, flank_end: " + json(flank_end).dump() +
            "deg, allowance: " + mm(allowance) + ", allowance_wall: " + mm(allowance) +
            ", step: " + mm(step) + ", kind: " + (is_left ? "1" : "5") + ", tool_d: " + mm(tool_w) +
            ")";
        const ProfilePoint start{d / 2 + 10, 60};
        const std::string text = program_text("", call, start, "grooves");
        SCOPED_TRACE(text);
        const CycleRun run = run_text(text, "iso", "lathe");
        ASSERT_EQ(run.status, 0) << run.error;
        Profile part(-wide - 20, 30, kCell);
        part.fill(-1e9, 0, d / 2);
        part.cut(run.commands, {false, 1}, {0, 0, tool_w});
        expect_clean(part);
        const double left = is_left ? std::round(1000 * z) / 1000 : z - wide;
        const double left_along = is_left ? along : along_end;
        const double right_along = is_left ? along_end : along;
        const auto wanted = [&](double t) {
            const double from_left = t - left, from_right = left + wide - t;
            if (from_left < 0 || from_right < 0) return d / 2;
            const double left_depth = left_along > 0 ? from_left / left_along : deep;
            const double right_depth = right_along > 0 ? from_right / right_along : deep;
            return d / 2 - std::min({deep, left_depth, right_depth});
        };
        for (std::size_t k = 0; k < part.heights().size(); ++k) {
            const double t = part.place(k);
            if (t < left - 10 || t > -0.1) continue;
            const std::initializer_list<double> near = {wanted(t - 1.5 * kCell), wanted(t),
                                                        wanted(t + 1.5 * kCell)};
            ASSERT_GT(part.heights()[k], std::min(near) - kExact) << "cut into it at " << t;
            ASSERT_LT(part.heights()[k], std::max(near) + kExact) << "left at " << t;
        }
    }
}

// ---------------------------------------------------------------- cycles of cycles.turning

/// The part after a call from the diameter 2·start.h, at Z 60; the tool comes back there.
Profile turned(Profile part, const std::string& call, const ProfilePoint& start,
               const ProfileView& view, const TurningTool& tool) {
    const std::string text = program_text("", call, start, "turning");
    SCOPED_TRACE(text);
    const CycleRun run = run_text(text, "iso", "lathe");
    EXPECT_EQ(run.status, 0) << run.error;
    part.cut(run.commands, view, tool);
    expect_clean(part);
    EXPECT_NEAR(part.x(), start.h, 1e-6) << "the cycle ends where it began";
    return part;
}

/// Heights between two places, all within `kExact` of what they should be.
template <typename Wanted>
void expect_heights(const Profile& part, double t_low, double t_high, const Wanted& wanted) {
    for (std::size_t i = 0; i < part.heights().size(); ++i) {
        const double t = part.place(i);
        if (t < t_low + kCell || t > t_high - kCell) continue;
        ASSERT_NEAR(part.heights()[i], wanted(t), kExact) << "at " << t;
    }
}

TEST(Turning, Face) {
    Dice dice(31);
    for (int i = 0; i < sets(); ++i) {
        const double d = dice.length(5, 80), to = dice.length(-5, 5);
        const double top = to + dice.length(0.1, 6), step = dice.length(0.2, 3);
        const ProfilePoint start{tenth(d / 2 + dice.length(2, 20)), 60};
        const std::string call = "turn_face(d: " + mm(d) + ", to: " + mm(to) + ", top: " + mm(top) +
                                 ", step: " + mm(step) + ")";
        SCOPED_TRACE(call);
        Profile part(-5, d / 2 + 30, kCell);
        part.fill(-1e9, d / 2, top);
        part = turned(part, call, start, {true, 1}, {});
        EXPECT_LE(part.deepest_cut(), step + kExact);
        expect_heights(part, -0.8, d / 2, [&](double) { return to; });
    }
}

TEST(Turning, FinishAlongPoints) {
    Dice dice(32);
    for (int i = 0; i < sets(); ++i) {
        ProfileShape shape{{dice.length(6, 15), dice.length(-3, 3)}, {}};
        ProfilePoint here = shape.start;
        const double chamfer = dice.coin() ? 0 : dice.length(0.2, 2);
        std::string points = "{" + mm(2 * here.h) + ", " + mm(here.t) + "}";
        for (int k = dice.number(1, 6); k >= 0; --k) {
            const bool is_first = chamfer > 0 && here.t == shape.start.t && here.h == shape.start.h;
            // There is room for the chamfer, on a cylinder or on a taper.
            here.h = tenth(here.h + (dice.coin() ? 0 : dice.length(0, is_first ? 4 : 8)));
            here.t = tenth(here.t - (is_first ? 7 : dice.length(0, 20)));
            points += ", {" + mm(2 * here.h) + ", " + mm(here.t) + "}";
            shape.elements.push_back({here});
        }
        if (chamfer > 0) {
            // It falls at 45 degrees from the face and ends where it meets the first element.
            const ProfilePoint edge = shape.start, to = shape.elements[0].to;
            const double share = chamfer / (edge.t - to.t - (to.h - edge.h));
            shape.start.h -= chamfer;
            shape.elements.insert(
                shape.elements.begin(),
                {.to = {edge.h + share * (to.h - edge.h), edge.t + share * (to.t - edge.t)}});
        }
        const ProfilePoint start{tenth(here.h + dice.length(2, 20)), 60};
        const std::string call = "turn_finish({" + points + "}, chamfer: " + mm(chamfer) + ")";
        SCOPED_TRACE(call);
        Profile part(here.t - 20, 40, kCell);
        const std::vector<double> kept = part.kept(shape, 0, 0, 0, 0);
        const std::vector<double> rough = part.kept(shape, 0.5, 0, 0, 0);
        for (std::size_t c = 0; c < rough.size(); ++c)
            part.fill(part.place(c) - kCell / 2, part.place(c) + kCell / 2,
                      std::min(rough[c], here.h + 0.5));
        part = turned(part, call, start, {false, 1}, {});
        expect_between(part, kept, here.t + 0.05, shape.start.t - 0.05, here.h + 0.5, 0);
    }
}

TEST(Turning, Groove) {
    Dice dice(33);
    for (int i = 0; i < sets(); ++i) {
        const double tool_w = dice.length(1, 5);
        const double w = tenth(tool_w * (dice.coin() ? 1 : 1 + dice.length(0, 4)));
        const double d = dice.length(20, 60), to = dice.length(5, d - 1);
        const double z = -w - dice.length(1, 20);
        const double allowance =
            dice.coin() ? 0 : std::min({0.2, (w - tool_w) / 2, (d - to) / 2 - 0.1});
        const double step = dice.length(0.2, 4);
        const bool is_stepped = dice.coin();
        const ProfilePoint start{tenth(d / 2 + dice.length(1, 20)), 60};
        const std::string call = "turn_groove(d: " + mm(d) + ", to: " + mm(to) + ", z: " + mm(z) +
                                 ", w: " + mm(w) + ", tool_w: " + mm(tool_w) +
                                 ", allowance: " + mm(allowance) +
                                 (is_stepped ? ", step: " + mm(step) : "") + ")";
        SCOPED_TRACE(call);
        Profile part(z - 20, 30, kCell);
        part.fill(-1e9, 0, d / 2);
        part = turned(part, call, start, {false, 1}, {0, 0, tool_w});
        if (is_stepped && allowance == 0) {
            EXPECT_LE(part.deepest_cut(), step + kExact);
        }
        expect_heights(part, z, z + w, [&](double) { return to / 2; });
        expect_heights(part, z - 19, z, [&](double) { return d / 2; });
        expect_heights(part, z + w, 0, [&](double) { return d / 2; });
    }
}

TEST(Turning, PartingOff) {
    Dice dice(34);
    for (int i = 0; i < sets(); ++i) {
        const double tool_w = dice.length(1, 5), d = dice.length(10, 60), z = -dice.length(5, 40);
        const double to = dice.coin() ? -0.4 : dice.length(0, d / 2);
        const double room = (d - std::max(to, 0.0)) / 2;
        const double chamfer = dice.coin() ? 0 : std::floor(dice.length(1, 8) * room) / 10;
        const ProfilePoint start{tenth(d / 2 + dice.length(1, 20)), 60};
        const std::string call = "part_off(d: " + mm(d) + ", z: " + mm(z) +
                                 ", tool_w: " + mm(tool_w) + ", to: " + mm(to) +
                                 ", chamfer: " + mm(chamfer) +
                                 (dice.coin() ? ", slow: 0.05mm/rev" : "") + ")";
        SCOPED_TRACE(call);
        Profile part(z - 20, 30, kCell);
        part.fill(-1e9, 0, d / 2);
        part = turned(part, call, start, {false, 1}, {0, 0, tool_w});
        expect_heights(part, z - tool_w, z, [&](double) { return to / 2; });
        expect_heights(part, z, 0,
                       [&](double t) { return d / 2 - std::max(0.0, chamfer - (t - z)); });
        expect_heights(part, z - 19, z - tool_w, [&](double) { return d / 2; });
    }
}

/// Behind its last point the bar stays, with the allowance before its face.
TEST(Turning, TheShoulderBehindTheContourStays) {
    for (const double nose : {0.0, 0.4, 0.8}) {
        for (const bool is_inner : {false, true}) {
            const std::string call = "face_rough(shape, d: " + std::string(is_inner ? "20" : "40") +
                                     "mm, step: 6mm, allowance: 0.3mm, nose: " + mm(nose) +
                                     (is_inner ? ", where: inner" : "") + ")";
            const std::string text = program_text(
                is_inner ? "{ DIAMON; G1 X60 Z0; X30; Z-25; }" : "{ DIAMON; G1 X0 Z0; X30; Z-25; }",
                call, {is_inner ? 4.0 : 45.0, 60}, "contour_turning");
            SCOPED_TRACE(text);
            const CycleRun run = run_text(text, "iso", "lathe");
            ASSERT_EQ(run.status, 0) << run.error;
            double lowest = 0;
            for (const json& command : run.commands) {
                if (command.contains("to"))
                    lowest = std::min(lowest, command["to"]["Z"].get<double>());
            }
            EXPECT_NEAR(lowest, -24.7, 1e-6);
        }
    }
}

TEST(Turning, PartingIsSlowFromItsDiameterOn) {
    struct Row {
        const char* arguments;
        double fast_to;  // diameter
    };
    for (const Row& row : {Row{"slow_at: 10mm", 10},
                           {"slow_at: 40mm", 40},
                           {"slow_at: 41mm", 41},
                           {"slow_at: 10mm, chamfer: 1mm", 10},
                           {"slow_at: 40mm, chamfer: 1mm", 40},
                           {"slow_at: 38mm, chamfer: 1mm", 38},
                           {"slow_at: 0mm", 0}}) {
        SCOPED_TRACE(row.arguments);
        const CycleRun run =
            run_text(program_text("",
                                  std::string("part_off(d: 40mm, z: -20mm, tool_w: 3mm, slow: "
                                              "0.04mm/rev, ") +
                                      row.arguments + ")",
                                  {30, 60}, "turning"),
                     "iso", "lathe");
        ASSERT_EQ(run.status, 0) << run.error;
        int cuts = 0;
        for (const json& command : run.commands) {
            if (command["op"] != "line") continue;
            ++cuts;
            const bool is_slow = 2 * command["to"]["X"].get<double>() < row.fast_to - 1e-6;
            EXPECT_NEAR(command["feed"].get<double>(), is_slow ? 0.04 : 0.2, 1e-9) << command;
        }
        EXPECT_GE(cuts, 1);
    }
}

// ---------------------------------------------------------------- what is refused, and everywhere

TEST(Turning, WrongParametersAreRefused) {
    const struct {
        const char* contour;
        const char* call;
        const char* message;
    } rows[] = {
        {"{ DIAMOF; G1 X10 Z0; Z-10; }", "turn_rough(shape, d: 40mm, step: 2mm)",
         "begins with DIAMON"},
        {"{ DIAMON; G1 X10 Z0; }", "turn_rough(shape, d: 40mm, step: 2mm)", "begins with DIAMON"},
        {"{ DIAMON; G1 X10 Z0; Z-10; X20 Z-8; }", "turn_rough(shape, d: 40mm, step: 2mm)",
         "shape[1] turns back in Z"},
        {"{ DIAMON; G1 X20 Z0; Z-10; G3 X20 Z-14 CR=-3; }",
         "turn_rough(shape, d: 40mm, step: 2mm, falling: 80deg)", "shape[1] turns back in Z"},
        {"{ DIAMON; G1 X20 Z0; Z-10; X18 Z-12; X30; }", "turn_rough(shape, d: 40mm, step: 2mm)",
         "shape[1] falls at 26.6 deg; the tool goes down at 0.0 deg (`falling`)"},
        {"{ DIAMON; G1 X20 Z0; Z-10; G2 X20 Z-14 CR=4; }",
         "turn_rough(shape, d: 40mm, step: 2mm, falling: 20deg)", "shape[1] falls at 30.0 deg"},
        {"{ DIAMON; G1 X20 Z0; Z-10; X18; Z-20; }",
         "turn_rough(shape, d: 40mm, step: 2mm, falling: 80deg)", "shape[1] falls at 90.0 deg"},
        // A quarter circle whose ends a drawing has rounded.
        {"{ DIAMON; G1 X20 Z0; Z-10; G2 X24.667 Z-12.333 CR=2.333; G1 X40; }",
         "turn_rough(shape, d: 40mm, step: 3mm, allowance: 0.3mm, nose: 0.4mm)", ""},
        {"{ DIAMON; G1 X15.333 Z0; G3 X20 Z-2.333 CR=2.333; G1 Z-10; X40; }",
         "face_rough(shape, d: 40mm, step: 3mm)", ""},
        {"{ DIAMON; G1 X15.333 Z0; G3 X20 Z-2.333 CR=2.333; G1 Z-10; X40; }",
         "turn_contour(shape, nose: 0.4mm)", ""},
        {"{ DIAMON; G1 X20 Z0; Z-10; G2 X24.667 Z-12.31 CR=2.333; G1 X40; }",
         "turn_rough(shape, d: 40mm, step: 3mm)", ""},
        {"{ DIAMON; G1 X20 Z0; X40 Z-1; X50; }", "face_rough(shape, d: 60mm, step: 2mm, top: 1mm)",
         ""},
        {"{ DIAMON; G1 X0 Z-2; X20; X10 Z-4; X50; }",
         "face_rough(shape, d: 60mm, step: 2mm, top: 1mm)", "shape[1] turns back in X"},
        {"{ DIAMON; G1 X0 Z-2; X20; X30 Z-1; X50; }",
         "face_rough(shape, d: 60mm, step: 2mm, top: 1mm)", "shape[1] falls at 11.3 deg"},
        {"{ DIAMON; G1 X20 Z0; Z-10; }", "turn_rough(shape, d: 40mm, step: 0mm)",
         "the cut must be deeper than 0"},
        {"{ DIAMON; G1 X20 Z0; Z-10; }", "turn_rough(shape, d: 40mm, step: 1um)",
         "cuts of 0.001 mm are more than 1000"},
        {"{ DIAMON; G1 X20 Z0; Z-10; }", "turn_rough(shape, d: 20mm, step: 2mm)",
         "nothing is to be roughed"},
        {"{ DIAMON; G1 X20 Z0; Z-10; }", "turn_rough(shape, d: 40mm, step: 2mm, allowance: -1mm)",
         "are not negative"},
        {"{ DIAMON; G1 X20 Z0; Z-10; }", "turn_rough(shape, d: 40mm, step: 2mm, clear: 0mm)",
         "are no distances"},
        {"{ DIAMON; G1 X20 Z0; Z-10; }", "turn_rough(shape, d: 40mm, step: 2mm, falling: 90deg)",
         "a tool cannot fall at 90 deg"},
        {"{ DIAMON; G1 X20 Z0; Z-10; }", "turn_rough(shape, d: 88mm, step: 2mm)",
         "the tool starts at diameter 90 mm; outside the part is 92 mm and more"},
        {"{ DIAMON; G1 X60 Z0; Z-10; }", "turn_rough(shape, d: 40mm, step: 2mm, where: inner)",
         "the tool starts at diameter 90 mm; free is the bore to 36 mm"},
        {"{ DIAMON; G1 X20 Z0; Z-10; X16 Z-14; X30; }",
         "turn_rough(shape, d: 40mm, step: 2mm, falling: 45deg, allowance_z: 0.1mm)",
         "an allowance along Z would cut into the walls of hollows"},
        {"{ DIAMON; G1 X20 Z0; X88 Z-10; }", "turn_contour(shape)",
         "the tool starts at diameter 90 mm; outside the part is 92 mm and more"},
        {"{ DIAMON; G1 X20 Z0; X88 Z-10; }", "turn_contour(shape, nose: -1mm)",
         "are no radius and no allowance"},
        {"{ DIAMON; G1 X60 Z0; X30 Z-10; }", "turn_contour(shape, where: inner)",
         "free is the bore to 26 mm"},
    };
    for (const auto& row : rows) {
        const std::string text = program_text(row.contour, row.call, {45, 60}, "contour_turning");
        SCOPED_TRACE(text);
        const CycleRun run = run_text(text, "iso", "lathe");
        EXPECT_EQ(run.status, std::string(row.message).empty() ? 0 : 1) << run.error;
        EXPECT_NE(run.error.find(row.message), std::string::npos) << run.error;
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

}  // namespace turning_test
