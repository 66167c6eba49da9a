#include "driver/output.h"

#include <cerrno>
#include <filesystem>
#include <functional>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/diagnostics/driver.h"

namespace kadr::driver {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBuffer = std::size_t{1} << 16;       // bytes between two writes to a file
constexpr std::size_t kSpoolBuffer = std::size_t{1} << 20;  // … before a spool goes to disk

/// The file behind symbolic links, so that a rename replaces the file and not the link.
std::string behind_links(const std::string& path) {
    std::error_code error;
    if (!fs::is_symlink(path, error)) return path;
    const fs::path real = fs::canonical(path, error);
    return error ? path : real.string();
}

/// Whether something stands there that must not be replaced: a device, a pipe.
bool is_special(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// The standard stream that writes to the same file: `/dev/stdout`, or the file that a shell has
/// opened for it. Replaced by a rename, that file would lose what the shell writes behind us.
std::FILE* standard_stream(const std::string& path) {
    struct stat named {};
    if (::stat(path.c_str(), &named) != 0) return nullptr;
    for (std::FILE* stream : {stdout, stderr}) {
        struct stat open {};
        const bool is_same = ::fstat(::fileno(stream), &open) == 0 && open.st_dev == named.st_dev &&
                             open.st_ino == named.st_ino;
        if (is_same) return stream;
    }
    return nullptr;
}

/// Whether the name is free or holds a file of ours to write. A rename would also replace a file
/// that is write-protected; that is not what its owner wanted.
bool may_replace(const std::string& path) {
    std::error_code error;
    if (fs::is_directory(path, error)) return false;
    return ::access(path.c_str(), W_OK) == 0 || errno == ENOENT;
}

/// A replaced file keeps its permissions.
void copy_permissions(const std::string& from, std::FILE* to) {
    struct stat existing {};
    if (::stat(from.c_str(), &existing) == 0) {
        [[maybe_unused]] const int ignored = ::fchmod(::fileno(to), existing.st_mode & 07777);
    }
}

/// A name beside the file, no longer than any: that of the file may be as long as names can be.
std::string draft_name(const std::string& target) {
    const fs::path path(target);
    const std::string name = ".kadr-" + std::to_string(::getpid()) + '-' +
                             std::to_string(std::hash<std::string>{}(path.filename().string())) +
                             '~';
    return (path.parent_path() / name).string();
}

/// A file without a name in the folder of `path`: it vanishes by itself if we are killed. Null
/// where the file system has no such files.
std::FILE* open_nameless(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    const int file =
        ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    return file < 0 ? nullptr : ::fdopen(file, "wb");
}

/// Gives a nameless file its name.
bool give_name(std::FILE* file, const std::string& name) {
    const std::string handle = "/proc/self/fd/" + std::to_string(::fileno(file));
    return ::linkat(AT_FDCWD, handle.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

}  // namespace

std::unique_ptr<Output> Output::open(const std::string& path, DiagnosticSink& sink,
                                     const OutputRules& rules) {
    const std::string target = path == "-" ? path : behind_links(path);
    std::FILE* const stream = path == "-" ? stdout : standard_stream(target);
    const bool is_spool = stream != nullptr || is_special(target);
    std::unique_ptr<Output> output(new Output(path, is_spool ? Kind::Spool : Kind::File, rules));
    if (!output->require_no_source(sink)) return nullptr;
    if (is_spool) {
        output->destination_ = stream != nullptr ? stream : std::fopen(target.c_str(), "wb");
        if (output->destination_ != nullptr) return output;
    } else if (may_replace(target)) {
        output->final_path_ = target;
        output->draft_ = draft_name(target);
        output->stream_ = open_nameless(target);
        output->is_nameless_ = output->stream_ != nullptr;
        if (!output->is_nameless_) output->stream_ = std::fopen(output->draft_.c_str(), "wb");
        if (output->stream_ != nullptr) {
            copy_permissions(target, output->stream_);
            return output;
        }
    }
    const std::string why = why_unwritable(target);
    auto message = sink.report(diag::FileUnwritable);
    message.arg(path == "-" ? "standard output" : path);
    if (!why.empty()) message.note(why);
    return nullptr;
}

Output::~Output() {
    if (stream_ != nullptr) {
        std::fclose(stream_);
        if (kind_ == Kind::File && !is_nameless_) std::remove(draft_.c_str());
    }
    const bool is_standard = destination_ == stdout || destination_ == stderr;
    if (destination_ != nullptr && !is_standard) std::fclose(destination_);
}

void Output::write(std::string_view text) {
    if (rules_.limit != nullptr && !rules_.limit->take(text.size())) return;
    buffer_ += text;
    if (buffer_.size() >= (kind_ == Kind::File ? kBuffer : kSpoolBuffer)) flush();
}

Done Output::require_no_source(DiagnosticSink& sink) const {
    if (rules_.inputs == nullptr || name_ == "-" || !rules_.inputs->was_read(name_)) return kDone;
    sink.report(diag::OutputIsSource).arg(name_);
    return kFailed;
}

/// Keeps why the system refused, for the message.
void Output::note_fault() {
    if (failed_ && fault_ == 0) fault_ = errno;
}

void Output::flush() {
    if (kind_ == Kind::Spool && stream_ == nullptr) stream_ = std::tmpfile();
    failed_ = failed_ || stream_ == nullptr ||
              std::fwrite(buffer_.data(), 1, buffer_.size(), stream_) != buffer_.size();
    note_fault();
    buffer_.clear();
}

void Output::overwrite(std::size_t at, std::string_view text) {
    if (stream_ == nullptr) {  // a spool that is still in memory
        buffer_.replace(at, text.size(), text);
        return;
    }
    flush();
    failed_ = failed_ || std::fseek(stream_, static_cast<long>(at), SEEK_SET) != 0 ||
              std::fwrite(text.data(), 1, text.size(), stream_) != text.size() ||
              std::fseek(stream_, 0, SEEK_END) != 0;
}

bool Output::copy_spool() {
    if (stream_ != nullptr) {
        std::rewind(stream_);
        std::vector<char> piece(kBuffer);
        while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), stream_)) {
            if (std::fwrite(piece.data(), 1, got, destination_) != got) return false;
        }
        if (std::ferror(stream_) != 0) return false;
    }
    return std::fwrite(buffer_.data(), 1, buffer_.size(), destination_) == buffer_.size() &&
           std::fflush(destination_) == 0;
}

bool Output::move_draft() {
    flush();
    failed_ = failed_ || std::fflush(stream_) != 0 || (is_nameless_ && !give_name(stream_, draft_));
    note_fault();
    failed_ = std::fclose(stream_) != 0 || failed_;
    note_fault();
    stream_ = nullptr;
    failed_ = failed_ || std::rename(draft_.c_str(), final_path_.c_str()) != 0;
    note_fault();
    if (failed_) std::remove(draft_.c_str());
    return !failed_;
}

bool Output::put_in_place() {
    if (kind_ == Kind::File) return move_draft();
    failed_ = failed_ || !copy_spool();
    note_fault();
    return !failed_;
}

Done Output::commit(DiagnosticSink& sink) {
    if (!require_no_source(sink)) return kFailed;
    const bool is_done = put_in_place();
    buffer_.clear();
    if (is_done) return kDone;
    auto message = sink.report(diag::FileUnwritable);
    message.arg(name_ == "-" ? "standard output" : name_);
    if (fault_ != 0) message.note(system_fault(fault_));
    return kFailed;
}

}  // namespace kadr::driver
