// control_files.h — files in the control's memory that a program writes, reads and deletes.
//
// Lines by the name of the file, for the length of a run: nothing is written to a disk, and a file
// that was there before stays there whatever the program does to it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kadr::macro {

class ControlFiles {
  public:
    /// As programs see them.
    /// source  S 8.4 READ, WRITE, DELETE; numbers of the job planning manual
    enum class Error : int {
        None = 0,
        FileMissing = 3,
        FileFull = 10,
        LineMissing = 21,     // the first line that is wanted
        ResultTooSmall = 22,  // for so many lines
        TooManyLines = 23,    // more than there are
    };
    using Lines = std::vector<std::string>;
    static constexpr std::size_t kMostBytes = std::size_t{16} << 20;

    /// Whether the program has written or deleted it; else it is as it was before the run.
    bool knows(const std::string& name) const { return files_.contains(name); }
    bool has(const std::string& name) const;
    /// A file that was there before, as the program finds it.
    void add(const std::string& name, Lines lines) { files_.emplace(name, std::move(lines)); }
    /// One line more; a file that is not there is made. All files together take kMostBytes; the
    /// control's limit is a datum of the machine.
    Error write(const std::string& name, std::string_view line);
    Error remove(const std::string& name);
    /// `count` lines from the line `first` on, counted from 1; 0: the last ones. What there is of
    /// them is read with TooManyLines, too (unsure).
    Error read(const std::string& name, double first, double count, Lines& out) const;

  private:
    std::map<std::string, std::optional<Lines>> files_;  // nothing: it was deleted
    std::size_t bytes_ = 0;                              // that were written
};

}  // namespace kadr::macro
