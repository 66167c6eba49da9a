// patterns.cpp — positions at which the control calls a cycle: a row, a circle, a grid of holes.
//
// The blocks of such a cycle are motions to positions. Each is executed as if it stood in the
// program, so that the cycle which is called behind motions, or is modal, is called there.
#include "base/diagnostics/iso.h"
#include "interp/channel.h"
#include "interp/cornering.h"
#include "interp/cycles.h"
#include "interp/executor.h"
#include "interp/stages.h"

namespace kadr::interp {

using nc::Block;
using nc::Function;

namespace {

constexpr std::size_t kPlaceBatch = 16;

}  // namespace

void Cycles::begin_pattern(const Block& block, std::unique_ptr<Stream<Block>> places) {
    if (corners_.is_active()) channel_.stages.settle(block);
    channel_.cornering.leave_corners(diag::CornerWithoutMotion);
    if (reporter_.has_ended()) return;
    callers_.call(Callers::Kind::Pattern, std::move(places), kPlaceBatch);
    patterns_.push_back({block, modal_, calls_program_at(block)});
    begin_blocks();
}

void Cycles::go_to_position(const Block* position) {
    if (position == nullptr) return finish_pattern();
    const PatternRun& pattern = patterns_.back();
    place_ = in_plane_of_cycle(*position);
    place_.line = pattern.caller.line;
    if (pattern.calls_program) callers_.hold_pattern();
    // A modal cycle is repeated by positions; a motion code would end it.
    if (modal_cycles_.modal.is_active) place_.motion = Function::None;
    channel_.executor.execute(place_);
}

/// Behind the positions the codes act that acted before them. A feed that was set there stays.
void Cycles::finish_pattern() {
    const PatternRun& pattern = patterns_.back();
    const Block caller = pattern.caller;
    Modal after = pattern.modal_before;
    after.end_block_feed();
    if (pattern.calls_program) {
        after.feed = modal_.feed;
        after.has_feed = modal_.has_feed;
    }
    take_back(after);
    patterns_.pop_back();
    callers_.leave(Callers::Kind::Pattern);
    if (const auto words = cycles_->refusal()) refuse_cycle(caller, *words);
}

/// Whether the program of the text is called at the positions of this block, and not a cycle.
bool Cycles::calls_program_at(const Block& block) const {
    return reporter_.locations() != nullptr && reporter_.locations()->calls_at_positions(block);
}

bool Cycles::is_at_pattern_position() const { return callers_.is_pattern_held(); }

void Cycles::leave_pattern_position() { callers_.release_pattern(); }

void Cycles::leave_pattern() {
    if (!patterns_.empty()) finish_pattern();
}

}  // namespace kadr::interp
