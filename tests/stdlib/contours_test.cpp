// What the cycles along contours and inside them leave behind, over random contours: stars with
// straight and bent sides, with an island or without. Distances are measured here to chains of
// short chords, not by what the cycles calculate with.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/stdlib/cycle_run.h"
#include "tests/stdlib/stock.h"

namespace contours_test {

namespace {

using namespace stdlib_test;
using nlohmann::json;

constexpr double kPi = std::numbers::pi;
constexpr double kCell = 0.25;    // mm
constexpr double kMargin = 0.03;  // inside: scallops of the simulation
constexpr double kEdge = 0.004;   // outside: rounding of the text, chords instead of arcs

// Each set runs three programs against a block of material: a few are enough. RC_PARAMS asks for
// more.
const int kFew = ::setenv("RC_PARAMS", "max_success=12", 0);

struct Vec {
    double x = 0, y = 0;
};

/// A closed chain of corners; a side may be an arc that bulges outwards or inwards.
struct Outline {
    std::vector<Vec> corners;  // anticlockwise
    std::vector<double>
        bulges;               // of the side behind each corner: tangent of a quarter of its angle
    std::vector<Vec> chords;  // the same, in short pieces

    /// The statements of a contour.
    std::string text() const {
        std::string out = "{ G1 X" + number(corners[0].x) + " Y" + number(corners[0].y) + ";";
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec to = corners[(i + 1) % corners.size()];
            const double bulge = bulges[i];
            out += bulge == 0 ? " G1" : bulge > 0 ? " G3" : " G2";
            out += " X" + number(to.x) + " Y" + number(to.y);
            if (bulge != 0) out += " CR=" + number(radius(i), 9);
            out += ";";
        }
        return out + " }";
    }

    double radius(std::size_t i) const {
        const Vec from = corners[i], to = corners[(i + 1) % corners.size()];
        const double chord = std::hypot(to.x - from.x, to.y - from.y);
        return chord * (1 + bulges[i] * bulges[i]) / (4 * std::fabs(bulges[i]));
    }

    static std::string number(double value, int digits = 3) {
        const double scale = std::pow(10, digits);
        return json(std::round(value * scale) / scale).dump();
    }

    void make_chords() {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec from = corners[i], to = corners[(i + 1) % corners.size()];
            const double angle = 4 * std::atan(bulges[i]);
            chords.push_back(from);
            if (angle == 0) continue;
            const double r = radius(i);
            // The centre lies beside the middle of the chord.
            const double h = (1 - bulges[i] * bulges[i]) / (4 * bulges[i]);
            const Vec center{(from.x + to.x) / 2 - h * (to.y - from.y),
                             (from.y + to.y) / 2 + h * (to.x - from.x)};
            const double start = std::atan2(from.y - center.y, from.x - center.x);
            const int pieces =
                static_cast<int>(std::ceil(std::fabs(angle) / std::sqrt(8 * 0.0005 / r)));
            for (int k = 1; k < pieces; ++k) {
                const double at = start + angle * k / pieces;
                chords.push_back({center.x + r * std::cos(at), center.y + r * std::sin(at)});
            }
        }
    }

    /// The nearest place of the outline.
    Vec nearest(double x, double y) const {
        Vec best;
        double least = 1e9;
        for (std::size_t i = 0; i < chords.size(); ++i) {
            const Vec a = chords[i], b = chords[(i + 1) % chords.size()];
            const double dx = b.x - a.x, dy = b.y - a.y;
            const double t =
                std::clamp(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
            const Vec at{a.x + t * dx, a.y + t * dy};
            const double apart = std::hypot(x - at.x, y - at.y);
            if (apart < least) {
                least = apart;
                best = at;
            }
        }
        return best;
    }

    /// Signed distance: negative inside.
    double distance(double x, double y) const {
        bool is_inside = false;
        for (std::size_t i = 0, j = chords.size() - 1; i < chords.size(); j = i++) {
            const Vec a = chords[i], b = chords[j];
            if ((a.y > y) == (b.y > y)) continue;
            if (x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x) is_inside = !is_inside;
        }
        const Vec at = nearest(x, y);
        return std::hypot(x - at.x, y - at.y) * (is_inside ? -1 : 1);
    }
};

int whole(int low, int high) { return *rc::gen::inRange(low, high + 1); }

double length(double low, double high) {
    return whole(static_cast<int>(low * 10), static_cast<int>(high * 10)) / 10.0;
}

/// A star about a middle: corners in all directions, at any distance.
Outline any_star(const Vec& middle, double least, double most) {
    Outline outline;
    const int n = whole(3, 8);
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * kPi * (i + whole(-30, 30) / 100.0) / n;
        const double r = length(least, most);
        outline.corners.push_back({std::round((middle.x + r * std::cos(angle)) * 1000) / 1000,
                                   std::round((middle.y + r * std::sin(angle)) * 1000) / 1000});
        // Inwards only a little, so that sides do not meet.
        outline.bulges.push_back(whole(0, 2) > 0 ? 0 : whole(0, 1) > 0 ? 0.2 : -0.08);
    }
    outline.make_chords();
    return outline;
}

/// A pocket: a wall, maybe an island about the middle.
struct Walls {
    Outline wall;
    std::vector<Outline> islands;

    double distance(double x, double y) const {
        double all = wall.distance(x, y);
        for (const Outline& island : islands) all = std::max(all, -island.distance(x, y));
        return all;
    }
    Vec nearest(double x, double y) const {
        Vec best = wall.nearest(x, y);
        for (const Outline& island : islands) {
            const Vec other = island.nearest(x, y);
            if (std::hypot(x - other.x, y - other.y) < std::hypot(x - best.x, y - best.y))
                best = other;
        }
        return best;
    }
};

/// As Stock wants it: positive where nothing may be touched, negative where a cutter of the radius
/// r reaches for certain, 0 where it may or may not: in the corners.
Shape reachable(const std::function<double(double, double)>& distance,
                const std::function<Vec(double, double)>& nearest, double r, double inset) {
    return [=](double x, double y) {
        const double d = distance(x, y) + inset;
        if (d > 0) return d;
        if (d > -kMargin) return 0.0;
        if (d <= -r) return d;
        // Beside a wall: the cutter that touches it there stands on the perpendicular.
        const Vec foot = nearest(x, y);
        const double apart = std::hypot(x - foot.x, y - foot.y);
        const double k = (r + inset) / apart;
        const double cx = foot.x + (x - foot.x) * k, cy = foot.y + (y - foot.y) * k;
        return distance(cx, cy) + inset <= -r + 1e-6 ? d : 0.0;
    };
}

/// What went wrong; a cutter that cuts over its centre may go straight down.
std::string faults_of(const Stock& stock, bool may_plunge) {
    std::string all;
    for (const Fault& fault : stock.faults()) {
        if (may_plunge && fault.what.starts_with("straight down")) continue;
        all += fault.what + ": " + fault.command + "\n";
    }
    return all;
}

Stock plate() {
    return Stock(40, kCell, 0, [](double, double) { return -1.0; });
}

void expect_same_everywhere(const std::string& call, const std::vector<json>& commands) {
    const std::string dialect = *rc::gen::element<std::string>("sinumerik", "fanuc", "axioma");
    RC_ASSERT(motion_difference(commands, "cycles.contours", call, dialect) == "");
}

TEST(Contours, PocketsOfAnyShape) {
    EXPECT_TRUE(rc::check([] {
        Walls walls;
        walls.wall = any_star({0, 0}, 9, 36);
        const double tool_d = length(2, 8), r = tool_d / 2;
        const double allowance = whole(0, 1) * 0.2;
        const double floor = -length(0.5, 6), step = length(0.5, 4);
        const double floor_allowance = whole(0, 1) * 0.2;
        if (whole(0, 1) > 0) {
            const Outline island = any_star({0, 0}, 1, 4);
            for (const Vec& corner : island.chords)
                RC_PRE(walls.wall.distance(corner.x, corner.y) < -0.1);
            walls.islands.push_back(island);
        }
        const std::string down = *rc::gen::element<std::string>("helix", "ramp", "straight");
        const std::string call =
            "contour wall = " + walls.wall.text() + ";" +
            (walls.islands.empty() ? std::string()
                                   : "contour island = " + walls.islands[0].text() + ";") +
            " pocket_contour(wall, to: " + mm(floor) + ", tool_d: " + mm(tool_d) +
            ", step: " + mm(step) + ", plunge: 200mm/min, allowance: " + mm(allowance) +
            ", floor_allowance: " + mm(floor_allowance) + ", down: " + down +
            (walls.islands.empty() ? "" : ", islands: {island}") +
            (whole(0, 1) > 0 ? ", sense: conventional" : "") +
            (whole(0, 1) > 0 ? ", width: " + mm(0.5 * tool_d) : "");
        RC_LOG() << call << ")\n";
        const CycleRun run = run_cycle("cycles.contours", call + ")");
        // What is too narrow is refused in clear words: then nothing is cut.
        const bool is_refused = run.error.find("does not fit") != std::string::npos ||
                                run.error.find("room neither for a helix") != std::string::npos ||
                                run.error.find("leaves no room for roughing") != std::string::npos;
        RC_PRE(!is_refused);
        RC_LOG() << run.error;
        RC_ASSERT(run.status == 0);

        const auto distance = [&](double x, double y) { return walls.distance(x, y); };
        const auto nearest = [&](double x, double y) { return walls.nearest(x, y); };
        const bool may_plunge = down == "straight";
        Stock whole_pocket = plate();
        whole_pocket.cut(run.commands, tool_d);
        RC_ASSERT(faults_of(whole_pocket, may_plunge) == "");
        RC_ASSERT(whole_pocket.difference(reachable(distance, nearest, r, 0), floor, 0, kEdge) ==
                  "");

        Stock rough = plate();
        const CycleRun roughing = run_cycle("cycles.contours", call + ", make: roughing)");
        RC_ASSERT(roughing.status == 0);
        rough.cut(roughing.commands, tool_d);
        RC_ASSERT(rough.difference(reachable(distance, nearest, r, allowance),
                                   floor + floor_allowance, 0, kEdge) == "");
        RC_ASSERT(rough.deepest_cut() <= step + 1e-3);
        if (allowance > 0 || floor_allowance > 0) {
            const CycleRun finishing = run_cycle("cycles.contours", call + ", make: finishing)");
            RC_ASSERT(finishing.status == 0);
            rough.cut(finishing.commands, tool_d);
            RC_ASSERT(faults_of(rough, may_plunge) == "");
            RC_ASSERT(rough.difference(reachable(distance, nearest, r, 0), floor, 0, kEdge) == "");
        }
        expect_same_everywhere(call + ")", run.commands);
    }));
}

/// The way off a ring that was entered on a ramp: beside it nothing has been cut yet.
TEST(Contours, ARingWithNothingInsideIsLeftStraightUp) {
    for (const char* allowance : {"0mm", "0.3mm"}) {
        for (const char* down : {"helix", "ramp", "straight"}) {
            const std::string call =
                std::string("contour wall = { G1 X20 Y0; G3 I-20 J0; };\n") +
                "contour post = { G1 X10 Y0; G3 I-10 J0; };\n" +
                "pocket_contour(wall, to: -5mm, tool_d: 8mm, step: 2mm, plunge: 200mm/min, "
                "islands: {post}, down: " +
                down + ", allowance: " + allowance + ")";
            SCOPED_TRACE(call);
            Stock stock = plate();
            stock.cut(commands_of("cycles.contours", call), 8);
            EXPECT_EQ(faults_of(stock, std::string(down) == "straight"), "");
            EXPECT_NEAR(stock.lowest(), -5, 1e-6);
        }
    }
}

TEST(Contours, WallsOfAnyShape) {
    EXPECT_TRUE(rc::check([] {
        const Outline outline = any_star({0, 0}, 8, 24);
        const bool is_outside = whole(0, 1) > 0;
        const double tool_d = length(2, 8), r = tool_d / 2;
        const double allowance = whole(0, 1) * 0.3;
        const double floor = -length(0.5, 6), step = length(0.5, 4);
        const std::string call =
            "contour wall = " + outline.text() + "; mill_contour(wall, to: " + mm(floor) +
            ", tool_d: " + mm(tool_d) + ", step: " + mm(step) +
            ", side: " + (is_outside ? "right" : "left") + ", allowance: " + mm(allowance);
        RC_LOG() << call << ")\n";
        const CycleRun run = run_cycle("cycles.contours", call + ")");
        RC_PRE(run.error.find("falls into") == std::string::npos);
        RC_PRE(run.error.find("nothing of this contour") == std::string::npos);
        RC_LOG() << run.error;
        RC_ASSERT(run.status == 0);
        const double side = is_outside ? -1 : 1;
        const auto distance = [&](double x, double y) { return side * outline.distance(x, y); };
        const auto nearest = [&](double x, double y) { return outline.nearest(x, y); };
        // Cut is a strip as wide as the cutter; what lies farther away, nobody asks about.
        const auto strip = [&](double inset) -> Shape {
            const Shape all = reachable(distance, nearest, r, inset);
            return [=](double x, double y) {
                const double d = all(x, y);
                return d < -tool_d + 0.1 ? 0.0 : d <= -r ? 0.0 : d;
            };
        };
        Stock stock = plate();
        stock.cut(run.commands, tool_d);
        RC_ASSERT(faults_of(stock, true) == "");
        RC_ASSERT(stock.difference(strip(0), floor, 0, kEdge) == "");
        RC_ASSERT(std::fabs(stock.lowest() - floor) < 1e-6);
        Stock rough = plate();
        const CycleRun roughing = run_cycle("cycles.contours", call + ", make: roughing)");
        RC_ASSERT(roughing.status == 0);
        rough.cut(roughing.commands, tool_d);
        RC_ASSERT(rough.difference(strip(allowance), floor, 0, kEdge) == "");
        RC_ASSERT(rough.deepest_cut() <= step + 1e-3);
        expect_same_everywhere(call + ")", run.commands);
    }));
}

TEST(Contours, ChamfersOfAnyShape) {
    EXPECT_TRUE(rc::check([] {
        const Outline outline = any_star({0, 0}, 10, 22);
        const double size = length(0.3, 2), tip_d = length(0, 3), tip_deg = whole(60, 120);
        const std::string call = "contour edge = " + outline.text() +
                                 "; chamfer_contour(edge, size: " + mm(size) +
                                 ", side: right, tip_d: " + mm(tip_d) +
                                 ", arc_in: 0mm, tip: " + json(tip_deg).dump() + "deg";
        RC_LOG() << call << ")\n";
        const CycleRun run = run_cycle("cycles.contours", call + ")");
        RC_PRE(run.error.find("falls into") == std::string::npos);
        RC_ASSERT(run.status == 0);
        Stock stock = plate();
        stock.lower_outside([&](double x, double y) { return outline.distance(x, y); }, -20);
        stock.cut(run.commands, tip_d, tip_deg);
        // Everywhere inside the height is that of the cone beside the nearest place of the edge,
        // or, in corners where the cutter does not get so near, higher; never lower.
        const double slope = 1 / std::tan(tip_deg / 2 * kPi / 180);
        const double off = tip_d / 2 + 0.3 / slope;
        for (double x = -25.125; x < 25; x += 1.25) {
            for (double y = -25.125; y < 25; y += 1.25) {
                const double into = -outline.distance(x, y);
                if (into <= 0.05) continue;
                const double wanted = std::min(0.0, (into - size) * slope);
                RC_ASSERT(stock.height_at(x, y) >= wanted - 0.01);
                const Vec foot = outline.nearest(x, y);
                const double cx = foot.x - (x - foot.x) / into * off;
                const double cy = foot.y - (y - foot.y) / into * off;
                if (outline.distance(cx, cy) < off - 1e-6) continue;
                RC_ASSERT(stock.height_at(x, y) <= wanted + 0.03);
            }
        }
    }));
}

}  // namespace

}  // namespace contours_test
