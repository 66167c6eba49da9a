// disk_writing.cpp — results on the disk, whole or not at all.
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/disk_files.h"

namespace kadr {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSpoolBuffer = std::size_t{1} << 20;  // bytes before a spool goes to disk
constexpr std::size_t kCopied = std::size_t{1} << 16;       // … that are copied at a time

/// The file behind symbolic links, so that a rename replaces the file and not the link.
std::string behind_links(const std::string& path) {
    std::error_code error;
    if (!fs::is_symlink(path, error)) return path;
    const fs::path real = fs::canonical(path, error);
    return error ? path : real.string();
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
    if (disk().is_folder(path)) return false;
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

/// Whether something went wrong, and the system's first reason.
class Trouble {
  public:
    bool is_there() const { return is_there_; }
    int reason() const { return reason_; }
    /// Keeps the system's reason, if this has failed.
    void note(bool has_failed) {
        is_there_ = is_there_ || has_failed;
        if (has_failed && reason_ == 0) reason_ = errno;
    }

  private:
    bool is_there_ = false;
    int reason_ = 0;
};

/// Writes into a stream at this byte; the stream stands at its end behind it.
bool overwrite_in(std::FILE* stream, std::size_t at, std::string_view text) {
    return std::fseek(stream, static_cast<long>(at), SEEK_SET) == 0 &&
           std::fwrite(text.data(), 1, text.size(), stream) == text.size() &&
           std::fseek(stream, 0, SEEK_END) == 0;
}

/// A neighbour of the file that becomes it.
class DraftWriter final : public FileWriter {
  public:
    /// Null if nothing can be written there.
    static std::unique_ptr<FileWriter> open(const std::string& target) {
        if (!may_replace(target)) return nullptr;
        std::unique_ptr<DraftWriter> writer(new DraftWriter(target));
        if (writer->stream_ == nullptr) return nullptr;
        copy_permissions(target, writer->stream_);
        return writer;
    }
    ~DraftWriter() override {
        if (stream_ == nullptr) return;
        std::fclose(stream_);
        if (!is_nameless_) std::remove(draft_.c_str());
    }
    DraftWriter(const DraftWriter&) = delete;
    DraftWriter& operator=(const DraftWriter&) = delete;

    void write(std::string_view text) override {
        if (trouble_.is_there()) return;
        trouble_.note(std::fwrite(text.data(), 1, text.size(), stream_) != text.size());
    }
    void overwrite(std::size_t at, std::string_view text) override {
        if (!trouble_.is_there()) trouble_.note(!overwrite_in(stream_, at, text));
    }
    bool commit() override {
        if (!trouble_.is_there()) trouble_.note(std::fflush(stream_) != 0);
        if (!trouble_.is_there() && is_nameless_) trouble_.note(!give_name(stream_, draft_));
        trouble_.note(std::fclose(stream_) != 0);
        stream_ = nullptr;
        if (!trouble_.is_there())
            trouble_.note(std::rename(draft_.c_str(), final_path_.c_str()) != 0);
        if (trouble_.is_there()) std::remove(draft_.c_str());
        return !trouble_.is_there();
    }
    std::string fault() const override {
        return trouble_.reason() == 0 ? std::string() : system_fault(trouble_.reason());
    }

  private:
    explicit DraftWriter(const std::string& target)
        : final_path_(target), draft_(draft_name(target)), stream_(open_nameless(target)) {
        is_nameless_ = stream_ != nullptr;
        if (!is_nameless_) stream_ = std::fopen(draft_.c_str(), "wb");
    }

    std::string final_path_;
    std::string draft_;  // the neighbour's name
    std::FILE* stream_;
    bool is_nameless_ = false;  // it gets its name only at the end
    Trouble trouble_;
};

/// For standard output and special files: in memory, then in a file of the system, until the end.
class SpoolWriter final : public FileWriter {
  public:
    explicit SpoolWriter(std::FILE* destination) : destination_(destination) {}
    ~SpoolWriter() override {
        if (stream_ != nullptr) std::fclose(stream_);
        if (destination_ != stdout && destination_ != stderr) std::fclose(destination_);
    }
    SpoolWriter(const SpoolWriter&) = delete;
    SpoolWriter& operator=(const SpoolWriter&) = delete;

    void write(std::string_view text) override {
        buffer_ += text;
        if (buffer_.size() >= kSpoolBuffer) flush();
    }
    void overwrite(std::size_t at, std::string_view text) override {
        if (stream_ == nullptr) {
            buffer_.replace(at, text.size(), text);
            return;
        }
        flush();
        if (!trouble_.is_there()) trouble_.note(!overwrite_in(stream_, at, text));
    }
    bool commit() override {
        if (!trouble_.is_there()) trouble_.note(!copy());
        buffer_.clear();
        return !trouble_.is_there();
    }
    std::string fault() const override {
        return trouble_.reason() == 0 ? std::string() : system_fault(trouble_.reason());
    }

  private:
    void flush() {
        if (stream_ == nullptr) stream_ = std::tmpfile();
        trouble_.note(stream_ == nullptr ||
                      std::fwrite(buffer_.data(), 1, buffer_.size(), stream_) != buffer_.size());
        buffer_.clear();
    }
    bool copy() {
        if (stream_ != nullptr) {
            std::rewind(stream_);
            std::vector<char> piece(kCopied);
            while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), stream_)) {
                if (std::fwrite(piece.data(), 1, got, destination_) != got) return false;
            }
            if (std::ferror(stream_) != 0) return false;
        }
        return std::fwrite(buffer_.data(), 1, buffer_.size(), destination_) == buffer_.size() &&
               std::fflush(destination_) == 0;
    }

    std::FILE* destination_;
    std::FILE* stream_ = nullptr;  // where memory ends
    std::string buffer_;
    Trouble trouble_;
};

}  // namespace

std::unique_ptr<FileWriter> create_on_disk(const std::string& path) {
    if (path == "-") return std::make_unique<SpoolWriter>(stdout);
    const std::string target = behind_links(path);
    if (std::FILE* const stream = standard_stream(target))
        return std::make_unique<SpoolWriter>(stream);
    if (disk().kind_of(target) != FileKind::Special) return DraftWriter::open(target);
    std::FILE* const device = std::fopen(target.c_str(), "wb");
    return device == nullptr ? nullptr : std::make_unique<SpoolWriter>(device);
}

}  // namespace kadr
