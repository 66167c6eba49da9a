// machine_values.h — named values that the machine gives a program, or that a program writes for
// it: inputs, data of its PLC, machine data.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "macro/control_value.h"
#include "macro/program.h"
#include "nc/language.h"

namespace kadr::macro {

/// Each has the whole name by which a program reads it: `$A_IN[3]`.
class MachineValues {
  public:
    struct Entry {
        ControlValue value;
        std::string text;        // if the value is one
        std::uint32_t form = 0;  // of variables, that reads it
    };
    /// Takes the name of a value that nobody has given, and what it is.
    using MissingListener = std::function<void(const std::string&, const std::string&)>;

    /// language  outlives them
    explicit MachineValues(const nc::Language& language) : language_(language) {}

    /// Who is notified that a value was read that nobody has given. Each is reported once, of an
    /// array its first element. Returns who was notified before.
    MissingListener report_missing_to(MissingListener listener) {
        return std::exchange(missing_listener_, std::move(listener));
    }
    /// Whether what is written next comes from the machine, which sets what programs cannot.
    void let_machine_write(bool is_machine) { is_machine_ = is_machine; }
    bool is_machine_writing() const { return is_machine_; }

    /// Null: nobody has given it. Valid until the next set().
    const Entry* find(const std::string& name) const {
        const auto found = values_.find(name);
        return found == values_.end() ? nullptr : &found->second;
    }
    void set(const std::string& name, Entry entry) {
        values_.insert_or_assign(name, std::move(entry));
    }
    /// The value, and its text if it is one; 0 where nobody has given it, and that is reported.
    void read(const nc::VariableRange& range, const std::string& name, ControlValue& out,
              std::string& text);
    /// Those of a form that programs write, too: what only the machine gives is known without the
    /// program.
    void list(std::uint32_t form, std::vector<ControlVariable>& out) const;

  private:
    const nc::Language& language_;
    std::map<std::string, Entry, std::less<>> values_;     // by their whole names
    std::set<std::string, std::less<>> reported_missing_;  // without their indices
    MissingListener missing_listener_;
    bool is_machine_ = false;
};

}  // namespace kadr::macro
