// output.h — a result that is written whole or not at all, however long it is.
//
// A file grows as a neighbour of its final name and is renamed when it is complete; standard output
// and special files get everything at the end, spooled until then. What is not committed leaves no
// trace.
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "base/diagnostic.h"

namespace kadr::driver {

class Output {
  public:
    /// Prepares to write; `-` is standard output. Null, with a message, if the place cannot be
    /// written.
    static std::unique_ptr<Output> open(const std::string& path, DiagnosticSink& sink);

    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
    /// Discards what was not committed.
    ~Output();

    void write(std::string_view text);
    /// Replaces what was written at this byte and behind it; not more than was written.
    void overwrite(std::size_t at, std::string_view text);
    /// Puts the result in its place. False, with a message, if that fails (a full disk); what stood
    /// there before is then untouched.
    bool commit(DiagnosticSink& sink);

    const std::string& name() const { return name_; }
    bool is_standard_output() const { return name_ == "-"; }

  private:
    enum class Kind : std::uint8_t { File, Spool };
    Output(std::string name, Kind kind) : name_(std::move(name)), kind_(kind) {}

    void flush();
    bool copy_spool();
    bool move_draft();

    std::string name_;
    Kind kind_;
    std::string final_path_;            // File: symbolic links followed
    std::string draft_;                 // File: the neighbour's name
    bool is_nameless_ = false;          // … which it gets only at the end
    std::FILE* stream_ = nullptr;       // File: the neighbour; Spool: where memory ends
    std::FILE* destination_ = nullptr;  // Spool
    std::string buffer_;
    bool failed_ = false;
};

}  // namespace kadr::driver
