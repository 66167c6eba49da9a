// What docs/warnings.md says: which words are warned of, where the warning stands in a program and
// in a text, and how it is silenced.
#include <filesystem>
#include <regex>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/common/process.h"

namespace warnings_test {

namespace {

namespace fs = std::filesystem;

/// A shop's mill: end mills of 20 and 12 mm, a drill; every tool has its length.
constexpr const char* kShop = R"(<?xml version="1.0" encoding="UTF-8"?>
<machine name="shop" title="the mill of a shop" tick="1 ms" max_feed="20 m/min" max_speed="12000 rpm"
         orient_time="0.5 s" tool_change_time="4 s">
  <axis name="X" limits="-1000..1000 mm" velocity="30 m/min" acceleration="5 m/s2" jerk="100 m/s3" home="0 mm"/>
  <axis name="Y" limits="-1000..1000 mm" velocity="30 m/min" acceleration="5 m/s2" jerk="100 m/s3" home="0 mm"/>
  <axis name="Z" limits="-1000..1000 mm" velocity="24 m/min" acceleration="4 m/s2" jerk="80 m/s3" home="0 mm"/>
  <tool number="1" name="end mill 20" length="120 mm" radius="10 mm"/>
  <tool number="2" name="end mill 12" length="95 mm" radius="5.98 mm"/>
  <tool number="4" name="drill" length="110 mm" radius="2 mm"/>
</machine>
)";

class Warnings : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("kadr-warnings-" + std::to_string(::getpid()));
        fs::create_directories(folder_);
        before_ = fs::current_path();
        fs::current_path(folder_);
        ASSERT_TRUE(kadr::write_file_whole("shop.xml", kShop));
    }
    void TearDown() override {
        fs::current_path(before_);
        fs::remove_all(folder_);
    }

    /// "4:5 K5970" for each message, in their order.
    static std::string said(const std::string& file, const std::string& text,
                            std::vector<std::string> words) {
        EXPECT_TRUE(kadr::write_file_whole(file, text));
        words.insert(words.begin(), KADR_BINARY);
        const std::string err = run_process(words).err;
        static const std::regex message(R"(\S+:(\d+:\d+): (?:warning|error|alarm)\[(K\d+)\])");
        std::string all;
        for (std::sregex_iterator at(err.begin(), err.end(), message), end; at != end; ++at) {
            if (!all.empty()) all += ", ";
            all += (*at)[1].str() + ' ' + (*at)[2].str();
        }
        return all;
    }
    static std::string checked(const std::string& program) {
        return said("part.kadr", program, {"check", "part.kadr", "-d", "fanuc", "-m", "shop.xml"});
    }

  private:
    fs::path folder_;
    fs::path before_;
};

TEST_F(Warnings, StandAtTheStatementOfTheProgram) {
    const std::string start = "program p() {\ntool(1); S1000 M3; G0 X0 Y0 Z5;\n";
    const struct {
        const char* statement;
        const char* wanted;
    } rows[] = {
        {"G95; G1 Z-20 F150;", "3:6 K5970"},
        {"G94; G1 Z-2 F0.2;", "3:6 K5971"},
        {"G1 Z-2 F500000;", "3:1 K5972"},
        {"G43 H4 Z3;", "3:1 K5973"},
        {"F100; G1 Z-5; tool(2);", "3:15 K5975"},
        {"tool(2); G91; G0 Z-20;", "3:15 K5976"},
        {"F100; G1 X9 Z-5; M5;", "3:18 K5981"},
        // What is right says nothing.
        {"G1 X9 Z-2 F100; G0 Z5; M5;", ""},
        {"G1 Z-2 F100; M5;", ""},
        {"G95; G1 Z-20 F0.15;", ""},
        {"G1 Z-2 F100; G0 Z5; tool(2); G0 Z5;", ""},
    };
    for (const auto& row : rows)
        EXPECT_EQ(checked(start + row.statement + "\nM30; }\n"), row.wanted) << row.statement;
}

TEST_F(Warnings, OfATextThatIsOnlyMadeAskForAMachine) {
    const std::string program =
        "program p() {\n    tool(1); S1000 M3; G0 X0 Y0 Z5;\n    G95; G1 Z-20 F150;\n    M30;\n}\n";
    EXPECT_EQ(said("part.kadr", program, {"expand", "part.kadr", "-d", "fanuc"}), "");
    EXPECT_EQ(said("part.kadr", program, {"expand", "part.kadr", "-d", "fanuc", "-m", "mill"}),
              "3:10 K5970");
    // The text is the same.
    const std::string plain = run_process({KADR_BINARY, "expand", "part.kadr", "-d", "fanuc"}).out;
    EXPECT_EQ(run_process({KADR_BINARY, "expand", "part.kadr", "-d", "fanuc", "-m", "mill"}).out,
              plain);
    EXPECT_NE(plain.find("F150."), std::string::npos);
}

TEST_F(Warnings, OfTheLibraryStandWhereItIsCalled) {
    EXPECT_EQ(checked("import cycles.milling;\nprogram p() {\n    tool(1); S1000 M3; G0 X0 Y0 Z5;\n"
                      "    F30000;\n    pocket_circle(d: 60mm, to: -2mm, tool_d: 20mm, step: 2mm,\n"
                      "                  plunge: 100mm/min);\n    M30;\n}\n"),
              "5:5 K5972");
}

TEST_F(Warnings, AreSilencedWithAReason) {
    EXPECT_EQ(checked("program p() {\n    tool(1); S1000 M3; G0 X0 Y0 Z5;\n"
                      "    G1 Z-1 F0.5;  // kadr: allow K5971 the touch-off crawls\n    M30;\n}\n"),
              "");
    const std::vector<std::string> check = {"check", "part.nc", "-d", "fanuc"};
    const std::string text = "%\nO1\nT2M6\nS1000M3\nG43H12Z10.%s\nM30\n%\n";
    const auto with = [&](const std::string& comment) {
        std::string all = text;
        return all.replace(all.find("%s"), 2, comment);
    };
    EXPECT_EQ(said("part.nc", with(""), check), "5:1 K5973");
    EXPECT_EQ(said("part.nc", with("(KADR: ALLOW K5973 UPPER EDGE)"), check), "");
    EXPECT_EQ(said("part.nc", with("(kadr: allow K5970, K5973)"), check), "");
    EXPECT_EQ(said("part.nc", with("(KADR: ALLOW K5971)"), check), "5:1 K5973");
    EXPECT_EQ(said("part.nc", with("(ALLOW K5973)"), check), "5:1 K5973");
}

TEST_F(Warnings, AreSaidWhereTheNextLineIsNotAllowed) {
    const std::vector<std::string> check = {"check", "part.mpf", "-d", "sinumerik"};
    const std::string head = "T1 D1 M6\nG0 X0 Y0 Z5\nS100 M3\nG1 Z-1 F0.5 ; kadr: allow K5971\n";
    EXPECT_EQ(said("part.mpf", head + "G1 X2 F100\nM30\n", check), "");
    EXPECT_EQ(said("part.mpf", head + "G1 Z-2 F0.5\nX5\nM30\n", check), "5:8 K5971");
    EXPECT_EQ(said("part.mpf", head + "X2\nX5\nM30\n", check), "5:1 K5971");
    EXPECT_EQ(said("part.kadr",
                   "program p() {\n    tool(1); S1000 M3; G0 X0 Y0 Z5;\n"
                   "    G1 Z-1 F0.5;  // kadr: allow K5971 the touch-off crawls\n"
                   "    G1 X5 F0.5;\n    M30;\n}\n",
                   {"run", "part.kadr", "-d", "sinumerik"}),
              "4:5 K5971");
}

TEST_F(Warnings, OfADiameterOnAMillThatNobodyHasNamed) {
    const std::string text = "T1 D1 M6\nG18 DIAMON\nG0 X50 Z5\nM30\n";
    EXPECT_EQ(said("turn.mpf", text, {"check", "turn.mpf", "-d", "sinumerik"}), "2:5 K5907");
    EXPECT_EQ(said("turn.mpf", text, {"check", "turn.mpf", "-d", "sinumerik", "-m", "mill"}), "");
    EXPECT_EQ(said("turn.mpf", text, {"check", "turn.mpf", "-d", "sinumerik", "-m", "lathe"}), "");
}

TEST_F(Warnings, OfACutterThatTheMachineHasNotAreErrorsWhereItRuns) {
    const std::string pocket =
        "import cycles.milling;\nprogram p() {\n    tool(TOOL); S1000 M3;\n"
        "    G0 X0 Y0 Z5; F300;\n    pocket_rect(w: 60mm, h: 40mm, to: -4mm,"
        " tool_d: 12mm, step: 2mm, plunge: 100mm/min);\n    M30;\n}\n";
    const auto of_tool = [&](const std::string& tool) {
        std::string all = pocket;
        return all.replace(all.find("TOOL"), 4, tool);
    };
    const std::vector<std::string> run = {"run", "part.kadr", "-d", "fanuc", "-m", "shop.xml"};
    const std::vector<std::string> expand = {"expand", "part.kadr", "-d",
                                             "fanuc",  "-m",        "shop.xml"};
    EXPECT_EQ(said("part.kadr", of_tool("1"), run), "5:5 K3650");
    EXPECT_EQ(said("part.kadr", of_tool("1"), expand), "5:5 K3651");
    EXPECT_EQ(said("part.kadr", of_tool("1"), {"expand", "part.kadr", "-d", "fanuc"}), "");
    // A cutter that was ground again, and a tool of which the machine knows no radius.
    EXPECT_EQ(said("part.kadr", of_tool("2"), run), "");
    EXPECT_EQ(said("part.kadr", of_tool("7"), {"expand", "part.kadr", "-d", "fanuc", "-m", "mill"}),
              "");
}

TEST_F(Warnings, OfASelectedToolSayThatNothingChangesIt) {
    const std::string program =
        "program p() {\nT2; S1000 M3; F100; G0 X0 Y0 Z5;\nG1 Z-1;\nM30; }\n";
    EXPECT_EQ(said("part.kadr", program, {"expand", "part.kadr", "-d", "fanuc"}), "3:1 K5265");
    EXPECT_EQ(said("part.kadr", program, {"expand", "part.kadr", "-d", "sinumerik"}), "3:1 K5265");
    // A turret comes with the T.
    EXPECT_EQ(
        said("part.kadr",
             "program p() {\nG18 DIAMON; T2; S1000 M3; F0.1 G95; G0 X20 Z5;\nG1 Z-1;\nM30; }\n",
             {"expand", "part.kadr", "-d", "sinumerik"}),
        "");
}

TEST_F(Warnings, OfPiAndOfRatiosKnowWhereANumberComesFrom) {
    const struct {
        const char* statement;
        const char* wanted;
    } rows[] = {
        {"G0 X=10mm*sin(pi/4);", "2:15 K2630"},
        {"real a = 3.14159/4; G0 X=10mm*sin(a);", "2:35 K2630"},
        {"real a = 0.7854; G0 X=10mm*cos(2*a);", "2:32 K2630"},
        {"angle a = pi/2; G0 X=10mm*cos(a);", "2:11 K2630"},
        {"for (int i : 1..4) G0 X=10mm*sin(2*pi*i/4);", "2:34 K2630"},
        {"length c = w/h; G0 X=c;", "2:12 K2631"},
        {"G0 X=w/h;", "2:4 K2631"},
        {"int n = 5; G0 X=n^2;", "2:17 K2632"},
        {"int n = 5; int mask = 2; G0 X=n^mask;", ""},
        {"int n = 5; G0 X=n^(1 << 1);", ""},
        // Degrees, radians with a unit, and what turns them into degrees.
        {"G0 X=10mm*sin(45);", ""},
        {"G0 X=10mm*sin(pi/4*1rad);", ""},
        {"real a = pi/4; G0 X=10mm*sin(a*180/pi);", ""},
        {"real a = pi/4; real k = 180/pi; G0 X=10mm*sin(k*a);", ""},
        {"real a = pi/4; a = 45; G0 X=10mm*sin(a);", ""},
        {"G0 X=10mm*sin(0.785) Y=pi*w/4;", ""},
        {"for (int i : 1..4) G0 X=10mm*sin(360*i/4);", ""},
        {"G0 X=10mm*sin(360*w/h) Y=w/h*1mm;", ""},
        {"real r = w/h; int n = 3; length c = 2*n; G0 X=c*r;", ""},
    };
    for (const auto& row : rows) {
        const std::string program = "program p(length w = 5mm, length h = 2mm) {\n" +
                                    std::string(row.statement) + "\nG0 Y=w Z=h; M30; }\n";
        EXPECT_EQ(said("part.kadr", program, {"check", "part.kadr"}), row.wanted) << row.statement;
    }
}

/// Raw text may change all of the modal state: the first message behind it names what the part
/// needs in the words of a program, and a line of these words is enough.
TEST_F(Warnings, BehindRawTextNameAllThatIsToBeSaidAgain) {
    const std::string head =
        "import cycles.milling;\nprogram p() {\n    tool(1); S1000 M3 F100; G0 X0 Y0 Z5;"
        "\n    raw \"G65 P9832\";\n    ";
    const std::string pocket =
        "pocket_rect(w: 60mm, h: 40mm, to: -4mm, tool_d: 12mm, step: 2mm, "
        "plunge: 100mm/min, initial: 5mm);\n    M30;\n}\n";
    const std::vector<std::string> for_fanuc = {"expand", "part.kadr", "-d", "fanuc"};
    const std::vector<std::string> for_sinumerik = {"expand", "part.kadr", "-d", "sinumerik"};
    const auto fixes = [](std::vector<std::string> words) {
        words.insert(words.begin(), KADR_BINARY);
        return run_process(words).err;
    };
    EXPECT_EQ(said("part.kadr", head + pocket, for_fanuc), "5:5 K3212");
    // A mill of FANUC has no word that says what X is.
    std::string err = fixes(for_fanuc);
    EXPECT_NE(err.find("whether `G90 G17 G40` acts, as `pocket_rect` needs"), std::string::npos)
        << err;
    EXPECT_NE(err.find("all at once what the part needs: `G90 G17 G40 G94 G97`, F, S, `shift();`"),
              std::string::npos)
        << err;
    EXPECT_EQ(said("part.kadr", head + pocket, for_sinumerik), "5:5 K3212");
    err = fixes(for_sinumerik);
    EXPECT_NE(err.find("whether `G90 G17 G40 DIAMOF` acts"), std::string::npos) << err;
    EXPECT_NE(err.find("`G90 G17 G40 DIAMOF G94 G97`, F, S, `shift();`"), std::string::npos) << err;
    EXPECT_EQ(said("part.kadr", head + "G90 G17 G40 G94 F100;\n    " + pocket, for_fanuc), "");
    EXPECT_EQ(
        said("part.kadr", head + "G90 G17 G40 DIAMOF G94 F100;\n    " + pocket, for_sinumerik), "");
    // A block names what it needs, and the rest with it.
    EXPECT_EQ(said("part.kadr", head + "G1 X10;\n    M30;\n}\n", for_fanuc), "5:5 K3212");
    EXPECT_NE(fixes(for_fanuc).find("`G90 G17 G40 G94 G97`, F, S"), std::string::npos);
}

/// What no warning says, a comparison does: without -m it takes a machine that is set up, so that a
/// length that is another tool's, none, or another work offset move the axes elsewhere.
TEST_F(Warnings, AreNotNeededWhereTwoTextsAreCompared) {
    const auto text = [](const std::string& offset, const std::string& length) {
        return "%\nO1\nT2M6\nS1000M3\n" + offset + "G0X0Y0\n" + length +
               "Z10.\nG1Z-1.F100.\nX20.\nG0Z50.\nM30\n%\n";
    };
    const auto status = [&](const std::string& other) {
        EXPECT_TRUE(kadr::write_file_whole("a.nc", text("G54", "G43H2")));
        EXPECT_TRUE(kadr::write_file_whole("b.nc", other));
        return run_process({KADR_BINARY, "compare", "a.nc", "b.nc", "-d", "fanuc"}).status;
    };
    EXPECT_EQ(status(text("G54", "G43H2")), 0);
    EXPECT_EQ(status(text("", "G43H02")), 0);
    EXPECT_EQ(status(text("G54", "G43H4")), 1);
    EXPECT_EQ(status(text("G54", "")), 1);
    EXPECT_EQ(status(text("G55", "G43H2")), 1);
}

/// M100 to M999 are the builder's on every control; a lower one that the control means itself is
/// his by a dialect.
TEST_F(Warnings, DoNotMeetTheMFunctionsOfTheBuilder) {
    const std::string program = "program p() { machine_function(NUMBER); M30; }\n";
    const auto of = [&](const std::string& number) {
        std::string all = program;
        return all.replace(all.find("NUMBER"), 6, number);
    };
    for (const char* dialect : {"iso", "fanuc", "sinumerik", "axioma", "fanuc-lathe"}) {
        for (const char* number : {"100", "117", "999"}) {
            EXPECT_EQ(said("part.kadr", of(number), {"expand", "part.kadr", "-d", dialect}), "");
            const std::string text =
                run_process({KADR_BINARY, "expand", "part.kadr", "-d", dialect}).out;
            const std::string word = std::string("M") + number;
            EXPECT_NE(text.find(word), std::string::npos) << dialect << text;
            EXPECT_EQ(said("part.nc", word + "\nM30\n", {"run", "part.nc", "-d", dialect}),
                      "1:1 K5241");
            const auto explained = run_process({KADR_BINARY, "dialect", "explain", dialect, word});
            EXPECT_NE(explained.out.find("machine_function"), std::string::npos) << explained.err;
        }
    }
    // M198 calls a program there.
    EXPECT_EQ(said("part.kadr", of("198"), {"expand", "part.kadr", "-d", "fanuc"}), "1:15 K4201");
    ASSERT_TRUE(
        kadr::write_file_whole("own.xml",
                               "<dialect name=\"own\" extends=\"fanuc\" title=\"t\" "
                               "suffix=\"nc\"><rules builder_codes=\"200..299\"/>"
                               "<unsupported words=\"M210\" meaning=\"a door\"/></dialect>"));
    for (const auto& [number, wanted] :
         {std::pair{"200", ""}, {"299", ""}, {"117", "1:15 K4201"}, {"210", "1:15 K4201"}})
        EXPECT_EQ(said("part.kadr", of(number), {"expand", "part.kadr", "-d", "own.xml"}), wanted);
    EXPECT_EQ(said("part.kadr", of("29"), {"expand", "part.kadr", "-d", "fanuc"}), "1:15 K4201");
    const std::string err = run_process({KADR_BINARY, "expand", "part.kadr", "-d", "fanuc"}).err;
    EXPECT_NE(err.find("`M29` is `tap_rigid` on this control"), std::string::npos) << err;
    EXPECT_NE(err.find("<remove commands=\"tap_rigid\"/>"), std::string::npos) << err;
    for (const auto& [number, note, fix] :
         {std::tuple{"98", "`M98` calls a program on this control", "by its name: `name(5mm);`"},
          {"99", "`M99` ends a call on this control", "`return;` leaves it"},
          {"97", "`M97` has a meaning of its own on this control", ""}}) {
        EXPECT_EQ(said("part.kadr", of(number), {"expand", "part.kadr", "-d", "fanuc"}),
                  "1:15 K4201");
        const std::string calls =
            run_process({KADR_BINARY, "expand", "part.kadr", "-d", "fanuc"}).err;
        EXPECT_NE(calls.find(note), std::string::npos) << calls;
        EXPECT_NE(calls.find(fix), std::string::npos) << calls;
        EXPECT_EQ(calls.find("machine builder's"), std::string::npos) << calls;
    }
}

}  // namespace

}  // namespace warnings_test
