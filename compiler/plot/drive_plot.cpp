#include "plot/drive_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/numbers.h"
#include "base/units.h"
#include "plot/chart.h"
#include "plot/svg_text.h"

namespace kadr::plot {

namespace {

using process::DriveSample;

constexpr std::size_t kMostSamples = 1 << 16;

}  // namespace

void DriveTrace::add(const DriveSample& sample) {
    if (pending_ > 0 && pending_ < stride_) {
        ++pending_;
        if (sample.current > samples_.back().current) samples_.back() = sample;
        return;
    }
    samples_.push_back(sample);
    pending_ = 1;
    if (samples_.size() < kMostSamples) return;
    for (std::size_t i = 0; 2 * i < samples_.size(); ++i) {
        const DriveSample& first = samples_[2 * i];
        const DriveSample& second = samples_[std::min(2 * i + 1, samples_.size() - 1)];
        samples_[i] = first.current >= second.current ? first : second;
    }
    samples_.resize((samples_.size() + 1) / 2);
    stride_ *= 2;
    pending_ = stride_;
}

namespace {

constexpr double kLeft = 84;
constexpr double kTop = 110;
constexpr double kWide = 560;
constexpr double kHigh = 140;
constexpr double kGap = 34;     // between charts one below the other
constexpr double kBeside = 84;  // between charts side by side
constexpr double kBelow = 50;   // for the labels of the time
constexpr const char* kRadius = "#1f6fb4";
constexpr const char* kSpeed = "#1e7d43";
constexpr const char* kCurrent = "#b45f06";
constexpr const char* kFeed = "#6a3d9a";

/// What happens when a cut comes to the centre.
struct Facing {
    std::size_t begin = 0;               // first sample under load
    std::optional<std::size_t> limit;    // the spindle reaches its limit
    std::optional<std::size_t> peak;     // greatest current close to the centre
    std::vector<std::size_t> crossings;  // first samples behind the centre, first and second
};

/// The first cut that passes the centre; nothing if none does.
std::optional<Facing> find_facing(const std::vector<DriveSample>& samples) {
    std::optional<std::size_t> crossing;
    std::optional<std::size_t> begin;
    for (std::size_t i = 1; i < samples.size() && !crossing; ++i) {
        const bool is_cut = samples[i].load > 0;
        if (is_cut && samples[i - 1].load <= 0 && samples[i - 1].tip[0] > 0) begin = i;
        if (begin && samples[i - 1].tip[0] > 0 && samples[i].tip[0] <= 0) crossing = i;
    }
    if (!crossing) return std::nullopt;
    Facing facing;
    facing.begin = *begin;
    facing.crossings.push_back(*crossing);
    for (std::size_t i = *crossing; i < samples.size(); ++i) {
        if (samples[i].tip[0] <= 0) continue;
        facing.crossings.push_back(i);
        break;
    }
    // Where the load passes the rest to the dynamics: below 0.4 of the radius, as the paper has it.
    constexpr double kNear = 0.4;
    const double near = kNear * samples[facing.begin].tip[0];
    const double top = samples[*crossing].wanted_speed;
    for (std::size_t i = facing.begin; i < *crossing; ++i) {
        if (!facing.limit && samples[i].wanted_speed >= top * (1 - 1e-9)) facing.limit = i;
        if (samples[i].tip[0] > near || samples[i].load <= 0) continue;
        if (!facing.peak || samples[i].current > samples[*facing.peak].current) facing.peak = i;
    }
    return facing;
}

struct Window {
    double from = 0;
    double to = 1;
};

Window whole_of(const std::vector<DriveSample>& samples) {
    if (samples.size() < 2) return {};
    return {samples.front().time, samples.back().time};
}

/// From a sixth of the first radius to a little behind the second crossing.
Window window_of(const std::vector<DriveSample>& samples, const Facing& facing) {
    constexpr double kPart = 1.0 / 6;
    const double near = kPart * samples[facing.begin].tip[0];
    std::size_t from = facing.begin;
    while (samples[from].tip[0] > near) ++from;
    const double start = samples[from].time;
    const double end = samples[facing.crossings.back()].time;
    return {start, end + 0.12 * (end - start)};
}

using Value = double (*)(const DriveSample&);

ChartLine line_of(const std::vector<DriveSample>& samples, Value value, const char* color) {
    ChartLine line;
    line.color = color;
    for (const DriveSample& sample : samples) {
        line.across.push_back(sample.time);
        line.up.push_back(value(sample));
    }
    return line;
}

/// The four charts of one window, from top to bottom.
std::vector<Chart> charts_of(const std::vector<DriveSample>& samples, const Window& window,
                             double left, const std::vector<ChartMark>& marks) {
    std::vector<Chart> charts(4);
    charts[0].title = "Radius, mm";
    charts[0].lines = {line_of(
        samples, [](const DriveSample& s) { return s.tip[0]; }, kRadius)};
    charts[1].title = "Spindle speed, rpm";
    charts[1].lines = {
        line_of(
            samples, [](const DriveSample& s) { return rpm_from_angular_speed(s.wanted_speed); },
            kSoft),
        line_of(
            samples, [](const DriveSample& s) { return rpm_from_angular_speed(s.speed); }, kSpeed)};
    charts[1].lines[0].is_dashed = true;
    charts[1].lines[0].name = "commanded";
    charts[1].lines[1].name = "real";
    charts[2].title = "Current of the main drive, A";
    charts[2].lines = {line_of(
        samples, [](const DriveSample& s) { return s.current; }, kCurrent)};
    charts[3].title = "Path speed, mm/min";
    charts[3].lines = {line_of(
        samples, [](const DriveSample& s) { return mm_min_from_feed(s.feed); }, kFeed)};
    // Rapids are many times as fast as a cut: they run out of the chart.
    constexpr double kAbove = 1.3;
    double fastest = 0;
    for (const DriveSample& sample : samples) {
        if (sample.load > 0) fastest = std::max(fastest, mm_min_from_feed(sample.feed));
    }
    if (fastest > 0) charts[3].most = kAbove * fastest;
    double top = kTop;
    for (Chart& chart : charts) {
        chart.frame = {left, top, kWide, kHigh};
        chart.lower = window.from;
        chart.upper = window.to;
        chart.marks = marks;
        // The numbers stand once, above all of them.
        if (&chart != &charts.front()) {
            for (ChartMark& mark : chart.marks) mark.name.clear();
        }
        top += kHigh + kGap;
    }
    charts.back().across = "time, s";
    return charts;
}

/// Current over radius of the cut, with the line that the force alone would give.
Chart radius_chart(const std::vector<DriveSample>& samples, const Facing& facing,
                   const machine::Drives& drives, const PlotFrame& frame) {
    Chart chart;
    chart.frame = frame;
    chart.title = "Current over radius, A";
    chart.across = "radius, mm";
    chart.upper = samples[facing.begin].tip[0];
    ChartLine steady{{}, {}, kSoft, "steady: force and idle losses", true};
    ChartLine real{{}, {}, kCurrent, "real", false};
    // From the centre outwards.
    for (std::size_t i = facing.crossings[0]; i-- > facing.begin;) {
        const DriveSample& sample = samples[i];
        if (sample.load <= 0) continue;
        const double torque = drives.cutting_force * sample.tip[0] / 1000 +
                              process::idle_torque(drives.spindle, sample.speed);
        real.across.push_back(sample.tip[0]);
        real.up.push_back(sample.current);
        steady.across.push_back(sample.tip[0]);
        steady.up.push_back(torque / drives.spindle.torque_constant);
    }
    chart.lines = {std::move(steady), std::move(real)};
    return chart;
}

std::string number(double value, int decimals) {
    return format_shortest(round_to(value, decimals));
}

/// The marks of the pass, each with the sentence that explains its number.
struct PassMarks {
    std::vector<ChartMark> marks;
    std::vector<std::string> sentences;
};

PassMarks pass_marks(const std::vector<DriveSample>& samples, const Facing& facing) {
    struct Event {
        std::size_t at;
        std::string sentence;
    };
    std::vector<Event> events;
    const auto where = [&](std::size_t i) {
        return " at " + number(samples[i].time, 3) + " s, radius " + number(samples[i].tip[0], 2) +
               " mm";
    };
    if (facing.peak) {
        events.push_back({*facing.peak, "the dynamic peak, " +
                                            number(samples[*facing.peak].current, 1) + " A" +
                                            where(*facing.peak)});
    }
    if (facing.limit) {
        events.push_back(
            {*facing.limit,
             "the speed limit, " +
                 number(rpm_from_angular_speed(samples[*facing.limit].wanted_speed), 1) + " rpm" +
                 where(*facing.limit) + "; from here the current drops"});
    }
    const char* const names[] = {"the tool passes the centre: the load ends",
                                 "it passes the centre again on its way back"};
    for (std::size_t i = 0; i < facing.crossings.size(); ++i) {
        const DriveSample& sample = samples[facing.crossings[i]];
        events.push_back(
            {facing.crossings[i], std::string(names[i]) + " at " + number(sample.time, 3) + " s"});
    }
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return a.at < b.at; });
    PassMarks all;
    for (const Event& event : events) {
        all.marks.push_back({samples[event.at].time, std::to_string(all.marks.size() + 1)});
        all.sentences.push_back(event.sentence);
    }
    return all;
}

void draw_sentences(std::string& out, const std::vector<std::string>& sentences, double left,
                    double top) {
    double y = top;
    for (std::size_t i = 0; i < sentences.size(); ++i, y += 22) {
        draw_badge(out, left + 8, y - 4, std::to_string(i + 1));
        put(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12.5\" fill=\"{}\">{}</text>\n",
            left + 24, y, kInk, escaped(sentences[i]));
    }
}

}  // namespace

std::string drive_svg(const DriveTrace& trace, const machine::Drives& drives,
                      const DriveText& text) {
    const std::vector<DriveSample>& samples = trace.samples();
    const std::optional<Facing> facing = find_facing(samples);
    const double second = kLeft + kWide + kBeside;
    const double below = kTop + 4 * (kHigh + kGap) + kBelow;
    std::string out;
    put_start(out, facing ? second + kWide + 30 : kLeft + kWide + 30,
              facing ? below + kHigh + kBelow + 10 : below);
    put_paper(out, text.title);
    put_title(out, text.title, text.subtitle, text.warning);
    if (!facing) {
        for (const Chart& chart : charts_of(samples, whole_of(samples), kLeft, {}))
            draw_chart(out, chart);
        return out + "</svg>\n";
    }
    const PassMarks events = pass_marks(samples, *facing);
    for (const Chart& chart : charts_of(samples, whole_of(samples), kLeft, {}))
        draw_chart(out, chart);
    for (const Chart& chart :
         charts_of(samples, window_of(samples, *facing), second, events.marks)) {
        draw_chart(out, chart);
    }
    draw_chart(out, radius_chart(samples, *facing, drives, {kLeft, below, kWide, kHigh}));
    draw_sentences(out, events.sentences, second, below + 20);
    return out + "</svg>\n";
}

}  // namespace kadr::plot
