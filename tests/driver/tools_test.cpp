// The tool library: what is wrong with a file and where, what programs ask of it, what a run makes
// of it, and the set-up sheet.
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace tools_test {

namespace {

using kadr::read_file;

const std::string kHead =
    "number,name,kind,d,r,length,flutes,tip_angle,pitch,holder,material,vc,fz,f\n";
const std::string kCsv = kHead +
                         "3,MILL_10,end mill,10,,88,4,,,ER32,steel,120,0.05,\n"
                         ",,,,,,,,,,brass,200,0.1,\n"
                         "5,DRILL_5,drill,5,,112,2,140,,,,80,,0.1\n";
const std::string kXml = R"(<?xml version="1.0" encoding="UTF-8"?>
<tools>
  <tool number="3" name="MILL_10" kind="end mill" d="10 mm" length="88 mm" flutes="4" holder="ER32">
    <cutting material="steel" vc="120 m/min" fz="0.05 mm"/>
    <cutting material="brass" vc="200 m/min" fz="0.1 mm"/>
  </tool>
  <tool number="5" name="DRILL_5" kind="drill" d="5 mm" length="112 mm" flutes="2" tip_angle="140 deg">
    <cutting vc="80 m/min" f="0.1 mm"/>
  </tool>
</tools>
)";

class Tools : public kadr::test::ScratchFolder {
  protected:
    void SetUp() override {
        ScratchFolder::SetUp();
        save("tools.csv", kCsv);
        save("tools.xml", kXml);
    }

    /// The messages about a program with these statements.
    std::string said_of(const std::string& statements, const std::string& library = "tools.csv") {
        save("part.kadr", "program p() { " + statements + " M30; }\n");
        std::vector<std::string> words = {"check", file("part.kadr"), "-d", "fanuc"};
        if (!library.empty()) words.insert(words.end(), {"--tools", file(library)});
        return kadr(words).err;
    }
    /// The messages about a library.
    std::string said_of_file(const std::string& name, const std::string& text) {
        save(name, text);
        return said_of("tool(1);", name);
    }
    std::string text_of(const std::string& program, const std::string& control,
                        const std::string& library = "tools.csv") {
        save("part.kadr", program);
        const auto result =
            kadr({"expand", file("part.kadr"), "-d", control, "--tools", file(library)});
        EXPECT_EQ(result.status, 0) << result.err;
        return result.out;
    }
};

bool has(const std::string& text, const std::string& piece) {
    return text.find(piece) != std::string::npos;
}

/// n·vc/(π·d): 120 m/min on 10 mm are 3820 turns, 4 teeth of 0.05 mm make 764 mm/min of them.
const std::string kAsks = R"(program p() {
    tool("MILL_10");
    S=tool("MILL_10", "steel").speed M3 F=tool("MILL_10", "steel").feed;
    G0 X=tool("MILL_10").d Y=tool("MILL_10").length Z5;
    G1 X=tool("MILL_10", "brass").fz*tool("MILL_10").flutes Z=-(tool("DRILL_5").r ?? 1.5mm);
    if (!(given tool("MILL_10").tip_angle)) G1 Y=sin(tool("DRILL_5").tip_angle/2)*10mm;
    length? corner = tool("MILL_10").r;
    G1 Y=corner ?? 7mm;
    if (tool("DRILL_5").kind == "drill") F=tool(5).f*tool("DRILL_5").speed;
    G1 X=tool("DRILL_5").number*1mm;
    message(tool("MILL_10").name + " " + tool("MILL_10").holder);
    M30;
}
)";

TEST_F(Tools, AProgramReadsThem) {
    for (const char* library : {"tools.csv", "tools.xml"}) {
        SCOPED_TRACE(library);
        const std::string fanuc = text_of(kAsks, "fanuc", library);
        for (const char* piece : {"T03 M06", "F764. S3820 M03", "X10. Y88. Z5.", "X0.4 Z-1.5",
                                  "Y9.397", "Y7.", "F509.3", "X5.", "MILL_10 ER32"})
            EXPECT_TRUE(has(fanuc, piece)) << piece << " in\n" << fanuc;
        EXPECT_TRUE(has(text_of(kAsks, "sinumerik", library), "T=\"3\" D1"));
        EXPECT_TRUE(has(text_of(kAsks, "axioma", library), "M6"));
    }
}

TEST_F(Tools, WhatAProgramAsksWrongly) {
    const std::vector<std::pair<std::string, std::string>> rows = {
        {"tool(\"MIL_10\");", ":1:20: error[K2712]"},
        {"tool(\"MIL_10\");", "did you mean `MILL_10`?"},
        {"G0 X=tool(4).d;", "K2712"},
        {"G0 X=tool(\"MILL_10\").dd;", "K2713"},
        {"G0 X=tool(\"MILL_10\").dd;", "did you mean `d`?"},
        {"G0 X=tool(\"DRILL_5\").r;", "K2714"},
        {"G0 X=tool(\"DRILL_5\").r;", "tools.csv:4:1: note: the tool stands here"},
        {"G0 X=tool(\"MILL_10\").fz;", "K2715"},
        {"G0 X=tool(\"MILL_10\", \"bras\").fz;", "did you mean `brass`?"},
        {"G0 X=tool(\"MILL_10\").tip_angle;", "K2714"},
        {"string s = \"a\"; s = \"b\"; tool(s);", "K2112"},
        {"G0 X=tool(\"MILL_10\", \"brass\").vc;", "K2102"},  // a speed is no length
    };
    for (const auto& [statements, piece] : rows)
        EXPECT_TRUE(has(said_of(statements), piece)) << statements << '\n' << said_of(statements);
    // Without a library it is said once.
    const std::string said = said_of("tool(\"A\"); G0 X=tool(\"B\").d;", "");
    EXPECT_TRUE(has(said, "K2711")) << said;
    EXPECT_EQ(said.find("K2711"), said.rfind("K2711")) << said;
}

TEST_F(Tools, WhatIsWrongWithAFile) {
    const std::string one = "number,name,kind,d,r\n1,A,end mill,10,1\n";
    const std::vector<std::pair<std::string, std::string>> rows = {
        {one + "1,B,drill,5,\n", ":3:1: error[K6014]"},
        {one + "2,A,drill,5,\n", ":3:3: error[K6014]"},
        {one + "2,B,dril,5,\n", ":3:5: error[K6704]"},
        {one + "2,B,dril,5,\n", "did you mean `drill`?"},
        {one + ",B,drill,5,\n", "K6701"},
        {one + "2,,drill,5,\n", "K6701"},
        {one + "0,B,drill,5,\n", ":3:1: error[K6702]"},
        {one + "2,B\xC3\x96,drill,5,\n", "K6703"},
        {one + "2,B,drill,-5,\n", ":3:11: error[K6705]"},
        {one + "2,B,ball,6,2\n", "half of the diameter of a ball, 3 mm"},
        {one + ",,,6,\n", ":3:4: error[K6706]"},
        {"number,name,kind,vc\n,,,100\n", "K6707"},
        {one + "2,B,drill,x,\n", ":3:11: error[K2409]"},
        {"number,name,d\n", "K2406"},
        {"number,name,kind,d [kg]\n1,A,drill,5\n", ":1:18: error[K2407]"},
    };
    for (const auto& [text, piece] : rows) {
        const std::string said = said_of_file("wrong.csv", text);
        EXPECT_TRUE(has(said, piece)) << text << piece << '\n' << said;
    }
    const std::string xml = said_of_file("wrong.xml",
                                         "<tools><tool number=\"1\" name=\"A\" kind=\"drill\" "
                                         "d=\"5\"/><tool name=\"B\" kind=\"tapp\" "
                                         "number=\"1\"/></tools>");
    for (const char* piece : {"K6008", "K6014", "K6704", "did you mean `tap`?"})
        EXPECT_TRUE(has(xml, piece)) << piece << '\n' << xml;
    EXPECT_TRUE(has(said_of("tool(1);", "none.csv"), "it is asked for by the option `--tools`"));
}

TEST_F(Tools, ARunTakesLengthAndRadius) {
    save("part.mpf",
         "T=\"MILL_10\" D1\nM6\nS1000 M3\nG0 X0 Y0 Z5\nG41 G1 X0 Y20 F500\nY40\nG40 X20\nM30\n");
    const auto run = kadr({"run", file("part.mpf"), "-d", "sinumerik", "--tools", file("tools.csv"),
                           "--commands", "-"});
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(has(run.out, "\"length\":88")) << run.out;
    EXPECT_TRUE(has(run.out, "-5")) << run.out;  // half of 10 mm beside the line
    // The machine file may name the library.
    std::string machine = read_file(KADR_ROOT "/runtime/machines/mill.xml").value();
    machine.replace(machine.find("<machine "), 9, "<machine tools=\"tools.csv\" ");
    save("shop.xml", machine);
    const auto named = kadr(
        {"run", file("part.mpf"), "-d", "sinumerik", "-m", file("shop.xml"), "--commands", "-"});
    EXPECT_EQ(named.out, run.out) << named.err;
}

/// The cutter that a cycle names and the one of the library under the number of the tool.
TEST_F(Tools, AContradictionIsToldByExpandAndEndsARun) {
    save("part.kadr",
         "import cycles.milling;\nimport \"tools.csv\";\nprogram p() { tool(\"MILL_10\"); S1000 "
         "M3; F300; G0 X0 Y0 Z5; "
         "pocket_rect(w: 60mm, h: 40mm, to: -4mm, tool_d: 12mm, step: 2mm, plunge: 100mm/min); "
         "M30; }\n");
    const auto run = kadr({"run", file("part.kadr"), "-d", "fanuc"});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(has(run.err, "K3650")) << run.err;
    const auto expand = kadr({"expand", file("part.kadr"), "-d", "fanuc", "-m", "mill"});
    EXPECT_EQ(expand.status, 0) << expand.err;
    EXPECT_TRUE(has(expand.err, "K3651")) << expand.err;
}

TEST_F(Tools, AProgramImportsOne) {
    save("part.kadr", "import \"tools.csv\";\nprogram p() { tool(\"MILL_10\"); M30; }\n");
    EXPECT_TRUE(has(kadr({"expand", file("part.kadr"), "-d", "fanuc"}).out, "T03 M06"));
    // The command line stands in for it.
    save("shop.csv", "number,name,kind\n9,MILL_10,end mill\n");
    EXPECT_TRUE(
        has(kadr({"expand", file("part.kadr"), "-d", "fanuc", "--tools", file("shop.csv")}).out,
            "T09 M06"));
    save("part.kadr", "import \"tools.csv\"; import \"tools.xml\";\nprogram p() { M30; }\n");
    EXPECT_TRUE(has(kadr({"check", file("part.kadr")}).err, ":1:21: error[K2716]"));
    save("part.kadr", "import \"tool.csv\";\nprogram p() { M30; }\n");
    EXPECT_TRUE(has(kadr({"check", file("part.kadr")}).err, ":1:1: error[K"));
}

/// The machine has measured its tool 1; the library thinks that it is another one.
TEST_F(Tools, TheMachinesMeasuresHold) {
    save("shop.csv", "number,name,kind,d\n1,MILL_12,end mill,12\n");
    save("part.kadr", "program p() { tool(\"MILL_12\"); S1000 M3; F100; G0 X0 Z5; G1 X5; M30; }\n");
    const auto run = kadr({"run", file("part.kadr"), "-d", "fanuc", "-m", "rotary-a", "--tools",
                           file("shop.csv"), "--commands", "-"});
    EXPECT_TRUE(has(run.err, "K6708")) << run.err;
    EXPECT_TRUE(has(run.out, "\"length\":120")) << run.out;
}

TEST_F(Tools, TheSummaryNamesThem) {
    save("part.kadr",
         "program p() { tool(3); S1000 M3; F500; G0 Z5; G1 X9; tool(5); S900 M3; G1 X5; M30; }\n");
    const auto run = kadr({"run", file("part.kadr"), "-d", "fanuc", "--tools", file("tools.csv")});
    EXPECT_TRUE(has(run.out, "T3 MILL_10")) << run.out;
}

TEST_F(Tools, TheSetupSheetHasWhatAPersonNeeds) {
    save("part.kadr", R"(import cycles.drilling;
import "tools.csv";
program p(length deep = 12mm, int n = 2, string who = "a, b") {
    work_offset(2);
    tool("DRILL_5");
    S=tool("DRILL_5").speed M3 F=tool("DRILL_5").feed;
    G0 X0 Y0 Z20;
    for (int i = 0; i < n; i++) { G0 X=i*10mm; drill(to: -deep); }
    tool(3);
    S1000 M3 F300;
    G0 X0 Z5;
    G1 Z-3;
    G1 X50;
    G0 Z20;
    message(who);
    M30;
}
)");
    const auto sheet = [&](const std::string& name) {
        const auto run = kadr(
            {"run", file("part.kadr"), "-d", "fanuc", "-D", "n=3", "--setup-sheet", file(name)});
        EXPECT_EQ(run.status, 0) << run.err;
        return read_file(file(name)).value_or("");
    };
    const std::string text = sheet("sheet.md");
    for (const char* piece :
         {"| T5 | DRILL_5 | drill | – | 5 | – | 112 | 2 | -12 |",
          "| T3 | MILL_10 | end mill | ER32 | 10 | – | 88 | 4 | -3 |", "| T5 | drill |",
          "| T3 | lines and arcs of the program |", "| G55 | 0 |", "| deep | 12mm | 12mm |",
          "| n | 3 ← | 2 |", "| who | \"a, b\" | \"a, b\" |", "| T5 DRILL_5 |", "| all |", "| X |",
          "-1000 to 1000 mm"})
        EXPECT_TRUE(has(text, piece)) << piece << " in\n" << text;
    EXPECT_LT(text.find("T5"), text.find("T3"));  // as they are used
    const std::string page = sheet("sheet.html");
    EXPECT_TRUE(page.starts_with("<!doctype html>") && page.ends_with("</html>\n"));
    EXPECT_TRUE(has(page, "prefers-color-scheme: dark") && has(page, "@media print"));
    EXPECT_TRUE(has(page, "data:image/svg+xml;base64,"));
    for (const char* alien : {"http://", "https://", "<script"}) EXPECT_FALSE(has(page, alien));
    EXPECT_EQ(page, sheet("again.html"));
}

}  // namespace

}  // namespace tools_test
