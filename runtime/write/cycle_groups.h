// cycle_groups.h — equal calls of a cycle at several positions become one modal call.
//
// Between the expander and the writer. A move at rapid beside the tool axis and the call behind it
// are a position; positions whose calls are equal in everything become what a programmer writes:
// the cycle once, the positions, the end (`G83 X… / X… / G80`, `MCALL CYCLE83(…) / X… / MCALL`).
// Each position is reached by the same move, and the same cycle runs there.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "write/names.h"

namespace kadr::write {

class Writer;

/// Whether the block begins a cycle that is called at the positions which follow.
bool is_modal_call(const Block& block);

class CycleGroups {
  public:
    /// Gets the blocks as they are to be written; number: of the block that was taken for it.
    using Put = std::function<void(const Block&, std::uint64_t number)>;

    /// writer  that has written all blocks which were put; dialect and writer outlive the groups
    CycleGroups(const Dialect& dialect, const Writer& writer, Put put);

    /// Whether a block goes through as it is, at once: most do.
    bool lets_pass(const Block& block) const {
        return !move_ && !call_ && block.function_count == 0 && block.motion != Function::Rapid;
    }
    void take(const Block& block, std::uint64_t number);
    /// What was held back is put: no block follows.
    void finish();
    /// Whether the block with this number is still held back, or something will be put for it.
    bool holds(std::uint64_t number) const;

  private:
    /// How the control spells the positions of a modal call.
    enum class Style : std::uint8_t {
        None,    // it has no modal calls
        Inside,  // the first one stands in the block of the cycle: G83
        Behind,  // all stand in blocks behind it: MCALL
    };
    struct Held {
        Block block;
        std::uint64_t number = 0;
    };

    Style style_of(const Dialect& dialect) const;
    bool is_move(const Block& block, SlotMask also = 0) const;
    bool is_call(const Block& block) const;
    bool take_in_group(const Block& block, std::uint64_t number);
    bool take_behind_call(const Block& block, std::uint64_t number);
    void open();
    void close();
    void put_position(const Block& move, SourceId call, std::uint64_t number);
    void release();

    const DialectTables& tables_;
    const Writer& writer_;
    Put put_;
    Style style_;
    std::vector<bool> can_open_;  // by cycle
    bool is_open_ = false;        // the modal call has been put, its end has not
    std::optional<Held> move_;    // in front of the call
    std::optional<Held> call_;    // the first of the group
    std::optional<Held> next_;    // the move behind it, or behind the latest position
    struct LatestCall {
        SourceId source;
        std::uint64_t number = 0;
    } last_;  // of the open group
};

}  // namespace kadr::write
