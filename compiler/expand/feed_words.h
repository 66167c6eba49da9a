// feed_words.h — what messages call the kinds of feed.
#pragma once

#include <string_view>

#include "nc/vocabulary.h"

namespace kadr::expand {

inline std::string_view feed_word(nc::Function mode) {
    switch (mode) {
        case nc::Function::FeedPerRevolution: return "feed per revolution";
        case nc::Function::FeedInverseTime: return "inverse time feed";
        default: return "feed per minute";
    }
}

inline const char* feed_code(nc::Function mode) {
    return mode == nc::Function::FeedPerRevolution ? "G95"
           : mode == nc::Function::FeedInverseTime ? "G93"
                                                   : "G94";
}

inline const char* feed_unit(nc::Function mode) {
    return mode == nc::Function::FeedPerRevolution ? "mm/rev"
           : mode == nc::Function::FeedInverseTime ? "1/min"
                                                   : "mm/min";
}

}  // namespace kadr::expand
