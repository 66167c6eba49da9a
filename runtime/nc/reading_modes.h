// reading_modes.h — what the lines before leave for those behind them: the modal functions that are
// in force, the units of numbers, and which form was used last.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nc/modal_functions.h"
#include "nc/number_text.h"
#include "nc/tables.h"

namespace kadr::nc {

class ReadingModes {
  public:
    /// As the control powers on, without a motion.
    ///
    /// tables  outlive it
    explicit ReadingModes(const DialectTables& tables);

    const ModalFunctions& modal() const { return modal_; }
    Function active(Group group) const { return modal_[static_cast<std::size_t>(group)]; }
    const TextUnits& units() const { return units_; }
    /// number in the text = value of a slot · this
    double slot_scale(Dimension dimension) const {
        return slot_scales_[static_cast<std::size_t>(dimension)];
    }
    /// Whether F is the time of a block, s: the control reads it so, and inverse time acts.
    bool is_feed_time() const { return feed_is_time_ && units_.inverse_time; }
    /// Whether it would be under inverse time.
    bool may_be_feed_time() const { return feed_is_time_; }
    /// Whether F of threads is their pitch, with the digits of a pitch.
    bool is_feed_pitch() const { return feed_is_pitch_; }
    /// The form that was used for a group of the dialect last; kNoForm.
    FormId last_form(std::size_t group) const { return last_forms_[group]; }
    /// The form that called a cycle last; kNoForm.
    FormId last_cycle() const { return last_cycle_; }
    /// The number of the last M function; 0: none was programmed.
    double machine_code() const { return machine_code_; }
    /// Whether the program has chosen a master spindle, and whether that is not the first one.
    bool has_chosen_master() const { return has_chosen_master_; }
    bool has_other_master() const { return has_other_master_; }

    void note_machine_code(double code) { machine_code_ = code; }
    /// A form of the line that is read.
    void note_form(FormId id);
    /// What the block leaves of the modal functions.
    void follow(const Block& block) { follow_modal(tables_.rules, block, modal_); }
    /// The same for numbers of this block already: its own changes of units act in it.
    void begin_numbers(const Block& block);
    /// The same of a whole line: where the operator may skip it, nobody knows what is left.
    void follow_line(const Block& block);
    /// The master spindle, if the block chooses one.
    void follow_master(const Block& block);
    /// The numbers of the block that began were wrong: its functions have no effect.
    void go_back(const ModalFunctions& before) { modal_ = before; }
    /// Goes back to modal functions of before: adds to the block what restores them, as if words
    /// had programmed it, and follows it.
    void restore(const ModalFunctions& wanted, Block& block);

  private:
    void follow_units();

    const DialectTables& tables_;
    ModalFunctions modal_{};
    TextUnits units_;
    std::array<double, static_cast<std::size_t>(Dimension::Text) + 1> slot_scales_{};
    bool feed_stays_metric_ = false;
    bool feed_is_time_ = false;
    bool feed_is_pitch_ = false;
    std::vector<FormId> last_forms_;  // of each group of the dialect
    FormId last_cycle_ = kNoForm;
    double machine_code_ = 0;
    bool has_chosen_master_ = false;
    bool has_other_master_ = false;
};

}  // namespace kadr::nc
