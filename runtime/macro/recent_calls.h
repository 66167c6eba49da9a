// recent_calls.h — calls of programs by a number that travels with their blocks, so that a message
// about a block can tell long afterwards what had led to it.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/source.h"
#include "nc/kept_lines.h"

namespace kadr::macro {

class RecentCalls {
  public:
    /// The number of the call, by which `find` knows it until kCalls others have come.
    SourceId add(std::shared_ptr<const nc::CallSite> call) {
        const SourceId id{next_};
        next_ = next_ + 1 == SourceId::kNone ? 0 : next_ + 1;
        const std::size_t index = id.index % kCalls;
        if (index >= entries_.size()) entries_.resize(index + 1);
        entries_[index] = {id, std::move(call)};
        return id;
    }

    /// Null: it was never there, or it is forgotten.
    const nc::CallSite* find(SourceId id) const {
        const std::size_t index = id.index % kCalls;
        const bool is_there = id.is_valid() && index < entries_.size() && entries_[index].id == id;
        return is_there ? entries_[index].call.get() : nullptr;
    }

  private:
    // As many as lines are kept for messages of the motion: each may stand in a call of its own.
    static constexpr std::size_t kCalls = std::size_t{1} << 14;

    struct Entry {
        SourceId id;
        std::shared_ptr<const nc::CallSite> call;
    };
    std::vector<Entry> entries_;
    std::uint32_t next_ = 0;
};

}  // namespace kadr::macro
