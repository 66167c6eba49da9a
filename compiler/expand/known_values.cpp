#include "expand/known_values.h"

namespace kadr::expand {

void CompensationInUse::choose(nc::Function side, int skip_level, SourceId source) {
    if (skip_level < 0) {
        without_ = side;
        choice_ = kNoChoice;
        return;
    }
    if (choice_ != kNoChoice && choice_ != skip_level) choice_ = kSeveralLevels;
    else choice_ = side == without_ ? kNoChoice : skip_level;
    by_ = source;
}

}  // namespace kadr::expand
