// listing.h — a command as one line of JSON, as `--commands` writes it.
//
//   {"op":"line","to":{"X":10,"Y":0,"Z":-1},"feed":200,"iso":12,"src":"part.kadr:34"}
#pragma once

#include <string>
#include <string_view>

#include "machine/machine.h"
#include "path/command.h"

namespace kadr::interp {

/// Writes commands of one run.
class Listing {
  public:
    /// X, Y and Z are always shown; of the other axes those that the machine has.
    explicit Listing(const machine::Machine& machine);

    /// Appends one line, its line end included. `source` is the location in the source program
    /// ("part.kadr:34"); empty: none. Lengths mm, angles deg, rounded to 9 decimals, so that the
    /// noise of frames does not show.
    void append(const path::Command& command, std::string_view source, std::string& out) const;

  private:
    AxisMask axes_ = kLinearXYZ;
};

}  // namespace kadr::interp
