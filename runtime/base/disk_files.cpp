#include "base/disk_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace kadr {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 16;

FileKind kind_of_status(const fs::file_status& status) {
    if (!fs::exists(status)) return FileKind::Missing;
    if (fs::is_regular_file(status)) return FileKind::File;
    return fs::is_directory(status) ? FileKind::Folder : FileKind::Special;
}

class DiskReader final : public FileReader {
  public:
    explicit DiskReader(std::FILE* file) : file_(file) {}
    ~DiskReader() override {
        if (file_ != stdin) std::fclose(file_);
    }
    DiskReader(const DiskReader&) = delete;
    DiskReader& operator=(const DiskReader&) = delete;

    std::size_t read(std::span<char> piece) override {
        return std::fread(piece.data(), 1, piece.size(), file_);
    }
    bool seek(std::uint64_t offset) override {
        return file_ != stdin && fseeko(file_, static_cast<off_t>(offset), SEEK_SET) == 0;
    }

  private:
    std::FILE* file_;
};

}  // namespace

Files& disk() {
    static DiskFiles files;
    return files;
}

std::optional<std::string> read_file(const std::string& path) {
    auto text = disk().read(path);
    if (!text) return std::nullopt;
    return *std::move(text);
}

bool write_file_whole(const std::string& path, std::string_view text) {
    const auto file = disk().create(path);
    if (file == nullptr) return false;
    file->write(text);
    return file->commit();
}

FileKind DiskFiles::kind_of(const std::string& path) const {
    std::error_code error;
    return kind_of_status(fs::status(path, error));
}

std::vector<FolderEntry> DiskFiles::list(const std::string& folder) const {
    std::vector<FolderEntry> entries;
    std::error_code error;
    const fs::path root = folder.empty() ? fs::path(".") : fs::path(folder);
    for (fs::directory_iterator entry(root, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;
        entries.push_back(
            {entry->path().filename().string(), kind_of_status(entry->status(ignored))});
    }
    std::ranges::sort(entries, {}, &FolderEntry::name);
    return entries;
}

std::string DiskFiles::real_path(const std::string& path) const {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? std::string() : real.string();
}

std::optional<std::string> DiskFiles::link_target(const std::string& path) const {
    std::error_code error;
    if (!fs::is_symlink(path, error)) return std::nullopt;
    return fs::read_symlink(path, error).string();
}

std::optional<Files::Identity> DiskFiles::identity_of(const std::string& path) const {
    struct stat found {};
    const int failed = path == "-" ? ::fstat(STDIN_FILENO, &found) : ::stat(path.c_str(), &found);
    if (failed != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return Identity{found.st_dev, found.st_ino};
}

Result<std::string, ReadFault> DiskFiles::read(const std::string& path,
                                               std::uint64_t most_bytes) const {
    if (path != "-" && is_folder(path))
        return ReadFault{ReadFault::Kind::Unreadable, "it is a folder"};
    std::FILE* const in = path == "-" ? stdin : std::fopen(path.c_str(), "rb");
    if (in == nullptr) return ReadFault{ReadFault::Kind::Unreadable, system_fault(errno)};
    // In pieces, and counted: what is read may be a file without an end.
    std::string text;
    std::array<char, kPiece> piece{};
    bool is_too_large = false;
    while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), in)) {
        is_too_large = text.size() + got > most_bytes;
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

std::unique_ptr<FileReader> DiskFiles::open(const std::string& path) const {
    if (path != "-" && is_folder(path)) return nullptr;
    std::FILE* file = path == "-" ? stdin : std::fopen(path.c_str(), "rb");
    return file == nullptr ? nullptr : std::make_unique<DiskReader>(file);
}

std::unique_ptr<FileWriter> DiskFiles::create(const std::string& path) {
    return create_on_disk(path);
}

std::string DiskFiles::why_unreadable(const std::string& path) const {
    if (is_folder(path)) return "it is a folder";
    if (::access(path.c_str(), R_OK) != 0) return system_fault(errno);
    return {};
}

std::string DiskFiles::why_unwritable(const std::string& path) const {
    if (is_folder(path)) return "it is a folder";
    struct stat found {};
    if (::stat(path.c_str(), &found) == 0)
        return ::access(path.c_str(), W_OK) == 0 ? std::string() : system_fault(errno);
    if (errno != ENOENT) return system_fault(errno);
    const std::string folder = fs::path(path).parent_path().string();
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK) != 0)
        return errno == ENOENT ? "the folder does not exist" : system_fault(errno);
    return {};
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

}  // namespace kadr
