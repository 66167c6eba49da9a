// The turning cycles that the controls call, over many sets of parameters: undercuts keep to the
// outline of their standard, roughing leaves the shape with its allowances, strokes are as deep as
// they may be, and single cuts go the way that they say and back.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/stdlib/cycle_run.h"
#include "tests/stdlib/profile.h"

namespace lathe_cycles_test {

namespace {

using namespace stdlib_test;
using nlohmann::json;

constexpr int kSets = 16;        // parameter sets a cycle
constexpr double kCell = 0.02;   // mm
constexpr double kExact = 2e-6;  // mm: what the number format of the common core rounds
constexpr double kRound = 2e-3;  // mm: chords instead of arcs

std::string program_of(const std::string& module, const std::string& call, double x, double z) {
    return "import cycles." + module +
           ";\nprogram test() {\n    G18 G95 F0.2; tool(1); S800 M3;\n    G0 X=" + mm(2 * x) +
           " Z=" + mm(z) + ";\n    " + call + ";\n    M30;\n}\n";
}

/// The commands of the call alone, from the place (x, z) on, x on the radius.
std::vector<json> commands_from(const std::string& module, const std::string& call, double x,
                                double z) {
    const CycleRun run = run_text(program_of(module, call, x, z), "iso", "lathe");
    EXPECT_EQ(run.status, 0) << call << '\n' << run.error;
    std::vector<json> moves;
    for (const json& command : run.commands) {
        if (command.contains("to")) moves.push_back(command);
    }
    return moves;
}

double x_of(const json& command) { return command.at("to").at("X"); }
double z_of(const json& command) { return command.at("to").at("Z"); }
bool is_rapid(const json& command) { return command.at("op") == "rapid"; }

// ---------------------------------------------------------------- undercuts

/// An outline in a view: heights down into the part, the way from the shoulder (0) to the right.
struct Undercut {
    double deep, radius, length, slope_deg, into;

    std::vector<ProfilePoint> outline() const {
        const double slope = slope_deg * std::numbers::pi / 180;
        const double out = into > 0 ? 8 * std::numbers::pi / 180 : 0;
        std::vector<ProfilePoint> points = {
            {0, length + 5}, {0, length}, {-deep, length - deep / std::tan(slope)}};
        const ProfilePoint center{radius - deep, radius - into};
        for (int i = 0; i <= 400; ++i) {
            const double angle = -std::numbers::pi / 2 - (std::numbers::pi / 2 + out) * i / 400;
            points.push_back(
                {center.h + radius * std::sin(angle), center.t + radius * std::cos(angle)});
        }
        if (into > 0) points.push_back({points.back().h - points.back().t / std::tan(out), 0});
        points.push_back({10, 0});
        return points;
    }
};

double distance_to(const std::vector<ProfilePoint>& line, const ProfilePoint& p) {
    double least = 1e9;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double dh = line[i + 1].h - line[i].h, dt = line[i + 1].t - line[i].t;
        const double all = dh * dh + dt * dt;
        if (all == 0) continue;
        const double at =
            std::clamp(((p.h - line[i].h) * dh + (p.t - line[i].t) * dt) / all, 0.0, 1.0);
        least = std::min(least, std::hypot(p.h - line[i].h - at * dh, p.t - line[i].t - at * dt));
    }
    return least;
}

/// Where the middle of the nose goes at feed, in the view of the outline.
std::vector<ProfilePoint> nose_way(const std::vector<json>& moves, double nose,
                                   const std::function<ProfilePoint(double, double)>& seen) {
    std::vector<ProfilePoint> way;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        if (is_rapid(moves[i])) continue;
        const double x0 = x_of(moves[i - 1]), z0 = z_of(moves[i - 1]);
        const double x1 = x_of(moves[i]), z1 = z_of(moves[i]);
        const bool is_arc = moves[i].at("op") == "arc";
        double cx = 0, cz = 0, from = 0, sweep = 0;
        if (is_arc) {
            cx = moves[i].at("center")[0];
            cz = moves[i].at("center")[2];
            from = std::atan2(x0 - cx, z0 - cz);
            sweep = std::remainder(std::atan2(x1 - cx, z1 - cz) - from, 2 * std::numbers::pi);
        }
        for (int k = 0; k <= 100; ++k) {
            const double share = k / 100.0, r = std::hypot(x0 - cx, z0 - cz);
            const double x =
                is_arc ? cx + r * std::sin(from + share * sweep) : x0 + share * (x1 - x0);
            const double z =
                is_arc ? cz + r * std::cos(from + share * sweep) : z0 + share * (z1 - z0);
            const ProfilePoint tip = seen(x, z);
            way.push_back({tip.h + nose, tip.t + nose});
        }
    }
    return way;
}

/// The nose touches the outline all along the undercut, and never comes nearer.
void expect_undercut(const std::string& call, const Undercut& undercut, double surface, double z,
                     bool is_inside, bool is_mirrored, double nose) {
    SCOPED_TRACE(call);
    const double side = is_inside ? -1 : 1, distance = is_mirrored ? -1 : 1;
    const double start_x = is_inside ? std::max(0.5, surface - 3) : surface + 20;
    const std::vector<json> moves = commands_from("grooves", call, start_x, z + distance * 30);
    const auto seen = [&](double x, double at) {
        return ProfilePoint{side * (x - surface), distance * (at - z)};
    };
    const std::vector<ProfilePoint> outline = undercut.outline();
    const std::vector<ProfilePoint> nose_at = nose_way(moves, nose, seen);
    ASSERT_GT(nose_at.size(), 300u);
    for (const ProfilePoint& p : nose_at) ASSERT_GE(distance_to(outline, p), nose - kRound);
    // What the standard cuts away is reached: the nose rolls along it.
    const double slope = undercut.slope_deg * std::numbers::pi / 180;
    const ProfilePoint corner{-undercut.deep, undercut.length - undercut.deep / std::tan(slope)};
    for (std::size_t i = 1; i + 2 < outline.size(); ++i) {
        for (int k = 0; k < 5; ++k) {
            const double share = k / 5.0;
            const ProfilePoint p{outline[i].h + share * (outline[i + 1].h - outline[i].h),
                                 outline[i].t + share * (outline[i + 1].t - outline[i].t)};
            // In the corner between slope and ground it leaves its own radius.
            const double apart = std::hypot(p.h - corner.h, p.t - corner.t);
            if (p.h > 0 || apart < nose * std::tan(slope / 2) + kRound) continue;
            ASSERT_LE(distance_to(nose_at, p), nose + kRound) << p.h << ' ' << p.t;
        }
    }
    // No rapid in the part: below the surface, or behind the shoulder below the clearance.
    for (const json& move : moves) {
        if (!is_rapid(move)) continue;
        const ProfilePoint p = seen(x_of(move), z_of(move));
        EXPECT_GE(p.h, 1 - kExact);
    }
}

TEST(LatheCycles, UndercutsOfShouldersKeepToDin509) {
    Dice dice(41);
    for (int i = 0; i < kSets; ++i) {
        const double d = dice.length(3.2, 120);
        const bool has_face = dice.coin();
        const int kind = dice.number(0, 4);
        // DIN 509: depth, radius, width, how far into the face.
        Undercut undercut = d <= 18   ? Undercut{0.2, 0.4, 2, 15, 0.1}
                            : d <= 80 ? Undercut{0.3, 0.6, 2.5, 15, 0.2}
                                      : Undercut{0.4, 1, 4, 15, 0.3};
        if (!has_face) undercut.into = 0;
        const double nose = undercut.radius * dice.number(0, 5) / 5;
        const double z = -dice.length(5, 40);
        expect_undercut("undercut_shoulder(d: " + mm(d) + ", z: " + mm(z) +
                            ", form: " + (has_face ? "70" : "69") +
                            ", kind: " + std::to_string(kind) + ", tool_d: " + mm(2 * nose) + ")",
                        undercut, d / 2, z, kind == 1 || kind == 2, kind == 1 || kind == 4, nose);
    }
}

TEST(LatheCycles, UndercutsOfThreadsKeepToDin76) {
    struct Row {
        double size, pitch, core_less, radius, a, b, c, d;
    };
    // DIN 76-1, coarse threads: dg = size - core_less outside, size + 0.5 inside; widths g2.
    const std::array rows = {
        Row{6, 1, 1.6, 0.6, 3.5, 2.5, 5.2, 3.7}, Row{10, 1.5, 2.3, 0.8, 5.2, 3.8, 7.8, 5.6},
        Row{16, 2, 3, 1, 7, 5, 10.3, 7.3},       Row{24, 3, 4.4, 1.6, 10.5, 7.5, 15.2, 10.7},
        Row{36, 4, 5.7, 2, 14, 10, 20, 14},      Row{64, 6, 8.3, 3.2, 21, 15, 30, 21}};
    Dice dice(42);
    for (int i = 0; i < kSets; ++i) {
        const Row& row = rows[static_cast<std::size_t>(dice.number(0, rows.size() - 1))];
        const int form = dice.number(0, 3);
        const bool is_inside = form >= 2, is_mirrored = dice.coin();
        const double surface = (is_inside ? row.size - 1.0825 * row.pitch : row.size) / 2;
        const double ground = (is_inside ? row.size + 0.5 : row.size - row.core_less) / 2;
        const double length =
            std::array{row.a, row.b, row.c, row.d}[static_cast<std::size_t>(form)];
        const Undercut undercut{std::fabs(surface - ground), row.radius, length, 30, 0};
        const double nose = row.radius * dice.number(0, 5) / 5;
        const double z = -dice.length(25, 60);
        const int kind = is_inside ? (is_mirrored ? 1 : 2) : (is_mirrored ? 4 : 3);
        expect_undercut("undercut_thread(d: " + mm(row.size) + ", z: " + mm(z) +
                            ", form: " + std::to_string(65 + form) +
                            ", kind: " + std::to_string(kind) + ", tool_d: " + mm(2 * nose) + ")",
                        undercut, surface, z, is_inside, is_mirrored, nose);
    }
}

// ---------------------------------------------------------------- shapes that stand in the program

struct Shape {
    ProfileShape profile;
    std::string text;  // the contour
};

/// A shape that only rises from its front to the chuck: steps, cylinders, tapers.
Shape any_shape(Dice& dice) {
    Shape shape;
    ProfilePoint here{dice.length(5, 15), 0};
    shape.profile.start = {here.h, 2};
    shape.text = "contour shape = { DIAMON; G1 X=" + mm(2 * here.h) + " Z2;";
    for (int i = dice.number(1, 6); i >= 0; --i) {
        const double rise = i % 2 == 0 ? dice.length(0.2, 6) : 0;
        const double run = rise == 0 || dice.coin() ? dice.length(0.5, 12) : 0;
        here = {std::round((here.h + rise) * 10) / 10, std::round((here.t - run) * 10) / 10};
        shape.profile.elements.push_back({here});
        shape.text += " X=" + mm(2 * here.h) + " Z=" + mm(here.t) + ";";
    }
    shape.text += " };\n    ";
    return shape;
}

/// Faults but those of the ways to the start of the shape and back, which these cycles go in both
/// axes.
void expect_no_fault(const Profile& part) {
    for (const std::string& fault : part.faults()) {
        if (!fault.starts_with("rapid in two axes")) ADD_FAILURE() << fault;
    }
}

void expect_left(const Profile& part, const std::vector<double>& kept, double t_low,
                 double rough_h) {
    for (std::size_t i = 1; i + 1 < kept.size(); ++i) {
        const double t = part.place(i);
        if (t < t_low || t > -0.1) continue;
        const double low = std::min({kept[i - 1], kept[i], kept[i + 1], rough_h});
        const double high = std::min(std::max({kept[i - 1], kept[i], kept[i + 1]}), rough_h);
        ASSERT_GE(part.heights()[i], low - 0.02) << "cut into what stays at " << t;
        ASSERT_LE(part.heights()[i], high + 0.02) << "left at " << t;
    }
}

TEST(LatheCycles, StockIsRoughedToTheShapeAndItsAllowances) {
    Dice dice(43);
    for (int i = 0; i < kSets; ++i) {
        const Shape shape = any_shape(dice);
        const double rough_h = shape.profile.highest(), step = dice.length(0.3, 3);
        const double on_x = dice.coin() ? 0 : dice.length(0.1, 1);
        const double on_z = dice.coin() ? 0 : dice.length(0.1, 0.5);
        const std::string call = shape.text + "stock_rough(shape, step: " + mm(step) +
                                 ", escape: " + mm(dice.length(0, 1)) +
                                 ", allowance_x: " + mm(on_x) + ", allowance_z: " + mm(on_z) +
                                 (dice.coin() ? ", both: true" : "") + ")";
        SCOPED_TRACE(call);
        const double x = rough_h + 1;
        const std::vector<json> moves = commands_from("lathe_stock", call, x, 2);
        Profile part(shape.profile.end().t - 20, 30, kCell);
        part.fill(-1e9, 0, rough_h);
        part.cut(moves, {false, 1}, {});
        expect_no_fault(part);
        EXPECT_LE(part.deepest_cut(), step + on_z + 0.02);
        EXPECT_NEAR(part.x(), x, kExact);
        EXPECT_NEAR(part.z(), 2, kExact);
        const double low = shape.profile.end().t + on_z + 0.1;
        expect_left(part, part.kept(shape.profile, 0, on_x / 2, on_z, 0), low, rough_h);
    }
}

TEST(LatheCycles, APatternComesNearerWithEachPass) {
    Dice dice(44);
    for (int i = 0; i < kSets; ++i) {
        const Shape shape = any_shape(dice);
        const double relief = dice.length(1, 8), on_x = dice.coin() ? 0 : dice.length(0.1, 1);
        const double on_z = dice.coin() ? 0 : dice.length(0.1, 0.5);
        const int passes = dice.number(1, 6);
        const std::string call = shape.text + "stock_pattern(shape, relief_x: " + mm(relief) +
                                 ", passes: " + std::to_string(passes) +
                                 ", allowance_x: " + mm(on_x) + ", allowance_z: " + mm(on_z) + ")";
        SCOPED_TRACE(call);
        const double x = shape.profile.highest() + 2;
        const std::vector<json> moves = commands_from("lathe_stock", call, x, 4);
        const auto feeds = std::ranges::count_if(moves, [](const json& m) { return !is_rapid(m); });
        EXPECT_EQ(feeds, passes * static_cast<int>(shape.profile.elements.size()));
        // Each pass runs as far off the finished one as its share of the relief.
        std::size_t at = 0;
        for (const json& move : moves) {
            if (is_rapid(move)) continue;
            const std::size_t pass = at / shape.profile.elements.size();
            const ProfilePoint& to =
                shape.profile.elements[at++ % shape.profile.elements.size()].to;
            const double share = passes == 1 ? 0 : 1 - static_cast<double>(pass) / (passes - 1);
            EXPECT_NEAR(x_of(move), to.h + on_x / 2 + share * relief, kExact);
            EXPECT_NEAR(z_of(move), to.t + on_z, kExact);
        }
        EXPECT_NEAR(x_of(moves.back()), x, kExact);
        EXPECT_NEAR(z_of(moves.back()), 4, kExact);

        const std::vector<json> last =
            commands_from("lathe_stock", shape.text + "stock_follow(shape)", x, 4);
        Profile part(shape.profile.end().t - 20, 30, kCell);
        part.fill(-1e9, 0, shape.profile.highest());
        part.cut(last, {false, 1}, {});
        expect_left(part, part.kept(shape.profile, 0, 0, 0, 0), shape.profile.end().t + 0.1,
                    shape.profile.highest());
    }
}

TEST(LatheCycles, StrokesAreNoDeeperThanTheyMayBe) {
    Dice dice(45);
    for (int i = 0; i < kSets; ++i) {
        const bool along = dice.coin();
        const double deep = dice.length(2, 20), wide = dice.coin() ? 0 : dice.length(1, 15);
        const double stroke = dice.length(0.5, 8), pace = dice.length(0.5, 6);
        const double back = dice.length(0, 0.4), x = 40, z = 5;
        // On the radius and along Z; X of the end is a diameter.
        const double end_x = along ? x - wide : x - deep, end_z = along ? z - deep : z - wide;
        const std::string call = "stock_peck(x: " + mm(2 * end_x) + ", z: " + mm(end_z) +
                                 ", step_x: " + mm(along ? pace : stroke) +
                                 ", step_z: " + mm(along ? stroke : pace) + ", back: " + mm(back) +
                                 ", along: " + (along ? "true" : "false") + ")";
        SCOPED_TRACE(call);
        const std::vector<json> moves = commands_from("lathe_stock", call, x, z);
        double done = 0, across = 0;
        int plunges = 0, strokes = 0;
        double at = 0;
        for (const json& move : moves) {
            const double down = along ? z - z_of(move) : x - x_of(move);
            const double beside = along ? x - x_of(move) : z - z_of(move);
            if (std::fabs(beside - across) > kExact) {
                EXPECT_NEAR(at, 0, kExact) << "beside at the bottom";
                EXPECT_LE(beside - across, pace + kExact);
                across = beside;
                done = 0;
            }
            if (!is_rapid(move)) {
                EXPECT_LE(down - done, stroke + kExact);
                done = down;
                ++strokes;
                if (std::fabs(down - deep) < kExact) ++plunges;
            } else {
                EXPECT_LE(down, std::max(0.0, done) + kExact) << "rapid into what is not cut";
            }
            at = down;
        }
        const int places = wide > 0 ? 1 + static_cast<int>(std::ceil(wide / pace - 1e-6)) : 1;
        EXPECT_EQ(plunges, places);
        EXPECT_EQ(strokes, places * static_cast<int>(std::ceil(deep / stroke - 1e-6)));
        EXPECT_NEAR(x_of(moves.back()), x, kExact);
        EXPECT_NEAR(z_of(moves.back()), z, kExact);
    }
}

// ---------------------------------------------------------------- single cuts and threads

TEST(LatheCycles, OneCutGoesThereAndBack) {
    Dice dice(46);
    for (int i = 0; i < kSets; ++i) {
        const double x = dice.length(20, 40), z = dice.length(2, 20);
        const double end_x = dice.length(5, x - 3), end_z = -dice.length(1, 40);
        const double taper = dice.coin() ? 0 : -dice.length(0.1, 2);
        const std::string ends =
            "(x: " + mm(2 * end_x) + ", z: " + mm(end_z) + ", taper: " + mm(taper) + ")";
        SCOPED_TRACE(ends);
        const auto turned = commands_from("turning", "turn_once" + ends, x, z);
        ASSERT_GE(turned.size(), 4u);
        const std::vector<json> turn(turned.end() - 4, turned.end());
        EXPECT_NEAR(x_of(turn[0]), end_x + taper, kExact);
        EXPECT_NEAR(x_of(turn[1]), end_x, kExact);
        EXPECT_NEAR(z_of(turn[1]), end_z, kExact);
        EXPECT_NEAR(x_of(turn[2]), x, kExact);
        EXPECT_NEAR(z_of(turn[3]), z, kExact);
        EXPECT_TRUE(is_rapid(turn[0]) && !is_rapid(turn[1]) && !is_rapid(turn[2]) &&
                    is_rapid(turn[3]));

        const auto faced = commands_from("turning", "face_once" + ends, x, z);
        ASSERT_GE(faced.size(), 4u);
        const std::vector<json> face(faced.end() - 4, faced.end());
        EXPECT_NEAR(z_of(face[0]), end_z + taper, kExact);
        EXPECT_NEAR(x_of(face[1]), end_x, kExact);
        EXPECT_NEAR(z_of(face[1]), end_z, kExact);
        EXPECT_NEAR(z_of(face[2]), z, kExact);
        EXPECT_NEAR(x_of(face[3]), x, kExact);
        EXPECT_TRUE(is_rapid(face[0]) && !is_rapid(face[1]) && !is_rapid(face[2]) &&
                    is_rapid(face[3]));
    }
}

std::vector<json> threads_of(const std::vector<json>& moves) {
    std::vector<json> threads;
    for (const json& move : moves) {
        if (move.at("op") == "thread") threads.push_back(move);
    }
    return threads;
}

TEST(LatheCycles, PassesOfAThreadGoToTheirDepths) {
    Dice dice(47);
    for (int i = 0; i < kSets; ++i) {
        const double core = dice.length(8, 30), z = 10, end = -dice.length(10, 40);
        const double depth = dice.length(0.5, 2), first = dice.length(0.2, 0.5);
        const double least = dice.length(0, 0.2), allowance = dice.coin() ? 0 : 0.1;
        const int finish = dice.number(0, 3), method = dice.number(1, 4);
        const double lead = dice.length(0.5, 3);
        const std::string call =
            "thread_passes(x: " + mm(2 * core) + ", z: " + mm(end) + ", depth: " + mm(depth) +
            ", first: " + mm(first) + ", lead: " + mm(lead) + ", least: " + mm(least) +
            ", finish: " + std::to_string(finish) + ", allowance: " + mm(allowance) +
            ", run_off: 0, point: 60, method: " + std::to_string(method) + ")";
        SCOPED_TRACE(call);
        const double x = core + depth + 2;
        const auto cuts = threads_of(commands_from("threading", call, x, z));
        // Each cut n is first·√n deep, or first·n, and `least` deeper than the one before at least.
        std::vector<double> wanted;
        for (double deep = 0; deep < depth - allowance - 1e-9;) {
            const auto n = static_cast<double>(wanted.size() + 1);
            const double next = method > 2 ? first * n : first * std::sqrt(n);
            deep = std::min(std::max(next, deep + least), depth - allowance);
            wanted.push_back(deep);
        }
        wanted.insert(wanted.end(), static_cast<std::size_t>(finish), depth);
        ASSERT_EQ(cuts.size(), wanted.size());
        for (std::size_t k = 0; k < cuts.size(); ++k) {
            EXPECT_NEAR(x_of(cuts[k]), core + depth - wanted[k], kExact) << k;
            EXPECT_NEAR(z_of(cuts[k]), end, kExact);
            EXPECT_NEAR(cuts[k]["feed"].get<double>(), lead, 1e-6);
        }
        const std::string once =
            "thread_once(x: " + mm(2 * core) + ", z: " + mm(end) + ", lead: " + mm(lead) + ")";
        const auto moves = commands_from("threading", once, x, z);
        const auto cut = threads_of(moves);
        ASSERT_EQ(cut.size(), 1u);
        EXPECT_NEAR(x_of(cut[0]), core, kExact);
        EXPECT_NEAR(x_of(moves.back()), x, kExact);
        EXPECT_NEAR(z_of(moves.back()), z, kExact);
    }
}

TEST(LatheCycles, ThreadsBehindEachOtherAreCutInOne) {
    Dice dice(48);
    for (int i = 0; i < kSets; ++i) {
        std::array<double, 4> z{}, d{};
        z[0] = dice.length(-5, 5);
        d[0] = dice.length(20, 40);
        for (std::size_t k = 1; k < 4; ++k) {
            z[k] = z[k - 1] - dice.length(5, 30);
            d[k] = d[k - 1] + (dice.coin() ? 0 : dice.length(-2, 4));
        }
        const std::array leads = {dice.length(0.5, 3), dice.length(0.5, 3), dice.length(0.5, 3)};
        const int kind = dice.number(1, 4), cuts = dice.number(1, 6), spring = dice.number(0, 2);
        const int starts = dice.number(1, 3);
        const bool is_inside = kind % 2 == 0;
        const double depth = dice.length(0.5, 2), allowance = dice.coin() ? 0 : 0.1, out = 2;
        std::string call = "thread_chain(";
        for (int k = 0; k < 4; ++k) {
            const auto n = static_cast<std::size_t>(k);
            call += "z" + std::to_string(k + 1) + ": " + mm(z[n]) + ", d" + std::to_string(k + 1) +
                    ": " + mm(d[n]) + ", ";
        }
        call += "run_in: 6mm, run_out: 2mm, depth: " + mm(depth) + ", allowance: " + mm(allowance) +
                ", cuts: " + std::to_string(cuts) + ", spring: " + std::to_string(spring) +
                ", lead: " + mm(leads[0]) + ", lead2: " + mm(leads[1]) +
                ", lead3: " + mm(leads[2]) + ", kind: " + std::to_string(kind) +
                ", starts: " + std::to_string(starts) + ", clear: 1.5mm)";
        SCOPED_TRACE(call);
        const double x = is_inside ? 5 : 60;
        const auto moves = commands_from("thread_chain", call, x, 40);
        const auto threads = threads_of(moves);
        const int passes = cuts + spring + (allowance > 0 ? 1 : 0);
        ASSERT_EQ(threads.size(), static_cast<std::size_t>(3 * starts * passes));
        const double side = is_inside ? 1 : -1, rough = depth - allowance;
        const double first = std::ceil(rough / std::sqrt(cuts) * 1000 - 0.001) / 1000;
        for (std::size_t k = 0; k < threads.size(); ++k) {
            const int pass = static_cast<int>(k / 3) % passes + 1;
            const double deep = pass > cuts ? depth
                                : kind >= 3 ? std::min(first * std::sqrt(pass), rough)
                                            : rough * pass / cuts;
            const std::size_t part = k % 3;
            const double slope = (d[3] - d[2]) / (z[3] - z[2]);
            const double end_z = part == 2 ? z[3] - out : z[part + 1];
            const double end_d = part == 2 ? d[3] - out * slope : d[part + 1];
            EXPECT_NEAR(x_of(threads[k]), end_d / 2 + side * deep, kExact) << k;
            EXPECT_NEAR(z_of(threads[k]), end_z, kExact) << k;
            if (part == 0) {
                const double start =
                    360.0 * static_cast<double>(k / 3 / static_cast<std::size_t>(passes)) / starts;
                EXPECT_NEAR(threads[k].value("start", 0.0), start, 1e-5);
            }
        }
        // Between the cuts the tool keeps clear of all surfaces.
        const double widest =
            *(is_inside ? std::ranges::min_element(d) : std::ranges::max_element(d));
        for (std::size_t k = 1; k < moves.size(); ++k) {
            if (!is_rapid(moves[k]) || z_of(moves[k]) == z_of(moves[k - 1]) || k < 3) continue;
            EXPECT_GE(-side * (x_of(moves[k]) - widest / 2), 1.5 - 1) << moves[k];
        }
    }
}

TEST(LatheCycles, AThreadByItsSizeIsTheOneByItsPitch) {
    // ISO 261, coarse.
    const std::array<std::pair<double, double>, 8> sizes = {
        {{3, 0.5}, {5, 0.8}, {8, 1.25}, {12, 1.75}, {20, 2.5}, {30, 3.5}, {42, 4.5}, {48, 5}}};
    Dice dice(49);
    for (int i = 0; i < kSets / 2; ++i) {
        const auto& [size, pitch] = sizes[static_cast<std::size_t>(dice.number(0, 7))];
        const int kind = dice.number(1, 4);
        const std::string rest = "from: 0mm, to: " + mm(-dice.length(10, 40)) + ", d: " + mm(size) +
                                 ", d_end: " + mm(size) + ", run_in: " + mm(3 * pitch) +
                                 ", run_out: " + mm(dice.length(0, 3)) +
                                 ", depth: " + mm(std::round(600 * pitch) / 1000) +
                                 ", cuts: " + std::to_string(dice.number(1, 8)) +
                                 ", spring: " + std::to_string(dice.number(0, 2)) +
                                 ", clear: 0.5mm";
        SCOPED_TRACE(rest);
        const double x = kind % 2 == 0 ? 0.4 : 60;
        const auto sized = commands_from("thread_chain",
                                         "thread_cut_sized(thread_size: " + json(size).dump() +
                                             ", " + rest + ", kind: " + std::to_string(kind) + ")",
                                         x, 40);
        const auto plain =
            commands_from("threading",
                          "thread_cut(lead: " + mm(pitch) + ", " + rest +
                              ", degressive: " + (kind >= 3 ? "true" : "false") +
                              ", inside: " + (kind % 2 == 0 ? "true" : "false") + ")",
                          x, 40);
        ASSERT_EQ(sized.size(), plain.size());
        ASSERT_FALSE(threads_of(sized).empty());
        for (std::size_t k = 0; k < sized.size(); ++k) {
            EXPECT_EQ(sized[k]["to"], plain[k]["to"]);
            EXPECT_EQ(sized[k].value("feed", 0.0), plain[k].value("feed", 0.0));
        }
    }
}

}  // namespace

}  // namespace lathe_cycles_test
