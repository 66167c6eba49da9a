#include "driver/work_times.h"

#include <algorithm>
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

void WorkTimes::see(const path::Command& command) {
    if (command.op == path::Op::Tool) calls_.push_back(command.tool);
}

void WorkTimes::add(const motion::Segment& segment) {
    if (segment.kind == motion::SegmentKind::ToolChange) take_next_tool();
    const bool moves = motion::is_motion(segment.kind) || motion::is_external(segment.kind);
    const bool has_way = moves && !segment.turns_only;
    const double length = has_way ? path::length(segment.curve) : 0;
    add_to(tools_[tool_at_].share, segment, length);
    add_to(share_of(segment), segment, length);
    if (rows_.size() > kMostRows) forget_least();
}

void WorkTimes::take_next_tool() {
    if (calls_.empty()) return;
    const std::int64_t tool = calls_.front();
    calls_.pop_front();
    const auto found = std::ranges::find(tools_, tool, &ToolShare::tool);
    tool_at_ = static_cast<std::size_t>(found - tools_.begin());
    if (found == tools_.end()) tools_.push_back({tool, {}});
}

WorkShare& WorkTimes::share_of(const motion::Segment& segment) {
    WorkPlace place = places_.find(segment.line, segment.source);
    std::string key = WorkPlaces::key_of(place);
    return rows_.try_emplace(std::move(key), Row{std::move(place), {}}).first->second.share;
}

void WorkTimes::forget_least() {
    std::vector<double> times;
    times.reserve(rows_.size());
    for (const auto& [key, row] : rows_) times.push_back(row.share.time);
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    const double most = *middle;
    std::erase_if(rows_, [&](const auto& entry) { return entry.second.share.time <= most; });
}

std::vector<ToolShare> WorkTimes::tools() const {
    if (!(execution_.machine().tool_change_time > 0)) return {};
    std::vector<ToolShare> all = tools_;
    std::erase_if(all, [](const ToolShare& tool) { return tool.share.time == 0; });
    return all;
}

std::vector<PlaceShare> WorkTimes::longest(std::size_t most) const {
    std::vector<const Row*> rows;
    for (const auto& [key, row] : rows_) {
        if (row.share.time > 0) rows.push_back(&row);
    }
    const std::size_t count = std::min(most, rows.size());
    const auto is_before = [](const Row* a, const Row* b) {
        if (a->share.time != b->share.time) return a->share.time > b->share.time;
        return a->place < b->place;
    };
    const auto end = rows.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(rows.begin(), end, rows.end(), is_before);
    std::vector<PlaceShare> all;
    for (auto row = rows.begin(); row != end; ++row) all.push_back(shown(**row));
    return all;
}

PlaceShare WorkTimes::shown(const Row& row) const {
    return {places_.name_of(row.place), places_.text_of(row.place), row.share};
}

}  // namespace kadr::driver
