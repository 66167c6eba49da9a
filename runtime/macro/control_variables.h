// control_variables.h — the variables of a program: its own, the control's, and those that show the
// state of the control.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "macro/evaluator.h"
#include "macro/machine_values.h"
#include "macro/program.h"
#include "macro/system_variables.h"
#include "macro/value_types.h"
#include "macro/variable_names.h"
#include "nc/line_reader.h"

namespace kadr::macro {

/// The variable of the level that was declared at this index among its single values; null: it is
/// one of the language.
const nc::ControlSymbol* declared_at(const Level& level, std::uint32_t slot);

class ControlVariables final : public Variables {
  public:
    /// What a variable may hold by its definition.
    struct Limits {
        double least = -std::numeric_limits<double>::infinity();
        double most = std::numeric_limits<double>::infinity();
    };

    ControlVariables(const nc::Dialect& dialect, const nc::LineReader& reader);

    const VariableNames& names() const { return names_; }
    SystemVariables& system_variables() { return system_variables_; }
    MachineValues& machine_values() { return machine_values_; }

    Answer family(std::uint32_t form, std::int64_t number, ControlValue& out) override;
    std::string named(std::uint32_t form, std::int64_t number) const override;
    Answer input(std::uint32_t form, std::span<const std::int64_t> indices, ControlValue& out,
                 std::string& text) override;
    Answer system(nc::SystemQuantity quantity, std::int64_t first, std::int64_t second,
                  double& out) override;
    bool set_system(nc::SystemQuantity quantity, std::int64_t first, std::int64_t second,
                    double value) override {
        return system_variables_.set_whole_number(quantity, first, second, value);
    }
    Answer frame(nc::SystemQuantity quantity, std::int64_t index,
                 control::ControlFrame& out) override {
        return system_variables_.frame(quantity, index, out);
    }
    Answer text(nc::SystemQuantity quantity, std::int64_t index, std::string& out) override {
        return system_variables_.text(quantity, index, out);
    }
    double axis_unit(Axis axis) const override { return system_variables_.axis_unit(axis); }
    std::optional<std::int64_t> axis_number(Axis axis) const override {
        return system_variables_.axis_number(axis);
    }
    bool has_name(std::string_view name) const override { return type_of(name).has_value(); }
    std::optional<nc::ValueType> type_of(std::string_view name) const override;
    bool find_program(std::string_view name) override {
        return system_variables_.has_program(name);
    }
    bool has_spindle(std::int64_t number) const override {
        return system_variables_.has_spindle(number);
    }
    std::string word_of(nc::Operation operation) const override;
    bool set_element(const nc::ControlSymbol& symbol, std::uint32_t element, double value) override;

    const Store& globals() const { return globals_; }
    Level& level() { return *level_; }
    Level& main_level() { return main_; }
    /// What is declared in it, all levels made from now on have.
    Level& definitions() { return definitions_; }
    /// The level has the variables of the definitions; before anything is declared in it.
    void share_definitions(Level& level);
    /// A level with the variables of the language, none of them set.
    std::unique_ptr<Level> new_level();
    /// What follows reads and writes the variables of this level.
    void enter(Level& level) { level_ = &level; }
    const nc::ControlSymbol& declare(nc::ControlSymbol symbol);
    /// What a variable that all programs have may hold.
    void limit(const std::string& name, const Limits& limits) { limits_[name] = limits; }
    /// The location of a variable, for a parameter that stands for it.
    struct VariableRef {
        Store* store = nullptr;  // null: it holds nothing that a program could write
        std::uint32_t slot = 0;
        nc::ValueType type = nc::ValueType::Real;
        const nc::ControlSymbol* symbol = nullptr;  // if it was declared
    };
    VariableRef variable_of(const nc::ControlInstruction& load,
                            std::span<const std::int64_t> indices);
    /// Sets an element from there on, of a variable that takes numbers.
    void set_number(const VariableRef& variable, std::uint32_t element, double number);
    /// The parameter of `level` stands for a variable elsewhere; `symbol.slot` counts there.
    static void bind(Level& level, nc::ControlSymbol symbol, Store& store);

    /// What the number of a family stands for; None: a variable that holds something.
    nc::SystemQuantity quantity_of(std::uint32_t form, std::int64_t number) const;
    /// Whether writing it has to wait for the blocks before.
    bool must_wait(const nc::ControlInstruction& target,
                   std::span<const std::int64_t> indices) const;
    VariableFault store(const nc::ControlInstruction& target, std::span<const std::int64_t> indices,
                        const ControlValue& value, const Content& content);
    VariableFault store_element(const nc::ControlSymbol& symbol, std::uint32_t slot,
                                const ControlValue& value, const Content& content);
    /// An argument by its letter: a variable of the language at this slot of `level`.
    void set_argument(Level& level, std::uint32_t slot, const ControlValue& value);
    /// The variable of the whole run that this name means; false: there is none.
    bool set_global(std::string_view name, double value);
    /// The counter of a loop; false: it cannot be read.
    bool load(const nc::ControlInstruction& from, std::span<const std::int64_t> indices,
              ControlValue& out);

    std::vector<ControlVariable> list() const;
    /// Those of one owner, as a program of this level sees them.
    std::vector<ControlVariable> list(const Level& level, VariableOwner owner) const;
    /// Every variable that is set from now on is noted here; null: nobody wants to know.
    /// Returns who was notified before.
    std::vector<VariableChange>* note_changes(std::vector<VariableChange>* changes) {
        return std::exchange(changes_, changes);
    }
    bool notes_changes() const { return changes_ != nullptr; }
    /// Without `before`: it had no value under this name.
    void note_change(std::optional<ControlVariable> before, ControlVariable after);
    ControlVariable shown_at(const VariableRef& variable) const {
        return shown_in(*variable.store, variable.slot, variable.symbol);
    }
    /// Whether it is no variable that holds something, but the control's own state.
    bool is_state(const nc::ControlInstruction& target,
                  std::span<const std::int64_t> indices) const;
    /// Variables of the language that show the data of an offset by number: those of the work
    /// offset, or those of the tool offset; each variable once.
    std::vector<ControlVariable> shown_data(bool is_of_tool, std::int64_t number);
    ControlVariable shown_state(const nc::ControlInstruction& target,
                                std::span<const std::int64_t> indices, std::string name);

  private:
    VariableFault check_limits(const nc::ControlSymbol& symbol, const ControlValue& value) const;
    VariableFault store_family(std::uint32_t form, std::int64_t number, const ControlValue& value);
    VariableFault store_part(const nc::ControlInstruction& target,
                             std::span<const std::int64_t> indices, const ControlValue& value);
    /// Sets a variable of a store by `set`, and notes it if somebody wants to know. `symbol`: that
    /// it is a part of; null: a variable of the language.
    template <typename Set>
    void change(Store& store, std::size_t slot, const nc::ControlSymbol* symbol, Set set);
    ControlVariable shown_in(const Store& store, std::size_t slot,
                             const nc::ControlSymbol* symbol) const;
    // input_variables.cpp
    Answer read_bits(std::uint32_t form, const nc::VariableRange& range, std::int64_t number,
                     ControlValue& out);
    VariableFault store_bits(std::uint32_t form, const nc::VariableRange& range,
                             std::int64_t number, const ControlValue& value);
    VariableFault store_input(std::uint32_t form, const nc::VariableRange& range,
                              const std::string& name, const ControlValue& value,
                              std::string_view text);
    void list_range(const nc::VariableForm& form, const nc::VariableRange& range,
                    const Store& store, std::vector<ControlVariable>& out) const;
    void list_declared(const Level& level, const nc::ControlSymbol& symbol,
                       std::vector<ControlVariable>& out) const;
    /// The store of a range of variables that hold something; null: they are no such ones.
    const Store* store_of(const nc::VariableRange& range, const Level& level) const;

    const nc::DialectTables& tables_;
    const nc::Language& language_;
    VariableNames names_;
    SystemVariables system_variables_;
    MachineValues machine_values_;
    Store globals_;
    Level main_;
    Level definitions_;
    std::map<std::string, Limits, std::less<>> limits_;  // of some of its variables
    Level* level_ = &main_;
    std::vector<VariableChange>* changes_ = nullptr;
};

}  // namespace kadr::macro
