// modal.h — what the expander knows of the control's state behind the blocks that it has made.
//
// Only what the language needs: members of the modal groups for `with` and `preserves`, F and S,
// the programmed position for `position.x`, the programmable frame. The parts of it are values with
// transitions of their own; here stands what concerns several of them.
#pragma once

#include "expand/known_drawing.h"
#include "expand/known_frame.h"
#include "expand/known_position.h"
#include "expand/known_values.h"
#include "expand/owed.h"
#include "expand/reported_in_program.h"
#include "nc/block.h"
#include "nc/effects.h"
#include "sema/code.h"

namespace kadr::expand {

struct ModalState {
    ActiveGroups groups;
    KnownFeed feed;
    KnownSpeed speed;
    KnownTool tool;
    KnownLength length;
    CompensationInUse compensation;
    KnownPosition position;
    Drifts drifts;
    KnownFrame frame;
    TiltInUse tilt;
    TcpInUse tcp;
    KnownDrawing drawing;
    LostState lost;
    Owed owed;
    double work_offset = 0;    // parameter of WorkOffset
    bool is_diameter = false;  // words of X
    bool has_ended = false;    // behind M30
    SourceId ended_by;
    ReportedInProgram reported;  // of this state; a change of it renews that

    nc::Function operator[](nc::Group group) const { return groups[group]; }
    SourceId by(nc::Group group) const { return groups.by(group); }

    /// A member that acts without a block of its own that programs it.
    void assume(nc::Group group, nc::Function member) { groups.assume(group, member); }
    /// … because of a statement, which `by` is: whatever was unknown before it.
    void assume(nc::Group group, nc::Function member, SourceId by) {
        groups.set(group, member, by);
        lost.regain(sema::group_bit(group));
    }
    /// … or which is noted, and nothing more.
    void note(nc::Group group, nc::Function member, SourceId by) { groups.set(group, member, by); }

    /// The state in which every Kadr program begins.
    ///
    /// diameter     the member of its group that the control has by itself
    static ModalState at_start(const sema::FunctionCode& entry, nc::Function diameter);
    /// Whether X is a diameter the program has set that calls; a cycle that needs diameters where
    /// it has set radii begins with that.
    void take_diameter_of_caller(bool needs_diameter);
    /// What the functions of a block do before it moves.
    ///
    /// target  the control for which the program is written: some of its customs the text has
    /// Returns whether something of it comes true behind the motion only: `take_behind` is due.
    bool take_functions(const nc::Block& block, const nc::Rules& target);
    /// … then its words …
    void take_words(const nc::Block& block);
    /// … and what is so behind its motion, by the functions that the block has then: a return to
    /// the reference point may have become another one.
    void take_behind(const nc::Block& block, const nc::Rules& target);
    /// All of that.
    void take_block(const nc::Block& block, const nc::Rules& target);

    /// Where the tools of the program are, as far as is known.
    nc::Changer changer() const;
    /// Whether the spindle turns, as far as the program is known.
    bool is_spindle_turning() const {
        const nc::Function spindle = groups[nc::Group::Spindle];
        const bool is_on = spindle == nc::Function::SpindleCw ||
                           spindle == nc::Function::SpindleCcw || spindle == nc::Function::None;
        return is_on && !speed.is_missing() && !(speed.is_known() && speed.value() == 0);
    }
    /// Whether a motion in the plane begins or ends cutter radius compensation.
    bool is_compensation_due() const {
        const nc::Function wanted = groups[nc::Group::RadiusComp];
        const nc::Function moved_under = compensation.moved_under();
        return moved_under != nc::Function::None && wanted != nc::Function::None &&
               nc::has_fact(moved_under, nc::Fact::CompSide) !=
                   nc::has_fact(wanted, nc::Fact::CompSide);
    }
    void switch_spindle(nc::Function member, SourceId source);
    /// 3, 4, 5 as in M3, M4, M5.
    void set_spindle(double code, SourceId source);
    /// The frame, as blocks have programmed it anew.
    void put_frame(const control::ProgramFrame& next, SourceId source);
    /// The motion that acts stands in the block, if the text owes it and the block has none.
    void put_motion(nc::Block& block) {
        if (!owed.motion() || block.motion != nc::Function::None) return;
        block.motion = groups[nc::Group::Motion];
        owed.owe_motion(false);
    }

    /// Text of unknown meaning: nothing is known any more.
    void forget(SourceId source);
    /// Behind a `with` that set the first F: what held before it was none.
    void forget_feed(SourceId source);
    /// Keeps what is so whether the operator lets a block run, as it did here, or leaves it out.
    ///
    /// without  the state before it. What the writer writes again by itself is as the block has it
    void join(const ModalState& without, SourceId block);
};

/// Groups of the mask whose state differs, F and S and frames included.
sema::ModalMask difference(const ModalState& a, const ModalState& b, sema::ModalMask mask);

}  // namespace kadr::expand
