// A command as a line of JSON.
#include "interp/listing.h"

#include <gtest/gtest.h>

namespace kadr::interp::listing_test {
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
    Command line(Op::Line);
    line.motion().to = {10, 0, -1.25};
    line.motion().feed = 200;
    line.line = 12;
    EXPECT_EQ(
        line_of(line, "part.kadr:34"),
        "{\"op\":\"line\",\"to\":{\"X\":10,\"Y\":0,\"Z\":-1.25,\"B\":0},\"feed\":200,\"iso\":12,"
        "\"src\":\"part.kadr:34\"}\n");
    line.motion().feed_mode = path::FeedMode::InverseTime;
    line.motion().exact_stop = true;
    line.line = 0;
    EXPECT_EQ(line_of(line),
              "{\"op\":\"line\",\"to\":{\"X\":10,\"Y\":0,\"Z\":-1.25,\"B\":0},\"feed\":200,"
              "\"feed_mode\":\"inverse_time\",\"exact_stop\":true}\n");
}

TEST(Listing, RoundedCornersAndCompressedLines) {
    const std::string begin =
        "{\"op\":\"line\",\"to\":{\"X\":0,\"Y\":0,\"Z\":0,\"B\":0},\"feed\":0";
    Command line(Op::Line);
    line.motion().blending = {path::BlendKind::Distance, false, 0.5};
    EXPECT_EQ(line_of(line), begin + ",\"blend_distance\":0.5}\n");
    line.motion().blending = {path::BlendKind::Tolerance, true, 0.02};
    line.motion().compress = 0.01;
    EXPECT_EQ(line_of(line),
              begin + ",\"blend_tolerance\":0.02,\"blend_tangents\":true,\"compress\":0.01}\n");
    line.motion().exact_stop = true;
    line.motion().compress = 0;
    EXPECT_EQ(line_of(line), begin + ",\"exact_stop\":true}\n");
}

TEST(Listing, Arc) {
    Command arc(Op::Arc);
    arc.motion().to = {1, 2, 3};
    arc.motion().arc().center = {0, 0.5, 3};
    arc.motion().plane = path::Plane::Zx;
    arc.motion().arc().normal = path::Vec3::UnitY();
    arc.motion().arc().is_clockwise = true;
    arc.motion().arc().turns = 2;
    arc.motion().feed = 0.1;
    arc.motion().feed_mode = path::FeedMode::PerRevolution;
    EXPECT_EQ(line_of(arc),
              "{\"op\":\"arc\",\"to\":{\"X\":1,\"Y\":2,\"Z\":3,\"B\":0},\"center\":[0,0.5,3],"
              "\"plane\":\"ZX\","
              "\"dir\":\"cw\",\"turns\":2,\"feed\":0.1,\"feed_mode\":\"per_revolution\"}\n");
    arc.motion().arc().turns = 0;
    arc.motion().arc().is_clockwise = false;
    arc.motion().plane = path::Plane::Yz;
    arc.motion().arc().normal = path::Vec3::UnitX();
    arc.motion().feed_mode = path::FeedMode::PerMinute;
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
        rapid.motion().to[0] = row.value;
        EXPECT_EQ(line_of(rapid), std::string("{\"op\":\"rapid\",\"to\":{\"X\":") + row.text +
                                      ",\"Y\":0,\"Z\":0,\"B\":0}}\n");
    }
}

TEST(Listing, TheOthers) {
    Command c(Op::Message);
    c.message().text = "say \"yes\"\n";
    EXPECT_EQ(line_of(c), "{\"op\":\"message\",\"text\":\"say \\\"yes\\\"\\n\"}\n");
    c.become(Op::Coolant);
    for (const auto& [mode, text] : {std::pair{path::CoolantMode::Off, "off"},
                                     {path::CoolantMode::Flood, "flood"},
                                     {path::CoolantMode::Mist, "mist"}}) {
        c.coolant().mode = mode;
        EXPECT_EQ(line_of(c), std::string("{\"op\":\"coolant\",\"mode\":\"") + text + "\"}\n");
    }
    c.become(Op::Spindle);
    c.spindle().mode = path::SpindleMode::Ccw;
    c.spindle().speed = 500;
    EXPECT_EQ(line_of(c), "{\"op\":\"spindle\",\"mode\":\"ccw\",\"speed\":500}\n");
    c.become(Op::Tool);
    c.tool().number = 7;
    EXPECT_EQ(line_of(c), "{\"op\":\"tool\",\"tool\":7}\n");
    c.become(Op::Rapid);
    c.motion().machine_coordinates = true;
    EXPECT_EQ(line_of(c),
              "{\"op\":\"rapid\",\"to\":{\"X\":0,\"Y\":0,\"Z\":0,\"B\":0},\"machine_coordinates\":"
              "true}\n");
    for (const auto& [op, name] :
         {std::pair{Op::Stop, "stop"}, {Op::OptionalStop, "optional_stop"}, {Op::End, "end"}}) {
        c.become(op);
        EXPECT_EQ(line_of(c), std::string("{\"op\":\"") + name + "\"}\n");
    }
}

}  // namespace
}  // namespace kadr::interp::listing_test
