// shape_calls.h — cycles that work along a shape: its blocks come next, wherever they
// stand in the program or in another one.
#pragma once

#include "macro/named_shape.h"
#include "macro/outcome.h"
#include "macro/program_frame.h"

namespace kadr::macro {

class ProgramRun;

class ShapeCalls {
  public:
    /// run  outlives it
    explicit ShapeCalls(ProgramRun& run) : run_(run) {}

    /// A cycle that is called behind motions and names the program of its shape.
    bool has_modal() const { return modal_.has_value(); }
    /// The shape of the cycle that the block calls comes next.
    void follow(const nc::Block& block, std::string_view text, const ProgramLine& line);
    /// … of the modal one, if the block moves an axis.
    void follow_modal(const nc::Block& block);

  private:
    /// A cycle that is called behind motions and names the program of its shape.
    struct ModalShape {
        nc::Block block;
        std::string text;
        ProgramLine program_line;
    };
    void keep_modal_shape(const nc::Block& block, std::string_view text, const ProgramLine& line);
    NamedContour contour_of(const nc::Block& block) const;
    void follow_named_shape(const nc::Block& block, std::string_view text, const ProgramLine& line);

    ProgramRun& run_;
    std::optional<ModalShape> modal_;
    std::optional<NamedContour> named_;
};

}  // namespace kadr::macro
