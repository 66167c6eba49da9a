#include "sema/scopes.h"

#include <utility>

namespace kadr::sema {

Scopes::Outer Scopes::enter(const SourceRange& range) {
    return {symbols_.size(), std::exchange(begin_, symbols_.size()),
            std::exchange(end_, range.end)};
}

void Scopes::leave(const Outer& outer) {
    while (symbols_.size() > outer.size) {
        visible_[symbols_.back().name].pop_back();
        symbols_.pop_back();
    }
    while (!varying_.empty() && varying_.back() >= symbols_.size()) varying_.pop_back();
    begin_ = outer.begin;
    end_ = outer.end;
}

void Scopes::begin_function(std::uint32_t end) { leave({0, 0, end}); }

std::int32_t Scopes::find(std::string_view name) const {
    const auto found = visible_.find(name);
    return found == visible_.end() || found->second.empty() ? kNone : found->second.back();
}

std::int32_t Scopes::add(const Symbol& symbol, bool varies) {
    const auto index = static_cast<std::int32_t>(symbols_.size());
    visible_[symbol.name].push_back(index);
    if (varies) varying_.push_back(static_cast<std::uint32_t>(index));
    symbols_.push_back(symbol);
    return index;
}

void Scopes::hide(std::string_view name) { visible_[name].pop_back(); }

void Scopes::show(std::int32_t index) { visible_[(*this)[index].name].push_back(index); }

// Only of what can be without a value: at each branch, all variables would be looked at.

FlowState Scopes::flow() const {
    FlowState state;
    state.reserve(varying_.size());
    for (const std::uint32_t i : varying_) state.push_back(symbols_[i].givenness);
    return state;
}

void Scopes::set_flow(const FlowState& state) {
    for (std::size_t i = 0; i < varying_.size() && i < state.size(); ++i)
        symbols_[varying_[i]].givenness = state[i];
}

void Scopes::join_flow(const FlowState& other) {
    for (std::size_t i = 0; i < varying_.size() && i < other.size(); ++i) {
        Givenness& now = symbols_[varying_[i]].givenness;
        if (now != other[i]) now = Givenness::Perhaps;
    }
}

void Scopes::join_into(FlowState& state) const {
    for (std::size_t i = 0; i < varying_.size() && i < state.size(); ++i) {
        if (state[i] != symbols_[varying_[i]].givenness) state[i] = Givenness::Perhaps;
    }
}

void Scopes::forget_flow() {
    for (const std::uint32_t i : varying_) {
        Symbol& symbol = symbols_[i];
        if (symbol.may_be_unset || symbol.is_optional) symbol.givenness = Givenness::Perhaps;
    }
}

}  // namespace kadr::sema
