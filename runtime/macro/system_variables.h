// system_variables.h — system variables of a control: its state as programs read and set it, in the
// units of the text.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "macro/active_codes.h"
#include "macro/control_access.h"
#include "macro/evaluator.h"
#include "macro/value_types.h"
#include "nc/line_reader.h"

namespace kadr::macro {

/// What the name of a system variable leaves open: the number of an offset, an axis …
struct QuantityIndices {
    std::int64_t first = 0;
    std::int64_t second = 0;
};

/// Those of a number in a range of variables: `#2601` is the first axis of the second offset.
QuantityIndices indices_of(const nc::VariableRange& range, std::int64_t number);

class SystemVariables {
  public:
    using Answer = Variables::Answer;

    /// References outlive it.
    SystemVariables(const nc::Dialect& dialect, const nc::LineReader& reader)
        : tables_(dialect.tables()),
          language_(tables_.language),
          reader_(reader),
          codes_(dialect, reader.modes()) {}

    /// Whose state it is. Without a control what it would know is not supported.
    void follow(ControlAccess& state) { state_ = &state; }
    /// Whether everything that was given is executed. If not, what the control knows is `Later`.
    void set_in_step(bool in_step) { in_step_ = in_step; }
    bool is_in_step() const { return in_step_; }
    /// Who knows which modal call acts, and gives its code.
    void ask_modal_call(std::function<double()> ask) { modal_call_ = std::move(ask); }
    /// Who knows the programs: the name of the one at a level of calls, or nothing, and whether
    /// there is one with a name.
    void ask_programs(std::function<std::optional<std::string>(std::int64_t)> name_at,
                      std::function<bool(std::string_view)> is_there) {
        name_at_ = std::move(name_at);
        is_program_ = std::move(is_there);
    }
    void set_block_number(std::int64_t number) { block_number_ = number; }
    void set_program_level(std::size_t level) { program_level_ = level; }
    const ActiveCodes& codes() const { return codes_; }

    /// A system variable that is a number. `Missing`: it does not exist for these indices.
    /// `Compensated`: it is a position, and the tool stands beside the programmed contour.
    Answer number(nc::SystemQuantity quantity, std::int64_t first, std::int64_t second,
                  double& out);
    /// One that is a frame; lengths in mm.
    Answer frame(nc::SystemQuantity quantity, std::int64_t index, control::ControlFrame& out);
    /// One that is a text.
    Answer text(nc::SystemQuantity quantity, std::int64_t index, std::string& out);
    /// mm, or degrees, that 1 in a word of the axis is.
    double axis_unit(Axis axis) const;
    /// Which of the machine's axes it is, counted from 1; nothing: the machine has none such.
    std::optional<std::int64_t> axis_number(Axis axis) const;
    /// Whether the machine has a spindle with this number; 0 is the master.
    bool has_spindle(std::int64_t number) const;
    /// Whether a program has this name.
    bool has_program(std::string_view name) const { return is_program_ && is_program_(name); }
    /// A contour in mm gets the units of the text, and returns which those are.
    void put_units(ContourElements& contour) const;

    /// Sets a system variable that has no unit; false: there is no such variable.
    bool set_whole_number(nc::SystemQuantity quantity, std::int64_t first, std::int64_t second,
                          double value);
    /// Sets a number by a value in the units of the text.
    VariableFault set_number(nc::SystemQuantity quantity, const QuantityIndices& indices,
                             const ControlValue& value);
    VariableFault set_frame(nc::SystemQuantity quantity, std::int64_t number,
                            const control::ControlFrame& frame);
    /// value  what it becomes, which is this text if it is one
    VariableFault set_text(nc::SystemQuantity quantity, std::int64_t index,
                           const ControlValue& value, std::string_view text);

  private:
    double to_text_units(nc::SystemQuantity quantity, const QuantityIndices& indices,
                         double value) const;
    double on_increment(double value, bool is_length) const;
    double text_factor(std::int64_t axis) const;

    const nc::DialectTables& tables_;
    const nc::Language& language_;
    const nc::LineReader& reader_;
    ActiveCodes codes_;
    ControlAccess* state_ = nullptr;
    bool in_step_ = true;
    std::int64_t block_number_ = 0;
    std::size_t program_level_ = 0;
    std::function<double()> modal_call_;
    std::function<std::optional<std::string>(std::int64_t)> name_at_;
    std::function<bool(std::string_view)> is_program_;
};

}  // namespace kadr::macro
