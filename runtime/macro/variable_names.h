// variable_names.h — how programs write their variables, for lists, for messages and for who looks
// on.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "macro/control_value.h"
#include "macro/program.h"
#include "nc/language.h"

namespace kadr::macro {

/// A value as who looks on is shown it.
ControlVariable shown(std::string name, const ControlValue& value, std::string_view text);

class VariableNames {
  public:
    /// language  outlives it
    explicit VariableNames(const nc::Language& language) : language_(language) {}

    /// Numbers the names that stand for variables of open forms: who reads lines adds to them.
    nc::NameTable* numbers() const { return numbers_.get(); }

    /// A variable of the form by its number: `R1`, `#100`.
    std::string in_family(const nc::VariableForm& form, std::int64_t number) const;
    /// … with what it is: "`#1004` (inputs)".
    std::string with_meaning(const nc::VariableForm& form, std::int64_t number) const;
    /// A value of the machine by the number of its name and its indices; an axis by the name of
    /// that axis.
    std::string of_machine_value(std::span<const std::int64_t> indices) const;
    /// The variable of the language at this slot, of those of the whole run or of those of a level.
    /// Empty: there is none.
    std::string at_slot(nc::VariableRange::Kind kind, std::size_t slot) const;
    /// An element of a variable that the program has declared, or that variable if it is no array.
    std::string of_element(const nc::ControlSymbol& symbol, std::uint32_t element) const;

    /// How the control writes an operation.
    std::string of_operation(nc::Operation operation) const;
    /// A frame by its constants, as a program would write it: `CTRANS(X,10):CROT(Z,30)`.
    std::string written(const control::ControlFrame& frame) const;

  private:
    const nc::Language& language_;
    std::unique_ptr<nc::NameTable> numbers_ = std::make_unique<nc::NameTable>();
};

}  // namespace kadr::macro
