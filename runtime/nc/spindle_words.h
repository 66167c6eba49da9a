// spindle_words.h — words that name a spindle where the program has chosen which one is the master.
#pragma once

#include "nc/lexer.h"
#include "nc/reading_modes.h"

namespace kadr::nc {

/// Words that name the first spindle become words of the master while it is that, and words with a
/// number while another one is: `S1=500` and `S500`. Returns whether there are any.
bool name_spindles(const DialectTables& tables, const ReadingModes& modes, LexedLine& words);

}  // namespace kadr::nc
