// owed.h — what nobody knows any more, and what the text does not have yet. For the room expand
// only.
#pragma once

#include "base/source.h"
#include "expand/known_position.h"
#include "nc/vocabulary.h"
#include "sema/code.h"

namespace kadr::expand {

/// Modal state that something has made unknown: it must be programmed again.
class LostState {
  public:
    sema::ModalMask what() const { return what_; }
    bool has(sema::ModalMask mask) const { return (what_ & mask) != 0; }
    bool has(nc::Group group) const { return has(sema::group_bit(group)); }
    /// Whether a block is to be looked at: nearly all are not.
    bool needs_care() const { return (what_ | restate_) != 0; }
    /// The statement that did so last, and how.
    SourceId by() const { return by_; }
    Loss how() const { return how_; }
    /// Set by a block that may be left out: written again.
    sema::ModalMask restate() const { return restate_; }

    void lose(sema::ModalMask mask, SourceId by, Loss how) {
        what_ |= mask;
        by_ = by;
        how_ = how;
    }
    /// … by what was noted before.
    void lose_again(sema::ModalMask mask) { what_ |= mask; }
    /// It is programmed.
    void regain(sema::ModalMask mask) { what_ &= ~mask; }
    void write_again(sema::ModalMask mask) { restate_ |= mask; }
    void settle(sema::ModalMask mask) { restate_ &= ~mask; }

  private:
    sema::ModalMask what_ = 0;
    SourceId by_;
    Loss how_ = Loss::RawText;
    sema::ModalMask restate_ = 0;
};

/// What the text gets with the next block that needs it.
class Owed {
  public:
    /// The motion that acts: another one stands in the text, or none.
    bool motion() const { return motion_; }
    void owe_motion(bool is_owed = true) { motion_ = is_owed; }
    /// What X is; None: the text has it.
    nc::Function diameter() const { return diameter_; }
    void owe_diameter(nc::Function member) { diameter_ = member; }
    /// A work offset of the control of a source, before the first move; 0: none.
    int work_offset() const { return work_offset_; }
    void owe_work_offset(int number) { work_offset_ = number; }
    /// The text is under absolute dimensions for one block.
    bool incremental() const { return incremental_; }
    void owe_incremental(bool is_owed = true) { incremental_ = is_owed; }
    /// The frame has changed since a block was made.
    bool position() const { return position_; }
    void owe_position(bool is_owed = true) { position_ = is_owed; }

  private:
    bool motion_ = false;
    bool incremental_ = false;
    bool position_ = false;
    nc::Function diameter_ = nc::Function::None;
    int work_offset_ = 0;
};

}  // namespace kadr::expand
