// nc_testing.h — what the tests of the nc room share: the shipped dialects, and blocks from text.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/render.h"
#include "nc/dialect.h"
#include "nc/reader.h"

namespace kadr::nc::testing {

inline const SearchPath& dialect_folders() {
    static const SearchPath folders = {KADR_ROOT "/dialects"};
    return folders;
}

/// A shipped dialect, loaded once. Ends the tests with its messages if it has mistakes.
const Dialect& shipped(const std::string& name);

/// Everything in the list as a person reads it.
std::string rendered(const DiagnosticList& list, const Sources& sources);
/// The codes of the messages: "K4101 K4103".
std::string codes(const DiagnosticList& list);

/// A source word, split as the parser does: `X10`, `CR=5`, `X=AC(3)`, `TRANS`.
SourceWord source_word(std::string_view text);

/// A block from a Kadr statement in the words of a dialect (`G1 X10 F200;`) or a command
/// (`dwell(time: 0.5s);`). Numbers go in as the evaluator would put them, for metric programs.
Block source_block(const Dialect& dialect, std::string_view statement);

/// A text in one piece that cannot be read again.
class OneText final : public TextSource {
  public:
    explicit OneText(std::string_view text) : text_(text) {}
    std::string_view next() override { return std::exchange(text_, {}); }

  private:
    std::string_view text_;
};

/// Blocks of a text, and what the reader said.
struct ReadText {
    std::vector<Block> blocks;
    DiagnosticList messages;
    bool failed = false;
};
ReadText read_blocks(const Dialect& dialect, std::string_view text);

}  // namespace kadr::nc::testing
