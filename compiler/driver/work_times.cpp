#include "driver/work_times.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "path/curve.h"

namespace kadr::driver {

namespace {

constexpr std::size_t kMostRows = 1 << 16;
constexpr std::size_t kShownText = 48;  // characters of a statement

/// The first line of a statement, without the brace of its body, as far as it fits.
std::string first_line(std::string_view statement) {
    std::string text(statement.substr(0, statement.find('\n')));
    while (!text.empty() && (text.back() == ' ' || text.back() == '{' || text.back() == '\r'))
        text.pop_back();
    if (text.size() <= kShownText) return text;
    std::size_t cut = kShownText;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0u) == 0x80u) --cut;
    return text.substr(0, cut) + "…";
}

std::string without_folder(const std::string& name) {
    return std::filesystem::path(name).filename().string();
}

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
    Place place;
    place.statement = users_statement(segment);
    key_.clear();
    if (place.statement.file.is_valid()) {
        key_ = std::to_string(place.statement.file.index) + '@' +
               std::to_string(place.statement.begin);
    } else if (interp::Program::is_in_main_text(segment.line)) {
        place.line = segment.line;
        key_ = std::to_string(segment.line);
    } else {
        const LinePlace called = execution_.place_of(segment.line);
        place.called = called.file + ':' + std::to_string(called.line);
        key_ = place.called;
    }
    return rows_.try_emplace(key_, Row{std::move(place), {}}).first->second.share;
}

/// The statement outside of the library that led to the piece; none in ISO-7bit text.
SourceRange WorkTimes::users_statement(const motion::Segment& segment) const {
    const SourceRange statement = execution_.statement(segment.source);
    if (!statement.file.is_valid() || !is_in_library(statement)) return statement;
    const GeneratedText* generated = execution_.generated();
    const expand::Trace* calls =
        generated == nullptr ? nullptr : generated->calls_behind(segment.line);
    if (calls == nullptr) return statement;
    for (auto call = calls->calls.rbegin(); call != calls->calls.rend(); ++call) {
        if (call->range.file.is_valid() && !is_in_library(call->range)) return call->range;
    }
    return statement;
}

bool WorkTimes::is_in_library(const SourceRange& range) const {
    return session_.sources().name(range.file).starts_with(session_.share().library);
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
        if (a->place.line != b->place.line) return a->place.line < b->place.line;
        if (a->place.statement.begin != b->place.statement.begin)
            return a->place.statement.begin < b->place.statement.begin;
        return a->place.called < b->place.called;
    };
    const auto end = rows.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(rows.begin(), end, rows.end(), is_before);
    std::vector<PlaceShare> all;
    for (auto row = rows.begin(); row != end; ++row) all.push_back(shown(**row));
    return all;
}

PlaceShare WorkTimes::shown(const Row& row) const {
    const Place& place = row.place;
    if (!place.called.empty()) return {without_folder(place.called), {}, row.share};
    if (!place.statement.file.is_valid()) {
        const std::string name = execution_.text_name() + ':' + std::to_string(place.line);
        return {without_folder(name), {}, row.share};
    }
    return {without_folder(session_.source_name(place.statement)),
            first_line(session_.sources().text(place.statement)), row.share};
}

}  // namespace kadr::driver
