#include "write/block_writer.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/diagnostics/dialect.h"
#include "base/text.h"
#include "write/arc_blocks.h"
#include "write/arc_targets.h"
#include "write/cycle_groups.h"
#include "write/frame_turns.h"

namespace kadr::write {

BlockWriter::BlockWriter(const Dialect& dialect, const WriteOptions& options, DiagnosticSink& sink)
    : dialect_(dialect),
      tables_(dialect.tables()),
      options_(options),
      state_(dialect),
      messages_(tables_, modal_.units, sink),
      lines_(tables_, options.number_blocks, messages_),
      words_(state_, messages_),
      chooser_(state_, messages_, options_),
      fast_(state_, lines_, words_, options.verbose_modal),
      idle_(dialect, text_, messages_) {
    begin({});
}

void BlockWriter::begin(const ProgramInfo& program) {
    state_.begin(program.is_inch);
    lines_.begin(program.greatest_number);
}

std::uint32_t BlockWriter::write(const Block& block, std::string& out) {
    const std::uint32_t before = lines_.count();
    switch (block.kind) {
        case Block::Kind::Nc:
            if (!fast_.write(block, out)) write_long(block, out);
            if (shape_.ends_with(block)) state_.come_back(shape_.start());
            else shape_.look(block, tables_.cycles, modal_.position);
            if (idle_.counts()) idle_.count(block, lines_.count() - before);
            break;
        case Block::Kind::Comment: lines_.write_comment(block.comment, out); break;
        case Block::Kind::Raw:
            write_raw(block, out);
            idle_.forget();
            break;
        case Block::Kind::Label:
            messages_.cannot_express(block, "the label " + quoted(block.text));
            break;
        case Block::Kind::Modal: state_.forget(); break;
        case Block::Kind::Position: state_.take_position(block); break;
    }
    return lines_.count() == before ? lines_.count() : before + 1;
}

// ---------------------------------------------------------------- blocks

void BlockWriter::write_long(const Block& block, std::string& out) {
    if (block.length_waits && rules_.length_moves_alone && holds_length(block))
        return write_without_length(block, out);
    lines_.bring_number(block.number);
    check_front(block);
    check_arc_words(block);
    if (block.skip_level < 0) {
        write_block(block, out);
    } else {
        // The operator may leave it out: behind it, only what is the same with and without it is
        // known, so that everything else is written again.
        const std::size_t waiting = state_.pending().size();
        const WriterModal before = modal_;
        write_block(block, out);
        if (state_.pending().size() < waiting || before.edge.is_end_due != modal_.edge.is_end_due) {
            messages_.cannot_express(
                block, "a block that may be left out where the tool length begins to act");
        }
        state_.join(before);
    }
    if (lines_.brings_number()) {  // all that the block programs holds already
        lines_.open(block.skip_level, true, out);
        lines_.end_block(out);
        lines_.close(out);
    }
}

/// Block number and skip level that the control takes.
void BlockWriter::check_front(const Block& block) {
    if (block.number > tables_.block_numbers.most) {
        messages_.number_fault(block, NumberFault::TooLarge, block.number, Dimension::Count, "N");
    }
    const bool is_level = block.skip_level >= tables_.notation.default_skip &&
                          block.skip_level < tables_.notation.skip_levels;
    if (block.further_skip_levels != 0)
        messages_.cannot_express(block, "several skip levels of one block");
    if (block.skip_level >= 0 && !is_level) {
        messages_.cannot_express(block, "the skip level " + std::to_string(block.skip_level));
    }
}

/// Centre, radius and full turns are for arcs, and an arc that moves has a centre or a radius.
void BlockWriter::check_arc_words(const Block& block) {
    constexpr SlotMask kArcMoves = kArcSlots | kTargetSlots;
    if ((block.given & kArcMoves) == 0) return;
    const Function motion =
        block.find(Function::Cycle) != nullptr ? Function::Cycle : text_.effective_motion(block);
    const bool has_centre = (block.given & kCenterSlots) != 0;
    if (motion == Function::None || has_fact(motion, Fact::Pitch)) {
        // After raw text the author knows; beside a motion of threads the centre word is the pitch.
    } else if (!is_arc(motion)) {
        for (std::size_t i = 0; i < kSlots; ++i) {
            const auto slot = static_cast<Slot>(i);
            if ((block.given & kArcSlots & bit(slot)) == 0) continue;
            if (!messages_.fails_first_time(block, slot_name(slot))) continue;
            messages_.report(diag::ArcWordWithoutArc, block)
                .arg(slot_name(slot))
                .arg(info(motion).name);
        }
        return;
    } else if (!has_centre && !block.has(Slot::Radius)) {
        if (messages_.fails_first_time(block, "no centre")) {
            messages_.report(diag::ArcSaidNowhere, block)
                .fix(
                    "say its centre by `I`, `J`, `K` or its radius by `CR=`, in a FANUC's source "
                    "`R`; a straight line begins with `G1`");
        }
        return;
    }
    if (has_centre && block.has(Slot::Radius) &&
        messages_.fails_first_time(block, "centre and radius"))
        messages_.report(diag::ArcSaidTwice, block);
    if (!block.has(Slot::Turns)) return;
    const double turns = block.at(Slot::Turns);
    if (!(turns >= 0 && turns == std::nearbyint(turns))) {
        messages_.number_fault(block, NumberFault::NotReadBack, turns, Dimension::Count,
                               slot_name(Slot::Turns));
    } else if (turns > kMostTurns) {
        messages_.number_fault(block, NumberFault::TooLarge, turns, Dimension::Count,
                               slot_name(Slot::Turns));
    }
}

/// A control that counts knots needs one beside every control point.
void BlockWriter::check_knot(const Block& block, Function motion) {
    if (motion != Function::Spline || (block.given & kTargetSlots) == 0) return;
    const bool has_intervals = dialect_.can_write(Function::SplineInterval);
    if (has_intervals || !dialect_.can_write(Function::SplineKnot)) return;
    if (block.find(Function::SplineKnot) == nullptr)
        messages_.cannot_express(block, "a control point without its knot");
}

/// Arcs that need other blocks; the plane and the dimensions that the block programs hold for them.
BlockWriter::Written BlockWriter::write_other_arc(const Block& block, Whole whole,
                                                  std::string& out) {
    if (!is_arc(text_.effective_motion(block))) return write_turns(block, whole, out);
    const ModalFunctions meant = modal_.meant;
    state_.mean(block);
    if (write_turns(block, whole, out) == Written::Already ||
        straighten(block, out) == Written::Already ||
        (whole == Whole::Yes && write_parts(block, out) == Written::Already))
        return Written::Already;
    state_.mean(meant);
    return Written::NotYet;
}

/// A helix of several turns on a control without a word for them: one block a turn. On one without
/// helices it is lines.
BlockWriter::Written BlockWriter::write_turns(const Block& block, Whole whole, std::string& out) {
    const std::optional<HelixTurns> helix = turns_of(text_, messages_, block);
    if (!helix) return Written::NotYet;
    for (int chord = 1; chord <= helix->chords; ++chord)
        write_block(chord_of(*helix, chord, text_), out, whole);
    if (helix->chords > 0) {
        state_.mean(Group::Motion, helix->motion);
        return Written::Already;
    }
    for (int turn = 1; turn <= helix->turns; ++turn)
        write_block(circle_of(*helix, turn, text_), out, whole);
    write_block(rest_of(*helix, text_), out, whole);
    return Written::Already;
}

BlockWriter::Written BlockWriter::write_parts(const Block& block, std::string& out) {
    const std::optional<ArcParts> parts = parts_of_arc(text_, messages_, block);
    if (!parts) return Written::NotYet;
    for (std::size_t part = 0; part < parts->count; ++part)
        write_block(block_of(*parts, part, text_), out, Whole::No);
    if (parts->shares_time) state_.mean_shared_feed(parts->feed);
    return Written::Already;
}

/// An arc that the control cannot tell from its chord is written as that.
BlockWriter::Written BlockWriter::straighten(const Block& block, std::string& out) {
    if (!vanishes(text_, block)) return Written::NotYet;
    messages_.report(diag::ArcVanishes, block).arg(dialect_.title());
    const Function motion = text_.effective_motion(block);
    Block line = block;
    line.motion = Function::Line;
    line.given &= ~(kCenterSlots | bit(Slot::Radius) | bit(Slot::Turns));
    write_block(line, out);
    state_.mean(Group::Motion, motion);
    return Written::Already;
}

void BlockWriter::write_block(const Block& block, std::string& out, Whole whole) {
    if (rules_.modal_cycles && ends_cycle(block)) return close_cycle(out);
    if (write_other_arc(block, whole, out) == Written::Already ||
        write_thread(block, out) == Written::Already)
        return;
    if (modal_.edge.waiting != 0) write_waiting_edge(block, out);
    if (modal_.edge.is_length_due) check_length_due(block);
    if (block.function_count != 0) say_doubtful(block, out);
    const Function diameter = modal_.text_of(Group::Diameter);
    Choice choice = chooser_.choose(block);
    if (text_.needs_incremental(block)) choice.drop(block, Function::Absolute);
    write_functions_alone(block, choice, out);
    state_.mean_all(block);
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (choice.is_open(i)) state_.say(tables_.forms[choice.forms[i]]);
    }

    Items items;
    if (!open_cycle_) restore_modal(block, choice, items);
    collect_functions(block, choice, items);
    if (modal_.text_of(Group::Diameter) != diameter) state_.change_diameter(diameter);
    const Function motion = text_.effective_motion(block);
    if (block.motion != Function::None && block.motion != motion)
        messages_.cannot_express(block, "a probing move that is no line at feed");
    const Targets targets = place_words(block, motion);
    // An incremental word that the control can only write under incremental dimensions.
    if (targets.written != 0 && targets.needs_incremental &&
        modal_.text_of(Group::Distance) != Function::Incremental) {
        add_code(block, Function::Incremental, items);
    }
    const bool probes = block.function_count != 0 && block.find(Function::Probe) != nullptr;
    const bool has_motion = block.motion != Function::None ||
                            (!probes && (block.given & (kTargetSlots | kCenterSlots)) != 0);
    if (has_motion) {
        const bool is_new = modal_.text_of(Group::Motion) != motion;
        // Where a cycle is modal, a code of the motion would end it.
        const bool is_of_cycle = rules_.modal_cycles && (open_cycle_ || is_modal_call(block));
        if (motion != Function::None && !is_of_cycle &&
            (is_new || (options_.verbose_modal && block.motion != Function::None))) {
            add_code(block, motion, items);
        }
    }
    add_deferred(block, choice, items);
    add_edge(block, items);
    collect_slots(block, choice, targets, items);
    if (items.count == 0 && !lines_.brings_number()) {
        if (!block.comment.empty()) lines_.write_comment(block.comment, out);
    } else if (items.count != 0 || !block.comment.empty()) {
        write_items(block, items, targets, out);
    }
    for (std::size_t i = 0; i < state_.pending().size(); ++i)
        state_.set_offset(i, own_offset(choice, state_.pending()[i], block));
    if (block.function_count == 0) return;
    follow_cycle(block, choice, out);
    state_.follow(block);
    if (block.find(Function::Message) != nullptr) check_message(block);
}

/// The words of axes, centre, radius and feed. The text's position goes to the end of the block.
Targets BlockWriter::place_words(const Block& block, Function motion) {
    Targets targets;
    const WrittenPosition start = modal_.position;
    place_targets(state_, messages_, block, targets);
    if (modal_.frame.turn.miss > 0 || modal_.frame.tilt.miss > 0)
        check_turn(text_, messages_, block);
    check_knot(block, motion);
    if (is_arc(motion)) {
        place_arc(text_, messages_, block, start, targets);
        place_arc_feed(text_, messages_, block, start, targets);
        place_helix_feed(text_, messages_, block, start, targets);
    } else if (motion == Function::None) {
        place_arc_as_given(text_, messages_, block, start, targets);
    } else if (has_fact(motion, Fact::Pitch)) {
        for (const Slot slot : {Slot::CenterX, Slot::CenterY, Slot::CenterZ}) {
            if (!block.has(slot)) continue;
            targets.written |= bit(slot);
            targets.number[static_cast<std::size_t>(slot)] = text_.to_text(slot, block.at(slot));
        }
    } else if (block.function_count == 0 && !options_.verbose_modal) {
        drop_unchanged(text_, block, start, targets);
    }
    if (motion == Function::Line) place_axes_feed(text_, messages_, block, start, targets);
    return targets;
}

/// A message that the control's line on the screen does not show to its end.
void BlockWriter::check_message(const Block& block) {
    const std::size_t length = count_code_points(block.text);
    const auto most = static_cast<std::size_t>(std::max(0, rules_.most_message));  // 0: no limit
    if (most == 0 || length <= most) return;
    if (!messages_.first_time(block, "a long message")) return;
    messages_.report(diag::MessageTooLong, block)
        .arg(length)
        .arg(tables_.name)
        .arg(most)
        .fix("make it shorter, or put the rest into a `note`");
}

// ---------------------------------------------------------------- threads

/// The axis of the longer travel of a straight move; nothing if the block does not tell.
std::optional<std::size_t> BlockWriter::longer_travel(const Block& block) const {
    std::optional<std::size_t> longest;
    double most = -1;
    bool is_certain = true;
    std::size_t count = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        if (!block.has(slot)) continue;
        ++count;
        const bool is_distance = text_.is_distance(block, axis);
        is_certain &= is_distance || text_.is_known(axis);
        const double distance =
            std::fabs(is_distance ? block.at(slot) : block.at(slot) - modal_.position.meant[axis]);
        if (distance > most) longest = axis, most = distance;
    }
    return count == 1 || is_certain ? longest : std::nullopt;
}

/// The pitch of a thread stands where the control takes it: in F, or in the word of the axis of the
/// longer travel.
BlockWriter::Written BlockWriter::write_thread(const Block& block, std::string& out) {
    if (text_.effective_motion(block) != Function::Thread || (block.given & kTargetSlots) == 0 ||
        block.find(Function::Cycle) != nullptr)
        return Written::NotYet;
    const auto& forms = tables_.forms_of[static_cast<std::size_t>(Function::Thread)];
    if (forms.empty()) return Written::NotYet;
    const bool is_feed = tables_.forms[forms[0]].feed_is_pitch;
    const SlotMask words = block.given & kCenterSlots;
    if (words == 0 && !block.has(Slot::Feed)) {
        if (messages_.fails_first_time(block, "no pitch"))
            messages_.report(diag::ThreadSaidNowhere, block);
        return Written::Already;
    }
    if (is_feed ? words == 0 : words != 0) return Written::NotYet;
    Block said = block;
    if (is_feed) {
        const auto word = static_cast<Slot>(std::countr_zero(words));
        said.given &= ~kCenterSlots;
        said.set(Slot::Feed, block.at(word));
    } else {
        const std::optional<std::size_t> axis = longer_travel(block);
        if (!axis) {
            messages_.position_unknown(block, "F", text_.unknown_ends(block, modal_.position));
            return Written::Already;
        }
        said.given &= ~bit(Slot::Feed);
        said.set(static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + *axis),
                 block.at(Slot::Feed));
    }
    // The feed of the program, which the pitch is not, acts again behind the thread.
    const double feed = block.has(Slot::Feed) ? block.at(Slot::Feed) : modal_.meant_feed;
    const bool has_feed = block.has(Slot::Feed) || modal_.has_meant_feed;
    state_.begin_lead(is_feed);
    write_block(said, out);
    state_.end_lead({has_feed, feed}, is_feed);
    return Written::Already;
}

// ---------------------------------------------------------------- comments, raw text

void BlockWriter::write_raw(const Block& block, std::string& out) {
    // The author's text stands under the dimensions that he has programmed, not under those that a
    // block before it needed.
    if (modal_.feed_is_other && modal_.has_meant_feed) {
        Block feed;
        feed.source = block.source;
        feed.set(Slot::Feed, modal_.meant_feed);
        write_block(feed, out);
    }
    if (modal_.edge.waiting != 0) put_waiting_edge(block, out);
    if (modal_.edge.is_end_due)
        messages_.cannot_express(block,
                                 "raw text between the end of the tool length and the next move "
                                 "along the tool");
    Items items;
    const Function dimensions = modal_.meant_of(Group::Distance);
    if (dimensions != Function::None && modal_.text_of(Group::Distance) != dimensions &&
        !tables_.has_incremental_letters)
        add_code(block, dimensions, items);
    if (items.count != 0) {
        Block alone;
        alone.source = block.source;
        write_items(alone, items, {}, out);
    }
    const auto foreign = std::ranges::find_if(block.text, [](char c) { return (c & 0x80) != 0; });
    if (tables_.comment.is_ascii && foreign != block.text.end() &&
        messages_.first_time(block, "raw")) {
        const auto at = static_cast<std::size_t>(foreign - block.text.begin());
        messages_.report(diag::RawCharacter, block)
            .arg(code_points(std::string_view(block.text).substr(at), 0, 1))
            .arg(tables_.name);
    }
    std::string_view rest = block.text;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        lines_.open(-1, false, out);
        out += rest.substr(0, end);
        lines_.close(out);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    state_.forget();
}

// ---------------------------------------------------------------- functions

/// The line that a form wants before its own: `M29 S800` before the tapping cycle.
void BlockWriter::write_pitch(const Form& form, const Block& block, const Invocation& invocation,
                              std::string& out) {
    lines_.open(block.skip_level, true, out);
    words_.append_words(block, form.lead, &invocation, false, out);
    lines_.end_block(out);
    lines_.close(out);
    note_line(form.lead);
}

/// What a line of the control's own language needs stands before it: it is a line letter by letter.
void BlockWriter::write_needs(const Form& form, const Block& block, std::string& out) {
    Items items;
    for (const Function needed : form.needs) {
        if (!chooser_.is_suppressed(needed)) add_code(block, needed, items);
    }
    if (items.count == 0) return;
    Block alone;
    alone.source = block.source;
    alone.skip_level = block.skip_level;
    write_items(alone, items, {}, out);
}

/// Functions that cannot share a line with others, and what has to be written before them.
void BlockWriter::write_functions_alone(const Block& block, Choice& choice, std::string& out) {
    const bool is_only =
        block.function_count == 1 && block.given == 0 && block.motion == Function::None;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (!choice.is_open(i)) continue;
        const Form& form = tables_.forms[choice.forms[i]];
        const Invocation& invocation = block.functions[i];
        const bool moves =
            block.motion != Function::None || (block.given & (kTargetSlots | kCenterSlots)) != 0;
        if (form.owns_axes && moves)
            messages_.cannot_express(block, quoted(info(form.function).name) + " beside a move");
        write_before(form, block, out);
        if (is_shift_standing(form, block, invocation)) {
            choice.finish(i);
            continue;
        }
        if (!form.implied.empty()) write_initial_level(form, block, invocation, out);
        const bool needs_feed = modal_.feed_is_other && modal_.has_meant_feed &&
                                form.function == Function::Cycle &&
                                is_call(choice, block, invocation);
        if (needs_feed && !dialect_.cycles()[block.cycle].taps) {
            Block feed;
            feed.source = block.source;
            feed.skip_level = block.skip_level;
            feed.set(Slot::Feed, modal_.meant_feed);
            write_block(feed, out);
        }
        if (!form.lead.empty()) write_pitch(form, block, invocation, out);
        if (form.is_verbatim) write_needs(form, block, out);
        const bool is_alone = form.owns_block || form.owns_line;
        if (is_only || !(is_alone || shares_address(form, block))) continue;
        Items items;
        if (!form.is_verbatim) {
            for (const Function needed : form.needs) add_code(block, needed, items);
        }
        items.add(Item::of_form(form.order, choice.forms[i], &invocation));
        Block alone;
        alone.skip_level = block.skip_level;
        alone.text = block.text;
        alone.cycle = block.cycle;
        alone.arguments = block.arguments;
        alone.source = block.source;
        write_items(alone, items, {}, out);
        choice.finish(i);
    }
}

/// Whether the text has this shift already, on a control where it stays until another is
/// programmed.
bool BlockWriter::is_shift_standing(const Form& form, const Block& block,
                                    const Invocation& invocation) const {
    if (!form.remembers || options_.verbose_modal) return false;
    return std::ranges::all_of(form.words, [&](const FormWord& word) {
        if (word.parameter < 0) return true;
        const auto parameter = static_cast<std::size_t>(word.parameter);
        const NumberInForce& kept = modal_.frame.shift[parameter % modal_.frame.shift.size()];
        return kept.is_known && kept.value == block.argument(invocation, parameter, word.fallback);
    });
}

/// Whether a word of the form has the address of a word that the block has by itself: `G92 X0` and
/// a move to X. They cannot share a line.
bool BlockWriter::shares_address(const Form& form, const Block& block) const {
    if (form.function == Function::Cycle) return false;
    return std::ranges::any_of(form.words, [&](const FormWord& word) {
        if (word.address == kNoAddress) return false;
        const int slot = tables_.addresses[word.address].slot;
        return slot >= 0 && block.has(static_cast<Slot>(slot));
    });
}

void BlockWriter::write_before(const Form& form, const Block& block, std::string& out) {
    for (const Function function : form.before) {
        const bool is_rotation = function == Function::RotateOff;
        const bool is_mirror = function == Function::MirrorOff;
        if (is_rotation && modal_.frame.rotation == Activity::No) continue;
        if (is_mirror && modal_.frame.mirror == Activity::No) continue;
        if (function == Function::ScaleOff && modal_.frame.scale == Activity::No) continue;
        Block extra;
        extra.source = block.source;
        extra.skip_level = block.skip_level;
        extra.add(function);
        write_block(extra, out);
    }
}

/// A cycle that begins at the position of the tool axis needs the axis to be there.
void BlockWriter::write_initial_level(const Form& form, const Block& block,
                                      const Invocation& invocation, std::string& out) {
    if (is_at_level(form, block, invocation)) return;
    const double level = block.argument(invocation, static_cast<std::size_t>(form.implied[0]));
    const std::size_t axis = text_.plane_axes()[2];
    const Function motion = modal_.meant_of(Group::Motion);
    Block move;
    move.source = block.source;
    move.motion = Function::Rapid;
    move.set(static_cast<Slot>(axis), level);
    move.absolute = bit(static_cast<Slot>(axis));
    if (!tables_.notation.has_modes || modal_.text_of(Group::Distance) == Function::Absolute)
        move.absolute = 0;
    const Function distance = modal_.meant_of(Group::Distance);
    state_.mean(Group::Distance, Function::Absolute);
    write_block(move, out);
    state_.mean(Group::Distance, distance);
    state_.mean(Group::Motion, motion);
}

void BlockWriter::collect_functions(const Block& block, const Choice& choice, Items& items) {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (!choice.is_open(i)) continue;
        const Form& form = tables_.forms[choice.forms[i]];
        for (const Function needed : form.needs) {
            if (!form.is_verbatim && !chooser_.is_suppressed(needed))
                add_code(block, needed, items);
        }
        // The word that makes a call modal stands in front of the call.
        const int order = form.function == Function::CycleModal ? 0 : form.order;
        items.add(Item::of_form(order, choice.forms[i], &block.functions[i]));
    }
}

/// The code of a modal function without parameters.
void BlockWriter::add_code(const Block& block, Function function, Items& items) {
    for (const Item& item : items.all()) {
        if (item.form != kNoForm && tables_.forms[item.form].function == function) return;
    }
    static const Block kNothing{};
    for (const FormId id : tables_.forms_of[static_cast<std::size_t>(function)]) {
        const Form& form = tables_.forms[id];
        if (form.function != function || !chooser_.holds(form, kNothing, function, true)) continue;
        items.add(Item::of_form(form.order - 1, id, nullptr));
        state_.say(form);
        return;
    }
    messages_.cannot_express(block, quoted(info(function).name));
}

}  // namespace kadr::write
