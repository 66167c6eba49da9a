// scopes.h — the local names of a function: which can be used where the checker is, and what is
// known of each.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "sema/names.h"

namespace kadr::sema {

/// What is known of every name that can be without a value, in the order of their declarations.
using FlowState = std::vector<Givenness>;

class Scopes {
  public:
    static constexpr std::int32_t kNone = -1;

    /// What `leave` goes back to.
    struct Outer {
        std::size_t size = 0;
        std::size_t begin = 0;
        std::uint32_t end = 0;
    };
    /// A scope that ends where the range ends.
    Outer enter(const SourceRange& range);
    void leave(const Outer& outer);
    /// Forgets everything; a function begins, whose text ends at this byte.
    void begin_function(std::uint32_t end);

    std::int32_t find(std::string_view name) const;
    Symbol& operator[](std::int32_t index) { return symbols_[static_cast<std::size_t>(index)]; }
    const Symbol& operator[](std::int32_t index) const {
        return symbols_[static_cast<std::size_t>(index)];
    }
    /// All that are visible, outer ones first.
    std::span<Symbol> all() { return symbols_; }
    std::span<const Symbol> all() const { return symbols_; }
    /// Those that have been declared since a scope was entered.
    std::span<const Symbol> since(const Outer& outer) const {
        return std::span(symbols_).subspan(outer.size);
    }
    bool is_of_innermost(std::int32_t index) const {
        return static_cast<std::size_t>(index) >= begin_;
    }
    /// Where the innermost scope ends, a byte of its file.
    std::uint32_t end() const { return end_; }

    /// `varies`: it can be without a value.
    std::int32_t add(const Symbol& symbol, bool varies);
    /// A parameter cannot be named before its turn has come.
    void hide(std::string_view name);
    void show(std::int32_t index);

    FlowState flow() const;
    void set_flow(const FlowState& state);
    /// Two ways meet: what only one of them knows is not known.
    void join_flow(const FlowState& other);
    /// … for a state that is kept.
    void join_into(FlowState& state) const;
    /// A loop begins: its body may run again after what stands below has been assigned.
    void forget_flow();

  private:
    std::vector<Symbol> symbols_;         // visible ones, innermost last
    std::vector<std::uint32_t> varying_;  // of the symbols: may be without a value
    std::unordered_map<std::string_view, std::vector<std::int32_t>> visible_;  // innermost last
    std::size_t begin_ = 0;  // first symbol of the innermost scope
    std::uint32_t end_ = 0;
};

}  // namespace kadr::sema
