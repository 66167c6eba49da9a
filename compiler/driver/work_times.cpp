#include "driver/work_times.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "path/curve.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kMostRows = 1 << 16;

void add_to(WorkShare& share, const motion::Segment& segment, double length) {
    share.time += segment.duration;
    const bool cuts =
        segment.kind == motion::SegmentKind::Feed || segment.kind == motion::SegmentKind::Mark;
    if (cuts) share.cutting_time += segment.duration;
    share.length += length;
}

}  // namespace

void WorkTimes::add(const motion::Segment& segment) {
    // A module beside the axes does not know of tools.
    if (!motion::is_external(segment.kind)) take_tool(segment.tool_number);
    const bool moves = motion::is_motion(segment.kind) || motion::is_external(segment.kind);
    const bool has_distance = moves && !segment.is_rotary_only;
    const double length = has_distance ? path::arc_length(segment.curve) : 0;
    // What tools have adds up to what the axes do: marks of a module have figures of their own.
    if (motion::is_external(segment.kind)) {
        tools_[tool_at_].share.time += segment.duration;
    } else {
        add_to(tools_[tool_at_].share, segment, length);
    }
    add_to(share_of(segment), segment, length);
    if (segment.cycle != 0) {
        if (cycles_.size() <= segment.cycle) cycles_.resize(segment.cycle + 1u);
        add_to(cycles_[segment.cycle], segment, length);
    }
    if (rows_.size() > kMostRows) forget_least();
}

void WorkTimes::take_tool(std::int64_t tool) {
    if (tools_[tool_at_].tool == tool) return;
    const auto found = std::ranges::find(tools_, tool, &ToolShare::tool);
    tool_at_ = static_cast<std::size_t>(found - tools_.begin());
    if (found == tools_.end()) tools_.push_back({tool, {}});
}

WorkShare& WorkTimes::share_of(const motion::Segment& segment) {
    const bool is_same = segment.line == last_line_ && segment.source == last_source_;
    if (last_ != nullptr && is_same) return last_->share;
    ProgramLocation location = locations_.find(segment.line, segment.source);
    const std::uint64_t key = key_of(location);
    last_ = &rows_.try_emplace(key, Row{std::move(location), {}}).first->second;
    last_line_ = segment.line;
    last_source_ = segment.source;
    return last_->share;
}

/// Lines of the main text have their number; statements file and offset; others are counted.
std::uint64_t WorkTimes::key_of(const ProgramLocation& location) {
    constexpr std::uint64_t kCalled = std::uint64_t{1} << 63;
    const SourceRange& statement = location.statement;
    if (statement.file.is_valid())
        return (std::uint64_t{statement.file.index} + 1) << 32 | statement.begin;
    if (location.called.empty()) return location.line;
    return called_.try_emplace(location.called, kCalled + called_.size()).first->second;
}

void WorkTimes::forget_least() {
    std::vector<double> times;
    times.reserve(rows_.size());
    for (const auto& [key, row] : rows_) times.push_back(row.share.time);
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    const double most = *middle;
    last_ = nullptr;
    std::erase_if(rows_, [&](const auto& entry) { return entry.second.share.time <= most; });
}

std::vector<ToolShare> WorkTimes::tools() const {
    std::vector<ToolShare> all = tools_;
    std::erase_if(all, [](const ToolShare& tool) { return tool.share.time == 0; });
    return all;
}

std::vector<CycleShare> WorkTimes::cycles() const {
    std::vector<CycleShare> all;
    for (std::size_t number = 1; number < cycles_.size(); ++number) {
        if (!(cycles_[number].time > 0)) continue;
        all.push_back({execution_.dialect().cycles()[number - 1].name, cycles_[number]});
    }
    std::ranges::stable_sort(all, std::ranges::greater{},
                             [](const CycleShare& cycle) { return cycle.share.time; });
    return all;
}

std::vector<LocationShare> WorkTimes::longest(std::size_t most) const {
    std::vector<const Row*> rows;
    for (const auto& [key, row] : rows_) {
        if (row.share.time > 0) rows.push_back(&row);
    }
    const std::size_t count = std::min(most, rows.size());
    const auto is_before = [](const Row* a, const Row* b) {
        if (a->share.time != b->share.time) return a->share.time > b->share.time;
        return a->location < b->location;
    };
    const auto end = rows.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(rows.begin(), end, rows.end(), is_before);
    std::vector<LocationShare> all;
    for (auto row = rows.begin(); row != end; ++row) all.push_back(shown(**row));
    return all;
}

LocationShare WorkTimes::shown(const Row& row) const {
    return {locations_.name_of(row.location), locations_.text_of(row.location), row.share};
}

}  // namespace kadr::driver
