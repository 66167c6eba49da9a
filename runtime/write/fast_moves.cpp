#include "write/fast_moves.h"

#include <array>
#include <cmath>

#include "base/numbers.h"
#include "base/powers.h"

namespace kadr::write {

FastPlan fast_plan(const TextView& text) {
    const DialectTables& tables = text.tables;
    FastPlan plan;
    for (const Function motion : {Function::Rapid, Function::Line}) {
        const auto& forms = tables.forms_of[static_cast<std::size_t>(motion)];
        if (forms.empty()) continue;
        const Form& form = tables.forms[forms[0]];
        const bool is_code = form.function == motion && form.sets.empty() &&
                             form.words.size() == 1 &&
                             form.words[0].kind == FormWord::Kind::Fixed && form.extra.empty();
        if (is_code) (motion == Function::Rapid ? plan.rapid : plan.line) = form.words[0].text;
    }
    for (const Slot slot : tables.slot_order) {
        if ((bit(slot) & kTargetSlots) == 0) continue;
        const Address& address = text.address_of(slot);
        const NumberFormat& format = address.format;
        // A missing point must not change the meaning, and minus must be allowed.
        const bool has_increments = format.increment > 0 || format.inch_increment > 0;
        const bool is_usual = address.name.size() == 1 && format.point != PointRule::Never &&
                              format.allows_minus && !format.writes_plus &&
                              (format.point == PointRule::Always || !has_increments);
        if (!is_usual) continue;
        FastAxis axis;
        axis.slot = slot;
        axis.letter = address.name[0];
        axis.is_length = address.dimension == Dimension::Length;
        axis.has_point = format.point == PointRule::Always;
        axis.decimals = {format.decimals, axis.is_length ? format.inch_decimals : format.decimals};
        axis.most = most_increments(format);
        plan.axes.push_back(axis);
        plan.slots |= bit(slot);
    }
    return plan;
}

bool FastMoves::is_fast(const Block& block) const {
    if (block.kind != Block::Kind::Nc || block.function_count != 0 || block.skip_level >= 0 ||
        block.number >= 0)
        return false;
    const SlotMask targets = block.given & kTargetSlots;
    if (targets == 0 || (block.given & ~(plan_.slots | bit(Slot::Feed))) != 0) return false;
    if (((block.incremental | block.absolute) & block.given) != 0) return false;
    if (!block.comment.empty() || !state_.pending().empty() || modal_.edge.waiting != 0 ||
        modal_.edge.is_length_due || modal_.edge.is_end_due || modal_.units.inverse_time ||
        modal_.feed_is_other || modal_.doubtful != 0 || modal_.frame.turn.miss > 0 ||
        modal_.frame.tilt.miss > 0)
        return false;
    const Function motion = text_.effective_motion(block);
    if (motion != Function::Rapid && motion != Function::Line) return false;
    const bool moves_others = (targets & ~SlotMask{kLinearXYZ}) != 0;
    if (moves_others && block.feed_of_all_axes != tables_.rules.feed_of_all_axes &&
        motion == Function::Line)
        return false;
    if (repeats_ && plan_.code(motion).empty()) return false;
    const auto distance = static_cast<std::size_t>(Group::Distance);
    const auto feed_mode = static_cast<std::size_t>(Group::FeedMode);
    if (block.has(Slot::Feed) && modal_.text[feed_mode] != modal_.meant[feed_mode]) return false;
    return modal_.text[static_cast<std::size_t>(Group::Motion)] == motion &&
           (modal_.text[distance] == Function::Absolute || tables_.has_incremental_letters) &&
           modal_.meant[distance] == Function::Absolute;
}

bool FastMoves::write(const Block& block, std::string& out) {
    if (!is_fast(block)) return false;
    struct Word {
        const FastAxis* axis;
        std::uint64_t scaled;
        bool is_minus;
        int decimals;
    };
    std::array<Word, kAxes> words;
    std::array<TextState::Arrival, kAxes> arrivals;
    std::size_t count = 0;
    SlotMask changed = 0;
    const std::size_t system = modal_.units.inch ? 1 : 0;
    const double of_lengths = text_scale(Dimension::Length, modal_.units, true);
    for (const FastAxis& axis : plan_.axes) {
        if (!block.has(axis.slot)) continue;
        const int decimals = axis.decimals[system];
        const double scale = axis.is_length ? of_lengths : 1;
        const double number = block.at(axis.slot) * scale;
        std::uint64_t scaled = 0;
        if (!scaled_magnitude(number, decimals, scaled) || scaled > axis.most) return false;
        const bool is_minus = number < 0 && scaled != 0;
        const double rounded =
            static_cast<double>(scaled) / kPowersOfTen[static_cast<std::size_t>(decimals)];
        const double text = (is_minus ? -rounded : rounded) / scale;
        const auto index = static_cast<std::size_t>(axis.slot);
        const bool is_same = !repeats_ && text_.is_named(index) &&
                             std::fabs(text - modal_.position.text[index]) < kSame;
        if (!is_same) changed |= bit(axis.slot);
        arrivals[count] = {index, text};
        words[count++] = {&axis, scaled, is_minus, decimals};
    }
    state_.arrive(block, text_.effective_motion(block), std::span(arrivals).first(count));
    lines_.open(-1, true, out);
    if (repeats_ && block.motion != Function::None) {
        blank(out);
        out += plan_.code(block.motion);
    }
    std::array<char, 32 * kAxes> line;
    char* end = line.data();
    for (std::size_t i = 0; i < count; ++i) {
        const Word& word = words[i];
        if (changed != 0 && (changed & bit(word.axis->slot)) == 0) continue;
        if (end != line.data() || out.size() != lines_.start()) *end++ = ' ';
        *end++ = word.axis->letter;
        end =
            nc::write_scaled(end, word.scaled, word.is_minus, word.decimals, word.axis->has_point);
    }
    out.append(line.data(), end);
    if (block.has(Slot::Feed) &&
        (repeats_ || !text_.is_standing(Slot::Feed, block.at(Slot::Feed), modal_.feed))) {
        words_.append_slot(block, Slot::Feed, {}, out);
    }
    lines_.end_block(out);
    lines_.close(out);
    return true;
}

}  // namespace kadr::write
