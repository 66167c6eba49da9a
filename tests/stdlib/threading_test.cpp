// Threads over many sets of parameters: every start has its cuts, each goes as deep as it should
// and none deeper, the chips are equal, no rapid touches the part, and forbidden parameters say so.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/stdlib/commands.h"

namespace threading_test {

namespace {

using nlohmann::json;
using stdlib_test::outcome_of;

constexpr double kExact = 2e-6;  // mm: what the number format of the common core rounds

struct Thread {
    double d, d_end, pitch, from, to, depth, allowance, infeed_deg, run_in, run_out, clear;
    int cuts, spring, starts;
    bool degressive, inside;

    double way() const { return to < from ? -1 : 1; }
    double lead() const { return pitch * starts; }
    double surface(double z) const { return d / 2 + (d_end - d) / 2 * (z - from) / (to - from); }
    std::string call() const {
        const auto mm = [](double v) { return json(v).dump() + "mm"; };
        return "thread_turn(d: " + mm(d) + ", d_end: " + mm(d_end) + ", pitch: " + mm(pitch) +
               ", from: " + mm(from) + ", to: " + mm(to) + ", depth: " + mm(depth) +
               ", allowance: " + mm(allowance) + ", infeed: " + json(infeed_deg).dump() +
               "deg, run_in: " + mm(run_in) + ", run_out: " + mm(run_out) +
               ", clear: " + mm(clear) + ", cuts: " + std::to_string(cuts) +
               ", spring: " + std::to_string(spring) + ", starts: " + std::to_string(starts) +
               ", degressive: " + (degressive ? "true" : "false") +
               ", inside: " + (inside ? "true" : "false") + ")";
    }
};

std::string program_of(const std::string& call, bool inside) {
    const std::string start = inside ? "G0 X6 Z60;\n" : "G0 X160 Z60;\n";
    return "import cycles.threading;\nprogram test() {\nG18 G95;\nS500 M3;\nF0.2;\n" + start +
           call + ";\nM30;\n}\n";
}

Thread any_thread(std::mt19937& random) {
    const auto real = [&](double least, double most) {
        const double value = std::uniform_real_distribution<double>(least, most)(random);
        return std::round(value * 1000) / 1000;
    };
    const auto whole = [&](int least, int most) {
        return std::uniform_int_distribution<int>(least, most)(random);
    };
    Thread t{};
    t.d = real(20, 80);
    t.pitch = real(0.5, 4);
    t.from = real(-5, 5);
    t.to = t.from - real(10, 60);
    t.d_end = whole(0, 2) == 0 ? t.d + real(-2, 2) : t.d;
    t.depth = std::round(0.6 * t.pitch * 1000) / 1000;
    t.allowance = whole(0, 1) == 0 ? 0 : 0.05;
    t.infeed_deg = whole(0, 3) == 0 ? 0 : real(-30, 30);
    t.run_out = real(0, 3);
    t.clear = real(0.5, 3);
    t.cuts = whole(1, 12);
    t.spring = whole(0, 3);
    t.starts = whole(1, 3);
    t.run_in = 2 * t.lead() + 1;
    t.degressive = whole(0, 3) != 0;
    t.inside = whole(0, 2) == 0;
    return t;
}

/// Depth of the n-th roughing cut, n from 1.
double wanted_depth(const Thread& t, int n) {
    const double rough = t.depth - t.allowance;
    if (!t.degressive) return rough * n / t.cuts;
    const double first = std::ceil(rough / std::sqrt(t.cuts) * 1000 - 0.001) / 1000;
    return std::min(first * std::sqrt(n), rough);
}

void check_cuts(const Thread& t, const std::vector<json>& commands) {
    const int finish = t.spring + (t.allowance > 0 ? 1 : 0);
    const double side = t.inside ? 1 : -1;
    std::vector<double> depths;
    std::vector<double> starts;
    double x = 0, z = 60;
    for (const json& command : commands) {
        if (!command.contains("to")) continue;
        const double to_x = command["to"]["X"], to_z = command["to"]["Z"];
        if (command["op"] == "thread") {
            // Both ends of the cut are equally deep: no more than the thread's depth.
            const double deep = side * (to_x - t.surface(to_z));
            EXPECT_NEAR(side * (x - t.surface(z)), deep, 2 * kExact);
            EXPECT_NEAR(to_z, t.to + t.way() * t.run_out, kExact);
            EXPECT_LE(deep, t.depth + 2 * kExact) << "below the core";
            depths.push_back(deep);
            starts.push_back(command.value("start", 0.0));
            const double slant = std::hypot(to_x - x, to_z - z) / std::fabs(to_z - z);
            EXPECT_NEAR(command["feed"].get<double>(), t.lead() * slant, 1e-6);
            // In front of the thread by what is left of the way in.
            EXPECT_GE((t.from - z) * t.way(), 0);
        } else if (!depths.empty() || std::fabs(to_x - x) < 60) {
            // A rapid along the part keeps clear of it.
            const bool is_along = to_z != z;
            const double gap = -side * (x - (t.inside ? std::min(t.surface(z), t.surface(to_z))
                                                      : std::max(t.surface(z), t.surface(to_z))));
            if (is_along && !depths.empty()) {
                EXPECT_GE(gap, t.clear - 0.01 * t.depth) << command;
            }
        }
        x = to_x;
        z = to_z;
    }
    ASSERT_EQ(depths.size(), static_cast<std::size_t>(t.starts * (t.cuts + finish)));
    const std::size_t each = depths.size() / static_cast<std::size_t>(t.starts);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const auto n = static_cast<int>(i % each) + 1;
        const double wanted = n > t.cuts ? t.depth : wanted_depth(t, n);
        EXPECT_NEAR(depths[i], wanted, 2 * kExact) << "cut " << n;
        const std::size_t start = i / each;
        EXPECT_NEAR(starts[i], 360.0 * static_cast<double>(start) / t.starts, 1e-5);
    }
    // Equal chips: the sections of a V are as the squares of the depths.
    for (int n = 2; t.degressive && n < t.cuts; ++n) {
        const auto i = static_cast<std::size_t>(n - 1);
        const double chip = depths[i] * depths[i] - depths[i - 1] * depths[i - 1];
        EXPECT_NEAR(chip, depths[0] * depths[0], 1e-4);
        EXPECT_GT(depths[i], depths[i - 1]);
    }
    EXPECT_NEAR(depths[each - 1], t.depth, 2 * kExact);
    EXPECT_NEAR(x, t.inside ? x : 80, kExact) << "ends where it began";
}

TEST(Threading, CutsWhatItShouldForAllParameters) {
    std::mt19937 random(20);
    for (int i = 0; i < 40; ++i) {
        const Thread t = any_thread(random);
        SCOPED_TRACE(t.call());
        const auto outcome = outcome_of(program_of(t.call(), t.inside), "iso", "lathe");
        ASSERT_EQ(outcome.status, 0) << outcome.messages;
        check_cuts(t, outcome.commands);
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(Threading, FollowsTheFlank) {
    // Along one flank the start moves by depth·tan(infeed) with the feed; along both in turn every
    // second one as far behind the last start as the first is in front of it.
    Thread t{30, 30, 2, 0, -20, 1.2, 0, 30, 6, 0, 1, 4, 0, 1, true, false};
    for (const double infeed : {30.0, -30.0}) {
        t.infeed_deg = infeed;
        const auto outcome = outcome_of(program_of(t.call(), false), "iso", "lathe");
        ASSERT_EQ(outcome.status, 0) << outcome.messages;
        double z = 0;
        int n = 0;
        const double slope = std::tan(std::fabs(infeed) * std::acos(-1) / 180);
        for (const json& command : outcome.commands) {
            if (!command.contains("to")) continue;
            if (command["op"] == "thread") {
                const double deep = wanted_depth(t, ++n);
                const bool is_other = infeed < 0 && n % 2 == 0;
                EXPECT_NEAR(z, 6 - slope * (is_other ? 2 * t.depth - deep : deep), 1e-5) << n;
            }
            z = command["to"]["Z"];
        }
        EXPECT_EQ(n, 4);
    }
}

TEST(Threading, NativeCyclesGiveTheSameMoves) {
    const std::string call =
        "thread_turn(d: 20mm, pitch: 1.5mm, from: 0mm, to: -30mm, cuts: 5, infeed: 30deg, "
        "allowance: 0.04mm)";
    const auto moves = outcome_of(program_of(call, false), "iso", "lathe").commands;
    for (const char* dialect : {"sinumerik", "fanuc-lathe", "axioma"}) {
        SCOPED_TRACE(dialect);
        std::vector<json> native;
        for (const json& command :
             outcome_of(program_of(call, false), dialect, "lathe", "native").commands) {
            native.push_back(command);
        }
        const auto threads = [](const std::vector<json>& all) {
            std::vector<std::string> lines;
            for (const json& command : all) {
                if (command["op"] != "thread") continue;
                lines.push_back(json(std::round(command["to"]["X"].get<double>() * 1000)).dump() +
                                command["feed"].dump());
            }
            return lines;
        };
        EXPECT_EQ(threads(native).size(), 7u);
        EXPECT_EQ(threads(native), threads(moves));
    }
}

TEST(Threading, ForbiddenParametersSaySo) {
    struct Row {
        const char* call;
        const char* message;
    };
    const std::string good = "d: 20mm, from: 0mm, to: -30mm";
    for (const Row& row : {
             Row{"pitch: 0mm", "finer than any thread"},
             {"pitch: 1mm, starts: 0", "the number of starts must be 1 to 12, not 0"},
             {"pitch: 1mm, depth: 0mm", "a thread of depth 0"},
             {"pitch: 1mm, depth: 11mm", "leaves no core"},
             {"pitch: 1mm, allowance: 1mm", "an allowance of 1"},
             {"pitch: 1mm, infeed: 50deg", "is not within 45 degrees"},
             {"pitch: 1mm, cuts: 0", "the number of cuts must be 1 to 100, not 0"},
             {"pitch: 1mm, spring: -1", "the number of cuts without infeed"},
             {"pitch: 1mm, run_in: -1mm", "are no ways in and out"},
             {"pitch: 1mm, run_in: 0mm", "must start in front of the thread"},
             {"pitch: 3mm, run_in: 1mm, infeed: 30deg", "cuts begin up to 1.062 farther along"},
             {"pitch: 3mm, run_in: 1.1mm, infeed: -30deg", "cuts begin up to 2.125 farther along"},
             {"pitch: 2mm, inside: true, clear: 10.1mm, initial: 18mm", "beyond the axis"},
             {"pitch: 1mm, clear: 0mm", "must keep clear of the part"},
             {"pitch: 1mm, d_end: 90mm", "steeper than 45 degrees"},
             {"pitch: 1mm, start_at: 360deg", "is not in one turn"},
             {"pitch: 1mm, initial: 20mm", "outside the thread is 22"},
         }) {
        SCOPED_TRACE(row.call);
        const std::string call = "thread_turn(" + good + ", " + row.call + ")";
        const auto outcome = outcome_of(program_of(call, false), "iso", "lathe");
        EXPECT_EQ(outcome.status, 1);
        EXPECT_NE(outcome.messages.find(row.message), std::string::npos) << outcome.messages;
    }
    // Under constant cutting speed, and in another plane, it is refused before anything is written.
    const auto outcome = outcome_of(
        "import cycles.threading;\nprogram test() {\nG18 G95 G96 S100 M3;\nG0 X60 Z20;\n"
        "thread_turn(d: 20mm, pitch: 1mm, from: 0mm, to: -30mm);\nM30;\n}\n",
        "iso", "lathe");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.messages.find("needs G97"), std::string::npos) << outcome.messages;
}

}  // namespace

}  // namespace threading_test
