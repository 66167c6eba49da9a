#include "interp/reported_in_run.h"

#include <algorithm>

namespace kadr::interp {

namespace {

template <typename Value>
bool is_among(const std::vector<Value>& reported, const Value& value) {
    return std::ranges::find(reported, value) != reported.end();
}

template <typename Value>
bool is_added(std::vector<Value>& reported, const Value& value) {
    if (is_among(reported, value)) return false;
    reported.push_back(value);
    return true;
}

}  // namespace

bool ReportedInRun::has_reported(NoticeEach what, std::int64_t number) const {
    return is_among(numbers_.at(static_cast<std::size_t>(what)), number);
}

void ReportedInRun::count_as_reported(NoticeEach what, std::int64_t number) {
    numbers_.at(static_cast<std::size_t>(what)).push_back(number);
}

bool ReportedInRun::first_time(NoticeEach what, std::int64_t number) {
    return is_added(numbers_.at(static_cast<std::size_t>(what)), number);
}

bool ReportedInRun::first_time_of_name(const std::string& name) {
    return is_added(shared_names_, name);
}

bool ReportedInRun::first_time_of_feed(double feed) {
    constexpr std::size_t kMost = 100;
    return feeds_.size() < kMost && is_added(feeds_, feed);
}

}  // namespace kadr::interp
