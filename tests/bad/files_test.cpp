// What a program from somebody else cannot do to the files of its user: look around in them,
// replace them, fill the disk, take all memory.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/driver/scratch.h"

namespace files_test {

namespace {

namespace fs = std::filesystem;
using kadr::read_file;

class Files : public kadr::test::ScratchFolder {
  protected:
    void SetUp() override {
        ScratchFolder::SetUp();
        fs::create_directories(file("parts/own"));
        fs::create_directories(file("secret"));
        fs::create_directories(file("controls"));
        save("secret/rows.csv", "d\n77777\n");
        save("secret/other.kadr", "length known() { return 77777mm; }\n");
        save("secret/notes.txt", "the password is 77777\n");
        save("parts/own/rows.csv", "d\n5\n");
    }

    static constexpr const char* kRow = "struct row { length d; }\n";

    /// A program that reads a table of this name.
    static std::string reading(const std::string& table) {
        return std::string(kRow) + "program p() { row[] rows = table<row>(\"" + table +
               "\"); G0 X=rows[0].d; M30; }\n";
    }

    /// Runs it in parts/, with these options behind.
    ProcessResult expand(const std::string& program, std::vector<std::string> options = {}) const {
        save("parts/part.kadr", program);
        options.insert(options.begin(), {"expand", file("parts/part.kadr")});
        return kadr(options);
    }
    /// A command line as a shell takes it, in parts/.
    ProcessResult in_parts(const std::string& command) const {
        return run_process({"/bin/sh", "-c", "cd " + file("parts") + " && " + command});
    }
    void expect_refused(const ProcessResult& result, const char* code) const {
        EXPECT_NE(result.status, 0) << result.out;
        EXPECT_NE(result.err.find(code), std::string::npos) << result.err;
        EXPECT_EQ(result.err.find("77777"), std::string::npos) << result.err;
        EXPECT_EQ(result.out, "");
    }
};

// ---------------------------------------------------------------- what is read

TEST_F(Files, BelowTheSourceAreRead) {
    const ProcessResult result = expand(reading("own/rows.csv"));
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("X5"), std::string::npos) << result.out;
}

TEST_F(Files, ElsewhereAreNotReadAndNotShown) {
    fs::create_symlink(file("secret/rows.csv"), file("parts/link.csv"));
    for (const std::string& name :
         {std::string("../secret/rows.csv"), file("secret/rows.csv"),
          std::string("own/../../secret/rows.csv"), std::string("link.csv"),
          std::string("/etc/passwd"), std::string("../secret/no such file")}) {
        SCOPED_TRACE(name);
        expect_refused(expand(reading(name)), "K9032");
        // A name that only the running program knows.
        expect_refused(expand(std::string(kRow) + "program p(string n = \"" + name +
                              "\") { row[] rows = table<row>(n); G0 X=rows[0].d; M30; }\n"),
                       "K9032");
    }
    for (const char* name : {"../secret/other.kadr", "../secret/notes.txt"}) {
        SCOPED_TRACE(name);
        expect_refused(expand("import \"" + std::string(name) + "\";\nprogram p() { M30; }\n"),
                       "K9032");
    }
    expect_refused(
        expand("struct picture { int width; int height; real[] dots; }\nprogram p() { "
               "picture a = image<picture>(\"../secret/rows.csv\"); G0 X=a.width; M30; }\n"),
        "K9032");
}

/// What is proposed lets the file be read: of a link the folder that it leads to.
TEST_F(Files, ElsewhereAreReadAsTheFixSays) {
    fs::create_directories(file("other"));
    fs::create_symlink("../secret/rows.csv", file("parts/link.csv"));
    fs::create_symlink(file("parts/link.csv"), file("parts/twice.csv"));
    fs::create_directory_symlink(file("secret"), file("parts/folder"));
    const std::string secret = file("secret");
    for (const auto& [name, folder] : {std::pair{std::string("link.csv"), secret},
                                       {std::string("twice.csv"), secret},
                                       {std::string("folder/rows.csv"), file("parts/folder")},
                                       {file("secret/rows.csv"), secret}}) {
        SCOPED_TRACE(name);
        const ProcessResult refused = expand(reading(name));
        EXPECT_NE(refused.err.find("`--allow-read " + folder + "`"), std::string::npos)
            << refused.err;
        const ProcessResult read = expand(reading(name), {"--allow-read", folder});
        EXPECT_EQ(read.status, 0) << read.err;
        EXPECT_NE(read.out.find("X77777"), std::string::npos) << read.out;
    }
    // Where a link leads that stands elsewhere itself, is not told.
    fs::create_symlink(file("secret/rows.csv"), file("other/link.csv"));
    const ProcessResult refused = expand(reading("../other/link.csv"));
    EXPECT_EQ(refused.err.find("secret"), std::string::npos) << refused.err;
}

TEST_F(Files, OfAFolderThatTheUserNamesAreRead) {
    const std::string program = reading("../secret/rows.csv");
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--allow-read", file("secret")},
          std::vector<std::string>{"-I", file("secret")}}) {
        const ProcessResult result = expand(program, options);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("X77777"), std::string::npos) << result.out;
    }
    // A project says where its root is.
    save("kadr.toml", "");
    EXPECT_EQ(expand(program).status, 0);
}

TEST_F(Files, OfADialectLieBesideIt) {
    save("controls/mine.xml",
         "<dialect name=\"mine\" title=\"M\" suffix=\"nc\" extends=\"../secret/base.xml\"/>\n");
    const ProcessResult result =
        expand("program p() { M30; }\n", {"-d", file("controls/mine.xml")});
    EXPECT_NE(result.status, 0);
    save("secret/base.xml",
         "<dialect name=\"77777\" title=\"M\" suffix=\"nc\" extends=\"iso\"/>\n");
    expect_refused(expand("program p() { M30; }\n", {"-d", file("controls/mine.xml")}), "K9032");
    save("controls/kind.xml",
         "<dialect name=\"kind\" title=\"M\" suffix=\"nc\" extends=\"./itself.xml\"/>\n");
    save("controls/itself.xml",
         "<dialect name=\"itself\" title=\"M\" suffix=\"nc\" extends=\"./itself.xml\"/>\n");
    const ProcessResult circle =
        expand("program p() { M30; }\n", {"-d", file("controls/kind.xml")});
    EXPECT_NE(circle.status, 0);
    EXPECT_LT(circle.seconds, 5) << circle.err;
}

TEST_F(Files, CalledProgramsBehindALinkAreNotRead) {
    save("secret/HIDDEN.SPF", "R1=77777\nRET\n");
    fs::create_symlink(file("secret/HIDDEN.SPF"), file("parts/HIDDEN.SPF"));
    save("parts/main.mpf", "HIDDEN\nM30\n");
    const ProcessResult result = kadr({"run", file("parts/main.mpf"), "-d", "sinumerik"});
    EXPECT_NE(result.status, 0);
    EXPECT_NE(result.err.find("K9032"), std::string::npos) << result.err;
    EXPECT_EQ(
        kadr({"run", file("parts/main.mpf"), "-d", "sinumerik", "--search", file("secret")}).status,
        0);
}

// A file that is not what it is taken for is shown to nobody.
TEST_F(Files, OfAnotherKindAreNotShown) {
    save("parts/notes.txt", "the password is 77777\n");
    expect_refused(expand("import \"notes.txt\";\nprogram p() { M30; }\n"), "K9033");
    expect_refused(expand(reading("notes.txt")), "K2623");
    save("parts/notes.xml", "the password is 77777\n");
    const ProcessResult dialect = kadr({"dialect", "check", file("parts/notes.xml")});
    EXPECT_NE(dialect.status, 0);
    EXPECT_EQ(dialect.err.find("77777"), std::string::npos) << dialect.err;
}

TEST_F(Files, WithoutAnEndAreReadUpToTheLimit) {
    const ProcessResult source = kadr({"expand", "/dev/zero.kadr"});
    EXPECT_EQ(source.status, 2);
    save("parts/long.kadr", "program p() { M30; }\n" + std::string(9 << 20, ' '));
    EXPECT_EQ(kadr({"expand", file("parts/long.kadr")}).status, 1);
    expect_refused(expand(reading("own/rows.csv"), {"--max-input", "2B"}), "K9031");
    const ProcessResult device = kadr({"run", file("parts/part.kadr"), "-m", "/dev/zero"});
    EXPECT_EQ(device.status, 2) << device.err;
    EXPECT_LT(device.max_rss_kib, 1024 * 1024);
    // A program that is allowed the folder of devices reads none all the same.
    expect_refused(expand(reading("/dev/zero"), {"--allow-read", "/dev"}), "K2402");
}

TEST_F(Files, ThatCannotBeReadSayWhy) {
    const auto says = [](const ProcessResult& result, const char* words) {
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    };
    says(kadr({"run", file("none.kadr")}), "there is no such file");
    says(kadr({"run", file("parts")}), "it is a folder");
    says(kadr({"run", file(std::string(300, 'a') + ".kadr")}), "the name is too long");
    save("parts/part.kadr", "program p() { M30; }\n");
    const std::string part = file("parts/part.kadr");
    says(kadr({"expand", part, "-o", file("none/a.nc")}), "the folder does not exist");
    says(kadr({"expand", part, "-o", file(std::string(300, 'a'))}), "the name is too long");
    says(kadr({"expand", part, "-o", "/dev/full"}), "there is no space left");
    // As long as a name can be, and the neighbour has one of its own.
    EXPECT_EQ(kadr({"expand", part, "-o", file(std::string(255, 'a'))}).status, 0);
}

// ---------------------------------------------------------------- what is written

TEST_F(Files, ThatAreReadAreNotReplaced) {
    save("parts/tool.kadr", "length depth() { return 5mm; }\n");
    const std::string program = "import \"tool.kadr\";\n" + reading("own/rows.csv");
    const auto refuses = [&](const std::string& name, std::vector<std::string> arguments) {
        SCOPED_TRACE(name);
        const auto before = read_file(file(name));
        const ProcessResult result = kadr(arguments);
        EXPECT_EQ(result.status, 2) << result.err;
        EXPECT_NE(result.err.find("K9004"), std::string::npos) << result.err;
        EXPECT_EQ(read_file(file(name)), before);
    };
    save("parts/part.kadr", program);
    const std::string part = file("parts/part.kadr");
    for (const char* name : {"parts/part.kadr", "parts/tool.kadr", "parts/own/rows.csv"}) {
        refuses(name, {"expand", part, "-o", file(name)});
        refuses(name, {"run", part, "--commands", file(name)});
    }
    fs::create_hard_link(file("parts/tool.kadr"), file("parts/hard"));
    refuses("parts/hard", {"expand", part, "-o", file("parts/hard")});
    fs::copy_file(KADR_ROOT "/dialects/iso.xml", file("mine.xml"));
    fs::copy_file(KADR_ROOT "/runtime/machines/mill.xml", file("mill.xml"));
    save("events.txt", "100s feed hold\n101s cycle start\n");
    refuses("mine.xml", {"expand", part, "-d", file("mine.xml"), "-o", file("mine.xml")});
    refuses("mill.xml", {"run", part, "-m", file("mill.xml"), "--plot", file("mill.xml")});
    refuses("events.txt",
            {"run", part, "--events", file("events.txt"), "--commands", file("events.txt")});
    // The cycles of a dialect belong to it, whether the program calls one or not.
    for (const char* name : {"haas.xml", "haas.kadr"})
        fs::copy_file(std::string(KADR_ROOT "/examples/dialects/") + name, file(name));
    save("parts/plain.nc", "O1\nG0 X1.\nM30\n");
    refuses("haas.kadr", {"run", file("parts/plain.nc"), "-d", file("haas.xml"), "--commands",
                          file("haas.kadr")});
    save("parts/SUB.SPF", "G0 X5\nRET\n");
    save("parts/main.mpf", "SUB\nM30\n");
    refuses("parts/SUB.SPF", {"run", file("parts/main.mpf"), "-d", "sinumerik", "--commands",
                              file("parts/SUB.SPF")});
    // Nothing of the other outputs is there either.
    EXPECT_EQ(kadr({"run", file("parts/main.mpf"), "-d", "sinumerik", "--commands", file("c.jsonl"),
                    "--trace", file("parts/SUB.SPF")})
                  .status,
              2);
    EXPECT_FALSE(fs::exists(file("c.jsonl")));
    const ProcessResult piped =
        in_parts(std::string(KADR_BINARY) + " expand - -o part.kadr < part.kadr");
    EXPECT_EQ(piped.status, 2) << piped.err;
    EXPECT_EQ(read_file(part), program);
}

TEST_F(Files, OfAMachineLieBelowTheWorkingFolder) {
    std::string machine = read_file(KADR_ROOT "/runtime/machines/mill.xml").value_or("");
    const std::size_t end = machine.rfind("</machine>");
    ASSERT_NE(end, std::string::npos);
    machine.insert(end, "<pipeline><output period=\"100 ms\" file=\"" + file("taken.csv") +
                            "\"/></pipeline>\n");
    save("mine.xml", machine);
    save("parts/part.kadr", "program p() { G0 X1; M30; }\n");
    const ProcessResult result =
        in_parts(std::string(KADR_BINARY) + " run part.kadr -m " + file("mine.xml"));
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_NE(result.err.find("K9035"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(file("taken.csv")));
}

TEST_F(Files, GrowUpToTheLimit) {
    save("parts/wait.nc", "G0 X10\nG4 P10000000\nM30\n");
    const ProcessResult result =
        kadr({"run", file("parts/wait.nc"), "-d", "fanuc", "--setpoints", file("out.csv"),
              "--commands", file("out.jsonl"), "--max-output", "1MB"});
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_NE(result.err.find("K9034"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(file("out.csv")));
    EXPECT_FALSE(fs::exists(file("out.jsonl")));
    // What was not walked any more has not left its path.
    save("parts/slow.mpf", "T1 M6\nG94 S100 M3\nG1 X100 F1\nM30\n");
    const std::string text = kadr({"run", file("parts/slow.mpf"), "-d", "sinumerik", "--setpoints",
                                   file("out.csv"), "--max-output", "1MB"})
                                 .err;
    EXPECT_NE(text.find("K9034"), std::string::npos) << text;
    EXPECT_EQ(text.find("K6320"), std::string::npos) << text;
    save("parts/part.kadr", "program p() { for (int i = 0; i < 100000; i++) { G0 X=i; } }\n");
    EXPECT_EQ(kadr({"expand", file("parts/part.kadr"), "--max-output", "1kB"}).status, 1);
}

// Definitions that are checked by themselves, and a mistake in them: at its place alone.
TEST_F(Files, OfDefinitionsAreCheckedByThemselves) {
    const auto check = [&](const std::string& text, const std::string& name) {
        save("parts/UGUD.DEF", text);
        return kadr({"check", file("parts/" + name), "-d", "sinumerik"}).err;
    };
    save("parts/main.mpf", "QQ=3\nM30\n");
    for (const char* head : {"", "%_N_UGUD_DEF\n"}) {
        EXPECT_EQ(check(std::string(head) + "DEF NCK REAL QQ\nM17\n", "UGUD.DEF"), "");
        const std::string moves =
            check(std::string(head) + "DEF NCK REAL QQ\nR1=5\nM17\n", "UGUD.DEF");
        EXPECT_NE(moves.find("`UGUD` holds definitions"), std::string::npos) << moves;
    }
    for (const char* name : {"UGUD.DEF", "main.mpf"}) {
        const std::string words = check("DEF NCK REAL QQ\nDEF NCK FOO WW\nM17\n", name);
        EXPECT_NE(words.find("UGUD.DEF:2:9: alarm[12080]"), std::string::npos) << words;
        EXPECT_EQ(words.find("15180"), std::string::npos) << words;
        EXPECT_EQ(words.find("`QQ`"), std::string::npos) << words;
    }
}

// A control that nobody can tell inches gets no program in inches.
TEST_F(Files, OfDialectsWithoutInchesRefuseThem) {
    save("own.xml",
         "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<dialect name=\"own\" extends=\"iso\""
         " title=\"own\" suffix=\"nc\"><remove commands=\"inch\"/></dialect>\n");
    save("parts/part.kadr", "units inch; program p() { G0 X1; }\n");
    const ProcessResult result =
        kadr({"expand", file("parts/part.kadr"), "-d", file("own.xml"), "-o", file("out.nc")});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("K4201"), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(file("out.nc")));
}

// A drawing of a dwell of a hundred years is as quick as one of a second.
TEST_F(Files, OfLongWaitsAreDrawnAtOnce) {
    save("parts/wait.mpf", "G0 X10\nG4 F3000000000\nG0 X20\nM30\n");
    const ProcessResult result = kadr({"run", file("parts/wait.mpf"), "-d", "sinumerik", "--curves",
                                       file("a.svg"), "--page", file("a.html")});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_LT(result.seconds, 20);
}

TEST_F(Files, AreWholeOrNotThereWithoutMemory) {
    save(
        "parts/part.kadr",
        "program p() { int[] a; for (int i = 0; i < 40000000; i++) a.append(i); G0 X=a.count; }\n");
    const std::string run = " expand " + file("parts/part.kadr") + " -o " + file("a.nc");
    for (const char* format : {"text", "json"}) {
        const ProcessResult result = run_process(
            {"/bin/sh", "-c",
             "ulimit -v 300000; " + std::string(KADR_BINARY) + run + " --diagnostics " + format});
        EXPECT_EQ(result.status, 1) << result.err;
        EXPECT_NE(result.err.find("K9030"), std::string::npos) << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
        EXPECT_FALSE(fs::exists(file("a.nc")));
    }
}

TEST_F(Files, ThatAreFullEndWithStatusTwo) {
    for (const char* command :
         {"explain", "explain K9001", "--help", "dialect list", "dialect explain fanuc"}) {
        SCOPED_TRACE(command);
        const ProcessResult result = run_process(
            {"/bin/sh", "-c", std::string(KADR_BINARY) + ' ' + command + " > /dev/full"});
        EXPECT_EQ(result.status, 2) << result.err;
    }
    EXPECT_EQ(
        run_process({"/bin/sh", "-c", std::string(KADR_BINARY) + " repl > /dev/full"}, "1 + 1\n")
            .status,
        2);
}

// ---------------------------------------------------------------- what reaches the terminal

TEST_F(Files, SendNoCommandsToTheTerminal) {
    const std::string escape = "\x1b[2J";
    const auto is_clean = [](const ProcessResult& result) {
        EXPECT_EQ((result.out + result.err).find('\x1b'), std::string::npos) << result.err;
    };
    save("parts/alarm.nc", "#3000=1(" + escape + ")\nM30\n");
    const ProcessResult alarm = kadr({"run", file("parts/alarm.nc"), "-d", "fanuc"});
    is_clean(alarm);
    EXPECT_NE(alarm.err.find("\\x1b[2J"), std::string::npos) << alarm.err;
    is_clean(kadr({"run", file("parts/alarm.nc"), "-d", "fanuc", "--trace", "-"}));
    save("parts/alarm.mpf", "SETAL(65000,\"" + escape + "\")\nM30\n");
    is_clean(kadr({"run", file("parts/alarm.mpf"), "-d", "sinumerik"}));
    save("parts/own/rows.csv", "d," + escape + "\n5,6\n");
    is_clean(expand(reading("own/rows.csv")));
    is_clean(kadr({"run", file(escape + ".kadr")}));
    save("parts/" + escape + ".nc", "G0 X1\nM30\n");
    is_clean(kadr({"run", file("parts/" + escape + ".nc"), "-d", "fanuc"}));
}

TEST_F(Files, WithLongLinesGiveShortMessages) {
    const std::string name(3'000'000, 'a');
    const ProcessResult result = expand("program p() { G0 X=" + name + "; M30; }\n");
    EXPECT_EQ(result.status, 1);
    EXPECT_LT(result.err.size(), 10'000u);
    EXPECT_NE(result.err.find("… (3000000 characters)"), std::string::npos) << result.err;
    save("parts/long.mpf", "G1 " + name + "\nM30\n");
    const ProcessResult text = kadr({"run", file("parts/long.mpf"), "-d", "sinumerik"});
    EXPECT_NE(text.status, 0);
    EXPECT_LT(text.err.size(), 20'000u);
}

// ---------------------------------------------------------------- values from outside

TEST_F(Files, WithOldLineEndsAreTables) {
    for (const char* rows : {"d\r5\r7\r", "d\r\n5\r\n7\r\n", "d\n5\n7\n", "d\r5\r7"}) {
        save("parts/own/rows.csv", rows);
        const ProcessResult result =
            expand(std::string(kRow) +
                   "program p() { row[] rows = table<row>(\"own/rows.csv\"); "
                   "for (row r : rows) G0 X=r.d; M30; }\n");
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("X7"), std::string::npos) << result.out;
    }
    save("parts/own/rows.csv", "d\n1E+02\n");  // as spreadsheets write it
    EXPECT_NE(expand(reading("own/rows.csv")).out.find("X100"), std::string::npos);
}

/// Programs, events and machines whose lines end with CR alone say what they say with LF, and
/// messages name the same lines.
TEST_F(Files, WithOldLineEndsAreTexts) {
    struct Text {
        const char* name;
        std::string text;
        std::vector<std::string> arguments;
        const char* said;
    };
    const std::string machine = read_file(KADR_ROOT "/runtime/machines/mill.xml").value_or("");
    const std::string part = file("parts/part.nc");
    for (const Text& row :
         {Text{"parts/old.kadr",
               "// holes\nprogram p() {\n  G0 X1;  // one\n  G0 X=wide;\n  M30;\n}\n",
               {"expand", file("parts/old.kadr")},
               "old.kadr:4:8"},
          {"parts/old.nc",
           "%\nO0001\n\nG0 X1.\nG1 X2 F100 G777\nM30\n%\n",
           {"run", file("parts/old.nc"), "-d", "fanuc"},
           "old.nc:5:12"},
          {"parts/events.txt",
           "1s feed hold\n2s cycle start\nnow\n",
           {"run", part, "-d", "fanuc", "--events", file("parts/events.txt")},
           "events.txt:3:1"},
          {"parts/values.txt",
           "%\n#500=12.5\n#501=3\n%\n",
           {"run", part, "-d", "fanuc", "--variables-in", file("parts/values.txt"), "--variables",
            "-"},
           ""},
          {"parts/mill.xml",
           machine,
           {"run", part, "-d", "fanuc", "-m", file("parts/mill.xml")},
           ""}}) {
        SCOPED_TRACE(row.name);
        save("parts/part.nc", "%\nO0001\nT1 M6\nS1000 M3\nG1 X20. F100\nM30\n%\n");
        save(row.name, row.text);
        const ProcessResult wanted = kadr(row.arguments);
        EXPECT_NE(wanted.err.find(row.said), std::string::npos) << wanted.err;
        std::string old = row.text;
        std::ranges::replace(old, '\n', '\r');
        save(row.name, old);
        const ProcessResult result = kadr(row.arguments);
        EXPECT_EQ(result.status, wanted.status);
        EXPECT_EQ(result.out, wanted.out);
        EXPECT_EQ(result.err, wanted.err);
    }
}

TEST_F(Files, ValuesOfOptionsAreReadOrRefused) {
    const std::string program = "program p(length r = 1mm) { G0 X=r; M30; }\n";
    for (const char* value : {"r=1e2", "r=1E+2mm", "r=+1e2", "r=1000e-1mm"}) {
        const ProcessResult result = expand(program, {"-D", value});
        EXPECT_NE(result.out.find("X100"), std::string::npos) << value << '\n' << result.err;
    }
    for (const char* value : {"r=1e", "r=1e999", "r=e2"})
        EXPECT_EQ(expand(program, {"-D", value}).status, 1) << value;
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--tick", ""}, std::vector<std::string>{"--max-time", ""},
          std::vector<std::string>{"-d", ""}, std::vector<std::string>{"--max-output", "much"}}) {
        std::vector<std::string> arguments = {"run", file("parts/part.kadr")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProcessResult result = kadr(arguments);
        EXPECT_EQ(result.status, 2) << options[0];
        EXPECT_NE(result.err.find(options[0]), std::string::npos) << result.err;
    }
}

// ---------------------------------------------------------------- time

// Near linear in what there is to read, or a limit with a message.
TEST_F(Files, OfManyPartsAreReadInTime) {
    std::string locals = "program p() {\n";
    for (int i = 0; i < 30000; ++i) locals += "int a" + std::to_string(i) + " = 1;\n";
    std::string calls = "program p() {\n";
    for (int i = 0; i < 100000; ++i) calls += "f" + std::to_string(i) + "();\n";
    std::string columns = "d";
    std::string cells = "5";
    for (int i = 0; i < 200000; ++i) columns += ",c" + std::to_string(i), cells += ",1";
    save("parts/own/wide.csv", columns + '\n' + cells + '\n');
    for (const std::string& program :
         {locals + "M30; }\n", calls + "M30; }\n", reading("own/wide.csv")}) {
        const ProcessResult result = expand(program);
        EXPECT_LT(result.seconds, 30) << result.err.substr(0, 500);
        EXPECT_LT(result.err.size(), 200'000u);
    }
}

TEST_F(Files, AreCheckedInTheTimeThatThereIs) {
    std::string blocks = "program p() {\n";
    for (int i = 0; i < 200000; ++i) blocks += "G0 X=" + std::to_string(i) + "*2;\n";
    save("parts/part.kadr", blocks + "}\n");
    const ProcessResult result = kadr({"check", file("parts/part.kadr"), "--max-time", "0.1s"});
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_NE(result.err.find("K3405"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("K1"), std::string::npos) << result.err;
    EXPECT_LT(result.seconds, 10);
}

}  // namespace

}  // namespace files_test
