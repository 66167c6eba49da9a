// Places in the source are bytes, whatever the characters before them.
#include "parsing.h"

namespace kadr::syntax::locations_test {
namespace {

TEST(Places, AreBytes) {
    const Parsed result("// Ünïcödé – Отверстия\ncycle größe(length ø) { G1 X=ø*2 Y10; }");
    ASSERT_EQ(result.messages(), "");
    const Decl& cycle = result.ast[result.ast.top[0]];
    EXPECT_EQ(result.sources.text(cycle.name_range), "größe");
    const Stmt& body = result.ast[cycle.body];
    EXPECT_EQ(result.sources.text(body.range), "{ G1 X=ø*2 Y10; }");
    const Stmt& words = result.ast[result.ast.stmts(body.statements)[0]];
    EXPECT_EQ(result.sources.text(words.range), "G1 X=ø*2 Y10;");
    const auto run = result.ast.word_run(words.words);
    EXPECT_EQ(result.sources.text(run[1].range), "X=ø*2");
    EXPECT_EQ(result.sources.text(run[2].range), "Y10");
    EXPECT_EQ(result.sources.text(result.ast[run[1].value].range), "ø*2");
}

TEST(Places, ValuesInStrings) {
    const Parsed result("string s = \"Ø{größe:.2} мм {n}\";");
    ASSERT_EQ(result.messages(), "");
    const Expr& text = result.ast[result.ast[result.ast.top[0]].value];
    const auto pieces = result.ast.exprs(text.list);
    ASSERT_EQ(pieces.size(), 4u);
    EXPECT_EQ(result.sources.text(result.ast[result.ast[pieces[1]].child[0]].range), "größe");
    EXPECT_EQ(result.sources.text(result.ast[result.ast[pieces[3]].child[0]].range), "n");
}

TEST(Places, BehindRawTextAndUnclosedStrings) {
    const Parsed raw("cycle a() { raw { ß } größe = 1; }");
    const Ast& ast = raw.ast;
    const Stmt& last = ast[ast.stmts(ast[ast[ast.top[0]].body].statements)[1]];
    EXPECT_EQ(raw.sources.text(last.range), "größe = 1;");

    const Parsed open("cycle a() { note(\"ßß); }\ncycle b() { größe = 1; }");
    EXPECT_EQ(open.messages(), "1:18 K1008 the string is not closed");
    const Decl& second = open.ast[open.ast.top[1]];
    EXPECT_EQ(open.sources.text(second.range), "cycle b() { größe = 1; }");
}

}  // namespace
}  // namespace kadr::syntax::locations_test
