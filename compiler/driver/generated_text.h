// generated_text.h — a checked program as ISO-7bit text, piece by piece.
//
// The half of the road that a compiler is: evaluate → write. `kadr expand` copies the pieces to a
// file, `kadr run` feeds them to the reader.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "driver/deadline.h"
#include "driver/line_map.h"
#include "driver/output.h"
#include "driver/program.h"
#include "expand/expander.h"
#include "nc/reader.h"
#include "nc/writer.h"

namespace kadr::driver {

class GeneratedText final : public nc::TextSource {
  public:
    /// All references outlive the text. `map` gets a line for every block; null: no source map.
    GeneratedText(Session& session, const Program& program, const nc::Dialect& target, Output* map);
    ~GeneratedText() override;

    /// Chooses the program and sets its parameters. False: reported.
    bool start();

    std::string_view next() override;

    /// Whether evaluating or writing came to an error.
    bool failed() const;
    const LineMap& lines() const { return *line_map_; }
    std::uint64_t blocks() const { return blocks_; }

  private:
    void write_batch();
    void map_block(std::size_t index, std::uint32_t line);
    SourceRange last_statement() const;

    Session& session_;
    const Program& program_;
    expand::Expander expander_;
    nc::Writer writer_;
    Output* map_;
    std::unique_ptr<LineMap> line_map_;
    std::vector<nc::Block> batch_;
    std::string text_;
    std::string entry_;
    std::uint64_t blocks_ = 0;
    Deadline deadline_;
    bool is_late_ = false;
    SourceId last_source_;
    bool is_at_end_ = false;
};

/// The program of the file that is run: the one with this name, or the first if none is asked for.
/// Null if there is none.
const sema::FunctionCode* chosen_program(const sema::Code& code, std::string_view name);

}  // namespace kadr::driver
