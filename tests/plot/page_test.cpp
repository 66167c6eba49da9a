// The page that plays a machine, as far as C++ makes it: what is kept of a run of any length, and
// that nothing in a program can break the page. tests/page has the browser's side.
#include "plot/page.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "plot/base64.h"
#include "plot/page_trace.h"

namespace page_test {

namespace {

using namespace kadr;
using namespace kadr::plot;

constexpr double kTick = 0.001;

machine::Machine two_axes() {
    machine::Machine machine;
    machine.axes.push_back({.name = "X", .axis = Axis::X, .is_rotary = false});
    machine.axes.push_back({.name = "C", .axis = Axis::C, .is_rotary = true});
    return machine;
}

motion::Setpoint at(std::size_t tick, double x, double c = 0, double feed = 0) {
    motion::Setpoint setpoint;
    setpoint.time = static_cast<double>(tick) * kTick;
    setpoint.axis[0] = x;
    setpoint.axis[1] = c;
    setpoint.feed = feed;
    return setpoint;
}

/// Where the trace has an axis at a time.
double kept(const PageTrace& trace, std::size_t axis, double time) {
    const auto& samples = trace.samples();
    const auto next = std::ranges::lower_bound(samples, time, {}, &PageTrace::Sample::time);
    if (next == samples.begin()) return next->axis[axis];
    const auto& from = *std::prev(next);
    const double share = (time - from.time) / (next->time - from.time);
    return from.axis[axis] + share * (next->axis[axis] - from.axis[axis]);
}

TEST(Base64, IsThatOfTheStandard) {
    // RFC 4648, chapter 10.
    const std::pair<const char*, const char*> rows[] = {
        {"", ""},        {"f", "Zg=="},        {"fo", "Zm8="},
        {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"foobar", "Zm9vYmFy"}};
    for (const auto& [text, expected] : rows) {
        const std::string_view bytes = text;
        EXPECT_EQ(
            base64_of(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size())),
            expected);
    }
    const std::vector<std::int32_t> numbers = {1, -1};
    EXPECT_EQ(base64_of(std::span<const std::int32_t>(numbers)), "AQAAAP////8=");
}

TEST(PageTrace, EvenMotionIsTwoSamples) {
    const machine::Machine machine = two_axes();
    PageTrace trace(machine, 100, 100);
    for (std::size_t i = 0; i <= 5000; ++i)
        trace.add(at(i, 0.01 * double(i), 1e-4 * double(i), 10));
    trace.finish();
    ASSERT_EQ(trace.samples().size(), 2u);
    EXPECT_NEAR(trace.samples().back().axis[0], 50, 1e-12);
    EXPECT_NEAR(trace.samples().back().axis[1], 0.5 * 180 / std::numbers::pi, 1e-12) << "degrees";
    EXPECT_NEAR(trace.samples().back().feed, 600, 1e-9) << "mm/min";
}

TEST(PageTrace, EverySetpointIsMetWithinTheTolerance) {
    const machine::Machine machine = two_axes();
    for (const std::size_t most : {100'000u, 500u, 60u}) {
        PageTrace trace(machine, most, 100);
        const auto x = [](double t) { return 40 * std::sin(3 * t) + 5 * std::sin(17 * t); };
        const auto c = [](double t) { return 0.3 * t * t; };
        for (std::size_t i = 0; i <= 20'000; ++i)
            trace.add(at(i, x(kTick * double(i)), c(kTick * double(i))));
        trace.finish();
        EXPECT_LE(trace.samples().size(), most + 1);
        EXPECT_EQ(trace.samples().front().time, 0);
        EXPECT_EQ(trace.samples().back().time, 20);
        double worst = 0;
        for (std::size_t i = 0; i <= 20'000; ++i) {
            const double t = kTick * double(i);
            worst = std::max(worst, std::abs(kept(trace, 0, t) - x(t)));
            worst = std::max(worst, std::abs(kept(trace, 1, t) - c(t) * 180 / std::numbers::pi));
        }
        EXPECT_LE(worst, trace.tolerance() + 1e-9) << most;
        EXPECT_GT(worst, trace.tolerance() / 20) << most << ": thinned more than it had to be";
        if (most == 100'000u) {
            EXPECT_EQ(trace.tolerance(), 0.01);
        }
    }
}

motion::Segment piece(double time, motion::SegmentKind kind, double length = 0) {
    motion::Segment segment;
    segment.start_time = time;
    segment.kind = kind;
    segment.carrier = length * path::Vec3::UnitZ();
    return segment;
}

TEST(PageTrace, ABlockIsACommandOrAChangeOfKind) {
    const machine::Machine machine = two_axes();
    PageTrace trace(machine, 100, 100);
    PageBlock line;
    line.iso = {0, 1};
    using motion::SegmentKind;
    auto first = piece(0, SegmentKind::Feed);
    first.ends_command = false;
    trace.add(line, first);
    trace.add(line, piece(1, SegmentKind::Feed));  // the same command goes on
    trace.add(line, piece(2, SegmentKind::Feed));  // a further one of the same line: a loop
    trace.add(line, piece(3, SegmentKind::Dwell, 80));
    first.start_time = 4;
    first.kind = SegmentKind::Rapid;
    trace.add(line, first);                        // R1 turns at the pole, …
    trace.add(line, piece(5, SegmentKind::Feed));  // … and the cut begins
    ASSERT_EQ(trace.blocks().size(), 4u);
    EXPECT_EQ(trace.blocks()[3].time, 4);
    EXPECT_EQ(trace.blocks()[3].kind, SegmentKind::Feed);
    EXPECT_EQ(trace.blocks()[1].time, 2);
    EXPECT_EQ(trace.blocks()[2].kind, SegmentKind::Dwell);
    ASSERT_EQ(trace.tools().size(), 2u);
    EXPECT_EQ(trace.tools()[trace.blocks()[2].tool], path::Vec3(0, 0, 80));
}

TEST(PageTrace, BlocksWithoutTimeAndTooManyBlocksAreLeftOut) {
    const machine::Machine machine = two_axes();
    PageTrace trace(machine, 100, 64);
    for (std::uint32_t i = 0; i < 10'000; ++i) {
        PageBlock block;
        block.iso = {0, i + 1};
        trace.add(block, piece(0.01 * i, motion::SegmentKind::Feed));
        trace.add(block, piece(0.01 * i, motion::SegmentKind::Dwell));
    }
    EXPECT_LE(trace.blocks().size(), 64u);
    EXPECT_GE(trace.blocks().size(), 8u);
    EXPECT_EQ(trace.blocks().front().time, 0);
    for (std::size_t i = 1; i < trace.blocks().size(); ++i)
        EXPECT_GT(trace.blocks()[i].time, trace.blocks()[i - 1].time);
    EXPECT_GE(trace.blocks().back().iso.line, 9'000u);
}

TEST(PageTexts, KeepWholeLinesAsFarAsThereIsRoom) {
    PageTexts texts;
    const std::int32_t first = texts.index_of("a.mpf", false);
    EXPECT_EQ(texts.index_of("a.mpf", false), first);
    const std::string line(99, 'x');
    for (int i = 0; i < 40'000; ++i) texts.append(first, line + '\n');
    const std::int32_t second = texts.index_of("b.mpf", false);
    texts.append(second, "G0 X1\n");
    const PageTexts::Text& cut = texts.all()[0];
    EXPECT_TRUE(cut.is_cut);
    EXPECT_LE(cut.text.size(), 2'500'000u);
    EXPECT_EQ(cut.text.size() % 100, 0u);
    EXPECT_EQ(cut.text.back(), '\n');
    EXPECT_TRUE(texts.all()[1].is_cut) << "there is no room left";
    EXPECT_TRUE(texts.all()[1].text.empty());
}

TEST(Page, NothingInAProgramEndsItsScriptElement) {
    const machine::Machine machine = two_axes();
    PageTrace trace(machine, 100, 100);
    trace.add(at(0, 0));
    trace.finish();
    PageTexts texts;
    const std::string nasty =
        "; </script><SCRIPT>alert(1)</script> <!-- {{kadr:title}} \xff \x01\n";
    texts.append(texts.index_of("</script>.mpf", false), nasty);
    PageHead head;
    head.title = "<b>&.mpf";
    const std::string page = page_html(
        "<title>{{kadr:title}}</title><script>{{kadr:data}}</script>!", head, trace, texts);
    EXPECT_TRUE(page.starts_with("<title>&lt;b&gt;&amp;.mpf</title><script>{")) << page;
    ASSERT_TRUE(page.ends_with("}</script>!"));
    const std::size_t begin = page.find("<script>") + 8;
    const std::string json = page.substr(begin, page.size() - 10 - begin);
    EXPECT_EQ(json.find('<'), std::string::npos);
    const auto data = nlohmann::json::parse(json);
    EXPECT_EQ(data["title"], "<b>&.mpf");
    EXPECT_EQ(data["texts"][0]["text"],
              "; </script><SCRIPT>alert(1)</script> <!-- {{kadr:title}} \xEF\xBF\xBD \x01\n");
    EXPECT_EQ(data["machine"]["axes"][0]["name"], "X");
    EXPECT_TRUE(data["machine"]["chain"].is_null());
}

TEST(Page, FullOneStaysBelowTenMegabytes) {
    machine::Machine machine = two_axes();
    for (const Axis axis : {Axis::Y, Axis::Z, Axis::A})
        machine.axes.push_back({.name = "Q", .axis = axis, .is_rotary = axis == Axis::A});
    PageTrace trace(machine, most_page_samples(machine), most_page_blocks());
    // Nothing of this is even: every setpoint is one that is kept, until there are too many.
    PageBlock block;
    for (std::size_t i = 0; i < 400'000; ++i) {
        block.iso = {0, static_cast<std::uint32_t>(i + 1)};
        trace.add(at(i, i % 2 == 0 ? 1000 : -1000));
        trace.add(block, piece(kTick * double(i), motion::SegmentKind::Feed));
    }
    trace.finish();
    PageTexts texts;
    texts.append(texts.index_of("long.mpf", false), std::string(4'000'000, '<'));
    texts.append(texts.index_of("two.mpf", false), std::string(4'000'000, 'x'));
    const std::string page = page_html("{{kadr:title}}{{kadr:data}}", {}, trace, texts);
    constexpr std::size_t kTemplate = 800'000;  // of web/, about
    EXPECT_LT(page.size() + kTemplate, 10'000'000u);
}

}  // namespace

}  // namespace page_test
