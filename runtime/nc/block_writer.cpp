#include "nc/block_writer.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/assert.h"
#include "base/diagnostics/dialect.h"
#include "base/diagnostics/iso.h"
#include "base/text.h"
#include "nc/comment_text.h"

namespace kadr::nc {

namespace {

/// Groups whose active member is not written again. Spindle, coolant, work offset and length
/// compensation are: a tool change, an operator or another program may have changed them.
constexpr bool is_quiet_group(Group group) {
    switch (group) {
        case Group::Motion:
        case Group::Plane:
        case Group::Units:
        case Group::Distance:
        case Group::FeedMode:
        case Group::SpeedMode:
        case Group::RadiusComp:
        case Group::PathMode:
        case Group::CycleMode:
        case Group::CycleReturn:
        case Group::CompStart:
        case Group::CompCorner:
        case Group::CompCheck:
        case Group::Diameter:
        case Group::Compressor: return true;
        case Group::Once:
        case Group::LengthComp:
        case Group::WorkOffsets:
        case Group::Spindle:
        case Group::Coolant: return false;
    }
    return false;
}

/// Number to which the files set a switch; nothing if they do not.
std::optional<int> number_of_rule(const Dialect& dialect, std::string_view name) {
    std::optional<int> number;
    for (const RuleSetting& rule : dialect.rules()) {
        if (rule.name != name) continue;
        int value = 0;
        std::from_chars(rule.value.data(), rule.value.data() + rule.value.size(), value);
        number = value;
    }
    return number;
}

}  // namespace

BlockWriter::BlockWriter(const Dialect& dialect, const WriteOptions& options, DiagnosticSink& sink)
    : dialect_(dialect), tables_(dialect.tables()), options_(options), sink_(sink) {
    counts_feed_along_arc_ = dialect.has_rule("helix_feed_along_arc");
    shifts_center_ = dialect.has_rule("arc_error", "shift_center");
    scale_replaces_ = dialect.has_rule("scale_replaces");
    changer_moves_plane_ = dialect.has_rule("tool_change_moves_plane");
    if (const auto most = number_of_rule(dialect, "most_message"); most && *most > 0)
        most_message_ = static_cast<std::size_t>(*most);
    idle_is_alarm_ = dialect.has_rule("comp_more_empty_is_alarm");
    if (idle_is_alarm_ || dialect.has_rule("comp_more_empty_is_alarm", "no"))
        most_idle_ = number_of_rule(dialect, "comp_empty_blocks").value_or(-1);
    begin({});
    prepare_fast();
}

void BlockWriter::begin(const ProgramInfo& program) {
    modal_ = {};
    // The state in which every Kadr program begins; the start lines bring the control there.
    modal_.meant_of(Group::Motion) = Function::Rapid;
    modal_.meant_of(Group::Plane) = Function::PlaneXy;
    modal_.meant_of(Group::Units) = program.is_inch ? Function::Inch : Function::Metric;
    modal_.meant_of(Group::Distance) = Function::Absolute;
    modal_.meant_of(Group::FeedMode) = Function::FeedPerMinute;
    modal_.meant_of(Group::SpeedMode) = Function::CuttingSpeedOff;
    modal_.meant_of(Group::RadiusComp) = Function::RadiusCompOff;
    modal_.units.inch = modal_.units.inch_feed = program.is_inch;
    stand_without_codes();
    // A shift that keeps its words may be left over from another program.
    const auto& shifts = tables_.forms_of[static_cast<std::size_t>(Function::Shift)];
    const bool is_kept =
        std::ranges::any_of(shifts, [&](FormId id) { return tables_.forms[id].remembers; });
    for (Standing& s : modal_.shift) s = {!is_kept, 0};
    modal_.origin = modal_.shift;
    const BlockNumbers& numbers = tables_.block_numbers;
    const std::int64_t above =
        numbers.step > 0 ? (program.greatest_number / numbers.step + 1) * numbers.step : 0;
    number_ = program.greatest_number > 0 && above <= numbers.most ? std::max(numbers.start, above)
                                                                   : numbers.start;
    has_ended_ = false;
}

/// What the control has no code for it cannot have left: feeds a minute, X as a diameter, where no
/// code says so.
void BlockWriter::stand_without_codes() {
    for (std::size_t group = 0; group < kGroups; ++group) {
        const Function standing = tables_.power_on[group];
        if (standing != Function::None && !has_code(standing)) modal_.text[group] = standing;
    }
}

bool BlockWriter::has_code(Function function) const {
    return !tables_.forms_of[static_cast<std::size_t>(function)].empty();
}

void BlockWriter::forget_modal() {
    modal_.forget();
    stand_without_codes();
}

std::uint32_t BlockWriter::write(const Block& block, std::string& out) {
    const std::uint32_t before = lines_;
    switch (block.kind) {
        case Block::Kind::Nc:
            if (!write_fast(block, out)) write_long(block, out);
            if (most_idle_ >= 0) count_idle(block, before);
            break;
        case Block::Kind::Comment: write_comment(block, out); break;
        case Block::Kind::Raw:
            write_raw(block, out);
            idle_ = {};
            break;
        case Block::Kind::Label: cannot_express(block, "the label " + quoted(block.text)); break;
        case Block::Kind::Modal: forget_modal(); break;
        case Block::Kind::Position: take_position(block); break;
    }
    return lines_ == before ? lines_ : before + 1;
}

/// Lines in a row in which the cutter stays where it is beside a contour: behind so many of them
/// the control stops with an alarm, or cuts into inner corners, once the contour has begun.
/// Optional blocks may be left out, so each level is counted with them and without.
///
/// before       lines of the text before the block's
/// source       S 5.2 MD20250; F 4.3 No.19625
void BlockWriter::count_idle(const Block& block, std::uint32_t before) {
    constexpr int kContour = 2;  // moves: the way to the contour, and its first element
    const Function side = modal_.text_of(Group::RadiusComp);
    const bool acts = side == Function::RadiusCompLeft || side == Function::RadiusCompRight;
    if (!acts) return void(idle_ = {});
    if (idle_.moves == 0) idle_.level = block.skip;
    const auto axes = plane_axes();
    const SlotMask plane = SlotMask{1} << axes[0] | SlotMask{1} << axes[1];
    const bool moves = (block.given & (plane | kCenterSlots)) != 0;
    if (moves) idle_.moves = std::min(idle_.moves + 1, kContour);
    int most = 0;
    for (int i = 0; i < static_cast<int>(idle_.lines.size()); ++i) {
        const bool is_left_out =
            i > 0 && (i == 1 + block.skip || (block.skip_also >> (i - 1) & 1u) != 0);
        int& lines = idle_.lines[static_cast<std::size_t>(i)];
        if (!is_left_out) lines = moves ? 0 : lines + static_cast<int>(lines_ - before);
        // Without the blocks of a level in which the compensation begins nothing is compensated.
        if (idle_.level < 0 || i != 1 + idle_.level) most = std::max(most, lines);
    }
    if (idle_.moves < kContour || most <= most_idle_) return;
    if (!is_new_message(block, "idle")) return;
    const std::string fix = "end the compensation before them, or move in the plane in between";
    if (!idle_is_alarm_) {
        sink_.report(diag::IdleCutsCorners, place(block))
            .arg(tables_.name)
            .arg(most_idle_)
            .fix(fix);
        return;
    }
    const auto alarm = dialect_.alarm(diag::CompEmptyBlocks);
    sink_.report(diag::TooManyIdle, place(block))
        .arg(tables_.name)
        .arg(alarm ? alarm->number : std::string("without a number"))
        .arg(most_idle_)
        .fix(fix);
}

/// What the program knows of the axes behind a change of its frame, of which the text says nothing.
void BlockWriter::take_position(const Block& block) {
    WrittenPosition& position = modal_.position;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (!block.has(static_cast<Slot>(axis)) || is_known(axis)) continue;
        position.meant[axis] = position.text[axis] = block.at(static_cast<Slot>(axis));
        position.known |= bit(static_cast<Slot>(axis));
        position.told |= bit(static_cast<Slot>(axis));
    }
}

/// Whether the number that would be written is in force already.
bool BlockWriter::is_standing(Slot slot, double value, const Standing& standing) const {
    return standing.is_known && standing.value == round_to(to_text(slot, value), decimals(slot));
}

// ---------------------------------------------------------------- blocks

Function BlockWriter::effective_motion(const Block& block) const {
    // Whatever the modal motion is.
    if (block.function_count != 0 && block.find(Function::Probe) != nullptr) return Function::Line;
    return block.motion != Function::None ? block.motion : modal_.meant[index_of(Group::Motion)];
}

void BlockWriter::write_long(const Block& block, std::string& out) {
    given_number_ = block.number;
    check_front(block);
    check_arc_words(block);
    if (block.skip < 0) {
        write_block(block, out);
    } else {
        // The operator may leave it out: behind it, only what is the same with and without it is
        // known, so that everything else is said again.
        const std::size_t waiting = pending_.size();
        const WriterModal before = modal_;
        write_block(block, out);
        if (pending_.size() < waiting) {
            cannot_express(block,
                           "a block that may be left out where the tool length begins to act");
        }
        modal_.keep_common(before);
    }
    if (given_number_ >= 0) {  // all that the block says holds already
        open_line(block.skip, true, out);
        end_block(out);
        close_line(out);
    }
}

/// Block number and skip level that the control takes.
void BlockWriter::check_front(const Block& block) {
    if (block.number > tables_.block_numbers.most) {
        number_fault(block, NumberFault::TooLarge, block.number, Dimension::Count, "N");
    }
    const bool is_level =
        block.skip >= tables_.rules.default_skip && block.skip < tables_.rules.skip_levels;
    if (block.skip_also != 0) cannot_express(block, "several skip levels of one block");
    if (block.skip >= 0 && !is_level) {
        cannot_express(block, "the skip level " + std::to_string(block.skip));
    }
}

/// Centre, radius and turns are for arcs, and an arc that moves has a centre or a radius.
void BlockWriter::check_arc_words(const Block& block) {
    constexpr SlotMask kArcMoves = kArcSlots | kTargetSlots;
    if ((block.given & kArcMoves) == 0) return;
    const Function motion =
        block.find(Function::Cycle) != nullptr ? Function::Cycle : effective_motion(block);
    const bool has_centre = (block.given & kCenterSlots) != 0;
    if (motion == Function::None || takes_pitch(motion)) {
        // After raw text the author knows; beside a motion of threads the centre word is the pitch.
    } else if (!is_arc(motion)) {
        for (std::size_t i = 0; i < kSlots; ++i) {
            const auto slot = static_cast<Slot>(i);
            if ((block.given & kArcSlots & bit(slot)) == 0) continue;
            if (!is_new_message(block, slot_name(slot))) continue;
            sink_.report(diag::ArcWordWithoutArc, place(block))
                .arg(slot_name(slot))
                .arg(info(motion).name);
        }
        return;
    } else if (!has_centre && !block.has(Slot::Radius)) {
        if (is_new_message(block, "no centre")) sink_.report(diag::ArcSaidNowhere, place(block));
        return;
    }
    if (has_centre && block.has(Slot::Radius) && is_new_message(block, "centre and radius"))
        sink_.report(diag::ArcSaidTwice, place(block));
    if (!block.has(Slot::Turns)) return;
    const double turns = block.at(Slot::Turns);
    if (!(turns >= 0 && turns == std::nearbyint(turns))) {
        number_fault(block, NumberFault::NotReadBack, turns, Dimension::Count,
                     slot_name(Slot::Turns));
    } else if (turns > kMostTurns) {
        number_fault(block, NumberFault::TooLarge, turns, Dimension::Count, slot_name(Slot::Turns));
    }
}

/// A control that counts knots needs one beside every control point.
void BlockWriter::check_knot(const Block& block, Function motion) {
    if (motion != Function::Spline || (block.given & kTargetSlots) == 0) return;
    const bool has_intervals = dialect_.can_write(Function::SplineInterval);
    if (has_intervals || !dialect_.can_write(Function::SplineKnot)) return;
    if (block.find(Function::SplineKnot) == nullptr)
        cannot_express(block, "a control point without its knot");
}

/// Arcs that need other blocks; the plane and the dimensions that the block says hold for them.
bool BlockWriter::write_other_arc(const Block& block, std::string& out) {
    if (!is_arc(effective_motion(block))) return split_turns(block, out);
    const ModalFunctions meant = modal_.meant;
    follow_modal(block, modal_.meant);
    if (split_turns(block, out) || straighten(block, out) || (!is_halved_ && halve(block, out)))
        return true;
    modal_.meant = meant;
    return false;
}

void BlockWriter::write_block(const Block& block, std::string& out) {
    if (write_other_arc(block, out) || write_thread(block, out)) return;
    if (modal_.waiting_edge != 0) write_waiting_edge(block, out);
    if (modal_.is_length_due) check_length_due(block);
    if (modal_.doubtful != 0) say_doubtful(block, out);
    const Function diameter = modal_.text_of(Group::Diameter);
    done_ = 0;
    choose_forms(block);
    if (needs_incremental(block)) drop_function(block, Function::Absolute);
    write_functions_alone(block, out);
    follow_functions(block);

    Items items;
    restore_modal(block, items);
    collect_functions(block, items);
    if (modal_.text_of(Group::Diameter) != diameter) change_diameter(diameter);
    Targets targets;
    const WrittenPosition start = modal_.position;
    const Function motion = effective_motion(block);
    if (block.motion != Function::None && block.motion != motion)
        cannot_express(block, "a probing move that is no line at feed");
    place_targets(block, targets);
    check_knot(block, motion);
    if (is_arc(motion)) {
        place_arc(block, start, targets);
        place_arc_feed(block, start, targets);
        place_helix_feed(block, start, targets);
    } else if (motion == Function::None) {
        place_arc_as_given(block, start, targets);
    } else if (takes_pitch(motion)) {
        for (const Slot slot : {Slot::CenterX, Slot::CenterY, Slot::CenterZ}) {
            if (!block.has(slot)) continue;
            targets.written |= bit(slot);
            targets.number[static_cast<std::size_t>(slot)] = to_text(slot, block.at(slot));
        }
    } else if (block.function_count == 0 && !options_.verbose_modal) {
        drop_unchanged(block, start, targets);
    }
    // An incremental word that the control can only say under incremental dimensions.
    if (targets.written != 0 && targets.needs_incremental &&
        modal_.text_of(Group::Distance) != Function::Incremental) {
        add_code(block, Function::Incremental, items);
    }
    const bool probes = block.function_count != 0 && block.find(Function::Probe) != nullptr;
    const bool says_motion = block.motion != Function::None ||
                             (!probes && (block.given & (kTargetSlots | kCenterSlots)) != 0);
    if (says_motion) {
        const bool is_new = modal_.text_of(Group::Motion) != motion;
        if (motion != Function::None &&
            (is_new || (options_.verbose_modal && block.motion != Function::None))) {
            add_code(block, motion, items);
        }
    }
    add_deferred(block, items);
    add_edge(block, items);
    collect_slots(block, targets, items);
    if (items.count == 0 && given_number_ < 0) {
        if (!block.comment.empty()) write_comment(block, out);
    } else if (items.count != 0 || !block.comment.empty()) {
        write_items(block, items, targets, out);
    }
    for (Pending& pending : pending_) pending.tool = own_offset(pending, block);
    if (block.find(Function::Cycle) != nullptr) leave_cycle(block, out);
    for (std::size_t i = 0; i < block.function_count; ++i)
        follow_function(block, block.functions[i]);
}

// ---------------------------------------------------------------- threads

/// The axis along which a straight move goes the longer way; nothing if the block does not tell.
std::optional<std::size_t> BlockWriter::longer_way(const Block& block) const {
    std::optional<std::size_t> longest;
    double most = -1;
    bool is_certain = true;
    std::size_t count = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto slot = static_cast<Slot>(axis);
        if (!block.has(slot)) continue;
        ++count;
        const bool is_way = is_distance(block, axis);
        is_certain &= is_way || is_known(axis);
        const double way =
            std::fabs(is_way ? block.at(slot) : block.at(slot) - modal_.position.meant[axis]);
        if (way > most) longest = axis, most = way;
    }
    return count == 1 || is_certain ? longest : std::nullopt;
}

/// The pitch of a thread stands where the control takes it: in F, or in the word of the axis that
/// goes the longer way. True: the block is written.
bool BlockWriter::write_thread(const Block& block, std::string& out) {
    if (effective_motion(block) != Function::Thread || (block.given & kTargetSlots) == 0 ||
        block.find(Function::Cycle) != nullptr)
        return false;
    const auto& forms = tables_.forms_of[static_cast<std::size_t>(Function::Thread)];
    if (forms.empty()) return false;
    const bool is_feed = tables_.forms[forms[0]].feed_is_pitch;
    const SlotMask words = block.given & kCenterSlots;
    if (words == 0 && !block.has(Slot::Feed)) {
        if (is_new_message(block, "no pitch")) sink_.report(diag::ThreadSaidNowhere, place(block));
        return true;
    }
    if (is_feed ? words == 0 : words != 0) return false;
    Block said = block;
    if (is_feed) {
        const auto word = static_cast<Slot>(std::countr_zero(words));
        said.given &= ~kCenterSlots;
        said.set(Slot::Feed, block.at(word));
    } else {
        const std::optional<std::size_t> axis = longer_way(block);
        if (!axis) {
            position_unknown(block, "F");
            return true;
        }
        said.given &= ~bit(Slot::Feed);
        said.set(static_cast<Slot>(static_cast<std::size_t>(Slot::CenterX) + *axis),
                 block.at(Slot::Feed));
    }
    // The feed of the program, which the pitch is not, acts again behind the thread.
    const double feed = block.has(Slot::Feed) ? block.at(Slot::Feed) : modal_.meant_feed;
    const bool has_feed = block.has(Slot::Feed) || modal_.has_meant_feed;
    feed_is_lead_ = is_feed;
    write_block(said, out);
    feed_is_lead_ = false;
    modal_.meant_feed = feed;
    modal_.has_meant_feed = has_feed;
    if (is_feed) modal_.feed_is_other = true;
    return true;
}

// ---------------------------------------------------------------- cutting edges, cycles

/// The edge that a block in machine coordinates put aside acts again where the tool moves next.
void BlockWriter::write_waiting_edge(const Block& block, std::string& out) {
    const bool is_machine = block.find(Function::MachineCoordinates) != nullptr ||
                            block.find(Function::ReferencePoint) != nullptr ||
                            block.find(Function::ReferenceReturn) != nullptr;
    const bool moves = (block.given & kTargetSlots) != 0 || block.find(Function::Cycle) != nullptr;
    if (is_machine || !moves || block.find(Function::ToolEdge) != nullptr) return;
    say_waiting_edge(block, out);
}

/// In a line that nobody leaves out, whatever the block beside it is.
void BlockWriter::say_waiting_edge(const Block& block, std::string& out) {
    Block edge;
    edge.source = block.source;
    Invocation* invocation = edge.add(Function::ToolEdge, 1);
    edge.set_argument(*invocation, 0, std::exchange(modal_.waiting_edge, 0));
    const WrittenPosition position = modal_.position;
    write_block(edge, out);
    modal_.position = position;
    modal_.is_length_due = true;
}

/// The length comes with the first motion along it: a way there would be travelled less the length.
void BlockWriter::check_length_due(const Block& block) {
    const std::size_t along = plane_axes()[2];
    const bool is_other =
        block.function_count != 0 && (block.find(Function::MachineCoordinates) != nullptr ||
                                      block.find(Function::ReferencePoint) != nullptr ||
                                      block.find(Function::ReferenceReturn) != nullptr);
    if (is_other || !block.has(static_cast<Slot>(along))) return;
    modal_.is_length_due = false;
    if (!is_distance(block, along)) return;
    cannot_express(block, "a distance along " + std::string(kAxisNames[along]) +
                              " behind a move without the tool's length");
}

/// Where the tool length would act in machine coordinates, edge 0 stands beside them.
void BlockWriter::add_edge(const Block& block, Items& items) {
    if (block.function_count == 0 || block.find(Function::ToolEdge) != nullptr) return;
    for (std::size_t i = 0; i < items.count; ++i) {
        const Item& item = items.list[i];
        if (item.form == kNoForm || !tables_.forms[item.form].keeps_length) continue;
        const Standing old = std::exchange(modal_.edge, Standing{true, 0});
        if (old.is_known && old.value == 0) return;
        const auto& edges = tables_.forms_of[static_cast<std::size_t>(Function::ToolEdge)];
        if (edges.empty()) return;
        if (old.is_known) modal_.waiting_edge = old.value;
        if (!old.is_known && modal_.is_edge_lost && modal_.waiting_edge == 0)
            cannot_express(block,
                           "a move without tool length, while nobody knows which cutting edge "
                           "acts (say `D1` before it),");
        items.add(Item::of_edge(tables_.forms[edges[0]].order, 0));
        return;
    }
}

/// The first speed among a cycle's arguments; 0 if it has none.
double BlockWriter::cycle_speed(const Block& block, const Invocation& invocation) const {
    const std::vector<Parameter>& parameters = tables_.cycles[block.cycle].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const bool is_given = (invocation.given >> i & 1u) != 0;
        if (is_given && parameters[i].dimension == Dimension::Speed)
            return block.argument(invocation, i);
    }
    return 0;
}

/// Whether a cycle's block tells the control a spindle speed, in a word S or as an argument.
bool BlockWriter::says_speed(const Block& block, const Invocation& invocation) const {
    const std::vector<Parameter>& parameters = tables_.cycles[block.cycle].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const bool is_given = (invocation.given >> i & 1u) != 0;
        if (!is_given || parameters[i].dimension != Dimension::Speed) continue;
        const double speed = block.argument(invocation, i);
        if (speed != 0 && speed != modal_.meant_speed) return true;
    }
    return false;
}

/// What the spindle has to be told behind a cycle that leaves it otherwise than it was asked to.
Function BlockWriter::spindle_behind(const Form& form, const Block& block,
                                     const Invocation& invocation) const {
    if (form.spindle_parameter < 0) return Function::None;
    const auto parameter = static_cast<std::size_t>(form.spindle_parameter);
    if ((invocation.given >> parameter & 1u) == 0) return Function::None;
    const auto code = static_cast<int>(block.argument(invocation, parameter));
    const Function wanted = code == 3   ? Function::SpindleCw
                            : code == 4 ? Function::SpindleCcw
                                        : Function::SpindleStop;
    return wanted == form.leaves ? Function::None : wanted;
}

/// A cycle of the control may bring a feed and a speed of its own; those of the program act behind
/// it.
void BlockWriter::leave_cycle(const Block& block, std::string& out) {
    const Invocation* cycle = block.find(Function::Cycle);
    const FormId id = chosen_[static_cast<std::size_t>(cycle - block.functions.data())];
    if (id == kNoForm) return;
    const Form& form = tables_.forms[id];
    const bool says_feed = has_feed_word(block, *cycle);
    Block back;
    back.source = block.source;
    back.skip = block.skip;
    const Function mode = modal_.meant_of(Group::FeedMode);
    const bool changes_mode =
        mode != Function::None && !form.needs.empty() && modal_.text_of(Group::FeedMode) != mode;
    if (changes_mode) back.add(mode);
    if (says_feed || changes_mode) {
        modal_.feed.is_known = false;
        if (modal_.has_meant_feed) back.set(Slot::Feed, modal_.meant_feed);
    }
    const Function spindle = spindle_behind(form, block, *cycle);
    if (spindle != Function::None) back.add(spindle);
    if (says_speed(block, *cycle) || spindle != Function::None) {
        modal_.speed.is_known = false;
        if (modal_.has_meant_speed) back.set(Slot::Speed, modal_.meant_speed);
        else if (const double speed = cycle_speed(block, *cycle);
                 spindle != Function::None && speed > 0)
            back.set(Slot::Speed, speed);
    }
    if (back.function_count == 0 && back.given == 0) return;
    write_block(back, out);
}

void BlockWriter::write_comment(const Block& block, std::string& out) {
    std::string_view rest = block.comment;
    do {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string text = comment_text(rest.substr(0, end), tables_.comment);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        // Long comments go on in the next line, cut at a blank.
        do {
            std::size_t length = text.size();
            const std::size_t most = tables_.comment.max_length;
            if (most != 0 && length > most) {
                const std::size_t cut = text.rfind(' ', most);
                length = cut == std::string::npos || cut == 0 ? most : cut;
            }
            open_line(-1, false, out);
            out += tables_.comment.open;
            out.append(text, 0, length);
            if (tables_.comment.close.empty()) {
                while (out.ends_with(' ')) out.pop_back();
            }
            out += tables_.comment.close;
            close_line(out);
            text.erase(0, std::min(text.size(), text.find_first_not_of(' ', length)));
        } while (!text.empty());
    } while (!rest.empty());
}

void BlockWriter::write_raw(const Block& block, std::string& out) {
    // The author's text stands under the dimensions that he has said, not under those that a block
    // before it needed.
    if (modal_.feed_is_other && modal_.has_meant_feed) {
        Block feed;
        feed.source = block.source;
        feed.set(Slot::Feed, modal_.meant_feed);
        write_block(feed, out);
    }
    if (modal_.waiting_edge != 0) say_waiting_edge(block, out);
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
    if (tables_.comment.is_ascii && foreign != block.text.end() && is_unsaid(block, "raw")) {
        const auto at = static_cast<std::size_t>(foreign - block.text.begin());
        sink_.report(diag::RawCharacter, place(block))
            .arg(code_points(std::string_view(block.text).substr(at), 0, 1))
            .arg(tables_.name);
    }
    std::string_view rest = block.text;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        open_line(-1, false, out);
        out += rest.substr(0, end);
        close_line(out);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    forget_modal();
}

// ---------------------------------------------------------------- functions

void BlockWriter::choose_forms(const Block& block) {
    chosen_.fill(kNoForm);
    // Forms that say several functions at once come first, so that nothing is said twice.
    for (const bool with_others : {true, false}) {
        for (std::size_t i = 0; i < block.function_count; ++i) {
            const Invocation& invocation = block.functions[i];
            const auto function = static_cast<std::size_t>(invocation.function);
            if (tables_.said_with_others[function] != with_others || (done_ >> i & 1u) != 0)
                continue;
            if (is_suppressed(invocation.function) || is_left_to_machine(block, invocation)) {
                done_ |= 1u << i;
                continue;
            }
            chosen_[i] = choose_form(block, invocation);
            if (chosen_[i] == kNoForm) {
                done_ |= 1u << i;
                continue;
            }
            const Form& form = tables_.forms[chosen_[i]];
            for (std::size_t j = 0; j < block.function_count; ++j) {
                const Function other = block.functions[j].function;
                const bool is_said =
                    j != i && (other == form.function ||
                               std::ranges::find(form.sets, other) != form.sets.end());
                if (is_said && !form.sets.empty()) done_ |= 1u << j;
            }
        }
    }
}

/// The block does without the code; what it means for the blocks behind it holds.
void BlockWriter::drop_function(const Block& block, Function function) {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if (block.functions[i].function != function) continue;
        done_ |= 1u << i;
        chosen_[i] = kNoForm;
    }
}

bool BlockWriter::is_suppressed(Function function) const {
    const Group group = info(function).group;
    // Where the letters say it, no code does.
    if (group == Group::Distance && tables_.has_incremental_letters) return true;
    return is_quiet_group(group) && modal_.text[index_of(group)] == function &&
           (!options_.verbose_modal || !has_code(function));
}

/// Whether X is a diameter, on a control that has neither a code for it nor a rule: its text is the
/// same, and right where the machine is set so.
bool BlockWriter::is_left_to_machine(const Block& block, const Invocation& invocation) {
    if (info(invocation.function).group != Group::Diameter) return false;
    const bool has_any = has_code(Function::DiameterOn) || has_code(Function::DiameterOff) ||
                         tables_.power_on[index_of(Group::Diameter)] != Function::None;
    if (has_any) return false;
    if (is_unsaid(block, info(invocation.function).name)) {
        const bool is_diameter = invocation.function == Function::DiameterOn;
        sink_.report(diag::DiameterLeft, place(block))
            .arg(tables_.name)
            .arg(is_diameter ? "diameter" : "radius")
            .fix("for a lathe take the dialect of one, as `fanuc-lathe` is");
    }
    modal_.text_of(Group::Diameter) = invocation.function;
    return true;
}

/// The line that a form wants before its own: `M29 S800` before the tapping cycle.
void BlockWriter::write_lead(const Form& form, const Block& block, const Invocation& invocation,
                             std::string& out) {
    open_line(block.skip, true, out);
    append_words(block, form.lead, &invocation, false, out);
    end_block(out);
    close_line(out);
    note_line(form.lead);
}

/// Functions that cannot share a line with others, and what has to be written before them.
void BlockWriter::write_functions_alone(const Block& block, std::string& out) {
    const bool is_only =
        block.function_count == 1 && block.given == 0 && block.motion == Function::None;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if ((done_ >> i & 1u) != 0 || chosen_[i] == kNoForm) continue;
        const Form& form = tables_.forms[chosen_[i]];
        const Invocation& invocation = block.functions[i];
        write_before(form, block, out);
        if (is_shift_standing(form, block, invocation)) {
            done_ |= 1u << i;
            continue;
        }
        if (!form.implied.empty()) write_initial_level(form, block, invocation, out);
        if (!form.lead.empty()) write_lead(form, block, invocation, out);
        const bool is_alone = form.owns_block || form.owns_line;
        if (is_only || !(is_alone || shares_address(form, block))) continue;
        Items items;
        for (const Function needed : form.needs) add_code(block, needed, items);
        items.add(Item::of_form(form.order, chosen_[i], &invocation));
        Block alone;
        alone.skip = block.skip;
        alone.text = block.text;
        alone.cycle = block.cycle;
        alone.arguments = block.arguments;
        alone.source = block.source;
        write_items(alone, items, {}, out);
        done_ |= 1u << i;
    }
}

/// Whether the text has this shift already, on a control where it stays until another is said.
bool BlockWriter::is_shift_standing(const Form& form, const Block& block,
                                    const Invocation& invocation) const {
    if (!form.remembers || options_.verbose_modal) return false;
    return std::ranges::all_of(form.words, [&](const FormWord& word) {
        if (word.parameter < 0) return true;
        const auto parameter = static_cast<std::size_t>(word.parameter);
        const Standing& kept = modal_.shift[parameter % modal_.shift.size()];
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
        if (is_rotation && modal_.rotation == Activity::No) continue;
        if (is_mirror && modal_.mirror == Activity::No) continue;
        if (function == Function::ScaleOff && modal_.scale == Activity::No) continue;
        const auto chosen = chosen_;
        const std::uint32_t done = done_;
        Block extra;
        extra.source = block.source;
        extra.skip = block.skip;
        extra.add(function);
        write_block(extra, out);
        chosen_ = chosen;
        done_ = done;
    }
}

/// A cycle that begins at the position of the tool axis needs the axis to be there.
void BlockWriter::write_initial_level(const Form& form, const Block& block,
                                      const Invocation& invocation, std::string& out) {
    const auto level_at = static_cast<std::size_t>(form.implied[0]);
    if ((invocation.given >> level_at & 1u) == 0) return;
    const double level = block.argument(invocation, level_at);
    const std::size_t axis = plane_axes()[2];
    const double half_increment = 0.5 * std::pow(10.0, -decimals(static_cast<Slot>(axis)));
    const bool is_there =
        is_named(axis) && std::fabs(modal_.position.text[axis] - level) <= half_increment;
    if (is_there) return;
    const auto chosen = chosen_;
    const std::uint32_t done = done_;
    const Function motion = modal_.meant_of(Group::Motion);
    Block move;
    move.source = block.source;
    move.motion = Function::Rapid;
    move.set(static_cast<Slot>(axis), level);
    move.absolute = bit(static_cast<Slot>(axis));
    if (!tables_.rules.has_modes || modal_.text_of(Group::Distance) == Function::Absolute)
        move.absolute = 0;
    const Function distance = modal_.meant_of(Group::Distance);
    modal_.meant_of(Group::Distance) = Function::Absolute;
    write_block(move, out);
    modal_.meant_of(Group::Distance) = distance;
    modal_.meant_of(Group::Motion) = motion;
    chosen_ = chosen;
    done_ = done;
}

void BlockWriter::collect_functions(const Block& block, Items& items) {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if ((done_ >> i & 1u) != 0 || chosen_[i] == kNoForm) continue;
        const Form& form = tables_.forms[chosen_[i]];
        for (const Function needed : form.needs) {
            if (!is_suppressed(needed)) add_code(block, needed, items);
        }
        items.add(Item::of_form(form.order, chosen_[i], &block.functions[i]));
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
        if (form.function != function || !holds(form, kNothing, function, true)) continue;
        items.add(Item::of_form(form.order - 1, id, nullptr));
        note_written(form);
        return;
    }
    cannot_express(block, quoted(info(function).name));
}

/// Whether a form of the block stands under these dimensions only.
bool BlockWriter::needs_distance(const Block& block, Function distance) const {
    for (std::size_t i = 0; i < block.function_count; ++i) {
        if ((done_ >> i & 1u) != 0 || chosen_[i] == kNoForm) continue;
        const std::vector<Function>& during = tables_.forms[chosen_[i]].during;
        if (std::ranges::find(during, distance) != during.end()) return true;
    }
    return false;
}

/// What the text no longer agrees upon with the program: after a conversion, or at the start.
void BlockWriter::restore_modal(const Block& block, Items& items) {
    const auto restore = [&](Group group) {
        const Function meant = modal_.meant_of(group);
        if (meant == Function::None || modal_.text_of(group) == meant) return;
        for (std::size_t i = 0; i < block.function_count; ++i) {
            const bool is_done = (done_ >> i & 1u) != 0;  // before a line that changed it again
            if (!is_done && info(block.functions[i].function).group == group)
                return;  // the block says it itself
        }
        add_code(block, meant, items);
    };
    // Modal codes outlive the program on many machines: none ends under G91 that did not mean to.
    const bool is_end = block.function_count != 0 && (block.find(Function::End) != nullptr ||
                                                      block.find(Function::EndRewind) != nullptr);
    const bool acts = is_end || (block.given & kTargetSlots) != 0 ||
                      needs_distance(block, modal_.meant_of(Group::Distance));
    // Words that are said as distances whatever is meant leave the text as it is.
    const bool stays = needs_incremental(block) && !needs_distance(block, Function::Absolute);
    if (acts && !stays && !tables_.has_incremental_letters) restore(Group::Distance);
    if (is_arc(effective_motion(block)) && (block.given & (kTargetSlots | kCenterSlots)) != 0)
        restore(Group::Plane);
    if (block.has(Slot::Feed)) restore(Group::FeedMode);
    if (modal_.doubtful == 0 || (block.given & (kTargetSlots | kCenterSlots)) == 0) return;
    for (std::size_t i = 0; i < kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        if (is_said_again(group)) restore(group);
    }
}

/// Whether the group is said again before something moves. A compensation that acts is not: to say
/// it a second time is a command of its own on some controls.
bool BlockWriter::is_said_again(Group group) const {
    const Function meant = modal_.meant[index_of(group)];
    if ((modal_.doubtful & bit(group)) == 0 || meant == Function::None) return false;
    return has_code(meant) && (group != Group::RadiusComp || meant == Function::RadiusCompOff);
}

/// A cycle has no room for codes, and depends on them: they stand before it.
void BlockWriter::say_doubtful(const Block& block, std::string& out) {
    if (block.function_count == 0 || block.find(Function::Cycle) == nullptr) return;
    Block again;
    again.source = block.source;
    again.skip = block.skip;
    for (std::size_t i = 0; i < kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        if (is_said_again(group)) again.add(modal_.meant[i]);
    }
    if (again.function_count != 0) write_block(again, out);
}

void BlockWriter::note_written(const Form& form) {
    const auto note = [&](Function function) {
        const Group group = info(function).group;
        if (group == Group::Once) return;
        modal_.text_of(group) = function;
        modal_.doubtful &= ~bit(group);
        if (group == Group::Units) {
            modal_.units.inch = function == Function::Inch;
            modal_.units.inch_feed = modal_.units.inch && !form.feed_stays_metric;
            modal_.feed.is_known = modal_.speed.is_known = false;
        }
        if (group == Group::FeedMode) {
            modal_.units.per_revolution = function == Function::FeedPerRevolution;
            modal_.units.inverse_time = function == Function::FeedInverseTime;
            modal_.feed.is_known = false;
            feed_every_block_ = form.feed_every_block;
            inverse_arc_by_radius_ = form.feed_by_radius;
        }
        if (group == Group::SpeedMode) {
            modal_.units.cutting_speed = function == Function::CuttingSpeedOn;
            modal_.speed.is_known = false;
        }
    };
    note(form.function);
    for (const Function also : form.sets) note(also);
}

// ---------------------------------------------------------------- messages

SourceRange BlockWriter::place(const Block& block) const {
    return block.source.index < statements_.size() ? statements_[block.source.index]
                                                   : SourceRange{};
}

/// The word of the statement that sets the address: `Z+=10`, `Z=h`, `Z5`. The statement, if no such
/// word stands in it.
SourceRange BlockWriter::word_place(const Block& block, std::string_view address) const {
    SourceRange statement = place(block);
    if (sources_ == nullptr || !statement.file.is_valid()) return statement;
    const std::string_view text = sources_->text(statement);
    const auto is_part_of_name = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               c == '_' || c == '.' || (static_cast<unsigned char>(c) & 0x80u) != 0;
    };
    // A word stands outside brackets, and nothing in front of it waits for a value.
    int depth = 0;
    char before = ' ';
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == ' ' || c == '\t' || c == '\n') continue;
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        const std::size_t behind = i + address.size();
        const bool is_first = i == 0 || !is_part_of_name(text[i - 1]);
        const bool is_operand =
            std::string_view("=+-*/%<>?:,&|!").find(before) != std::string::npos;
        before = c;
        if (depth != 0 || !is_first || is_operand || behind >= text.size()) continue;
        const bool is_word =
            text.substr(i).starts_with(address) &&
            std::string_view("=+-.0123456789").find(text[behind]) != std::string::npos;
        if (!is_word) continue;
        std::size_t end = behind;
        int inside = 0;
        for (; end < text.size(); ++end) {
            if (text[end] == '(') ++inside;
            if (text[end] == ')') --inside;
            if (inside == 0 && (text[end] == ' ' || text[end] == ';' || text[end] == '\n')) break;
        }
        return {statement.file, statement.begin + static_cast<std::uint32_t>(i),
                statement.begin + static_cast<std::uint32_t>(end)};
    }
    return statement;
}

/// The writing failed; whether the statement has not said this yet: a loop reports once.
bool BlockWriter::is_new_message(const Block& block, std::string_view what) {
    failed_ = true;
    return is_unsaid(block, what);
}

/// Whether the statement has not been told this yet.
bool BlockWriter::is_unsaid(const Block& block, std::string_view what) {
    const std::uint64_t key =
        std::hash<std::string_view>()(what) ^ (std::uint64_t{block.source.index} << 32);
    return reported_.insert(key).second;
}

void BlockWriter::position_unknown(const Block& block, std::string_view name) {
    if (!is_new_message(block, name)) return;
    DiagnosticBuilder builder = sink_.report(diag::WriterPositionUnknown, word_place(block, name));
    builder.arg(name);
    if (name == "F" && !block.has(Slot::Feed))
        builder.note("the feed that acts is worked out again for this block");
    builder.fix("name the coordinates of the axes in a block before it: `G0 X… Y…`, `Z…`");
}

void BlockWriter::cannot_express(const Block& block, const std::string& what) {
    if (!is_new_message(block, what)) return;
    sink_.report(diag::CannotExpress, place(block)).arg(tables_.name).arg(what);
}

void BlockWriter::number_fault(const Block& block, NumberFault fault, double value,
                               Dimension dimension, std::string_view name) {
    if (!is_new_message(block, name)) return;
    const std::string quantity = quantity_words(value, dimension, modal_.units);
    switch (fault) {
        case NumberFault::None: break;
        case NumberFault::NotFinite:
            sink_.report(diag::ValueNotFinite, word_place(block, name)).arg(name);
            break;
        case NumberFault::TooLarge:
            sink_.report(diag::ValueTooLarge, word_place(block, name)).arg(quantity).arg(name);
            break;
        case NumberFault::Negative:
            sink_.report(diag::ValueNegative, word_place(block, name)).arg(name).arg(quantity);
            break;
        case NumberFault::Point:
        case NumberFault::NotReadBack:
            sink_.report(diag::ValueNotReadBack, word_place(block, name)).arg(quantity).arg(name);
            break;
    }
}

}  // namespace kadr::nc
