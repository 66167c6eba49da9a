// files.h — the one door to files: where texts come from, and where results go.
//
// It is handed in, so that the same program works on the disk (disk_files.h), in memory
// (memory_files.h), and on what an editor has not saved yet (overlay_files.h). Which of the files a
// program may read is another question: file_access.h.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace kadr {

/// Why a file was not read.
struct ReadFault {
    enum class Kind : std::uint8_t {
        Unreadable,  // it is missing, a folder, not ours; `why` tells what
        TooLarge,    // more bytes than the limit
        Elsewhere,   // outside of the folders that a program may read; `why` is the folder that
                     // would have to be among them
    };
    Kind kind = Kind::Unreadable;
    std::string why;
};

/// What a path leads to, symbolic links followed.
enum class FileKind : std::uint8_t {
    Missing,
    File,
    Folder,
    Special,  // a device, a pipe
};

/// One entry of a folder.
struct FolderEntry {
    std::string name;  // without the folder
    FileKind kind = FileKind::Missing;
    friend bool operator==(const FolderEntry&, const FolderEntry&) = default;
};

/// A file that is read piece by piece.
class FileReader {
  public:
    virtual ~FileReader() = default;
    /// Fills as much of the piece as there is. Returns how many bytes; 0: the end.
    virtual std::size_t read(std::span<char> piece) = 0;
    /// The next byte is this one, counted from 0. False: it cannot be read twice (a pipe).
    virtual bool seek(std::uint64_t offset) = 0;
};

/// A file that is written whole or not at all: nobody sees it before `commit`, and without it
/// nothing remains. What went wrong in between is reported by `commit`.
class FileWriter {
  public:
    virtual ~FileWriter() = default;
    virtual void write(std::string_view text) = 0;
    /// Replaces what was written at this byte and behind it; not more than was written.
    virtual void overwrite(std::size_t at, std::string_view text) = 0;
    /// Puts the file in its place. False: what stood there before is untouched; `fault` tells why.
    virtual bool commit() = 0;
    /// "there is no space left"; empty: nothing more is known.
    virtual std::string fault() const = 0;
};

/// A store of files by their paths. `-` is standard input where it is read, standard output where
/// it is written. Any thread may read; one writes.
class Files {
  public:
    /// Bytes of one file that are read at most, unless the user sets another limit.
    static constexpr std::uint64_t kMostBytes = std::uint64_t{256} << 20;
    /// The same for two paths that lead to the same file.
    using Identity = std::pair<std::uint64_t, std::uint64_t>;

    virtual ~Files() = default;

    virtual FileKind kind_of(const std::string& path) const = 0;
    bool is_file(const std::string& path) const { return kind_of(path) == FileKind::File; }
    bool is_folder(const std::string& path) const { return kind_of(path) == FileKind::Folder; }
    /// What stands in a folder, by name; empty if it cannot be looked through.
    virtual std::vector<FolderEntry> list(const std::string& folder) const = 0;
    /// Absolute and without links, as far as the path exists; empty if that cannot be had.
    virtual std::string real_path(const std::string& path) const = 0;
    /// Where a symbolic link leads, as it is written in it; nothing: it is none.
    virtual std::optional<std::string> link_target(const std::string& path) const = 0;
    /// Of a regular file. Nothing of what loses nothing when something is written to it.
    virtual std::optional<Identity> identity_of(const std::string& path) const = 0;

    /// The whole of a file, as bytes.
    virtual Result<std::string, ReadFault> read(const std::string& path,
                                                std::uint64_t most_bytes = kMostBytes) const = 0;
    /// Null if it cannot be read.
    virtual std::unique_ptr<FileReader> open(const std::string& path) const = 0;
    /// Null if it cannot be written.
    virtual std::unique_ptr<FileWriter> create(const std::string& path) = 0;

    /// Why a file cannot be opened, as words behind "it": "there is no such file". Asked behind the
    /// attempt, so it may be empty.
    virtual std::string why_unreadable(const std::string& path) const = 0;
    /// Likewise for a file that is to be written: "the folder does not exist".
    virtual std::string why_unwritable(const std::string& path) const = 0;
};

/// A number of bytes as a person writes it: "256 MiB".
std::string bytes_text(std::uint64_t bytes);

}  // namespace kadr
