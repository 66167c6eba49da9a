#include "nc/matched_line.h"

#include <algorithm>

namespace kadr::nc {

void MatchedLine::keep(const DialectTables& tables, const ControlLine& compiled,
                       const ModalFunctions& modal, const Block& block, const Match& match) {
    is_valid_ = !compiled.words.words.empty() &&
                std::ranges::all_of(compiled.computed, [&](const ComputedValue& computed) {
                    if (computed.argument >= 0) return false;
                    const AddressId id = compiled.words.words[computed.word].address;
                    const Address& address = tables.addresses[id];
                    return address.kind == Address::Kind::Value && address.slot >= 0 &&
                           address.forms.empty() && tables.code_index[id].empty();
                });
    if (!is_valid_) return;
    before_ = modal;
    shape_ = block;
    claims_.assign(match.claims.begin(),
                   match.claims.begin() + static_cast<std::ptrdiff_t>(match.claim_count));
    forms_.assign(match.forms.begin(),
                  match.forms.begin() + static_cast<std::ptrdiff_t>(match.form_count));
}

void MatchedLine::recall(const LexedLine& words, Block& block, Match& match) const {
    block.skip_level = shape_.skip_level;
    block.further_skip_levels = shape_.further_skip_levels;
    block.number = shape_.number;
    block.motion = shape_.motion;
    block.incremental = shape_.incremental;
    block.absolute = shape_.absolute;
    block.x_measure = shape_.x_measure;
    block.rotary_approaches = shape_.rotary_approaches;
    block.cycle = shape_.cycle;
    block.function_count = shape_.function_count;
    block.argument_count = shape_.argument_count;
    std::copy_n(shape_.functions.begin(), shape_.function_count, block.functions.begin());
    std::copy_n(shape_.arguments.begin(), shape_.argument_count, block.arguments.begin());
    if (!words.comment.empty()) block.comment = words.comment;
    if (!words.text.empty()) block.text = words.text;
    std::ranges::copy(claims_, match.claims.begin());
    std::ranges::copy(forms_, match.forms.begin());
    match.claim_count = claims_.size();
    match.form_count = forms_.size();
}

}  // namespace kadr::nc
