// words.h — the words of one line, with their numbers: forms of functions, axis words, held-back
// words.
//
// Appends what it is given; what a line has, and in which order, is items.h. What the words mean
// stays with the text (text_state.h).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "write/items.h"
#include "write/messages.h"
#include "write/targets.h"
#include "write/text_state.h"

namespace kadr::write {

class Words {
  public:
    Words(TextState& state, BlockMessages& messages)
        : state_(state),
          text_(state.view()),
          modal_(state.modal()),
          tables_(text_.tables),
          messages_(messages) {}

    /// The offset in words that a tool change held back.
    void set_held_offset(double offset) { held_offset_ = offset; }

    void append_item(const Block& block, const Item& item, const Targets& targets,
                     std::string& out);
    /// remembers  whether the control keeps the values, so that only those that change are written
    void append_words(const Block& block, std::span<const FormWord> words,
                      const Invocation* invocation, bool remembers, std::string& out);
    void append_slot(const Block& block, Slot slot, const Targets& targets, std::string& out);

  private:
    void append_verbatim(const Block& block, const Form& form, const Invocation& invocation,
                         std::string& out);
    void append_edge(const Block& block, int edge, std::string& out);
    void append_word(const Block& block, const FormWord& word, const Invocation* invocation,
                     std::string& out);
    void append_call(const Block& block, const FormWord& word, const Invocation* invocation,
                     std::string& out);
    void append_work_offset(const Block& block, std::string& out);
    void append_lettered(const Block& block, const FormWord& word, const Invocation* invocation,
                         std::string& out);
    std::size_t word_slot(const Block& block, Slot slot) const;
    void append_quantity(const Block& block, const FormWord& word, const NumberFormat& format,
                         std::string_view name, std::string& out);
    void append_parameter(const Block& block, const FormWord& word, const Invocation* invocation,
                          const NumberFormat& format, std::string_view name, std::string& out);
    void append_whole(const Block& block, const FormWord& word, double value,
                      const Invocation* invocation, std::string_view name, std::string& out);
    void append_both(const Block& block, const FormWord& word, double value,
                     const Invocation* invocation, std::string_view name, std::string& out);
    void append_factor(const Block& block, double number, bool in_thousandths,
                       const NumberFormat& address, std::string_view name, std::string& out);
    void append_text(const Block& block, std::string& out);
    void check_rounding(const Block& block, double number, int places, Dimension dimension,
                        std::string_view name);

    TextState& state_;
    const TextView& text_;
    const WriterModal& modal_;
    const DialectTables& tables_;
    BlockMessages& messages_;
    double held_offset_ = 0;
};

}  // namespace kadr::write
