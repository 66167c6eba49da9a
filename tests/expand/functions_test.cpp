// Functions, cycles, references, files.
#include <gtest/gtest.h>

#include "tests/sema/running.h"

namespace kadr::testing::functions_test {
namespace {

struct Row {
    const char* source;
    const char* blocks;
};

void expect_rows(std::initializer_list<Row> rows) {
    for (const Row& row : rows) {
        SCOPED_TRACE(row.source);
        const Outcome outcome = run(row.source);
        EXPECT_EQ(outcome.all_messages(), "");
        EXPECT_EQ(outcome.all_blocks(), row.blocks);
    }
}

TEST(Functions, Arguments) {
    expect_rows({
        {"cycle f(length a, length b = a*2, length c = a + b) { X=a Y=b Z=c; }\n"
         "program p() { f(1); f(1, 5); f(1, c: 9); f(b: 3, a: 1); }",
         "X1 Y2 Z3\nX1 Y5 Z6\nX1 Y2 Z9\nX1 Y3 Z4"},
        {"cycle f(length a, length? b) { X=a; if (given b) Y=b; }\nprogram p() { f(1); f(1, 2); }",
         "X1\nX1\nY2"},
        {"cycle f(point? a) { if (given a) G1 a; else M8; }\nprogram p() { f(); f({1mm, 2mm}); }",
         "coolant_flood\nline X1 Y2"},
        {"cycle f(length? b) { X=b ?? 7mm; }\nprogram p() { length? n; f(); f(n); f(b: 3mm); }",
         "X7\nX7\nX3"},
        {"int fib(int n) { if (n < 2) return n; return fib(n - 1) + fib(n - 2); }\n"
         "program p() { X=fib(15); }",
         "X610"},
        {"point middle(point a, point b) { return (a + b)/2; }\n"
         "program p() { G1 middle({0mm, 0mm}, {4mm, 8mm}); }",
         "line X2 Y4"},
    });
}

TEST(Functions, References) {
    expect_rows({
        {"void swap(int& a, int& b) { int t = a; a = b; b = t; }\n"
         "program p() { int x = 1; int y = 2; swap(x, y); X=x Y=y; }",
         "X2 Y1"},
        {"void grow(int[]& a) { a.append(7); }\nprogram p() { int[] a; grow(a); grow(a); X=a.count "
         "Y=a[1]; }",
         "X2 Y7"},
        {"void set(length& v) { v = 5mm; }\n"
         "struct hole { point at; length d; }\n"
         "program p() { hole[] h = {{{1mm, 2mm}, 3mm}}; set(h[0].d); X=h[0].d; hole g = h[0]; "
         "set(g.d); }",
         "X5"},
        {"void inner(int& a) { a += 1; }\nvoid outer(int& a) { inner(a); a *= 10; }\n"
         "program p() { int x = 1; outer(x); X=x; }",
         "X20"},
        {"int total = 0;\nvoid add(int n) { total += n; }\nvoid reset(int& n) { n = 0; }\n"
         "program p() { add(3); add(4); X=total; reset(total); X=total; }",
         "X7\nX0"},
        // By value: the caller's array stays as it is.
        {"void change(int[] a) { a[0] = 9; }\nprogram p() { int[] a = {1}; change(a); X=a[0]; }",
         "X1"},
        {"struct s { int[] a; }\nvoid change(s v) { v.a[0] = 9; }\n"
         "program p() { s v = {{1}}; change(v); s w = v; w.a[0] = 5; X=v.a[0] Y=w.a[0]; }",
         "X1 Y5"},
    });
}

TEST(Functions, Globals) {
    expect_rows({
        {"const length clear = 2*top;\nconst length top = 5mm;\nprogram p() { Z=clear; }", "Z10"},
        {"const int[] sizes = {3, 1, 2};\nint sum() { int s = 0; for (int n : sizes) s += n; "
         "return s; }\n"
         "program p() { X=sum() Y=sizes[0]; }",
         "X6 Y3"},
        {"int n = 1;\nint next() { n += 1; return n; }\nprogram p() { X=next(); X=next(); }",
         "X2\nX3"},
    });
}

TEST(Functions, Imports) {
    RunOptions options;
    options.modules["a"] =
        "import b;\nlength from_a() { return from_b() + 1; }\nlength unused() { return wrong; }";
    options.modules["b"] = "import a;\nconst length base = 10;\nlength from_b() { return base; }";
    const Outcome outcome = run("import a;\nprogram p() { X=from_a(); }", options);
    EXPECT_EQ(outcome.all_messages(), "");
    EXPECT_EQ(outcome.all_blocks(), "X11");
    // Only direct imports can be seen.
    EXPECT_EQ(run("import a;\nprogram p() { X=from_b(); }", options).messages,
              std::vector<std::string>{"2:17 K2002"});
    EXPECT_EQ(run("#include \"a\"\nprogram p() { X=from_a(); }", options).all_blocks(), "X11");
    EXPECT_EQ(run("#include <a>\nprogram p() { X=from_a(); }", options).all_blocks(), "X11");
    EXPECT_EQ(run("import c;\nprogram p() { X1; }", options).messages,
              std::vector<std::string>{"1:1 K9001"});
    // The prelude is there without being asked for; what a file declares itself comes first.
    options.modules["prelude"] = "enum rotation { cw, ccw }\nlength edge() { return 3; }";
    EXPECT_EQ(
        run("program p() { rotation r = ccw; if (r == ccw) X=edge(); }", options).all_blocks(),
        "X3");
    EXPECT_EQ(
        run("length edge() { return 4; }\nprogram p() { X=edge(); int cw = 1; Y=cw; }", options)
            .all_blocks(),
        "X4\nY1");
}

TEST(Functions, Tables) {
    RunOptions options;
    options.file = KADR_ROOT "/tests/sema/tables/test.kadr";
    const char* source =
        "enum grade { rough, fine }\n"
        "struct hole { point at; length d; length? depth; string name; grade g; bool through; feed "
        "f; }\n"
        "program p(string file = \"holes.csv\") {\n"
        "    for (hole h : table<hole>(\"holes.csv\")) X=h.at.x Y=h.at.y Z=h.depth ?? 99mm;\n"
        "    auto all = table<hole>(file);\n"
        "    note \"{all.count} {all[1].name} {all[1].g} {all[1].through} {all[1].d} "
        "{all[1].f}\";\n"
        "}\n";
    const Outcome outcome = run(source, options);
    EXPECT_EQ(outcome.all_messages(), "");
    EXPECT_EQ(outcome.all_blocks(),
              "X10 Y5 Z12\nX25.4 Y-5 Z99\ncomment \"2 M8, long fine true 8.5 120\"");
}

// Texts are made in every turn; what nobody holds any more is used again.
TEST(Functions, TextsAndArraysAreReused) {
    const Outcome outcome =
        run("string[] kept;\n"
            "program p() {\n"
            "    for (int i = 0; i < 300000; i++) {\n"
            "        string s = \"a long enough text number {i}\";\n"
            "        int[] a = {i, i + 1, i + 2};\n"
            "        if (i % 100000 == 0) kept.append(s + \"{a[2]}\");\n"
            "    }\n"
            "    for (string s : kept) note s;\n"
            "}\n");
    EXPECT_EQ(outcome.all_messages(), "");
    EXPECT_EQ(outcome.all_blocks(),
              "comment \"a long enough text number 02\"\n"
              "comment \"a long enough text number 100000100002\"\n"
              "comment \"a long enough text number 200000200002\"");
}

}  // namespace
}  // namespace kadr::testing::functions_test
