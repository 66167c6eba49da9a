#include "nc/reading_modes.h"

namespace kadr::nc {

ReadingModes::ReadingModes(const DialectTables& tables) : tables_(tables) {
    modal_ = ModalFunctions{tables_.power_on};
    modal_[static_cast<std::size_t>(Group::Motion)] = Function::None;
    last_forms_.assign(tables_.groups.size(), kNoForm);
    const auto& threads = tables_.forms_of[static_cast<std::size_t>(Function::Thread)];
    feed_is_pitch_ = !threads.empty() && tables_.forms[threads[0]].feed_is_pitch;
    follow_units();
}

void ReadingModes::note_form(FormId id) {
    const Form& form = tables_.forms[id];
    if (info(form.function).group == Group::Units) feed_stays_metric_ = form.feed_stays_metric;
    if (info(form.function).group == Group::FeedMode) feed_is_time_ = form.feed_is_time;
    if (form.group >= 0) last_forms_[static_cast<std::size_t>(form.group)] = id;
    if (form.function == Function::Cycle && !form.is_preset)
        last_cycle_ = tables_.cycles[form.cycle].is_modal ? id : kNoForm;
}

void ReadingModes::begin_numbers(const Block& block) {
    follow(block);
    follow_units();
}

void ReadingModes::follow_line(const Block& block) {
    if (block.kind != Block::Kind::Nc) return;
    follow(block);
    if (block.skip_level < 0) return;
    // Nobody knows here whether the operator lets the block run.
    if (block.function_count != 0 && block.find(Function::WorkOffset) != nullptr)
        modal_.work_offset = -1;
    for (std::size_t i = 0; i < block.function_count; ++i) {
        const Group group = info(block.functions[i].function).group;
        const bool scales =
            group == Group::Units || group == Group::FeedMode || group == Group::SpeedMode;
        if (!scales) modal_[static_cast<std::size_t>(group)] = Function::None;
    }
}

void ReadingModes::follow_master(const Block& block) {
    const Invocation* const master = block.find(Function::MasterSpindle);
    if (master == nullptr) return;
    has_chosen_master_ = true;
    has_other_master_ =
        block.argument(*master, parameter_of<Function::MasterSpindle>("spindle"), 1) != 1;
}

void ReadingModes::restore(const ModalFunctions& wanted, Block& block) {
    for (std::size_t i = 1; i < kGroups; ++i) {
        const auto group = static_cast<Group>(i);
        if (wanted[i] == modal_[i] || wanted[i] == Function::None) continue;
        // The spindle and the coolant run on; offsets come back with the frames.
        const bool is_state = group == Group::Spindle || group == Group::Coolant ||
                              group == Group::WorkOffsets || group == Group::LengthComp ||
                              group == Group::CycleMode || group == Group::SpeedMode;
        if (is_state) continue;
        if (group == Group::Motion) {
            block.motion = wanted[i];
        } else {
            block.add(wanted[i]);
        }
    }
    begin_numbers(block);
}

void ReadingModes::follow_units() {
    units_.inch = active(Group::Units) == Function::Inch;
    units_.inch_feed = units_.inch && !feed_stays_metric_;
    units_.per_revolution = active(Group::FeedMode) == Function::FeedPerRevolution;
    units_.inverse_time = active(Group::FeedMode) == Function::FeedInverseTime;
    units_.cutting_speed = active(Group::SpeedMode) == Function::CuttingSpeedOn;
    for (std::size_t i = 0; i < slot_scales_.size(); ++i)
        slot_scales_[i] = text_scale(static_cast<Dimension>(i), units_, true);
}

}  // namespace kadr::nc
