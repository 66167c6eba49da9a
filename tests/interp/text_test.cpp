// Programs as the control reads them: text → Reader → Interpreter, with each dialect's own rules.
// The rows are those of the references: sinumerik.md 15, fanuc.md 12.
#include "base/diagnostics/iso.h"
#include "text_bench.h"

namespace kadr::interp::text_test {
namespace {

TEST(Text, Sinumerik) {
    struct Row {
        const char* name;
        const char* text;
        const char* alarms;
        const char* end;
    };
    const std::string start = "M3 S1000\n";
    for (const Row& row : std::initializer_list<Row>{
             {"15.1", "G17 G90 G1 X10 Y10 F500\nX=IC(5)\nG91 X5 Y=AC(0)\nX-2.5\n", "",
              "17.5000 0.0000 0.0000"},
             {"IC after TRANS", "G0 X1\nTRANS X100\nX=IC(1)\n", "", "102.0000 0.0000 0.0000"},
             {"TRANS, AROT", "TRANS X40 Y25\nAROT RPL=30\nG0 X10 Y0\n", "",
              "48.6603 30.0000 0.0000"},
             {"TRANS deletes", "AROT RPL=30\nTRANS\nG0 X10 Y0\n", "", "10.0000 0.0000 0.0000"},
             {"14040", "G0 X20 Y0\nG3 X0 Y20.05 I-20 J0 F100\n", "14040", "20.0000 0.0000 0.0000"},
             {"centre shifted", "G0 X20 Y0\nG3 X0 Y20.01 I-20 J0 F100\n", "",
              "0.0000 20.0100 0.0000"},
             {"CR with start = end", "G0 X20 Y0\nG3 X20 Y0 CR=20 F100\n", "14040",
              "20.0000 0.0000 0.0000"},
             {"CR too small", "G0 X20 Y0\nG3 X0 Y20 CR=14 F100\n", "14095",
              "20.0000 0.0000 0.0000"},
             {"no feed", "G1 X10\n", "10860", "no motion"},
             {"feed deleted", "G1 X10 F100\nG95\nX20\n", "10860", "10.0000 0.0000 0.0000"},
             {"F0", "G1 X10 F0\n", "14800", "no motion"},
             {"software limit", "G0 X1001\n", "10720", "no motion"},
             {"inch", "G70\nG0 X1\n", "", "25.4000 0.0000 0.0000"},
             {"SUPA is not this; G53 suppresses frames", "G54 G0 X0\nG53 X5\n", "",
              "5.0000 0.0000 0.0000"}}) {
        SCOPED_TRACE(row.name);
        const Ran ran = read("sinumerik", start + row.text + "M30\n");
        EXPECT_EQ(alarms(ran), row.alarms);
        EXPECT_EQ(end_of(ran), row.end);
    }
}

TEST(Text, Fanuc) {
    struct Row {
        const char* name;
        const char* text;
        const char* alarms;
        const char* end;
    };
    machine::Machine machine = mill();
    machine.work_offsets = {{}, {-300, 0, 0}, {10, 0, 0}};
    const std::string start = "%\nO0001\nM3 S1000\n";
    for (const Row& row : std::initializer_list<Row>{
             {"G52", "G90 G54\nG52 X10.\nG0 X20.\n", "", "-270.0000 0.0000 0.0000"},
             {"behind a line that cannot be read", "G0 X5.\nG0 X\nX7.\n", "PS0005",
              "-295.0000 0.0000 0.0000"},
             {"increments", "G0 X1000\n", "", "-299.0000 0.0000 0.0000"},
             {"over tolerance", "G0 X20. Y0\nG3 X0 Y20.05 I-20. F100.\n", "PS0020",
              "-280.0000 0.0000 0.0000"},
             {"R, no chord: no motion", "G0 X20. Y0\nG3 X20. Y0 R20. F100.\n", "",
              "-280.0000 0.0000 0.0000"},
             {"R is used", "G0 X20. Y0\nG3 X0 Y20. R20. I-7. F100.\n", "",
              "-300.0000 20.0000 0.0000"},
             {"no IJK: a line", "G0 X20. Y0\nG3 X0 Y20. F100.\n", "K5909",
              "-300.0000 20.0000 0.0000"},
             {"no feed", "G1 X10.\n", "PS0011", "no motion"},
             {"feed kept", "G1 X10. F100.\nG95\nX20.\n", "K5970", "-280.0000 0.0000 0.0000"},
             {"G93", "G93 G1 X10. F2.\nX20.\n", "PS1202", "-290.0000 0.0000 0.0000"},
             {"G53 is rapid", "G1 F100. X1.\nG90 G53 X0\n", "", "0.0000 0.0000 0.0000"},
             {"G90 beside G53 acts in its block", "G91 G28 Z0\nG90 G53 X0\n", "",
              "0.0000 0.0000 0.0000"}}) {
        SCOPED_TRACE(row.name);
        const Ran ran = read("fanuc", start + row.text + "M30\n%\n", machine);
        EXPECT_EQ(alarms(ran), row.alarms);
        EXPECT_EQ(end_of(ran), row.end);
    }
}

TEST(Text, AlarmsStandAtTheWord) {
    const Ran ran = read("sinumerik", "N10 M3 S1000\nN20 G1 X10 F0\nM30\n");
    ASSERT_EQ(ran.messages.size(), 1u);
    ASSERT_TRUE(ran.messages[0].line);
    EXPECT_EQ(ran.messages[0].line->file, "test.nc");
    EXPECT_EQ(ran.messages[0].line->line, 2u);
    EXPECT_EQ(ran.messages[0].line->column, 12u);
    EXPECT_EQ(ran.messages[0].line->text, "N20 G1 X10 F0");
}

TEST(Text, AProgramWithoutAnEnd) {
    const Ran sinumerik = read("sinumerik", "G0 X1\n");
    EXPECT_EQ(sinumerik.messages.size(), 1u);
    EXPECT_EQ(sinumerik.messages.at(0).row, &diag::EndMissing);
    EXPECT_EQ(alarms(read("fanuc", "%\nO0001\nG0 X1.\n%\n")), "PS5010");
}

TEST(Text, ToolLengthIsTheSameForAll) {
    // Each control's way to say tool(2); the commands are the same.
    const std::string expected =
        "{\"op\":\"tool\",\"tool\":2}\n"
        "{\"op\":\"rapid\",\"to\":{\"X\":1,\"Y\":0,\"Z\":0,\"C\":0}}\n"
        "{\"op\":\"tool_length\",\"tool\":2,\"length\":80}\n"
        "{\"op\":\"rapid\",\"to\":{\"X\":1,\"Y\":0,\"Z\":50,\"C\":0}}\n"
        "{\"op\":\"end\"}\n";
    machine::Machine machine = mill();
    machine.work_offsets.clear();
    EXPECT_EQ(read("sinumerik", "T2 D1\nM6\nG64 G0 X1\nZ50\nM30\n", machine).listing(), expected);
    EXPECT_EQ(read("iso", "T2 M6\nG64 G0 X1\nZ50\nM30\n", machine).listing(), expected);
    EXPECT_EQ(read("fanuc", "O1\nT02 M06\nG64 G00 X1.\nG43 H02 Z50.\nM30\n", machine).listing(),
              expected);
}

TEST(Text, WarningsThatSaveASpindle) {
    machine::Machine changer = mill();
    changer.tool_change_time = 4;
    struct Row {
        const char* name;
        const char* text;
        const char* codes;
    };
    for (const Row& row : {
             Row{"down at rapid, spindle stopped", "T1 M6\nG0 Z5\nG0 Z-1\nM30\n", "K5264"},
             {"said once", "T1 M6\nG0 Z-1\nG0 Z-2\nM30\n", "K5264"},
             {"said anew", "T1 M6\nG0 Z-1\nG0 Z5\nS500 M3\nM5\nG0 Z-2\nG0 Z-3\nM30\n",
              "K5264 K5264"},
             {"up again", "T1 M6\nS500 M3\nG0 Z-5\nM5\nG0 Z-1\nM30\n", ""},
             {"along", "T1 M6\nS500 M3\nG0 Z-5\nM5\nG0 X10\nM30\n", ""},
             {"spindle on", "T1 M6\nS500 M3\nG0 Z-5\nM30\n", ""},
             {"not into the work", "T1 M6\nG18\nG0 Z-5\nM30\n", ""},
             {"a cut without a tool", "S500 M3\nG1 X5 F100\nG1 X6\nM30\n", "K5265"},
             {"with a tool", "T1 M6\nS500 M3\nG1 X5 F100\nM30\n", ""},
             {"units change on the way", "G21\nG0 X5\nG20\nG0 X1\nG21\nM30\n", "K5266"},
             {"units said again", "G21\nG0 X5\nG21\nG0 X1\nM30\n", ""},
             {"units before all motion", "G20\nG21\nG0 X5\nM30\n", ""},
         }) {
        SCOPED_TRACE(row.name);
        EXPECT_EQ(alarms(read("iso", row.text, changer)), row.codes);
    }
    // Behind G69 a FANUC wants a coordinate first.
    const std::string rotated = "G90 G17 G00 X0 Y0\nG68 X0 Y0 R30.\nX10. Y0\nG69\n";
    EXPECT_EQ(alarms(read("fanuc", rotated + "G91 X5.\nM30\n")), "K5267");
    EXPECT_EQ(alarms(read("fanuc", rotated + "G91 Z5.\nG90 X5.\nG91 X5.\nM30\n")), "");
    EXPECT_EQ(alarms(read("sinumerik", "G0 X0 Y0\nROT RPL=30\nX10 Y0\nROT\nG91 X5\nM30\n")), "");
    // A name that the table does not have is a tool all the same: it is changed, and known again.
    const Ran named =
        read("sinumerik", "T=\"MILL\" D1\nM6\nS500 M3\nG1 X5 F100\nT=\"MILL\"\nM6\nM30\n", changer);
    EXPECT_EQ(alarms(named), "K5240");
    EXPECT_NE(named.listing().find("tool"), std::string::npos) << named.listing();
    // A machine that changes no tools has the one that is in it.
    EXPECT_EQ(alarms(read("iso", "S500 M3\nG1 X5 F100\nM30\n")), "");
}

}  // namespace
}  // namespace kadr::interp::text_test
