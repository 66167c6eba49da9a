#include "driver/program_files.h"

#include <algorithm>
#include <filesystem>

#include "base/diagnostics/driver.h"
#include "driver/file_text.h"
#include "nc/tables.h"

namespace kadr::driver {

namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

const std::vector<ProgramFolders::Entry>& ProgramFolders::entries(const std::string& folder) {
    const auto known = entries_.find(folder);
    if (known != entries_.end()) return known->second;
    std::vector<Entry>& found = entries_[folder];
    std::error_code error;
    const auto end = fs::directory_iterator();
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != end;
         entry.increment(error)) {
        std::error_code unreadable;
        if (entry->is_regular_file(unreadable))
            found.push_back({entry->path().filename().string(), entry->path().string()});
    }
    std::ranges::sort(found, {}, &Entry::name);
    return found;
}

/// No link may lead away from the folders of programs.
Done ProgramFolders::require_readable(const std::string& file) {
    if (session_ == nullptr || session_->files().may_be_read(file)) return kDone;
    report_unread(session_->messages(), diag::FileUnreadable, {}, file,
                  session_->files().fault_elsewhere(file), session_->files());
    return kFailed;
}

std::optional<macro::ProgramFiles::File> ProgramFolders::open(const nc::Dialect& dialect,
                                                              const std::string& program,
                                                              const std::string& kind) {
    const nc::DialectTables& tables = dialect.tables();
    const bool is_number =
        std::ranges::all_of(program, [](char c) { return c >= '0' && c <= '9'; });
    for (const std::string& folder : folders_) {
        const std::vector<Entry>& names = entries(folder);
        for (const nc::ProgramPattern& pattern : tables.language.calls.files) {
            if (pattern.is_number && !is_number) continue;
            if (!kind.empty() && nc::kind_of(pattern) != kind) continue;
            const auto is_wanted = [&](const Entry& entry) {
                return nc::match_program(pattern, entry.name, tables.notation.ignores_case, true) ==
                       program;
            };
            const auto found = std::ranges::find_if(names, is_wanted);
            if (found == names.end()) continue;
            if (!require_readable(found->path)) continue;
            auto text = FileText::open(found->path);
            if (text && session_ != nullptr) session_->files().note(found->path);
            if (text) return File{found->path, std::move(text)};
        }
    }
    return std::nullopt;
}

}  // namespace kadr::driver
