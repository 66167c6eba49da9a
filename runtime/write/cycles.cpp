// The spindle and the feed around a cycle, and what is known behind it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "write/block_writer.h"
#include "write/cycle_groups.h"

namespace kadr::write {

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

/// Whether a cycle's block gives the control a spindle speed, in a word S or as an argument.
bool BlockWriter::has_speed(const Block& block, const Invocation& invocation) const {
    const std::vector<Parameter>& parameters = tables_.cycles[block.cycle].parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const bool is_given = (invocation.given >> i & 1u) != 0;
        if (!is_given || parameters[i].dimension != Dimension::Speed) continue;
        const double speed = block.argument(invocation, i);
        if (speed != 0 && speed != modal_.meant_speed) return true;
    }
    return false;
}

/// What the spindle has to be given behind a cycle that leaves it otherwise than it was asked to.
Function BlockWriter::spindle_behind(const Form& form, const Block& block,
                                     const Invocation& invocation) const {
    if (form.spindle_parameter < 0) return Function::None;
    const auto parameter = static_cast<std::size_t>(form.spindle_parameter);
    if ((invocation.given >> parameter & 1u) == 0) return Function::None;
    const Function wanted = nc::spindle_of_code(std::trunc(block.argument(invocation, parameter)));
    return wanted == form.leaves ? Function::None : wanted;
}

/// A cycle of the control may bring a feed and a speed of its own; those of the program act behind
/// it.
void BlockWriter::leave_cycle(const Block& block, const Choice& choice, std::string& out) {
    const Invocation* cycle = block.find(Function::Cycle);
    const FormId id = choice.forms[static_cast<std::size_t>(cycle - block.functions.data())];
    if (id == kNoForm) return;
    state_.follow_back(block, *cycle);
    const Form& form = tables_.forms[id];
    const bool has_feed = has_feed_word(block, choice, *cycle);
    Block back;
    back.source = block.source;
    back.skip_level = block.skip_level;
    const Function mode = modal_.meant_of(Group::FeedMode);
    const bool changes_mode =
        mode != Function::None && !form.needs.empty() && modal_.text_of(Group::FeedMode) != mode;
    if (changes_mode) back.add(mode);
    if (has_feed || changes_mode) {
        state_.doubt_feed();
        if (modal_.has_meant_feed) back.set(Slot::Feed, modal_.meant_feed);
    }
    const Function spindle = spindle_behind(form, block, *cycle);
    if (spindle != Function::None) back.add(spindle);
    if (has_speed(block, *cycle) || spindle != Function::None) {
        state_.doubt_speed();
        if (modal_.has_meant_speed) back.set(Slot::Speed, modal_.meant_speed);
        else if (const double speed = cycle_speed(block, *cycle);
                 spindle != Function::None && speed > 0)
            back.set(Slot::Speed, speed);
    }
    if (back.function_count == 0 && back.given == 0) return;
    write_block(back, out);
}

/// Whether the tool stands where the cycle wants to begin; true if it does not say where.
bool BlockWriter::is_at_level(const Form& form, const Block& block,
                              const Invocation& invocation) const {
    const auto level_at = static_cast<std::size_t>(form.implied[0]);
    if ((invocation.given >> level_at & 1u) == 0) return true;
    const double level = block.argument(invocation, level_at);
    const std::size_t axis = text_.plane_axes()[2];
    const double half_increment = 0.5 * std::pow(10.0, -text_.decimals(static_cast<Slot>(axis)));
    return text_.is_named(axis) && std::fabs(modal_.position.text[axis] - level) <= half_increment;
}

// ---------------------------------------------------------------- modal cycles

bool BlockWriter::is_ready_for(const Block& cycle, const Block& move) const {
    const auto waits_for_axis = [](const Pending& p) { return p.deferred->axis >= 0; };
    if (std::ranges::any_of(state_.pending(), waits_for_axis) || modal_.edge.waiting != 0 ||
        modal_.edge.is_length_due || modal_.edge.is_end_due)
        return false;
    return std::ranges::all_of(tables_.forms_of_cycle[cycle.cycle], [&](FormId id) {
        const Form& form = tables_.forms[id];
        if (move.has(Slot::Feed) && text_.has_feed_word(form)) return false;
        return form.implied.empty() || is_at_level(form, cycle, cycle.functions[0]);
    });
}

bool BlockWriter::ends_cycle(const Block& block) const {
    return open_cycle_ && block.function_count == 1 &&
           block.functions[0].function == Function::CycleModal;
}

/// Behind the lines of a block that is about a cycle.
void BlockWriter::follow_cycle(const Block& block, const Choice& choice, std::string& out) {
    if (is_modal_call(block)) open_cycle_ = OpenCycle{block, choice};
    else if (block.find(Function::Cycle) != nullptr) leave_cycle(block, choice, out);
    else if (ends_cycle(block)) close_cycle(out);
}

/// The lines that end the cycle, and what is said again behind it.
void BlockWriter::close_cycle(std::string& out) {
    const OpenCycle open = *std::exchange(open_cycle_, std::nullopt);
    const Invocation* cycle = open.block.find(Function::Cycle);
    const FormId id =
        open.choice.forms[static_cast<std::size_t>(cycle - open.block.functions.data())];
    if (id == kNoForm) return;
    write_further_lines(tables_.forms[id], open.block, cycle, out);
    leave_cycle(open.block, open.choice, out);
    state_.follow(open.block);
}

}  // namespace kadr::write
