// center_words.h — which letter of a centre stands for which axis, where the control counts the
// axes of the plane (rule center_by_plane).
#pragma once

#include <array>

#include "nc/block.h"

namespace kadr::nc {

/// The slot that a word of a centre sets beside an arc in this plane: I that of the plane's first
/// axis, J that of its second, K that of the axis across it. Another slot is returned as it is.
constexpr Slot center_slot_of_word(Slot word, Function plane) {
    constexpr auto kFirst = static_cast<std::size_t>(Slot::CenterX);
    if ((bit(word) & kCenterSlots) == 0) return word;
    const std::size_t turned = plane == Function::PlaneZx ? 2 : plane == Function::PlaneYz ? 1 : 0;
    return static_cast<Slot>(kFirst + (static_cast<std::size_t>(word) - kFirst + turned) % 3);
}

/// The word that says this slot there.
constexpr Slot center_word_of_slot(Slot slot, Function plane) {
    if ((bit(slot) & kCenterSlots) == 0) return slot;
    Slot word = Slot::CenterX;
    for (const Slot each : {Slot::CenterX, Slot::CenterY, Slot::CenterZ})
        if (center_slot_of_word(each, plane) == slot) word = each;
    return word;
}

}  // namespace kadr::nc
