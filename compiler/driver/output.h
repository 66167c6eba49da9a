// output.h — a result that is written whole or not at all, however long it is.
//
// What is not committed leaves no trace.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/diagnostic.h"
#include "base/done.h"
#include "base/file_access.h"
#include "base/files.h"

namespace kadr::driver {

/// How much all outputs of a command together may hold. Any thread may ask.
class OutputLimit {
  public:
    explicit OutputLimit(std::uint64_t most) : most_(most) {}
    std::uint64_t most() const { return most_; }
    bool is_over() const { return written_.load(std::memory_order_relaxed) > most_; }
    /// Counts bytes that are to be written. False: they are too many.
    bool take(std::size_t bytes) {
        return written_.fetch_add(bytes, std::memory_order_relaxed) + bytes <= most_;
    }
    /// Whether nobody has yet reported that it is over: from here on it counts as reported. Asked
    /// by one thread.
    bool first_time_over() { return !std::exchange(is_reported_, true); }

  private:
    std::uint64_t most_;
    std::atomic<std::uint64_t> written_ = 0;
    bool is_reported_ = false;
};

/// What an output must not do; both may be null: nothing is asked.
struct OutputRules {
    const FileAccess* inputs = nullptr;  // what was read is not replaced
    OutputLimit* limit = nullptr;        // what is beyond it is not written
};

class Output {
  public:
    /// Prepares to write; `-` is standard output. Null, with a message, if the file cannot be
    /// written, or holds a file that was read. The rules outlive the output.
    static std::unique_ptr<Output> open(Files& files, const std::string& path, DiagnosticSink& sink,
                                        const OutputRules& rules = {});

    void write(std::string_view text);
    /// Replaces what was written at this byte and behind it; not more than was written.
    void overwrite(std::size_t at, std::string_view text);
    /// The run must not have read what stands there.
    Done require_no_source(DiagnosticSink& sink) const;
    /// Puts the result there. Not done if that fails (a full disk, or the run
    /// has read what stands there meanwhile); what stood there before is then untouched.
    Done commit(DiagnosticSink& sink);

    const std::string& name() const { return name_; }
    bool is_standard_output() const { return name_ == "-"; }

  private:
    Output(std::string name, const OutputRules& rules) : name_(std::move(name)), rules_(rules) {}

    void flush();

    std::string name_;
    OutputRules rules_;
    std::unique_ptr<FileWriter> file_;
    std::string buffer_;
};

}  // namespace kadr::driver
