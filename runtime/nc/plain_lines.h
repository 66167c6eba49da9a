// plain_lines.h — lines of plain codes and numbers behind letters, as nearly all lines of a text
// are: read in one pass, without their words being kept.
//
// What needs a second look is left to the lexer and the forms.
#pragma once

#include <array>
#include <bitset>
#include <string_view>
#include <vector>

#include "nc/block.h"
#include "nc/point_watch.h"
#include "nc/reading_modes.h"

namespace kadr::nc {

class PlainLines {
  public:
    /// References outlive it.
    ///
    /// points  is given positions with a decimal point
    PlainLines(const DialectTables& tables, const ReadingModes& modes, PointWatch& points);

    /// Puts the line into the block, which is empty before. Gives up, without a word and with a
    /// block that is to be reset, on anything that is not plain.
    bool read(std::string_view line, Block& block) const;

  private:
    /// What a word means by its address alone.
    struct PlainWord {
        enum class Kind : std::uint8_t { None, Slot, Code, Number };
        Kind kind = Kind::None;
        Slot slot = Slot::X;
        AddressId address = kNoAddress;
        Dimension dimension = Dimension::Number;
        const NumberFormat* format = nullptr;
        bool is_position = false;  // where a number without a point counts in increments
        bool is_literal = false;   // a number is literal, and the control takes every one
    };
    /// A word of several letters, `CR=5`.
    struct PlainName {
        std::string_view name;
        PlainWord word;
    };

    bool are_of_motions(const Address& address);
    PlainWord word_of(AddressId id);
    void prepare_letter(std::size_t letter);
    void prepare_names();
    const PlainWord* named_word(const char*& p, const char* end) const;

    const DialectTables& tables_;
    const ReadingModes& modes_;
    PointWatch& points_;
    std::array<PlainWord, 128> letters_;
    std::vector<PlainName> names_;          // by name
    std::bitset<kFunctions> closely_read_;  // modes under which words have other meanings
};

}  // namespace kadr::nc
