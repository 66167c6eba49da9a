// text_view.h — what follows from a text so far: what a word would mean in it, and with which
// number it would stand there.
//
// Asks only: nothing here changes the text or reports.
#pragma once

#include <optional>

#include "write/modal.h"

namespace kadr::write {

struct TextView {
    const DialectTables& tables;
    const WriterModal& modal;
    const FeedWord& feed_word;

    // Addresses
    bool has_address(Slot slot) const {
        return tables.slot_address[static_cast<std::size_t>(slot)] != kNoAddress;
    }
    /// The address that writes the slot. Of a slot without one, what calculations need to go on:
    /// the word itself is never written (`append_slot`).
    const Address& address_of(Slot slot) const;
    double to_text(Slot slot, double value) const;
    int decimals(Slot slot) const;

    // Functions
    bool has_code(Function function) const {
        return !tables.forms_of[static_cast<std::size_t>(function)].empty();
    }
    /// The motion of the block: its own, or the modal one; of a probing block always a line.
    Function effective_motion(const Block& block) const {
        if (block.function_count != 0 && block.find(Function::Probe) != nullptr)
            return Function::Line;
        return block.motion != Function::None ? block.motion : modal.meant[index_of(Group::Motion)];
    }
    bool is_compensated() const;
    /// Whether F is the speed of the tip, whatever the axes do.
    bool leads_tip() const;
    /// Whether the function acts in the text so far.
    Activity activity_of(Function function) const;
    Activity is_shifted() const;
    bool is_restated(Group group) const;
    bool is_depended_on(const Block& block, Group group) const;

    // Positions
    /// First, second and third axis of the working plane.
    std::array<std::size_t, 3> plane_axes() const;
    bool is_known(std::size_t axis) const { return (modal.position.known >> axis & 1u) != 0; }
    /// Known, and from a word of the text.
    bool is_named(std::size_t axis) const {
        return is_known(axis) && (modal.position.written >> axis & 1u) == 0;
    }
    bool is_distance(const Block& block, std::size_t axis) const;
    bool needs_incremental(const Block& block) const;
    bool knows_diameter() const;
    double on_part(std::size_t axis) const;
    /// The increment of start and end of an arc, in the text's units: the coarser one of the
    /// plane's axes.
    double end_increment() const;
    std::optional<double> meant_distance(const Block& block, const WrittenPosition& start,
                                         std::size_t axis) const;

    /// Axes that the block brings to coordinates from where nobody knows.
    SlotMask unknown_ends(const Block& block, const WrittenPosition& start) const;

    /// Whether the number that would be written is in force already.
    bool is_standing(Slot slot, double value, const NumberInForce& standing) const;
    /// Whether a word of the form is F: the pitch of a cycle, mostly.
    bool has_feed_word(const Form& form) const;
    /// The form of a shift that stays, if a line with this code is one.
    const Form* kept_shift(AddressId address, double code) const;
};

}  // namespace kadr::write
