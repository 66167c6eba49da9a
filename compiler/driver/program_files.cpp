#include "driver/program_files.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/diagnostics/driver.h"
#include "driver/file_text.h"
#include "nc/tables.h"

namespace kadr::driver {

const std::vector<std::string>& ProgramFolders::names_in(const std::string& folder) {
    const auto known = names_.find(folder);
    if (known != names_.end()) return known->second;
    std::vector<std::string>& found = names_[folder];
    for (FolderEntry& entry : session_.files().list(folder)) {
        if (entry.kind == FileKind::File) found.push_back(std::move(entry.name));
    }
    return found;
}

std::vector<std::string> ProgramFolders::names(const nc::Dialect& dialect) {
    const nc::DialectTables& tables = dialect.tables();
    std::set<std::string> found;
    for (const std::string& folder : folders_) {
        for (const std::string& file : names_in(folder)) {
            for (const nc::ProgramPattern& pattern : tables.language.calls.files) {
                if (auto name =
                        nc::match_program(pattern, file, tables.notation.ignores_case, true))
                    found.insert(std::move(*name));
            }
        }
    }
    return {found.begin(), found.end()};
}

/// No link may lead away from the folders of programs.
Done ProgramFolders::require_readable(const std::string& file) {
    const FileAccess& access = session_.access();
    if (access.may_be_read(file)) return kDone;
    report_unread(session_.messages(), diag::FileUnreadable, {}, file, access.fault_elsewhere(file),
                  access);
    return kFailed;
}

std::optional<macro::ProgramFiles::File> ProgramFolders::open(const nc::Dialect& dialect,
                                                              const std::string& program,
                                                              const std::string& kind) {
    const nc::DialectTables& tables = dialect.tables();
    const bool is_number =
        std::ranges::all_of(program, [](char c) { return c >= '0' && c <= '9'; });
    for (const std::string& folder : folders_) {
        const std::vector<std::string>& names = names_in(folder);
        for (const nc::ProgramPattern& pattern : tables.language.calls.files) {
            if (pattern.is_number && !is_number) continue;
            if (!kind.empty() && nc::kind_of(pattern) != kind) continue;
            const auto is_wanted = [&](const std::string& name) {
                return nc::match_program(pattern, name, tables.notation.ignores_case, true) ==
                       program;
            };
            const auto found = std::ranges::find_if(names, is_wanted);
            if (found == names.end()) continue;
            const std::string path = (std::filesystem::path(folder) / *found).string();
            if (!require_readable(path)) continue;
            auto text = FileText::open(session_.files(), path);
            if (text) session_.access().note(path);
            if (text) return File{path, std::move(text)};
        }
    }
    return std::nullopt;
}

}  // namespace kadr::driver
