// The canonical layout: what changes, what stays, and that a second run changes nothing.
#include "syntax/format.h"

#include <filesystem>
#include <random>
#include <regex>

#include "base/disk_files.h"
#include "base/text.h"
#include "tests/syntax/parsing.h"

namespace kadr::syntax::format_test {

namespace {

namespace fs = std::filesystem;

/// The layout of a text; empty, with the messages as a failure of the test, if it has mistakes.
std::string formatted(const std::string& text) {
    Sources sources;
    DiagnosticList list;
    const FileId file = sources.add("part.kadr", text);
    const SourceHeader header = scan_header(sources.text(file));
    const auto out =
        format(sources, file, keywords(header.language.empty() ? "en" : header.language),
               dialect(header.dialect.empty() ? "iso" : header.dialect), list);
    for (const Diagnostic& diagnostic : list.all()) {
        ADD_FAILURE() << render_text(diagnostic, sources);
    }
    return out.value_or("");
}

/// Statements as the layout of a cycle's body, without the four blanks of its level.
std::string formatted_statements(const std::string& text) {
    const std::string whole = formatted("cycle test(length a, length r, int i) {\n" + text + "\n}");
    const std::size_t begin = whole.find('\n') + 1;
    const std::string body = whole.substr(begin, whole.size() - begin - 2);
    return std::regex_replace(body, std::regex("(^|\n)    "), "$1");
}

TEST(Format, BlocksOfAnInputDialectStay) {
    EXPECT_EQ(formatted("dialect   fanuc;\nprogram p( ) {\nG00   G17 G21 G40;   // start\n"
                        " /G01 X10.   F100.;\n/2   G01 X-10.5 Y.5;\n N10 G54.1   P2;\n"
                        "G51.1 X0.;  G04 P500;\nG01   X=5+3   Y= 2*3;\n}\n"),
              "dialect fanuc;\n\nprogram p() {\n    G00 G17 G21 G40;    // start\n"
              "    /G01 X10. F100.;\n    /2 G01 X-10.5 Y.5;\n    N10 G54.1 P2;\n"
              "    G51.1 X0.; G04 P500;\n    G01 X=5 + 3 Y=2*3;\n}\n");
    EXPECT_EQ(formatted("dialect sinumerik;\nprogram p( ) {\n G17   G500 G642 CFC;\n T3  D1;M6;\n"
                        "G2 X10  Y10   I=AC( 5 ) J=IC(0);\nG0  SUPA Z0 D0; X1 Y1;\n"
                        "AROT   RPL=30; ATRANS;\n MSG( \"hello\" );\n}\n"),
              "dialect sinumerik;\n\nprogram p() {\n    G17 G500 G642 CFC;\n    T3 D1; M6;\n"
              "    G2 X10 Y10 I=AC(5) J=IC(0);\n    G0 SUPA Z0 D0; X1 Y1;\n"
              "    AROT RPL=30; ATRANS;\n    MSG(\"hello\");\n}\n");
}

TEST(Format, StatementsHaveOneLayout) {
    const std::vector<Row> rows = {
        // blanks
        {"G1   X=r*cos( a )Y = a-r  F200;", "G1 X=r*cos(a) Y=a - r F200;\n"},
        {"X +=10mm Y-= r ;", "X+=10mm Y-=r;\n"},
        {"a=-r;a = - r*2; a=r- -1;", "a = -r;\na = -r*2;\na = r - -1;\n"},
        {"i ++; --i;", "i++;\n--i;\n"},
        {"a = i>0 ? r:a ;", "a = i > 0 ? r : a;\n"},
        // a block of its own behind a statement, and behind a case
        {"X1; {X2;}", "X1;\n{ X2; }\n"},
        {"note \"a\"; {\nX2;\n}", "note \"a\";\n{\n    X2;\n}\n"},
        {"switch (i) { case 1: {X1;} break; case 2: X2; {X3;} default: {} }",
         "switch (i) {\n    case 1: { X1; }\n        break;\n    case 2:\n        X2;\n"
         "        { X3; }\n    default: {}\n}\n"},
        {"bool b = !(i%2==0)||b;", "bool b = !(i % 2 == 0) || b;\n"},
        {"length [ ] l={1,2 , 3};", "length[] l = {1, 2, 3};\n"},
        {"length ? b ;", "length? b;\n"},
        {"G2 X10 Y0 I = AC( 5 ) J = IC(a);", "G2 X10 Y0 I=AC(5) J=IC(a);\n"},
        {"G1 { 1 , 2 }; G1 {a,r}+{1,1};", "G1 {1, 2}; G1 {a, r} + {1, 1};\n"},
        {"drill( to :-r,peck:3mm );", "drill(to: -r, peck: 3mm);\n"},
        {"F 200;", "F200;\n"},
        {"note\"a{ r  } b\" ;", "note \"a{ r  } b\";\n"},
        {"for(int j=0;j<i;j++)G1 X=j;", "for (int j = 0; j < i; j++) G1 X=j;\n"},
        {"for(length l:list)G1 X=l;", "for (length l : list) G1 X=l;\n"},
        {"for(int k:0..i-1)X=k; for (int k : 1 .. 3) X=k;",
         "for (int k : 0 .. i - 1) X=k;\nfor (int k : 1..3) X=k;\n"},
        {"auto t=table<hole>( \"f.csv\" );", "auto t = table<hole>(\"f.csv\");\n"},
        {"return(a);", "return (a);\n"},
        // lines
        {"S2400 M3;M8;\nF180;", "S2400 M3; M8;\nF180;\n"},
        {"M8; a = r; M9;", "M8;\na = r;\nM9;\n"},
        {"M8;\n\n\n\nM9;", "M8;\n\nM9;\n"},
        {"\n\nM8;\n\n", "M8;\n"},
        {"if(i==0)M8;else M9;", "if (i == 0) M8;\nelse M9;\n"},
        {"if (i == 0)\n  M8;\nelse\n  if (i == 1) M9;", "if (i == 0) M8;\nelse if (i == 1) M9;\n"},
        {"if (i == 0)\n{\n M8;\n}\nelse\n{\n M9;\n}",
         "if (i == 0) {\n    M8;\n} else {\n    M9;\n}\n"},
        {"if (i == 0) { M8; } else { M9; M5; }", "if (i == 0) { M8; }\nelse { M9; M5; }\n"},
        {"if (i == 0) {M8;}", "if (i == 0) { M8; }\n"},
        {"while (i < 3) { }", "while (i < 3) {}\n"},
        {"do\n{\ni++;\n}\nwhile(i<3);", "do {\n    i++;\n} while (i < 3);\n"},
        {"do {i++;} while(i<3);  // on", "do { i++; } while (i < 3);    // on\n"},
        {"do { i++; }\nwhile(i<3);", "do { i++; } while (i < 3);\n"},
        {"do i++; while(i<3);", "do\n    i++;\nwhile (i < 3);\n"},
        {"switch(i){case 1,2: M8;break;\ncase 3 ..5:\nM9;\nbreak;default:M5;}",
         "switch (i) {\n    case 1, 2: M8; break;\n    case 3..5:\n        M9;\n        break;\n"
         "    default: M5;\n}\n"},
        {"with G91,F100{X1;}", "with G91, F100 { X1; }\n"},
        {"with shift(x:1mm)rotate( 30deg )\n{X1;\n}",
         "with shift(x: 1mm) rotate(30deg) {\n    X1;\n}\n"},
        {"raw { G65 P1 \n  X2 }\nM8;", "raw { G65 P1 \n  X2 }\nM8;\n"},
        // comments
        {"M8; // on\nM9;   // off, later", "M8;    // on\nM9;    // off, later\n"},
        {"X=a*r; // one\nX1; /* two */\n", "X=a*r;    // one\nX1;       /* two */\n"},
        {"// before\nM8;\n\n// after  \n", "// before\nM8;\n\n// after\n"},
        {"a = r + // first\n    1mm;", "a = r + // first\n    1mm;\n"},
        {"drill(to: -r, /* fast */ peck: 3mm);", "drill(to: -r, /* fast */ peck: 3mm);\n"},
        {"if (i == 0) // why\n    M8;", "if (i == 0)    // why\n    M8;\n"},
        // what a comment silences is a line
        {"int c=5;int d=6; // kadr: allow K2501 later",
         "int c = 5; int d = 6;    // kadr: allow K2501 later\n"},
        {"// kadr: allow K2501\nint c=5;  int d=6;\nint e=7; int f=8;",
         "// kadr: allow K2501\nint c = 5; int d = 6;\nint e = 7;\nint f = 8;\n"},
        {"// kadr: allow K2501\n\nint c=5; int d=6;",
         "// kadr: allow K2501\n\nint c = 5;\nint d = 6;\n"},
        {"if (i == 0) M8; int d=6; // kadr: allow K2501",
         "if (i == 0) M8; int d = 6;    // kadr: allow K2501\n"},
        {"length name_of_a_long_one=a+r+a+r; length name_of_another_long_one=a+r+a+r+a+r+a+r+a+r; "
         "// kadr: allow K2501",
         "length name_of_a_long_one = a + r + a + r; "
         "length name_of_another_long_one = a + r + a + r + a + r + a + r + a + r;    "
         "// kadr: allow K2501\n"},
        {"int c=5; int d=6; // the two", "int c = 5;\nint d = 6;    // the two\n"},
        // a quotient is no unit
        {"a=cos( i*360deg/i );", "a = cos(i*360deg/i);\n"},
        {"a=200mm / min;", "a = 200mm / min;\n"},
        {"a=200mm/min;", "a = 200mm/min;\n"},
        {"a=20s / min;", "a = 20s/min;\n"},
        // line ends of another system
        {"raw {\r\n  G91\r\n  X1\r\n}\r\nM8;\r\n", "raw {\n  G91\n  X1\n}\nM8;\n"},
        // rows of values
        {"length[] l = {1, 2,\n3, 4};", "length[] l = {1, 2,\n              3, 4};\n"},
        {"length[] l = {\n1, 2,\n3, 4\n};", "length[] l = {\n    1, 2,\n    3, 4\n};\n"},
        // … but inside of a call a list is filled, unless its first row stands below the brace
        {"f(1, {1, 2,\n3, 4});", "f(1, {1, 2, 3, 4});\n"},
        {"f(1, {\n1, 2,\n3, 4\n});", "f(1, {\n    1, 2,\n    3, 4\n});\n"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.text);
        EXPECT_EQ(formatted_statements(row.text), row.expected);
        EXPECT_EQ(formatted_statements(row.expected), row.expected);
    }
}

TEST(Format, DeclarationsHaveOneLayout) {
    const std::vector<Row> rows = {
        {"#include   \"holes.kadr\"\nint f(int a) { a<<=2; return a; }",
         "#include   \"holes.kadr\"\nint f(int a) { a <<= 2; return a; }\n"},
        {"import cycles . drilling;\nconst length r=5mm ;",
         "import cycles.drilling;\nconst length r = 5mm;\n"},
        {"struct hole{point at;length d=8mm;}", "struct hole { point at; length d = 8mm; }\n"},
        {"struct hole{\npoint at; length d;}", "struct hole {\n    point at;\n    length d;\n}\n"},
        {"enum side{left,right}", "enum side { left, right }\n"},
        {"enum side{left, // L\nright=3,}", "enum side {\n    left,    // L\n    right = 3,\n}\n"},
        {"void f(){M8;}\nvoid g(){M9;}", "void f() { M8; }\nvoid g() { M9; }\n"},
        {"/// F.\nvoid f(){\nM8;}\n/// G.\nvoid g(){\nM9;}\nconst int n=1;",
         "/// F.\nvoid f() {\n    M8;\n}\n\n/// G.\nvoid g() {\n    M9;\n}\n\nconst int n = 1;\n"},
        {"contour c={G1 X0;X60;close;};", "contour c = { G1 X0; X60; close; };\n"},
        {"curve e(length a)over angle t=0deg..360deg{x=a*cos(t);}",
         "curve e(length a) over angle t = 0deg..360deg { x = a*cos(t); }\n"},
        {"property \"p\"(length w in 20mm..200mm){\nassume(w>1);}",
         "property \"p\" (length w in 20mm..200mm) {\n    assume(w > 1);\n}\n"},
        {"cycle long_name(length first, length second, length third, length fourth, length fifth, "
         "length sixth) preserves G90, G17 {\nM8;\n}",
         "cycle long_name(length first, length second, length third, length fourth, length fifth,\n"
         "                length sixth)\n"
         "        preserves G90, G17 {\n    M8;\n}\n"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.text);
        EXPECT_EQ(formatted(row.text), row.expected);
        EXPECT_EQ(formatted(row.expected), row.expected);
    }
}

/// Every Kadr program of the tree that has no syntax error.
std::vector<std::string> programs() {
    std::vector<std::string> texts;
    for (const char* folder : {"/stdlib", "/examples", "/tests/golden"}) {
        for (const auto& entry :
             fs::recursive_directory_iterator(KADR_ROOT + std::string(folder))) {
            if (entry.path().extension() != ".kadr") continue;
            texts.push_back(read_file(entry.path()).value_or(""));
        }
    }
    return texts;
}

TEST(Format, LinesFitAndASecondRunChangesNothing) {
    for (const std::string& text : programs()) {
        const std::string once = formatted(text);
        EXPECT_EQ(formatted(once), once);
    }
}

/// The text with other blanks wherever there are blanks: more, fewer, other line ends.
std::string respaced(const std::string& text, std::mt19937& random) {
    std::string out;
    bool in_text = false;
    bool in_comment = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\n') in_text = in_comment = false;
        if (c == '"' && !in_comment) in_text = !in_text;
        if (text.compare(i, 2, "//") == 0 && !in_text) in_comment = true;
        // The indentation stays: it tells a statement that goes on from a forgotten `;`.
        const bool is_indent = text.find_first_not_of(' ', text.rfind('\n', i) + 1) > i;
        if (c == ' ' && !in_comment && !in_text && !is_indent) {
            out.append(1 + random() % 3, ' ');
        } else if (c == '\n') {
            out += random() % 2 == 0 ? "\n" : "  \r\n";
        } else {
            out += c;
        }
    }
    return out;
}

TEST(Format, BlanksDoNotMatter) {
    std::mt19937 random(7);
    for (const std::string& text : programs()) {
        if (text.find("raw") != std::string::npos) continue;  // raw lines keep their blanks
        EXPECT_EQ(formatted(respaced(text, random)), formatted(text));
    }
}

/// The text with many of its line ends taken away: functions and their bodies share long lines.
std::string with_joined_lines(const std::string& text, std::mt19937& random, unsigned kept_of_ten) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = std::min(text.find('\n', i), text.size() - 1);
        const std::string line = text.substr(i, end - i);
        i = end + 1;
        const bool ends_itself = line.find("//") != std::string::npos || line.starts_with('#');
        const bool begins_line = text[i] == '#';
        out += line;
        out += ends_itself || begins_line || random() % 10 < kept_of_ten ? "\n" : " ";
    }
    return out;
}

TEST(Format, LongLinesKeepTheirMeaning) {
    std::mt19937 random(31);
    for (const std::string& text : programs()) {
        if (text.find("raw") != std::string::npos) continue;
        for (const unsigned kept : {0u, 2u, 5u, 8u}) {
            const std::string joined = with_joined_lines(text, random, kept);
            const std::string once = formatted(joined);  // it holds the tree against the old one
            EXPECT_EQ(formatted(once), once) << joined;
        }
    }
}

TEST(Format, BodiesInOneLineThatDoNotFitAreBroken) {
    const std::string words(85, 'w');
    EXPECT_EQ(formatted("void c(length p) { require(p > 1mm, \"" + words + "\"); }"),
              "void c(length p) {\n    require(p > 1mm,\n            \"" + words + "\");\n}\n");
    EXPECT_EQ(formatted("void c(length p) { for (int i : 1..2) error(\"" + words + words +
                        "\" + text(p)); }"),
              "void c(length p) {\n    for (int i : 1..2)\n        error(\"" + words + words +
                  "\" +\n              text(p));\n}\n");
    std::string names;
    std::string rows;
    for (int i = 0; i < 20; ++i) {
        const std::string name = "name_" + std::to_string(i) + (i < 19 ? "," : "");
        names += name + ' ';
        rows += "    " + name + '\n';
    }
    EXPECT_EQ(formatted("enum e { " + names + "}"), "enum e {\n" + rows + "}\n");
}

TEST(Format, AMistakeIsReportedAndNothingComesBack) {
    Sources sources;
    DiagnosticList list;
    const FileId file = sources.add("part.kadr", "cycle f( { }");
    EXPECT_FALSE(format(sources, file, keywords("en"), dialect("iso"), list).has_value());
    EXPECT_TRUE(list.has_errors());
}

}  // namespace

}  // namespace kadr::syntax::format_test
