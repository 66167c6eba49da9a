#include "write/text_view.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"

namespace kadr::write {

const Address& TextView::address_of(Slot slot) const {
    static const Address kNone = [] {
        Address none;
        none.dimension = Dimension::Length;
        return none;
    }();
    return has_address(slot) ? tables.addresses[tables.slot_address[static_cast<std::size_t>(slot)]]
                             : kNone;
}

double TextView::to_text(Slot slot, double value) const {
    return value * text_scale(address_of(slot).dimension, modal.units, true);
}

int TextView::decimals(Slot slot) const {
    const Address& address = address_of(slot);
    if (slot == Slot::Feed && feed_word.is_pitch)
        return text_decimals(pitch_format(address.format), address.dimension, modal.units);
    return text_decimals(address.format, address.dimension, modal.units);
}

Activity TextView::activity_of(Function function) const {
    switch (function) {
        case Function::Shift: return is_shifted();
        case Function::Rotate: return modal.frame.rotation;
        case Function::Scale: return modal.frame.scale;
        case Function::Mirror: return modal.frame.mirror;
        default: break;
    }
    return modal.text_of(info(function).group) == function ? Activity::Yes : Activity::No;
}

/// Where nobody knows, it is taken for none: a program does not begin in somebody's shift.
Activity TextView::is_shifted() const {
    const bool is_one = std::ranges::any_of(modal.frame.origin, [](const NumberInForce& shift) {
        return shift.is_known && shift.value != 0;
    });
    return is_one ? Activity::Yes : Activity::No;
}

bool TextView::leads_tip() const {
    const Function length = modal.meant_of(Group::LengthComp);
    const Function transformation = modal.meant_of(Group::Transformation);
    const bool is_axes = transformation == Function::None || transformation == Function::TcpOff;
    return !is_axes || length == Function::TcpLength || length == Function::TcpVector;
}

/// Whether the group is written again before something moves. A compensation that acts is not: to
/// write it a second time is a command of its own on some controls.
bool TextView::is_restated(Group group) const {
    const Function meant = modal.meant[index_of(group)];
    if ((modal.doubtful & bit(group)) == 0 || meant == Function::None) return false;
    return has_code(meant) && (group != Group::RadiusComp || meant == Function::RadiusCompOff);
}

/// Whether the text has something else than is meant of a group on which a function of the block
/// depends: the plane of a rotation, the dimensions of data. It is no motion, so no code is
/// restored beside it.
bool TextView::is_depended_on(const Block& block, Group group) const {
    const Function meant = modal.meant[index_of(group)];
    if (meant == Function::None || meant == modal.text_of(group) || !has_code(meant)) return false;
    if (programmed_in(block, group) != Function::None) return false;
    return (group == Group::Plane && block.find(Fact::NeedsPlane) != nullptr) ||
           (group == Group::Distance && block.find(Fact::AddsIncrements) != nullptr);
}

std::array<std::size_t, 3> TextView::plane_axes() const {
    switch (modal.meant[static_cast<std::size_t>(Group::Plane)]) {
        case Function::PlaneZx: return {2, 0, 1};
        case Function::PlaneYz: return {1, 2, 0};
        default: return {0, 1, 2};
    }
}

/// Whether the axis word is a distance; not where nobody knows what it is.
bool TextView::is_distance(const Block& block, std::size_t axis) const {
    const SlotMask mask = bit(static_cast<Slot>(axis));
    if (((block.incremental | block.absolute) & mask) != 0) return (block.incremental & mask) != 0;
    return modal.meant[static_cast<std::size_t>(Group::Distance)] == Function::Incremental;
}

/// Whether the block can be written under incremental dimensions only: all its words are distances,
/// and the control has neither AC() and IC() nor letters of distances to write them from positions
/// that nobody knows.
bool TextView::needs_incremental(const Block& block) const {
    const SlotMask given = block.given & kTargetSlots;
    if (given == 0 || (block.incremental & given) != given) return false;
    if (tables.notation.has_modes || tables.has_incremental_letters) return false;
    const bool has_functions = block.function_count != 0;
    if (has_functions && block.find(Function::MachineCoordinates) != nullptr) return false;
    // On the motion to the reference point the control's own habit is a distance: G91 G28 Z0.
    const bool is_return = has_functions && block.find(Function::ReferenceReturn) != nullptr;
    return is_return || (modal.position.known & given) != given;
}

/// Whether the text tells, or the control knows, what X is.
bool TextView::knows_diameter() const { return modal.text_of(Group::Diameter) != Function::None; }

/// What a coordinate is multiplied with to be one of the part: X may be a diameter, a centre never.
double TextView::on_part(std::size_t axis) const {
    return axis == kX && modal.text_of(Group::Diameter) == Function::DiameterOn ? 0.5 : 1;
}

double TextView::end_increment() const {
    const std::array<std::size_t, 3> axes = plane_axes();
    const auto decimals_of = [&](std::size_t i) { return decimals(static_cast<Slot>(axes[i])); };
    return std::pow(10.0, -std::min(decimals_of(0), decimals_of(1)));
}

/// How far an axis goes in a block, frames included; none where nobody knows where it stands.
std::optional<double> TextView::meant_distance(const Block& block, const WrittenPosition& start,
                                               std::size_t axis) const {
    const bool is_increment = is_distance(block, axis);
    if (!is_increment && (start.known >> axis & 1u) == 0) return std::nullopt;
    const double distance =
        block.at(static_cast<Slot>(axis)) - (is_increment ? 0 : start.meant[axis]);
    return axis < modal.frame.factors.size() ? distance * on_part(axis) * modal.frame.factors[axis]
                                             : distance;
}

SlotMask TextView::unknown_ends(const Block& block, const WrittenPosition& start) const {
    SlotMask axes = block.given & kTargetSlots & ~start.known;
    for (std::size_t axis = 0; axis < kAxes; ++axis)
        if (is_distance(block, axis)) axes &= ~(SlotMask{1} << axis);
    return axes;
}

bool TextView::is_standing(Slot slot, double value, const NumberInForce& standing) const {
    return standing.is_known && standing.value == round_to(to_text(slot, value), decimals(slot));
}

const Form* TextView::kept_shift(AddressId address, double code) const {
    for (const FormId id : tables.forms_of[static_cast<std::size_t>(Function::Shift)]) {
        const Form& form = tables.forms[id];
        const FormWord& head = form.words[0];
        const bool is_code = head.kind == FormWord::Kind::Fixed && head.address == address;
        if (form.remembers && is_code && head.number == code) return &form;
    }
    return nullptr;
}

bool TextView::is_compensated() const {
    return has_fact(modal.text_of(Group::RadiusComp), Fact::CompSide);
}

bool TextView::has_feed_word(const Form& form) const {
    const auto is_feed = [&](const FormWord& word) {
        return word.kind == FormWord::Kind::Value &&
               tables.addresses[word.address].slot == static_cast<int>(Slot::Feed);
    };
    return std::ranges::any_of(form.words, is_feed) || std::ranges::any_of(form.lead, is_feed);
}

}  // namespace kadr::write
