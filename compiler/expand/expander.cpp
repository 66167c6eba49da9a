#include "expand/expander.h"

#include "base/assert.h"
#include "expand/state.h"

namespace kadr::expand {

Expander::Expander(const sema::Code& code, const nc::Dialect& target, const ExpandOptions& options,
                   DiagnosticSink& sink)
    : state_(std::make_unique<State>(code, target, options, sink)) {}

Expander::~Expander() = default;

Done Expander::start(std::string_view program, const std::vector<sema::Define>& defines) {
    return state_->start(program, defines);
}

Done Expander::start_cycle(std::string_view cycle, std::span<const double> arguments,
                           std::uint32_t given, const Surroundings& at) {
    return state_->start_cycle(cycle, arguments, given, at);
}

void Expander::start_test(std::uint32_t function, std::span<const sema::Slot> values,
                          TestBench& bench) {
    state_->start_test(function, values, bench);
}

std::optional<std::vector<sema::Slot>> Expander::read_values(
    std::uint32_t function, const std::vector<sema::Define>& defines) {
    return state_->read_values(function, defines);
}

void Expander::start_call(const CallUnderTest& call) { state_->start_call(call); }

void Expander::warn_of_cuts(decltype(ExpandOptions::is_allowed) is_allowed) {
    state_->options.warns_of_cuts = true;
    state_->options.is_allowed = std::move(is_allowed);
}

std::size_t Expander::pull(std::span<nc::Block> out) { return state_->pull(out); }

bool Expander::failed() const { return state_->has_failed; }

bool Expander::rejected() const { return state_->is_rejected; }

const ModalState* Expander::known() const {
    return state_->waiting.empty() ? &state_->modal : nullptr;
}

const BlockOrigin& Expander::trace(std::size_t i) const {
    KADR_ASSERT(i < state_->traces.size(), "a trace was asked for without ExpandOptions::trace");
    return state_->traces[i];
}

}  // namespace kadr::expand
