#include "base/files.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#include "base/diagnostics/driver.h"

namespace kadr {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 16;
constexpr const char* kProjectFile = "kadr.toml";

/// Symbolic links followed as far as the path exists; empty if that is not possible.
std::string real_path(const fs::path& path) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? std::string() : real.string();
}

/// The folder of a file, or the nearest one above with the file that marks a project.
std::string home_of(const std::string& file) {
    const fs::path folder = file == "-" ? fs::path(".") : fs::path(file).parent_path();
    const std::string home = real_path(folder.empty() ? fs::path(".") : folder);
    std::error_code error;
    for (fs::path above = home; !above.empty(); above = above.parent_path()) {
        if (fs::is_regular_file(above / kProjectFile, error)) return above.string();
        if (above == above.root_path()) break;
    }
    return home;
}

bool is_below(std::string_view file, std::string_view folder) {
    if (folder.empty() || !file.starts_with(folder)) return false;
    return folder.ends_with('/') || file.size() == folder.size() || file[folder.size()] == '/';
}

}  // namespace

void Files::allow(const std::string& folder) {
    std::string real = real_path(folder.empty() ? "." : folder);
    while (real.size() > 1 && real.ends_with('/')) real.pop_back();
    if (!real.empty()) allowed_.push_back(std::move(real));
}

void Files::allow_home_of(const std::string& file) { allowed_.push_back(home_of(file)); }

bool Files::may_be_read(const std::string& file, const std::string& beside) const {
    const std::string real = real_path(file);
    if (real.empty()) return false;
    for (const std::string& folder : allowed_) {
        if (is_below(real, folder)) return true;
    }
    return !beside.empty() && is_below(real, home_of(beside));
}

ReadFault Files::fault_elsewhere(const std::string& file, const std::string& beside) const {
    constexpr int kMostLinks = 40;  // as the kernel follows
    fs::path at = file;
    std::string folder;
    for (int i = 0; i < kMostLinks; ++i) {
        folder = at.has_parent_path() ? at.parent_path().string() : ".";
        // Where a link leads that stands elsewhere, a program from somebody else must not learn.
        std::error_code error;
        if (!may_be_read(folder, beside) || !fs::is_symlink(at, error)) break;
        const fs::path target = fs::read_symlink(at, error);
        at = (fs::path(real_path(folder)) / target).lexically_normal();
    }
    return {ReadFault::Kind::Elsewhere, folder};
}

std::optional<Files::Identity> Files::identity_of(const std::string& file) {
    struct stat found {};
    const int failed = file == "-" ? ::fstat(STDIN_FILENO, &found) : ::stat(file.c_str(), &found);
    // Terminals and pipes lose nothing when something is written to them.
    if (failed != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return Identity{found.st_dev, found.st_ino};
}

void Files::note(const std::string& file) {
    const auto identity = identity_of(file);
    if (!identity) return;
    const std::lock_guard lock(mutex_);
    read_.insert(*identity);
}

bool Files::was_read(const std::string& file) const {
    const auto identity = identity_of(file);
    if (!identity || file == "-") return false;
    const std::lock_guard lock(mutex_);
    return read_.contains(*identity);
}

Result<std::string, ReadFault> Files::read(const std::string& file) {
    std::error_code error;
    if (file != "-" && fs::is_directory(file, error))
        return ReadFault{ReadFault::Kind::Unreadable, "it is a folder"};
    std::FILE* const in = file == "-" ? stdin : std::fopen(file.c_str(), "rb");
    if (in == nullptr) return ReadFault{ReadFault::Kind::Unreadable, system_fault(errno)};
    note(file);
    // In pieces, and counted: what is read may be a file without an end.
    std::string text;
    std::array<char, kPiece> piece{};
    bool is_too_large = false;
    while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), in)) {
        is_too_large = text.size() + got > most_bytes_;
        if (is_too_large) break;
        text.append(piece.data(), got);
    }
    const bool has_failed = std::ferror(in) != 0;
    const int why = errno;
    if (in != stdin) std::fclose(in);
    if (is_too_large) return ReadFault{ReadFault::Kind::TooLarge, {}};
    if (has_failed) return ReadFault{ReadFault::Kind::Unreadable, system_fault(why)};
    return text;
}

Result<std::string, ReadFault> Files::read_named(const std::string& file,
                                                 const std::string& beside) {
    // Whether it exists is revealed of no file that may not be read.
    if (!may_be_read(file, beside)) return fault_elsewhere(file, beside);
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
        return ReadFault{ReadFault::Kind::Unreadable, "it is a device or a pipe"};
    return read(file);
}

std::string system_fault(int error) {
    switch (error) {
        case ENOENT: return "there is no such file";
        case ENOTDIR: return "a part of its path is no folder";
        case EACCES:
        case EPERM: return "its permissions do not allow it";
        case ENAMETOOLONG: return "the name is too long";
        case ELOOP: return "its symbolic links lead in a circle";
        case EROFS: return "the file system can only be read";
        case ENOSPC: return "there is no space left";
        case EDQUOT: return "the quota is used up";
        case EMFILE:
        case ENFILE: return "too many files are open";
        default: return std::generic_category().message(error);
    }
}

std::string why_unreadable(const std::string& file) {
    std::error_code error;
    if (fs::is_directory(file, error)) return "it is a folder";
    if (::access(file.c_str(), R_OK) != 0) return system_fault(errno);
    return {};
}

std::string why_unwritable(const std::string& file) {
    std::error_code error;
    if (fs::is_directory(file, error)) return "it is a folder";
    struct stat found {};
    if (::stat(file.c_str(), &found) == 0)
        return ::access(file.c_str(), W_OK) == 0 ? std::string() : system_fault(errno);
    if (errno != ENOENT) return system_fault(errno);
    const std::string folder = fs::path(file).parent_path().string();
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK) != 0)
        return errno == ENOENT ? "the folder does not exist" : system_fault(errno);
    return {};
}

void report_unread(DiagnosticSink& sink, const DiagnosticRow& row, const SourceRange& location,
                   const std::string& file, const ReadFault& fault, const Files& files) {
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
                .arg(bytes_text(files.most_bytes()))
                .fix("if it is meant, raise the limit: `--max-input`");
            return;
        case ReadFault::Kind::Elsewhere:
            sink.report(diag::FileElsewhere, location)
                .arg(file)
                .fix("if the program may read it, say so: `--allow-read " + fault.why + '`');
            return;
    }
}

std::string bytes_text(std::uint64_t bytes) {
    constexpr std::array<const char*, 5> kUnits = {" bytes", " KiB", " MiB", " GiB", " TiB"};
    std::size_t unit = 0;
    while (bytes >= 1024 && bytes % 1024 == 0 && unit + 1 < kUnits.size()) {
        bytes /= 1024;
        ++unit;
    }
    return std::to_string(bytes) + kUnits[unit];
}

}  // namespace kadr
