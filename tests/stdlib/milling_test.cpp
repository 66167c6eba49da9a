// What the milling cycles of the library leave behind, over many sets of parameters: nothing
// outside the shape is touched, everything inside is at its depth, allowances are exact, no rapid
// goes into material, no cut is deeper than its step.
#include <gtest/gtest.h>

#include "tests/stdlib/cycle_run.h"
#include "tests/stdlib/stock.h"

namespace milling_test {

namespace {

using namespace stdlib_test;
using nlohmann::json;

constexpr double kCell = 0.25;    // mm
constexpr double kMargin = 0.03;  // inside: scallops of the simulation, cells near the border
constexpr double kEdge = 0.004;   // outside: what rounding of the text may do
constexpr int kSets = 12;         // parameter sets a cycle

/// A large plate with its surface at Z 0.
Stock plate() {
    return Stock(40, kCell, 0, [](double, double) { return -1.0; });
}

void expect_clean(const Stock& stock) {
    for (const Fault& fault : stock.faults()) ADD_FAILURE() << fault.what << ": " << fault.command;
    EXPECT_NEAR(stock.position().x, 0, 1e-9);
    EXPECT_NEAR(stock.position().y, 0, 1e-9);
    EXPECT_NEAR(stock.position().z, 40, 1e-9) << "the cycle ends where it began";
}

/// One of the other controls, each in its turn.
void expect_same_everywhere(const std::string& module, const std::string& call,
                            const std::vector<json>& commands) {
    static int turn = 0;
    const char* dialects[] = {"sinumerik", "fanuc", "axioma"};
    EXPECT_EQ(motion_difference(commands, module, call, dialects[turn++ % 3]), "");
}

/// A cavity is cut as a whole, and again roughed only: what is left is the allowance.
struct Cavity {
    std::string module, call;  // the call without `make`, its last argument open
    Shape shape;
    double tool_d, floor, step, allowance, floor_allowance;
    bool has_roughing = true;
    Shape rough = {};  // what roughing leaves, if it is not the shape less the allowance
};

void expect_cavity(const Cavity& cavity) {
    SCOPED_TRACE(cavity.call);
    Stock whole = plate();
    const std::vector<json> commands = commands_of(cavity.module, cavity.call + ")");
    expect_same_everywhere(cavity.module, cavity.call + ")", commands);
    whole.cut(commands, cavity.tool_d);
    expect_clean(whole);
    EXPECT_EQ(whole.difference(cavity.shape, cavity.floor, kMargin, kEdge), "");
    EXPECT_NEAR(whole.lowest(), cavity.floor, 1e-6);
    if (!cavity.has_roughing) return;

    Stock rough = plate();
    rough.cut(commands_of(cavity.module, cavity.call + ", make: roughing)"), cavity.tool_d);
    expect_clean(rough);
    const Shape inset = [&](double x, double y) { return cavity.shape(x, y) + cavity.allowance; };
    EXPECT_EQ(rough.difference(cavity.rough ? cavity.rough : inset,
                               cavity.floor + cavity.floor_allowance, kMargin, kEdge),
              "")
        << "roughing";
    EXPECT_LE(rough.deepest_cut(), cavity.step + 1e-3);
    if (cavity.allowance == 0 && cavity.floor_allowance == 0) return;

    // The finishing cut behind the roughing one gives the whole.
    rough.cut(commands_of(cavity.module, cavity.call + ", make: finishing)"), cavity.tool_d);
    expect_clean(rough);
    EXPECT_EQ(rough.difference(cavity.shape, cavity.floor, kMargin, kEdge), "") << "finishing";
}

TEST(Milling, RoundPocket) {
    Dice dice(1);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(3, 16), d = dice.length(1.25 * tool_d + 0.2, 60);
        const double wall = (d - tool_d) / 2;
        const double allowance = dice.coin() ? 0 : std::floor(wall * 2) / 20;
        const double floor = -dice.length(0.5, 12), step = dice.length(0.5, 5);
        const double floor_allowance = dice.coin() ? 0 : 0.2;
        expect_cavity(
            {"cycles.milling",
             "pocket_circle(d: " + mm(d) + ", to: " + mm(floor) + ", tool_d: " + mm(tool_d) +
                 ", step: " + mm(step) + ", plunge: 200mm/min, allowance: " + mm(allowance) +
                 ", floor_allowance: " + mm(floor_allowance) + (dice.coin() ? ", down: ramp" : ""),
             disc(d), tool_d, floor, step, allowance, floor_allowance});
    }
}

TEST(Milling, RectangularPocket) {
    Dice dice(2);
    for (int i = 0; i < 2 * kSets; ++i) {
        const double tool_d = dice.length(3, 12);
        const double w = dice.length(1.25 * tool_d + 0.2, 60);
        const double h = i % 5 == 0 ? w : dice.length(1.25 * tool_d + 0.2, 60);
        const double side = std::min(w, h), wall = (side - tool_d) / 2;
        const double corner =
            dice.coin() ? tool_d / 2 : std::min(side / 2, dice.length(tool_d / 2, side / 2) + 0.1);
        const double allowance = dice.coin() ? 0 : std::floor(wall * 2) / 20;
        const double floor = -dice.length(0.5, 12), step = dice.length(0.5, 5);
        const double floor_allowance = dice.coin() ? 0 : 0.2;
        expect_cavity(
            {"cycles.milling",
             "pocket_rect(w: " + mm(w) + ", h: " + mm(h) + ", corner: " + mm(corner) +
                 ", to: " + mm(floor) + ", tool_d: " + mm(tool_d) + ", step: " + mm(step) +
                 ", plunge: 200mm/min, allowance: " + mm(allowance) + ", floor_allowance: " +
                 mm(floor_allowance) + (dice.coin() ? ", width: " + mm(0.8 * tool_d) : "") +
                 (dice.coin() ? ", down: ramp" : ""),
             rectangle(w, h, corner), tool_d, floor, step, allowance, floor_allowance, true,
             // More is left in corners into which the cutter just fits.
             rectangle(w - 2 * allowance, h - 2 * allowance,
                       std::max(corner - allowance, tool_d / 2))});
    }
}

TEST(Milling, HelicalBore) {
    Dice dice(3);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(4, 20), d = dice.length(1.1 * tool_d, 1.9 * tool_d);
        const double allowance = dice.coin() ? 0 : std::floor((d - tool_d) * 10) / 100;
        const double floor = -dice.length(1, 15), pitch = dice.length(0.2, 2);
        expect_cavity({"cycles.milling",
                       "bore_helix(d: " + mm(d) + ", to: " + mm(floor) + ", tool_d: " + mm(tool_d) +
                           ", pitch: " + mm(pitch) + ", allowance: " + mm(allowance),
                       disc(d), tool_d, floor, pitch, allowance, 0, false});
    }
}

TEST(Milling, Slot) {
    Dice dice(4);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(3, 16), w = dice.length(tool_d, 1.9 * tool_d);
        const double l = dice.length(w + 1, 70);
        const double allowance = dice.coin() ? 0 : std::floor((w - tool_d) * 10) / 100;
        const double floor = -dice.length(0.5, 8), step = dice.length(0.5, 4);
        expect_cavity({"cycles.slots",
                       "slot(l: " + mm(l) + ", w: " + mm(w) + ", to: " + mm(floor) +
                           ", tool_d: " + mm(tool_d) + ", step: " + mm(step) +
                           ", plunge: 200mm/min, allowance: " + mm(allowance),
                       stadium(l, w), tool_d, floor, step, allowance, 0});
    }
}

TEST(Milling, SlotAlongACircle) {
    Dice dice(5);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(3, 10), w = dice.length(tool_d, 1.9 * tool_d);
        const double d = dice.length(w + 10, 50);
        const double start = dice.length(-180, 180), arc = dice.length(5, 260);
        const double allowance = dice.coin() ? 0 : std::floor((w - tool_d) * 10) / 100;
        const double floor = -dice.length(0.5, 6), step = dice.length(0.5, 3);
        if (arc > 180 && d * std::sin(arc * 3.14159265 / 360) <= w) continue;
        expect_cavity({"cycles.slots",
                       "slot_arc(d: " + mm(d) + ", start: " + json(start).dump() + "deg, arc: " +
                           json(arc).dump() + "deg, w: " + mm(w) + ", to: " + mm(floor) +
                           ", tool_d: " + mm(tool_d) + ", step: " + mm(step) +
                           ", plunge: 200mm/min, allowance: " + mm(allowance),
                       bent_stadium(d, start, arc, w), tool_d, floor, step, allowance, 0});
    }
}

TEST(Milling, TrochoidalSlot) {
    Dice dice(6);
    for (int i = 0; i < kSets / 2; ++i) {
        const double tool_d = dice.length(4, 12), w = dice.length(1.25 * tool_d, 1.9 * tool_d);
        const double l = dice.length(w + 5, 70), advance = dice.length(0.3, tool_d / 4);
        const double floor = -dice.length(2, 12), step = dice.length(2, 12);
        expect_cavity({"cycles.slots",
                       "slot_trochoidal(l: " + mm(l) + ", w: " + mm(w) + ", to: " + mm(floor) +
                           ", tool_d: " + mm(tool_d) + ", advance: " + mm(advance) +
                           ", step: " + mm(step) + ", plunge: 200mm/min",
                       stadium(l, w), tool_d, floor, step, 0, 0, false});
    }
}

/// A spigot is milled as a whole, and roughed and finished.
void expect_spigot(const std::string& call, const Shape& shape, const Shape& blank, double tool_d,
                   double floor, double step, double allowance) {
    SCOPED_TRACE(call);
    Stock whole(40, kCell, 0, blank);
    const std::vector<json> commands = commands_of("cycles.spigots", call + ")");
    expect_same_everywhere("cycles.spigots", call + ")", commands);
    whole.cut(commands, tool_d);
    expect_clean(whole);
    EXPECT_EQ(whole.spigot_difference(shape, floor, kMargin, kEdge), "");

    Stock rough(40, kCell, 0, blank);
    rough.cut(commands_of("cycles.spigots", call + ", make: roughing)"), tool_d);
    expect_clean(rough);
    const Shape larger = [&](double x, double y) { return shape(x, y) - allowance; };
    EXPECT_EQ(rough.spigot_difference(larger, floor, kMargin, kEdge), "") << "roughing";
    EXPECT_LE(rough.deepest_cut(), step + 1e-3);
    if (allowance == 0) return;
    rough.cut(commands_of("cycles.spigots", call + ", make: finishing)"), tool_d);
    expect_clean(rough);
    EXPECT_EQ(rough.spigot_difference(shape, floor, kMargin, kEdge), "") << "finishing";
}

TEST(Milling, RoundSpigot) {
    Dice dice(7);
    for (int i = 0; i < kSets / 2; ++i) {
        const double tool_d = dice.length(3, 16), blank = dice.length(20, 70);
        const double d = dice.length(5, blank - 1), allowance = dice.coin() ? 0 : 0.3;
        const double floor = -dice.length(0.5, 8), step = dice.length(0.5, 4);
        expect_spigot("spigot_circle(d: " + mm(d) + ", blank_d: " + mm(blank) +
                          ", to: " + mm(floor) + ", tool_d: " + mm(tool_d) + ", step: " + mm(step) +
                          ", allowance: " + mm(allowance),
                      disc(d), disc(blank), tool_d, floor, step, allowance);
    }
}

TEST(Milling, RectangularSpigot) {
    Dice dice(8);
    for (int i = 0; i < kSets; ++i) {
        const double tool_d = dice.length(3, 16);
        const double blank_w = dice.length(20, 70), blank_h = dice.length(20, 70);
        const double w = dice.length(5, blank_w), h = dice.length(5, blank_h - 1);
        const double corner = dice.coin() ? 0 : dice.length(0.1, std::min(w, h) / 2 - 0.1);
        const double allowance = dice.coin() ? 0 : 0.2;
        const double floor = -dice.length(0.5, 8), step = dice.length(0.5, 4);
        expect_spigot("spigot_rect(w: " + mm(w) + ", h: " + mm(h) + ", blank_w: " + mm(blank_w) +
                          ", blank_h: " + mm(blank_h) + ", corner: " + mm(corner) +
                          ", to: " + mm(floor) + ", tool_d: " + mm(tool_d) + ", step: " + mm(step) +
                          ", allowance: " + mm(allowance),
                      rectangle(w, h, corner), rectangle(blank_w, blank_h, 0), tool_d, floor, step,
                      allowance);
    }
}

TEST(Milling, Chamfers) {
    // Where the flat of the chamfer is met by X+: its height rises from -size/tan(tip/2) at the
    // wall to 0 at `size` from it.
    struct Row {
        const char* call;
        Shape wall;  // positive where the material is gone before
        bool is_inner;
        double wall_x, size, tip_d, tip_deg;
    };
    const auto inside_out = [](const Shape& shape) -> Shape {
        return [shape](double x, double y) { return -shape(x, y); };
    };
    const Row rows[] = {
        {"chamfer_circle(d: 40mm, size: 2mm, tip_d: 3mm)", disc(40), false, 20, 2, 3, 90},
        {"chamfer_circle(d: 40mm, size: 1mm, tip: 60deg, below: 1mm)", disc(40), false, 20, 1, 0,
         60},
        {"chamfer_circle(d: 40mm, size: 2mm, tip_d: 3mm, where: inner)", inside_out(disc(40)), true,
         20, 2, 3, 90},
        {"chamfer_rect(w: 50mm, h: 30mm, size: 2mm, tip_d: 3mm)", rectangle(50, 30, 0), false, 25,
         2, 3, 90},
        {"chamfer_rect(w: 50mm, h: 30mm, size: 1.5mm, corner: 5mm, tip: 120deg, tip_d: 1mm, where: "
         "inner)",
         inside_out(rectangle(50, 30, 5)), true, 25, 1.5, 1, 120},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.call);
        Stock stock = plate();
        stock.lower_outside(row.wall, -10);
        stock.cut(commands_of("cycles.spigots", row.call), row.tip_d, row.tip_deg);
        expect_clean(stock);
        const double slope = 1 / std::tan(row.tip_deg / 2 * 3.14159265358979 / 180);
        const double outwards = row.is_inner ? 1 : -1;  // from the wall into the material
        for (double into : {0.125, 0.625, row.size - 0.375, row.size + 0.125, row.size + 1.125}) {
            const double expected = std::min(0.0, (into - row.size) * slope);
            EXPECT_NEAR(stock.height_at(row.wall_x + outwards * into, 0.125), expected, 0.02)
                << into;
        }
    }
}

TEST(Milling, ThreadsLeaveCoreAndWall) {
    Dice dice(9);
    for (int i = 0; i < 2 * kSets; ++i) {
        const double d = dice.length(8, 40), pitch = std::max(0.5, std::floor(d * 1.2) / 10);
        const bool is_outside = dice.coin();
        const double core = d - (is_outside ? 1.22687 : 1.0825) * pitch;
        const double tool_d =
            is_outside ? dice.length(4, 16) : dice.length(0.4 * core, 0.85 * core);
        const double floor = -dice.length(2, 15);
        const std::string call = std::string(is_outside ? "thread_mill_outside" : "thread_mill") +
                                 "(d: " + mm(d) + ", pitch: " + mm(pitch) + ", to: " + mm(floor) +
                                 ", tool_d: " + mm(tool_d) + ", cut: 200mm/min" +
                                 (dice.coin() ? ", left: true" : "") +
                                 (dice.coin() ? ", passes: 3" : "") + ")";
        SCOPED_TRACE(call);
        // A spigot, or a plate with a bore; what must stay is inside the core, or outside the
        // thread.
        const Shape thread = disc(is_outside ? d : core);
        const double side = is_outside ? 1 : -1;
        Stock stock(40, kCell, 0, [&](double x, double y) { return side * thread(x, y); });
        const std::vector<json> commands = commands_of("threads", call);
        expect_same_everywhere("threads", call, commands);
        stock.cut(commands, tool_d);
        expect_clean(stock);
        const Shape keep = disc(is_outside ? core : d);
        const Shape kept = [&](double x, double y) {
            const double distance = -side * keep(x, y);
            return distance > 0 ? distance : 0;
        };
        EXPECT_EQ(stock.difference(kept, 0, 0, 0.006), "");
        // Between core and diameter everything is gone.
        const double edge = (core + d) / 4;
        EXPECT_LT(stock.height_at(-edge, 0.1), floor + pitch);
        EXPECT_GT(stock.deepest_cut(), 0);
    }
}

TEST(Milling, ChamfersOfAnySize) {
    Dice dice(10);
    for (int i = 0; i < 2 * kSets; ++i) {
        const double w = dice.length(16, 50), h = dice.length(16, 50), size = dice.length(0.2, 2);
        const double tip_d = dice.length(0, 2), tip_deg = dice.length(60, 120);
        const bool is_inner = dice.coin(), is_round = dice.coin();
        const double corner = is_inner ? dice.length(3, 7) : dice.length(0, 7);
        const Shape wall = is_round ? disc(w) : rectangle(w, h, corner);
        const Shape gone = [&](double x, double y) { return is_inner ? -wall(x, y) : wall(x, y); };
        const std::string call =
            (is_round ? "chamfer_circle(d: " + mm(w)
                      : "chamfer_rect(w: " + mm(w) + ", h: " + mm(h) + ", corner: " + mm(corner)) +
            ", size: " + mm(size) + ", tip_d: " + mm(tip_d) + ", tip: " + json(tip_deg).dump() +
            "deg" + (is_inner ? ", where: inner)" : ")");
        SCOPED_TRACE(call);
        Stock stock = plate();
        stock.lower_outside(gone, -10);
        stock.cut(commands_of("cycles.spigots", call), tip_d, tip_deg);
        expect_clean(stock);
        const double slope = 1 / std::tan(tip_deg / 2 * 3.14159265358979 / 180);
        for (double x = -27.125; x < 28; x += 1.25) {
            for (double y = -27.125; y < 28; y += 1.25) {
                const double into = -gone(x, y);
                const bool is_beside_corner = !is_inner && !is_round && corner < 0.2;
                if (into < 0.05 || is_beside_corner) continue;
                EXPECT_NEAR(stock.height_at(x, y), std::min(0.0, (into - size) * slope), 0.03)
                    << x << ", " << y;
            }
        }
    }
}

}  // namespace

}  // namespace milling_test
