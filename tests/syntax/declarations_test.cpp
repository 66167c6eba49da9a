// Everything that stands at the level of a file, whole programs, and other keyword languages.
#include "parsing.h"

namespace kadr::syntax::declarations_test {
namespace {

TEST(Declarations, EachKind) {
    for (const Row& row : {
             Row{"", ""},
             {";", ""},
             {"import cycles.drilling;", "(import cycles.drilling)"},
             {"import test.note;", "(import test.note)"},
             {"import \"holes.kadr\";", "(import \"holes.kadr\")"},
             {"#include \"holes.kadr\"", "(import \"holes.kadr\")"},
             {"#include \"holes.kadr\"\nconst int n = 1;",
              "(import \"holes.kadr\")\n(var const int n 1)"},
             {"#include \"a.kadr\" // what for\n#include \"b.kadr\" const int n = 1;",
              "(import \"a.kadr\")\n(import \"b.kadr\")\n(var const int n 1)"},
             {"# include <cycles/drilling.kadr>;", "(import \"cycles/drilling.kadr\")"},
             {"units mm;", "(units mm)"},
             {"dialect fanuc;", "(dialect fanuc)"},
             {"language en;", "(language en)"},
             {"const length c = 5mm;", "(var const length c 5mm)"},
             {"real[] list;", "(var real[] list)"},
             {"auto v = {1, 2};", "(var auto v (braces 1 2))"},
             {"const auto k = 2;", "(var const auto k 2)"},
             {"length half(length a) { return a / 2; }",
              "(function length half\n  (param length a)\n  (return (/ a 2)))"},
             {"length[]\nhalves(length a)\n{ return {a / 2}; }",
              "(function length[] halves\n  (param length a)\n  (return (braces (/ a 2))))"},
             {"point[4]\ncorners;", "(var point[4] corners)"},
             {"void swap(real& a, real& b) { }",
              "(function void swap\n  (param real& a)\n  (param real& b))"},
             {"length a = max(b, c & d);", "(var length a (call max b (& c d)))"},
             {"struct hole { point at; length d = 5mm; length[] r; };",
              "(struct hole\n  (var point at)\n  (var length d 5mm)\n  (var length[] r))"},
             {"enum side { left, right = 5, top, }", "(enum side left (= right 5) top)"},
             {"enum none { }", "(enum none)"},
             {"cycle f(length a, length? b) preserves G90, G17, frames { }",
              "(cycle f (preserves G90 G17 FRAMES)\n  (param length a)\n  (param length? b))"},
             {"program p(int n = 3) { M30; }", "(program p\n  (param int n 3)\n  (words M30))"},
             {"program p(length[] r, hole[4] h) preserves G90 { }",
              "(program p (preserves G90)\n  (param length[] r)\n  (param hole[4] h))"},
             {"contour outline = { G1 X0 Y0; X60; close; };",
              "(contour outline\n  (words G1 X0 Y0)\n  (words X60)\n  (close))"},
             {"curve ellipse(length a) over angle t = 0deg .. 360deg { x = a*cos(t); }",
              "(curve ellipse\n  (param length a)\n  (var angle t) (.. 0deg 360deg)\n"
              "  (do (= x (* a (call cos t)))))"},
             {"test \"six\" { expect(a == b); }", "(test \"six\"\n  (expect (== a b)))"},
             {"property \"walls\" (length w in 20mm..200mm, bool b in {true, false}) { assume(w > "
              "1mm); }",
              "(property \"walls\"\n  (param length w (.. 20mm 200mm))\n"
              "  (param bool b (braces true false))\n  (assume (> w 1mm)))"},
         }) {
        EXPECT_EQ(parsed(row.text), row.expected) << row.text;
    }
}

TEST(Declarations, Documentation) {
    EXPECT_EQ(parsed("/// Drills.\n/// Twice.\ncycle a(\n    /// mm\n    length d) { }\n"
                     "/// lost\n\nint x;\n// not one\nint y;"),
              "(cycle a (doc \"Drills.\\nTwice.\")\n  (param length d (doc \"mm\")))\n"
              "(var int x (doc \"lost\"))\n(var int y)");
}

TEST(Declarations, CommentsAreKept) {
    const Parsed result("// one\n/* two\n */ int a; /// three\nint b;");
    ASSERT_EQ(result.ast.comments.size(), 3u);
    EXPECT_EQ(result.sources.text(result.ast.comments[1].range), "/* two\n */");
    EXPECT_TRUE(result.ast.comments[2].is_documentation);
}

TEST(Declarations, OtherKeywordLanguages) {
    EXPECT_EQ(parsed("language ru;\n"
                     "цикл отверстия(длина d, целое n) сохраняет G90 {\n"
                     "    для (целое i = 0; i < n; i++) {\n"
                     "        если (i % 2 == 0 и не (i == 4)) G0 X=d/2*cos(i*360deg/n);\n"
                     "        иначе продолжить;\n"
                     "    }\n"
                     "    вещественное доля = вещественное(n);\n"
                     "}\n"
                     "программа главная() { отверстия(d: 50mm, n: 6); M30; }"),
              "(language ru)\n"
              "(cycle отверстия (preserves G90)\n"
              "  (param length d)\n"
              "  (param int n)\n"
              "  (for\n"
              "    (var int i 0) (< i n) (post++ i)\n"
              "    (block\n"
              "      (if (&& (== (% i 2) 0) (! (== i 4)))\n"
              "        (words G0 (X= (* (/ d 2) (call cos (/ (* i 360deg) n)))))\n"
              "        (continue))))\n"
              "  (var real доля (call real n)))\n"
              "(program главная\n"
              "  (do (call отверстия d: 50mm n: 6))\n"
              "  (words M30))");
    EXPECT_EQ(parsed("language uk;\nцикл а() { якщо (істина) M8; інакше M9; }"),
              "(language uk)\n(cycle а\n  (if true\n    (words M8)\n    (words M9)))");
    EXPECT_EQ(parsed("język pl;\ncykl a() { dopóki (prawda) przerwij; }"),
              "(language pl)\n(cycle a\n  (while true\n    (break)))");
}

TEST(Declarations, Header) {
    struct HeaderRow {
        const char* text;
        const char* language;
        const char* dialect;
    };
    for (const HeaderRow& row : {
             HeaderRow{"", "", ""},
             {"language ru;", "ru", ""},
             {"// a part\n/* of\n two */ язык ru ; dialect fanuc;", "ru", "fanuc"},
             {"dialect \"fanuc-lathe\";", "", "fanuc-lathe"},
             {"dialect fanuc-lathe;", "", "fanuc-lathe"},
             // A text may be the name of a file, and what stands behind it is not lost.
             {"dialect \"./my haas.xml\"; language ru;", "ru", "./my haas.xml"},
             {"dialect \"\"; language ru;", "ru", ""},
             {"dialect \"a\nb\"; language ru;", "", ""},
             {"units mm; мова uk;", "uk", ""},
             {"import a.b; language ru;", "ru", ""},
             {"program p() { } language ru;", "", ""},
             {"language", "", ""},
             {"language ru", "", ""},
             {"/* language ru;", "", ""},
         }) {
        const SourceHeader header = scan_header(row.text);
        EXPECT_EQ(header.language, row.language) << row.text;
        EXPECT_EQ(header.dialect, row.dialect) << row.text;
    }
}

}  // namespace
}  // namespace kadr::syntax::declarations_test
