// described_machine.h — a whole machine file: the machine itself, and what it gives the programs
// that run on it.
//
// Motion needs the machine alone; what it gives is for who executes programs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "machine/machine.h"
#include "machine/probe.h"

namespace kadr::machine {

/// A value that programs read from the control: machine data, an input.
struct MachineDatum {
    std::string name;      // as programs write it: `$MN_USER_DATA_INT[3]`, `#1004`
    std::string value;     // a number or a text
    SourceRange location;  // in the machine file
};

struct MachineData {
    std::vector<MachineDatum> data;          // in the order of the file
    std::map<std::string, Axis> axis_names;  // of axes as an index, besides AX1, X1 …
    std::optional<ProbeScene> probe;         // what its touch probe meets, if the file has one
    std::string tools;                       // path of its tool library; empty: none is named
};

struct DescribedMachine {
    Machine machine;
    MachineData data;
};

/// Loads a machine as `load_machine` does, with what it gives.
std::optional<DescribedMachine> load_described_machine(const std::string& name_or_file,
                                                       const SearchPath& folders, Sources& sources,
                                                       DiagnosticSink& sink);

}  // namespace kadr::machine
