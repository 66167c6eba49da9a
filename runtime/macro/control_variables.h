// control_variables.h — the variables of a program: its own, the control's, and those that show the
// state of the control.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "macro/control_access.h"
#include "macro/evaluator.h"
#include "macro/program.h"
#include "nc/line_reader.h"

namespace kadr::macro {

/// The variable of the level that was declared at this place among its single values; null: it is
/// one of the language.
const nc::Symbol* declared_at(const Level& level, std::uint32_t slot);

/// A value as who looks on is shown it.
ControlVariable shown(std::string name, const Value& value, std::string_view text);

class ControlVariables final : public Variables {
  public:
    /// Why a variable did not take a value; `row` is null if it did.
    struct Fault {
        const DiagnosticRow* row = nullptr;
        std::vector<std::string> arguments;
    };

    /// What a variable may hold by its definition.
    struct Limits {
        double least = -std::numeric_limits<double>::infinity();
        double most = std::numeric_limits<double>::infinity();
    };

    ControlVariables(const nc::Dialect& dialect, const nc::LineReader& reader);

    void follow(ControlAccess& state) { state_ = &state; }
    /// Who numbers the variables that the program names itself.
    nc::NameTable* names() const { return names_.get(); }
    void begin_batch() { in_step_ = true; }
    /// Whether everything that was given is executed.
    void set_in_step(bool in_step) { in_step_ = in_step; }
    /// Who is told that a value of the machine was read that nobody has given: its name, what it
    /// is. Each is told once, of an array its first element.
    void ask_missing(std::function<void(const std::string&, const std::string&)> tell) {
        tell_missing_ = std::move(tell);
    }
    /// Whether what is written next comes from the machine, which sets what programs cannot.
    void let_machine_write(bool is_machine) { is_machine_ = is_machine; }
    /// Who knows which modal call acts, and says its code.
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

    Answer family(std::uint32_t form, std::int64_t number, Value& out) override;
    std::string named(std::uint32_t form, std::int64_t number) const override;
    Answer input(std::uint32_t form, std::span<const std::int64_t> indices, Value& out,
                 std::string& text) override;
    Answer system(nc::Quantity quantity, std::int64_t first, std::int64_t second,
                  double& out) override;
    bool set_system(nc::Quantity quantity, std::int64_t first, std::int64_t second,
                    double value) override;
    Answer frame(nc::Quantity quantity, std::int64_t index, control::ControlFrame& out) override;
    Answer text(nc::Quantity quantity, std::int64_t index, std::string& out) override;
    double axis_unit(Axis axis) const override;
    std::optional<std::int64_t> axis_number(Axis axis) const override;
    bool has_name(std::string_view name) const override { return type_of(name).has_value(); }
    std::optional<nc::ValueType> type_of(std::string_view name) const override;
    bool find_program(std::string_view name) override;
    bool has_spindle(std::int64_t number) const override;
    std::string word_of(nc::Operation operation) const override;
    bool set_element(const nc::Symbol& symbol, std::uint32_t element, double value) override;
    /// A contour in mm gets the units of the text, and tells which those are.
    void say_units(ContourElements& contour) const;

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
    const nc::Symbol& declare(nc::Symbol symbol);
    /// What a variable that all programs have may hold.
    void limit(const std::string& name, const Limits& limits) { limits_[name] = limits; }
    /// The place of a variable, for a parameter that stands for it.
    struct VariableRef {
        Store* store = nullptr;  // null: it holds nothing that a program could write
        std::uint32_t slot = 0;
        nc::ValueType type = nc::ValueType::Real;
        const nc::Symbol* symbol = nullptr;  // if it was declared
    };
    VariableRef place_of(const nc::Instruction& load, std::span<const std::int64_t> indices);
    /// Sets an element from there on, of a variable that takes numbers.
    void set_number(const VariableRef& place, std::uint32_t element, double number);
    /// The parameter of `level` stands for a variable elsewhere; `symbol.slot` counts there.
    static void bind(Level& level, nc::Symbol symbol, Store& store);

    /// What the number of a family stands for; None: a variable that holds something.
    nc::Quantity quantity_of(std::uint32_t form, std::int64_t number) const;
    /// Whether writing it has to wait for the blocks before.
    bool must_wait(const nc::Instruction& target, std::span<const std::int64_t> indices) const;
    Fault store(const nc::Instruction& target, std::span<const std::int64_t> indices,
                const Value& value, const Content& content);
    Fault store_element(const nc::Symbol& symbol, std::uint32_t slot, const Value& value,
                        const Content& content);
    /// An argument by its letter: a variable of the language at this slot of `level`.
    void set_argument(Level& level, std::uint32_t slot, const Value& value);
    /// The variable of the whole run that this name means; false: there is none.
    bool set_global(std::string_view name, double value);
    /// The counter of a loop; false: it cannot be read.
    bool load(const nc::Instruction& from, std::span<const std::int64_t> indices, Value& out);

    std::vector<ControlVariable> list() const;
    /// Every variable that is set from now on is noted here; null: nobody wants to know.
    /// Returns who was told before.
    std::vector<VariableChange>* note_changes(std::vector<VariableChange>* changes) {
        return std::exchange(changes_, changes);
    }
    bool notes_changes() const { return changes_ != nullptr; }
    /// Without `before`: it had no value under this name.
    void note_change(std::optional<ControlVariable> before, ControlVariable after);
    ControlVariable shown_at(const VariableRef& place) const {
        return shown_in(*place.store, place.slot, place.symbol);
    }
    /// Whether it is no variable that holds something, but the control's own state.
    bool is_state(const nc::Instruction& target, std::span<const std::int64_t> indices) const;
    /// Variables of the language that show the data of an offset by number: those of the work
    /// offset, or those of the tool offset; each quantity once.
    std::vector<ControlVariable> shown_data(bool is_of_tool, std::int64_t number);
    ControlVariable shown_state(const nc::Instruction& target,
                                std::span<const std::int64_t> indices, std::string name);
    /// The code of a group of the dialect that acts: the one said last, if what it says still acts.
    const nc::Form* active_form(std::size_t group) const;

  private:
    struct Indices {
        std::int64_t first = 0;
        std::int64_t second = 0;
    };
    static Indices indices_of(const nc::VariableRange& range, std::int64_t number);
    Fault check_limits(const nc::Symbol& symbol, const Value& value) const;
    Fault store_family(std::uint32_t form, std::int64_t number, const Value& value);
    Fault store_system(nc::Quantity quantity, const Indices& indices, const Value& value);
    Fault store_frame(nc::Quantity quantity, std::int64_t number,
                      const control::ControlFrame& frame);
    Fault store_text(nc::Quantity quantity, std::int64_t index, const Value& value,
                     std::string_view text);  // control_texts.cpp
    static std::string written_text(const Value& value, std::string_view text);
    Fault store_part(const nc::Instruction& target, std::span<const std::int64_t> indices,
                     const Value& value);
    std::string written(const control::ControlFrame& frame) const;
    static Fault convert(nc::ValueType type, Value& value, std::string_view text);
    double to_text_units(nc::Quantity quantity, const Indices& indices, double value) const;
    double on_increment(double value, bool is_length) const;
    double text_factor(const Indices& indices, std::int64_t axis) const;
    std::optional<double> code_in_list(const nc::CodeList& list, std::size_t group) const;
    std::optional<double> modal_code(std::int64_t group, bool by_place) const;
    /// Sets a variable of a store by `set`, and notes it if somebody wants to know. `symbol`: that
    /// it is a part of; null: a variable of the language.
    template <typename Set>
    void change(Store& store, std::size_t slot, const nc::Symbol* symbol, Set set);
    ControlVariable shown_in(const Store& store, std::size_t slot, const nc::Symbol* symbol) const;
    std::string name_in(const Store& store, std::size_t slot) const;
    std::string name_of(const nc::VariableForm& form, std::int64_t number) const;
    // machine_values.cpp
    std::string input_name(std::uint32_t form, std::span<const std::int64_t> indices) const;
    Answer read_input(std::uint32_t form, const nc::VariableRange& range, const std::string& name,
                      Value& out, std::string& text);
    Answer read_bits(std::uint32_t form, const nc::VariableRange& range, std::int64_t number,
                     Value& out);
    Fault store_bits(std::uint32_t form, const nc::VariableRange& range, std::int64_t number,
                     const Value& value);
    Fault store_input(std::uint32_t form, const nc::VariableRange& range, const std::string& name,
                      const Value& value, std::string_view text);
    void list_inputs(std::uint32_t form, std::vector<ControlVariable>& out) const;
    void list_family(const nc::VariableForm& form, std::vector<ControlVariable>& out) const;

    const nc::Dialect& dialect_;
    const nc::DialectTables& tables_;
    const nc::Language& language_;
    const nc::LineReader& reader_;
    std::unique_ptr<nc::NameTable> names_ = std::make_unique<nc::NameTable>();
    ControlAccess* state_ = nullptr;
    Store globals_;
    Level main_;
    Level definitions_;
    std::map<std::string, Limits, std::less<>> limits_;  // of some of its variables
    Level* level_ = &main_;
    std::int64_t block_number_ = 0;
    /// A value of the machine, and the form that reads it.
    struct MachineValue {
        Value value;
        std::string text;
        std::uint32_t form = 0;
    };
    std::map<std::string, MachineValue, std::less<>> machine_values_;  // by their whole names
    std::set<std::string, std::less<>> told_missing_;
    std::function<void(const std::string&, const std::string&)> tell_missing_;
    bool is_machine_ = false;
    std::function<double()> modal_call_;
    std::function<std::optional<std::string>(std::int64_t)> name_at_;
    std::function<bool(std::string_view)> is_program_;
    std::size_t program_level_ = 0;
    bool in_step_ = true;
    std::vector<VariableChange>* changes_ = nullptr;
};

}  // namespace kadr::macro
