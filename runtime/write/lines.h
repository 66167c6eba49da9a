// lines.h — lines of the text: block numbers, skip levels, comments, line ends, their length.
//
// Knows nothing of what the words in a line mean.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "write/messages.h"

namespace kadr::write {

/// A blank in front of a word that is not the first of its line.
inline void blank(std::string& out) {
    const char last = out.empty() ? '\n' : out.back();
    if (last != ' ' && last != '\n' && last != '/') out += ' ';
}

class Lines {
  public:
    /// is_numbered  whether blocks get the numbers that the dialect gives
    Lines(const DialectTables& tables, bool is_numbered, BlockMessages& messages)
        : tables_(tables), is_numbered_(is_numbered), messages_(messages) {}

    /// greatest_number  that a block of the program brings; those that are counted lie above
    void begin(std::int64_t greatest_number);
    /// The next numbered line has this number of the program's own; below 0: a counted one.
    void bring_number(std::int32_t number) { given_number_ = number; }
    bool brings_number() const { return given_number_ >= 0; }
    /// Number of a block with which an operator may begin again; below 0: it has none of this kind.
    std::int32_t next_section();

    /// skip_level  level; below 0: the line is no optional one
    void open(int skip_level, bool has_number, std::string& out);
    /// The sign that the control wants behind the words of a block.
    void end_block(std::string& out) const;
    void close(std::string& out);

    /// A whole line of the program's frame.
    void write(std::string_view line, bool has_number, std::string& out);
    /// A comment in lines of its own.
    void write_comment(std::string_view comment, std::string& out);
    /// A comment behind the words of a block.
    void append_comment(std::string_view comment, std::string& out) const;

    std::uint32_t count() const { return count_; }
    std::size_t start() const { return start_; }  // of the line that is open, in the text so far

  private:
    void write_comment_line(std::string text, std::string& out);

    const DialectTables& tables_;
    const bool is_numbered_;
    BlockMessages& messages_;
    std::uint32_t count_ = 0;
    std::size_t start_ = 0;
    std::int64_t number_ = 0;         // of the next line
    std::int64_t sections_ = 0;       // that have a number
    std::int32_t given_number_ = -1;  // that the block brings, for its first line
};

}  // namespace kadr::write
