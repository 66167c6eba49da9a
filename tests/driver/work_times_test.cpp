// Where the time of a run goes: what tools and statements take adds up to the whole.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/driver/scratch.h"

namespace work_times_test {

namespace {

using nlohmann::json;

class WorkTimes : public kadr::test::ScratchFolder {
  protected:
    json summary(const std::string& name, const std::string& text) const {
        save(name, text);
        const auto result = kadr({"run", file(name), "-d", "fanuc", "--summary", "json"});
        EXPECT_EQ(result.status, 0) << result.err;
        return json::parse(result.out);
    }
    static double sum(const json& rows, const char* member) {
        double all = 0;
        for (const json& row : rows) all += row[member].get<double>();
        return all;
    }
};

constexpr const char* kPart = R"(import cycles.drilling;
program part() {
    tool(1); S1000 M3; F100;
    G0 X0 Y0;
    Z10;
    for (int i = 0; i < 3; ++i) {
        G0 X=20*i;
        drill_peck(to: -30mm, peck: 5mm);
    }
    tool(2); S2000 M3; F200;
    G1 X100;
    tool(1); S1000 M3; F100;
    G0 Z100;
    M30;
}
)";

TEST_F(WorkTimes, AddUpByToolAndByStatement) {
    const json run = summary("part.kadr", kPart);
    ASSERT_EQ(run["tools"].size(), 2u) << "a tool that is called again has one row";
    EXPECT_EQ(run["tools"][0]["tool"], 1);
    EXPECT_EQ(run["tools"][1]["tool"], 2);
    for (const char* rows : {"tools", "longest"}) {
        EXPECT_NEAR(sum(run[rows], "time_s"), run["time_s"].get<double>(), 1e-6) << rows;
        EXPECT_NEAR(sum(run[rows], "cutting_s"), run["cutting_s"].get<double>(), 1e-6) << rows;
        EXPECT_NEAR(sum(run[rows], "length_mm"), run["length_mm"].get<double>(), 1e-6) << rows;
    }
    EXPECT_EQ(run["longest"][0]["at"], "part.kadr:8");
    EXPECT_EQ(run["longest"][0]["text"], "drill_peck(to: -30mm, peck: 5mm)");
}

// What a cycle of the control moves is its own, the way to its place is not.
TEST_F(WorkTimes, AddUpByCycle) {
    const json run = summary("part.nc",
                             "%\nO1\nT1M6\nS500M3\nG0X0Y0Z50.\nG83X10.Z-12.R2.Q6.F100.\nX20.\n"
                             "X30.\nG80\nG81X40.Z-5.R2.F50.\nX50.\nG80\nM30\n%\n");
    ASSERT_EQ(run["cycles"].size(), 2u);
    const json& peck = run["cycles"][0];
    const json& drill = run["cycles"][1];
    EXPECT_EQ(peck["cycle"], "drill_peck");
    EXPECT_EQ(drill["cycle"], "drill");
    // 14 mm and two begins of a peck 1 mm above its ground at F100; 7 mm at F50; ramps besides.
    EXPECT_NEAR(peck["cutting_s"].get<double>(), 3 * 16 * 0.6, 0.2);
    EXPECT_NEAR(drill["cutting_s"].get<double>(), 2 * 7 * 1.2, 0.2);
    EXPECT_NEAR(sum(run["cycles"], "cutting_s"), run["cutting_s"].get<double>(), 1e-6);
    // … up to Z50, and to five places 10 mm apart.
    EXPECT_NEAR(run["length_mm"].get<double>() - sum(run["cycles"], "length_mm"), 100, 1e-6);
}

// The library's moves, where the control has no such cycle, are those of the statement that called.
TEST_F(WorkTimes, CountTheLibraryForItsCaller) {
    save("part.kadr", kPart);
    const auto result =
        kadr({"run", file("part.kadr"), "-d", "iso", "--cycles", "moves", "--summary", "json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const json run = json::parse(result.out);
    for (const json& row : run["longest"])
        EXPECT_TRUE(row["at"].get<std::string>().starts_with("part.kadr:")) << row;
}

TEST_F(WorkTimes, NameLinesOfForeignText) {
    const json run = summary("part.nc",
                             "%\nO1\nT1M6\nS500M3\nG0X50.\nG1X0F100.\nM98P2\nM30\n"
                             "O2\nG1X10.\nM99\n%\n");
    EXPECT_EQ(run["longest"][0]["at"], "part.nc:6");
    EXPECT_NEAR(run["longest"][0]["time_s"].get<double>(), 30, 0.1);
    EXPECT_NEAR(sum(run["longest"], "time_s"), run["time_s"].get<double>(), 1e-6);
}

}  // namespace

}  // namespace work_times_test
