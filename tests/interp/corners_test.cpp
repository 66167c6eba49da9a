// Chamfers and roundings, polar coordinates and contours by angles beside cycles, compensation and
// each other; what each rule of the manuals does alone is in tests/control.
#include <random>

#include "base/diagnostics/iso.h"
#include "base/units.h"
#include "path/contour_corner.h"
#include "text_bench.h"

namespace kadr::interp::corners_test {
namespace {

using path::Element;
using path::Op;
using path::Vec2;

const std::string kStart = "M3 S1000 F200\nG0 X0 Y0\n";

Vec2 end_of(const path::Command& command) {
    return {command.motion().to[0], command.motion().to[1]};
}

/// The motions behind the first one as elements of the plane X-Y.
path::Contour contour_of(const Ran& ran) {
    path::Contour contour;
    std::optional<Vec2> at;
    for (const path::Command& command : ran.commands) {
        if (!command.is_motion()) continue;
        const Vec2 to = end_of(command);
        if (at && command.op() == Op::Arc) {
            contour.push_back(path::arc_element(
                *at, to, {command.motion().arc().center[0], command.motion().arc().center[1]},
                command.motion().arc().is_clockwise));
        } else if (at) {
            contour.push_back(path::line_element(*at, to));
        }
        at = to;
    }
    return contour;
}

std::string number(double value) {
    std::string text;
    append_shortest(text, round_to(value, 4));
    return text;
}

/// A random way of lines and arcs that keeps its sides long and its corners open.
struct RandomWay {
    std::string text;
    std::size_t corners = 0;
};

RandomWay random_way(std::mt19937& random, const std::string& corner, bool has_arcs) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    RandomWay way{kStart, 0};
    Vec2 at = Vec2::Zero();
    double heading = between(-3, 3);
    const int sides = 8;
    for (int i = 0; i < sides; ++i) {
        const double length = between(30, 50);
        const bool is_arc = has_arcs && i % 2 == 1;
        const Vec2 to = at + length * Vec2(std::cos(heading), std::sin(heading));
        way.text += is_arc ? (between(-1, 1) < 0 ? "G2" : "G3") : "G1";
        way.text += " X" + number(to.x()) + " Y" + number(to.y());
        if (is_arc) way.text += " CR=" + number(between(60, 120));
        if (i + 1 < sides) {
            way.text += ' ' + corner;
            ++way.corners;
        }
        way.text += '\n';
        at = to;
        // Corners between 40 and 120 degrees: an arc beside one turns by less than 25 more.
        heading += (between(-1, 1) < 0 ? -1 : 1) * between(0.7, 2.1);
    }
    way.text += "M30\n";
    return way;
}

TEST(Corners, RoundingsGoOnWithoutACorner) {
    std::mt19937 random(41);
    for (int i = 0; i < 200; ++i) {
        const RandomWay way = random_way(random, "RND=3", i % 2 == 1);
        SCOPED_TRACE(way.text);
        const Ran ran = read("sinumerik", way.text);
        ASSERT_EQ(alarms(ran), "");
        const path::Contour contour = contour_of(ran);
        ASSERT_EQ(contour.size(), 8 + way.corners);
        std::size_t roundings = 0;
        for (std::size_t k = 1; k < contour.size(); ++k) {
            EXPECT_NEAR(path::turn_between(contour[k - 1], contour[k]), 0, 1e-6);
            const bool is_rounding =
                contour[k].is_arc() && std::abs(path::radius(contour[k]) - 3) < 1e-6;
            roundings += is_rounding ? 1 : 0;
        }
        EXPECT_EQ(roundings, way.corners);
    }
}

TEST(Corners, ChamfersHaveTheirLengthAndLieEvenly) {
    std::mt19937 random(42);
    for (int i = 0; i < 200; ++i) {
        const bool is_length = i % 4 < 2;
        const RandomWay way = random_way(random, is_length ? "CHF=4" : "CHR=4", i % 2 == 1);
        const RandomWay plain = way;
        SCOPED_TRACE(way.text);
        const Ran ran = read("sinumerik", way.text);
        ASSERT_EQ(alarms(ran), "");
        std::string text = way.text;
        const std::string corner = is_length ? " CHF=4" : " CHR=4";
        for (std::size_t at = text.find(corner); at != std::string::npos; at = text.find(corner))
            text.erase(at, corner.size());
        const path::Contour sharp = contour_of(read("sinumerik", text));
        const path::Contour contour = contour_of(ran);
        ASSERT_EQ(contour.size(), sharp.size() + way.corners);
        for (std::size_t k = 1; k < contour.size(); k += 2) {
            const Element& chamfer = contour[k];
            const Vec2& tip = sharp[(k - 1) / 2].to;
            const double before = (chamfer.from - tip).norm();
            const double behind = (chamfer.to - tip).norm();
            EXPECT_NEAR(before, behind, 1e-6);
            EXPECT_NEAR(is_length ? path::length(chamfer) : before, 4, 1e-6);
            EXPECT_NEAR(path::nearest(sharp[(k - 1) / 2], chamfer.from).distance, 0, 1e-6);
            EXPECT_NEAR(path::nearest(sharp[(k + 1) / 2], chamfer.to).distance, 0, 1e-6);
        }
    }
}

TEST(Corners, ThroughTheCompensationTheCutterKeepsItsDistance) {
    std::mt19937 random(43);
    machine::Machine machine = mill();
    machine.tools[0].length = 0;
    for (int i = 0; i < 60; ++i) {
        // A convex part, from outside: every corner opens.
        const double r = std::uniform_real_distribution<double>(2, 6)(random);
        std::string text = "T1 D1 M6\nM3 S1000 F200\nG0 X-30 Y-30\nG41 G1 X0 Y0\n";
        text += "Y50 RND=" + number(r) + "\nX60 CHR=" + number(r) + "\nY-20 RND=" + number(r) +
                "\nX0\nG40 X-30 Y-30\nM30\n";
        SCOPED_TRACE(text);
        const Ran ran = read("sinumerik", text, machine);
        ASSERT_EQ(alarms(ran), "");
        const path::Contour part = {
            path::line_element({0, 0}, {0, 50 - r}),
            path::arc_element({0, 50 - r}, {r, 50}, {r, 50 - r}, true),
            path::line_element({r, 50}, {60 - r, 50}),
            path::line_element({60 - r, 50}, {60, 50 - r}),
            path::line_element({60, 50 - r}, {60, -20 + r}),
            path::arc_element({60, -20 + r}, {60 - r, -20}, {60 - r, -20 + r}, true),
            path::line_element({60 - r, -20}, {0, -20}),
        };
        const path::Contour cutter = contour_of(ran);
        ASSERT_GT(cutter.size(), 4u);
        for (std::size_t k = 1; k + 1 < cutter.size(); ++k) {
            for (double share = 0; share <= 1; share += 0.125) {
                EXPECT_NEAR(path::nearest(part, path::point_at(cutter[k], share)).distance, 5,
                            1e-3);
            }
        }
    }
}

TEST(Corners, BetweenTwoArcs) {
    // Two circles of radius 20 meet at X0 Y0: the rounding touches both.
    const Ran ran = read("sinumerik",
                         "M3 S1000 F200\nG0 X-20 Y-20\nG2 X0 Y0 CR=20 RND=4\n"
                         "G2 X20 Y-20 I0 J-20\nM30\n");
    EXPECT_EQ(alarms(ran), "") << "the way goes on in one direction: nothing to round";
    const Ran corner = read("sinumerik",
                            "M3 S1000 F200\nG0 X-20 Y20\nG3 X0 Y0 CR=20 RND=4\n"
                            "G3 X20 Y20 I0 J40 AR=30\nM30\n");
    EXPECT_EQ(alarms(corner), "14900");
    const Ran round = read("sinumerik",
                           "M3 S1000 F200\nG0 X-30 Y0\nG2 X0 Y0 CR=25 RND=2\n"
                           "G2 X30 Y0 CR=25\nM30\n");
    ASSERT_EQ(alarms(round), "");
    const path::Contour contour = contour_of(round);
    ASSERT_EQ(contour.size(), 3u);
    EXPECT_NEAR(path::turn_between(contour[0], contour[1]), 0, 1e-9);
    EXPECT_NEAR(path::turn_between(contour[1], contour[2]), 0, 1e-9);
    EXPECT_NEAR(path::radius(contour[1]), 2, 1e-9);
    EXPECT_GT(contour[1].sweep, 0) << "the corner turns left";
}

TEST(Corners, ModalRoundingSaysNothingWhereThereIsNoCorner) {
    const Ran ran =
        read("sinumerik", kStart + "G1 X20 RNDM=2\nG33 Z-10 K1\nG1 X40\nY10\nZ5\nM30\n");
    EXPECT_EQ(alarms(ran), "");
    const path::Contour contour = contour_of(ran);
    std::size_t arcs = 0;
    for (const Element& element : contour) arcs += element.is_arc() ? 1 : 0;
    EXPECT_EQ(arcs, 1u) << "between X40 and Y10 only";
}

TEST(Corners, WhatDoesNotFitIsMadeSmallerAndSaid) {
    struct Row {
        const char* corner;
        double made;
    };
    // Sides of 40 and 10 mm at a right angle.
    for (const Row& row : {Row{"RND=50", 10}, {"CHR=50", 10}, {"CHF=50", 14.1421}}) {
        SCOPED_TRACE(row.corner);
        const Ran ran = read("sinumerik", kStart + "G1 X40 " + row.corner + "\nY10\nX0\nM30\n");
        ASSERT_EQ(ran.messages.size(), 1u);
        EXPECT_EQ(ran.messages[0].row, &diag::CornerReduced);
        EXPECT_EQ(ran.messages[0].message(), "the chamfer or rounding is made smaller: " +
                                                 number(row.made) + " instead of 50");
        const path::Contour contour = contour_of(ran);
        ASSERT_EQ(contour.size(), 3u) << "nothing is left of Y10";
        EXPECT_NEAR((contour[1].to - Vec2(40, 10)).norm(), 0, 1e-6);
    }
}

TEST(Corners, UnderInverseTimeThePiecesKeepTheSpeed) {
    const Ran ran = read("sinumerik", "M3 S1000\nG0 X0 Y0\nG93 G1 X40 F2 CHR=10\nY40 F2\nM30\n");
    ASSERT_EQ(alarms(ran), "");
    std::vector<double> speeds;
    Vec2 at = Vec2::Zero();
    for (const path::Command& command : ran.commands) {
        if (command.op() == Op::Line)
            speeds.push_back((end_of(command) - at).norm() * command.motion().feed);
        if (command.is_motion()) at = end_of(command);
    }
    ASSERT_EQ(speeds.size(), 3u);
    EXPECT_NEAR(speeds[0], 80, 1e-9);
    EXPECT_NEAR(speeds[2], 80, 1e-9);
}

TEST(Corners, WhatStandsBetweenWaitsAndKeepsItsOrder) {
    const Ran ran = read("sinumerik", kStart + "G1 X20 RND=2 M8\nM9\nY20 M8\nM30\n");
    ASSERT_EQ(alarms(ran), "");
    std::string order;
    for (const path::Command& command : ran.commands) {
        order += command.op() == Op::Line      ? 'L'
                 : command.op() == Op::Arc     ? 'A'
                 : command.op() == Op::Coolant ? 'c'
                 : command.op() == Op::Rapid   ? 'R'
                                               : ' ';
    }
    EXPECT_EQ(order, " RcLccAL ");
}

TEST(Polar, WordsOfACycleTurnOnWithEveryRepetition) {
    class Places final : public CycleExpander {
      public:
        std::unique_ptr<Stream<Block>> expand(const CycleCall& call) override {
            at.push_back(number(call.position[0]) + ' ' + number(call.position[1]));
            return std::make_unique<BlockList>(std::vector<Block>{});
        }
        std::vector<std::string> at;
    } places;
    Sources sources;
    DiagnosticList messages;
    const auto dialect = nc::load_dialect("fanuc", {KADR_ROOT "/dialects"}, sources, messages);
    ASSERT_TRUE(dialect.has_value());
    Text text("S1000 M03\nG17 G90 G16\nG81 X50. Y30. Z-10. R2. F100.\nG91 Y60. K2\nG15 G80\nM30\n");
    nc::Reader reader(*dialect, text, "test.nc", messages);
    const machine::Machine machine = mill();
    Interpreter interpreter(*dialect, machine, reader, &reader, &places, {}, messages);
    std::vector<path::Command> batch(16);
    while (interpreter.pull(batch) > 0) continue;
    EXPECT_EQ(places.at, (std::vector<std::string>{"43.3013 25", "0 50", "-43.3013 25"}));
}

}  // namespace
}  // namespace kadr::interp::corners_test
