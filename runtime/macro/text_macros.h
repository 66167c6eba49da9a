// text_macros.h — words that a program has made stand for text.
//
// They are put in before a line is read, so nothing behind knows of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "macro/replaced_text.h"
#include "nc/tables.h"

namespace kadr::macro {

class TextMacros {
  public:
    enum class Fault : std::uint8_t { None, Form, Nested, Known };

    bool is_empty() const { return macros_.empty(); }
    /// Takes what stands behind the word that defines: `LIGHT AS M8`. Form: it is no name, AS and
    /// text. Nested: the text holds another such word. Known: the word stands for another text
    /// already; the same text once more, in a section that is repeated, is none.
    /// source  S 1.5, 1.7
    Fault define(const nc::DialectTables& tables, std::string_view definition);
    /// The line with the text of every such word outside comments and texts; nothing: it has none.
    std::optional<ReplacedText> expanded(const nc::DialectTables& tables,
                                         std::string_view line) const;

  private:
    struct Macro {
        std::string name;
        std::string text;
    };
    std::vector<Macro> macros_;
};

}  // namespace kadr::macro
