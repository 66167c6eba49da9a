// files.h — the one door to files that are read whole: which may be read, how much of them, and
// which were.
//
// A file that the user names may lie anywhere. One that a program names (a table, an import, what a
// dialect extends) lies below a folder that the user named: that of the source, one of a search
// path, the library. A program from somebody else cannot look around on the disk, then.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
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

class Files {
  public:
    /// Bytes of one file that are read at most, unless the user sets another limit.
    static constexpr std::uint64_t kMostBytes = std::uint64_t{256} << 20;

    explicit Files(std::uint64_t most_bytes = kMostBytes) : most_bytes_(most_bytes) {}
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;

    std::uint64_t most_bytes() const { return most_bytes_; }

    /// Programs may read what lies below this folder.
    void allow(const std::string& folder);
    /// … and below the home of a file that the user named: its folder, or the nearest one above
    /// that holds a `kadr.toml`. `-` is at home in the working folder.
    void allow_home_of(const std::string& file);
    /// Whether a program may read this file, symbolic links followed. `beside` is the file that
    /// names it and was named by the user; below its home it may be, too. Empty: none.
    bool may_be_read(const std::string& file, const std::string& beside = {}) const;

    /// What is wrong with a file that may not be read: `why` is its folder or, of a symbolic link
    /// in a folder that may be read, that of what it leads to.
    ReadFault fault_elsewhere(const std::string& file, const std::string& beside = {}) const;

    /// The whole of a file that the user named; `-` is standard input.
    Result<std::string, ReadFault> read(const std::string& file);
    /// … that a program named.
    Result<std::string, ReadFault> read_named(const std::string& file,
                                              const std::string& beside = {});

    /// Notes a file that somebody else reads: an output must not replace it.
    void note(const std::string& file);
    /// Whether this name leads to a file that was read.
    bool was_read(const std::string& file) const;

  private:
    using Identity = std::pair<std::uint64_t, std::uint64_t>;  // device, inode
    static std::optional<Identity> identity_of(const std::string& file);

    std::uint64_t most_bytes_;
    std::vector<std::string> allowed_;  // canonical
    mutable std::mutex mutex_;          // a running program reads tables beside the main thread
    std::set<Identity> read_;
};

/// What the system's number of an error means: "there is no space left".
std::string system_fault(int error);

/// Why a file cannot be opened, as words behind "it": "there is no such file". Asked behind the
/// attempt, so it may be empty.
std::string why_unreadable(const std::string& file);
/// Likewise for a file that is to be written: "the folder does not exist".
std::string why_unwritable(const std::string& file);

/// Reports that a file was not read: `row` (one argument, the name) with the reason, or that it is
/// too large or out of bounds.
void report_unread(DiagnosticSink& sink, const DiagnosticRow& row, const SourceRange& location,
                   const std::string& file, const ReadFault& fault, const Files& files);

/// A number of bytes as a person writes it: "256 MiB".
std::string bytes_text(std::uint64_t bytes);

}  // namespace kadr
