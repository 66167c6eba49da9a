#include "expand/expander.h"

#include "expand/running.h"
#include "expand/start.h"
#include "expand/tests.h"
#include "expand/vm.h"

namespace kadr::expand {

Expander::Expander(const sema::Code& code, const nc::Dialect& target, const ExpandOptions& options,
                   DiagnosticSink& sink)
    : run_(std::make_unique<Running>(code, target, options, sink)) {}

Expander::~Expander() = default;

Done Expander::start(std::string_view program, const std::vector<sema::Define>& defines) {
    return expand::start(*run_, program, defines);
}

Done Expander::start_cycle(std::string_view cycle, std::span<const double> arguments,
                           std::uint32_t given, const Surroundings& at) {
    return expand::start_cycle(*run_, cycle, arguments, given, at);
}

void Expander::start_test(std::uint32_t function, std::span<const sema::Slot> values,
                          TestBench& bench) {
    expand::start_test(*run_, function, values, bench);
}

std::optional<std::vector<sema::Slot>> Expander::read_values(
    std::uint32_t function, const std::vector<sema::Define>& defines) {
    return expand::read_values(*run_, function, defines);
}

void Expander::start_call(const CallUnderTest& call) { expand::start_call(*run_, call); }

void Expander::warn_of_cuts(decltype(ExpandOptions::is_allowed) is_allowed) {
    run_->options.warns_of_cuts = true;
    run_->options.is_allowed = std::move(is_allowed);
}

std::size_t Expander::pull(std::span<nc::Block> out) { return expand::pull(*run_, out); }

bool Expander::failed() const { return run_->status.has_failed(); }

bool Expander::rejected() const { return run_->test.is_rejected; }

const ModalState* Expander::known() const {
    return run_->batch.has_waiting() ? nullptr : &run_->modal;
}

const BlockOrigin& Expander::trace(std::size_t i) const { return run_->batch.origin(i); }

}  // namespace kadr::expand
