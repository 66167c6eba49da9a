#include "write/modal.h"

namespace kadr::write {

namespace {

void keep(NumberInForce& mine, const NumberInForce& other) {
    mine.is_known = mine.is_known && other.is_known && mine.value == other.value;
}

}  // namespace

void WrittenPosition::join(const WrittenPosition& other) {
    written |= other.written;
    reframed |= other.reframed;
    known &= other.known;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const bool is_same = text[i] == other.text[i] && meant[i] == other.meant[i];
        if (!is_same) known &= static_cast<SlotMask>(~(SlotMask{1} << i));
    }
}

/// Not `turn` and `tilt`: they are misses of the text's own words.
void TextFrame::join(const TextFrame& other) {
    for (std::size_t i = 0; i < shift.size(); ++i) {
        keep(shift[i], other.shift[i]);
        keep(origin[i], other.origin[i]);
    }
    turned |= other.turned;
    is_refused |= other.is_refused;
    if (rotation != other.rotation) rotation = Activity::Unknown;
    if (mirror != other.mirror) mirror = Activity::Unknown;
    if (scale != other.scale) scale = Activity::Unknown;
    if (tilted != other.tilted) tilted = Activity::Unknown;
    if (factors != other.factors) factors = {1, 1, 1};
}

void TextFrame::forget() {
    rotation = mirror = scale = tilted = Activity::Unknown;
    factors = {1, 1, 1};
    turned = kTargetSlots;
    for (NumberInForce& s : shift) s.is_known = false;
    for (NumberInForce& s : origin) s.is_known = false;
}

void WriterModal::join(const WriterModal& other) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == other.text[i]) continue;
        text[i] = Function::None;
        doubtful |= bit(static_cast<Group>(i)) & kRestated;
    }
    if (text.work_offset != other.text.work_offset) text.work_offset = -1;
    doubtful |= other.doubtful;
    keep(feed, other.feed);
    keep(speed, other.speed);
    feed_is_other |= other.feed_is_other;
    keep(tool, other.tool);
    keep(work_offset, other.work_offset);
    // Of edges only this: they and units stand in no block that may be left out, and an edge that
    // such a block puts aside is written again either way.
    keep(edge.number, other.edge.number);
    frame.join(other.frame);
    position.join(other.position);
}

void WriterModal::forget() {
    meant.fill(Function::None);
    text.fill(Function::None);
    text.work_offset = -1;
    doubtful = 0;
    feed.is_known = speed.is_known = has_meant_feed = has_meant_speed = false;
    edge.is_lost = edge.is_lost || (edge.number.is_known && edge.number.value != 0);
    tool.is_known = edge.number.is_known = work_offset.is_known = false;
    edge.waiting = 0;
    position.forget();
    frame.forget();
}

}  // namespace kadr::write
