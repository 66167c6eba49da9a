// The page that plays a machine: what a run puts into it.
#include <string>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "tests/driver/scratch.h"

namespace page_test {

namespace {

using namespace kadr;

class PageOfARun : public kadr::test::ScratchFolder {};

TEST_F(PageOfARun, IsWholeOrNotThere) {
    save("part.mpf", "T1 D1 M6\nS500 M3\nG1 X10 F500\nM30\n");
    const auto result =
        kadr({"run", file("part.mpf"), "-d", "sinumerik", "--page", file("p.html")});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const std::string page = read_file(file("p.html")).value();
    EXPECT_TRUE(page.starts_with("<!doctype html>"));
    EXPECT_NE(page.find("<title>part.mpf</title>"), std::string::npos);
    EXPECT_NE(page.find("Three.js Authors"), std::string::npos) << "the licence";
    EXPECT_EQ(page.find("{{"), std::string::npos);
    save("bad.mpf", "T1 D1\nG1 X10 F500 G99999\n");
    EXPECT_NE(kadr({"run", file("bad.mpf"), "-d", "sinumerik", "--page", file("q.html")}).status,
              0);
    EXPECT_FALSE(read_file(file("q.html")).has_value() &&
                 read_file(file("q.html"))->find("not complete") == std::string::npos);
    const auto refused =
        kadr({"run", file("part.mpf"), "-d", "sinumerik", "--page", file("part.mpf")});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("K9004"), std::string::npos) << refused.err;
}

TEST_F(PageOfARun, TextsFromStandardInputAndOfSubprogramsAreInIt) {
    const auto piped =
        run_process({KADR_BINARY, "run", "-", "-d", "sinumerik", "--page", file("p.html")},
                    "T1 D1\nG0 X10 ; from a pipe\nM30\n");
    ASSERT_EQ(piped.status, 0) << piped.err;
    EXPECT_NE(read_file(file("p.html")).value().find("from a pipe"), std::string::npos);
    save("SUB.SPF", "G0 X20 ; below\nM17\n");
    save("part.mpf", "T1 D1\nSUB\nM30\n");
    const auto result =
        kadr({"run", file("part.mpf"), "-d", "sinumerik", "--page", file("p.html")});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(read_file(file("p.html")).value().find("X20 ; below"), std::string::npos);
}

TEST_F(PageOfARun, IsTheSameWithAndWithoutThreads) {
    save("part.mpf", "T1 D1\nS500 M3\nG0 X1 Y2\nG1 X10 F500\nG2 X30 Y2 CR=20\nM30\n");
    std::string first;
    for (const char* threads : {"on", "off"}) {
        const auto result = kadr({"run", file("part.mpf"), "-d", "sinumerik", "--threads", threads,
                                  "--page", file("p.html")});
        ASSERT_EQ(result.status, 0) << result.err;
        const std::string page = read_file(file("p.html")).value();
        if (first.empty()) first = page;
        EXPECT_EQ(page, first);
    }
}

TEST_F(PageOfARun, NeedsATemplate) {
    save("part.mpf", "M30\n");
    const auto page_with = [&](const std::string& page) {
        return run_process({"/usr/bin/env", "KADR_PAGE=" + page, KADR_BINARY, "run",
                            file("part.mpf"), "-d", "sinumerik", "--page", file("p.html")});
    };
    const auto missing = page_with(file("none.html"));
    EXPECT_EQ(missing.status, 2);
    EXPECT_NE(missing.err.find("error[K6310]: there is no template for pages"), std::string::npos)
        << missing.err;
    const auto broken = page_with(file("part.mpf"));
    EXPECT_EQ(broken.status, 2);
    EXPECT_NE(broken.err.find("error[K6311]"), std::string::npos) << broken.err;
    EXPECT_NE(broken.err.find("`{{kadr:title}}` does not stand in it"), std::string::npos);
    EXPECT_FALSE(read_file(file("p.html")).has_value());
}

}  // namespace

}  // namespace page_test
