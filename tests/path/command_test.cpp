// Commands: the op is what a command is, whatever its slot held before, and copies share nothing.
#include "path/command.h"

#include <gtest/gtest.h>

#include "path/op_names.h"

namespace kadr::path::command_test {
namespace {

constexpr int kOps = static_cast<int>(Op::External) + 1;

TEST(Command, IsWhatItsOpSaysWhateverTheSlotHeld) {
    for (int before = 0; before < kOps; ++before) {
        for (int now = 0; now < kOps; ++now) {
            SCOPED_TRACE(before * 100 + now);
            Command command(static_cast<Op>(before));
            command.line = 7;
            command.become(static_cast<Op>(now));
            EXPECT_EQ(op_name(command.op()), op_name(static_cast<Op>(now)));
            EXPECT_EQ(command.is_motion(), is_motion(static_cast<Op>(now)));
            EXPECT_EQ(command.line, 7u);
        }
    }
}

TEST(Command, AMessageBecomesALineOfWhichNothingIsSaid) {
    Command command(Op::Message);
    command.message().text = "a text that is too long for the string to keep it in itself";
    command.become(Op::Line);
    EXPECT_EQ(command.motion().feed, 0);
    EXPECT_EQ(command.motion().moved, 0);
    EXPECT_EQ(command.motion().to, AxisValues{});
    EXPECT_FALSE(command.motion().contact);
    command.become(Op::Message);
    EXPECT_EQ(command.message().text, "");
}

TEST(Command, AnotherShapeLeavesTheMotion) {
    Command command(Op::Arc);
    Motion& motion = command.motion();
    motion.feed = 200;
    motion.arc().sweep = 1;
    motion.become(Op::Line);
    EXPECT_EQ(command.op(), Op::Line);
    EXPECT_EQ(motion.feed, 200);
    motion.become(Op::Arc);
    EXPECT_EQ(motion.arc().sweep, 0);  // of the new arc nothing is said
    motion.shape = ThreadShape{0.1, 90};
    EXPECT_EQ(command.op(), Op::Thread);
}

TEST(Command, CopiesShareNothing) {
    Command command(Op::Spline);
    command.motion().spline().degree = 2;
    command.motion().dynamics.made().feed = 0.5;
    OrientDetails details;
    details.angle = 1;
    command.motion().orient_details = details;
    Command copy = command;
    copy.motion().spline().degree = 3;
    copy.motion().dynamics->feed = 1;
    copy.motion().orient_plainly(OrientKind::Axes);
    EXPECT_EQ(command.motion().spline().degree, 2);
    EXPECT_EQ(command.motion().dynamics->feed, 0.5);
    EXPECT_EQ(command.motion().orientation().angle, 1);
    EXPECT_EQ(copy.motion().orientation().angle, 0);
}

TEST(Boxed, IsEqualWhereTheParts) {
    const Boxed<int> none;
    const Boxed<int> one = 1;
    EXPECT_TRUE(none == Boxed<int>() && one == Boxed<int>(1));
    EXPECT_FALSE(none == one || one == Boxed<int>(2));
    Boxed<int> other = one;
    other = none;
    EXPECT_FALSE(other);
    other = one;
    EXPECT_EQ(*other, 1);
}

TEST(CommandDeathTest, NoneIsReadAsAnother) {
    const Command line(Op::Line);
    EXPECT_DEATH(static_cast<void>(line.spindle()), "read as one of another kind");
    EXPECT_DEATH(static_cast<void>(line.motion().arc()), "read as one of another kind");
}

}  // namespace
}  // namespace kadr::path::command_test
