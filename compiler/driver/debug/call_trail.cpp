#include "driver/debug/call_trail.h"

namespace kadr::driver {

CallTrail::Arrival CallTrail::come_to(std::span<const expand::RunningCall> calls,
                                      const SourceRange& statement, std::uint64_t line) {
    std::size_t same = 0;
    while (same < known_.size() && same < calls.size() &&
           known_[same].function == calls[same].function &&
           known_[same].return_to == calls[same].return_to)
        ++same;
    const bool is_new = same < calls.size();
    known_.resize(same);
    for (std::size_t i = same; i < calls.size(); ++i)
        known_.push_back({calls[i].function, calls[i].return_to, {}, 0});
    Activation& here = known_.back();
    const bool goes_on_in_line = !is_new && here.line == line &&
                                 here.statement.file == statement.file &&
                                 here.statement.begin < statement.begin;
    here.statement = statement;
    here.line = line;
    return {is_new, !goes_on_in_line};
}

}  // namespace kadr::driver
