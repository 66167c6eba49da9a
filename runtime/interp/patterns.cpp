// patterns.cpp — places at which the control calls a cycle: a row, a circle, a grid of holes.
//
// The blocks of such a cycle are motions to places. Each is executed as if it stood in the program,
// so that the cycle which is called behind motions, or is modal, is called there.
#include "base/diagnostics/iso.h"
#include "interp/executor.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;

namespace {

constexpr std::size_t kPlaceBatch = 16;

}  // namespace

void Executor::begin_pattern(const Block& block, std::unique_ptr<Stream<Block>> places) {
    if (corners_.is_active()) settle(block);
    leave_corners(diag::CornerWithoutMotion);
    if (ended_) return;
    Stream<Block>& stream = *places;
    pattern_.emplace(PatternRun{std::move(places), BlockQueue(stream, kPlaceBatch), block, modal_});
    modal_.is_incremental = false;
    modal_.motion = Function::Rapid;
}

void Executor::go_to_next_place() {
    const Block* const place = pattern_->places.next();
    if (place == nullptr) return finish_pattern();
    place_ = in_plane_of_cycle(*place);
    place_.line = pattern_->caller.line;
    // A modal cycle is repeated by places; a motion code would end it.
    if (modal_cycle_.is_active) place_.motion = Function::None;
    execute(place_);
}

void Executor::finish_pattern() {
    const Block caller = pattern_->caller;
    modal_ = pattern_->modal_before;
    pattern_.reset();
    was_refused(caller);
}

}  // namespace kadr::interp
