// skipped.cpp — blocks that the operator may leave out: what cannot stand in one.
//
// What is left of such a block behind it belongs to one of three kinds. Modal codes, F and S are
// written again by the output (expand/unknown.cpp, write/again.cpp); the spindle, the coolant and
// M functions are the operator's choice; the rest is refused here.
#include "sema/skipped.h"

#include "base/diagnostics/sema.h"
#include "nc/frame_words.h"
#include "sema/checking.h"

namespace kadr::sema {

/// What stands behind a block that the operator may leave out must mean the same with and without
/// it; a frame or a tool that is there or not changes all of it.
void check_passed_text(Check& check, const Plan& plan, std::span<const syntax::Word> words) {
    for (const nc::Invocation& invocation : plan.functions) {
        if (!nc::has_fact(invocation.function, nc::Fact::LeavesUnstated)) continue;
        check.report(diag::SkipState, words[0].range).arg(nc::info(invocation.function).name);
        return;
    }
}

}  // namespace kadr::sema
