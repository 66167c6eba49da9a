// tool_names.h — tools by their names: as the machine's table has them and as the program has
// written them since, and tools of which the program gives nothing but a name.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "machine/machine.h"

namespace kadr::interp {

class ToolNames {
  public:
    explicit ToolNames(const machine::Machine& machine);

    /// The tools with this name, the lowest number first. Sister tools share one.
    std::vector<std::int64_t> numbers(std::string_view name) const;
    /// The name of a tool; its number, as a new tool is named, if nobody has given it one.
    /// source  SINUMERIK reference 5.1 ($TC_TP2)
    std::string of(std::int64_t number) const;
    void set(std::int64_t number, std::string_view name);
    /// A number inside the control for a tool of which the name alone is known: the next one
    /// behind those of the table, of the named tools and of `last`.
    std::int64_t invent(std::string_view name, std::int64_t last);

  private:
    std::map<std::int64_t, std::string> names_;
    std::map<std::int64_t, std::string> invented_;  // that no table has, and no program has named
    std::int64_t last_ = 0;                         // highest number that has a tool or a name
};

}  // namespace kadr::interp
