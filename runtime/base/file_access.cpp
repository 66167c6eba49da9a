#include "base/file_access.h"

#include <filesystem>
#include <string_view>
#include <utility>

#include "base/diagnostics/driver.h"

namespace kadr {

namespace {

namespace fs = std::filesystem;

constexpr const char* kProjectFile = "kadr.toml";

bool is_below(std::string_view file, std::string_view folder) {
    if (folder.empty() || !file.starts_with(folder)) return false;
    return folder.ends_with('/') || file.size() == folder.size() || file[folder.size()] == '/';
}

}  // namespace

/// The folder of a file, or the nearest one above with the file that marks a project.
std::string FileAccess::home_of(const std::string& file) const {
    const fs::path folder = file == "-" ? fs::path(".") : fs::path(file).parent_path();
    const std::string home = files_.real_path(folder.empty() ? "." : folder.string());
    for (fs::path above = home; !above.empty(); above = above.parent_path()) {
        if (files_.is_file((above / kProjectFile).string())) return above.string();
        if (above == above.root_path()) break;
    }
    return home;
}

void FileAccess::allow(const std::string& folder) {
    std::string real = files_.real_path(folder.empty() ? "." : folder);
    while (real.size() > 1 && real.ends_with('/')) real.pop_back();
    if (!real.empty()) allowed_.push_back(std::move(real));
}

void FileAccess::allow_home_of(const std::string& file) { allowed_.push_back(home_of(file)); }

bool FileAccess::may_be_read(const std::string& file, const std::string& beside) const {
    const std::string real = files_.real_path(file);
    if (real.empty()) return false;
    for (const std::string& folder : allowed_) {
        if (is_below(real, folder)) return true;
    }
    return !beside.empty() && is_below(real, home_of(beside));
}

ReadFault FileAccess::fault_elsewhere(const std::string& file, const std::string& beside) const {
    constexpr int kMostLinks = 40;  // as the kernel follows
    fs::path at = file;
    std::string folder;
    for (int i = 0; i < kMostLinks; ++i) {
        folder = at.has_parent_path() ? at.parent_path().string() : ".";
        // Where a link leads that stands elsewhere, a program from somebody else must not learn.
        if (!may_be_read(folder, beside)) break;
        const auto target = files_.link_target(at.string());
        if (!target) break;
        at = (fs::path(files_.real_path(folder)) / *target).lexically_normal();
    }
    return {ReadFault::Kind::Elsewhere, folder};
}

void FileAccess::note(const std::string& file) {
    const auto identity = files_.identity_of(file);
    if (!identity) return;
    const std::lock_guard lock(mutex_);
    read_.insert(*identity);
}

bool FileAccess::was_read(const std::string& file) const {
    const auto identity = files_.identity_of(file);
    if (!identity || file == "-") return false;
    const std::lock_guard lock(mutex_);
    return read_.contains(*identity);
}

Result<std::string, ReadFault> FileAccess::read(const std::string& file) {
    auto text = files_.read(file, most_bytes_);
    if (text || text.error().kind == ReadFault::Kind::TooLarge) note(file);
    return text;
}

Result<std::string, ReadFault> FileAccess::read_named(const std::string& file,
                                                      const std::string& beside) {
    // Whether it exists is revealed of no file that may not be read.
    if (!may_be_read(file, beside)) return fault_elsewhere(file, beside);
    if (files_.kind_of(file) == FileKind::Special)
        return ReadFault{ReadFault::Kind::Unreadable, "it is a device or a pipe"};
    return read(file);
}

void report_unread(DiagnosticSink& sink, const DiagnosticRow& row, const SourceRange& location,
                   const std::string& file, const ReadFault& fault, const FileAccess& access) {
    switch (fault.kind) {
        case ReadFault::Kind::Unreadable: {
            auto message = sink.report(row, location);
            message.arg(file);
            if (!fault.why.empty()) message.note(fault.why);
            return;
        }
        case ReadFault::Kind::TooLarge:
            sink.report(diag::FileTooLarge, location)
                .arg(file == "-" ? "standard input" : file)
                .arg(bytes_text(access.most_bytes()))
                .fix("if it is meant, raise the limit: `--max-input`");
            return;
        case ReadFault::Kind::Elsewhere:
            sink.report(diag::FileElsewhere, location)
                .arg(file)
                .fix("if the program may read it, say so: `--allow-read " + fault.why + '`');
            return;
    }
}

}  // namespace kadr
