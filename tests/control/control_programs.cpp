#include "tests/control/control_programs.h"

#include <algorithm>

#include "base/disk_files.h"
#include "base/text.h"

namespace kadr::interp {
namespace {

namespace fs = std::filesystem;

const fs::path kPrograms = fs::path(KADR_ROOT) / "tests/control";

bool is_program(const fs::path& file) {
    const std::string suffix = file.extension();
    return suffix == ".nc" || suffix == ".mpf" || suffix == ".i";
}

std::vector<ControlProgram> find_programs() {
    std::vector<ControlProgram> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kPrograms)) {
        const fs::path& file = entry.path();
        const fs::path chapter = file.parent_path();
        const bool is_in_chapter = chapter.parent_path().parent_path() == kPrograms;
        if (!is_in_chapter || !is_program(file) || chapter.filename() == "called") continue;
        found.push_back({file, chapter.parent_path().filename(), chapter.filename()});
    }
    std::ranges::sort(found, {}, &ControlProgram::file);
    return found;
}

}  // namespace

const std::vector<ControlProgram>& control_programs() {
    static const std::vector<ControlProgram> all = find_programs();
    return all;
}

std::string program_text(const std::string& control, const std::string& name) {
    for (const ControlProgram& program : control_programs()) {
        if (program.control == control && program.name() == name)
            return read_file(program.file.string()).value_or("");
    }
    return "";
}

}  // namespace kadr::interp
