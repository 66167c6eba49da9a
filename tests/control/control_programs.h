// control_programs.h — the programs in the controls' own languages: CONTROL/CHAPTER/NAME below this
// folder. README.md has the chapters and says how a program tells what it expects.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kadr::interp {

struct ControlProgram {
    std::filesystem::path file;
    std::string control;  // the dialect that it is written in
    std::string chapter;
    std::string name() const { return file.stem().string(); }
    /// Where the programs stand that programs of this control call.
    std::filesystem::path called() const { return file.parent_path().parent_path() / "called"; }
};

/// All of them, in the order of their paths. Called programs are none.
const std::vector<ControlProgram>& control_programs();

/// What a program says; empty: the control has none of this name.
std::string program_text(const std::string& control, const std::string& name);

}  // namespace kadr::interp
