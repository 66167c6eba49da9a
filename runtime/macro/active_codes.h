// active_codes.h — the code that acts of each modal group, as variables and traces show it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "nc/dialect.h"
#include "nc/reading_modes.h"

namespace kadr::macro {

/// Groups are those of the dialect, by their indices in its tables, or by the numbers that the
/// control gives them.
class ActiveCodes {
  public:
    /// References outlive it.
    ActiveCodes(const nc::Dialect& dialect, const nc::ReadingModes& modes)
        : dialect_(dialect), tables_(dialect.tables()), modes_(modes) {}

    /// The form of the code that acts: the one programmed last, if it is still in force;
    /// null: none.
    const nc::Form* form(std::size_t group) const;
    /// The number of the code that acts of the group with this number: 2 for `G02`. Nothing: there
    /// is no such group, or no code of it acts.
    std::optional<double> number(std::int64_t group_number) const;
    /// The index of that code in the list of the group, from 1 on, 0 if none acts; nothing: the
    /// group has no list.
    std::optional<std::int64_t> place(std::int64_t group_number) const;
    /// The same in the list of this group.
    std::int64_t place_in(const nc::GroupCodes& list, std::size_t group) const;

  private:
    std::optional<std::size_t> group_of(std::int64_t group_number) const;

    const nc::Dialect& dialect_;
    const nc::DialectTables& tables_;
    const nc::ReadingModes& modes_;
};

}  // namespace kadr::macro
