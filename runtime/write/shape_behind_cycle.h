// shape_behind_cycle.h — the blocks of a shape behind the cycle that works along them.
//
// The control does not execute them where they stand: behind the last one the tool is where it was
// when the cycle was called.
#pragma once

#include <cstdint>
#include <vector>

#include "nc/dialect.h"
#include "write/modal.h"

namespace kadr::write {

class ShapeBehindCycle {
  public:
    /// Whether this is the last block of the shape.
    bool ends_with(const nc::Block& block) const { return last_ >= 0 && block.number == last_; }
    /// Where the cycle was called.
    const WrittenPosition& start() const { return start_; }
    /// A block has been written that may call such a cycle.
    void look(const nc::Block& block, const std::vector<nc::CycleInfo>& cycles,
              const WrittenPosition& position) {
        if (block.function_count == 0) return;
        const nc::Invocation* const call = block.find(nc::Function::Cycle);
        if (call == nullptr || !cycles[block.cycle].takes_shape()) return;
        const auto last = static_cast<std::size_t>(cycles[block.cycle].roles.last_block);
        last_ = static_cast<std::int32_t>(block.argument(*call, last, -1));
        start_ = position;
    }

  private:
    std::int32_t last_ = -1;  // its number; -1: no cycle works along one
    WrittenPosition start_;
};

}  // namespace kadr::write
