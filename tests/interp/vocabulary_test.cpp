// Tapping, ways to the reference point, scales and centres, functions of the machine's builder.
#include "bench.h"

namespace kadr::interp::vocabulary_test {
namespace {

using path::FeedMode;
using path::Op;
using path::SpindleMode;

// ------------------------------------------------------------------------------ tapping

TEST(Tapping, TheSpindleFollowsThePitchAndStandsAtTheEnd) {
    struct Row {
        const char* name;
        double pitch;
        SpindleMode in, out;
    };
    for (const Row& row : {Row{"right-hand", 1.25, SpindleMode::Cw, SpindleMode::Ccw},
                           Row{"left-hand", -1.25, SpindleMode::Ccw, SpindleMode::Cw}}) {
        SCOPED_TRACE(row.name);
        const Ran ran = run({fn(Function::SpindleStop),
                             Words().motion(Function::TapIn).z(-10).k(row.pitch).s(300),
                             Words().motion(Function::TapOut).z(2).k(row.pitch)});
        EXPECT_EQ(ran.codes(), "");
        ASSERT_EQ(ran.commands.size(), 7u);
        EXPECT_EQ(ran.commands[1].spindle().mode, row.in);
        EXPECT_EQ(ran.commands[1].spindle().speed, 300);
        EXPECT_EQ(ran.commands[2].op(), Op::Line);
        EXPECT_EQ(ran.commands[2].motion().feed_mode, FeedMode::PerRevolution);
        EXPECT_EQ(ran.commands[2].motion().feed, 1.25);
        EXPECT_EQ(ran.commands[3].spindle().mode, SpindleMode::Stop);
        EXPECT_EQ(ran.commands[4].spindle().mode, row.out);
        EXPECT_EQ(ran.commands[5].motion().to[2], 2);
        EXPECT_EQ(ran.commands[6].spindle().mode, SpindleMode::Stop);
    }
}

TEST(Tapping, NeedsAPitchAndASpeed) {
    const Words without_pitch = Words().motion(Function::TapIn).z(-10).s(300);
    EXPECT_EQ(run({without_pitch}).codes(), "K5242");
    EXPECT_EQ(run({Words().motion(Function::TapIn).z(-10).k(0).s(300)}).codes(), "K5242");
    // The spindle of the bench turns; S0 is a warning of its own.
    EXPECT_EQ(run({Words().motion(Function::TapIn).z(-10).k(1).s(0)}).codes(), "K5217 K5243");
}

TEST(Tapping, WithACompensatingChuckIsALineWhateverTheModalMotion) {
    const Ran ran = run({rapid().z(2), fn(Function::TapFloating).z(-10).f(375), Words().z(5)});
    ASSERT_EQ(ran.commands.size(), 3u);
    EXPECT_EQ(ran.commands[1].op(), Op::Line);
    EXPECT_EQ(ran.commands[1].motion().feed, 375);
    EXPECT_EQ(ran.commands[2].op(), Op::Rapid) << "the modal motion stays";
}

// As in dialects/iso.xml: to, pitch, retract, …, floating.
constexpr nc::CycleId kTap = 3;
constexpr std::size_t kTapParameters = 10;
constexpr std::size_t kPitch = 1;
constexpr std::size_t kFloating = 6;

class Asked final : public CycleExpander {
  public:
    std::unique_ptr<Stream<Block>> expand(const CycleCall& call) override {
        pitch = (call.given >> kPitch & 1u) != 0 ? call.arguments[kPitch] : -1;
        floating = (call.given >> kFloating & 1u) != 0 ? call.arguments[kFloating] : -1;
        return std::make_unique<BlockList>(std::vector<Block>{});
    }
    double pitch = 0;
    double floating = 0;
};

Words tap_cycle() { return Words().cycle(kTap, kTapParameters, {{0, -10}, {2, 2}, {6, 1}}); }

TEST(Tapping, ACycleTakesItsPitchFromTheFeed) {
    // mm/min divided by rpm: 1250 / 1000; under feed per revolution F itself.
    Asked asked;
    EXPECT_EQ(run({tap_cycle().f(1250)}, {.cycles = &asked}).codes(), "");
    EXPECT_DOUBLE_EQ(asked.pitch, 1.25);
    EXPECT_EQ(asked.floating, 1);
    EXPECT_EQ(run({fn(Function::FeedPerRevolution), fn(Function::TapRigid), tap_cycle().f(1.5)},
                  {.cycles = &asked})
                  .codes(),
              "");
    EXPECT_DOUBLE_EQ(asked.pitch, 1.5);
    EXPECT_EQ(asked.floating, 0) << "M29 gears the spindle";
    EXPECT_EQ(run({tap_cycle()}, {.cycles = &asked}).codes(), "K5242");
    EXPECT_EQ(run({tap_cycle().f(100).s(0)}, {.cycles = &asked}).codes(), "K5217 K5243");
}

// ------------------------------------------------------------------------------ reference points

machine::Machine mill_with_homes() {
    machine::Machine machine = mill();
    machine.axes[2].home = 400;
    machine.axes[2].further_homes[0] = 250;
    return machine;
}

std::string heights(const Ran& ran) {
    std::string out;
    for (const path::Command& command : ran.commands) {
        if (command.op() != Op::Rapid && command.op() != Op::Line) continue;
        out += (out.empty() ? "" : " ") + format_shortest(round_to(command.motion().to[2], 6));
        if (command.motion().machine_coordinates) out += 'm';
    }
    return out;
}

TEST(Reference, GoesOverTheProgrammedPlaceToTheMachinesPoint) {
    const interp::Setup setup{.machine = mill_with_homes()};
    const Words g28 = fn(Function::ReferenceReturn, {{0, 1}});
    const Words g30 = fn(Function::ReferenceReturn, {{0, 2}});
    EXPECT_EQ(heights(run({rapid().z(10), Words(g28).z(50)}, setup)), "10 50 400m");
    EXPECT_EQ(heights(run({rapid().z(10), Words(g28).ic(Slot::Z, 0)}, setup)), "10 400m")
        << "over the place where it stands: straight";
    EXPECT_EQ(heights(run({rapid().z(10), Words(g30).ic(Slot::Z, 0)}, setup)), "10 250m");
    EXPECT_EQ(heights(run({rapid().z(10), fn(Function::ReferencePoint, {{0, 2}, {3, 0}})}, setup)),
              "10 250m");
    EXPECT_EQ(heights(run({fn(Function::WorkOffset, {{0, 1}}), fn(Function::Tool, {{0, 1}}),
                           rapid().z(10), Words(g28).ic(Slot::Z, 0), Words().z(10)},
                          setup)),
              "15 400m 15")
        << "neither work offset nor length act at the point, and both do behind it";
}

TEST(Reference, UnknownPointsAndCyclesAreAlarms) {
    EXPECT_EQ(run({fn(Function::ReferenceReturn, {{0, 2}}).z(0)}).codes(), "K5237");
    EXPECT_EQ(run({fn(Function::ReferencePoint, {{0, 5}, {1, 0}})}).codes(), "K5237");
    Asked cycles;
    EXPECT_EQ(run({tap_cycle().f(100), fn(Function::ReferenceReturn).ic(Slot::Z, 0)},
                  {.rules = "<rule name=\"modal_cycles\" value=\"yes\"/>", .cycles = &cycles})
                  .codes(),
              "K5235");
}

// ------------------------------------------------------------------------------ frames

constexpr std::string_view kFanucFrames =
    "<rule name=\"rotate_outside_scale\" value=\"yes\"/><rule name=\"frame_center_at_tool\" "
    "value=\"yes\"/><rule name=\"scale_replaces\" value=\"yes\"/><rule name=\"rotate_replaces\" "
    "value=\"yes\"/>";

Words rotate_about(double angle, double x, double y) {
    return fn(Function::Rotate, {{0, angle}, {1, x}, {2, y}});
}

TEST(Frames, RotationAndScaleAboutACentre) {
    // G68 X10. Y0 R90.: (20, 0) is 10 to the right of the centre and comes 10 above it.
    EXPECT_EQ(end_of(run({rotate_about(90, 10, 0), rapid().x(20).y(0)})), "10.0000 10.0000 0.0000");
    // 10 + 2·(20 − 10), 5 + 2·(0 − 5)
    EXPECT_EQ(end_of(run({fn(Function::Scale, {{0, 2}, {1, 10}, {2, 5}}), rapid().x(20).y(0)})),
              "30.0000 -5.0000 0.0000");
    EXPECT_EQ(end_of(run({fn(Function::Scale, {{4, 2}, {5, 0.5}}), rapid().x(20).y(8).z(3)})),
              "40.0000 4.0000 3.0000");
    EXPECT_EQ(end_of(run({fn(Function::Scale, {{0, 2}}), fn(Function::ScaleOff), rapid().x(20)})),
              "20.0000 0.0000 0.0000");
}

TEST(Frames, FanucScalesThePointAndTheCentreBeforeItRotates) {
    // G51 X0 Y0 P2000, G68 X10. Y0 R90., X30. Y0: scaled to (60, 0), about (20, 0) → (20, 40).
    const interp::Setup fanuc{.rules = kFanucFrames};
    const Words twice = fn(Function::Scale, {{0, 2}, {1, 0}, {2, 0}, {3, 0}});
    EXPECT_EQ(end_of(run({twice, rotate_about(90, 10, 0), rapid().x(30).y(0)}, fanuc)),
              "20.0000 40.0000 0.0000");
    // Unequal: (10, 0) · (2, 1) = (20, 0), turned → (0, 20). In the program's order it would be
    // (10, 0) turned → (0, 10), scaled → (0, 10).
    const Words wide = fn(Function::Scale, {{4, 2}, {1, 0}, {2, 0}, {3, 0}});
    EXPECT_EQ(end_of(run({wide, rotate_about(90, 0, 0), rapid().x(10).y(0)}, fanuc)),
              "0.0000 20.0000 0.0000");
    EXPECT_EQ(end_of(run({wide, rotate_about(90, 0, 0), rapid().x(10).y(0)})),
              "0.0000 10.0000 0.0000");
    // A centre that is not named is where the tool stands.
    EXPECT_EQ(
        end_of(run({rapid().x(5).y(5), fn(Function::Rotate, {{0, 90}}), rapid().x(6).y(5)}, fanuc)),
        "5.0000 6.0000 0.0000");
}

TEST(Frames, NoArcUnderUnequalScale) {
    const Words wide = fn(Function::Scale, {{4, 2}});
    const Words arc = ccw().x(10).i(5).j(0).f(100);
    EXPECT_EQ(run({wide, arc}).codes(), "K5229");
    EXPECT_EQ(run({fn(Function::Scale, {{6, 2}}), arc}).codes(), "")
        << "along the tool axis a scale makes no ellipse";
    EXPECT_EQ(run({fn(Function::Scale, {{0, 0}})}).codes(), "K5236");
}

// ------------------------------------------------------------------------------ threads

Words thread() { return Words().motion(Function::Thread); }

TEST(Threads, AreLinesGearedToTheSpindle) {
    const Ran ran = run({rapid().x(20).z(5), thread().z(-30).k(1.5),
                         fn(Function::ThreadStart, {{0, 90}}).z(-40).k(1.5), rapid().x(30)});
    EXPECT_EQ(ran.codes(), "");
    ASSERT_EQ(ran.commands.size(), 4u);
    for (const std::size_t i : {1u, 2u}) {
        EXPECT_EQ(ran.commands[i].op(), Op::Thread) << "thread cutting is modal";
        EXPECT_EQ(ran.commands[i].motion().feed_mode, FeedMode::PerRevolution);
        EXPECT_EQ(ran.commands[i].motion().feed, 1.5);
    }
    EXPECT_EQ(ran.commands[1].motion().thread().start_deg, 0);
    EXPECT_EQ(ran.commands[2].motion().thread().start_deg, 90);
    EXPECT_EQ(ran.commands[2].motion().to[2], -40);
    EXPECT_NE(ran.listing().find("\"op\":\"thread\""), std::string::npos);
    EXPECT_NE(ran.listing().find("\"start\":90"), std::string::npos);
}

TEST(Threads, ThePitchCountsAlongTheLongerWay) {
    // 30 along X, 40 along Z: a path of 50; a turn of 2 along Z is 2.5 along the path.
    const Ran taper = run({rapid().x(0).z(0), thread().x(30).z(-40).k(2)});
    EXPECT_DOUBLE_EQ(taper.commands.back().motion().feed, 2.5);
    // Steeper than 45 degrees: along X. 40 and 30.
    const Ran face = run({rapid().x(0).z(0), thread().x(40).z(-30).i(2)});
    EXPECT_DOUBLE_EQ(face.commands.back().motion().feed, 2.5);
    EXPECT_EQ(run({rapid().x(0).z(0), thread().x(40).z(-30).k(2)}).codes(), "K5244");
    // At 45 degrees either will do, and a thread of no way needs none in particular.
    EXPECT_EQ(run({rapid().x(0).z(0), thread().x(30).z(-30).k(2)}).codes(), "");
    EXPECT_EQ(run({rapid().x(0).z(0), thread().x(30).z(-30).i(2)}).codes(), "");
    EXPECT_EQ(run({rapid().x(0).z(0), thread().z(0).k(2)}).codes(), "");
}

TEST(Threads, NeedAPitchAndATurningSpindle) {
    EXPECT_EQ(run({thread().z(-30)}).codes(), "K5244");
    EXPECT_EQ(run({thread().z(-30).k(0)}).codes(), "K5244");
    EXPECT_EQ(run({thread().z(-30).f(1.5)}).codes(), "K5244") << "F is no pitch here";
    EXPECT_EQ(run({fn(Function::SpindleStop), thread().z(-30).k(1)}).codes(), "K5214");
    EXPECT_EQ(run({fn(Function::CuttingSpeedOn).s(100), thread().z(-30).k(1), Words().z(-50).k(1)})
                  .codes(),
              "K5245")
        << "said once";
}

TEST(Threads, OfFanucHaveThePitchInF) {
    const interp::Setup fanuc{.rules = R"(<rule name="thread_pitch_is_feed" value="yes"/>)"};
    const Ran ran = run({thread().z(-30).f(1.5), Words().z(-40)}, fanuc);
    EXPECT_EQ(ran.codes(), "");
    EXPECT_EQ(ran.commands[0].motion().feed, 1.5);
    EXPECT_EQ(ran.commands[1].motion().feed, 1.5) << "F is modal";
    EXPECT_EQ(run({thread().z(-30)}, fanuc).codes(), "K5244");
    EXPECT_EQ(run({thread().z(-30).k(2).f(1.5)}, fanuc).codes(), "K5226");
}

// ------------------------------------------------------------------------------ probes

TEST(Probes, MoveAtFeedWhateverTheModalMotion) {
    const Ran ran = run({rapid().z(5), fn(Function::Probe).z(-10).f(100), Words().z(2)});
    EXPECT_EQ(ran.codes(), "K5951");  // nobody says where the surface is
    ASSERT_EQ(ran.commands.size(), 3u);
    EXPECT_EQ(ran.commands[1].op(), Op::Probe);
    EXPECT_EQ(ran.commands[1].motion().feed, 100);
    EXPECT_EQ(ran.commands[1].motion().to[2], -10) << "the probe triggers at the end of its way";
    EXPECT_TRUE(ran.commands[1].motion().exact_stop);
    EXPECT_EQ(ran.commands[2].op(), Op::Rapid);
    EXPECT_NE(ran.listing().find("\"op\":\"probe\""), std::string::npos);
}

TEST(Probes, DoNotNeedATurningSpindleButAFeed) {
    const Words stop = fn(Function::SpindleStop);
    EXPECT_EQ(run({stop, fn(Function::Probe).z(-10).f(100)}).codes(), "K5951");
    EXPECT_EQ(run({stop, fn(Function::Probe).z(-10)}).codes(), "K5210");
    EXPECT_EQ(
        run({stop, fn(Function::FeedPerRevolution), fn(Function::Probe).z(-10).f(0.1)}).codes(),
        "K5214");
}

TEST(Probes, WhatTheyFoundChangesNothingHere) {
    EXPECT_EQ(
        end_of(run({fn(Function::WorkOffset, {{0, 1}}), fn(Function::Probe).x(10).f(100),
                    fn(Function::ProbeCheck, {{0, 1}, {1, 10}}),
                    fn(Function::OffsetToEdge, {{0, 1}, {1, 1}, {2, 7}}), rapid().x(0).y(0).z(0)})),
        end_of(run({fn(Function::WorkOffset, {{0, 1}}), rapid().x(0).y(0).z(0)})));
}

// ------------------------------------------------------------------------------ presets

// As in dialects/iso.xml: x, z, depth, first, lead, taper, infeed, least, finish, allowance …
constexpr nc::CycleId kPasses = 11;
constexpr std::size_t kPassParameters = 11;

class Told final : public CycleExpander {
  public:
    std::unique_ptr<Stream<Block>> expand(const CycleCall& call) override {
        given = call.given;
        finish = call.arguments[8];
        return std::make_unique<BlockList>(std::vector<Block>{});
    }
    std::uint32_t given = 0;
    double finish = 0;
};

Words preset(double finish) {
    Block block = Words();
    block.cycle = kPasses;
    nc::Invocation* invocation = block.add(Function::CyclePreset, kPassParameters);
    block.set_argument(*invocation, 8, finish);
    return Words(block);
}

TEST(CyclePresets, HoldForTheCallsThatFollow) {
    Told told;
    const Words call =
        Words().cycle(kPasses, kPassParameters, {{0, 18}, {1, -20}, {2, 1}, {3, 0.3}, {4, 1.5}});
    EXPECT_EQ(run({call}, {.cycles = &told}).codes(), "");
    EXPECT_EQ(told.given, 0b11111u);
    EXPECT_EQ(run({preset(2), call}, {.cycles = &told}).codes(), "");
    EXPECT_EQ(told.given, 0b1'0001'1111u);
    EXPECT_EQ(told.finish, 2);
    EXPECT_EQ(run({preset(2), preset(3), call}, {.cycles = &told}).codes(), "");
    EXPECT_EQ(told.finish, 3) << "the last one holds";
    // What the call says itself is its own.
    const Words own = Words().cycle(kPasses, kPassParameters, {{0, 18}, {8, 5}});
    EXPECT_EQ(run({preset(2), own}, {.cycles = &told}).codes(), "");
    EXPECT_EQ(told.finish, 5);
}

TEST(ToolSelect, MayBringItsOffset) {
    // T0102: tool 1, whose offset 2 is 80 long; T0100 cancels it.
    const interp::Setup lathe{.rules =
                                  R"(<rule name="tool_select_changes" value="yes"/>
                                   <rule name="tool_change_stops_spindle" value="no"/>
                                   <rule name="tool_change_activates_length" value="no"/>)"};
    const Ran ran = run({fn(Function::ToolSelect, {{0, 1}, {1, 2}}), rapid().z(10),
                         fn(Function::ToolSelect, {{0, 1}, {1, 0}}), rapid().z(20)},
                        lathe);
    ASSERT_EQ(ran.commands.size(), 5u);
    EXPECT_EQ(ran.commands[0].op(), Op::Tool);
    EXPECT_EQ(ran.commands[1].op(), Op::ToolLength);
    EXPECT_EQ(ran.commands[1].tool_length().length, 80);
    EXPECT_EQ(ran.commands[3].op(), Op::ToolLength);
    EXPECT_EQ(ran.commands[3].tool_length().length, 0);
}

// ------------------------------------------------------------------------------ small words

TEST(MachineFunctions, ArePassedOverAndSaidOnce) {
    const Words m88 = fn(Function::MachineFunction, {{0, 88}});
    EXPECT_EQ(run({m88, m88, fn(Function::MachineFunction, {{0, 89}})}).codes(), "K5241 K5241");
}

TEST(Diameter, IsWhatTheProgramSays) {
    EXPECT_EQ(end_of(run({fn(Function::DiameterOn), rapid().x(50)})), "25.0000 0.0000 0.0000");
    EXPECT_EQ(end_of(run({fn(Function::DiameterOn), fn(Function::DiameterOff), rapid().x(50)})),
              "50.0000 0.0000 0.0000");
}

}  // namespace
}  // namespace kadr::interp::vocabulary_test
