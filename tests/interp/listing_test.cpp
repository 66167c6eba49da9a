// A command as a line of JSON.
#include "interp/listing.h"

#include <gtest/gtest.h>

namespace kadr::interp {
namespace {

using path::Command;
using path::Op;

std::string line_of(const Command& command, std::string_view source = {}) {
    machine::Machine machine;
    for (const Axis axis : {Axis::X, Axis::Y, Axis::Z, Axis::B}) {
        machine.axes.emplace_back().axis = axis;
    }
    std::string out;
    Listing(machine).append(command, source, out);
    return out;
}

TEST(Listing, Line) {
    Command line;
    line.op = Op::Line;
    line.to = {10, 0, -1.25};
    line.feed = 200;
    line.line = 12;
    EXPECT_EQ(
        line_of(line, "part.kadr:34"),
        "{\"op\":\"line\",\"to\":{\"X\":10,\"Y\":0,\"Z\":-1.25,\"B\":0},\"feed\":200,\"iso\":12,"
        "\"src\":\"part.kadr:34\"}\n");
    line.feed_mode = path::FeedMode::InverseTime;
    line.exact_stop = true;
    line.line = 0;
    EXPECT_EQ(line_of(line),
              "{\"op\":\"line\",\"to\":{\"X\":10,\"Y\":0,\"Z\":-1.25,\"B\":0},\"feed\":200,"
              "\"feed_mode\":\"inverse_time\",\"exact_stop\":true}\n");
}

TEST(Listing, RoundedCornersAndCompressedLines) {
    const std::string begin =
        "{\"op\":\"line\",\"to\":{\"X\":0,\"Y\":0,\"Z\":0,\"B\":0},\"feed\":0";
    Command line;
    line.op = Op::Line;
    line.blending = {path::BlendKind::Distance, false, 0.5};
    EXPECT_EQ(line_of(line), begin + ",\"blend_distance\":0.5}\n");
    line.blending = {path::BlendKind::Tolerance, true, 0.02};
    line.compress = 0.01;
    EXPECT_EQ(line_of(line),
              begin + ",\"blend_tolerance\":0.02,\"blend_tangents\":true,\"compress\":0.01}\n");
    line.exact_stop = true;
    line.compress = 0;
    EXPECT_EQ(line_of(line), begin + ",\"exact_stop\":true}\n");
}

TEST(Listing, Arc) {
    Command arc;
    arc.op = Op::Arc;
    arc.to = {1, 2, 3};
    arc.center = {0, 0.5, 3};
    arc.plane = path::Plane::Zx;
    arc.normal = path::Vec3::UnitY();
    arc.is_clockwise = true;
    arc.turns = 2;
    arc.feed = 0.1;
    arc.feed_mode = path::FeedMode::PerRevolution;
    EXPECT_EQ(line_of(arc),
              "{\"op\":\"arc\",\"to\":{\"X\":1,\"Y\":2,\"Z\":3,\"B\":0},\"center\":[0,0.5,3],"
              "\"plane\":\"ZX\","
              "\"dir\":\"cw\",\"turns\":2,\"feed\":0.1,\"feed_mode\":\"per_revolution\"}\n");
    arc.turns = 0;
    arc.is_clockwise = false;
    arc.plane = path::Plane::Yz;
    arc.normal = path::Vec3::UnitX();
    arc.feed_mode = path::FeedMode::PerMinute;
    EXPECT_EQ(line_of(arc),
              "{\"op\":\"arc\",\"to\":{\"X\":1,\"Y\":2,\"Z\":3,\"B\":0},\"center\":[0,0.5,3],"
              "\"plane\":\"YZ\","
              "\"dir\":\"ccw\",\"feed\":0.1}\n");
}

TEST(Listing, NumbersAreShortAndWithoutNoise) {
    struct Row {
        double value;
        const char* text;
    };
    for (const Row& row : {Row{0.1 + 0.2, "0.3"},
                           {-1e-15, "0"},
                           {-0.0, "0"},
                           {1.0 / 3, "0.333333333"},
                           {48.66025403784439, "48.660254038"},
                           {-2.5, "-2.5"},
                           {123456, "123456"},
                           {1e12, "1000000000000"}}) {
        Command rapid;
        rapid.to[0] = row.value;
        EXPECT_EQ(line_of(rapid), std::string("{\"op\":\"rapid\",\"to\":{\"X\":") + row.text +
                                      ",\"Y\":0,\"Z\":0,\"B\":0}}\n");
    }
}

TEST(Listing, TheOthers) {
    Command c;
    c.op = Op::Message;
    c.text = "say \"yes\"\n";
    EXPECT_EQ(line_of(c), "{\"op\":\"message\",\"text\":\"say \\\"yes\\\"\\n\"}\n");
    c.op = Op::Coolant;
    for (const auto& [mode, text] : {std::pair{path::CoolantMode::Off, "off"},
                                     {path::CoolantMode::Flood, "flood"},
                                     {path::CoolantMode::Mist, "mist"}}) {
        c.coolant = mode;
        EXPECT_EQ(line_of(c), std::string("{\"op\":\"coolant\",\"mode\":\"") + text + "\"}\n");
    }
    c.op = Op::Spindle;
    c.spindle = path::SpindleMode::Ccw;
    c.speed = 500;
    EXPECT_EQ(line_of(c), "{\"op\":\"spindle\",\"mode\":\"ccw\",\"speed\":500}\n");
    c.op = Op::Tool;
    c.tool = 7;
    EXPECT_EQ(line_of(c), "{\"op\":\"tool\",\"tool\":7}\n");
    c.op = Op::Rapid;
    c.machine_coordinates = true;
    EXPECT_EQ(line_of(c),
              "{\"op\":\"rapid\",\"to\":{\"X\":0,\"Y\":0,\"Z\":0,\"B\":0},\"machine_coordinates\":"
              "true}\n");
    for (const auto& [op, name] :
         {std::pair{Op::Stop, "stop"}, {Op::OptionalStop, "optional_stop"}, {Op::End, "end"}}) {
        c.op = op;
        EXPECT_EQ(line_of(c), std::string("{\"op\":\"") + name + "\"}\n");
    }
}

}  // namespace
}  // namespace kadr::interp
