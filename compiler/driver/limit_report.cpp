#include "driver/limit_report.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "base/numbers.h"
#include "base/printable.h"
#include "driver/columns.h"
#include "driver/summary.h"
#include "path/curve.h"

namespace kadr::driver {

namespace {

using motion::LossReason;

constexpr std::size_t kShownPlaces = 30;  // of a report; a table has all
constexpr double kShownLoss = 0.0005;     // s; less is not worth a line
constexpr int kDecimals = 6;
constexpr std::size_t kMostWaiting = 1 << 12;
constexpr std::size_t kMostRows = 1 << 16;

/// A cell of a table; the name of a file may hold what divides cells.
std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",;\"\r\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

LossReason reason_at(std::size_t i) { return static_cast<LossReason>(i); }

/// Indices of what was lost, the greatest first.
std::vector<std::size_t> by_cost(const LimitShare& share) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < share.lost.size(); ++i) {
        if (share.lost[i] >= kShownLoss) order.push_back(i);
    }
    std::ranges::stable_sort(order, std::ranges::greater{},
                             [&](std::size_t i) { return share.lost[i]; });
    return order;
}

/// `corner 3.10 s, stop 0.42 s`
std::string reasons(const LimitShare& share) {
    std::string text;
    for (const std::size_t i : by_cost(share)) {
        text += fmt::format("{}{} {:.3f} s", text.empty() ? "" : ", ",
                            motion::reason_name(reason_at(i)), share.lost[i]);
    }
    return text;
}

double percent(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

}  // namespace

double LimitShare::all_lost() const { return std::accumulate(lost.begin(), lost.end(), 0.0); }

void LimitReport::see(const path::Command& command) {
    if (command.op() == path::Op::Tool) calls_.push_back(command.tool().number);
}

void LimitReport::lose(const motion::SpeedLoss& loss) { waiting_.push_back(loss); }

void LimitReport::add(const motion::Segment& segment) {
    if (segment.kind == motion::SegmentKind::ToolChange && !calls_.empty()) {
        tool_times_.push_back({segment.start_time, calls_.front()});
        calls_.erase(calls_.begin());
    }
    if (waiting_.size() > kMostWaiting) settle_until(segment.start_time);
    if (rows_.size() > kMostRows) forget_least();
    if (!motion::is_motion(segment.kind)) return;
    LimitShare& here = share_at(segment.line, segment.source);
    LimitShare& tool = share_of_tool(segment.start_time);
    for (LimitShare* share : {&all_, &here, &tool}) share->time += segment.duration;
    if (!has_pulses_) return;
    const double lost = segment.duration - path::arc_length(segment.curve) / segment.feed;
    const auto i = static_cast<std::size_t>(LossReason::PulseWindow);
    for (LimitShare* share : {&all_, &here, &tool}) share->lost[i] += lost;
}

LimitShare& LimitReport::share_at(std::uint32_t line, SourceId source) {
    ProgramLocation location = locations_.find(line, source);
    std::string key = ProgramLocations::key_of(location);
    return rows_.try_emplace(std::move(key), Row{std::move(location), {}}).first->second.share;
}

LimitShare& LimitReport::share_of_tool(double time) {
    const auto behind = std::ranges::upper_bound(tool_times_, time, {}, &ToolTime::from);
    const std::int64_t number = std::prev(behind)->tool;
    const auto found =
        std::ranges::find(tools_, number, [](const auto& tool) { return tool.first; });
    if (found != tools_.end()) return found->second;
    return tools_.emplace_back(number, LimitShare{}).second;
}

/// Reported losses find their tool when the pieces have come up to their time.
void LimitReport::settle_until(double time) {
    const auto rest =
        std::stable_partition(waiting_.begin(), waiting_.end(),
                              [&](const motion::SpeedLoss& loss) { return loss.at <= time; });
    for (const motion::SpeedLoss& loss : std::span(waiting_.begin(), rest)) {
        const auto i = static_cast<std::size_t>(loss.reason);
        const auto pulse = static_cast<std::size_t>(LossReason::PulseWindow);
        for (LimitShare* share :
             {&all_, &share_at(loss.line, loss.source), &share_of_tool(loss.at)}) {
            share->lost[i] += loss.time;
            // The pulses have what is left.
            if (has_pulses_ && loss.reason != LossReason::MachineFeed)
                share->lost[pulse] -= loss.time;
        }
    }
    waiting_.erase(waiting_.begin(), rest);
}

/// Memory is bounded: of very many locations those are forgotten that have cost least so far.
void LimitReport::forget_least() {
    std::vector<double> losses;
    losses.reserve(rows_.size());
    for (const auto& [key, row] : rows_) losses.push_back(row.share.all_lost());
    const auto middle = losses.begin() + static_cast<std::ptrdiff_t>(losses.size() / 2);
    std::ranges::nth_element(losses, middle);
    const double most = *middle;
    std::erase_if(rows_, [&](const auto& entry) { return entry.second.share.all_lost() <= most; });
}

std::vector<const LimitReport::Row*> LimitReport::costly() const {
    std::vector<const Row*> rows;
    for (const auto& [key, row] : rows_) {
        if (row.share.all_lost() >= kShownLoss) rows.push_back(&row);
    }
    std::ranges::sort(rows, [](const Row* a, const Row* b) {
        const double first = a->share.all_lost();
        const double second = b->share.all_lost();
        return first != second ? first > second : a->location < b->location;
    });
    return rows;
}

void LimitReport::write(Output& out, const std::string& source, const std::string& alarm) {
    settle_until(std::numeric_limits<double>::infinity());
    out.write(printable(out.name().ends_with(".csv") ? table() : report(source)));
    if (!alarm.empty()) out.write("# not complete, ended by " + alarm + '\n');
}

std::string LimitReport::report(const std::string& source) const {
    const double lost = all_.all_lost();
    std::string text = fmt::format("{}: what keeps the motion below its feed\n\n", source);
    text += fmt::format("motion                       {:>12}\n", duration_text(all_.time));
    text += fmt::format("at the feeds that are asked  {:>12}\n", duration_text(all_.time - lost));
    text += fmt::format("lost                         {:>12}  {:3.0f} %\n\n", duration_text(lost),
                        percent(lost, all_.time));
    for (const std::size_t i : by_cost(all_)) {
        text += fmt::format("  {:<29}{:>10.3f} s  {:3.0f} %\n", motion::reason_name(reason_at(i)),
                            all_.lost[i], percent(all_.lost[i], all_.time));
    }
    if (tools_.size() > 1) {
        text += "\nby tool\n";
        for (const auto& [tool, share] : tools_) {
            text += fmt::format("  T{:<6}{:>10.3f} s of {:.3f} s: {}\n", tool, share.all_lost(),
                                share.time, reasons(share));
        }
    }
    const std::vector<const Row*> rows = costly();
    if (!rows.empty()) text += "\nby statement, the costliest first\n";
    for (std::size_t i = 0; i < std::min(rows.size(), kShownPlaces); ++i) {
        const Row& row = *rows[i];
        const std::string statement = locations_.text_of(row.location);
        text += fmt::format("  {}{}{}\n", locations_.name_of(row.location),
                            statement.empty() ? "" : "  ", statement);
        text += fmt::format("      {:.3f} s of {:.3f} s: {}\n", row.share.all_lost(),
                            row.share.time, reasons(row.share));
    }
    if (rows.size() > kShownPlaces)
        text += fmt::format("  and {} more\n", rows.size() - kShownPlaces);
    return text;
}

/// One row for a location and a reason, in the order of cost.
std::string LimitReport::table() const {
    std::string text = "place,reason,lost,time\n";
    for (const Row* row : costly()) {
        for (const std::size_t i : by_cost(row->share)) {
            text += csv_cell(locations_.name_of(row->location));
            text += ',';
            text += motion::reason_name(reason_at(i));
            append_column(text, row->share.lost[i], kDecimals);
            append_column(text, row->share.time, kDecimals);
            text += '\n';
        }
    }
    return text;
}

}  // namespace kadr::driver
