// computed_words.h — words whose value, axis or code the program works out.
#pragma once

#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

class ComputedWords {
  public:
    /// run  outlives it
    explicit ComputedWords(ProgramRun& run) : run_(run) {}

    /// The words of a line as a block.
    Outcome read(CompiledLine& line, nc::Block& out);

  private:
    Outcome set_axes(CompiledLine& line);
    Outcome set_codes(CompiledLine& line);
    bool set_code(nc::LexedLine& words, std::size_t index, const std::string& code) const;
    Outcome let_axis_move_alone(CompiledLine& line, nc::Block& out);

    ProgramRun& run_;
    std::vector<nc::WordValue> values_;
    bool reported_separate_ = false;  // that axes move each by itself
};

}  // namespace kadr::macro
