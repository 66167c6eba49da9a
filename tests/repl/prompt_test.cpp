// The conversation: what is answered to a line, without a terminal.
#include "repl/prompt.h"

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "repl/sketch.h"
#include "tests/common/inputs.h"

namespace kadr::repl::prompt_test {

namespace {

namespace fs = std::filesystem;

class Conversation {
  public:
    explicit Conversation(const std::string& dialect = "iso", std::function<bool()> wait = {}) {
        driver::Options options;
        options.dialect = dialect;
        prompt_.emplace(
            options, test::inputs(),
            Surroundings{[this](std::string_view text) { heard_ += text; }, std::move(wait), 40},
            &stop_);
    }

    /// What is answered to a line.
    std::string say(std::string_view line) {
        heard_.clear();
        prompt_->take(line);
        return heard_;
    }
    Prompt& prompt() { return *prompt_; }
    std::atomic<bool>& stop() { return stop_; }

  private:
    std::string heard_;
    std::atomic<bool> stop_{false};
    std::optional<Prompt> prompt_;
};

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

TEST(Prompt, TakesBlocksAsTheInputDialectSays) {
    Conversation talk("sinumerik");
    EXPECT_EQ(talk.say("dialect fanuc;"), "");
    talk.say("T03 M06;");
    EXPECT_TRUE(has(talk.say("G43 H03 G00 X10. Y20. Z50.;"), "G0 X10 Y20 Z50 D1\n"));
    EXPECT_TRUE(has(talk.say("G68 R30.;"), "ATRANS X10 Y20\n"));
    EXPECT_TRUE(has(talk.say("G69;"), "TRANS\n"));
    EXPECT_TRUE(has(talk.say("G52 X5. Y6.;"), "TRANS X5 Y6\n"));
    EXPECT_TRUE(has(talk.say("G52 X7.;"), "TRANS X7 Y6\n"));
    EXPECT_TRUE(has(talk.say("X10;"), "error[K4115]"));
    EXPECT_TRUE(has(talk.say("X10.;"), "X10\n"));
}

TEST(Prompt, ABlockShowsItsTextAndWhatItChanged) {
    Conversation talk("fanuc");
    const std::string first = talk.say("G0 X10 Y20");
    EXPECT_TRUE(has(first, "\nX10. Y20.\n")) << first;
    EXPECT_TRUE(has(first, "at X10.000 Y20.000")) << first;
    const std::string second = talk.say("G1 X0 F200 S1000 M3;");
    EXPECT_TRUE(has(second, "G01 X0. F200. S1000 M03\n")) << second;
    EXPECT_TRUE(has(second, "feed 200 mm/min")) << second;
    EXPECT_TRUE(has(second, "spindle clockwise, 1000 rpm")) << second;
    EXPECT_TRUE(has(second, "; +")) << second;
    EXPECT_FALSE(talk.prompt().has_failed());
}

TEST(Prompt, ExpressionsShowTheirValue) {
    Conversation talk;
    EXPECT_EQ(talk.say("2 + 3"), "5\n");
    EXPECT_EQ(talk.say("length r = 25mm"), "");
    EXPECT_EQ(talk.say("r*2;"), "50 mm\n");
    EXPECT_EQ(talk.say("1in"), "25.4 mm\n");
    EXPECT_EQ(talk.say("sqrt(16)"), "4\n");
    EXPECT_EQ(talk.say("length twice(length a) { return 2*a; }"), "");
    EXPECT_EQ(talk.say("twice(4mm)"), "8 mm\n");
    EXPECT_EQ(talk.say("r = 3mm"), "");
    EXPECT_EQ(talk.say("r"), "3 mm\n");
}

TEST(Prompt, ValuesShowTheirUnit) {
    struct Row {
        const char* expression;
        const char* answer;
    };
    Conversation metric;
    for (const Row& row : {
             Row{"180deg/6", "30 deg\n"},
             {"0.5s", "0.5 s\n"},
             {"200mm/min", "200 mm/min\n"},
             {"0.1mm/rev", "0.1 mm/rev\n"},
             {"1500rpm", "1500 rpm\n"},
             {"120m/min", "120000 mm/min\n"},
             {"2mm*3mm", "6 mm^2\n"},
             {"3mm/2mm", "1.5\n"},
             {"7/2", "3.5\n"},
             {"true", "true\n"},
         }) {
        EXPECT_EQ(metric.say(row.expression), row.answer) << row.expression;
    }
    metric.say("feed f = 0.2mm/rev");
    metric.say("speed v = 120m/min");
    EXPECT_EQ(metric.say(":vars"), "f = 0.2 mm/rev\nv = 120 m/min\n");
    metric.say("f = 300mm/min");
    EXPECT_EQ(metric.say("f"), "300 mm/min\n");
    Conversation inch;
    inch.say("units inch;");
    EXPECT_EQ(inch.say("50.8mm"), "2 in\n");
    EXPECT_EQ(inch.say("254mm/min"), "10 in/min\n");
}

TEST(Prompt, AnInputMayHaveSeveralLines) {
    Conversation talk;
    EXPECT_EQ(talk.say("for (int i = 1; i <= 2; i++) {"), "");
    EXPECT_TRUE(talk.prompt().is_waiting());
    EXPECT_EQ(talk.say("    G0 X=i;"), "");
    const std::string answer = talk.say("}");
    EXPECT_FALSE(talk.prompt().is_waiting());
    EXPECT_TRUE(has(answer, "X1\nX2\n")) << answer;
    talk.say("cycle c(");
    talk.prompt().cancel();
    EXPECT_EQ(talk.say("1"), "1\n");
}

/// A line end, or a `}`, ends a statement inside of braces as it does outside of them.
TEST(Prompt, AForgottenSemicolonInBracesIsPutBehind) {
    Conversation talk;
    EXPECT_TRUE(has(talk.say("for (int i = 1; i <= 2; i++) { G0 X=i }"), "X1\nX2\n"));
    struct Row {
        const char* input;
        const char* text;  // of the control
    };
    for (const Row& row : {
             Row{"{\nG0 X3\nY4\n}", "X3\nY4\n"},
             Row{"{\nlength c = 2mm\n    + 3mm // both\nX=c\n}", "X5\n"},
             Row{"{\nif (position.x > 1mm)\n  Y=6\nelse\n  Y=7\n}", "Y6\n"},
             Row{"{\nfor (int i = 8; i < 10; i++)\n  Z=i\n}", "Z8\nZ9\n"},
             Row{"{\npoint p = {10mm, 11mm}\nX=p.x\n}", "X10\n"},
             Row{"{\nif (true) { Y12 } else { Y13 }\nX14\n}", "Y12\nX14\n"},
             Row{"{ X15 // no ; needed\n}", "X15\n"},
         }) {
        std::string answer;
        for (const std::string& line : lines_of(row.input)) answer = talk.say(line);
        EXPECT_TRUE(has(answer, row.text)) << row.input << '\n' << answer;
    }
    EXPECT_FALSE(talk.prompt().has_failed());
}

TEST(Prompt, WhatIsWholeInBracesStaysAsItIs) {
    Conversation talk;
    talk.say("cycle two(length a) {");
    talk.say("    G0 X=a");
    talk.say("       Y=a;");  // one block, as in a file
    talk.say("}");
    EXPECT_TRUE(has(talk.say("two(2mm)"), "X2 Y2\n"));
    // What is wrong besides is reported alone.
    talk.say("cycle wrong() {");
    talk.say("    G0 X1");
    talk.say("    Y=nowhere");
    const std::string answer = talk.say("}");
    EXPECT_TRUE(has(answer, "[K2001]")) << answer;
    EXPECT_FALSE(has(answer, "[K1101]")) << answer;
}

TEST(Prompt, ANameShowsItsContract) {
    Conversation talk("fanuc");
    const std::string library = talk.say("drill_peck?");
    EXPECT_TRUE(has(library, "cycle drill_peck(length to, length peck, length retract = 2mm"))
        << library;
    EXPECT_TRUE(has(library, "Drills a deep hole")) << library;
    EXPECT_TRUE(has(library, "  peck       length  mm    needed      > 0mm  depth of one stroke"))
        << library;
    EXPECT_TRUE(has(library, "  and (retract - to)/peck <= 1000\n")) << library;
    EXPECT_TRUE(has(library, "type `import cycles.drilling;` first\n")) << library;
    talk.say("import cycles.drilling;");
    for (const char* asked :
         {":help drill_peck", "help drill_peck;", "?drill_peck", "drill_peck()?"}) {
        const std::string known = talk.say(asked);
        EXPECT_TRUE(has(known, "cycle drill_peck(")) << asked << known;
        EXPECT_FALSE(has(known, "import")) << asked << known;
    }
    talk.say("/// Twice.\nlength twice(length a) { return 2*a; }");
    EXPECT_EQ(talk.say("twice?"),
              "length twice(length a)\nTwice.\n  parameter  type    unit  default\n"
              "  a          length  mm    needed\n");
    EXPECT_TRUE(has(talk.say("G83?"), "the cycle drill_peck"));
    EXPECT_TRUE(has(talk.say("rotate?"), "rotation in the working plane"));
    EXPECT_TRUE(has(talk.say("sqrt?"), "function of the language"));
    EXPECT_TRUE(has(talk.say(":help undo"), ":undo: take the last input back"));
    EXPECT_FALSE(talk.prompt().has_failed());
    EXPECT_EQ(talk.say("dril_peck?"),
              "nothing is known of `dril_peck`; did you mean `drill_peck`?\n");
    EXPECT_TRUE(talk.prompt().has_failed());
}

TEST(Prompt, AnswersWhatOtherPromptsAreAsked) {
    for (const char* word : {"help", "help;", "?"}) {
        Conversation talk;
        EXPECT_TRUE(has(talk.say(word), ":undo")) << word;
        EXPECT_FALSE(talk.prompt().has_failed()) << word;
    }
    for (const char* word : {"quit", "exit", "exit()", "quit;", ":exit"}) {
        Conversation talk;
        EXPECT_EQ(talk.say(word), "") << word;
        EXPECT_TRUE(talk.prompt().is_over()) << word;
    }
    Conversation talk;
    talk.say("length exit = 3mm");
    EXPECT_EQ(talk.say("exit"), "3 mm\n");
    EXPECT_FALSE(talk.prompt().is_over());
}

TEST(Prompt, AHeadAtTheEndOfALineWaitsForItsBody) {
    Conversation talk;
    for (const char* head :
         {"if (false)", "for (int i : 1..2)", "while (false)  // a comment",
          "if (true) G0 X1; else", "do", "do { G0 X1; }", "with G91", "cycle c()", "switch (1)",
          "struct s", "for (int i = 0; i < 2; i++)\n"}) {
        EXPECT_EQ(talk.say(head), "") << head;
        EXPECT_TRUE(talk.prompt().is_waiting()) << head;
        talk.prompt().cancel();
    }
    for (const char* whole : {"if (false);", "G0 X1", "1 +", "while (false) {}", "G1 X", "f()"}) {
        talk.say(whole);
        EXPECT_FALSE(talk.prompt().is_waiting()) << whole;
    }
    talk.say("if (false)");
    EXPECT_EQ(talk.say("G0 X6"), "") << "the move belongs to the condition";
    talk.say("for (int i : 2..3)");
    const std::string answer = talk.say("    G0 Y=i");
    EXPECT_TRUE(has(answer, "Y2\n") && has(answer, "Y3\n")) << answer;
    talk.say("void up()");
    talk.say("{ G0 Z9; }");
    EXPECT_TRUE(has(talk.say("up()"), "Z9\n"));
    Conversation polish;
    polish.say("language pl;");
    polish.say("jeżeli (fałsz)");
    EXPECT_TRUE(polish.prompt().is_waiting());
}

TEST(Prompt, AMistakeInACycleIsOneMessage) {
    Conversation talk;
    talk.say("length d = 40mm;");
    talk.say("cycle ring(length r) {");
    talk.say("    G0 X=;");
    talk.say("    G2 I=-r F100;");
    const std::string answer = talk.say("}");
    EXPECT_TRUE(has(answer, "K12")) << answer;
    EXPECT_EQ(answer.find("error["), answer.rfind("error[")) << answer;
    EXPECT_FALSE(has(answer, "40mm")) << answer;
    // What only the library's own files use is not proposed.
    EXPECT_FALSE(has(talk.say("ring(5mm)"), "levels"));
}

TEST(Prompt, AnErrorLeavesNothingBehind) {
    Conversation talk;
    EXPECT_TRUE(has(talk.say("G1 X=nothing F100"), "prompt.kadr:2:6: error[K2001]"));
    EXPECT_TRUE(has(talk.say("G1 X)"), "error[K"));
    EXPECT_TRUE(has(talk.say("error(\"so\")"), "so"));
    EXPECT_TRUE(talk.prompt().has_failed());
    EXPECT_TRUE(has(talk.say("G0 X1"), "X1\n"));
    EXPECT_FALSE(has(talk.say(":list"), "nothing"));
}

TEST(Prompt, UndoTakesTheLastInputBack) {
    Conversation talk;
    talk.say("G0 X1");
    talk.say("G0 X2");
    EXPECT_EQ(talk.say(":undo"), "taken back: G0 X2;\n");
    EXPECT_TRUE(has(talk.say(":state"), "X1.000"));
    talk.say(":undo");
    EXPECT_EQ(talk.say(":undo"), "nothing to take back\n");
    talk.say("G0 X3");
    talk.say("G0 X4");
    talk.say("G0 X5");
    EXPECT_TRUE(has(talk.say(":undo two"), "how many inputs?"));
    EXPECT_EQ(talk.say(":undo 2"), "taken back: G0 X5;\ntaken back: G0 X4;\n");
    EXPECT_TRUE(has(talk.say(":state"), "X3.000"));
}

TEST(Prompt, AnExpressionWithAnErrorSaysSo) {
    Conversation talk;
    talk.say("length[2] a = {1mm, 2mm}");
    talk.say("length r");
    struct Row {
        const char* expression;
        const char* answer;
    };
    for (const Row& row : {
             Row{"foo", "prompt.kadr:4:1: error[K2001]: `foo` is not declared\n   4 | foo;\n"},
             {"foo + 1", "error[K2001]"},
             {"foo.x", "error[K2001]"},
             {"5/0", "error[K2109]"},
             {"1mm + 1s", "error[K2103]: `+` between length and time"},
             {"a[7]", "error[K2117]: there is no element 7"},
             {"r + 1mm", "error[K2113]: `r` is not given here"},
             {"1 +", "error[K1205]"},
         }) {
        const std::string answer = talk.say(row.expression);
        EXPECT_TRUE(has(answer, row.answer)) << row.expression << ":\n" << answer;
    }
    EXPECT_TRUE(talk.prompt().has_failed());
}

TEST(Prompt, ValuesOfEveryTypeAreShown) {
    Conversation talk;
    struct Row {
        const char* input;
        const char* answer;
    };
    for (const Row& row : {
             Row{"point p = {10mm, 20mm}", ""},
             {"p", "{x: 10mm, y: 20mm}\n"},
             {"p*2", "{x: 20mm, y: 40mm}\n"},
             {"point nowhere", ""},
             {"nowhere", "not given\n"},
             {"vector up = {0, 0, 1}", ""},
             {"up", "{x: 0, y: 0, z: 1}\n"},
             {"\"left\"", "left\n"},
             {"\"a\" + \"b\"", "ab\n"},
             {"length? left_out", ""},
             {"left_out", "not given\n"},
             {"state.feed", "not given\n"},
             {"enum kind { through, blind }", ""},
             {"struct hole { point at; length d = 6mm; kind made; string name; }", ""},
             {"hole h = {{1mm, 2mm}, name: \"A\", made: blind}", ""},
             {"h", "{at: {x: 1mm, y: 2mm}, d: 6mm, made: blind, name: \"A\"}\n"},
             {"h.made", "blind\n"},
             {"kind.through", "through\n"},
             {"hole[] holes = {h}", ""},
             {"holes", "{{at: {x: 1mm, y: 2mm}, d: 6mm, made: blind, name: \"A\"}}\n"},
             {"int[] numbers", ""},
             {"numbers", "{}\n"},
             {"for (int i = 1; i <= 30; i++) numbers.append(i);", ""},
             {"numbers",
              "{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, "
              "… 30 in all}\n"},
             {"numbers.pop()", "30\n"},
             {"numbers.count", "29\n"},
             {"numbers.clear()", ""},
             {"contour none", ""},
             {"none", "an empty contour\n"},
             {"contour c = { G1 X0 Y0; X5; Y5; };", ""},
             {"c", "a contour from {x: 0mm, y: 0mm} to {x: 5mm, y: 5mm}, 2 elements\n"},
         }) {
        EXPECT_EQ(talk.say(row.input), row.answer) << row.input;
    }
    const std::string all = talk.say(":vars");
    EXPECT_TRUE(has(all, "p = {x: 10mm, y: 20mm}\n")) << all;
    EXPECT_TRUE(has(all, "left_out = not given\n")) << all;
    EXPECT_TRUE(has(all, "numbers = {}\n")) << all;
}

TEST(Prompt, ACallThatMovesAndHasAValueDoesBoth) {
    Conversation talk;
    talk.say("length down(length z) { G0 Z=-z; return z/2; }");
    const std::string answer = talk.say("down(4mm)");
    EXPECT_TRUE(has(answer, "Z-4\n2 mm\n    at")) << answer;
    EXPECT_TRUE(has(talk.say(":list"), "down(4mm);"));
}

TEST(Prompt, AWarningIsSaidOnceForEachInput) {
    Conversation talk;
    EXPECT_TRUE(has(talk.say("G1 X3 F100"), "warning[K5213]"));
    EXPECT_EQ(talk.say("length twice(length a) { return 2*a; }"), "");
    EXPECT_EQ(talk.say("struct pair { int a; int b; }"), "");
    EXPECT_EQ(talk.say("twice(2mm)"), "4 mm\n");
    EXPECT_TRUE(has(talk.say("warn(\"deep\")"), "deep"));
    EXPECT_EQ(talk.say("int n = 3"), "");
    EXPECT_TRUE(has(talk.say("warn(\"deep\")"), "deep"));
    EXPECT_FALSE(has(talk.say(":dialect fanuc"), "warning"));
}

TEST(Prompt, CommentsStandBehindAndInsideOfInputs) {
    Conversation talk;
    EXPECT_TRUE(has(talk.say("G0 X1 // to the left"), "X1\n"));
    EXPECT_EQ(talk.say("G0 X2 /* to the \"right"), "");
    EXPECT_TRUE(has(talk.say("   of it */"), "X2\n"));
    EXPECT_EQ(talk.say("/* several"), "");
    EXPECT_EQ(talk.say("lines */ 5 // five"), "5\n");
    EXPECT_EQ(talk.say("// nothing but words"), "");
    EXPECT_EQ(talk.say("\"// no comment\""), "// no comment\n");
    EXPECT_TRUE(has(talk.say(":list"), "G0 X1; // to the left\n"));
}

TEST(Prompt, SpeaksTheKeywordLanguageThatIsChosen) {
    Conversation talk;
    EXPECT_EQ(talk.say("language ru"), "");
    EXPECT_EQ(talk.say("длина r = 5mm"), "");
    EXPECT_EQ(talk.say("r"), "5 mm\n");
    EXPECT_TRUE(has(talk.say("если (r > 1mm) G0 X=r;"), "X5\n"));
    EXPECT_TRUE(has(talk.say("language pl"), "error[K1109]"));  // the statements are Russian
    EXPECT_TRUE(has(talk.say(":list"), "программа prompt() {\n"));
    Conversation other;
    other.say("units inch");
    EXPECT_EQ(other.say("25.4mm"), "1 in\n");
    EXPECT_EQ(other.say("units mm"), "");  // replaces the other
    EXPECT_EQ(other.say("25.4mm"), "25.4 mm\n");
    EXPECT_TRUE(has(other.say("language klingon"), "error[K1301]"));
    other.say("G0 X1");
    EXPECT_TRUE(has(other.say("units inch"), "error[K2302]"));
    EXPECT_TRUE(has(other.say(":list"), "units mm;"));
}

/// The conversations in docs/first-program.md: what stands behind `kadr> ` and what is answered.
TEST(Prompt, AnswersAsTheManualShows) {
    const auto manual = read_file(KADR_ROOT "/docs/first-program.md");
    ASSERT_TRUE(manual);
    constexpr std::string_view kPrompt = "kadr> ";
    Conversation talk("fanuc");
    std::string input;
    std::string expected;
    int inputs = 0;
    const auto compare = [&] {
        if (input.empty()) return;
        EXPECT_EQ(talk.say(input), expected) << input;
    };
    bool is_conversation = false;
    for (std::size_t begin = 0; begin < manual->size();) {
        const std::size_t end = std::min(manual->find('\n', begin), manual->size());
        const std::string line = manual->substr(begin, end - begin);
        begin = end + 1;
        if (line.starts_with(kPrompt)) {
            compare();
            is_conversation = true;
            input = line.substr(kPrompt.size());
            expected.clear();
            ++inputs;
        } else if (line.starts_with("```")) {
            is_conversation = false;
        } else if (is_conversation) {
            expected += line + '\n';
        }
    }
    compare();
    EXPECT_GE(inputs, 3);
}

TEST(Prompt, CommandsAnswer) {
    Conversation talk;
    talk.say("int n = 3");
    talk.say("G0 X10 Y5 Z5");
    talk.say("G1 X20 F100 S500 M3");
    struct Row {
        const char* command;
        const char* answer;
    };
    for (const Row& row : {
             Row{":help", ":dialect [NAME]"},
             {":h", ":dialect [NAME]"},
             {":dialect", "iso\n"},
             {":machine", "mill\n"},
             {":state", "feed         100 mm/min"},
             {":vars", "n = 3\n"},
             {":list", "   3  G0 X10 Y5 Z5;\n"},
             {":list iso", "X10 Y5 Z5\n"},
             {":time", "cutting"},
             {":plot", "X 10 … 20 mm"},
             {":reload", "lines\n"},
             {":step", "block by block\n"},
             {":s", "there is no command `:s`"},
             {":list what", "`:list iso`"},
             {":save", "where to?"},
             {":dialect nobody", "nobody"},
         }) {
        EXPECT_TRUE(has(talk.say(row.command), row.answer)) << row.command << ":\n"
                                                            << talk.say(row.command);
    }
    // A dialect that is not there leaves the one that holds.
    EXPECT_EQ(talk.say(":dialect"), "iso\n");
    EXPECT_EQ(talk.say(":dialect fanuc"), "");
    EXPECT_TRUE(has(talk.say(":list iso"), "O0001(PROMPT)"));
    talk.say(":quit");
    EXPECT_TRUE(talk.prompt().is_over());
}

TEST(Prompt, StepShowsWhatEachBlockDoes) {
    int waits = 0;
    Conversation talk("iso", [&waits] { return ++waits < 2; });
    talk.say("G0 X0");
    talk.say(":step on");
    const std::string answer = talk.say("for (int i = 1; i < 9; i++) G0 X=i;");
    EXPECT_TRUE(has(answer, "rapid to X1.000\n")) << answer;
    EXPECT_TRUE(has(answer, "rapid to X2.000\n")) << answer;
    EXPECT_FALSE(has(answer, "rapid to X3.000\n")) << answer;  // the second key was `q`
}

TEST(Prompt, ManyLinesAreShortened) {
    Conversation talk;
    talk.say("G0 X0");
    const std::string answer = talk.say("for (int i = 1; i <= 1000; i++) G0 X=i;");
    EXPECT_TRUE(has(answer, "X18\n")) << answer;
    EXPECT_FALSE(has(answer, "X19\n")) << answer;
    EXPECT_TRUE(has(answer, "    … 977 lines more\n")) << answer;
    EXPECT_TRUE(has(answer, "X996\nX997\nX998\nX999\nX1000\n")) << answer;
}

TEST(Prompt, FilesAreLoadedAndSaved) {
    const fs::path folder = fs::temp_directory_path() / ("kadr-repl-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::string library = (folder / "my.kadr").string();
    const std::string saved = (folder / "saved.kadr").string();
    ASSERT_TRUE(write_file_whole(library, "cycle hop(length to) { G0 Z=to; }\n"));
    Conversation talk;
    EXPECT_EQ(talk.say(":load " + library), "");
    EXPECT_TRUE(has(talk.say("hop(to: 7mm)"), "Z7\n"));
    ASSERT_TRUE(write_file_whole(library, "cycle hop(length to) { G0 Z=to + 1mm; }\n"));
    talk.say(":reload");
    EXPECT_TRUE(has(talk.say(":state"), "Z8.000"));
    EXPECT_EQ(talk.say(":save " + saved), "saved in " + saved + '\n');
    EXPECT_EQ(read_file(saved),
              "import \"" + library + "\";\n\nprogram prompt() {\n    hop(to: 7mm);\n}\n");
    EXPECT_TRUE(has(talk.say(":load " + (folder / "none.kadr").string()), "K9003"));
    // A program of the file is called as a cycle is.
    const std::string part = (folder / "part.kadr").string();
    ASSERT_TRUE(write_file_whole(part, "program row(int n = 3) { for (int i : 1..n) G0 X=i; }\n"));
    Conversation other;
    EXPECT_EQ(other.say(":load " + part), "");
    EXPECT_TRUE(has(other.say("row(n: 2)"), "X1\nX2\n"));
    EXPECT_TRUE(has(other.say("G0 Z5"), "Z5\n"));
    // … which a file cannot do: it is not saved as one that does not run.
    const std::string refused = other.say(":save " + saved + "2");
    EXPECT_TRUE(has(refused, "not saved: only at the prompt one program calls another")) << refused;
    EXPECT_TRUE(has(refused, "K2017")) << refused;
    EXPECT_FALSE(fs::exists(saved + "2"));
    EXPECT_EQ(talk.say(":plot " + (folder / "a.svg").string()), "nothing has moved\n");
    EXPECT_TRUE(fs::exists(folder / "a.svg"));
    fs::remove_all(folder);
}

// A file that is there already is replaced when somebody says so; in a pipe nobody does.
TEST(Prompt, AsksBeforeItReplacesAFile) {
    const fs::path folder = fs::temp_directory_path() / ("kadr-kept-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::string file = (folder / "part.kadr").string();
    ASSERT_TRUE(write_file_whole(file, "mine\n"));
    driver::Options options;
    options.dialect = "iso";
    std::string heard;
    std::vector<std::string> questions;
    bool answer = false;
    std::atomic<bool> stop{false};
    Surroundings surroundings{[&](std::string_view text) { heard += text; }, {}, 40};
    surroundings.ask = [&](std::string_view question) {
        questions.emplace_back(question);
        return answer;
    };
    Prompt asking(options, test::inputs(), surroundings, &stop);
    asking.take("G0 X1");
    asking.take(":save " + file);
    EXPECT_EQ(questions, std::vector<std::string>{"replace " + file + "?"});
    EXPECT_EQ(read_file(file), "mine\n");
    answer = true;
    asking.take(":save " + file);
    EXPECT_TRUE(read_file(file)->starts_with("program prompt()"));
    asking.take(":save " + file);  // it is the prompt's own by now
    EXPECT_EQ(questions.size(), 2u);
    ASSERT_TRUE(write_file_whole(file, "mine\n"));
    Conversation pipe;
    pipe.say("G0 X1");
    EXPECT_EQ(pipe.say(":save " + file), "not written: `" + file + "` is there already\n");
    EXPECT_EQ(pipe.say(":plot " + file), "not written: `" + file + "` is there already\n");
    EXPECT_EQ(read_file(file), "mine\n");
    fs::remove_all(folder);
}

TEST(Prompt, ASavedFileFindsItsImports) {
    const fs::path folder = fs::temp_directory_path() / ("kadr-save-" + std::to_string(::getpid()));
    fs::create_directories(folder / "parts");
    const fs::path before = fs::current_path();
    fs::current_path(folder);
    ASSERT_TRUE(write_file_whole("my.kadr", "cycle hop(length to) { G0 Z=to; }\n"));
    ASSERT_TRUE(write_file_whole("kadr.toml", ""));  // parts/ may import what lies above it
    Conversation talk;
    talk.say(":load my.kadr");
    talk.say("hop(to: 7mm)");
    EXPECT_EQ(talk.say(":save parts/saved.kadr"), "saved in parts/saved.kadr\n");
    EXPECT_EQ(read_file("parts/saved.kadr"),
              "import \"../my.kadr\";\n\nprogram prompt() {\n    hop(to: 7mm);\n}\n");
    EXPECT_EQ(talk.say(":save saved.kadr"), "saved in saved.kadr\n");
    EXPECT_TRUE(read_file("saved.kadr")->starts_with("import \"my.kadr\";"));
    fs::current_path(before);
    fs::remove_all(folder);
}

TEST(Prompt, CompletesModulesAndTheMembersOfTheState) {
    Conversation talk;
    const auto found = [&](std::string_view line) {
        std::string all;
        for (const std::string& name : talk.prompt().completions(line)) all += name + ' ';
        return all;
    };
    EXPECT_EQ(found("import cyc"), "cycles. ");
    EXPECT_EQ(found("import cycles.dri"), "drilling ");
    EXPECT_EQ(found("import cycles.drilling; dri"), "");
    EXPECT_EQ(found("F=state.f"), "feed ");
    EXPECT_EQ(found("state.s"), "scaled speed spindle ");
    for (const std::string& name : talk.prompt().completions("state."))
        EXPECT_EQ(talk.say("state." + name).find("error"), std::string::npos) << name;
}

TEST(Prompt, CompletesNamesWordsAndCommands) {
    Conversation talk;
    talk.say("import cycles.drilling;");
    talk.say("length diameter = 4mm");
    const auto found = [&](std::string_view line) {
        std::string all;
        for (const std::string& name : talk.prompt().completions(line)) all += name + ' ';
        return all;
    };
    EXPECT_EQ(found(":di"), "dialect ");
    EXPECT_EQ(found(":dialect si"), "sinumerik ");
    EXPECT_EQ(found(":machine lat"), "lathe lathe-c lathe-set-up ");
    EXPECT_TRUE(has(found("G0 X=dia"), "diameter "));
    EXPECT_TRUE(has(found("drill_p"), "drill_peck "));
    EXPECT_TRUE(has(found("drill_peck(to: -5mm, pe"), "peck: "));
    EXPECT_TRUE(has(found("whi"), "while "));
    EXPECT_EQ(found("xyzzy"), "");
}

TEST(Prompt, ThePositionIsShown) {
    Conversation talk;
    talk.say("G0 X10 Y20 Z5");
    EXPECT_TRUE(has(talk.say("position"), "10")) << talk.say("position");
    EXPECT_TRUE(has(talk.say("position"), "20"));
    EXPECT_EQ(talk.say("position.x"), "10 mm\n");
}

TEST(Prompt, ARunningEvaluationIsStopped) {
    Conversation talk;
    talk.stop() = true;
    EXPECT_TRUE(has(talk.say("int i = 0; while (true) { i++; }"), "K3410"));
    talk.stop() = false;
    EXPECT_EQ(talk.say("1"), "1\n");
}

TEST(Prompt, AHoleIsOnePlaceInPlan) {
    Conversation talk;
    talk.say("S1000 M3 F100");
    talk.say("G0 X10 Y5 Z5");
    talk.say("G1 Z-3");
    EXPECT_EQ(talk.say(":plot"), "at X 10, Y 5 mm from Z -3 to 5 mm\n");
}

TEST(Sketch, DrawsAtLeastSomething) {
    plot::PlotScene scene;
    EXPECT_EQ(sketch(scene, 40), "nothing has moved\n");
}

}  // namespace

}  // namespace kadr::repl::prompt_test
