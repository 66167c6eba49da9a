#include "interp/state.h"

namespace kadr::interp {

using nc::Function;

void Modal::set_path_mode(Function function) {
    has_exact_stop = function == Function::ExactStop;
    taps = function == Function::TappingMode;
    blend = blend_of(function);
}

}  // namespace kadr::interp
