// file_access.h — which files a command may read, how much of them, and which it has read.
//
// A file that the user names may lie anywhere. One that a program names (a table, an import, what a
// dialect extends) lies below a folder that the user named: that of the source, one of a search
// path, the library. A program from somebody else cannot look around on the disk, then.
#pragma once

#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/result.h"

namespace kadr {

class FileAccess {
  public:
    /// `files` outlives it.
    explicit FileAccess(const Files& files, std::uint64_t most_bytes = Files::kMostBytes)
        : files_(files), most_bytes_(most_bytes) {}
    FileAccess(const FileAccess&) = delete;
    FileAccess& operator=(const FileAccess&) = delete;

    const Files& files() const { return files_; }
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
    std::string home_of(const std::string& file) const;

    const Files& files_;
    std::uint64_t most_bytes_;
    std::vector<std::string> allowed_;  // real paths
    mutable std::mutex mutex_;          // a running program reads tables beside the main thread
    std::set<Files::Identity> read_;
};

/// Reports that a file was not read: `row` (one argument, the name) with the reason, or that it is
/// too large or out of bounds.
void report_unread(DiagnosticSink& sink, const DiagnosticRow& row, const SourceRange& location,
                   const std::string& file, const ReadFault& fault, const FileAccess& access);

}  // namespace kadr
