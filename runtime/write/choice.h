// choice.h — which form writes each function of a block: what a form needs, what must not act
// beside it, and why none fits.
#pragma once

#include <array>
#include <bit>
#include <span>
#include <string>

#include "write/messages.h"
#include "write/text_state.h"
#include "write/writer.h"

namespace kadr::write {

/// The forms of one block's functions, in their order.
struct Choice {
    std::array<FormId, kMaxInvocations> forms = none();
    std::uint32_t done = 0;  // functions that need no word, or none any more; a bit each

    bool is_done(std::size_t i) const { return (done >> i & 1u) != 0; }
    /// Whether the function has still to be written.
    bool is_open(std::size_t i) const { return !is_done(i) && forms[i] != kNoForm; }
    void finish(std::size_t i) { done |= 1u << i; }
    /// The block does without the code; what it means for the blocks behind it holds.
    void drop(const Block& block, Function function) {
        for (std::size_t i = 0; i < block.function_count; ++i) {
            if (block.functions[i].function != function) continue;
            finish(i);
            forms[i] = kNoForm;
        }
    }

  private:
    static constexpr std::array<FormId, kMaxInvocations> none() {
        std::array<FormId, kMaxInvocations> forms{};
        forms.fill(kNoForm);
        return forms;
    }
};

class FormChooser {
  public:
    FormChooser(TextState& state, BlockMessages& messages, const WriteOptions& options)
        : state_(state),
          text_(state.view()),
          modal_(state.modal()),
          tables_(text_.tables),
          messages_(messages),
          options_(options) {}

    /// Reports functions that no form can write.
    Choice choose(const Block& block);
    /// Whether the function acts in the text already, and is not written again.
    bool is_suppressed(Function function) const;
    bool holds(const Form& form, const Block& block, Function asked, bool allow_unknown) const;

  private:
    /// What a form cannot write, or lacks.
    struct Misfit {
        std::uint32_t parameters = 0;     // a bit each
        std::uint32_t lacking = 0;        // those of them that were not given
        Function state = Function::None;  // the form needs it active, and it is not
        bool is_none() const { return parameters == 0 && state == Function::None; }
        int count() const { return std::popcount(parameters) + (state != Function::None ? 32 : 0); }
    };

    FormId choose_form(const Block& block, const Invocation& invocation);
    Misfit misfit(const Form& form, const Block& block, const Invocation& invocation) const;
    static std::string misfit_words(std::span<const Parameter> parameters, const Misfit& misfit);
    void note_refusal(const Form& form, const Block& block, const Invocation& invocation,
                      const Misfit& misfit) const;
    bool is_left_to_machine(const Invocation& invocation) const;
    void leave_to_machine(const Block& block, const Invocation& invocation);
    static bool ends_by_itself(const Form& form, const Block& block, Function around);
    Function acting_around(const Form& form, const Block& block) const;

    TextState& state_;
    const TextView& text_;
    const WriterModal& modal_;
    const DialectTables& tables_;
    BlockMessages& messages_;
    const WriteOptions& options_;
};

}  // namespace kadr::write
