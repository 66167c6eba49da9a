// preserves.cpp — holds every path through a cycle to what its `preserves` promises.
//
// Follows the modal groups that are named through the statements: after each one, which words can
// have set a group last. On every way out that must be the member that the cycle names, or nothing.
// What cannot be decided here (another cycle's doing, raw text) is left to the running program.
#include "sema/preserves.h"

#include <algorithm>
#include <map>

#include "base/diagnostics/sema.h"
#include "nc/frame_words.h"
#include "sema/block_words.h"
#include "sema/checking.h"
#include "sema/with.h"

namespace kadr::sema {

using syntax::Expr;
using syntax::ExprId;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtId;
using syntax::StmtKind;

namespace {

/// A word that sets a group.
struct Setter {
    nc::Function function = nc::Function::None;
    SourceRange range;
};

/// Who can have set each group last, by the group's bit; groups without an entry are as found.
struct Flow {
    bool is_reached = true;
    std::map<ModalMask, std::vector<Setter>> setters;
};

void join(Flow& into, const Flow& other) {
    if (!other.is_reached) return;
    if (!into.is_reached) {
        into = other;
        return;
    }
    for (const auto& [bit, setters] : other.setters) {
        std::vector<Setter>& mine = into.setters[bit];
        for (const Setter& setter : setters) {
            const bool known = std::any_of(
                mine.begin(), mine.end(), [&](const Setter& s) { return s.range == setter.range; });
            if (!known) mine.push_back(setter);
        }
    }
}

}  // namespace

class PreservesCheck {
  public:
    explicit PreservesCheck(Check& check) : check_(check) {}

    /// The flow at the end of a body, joined over all ways out.
    Flow follow(const FunctionDecl& function) {
        const std::uint32_t module = std::exchange(check_.here.module, function.module);
        Flow flow;
        Flow out;
        out.is_reached = false;
        std::swap(out, out_);
        std::vector<LoopFlow> loops;
        std::swap(loops, loops_);
        walk(check_.ast()[function.decl].body, flow);
        std::swap(loops, loops_);
        std::swap(out, out_);
        join(out, flow);
        check_.here.module = module;
        return out;
    }

  private:
    struct LoopFlow {
        bool is_switch = false;
        std::size_t with_depth = 0;
        Flow on_break;
        Flow on_continue;
    };

    void set(Flow& flow, ModalMask bit, Setter setter) { flow.setters[bit] = {setter}; }

    void apply(Flow& flow, nc::Function function, const SourceRange& range) {
        if (nc::has_fact(function, nc::Fact::ChangesFrame)) {
            set(flow, kFrameBit, {function, range});
            return;
        }
        const nc::Group group = nc::info(function).group;
        if (group != nc::Group::NonModal) set(flow, group_bit(group), {function, range});
    }

    void words(const Stmt& stmt, Flow& flow) {
        for (const syntax::Word& word : check_.ast().word_run(stmt.words)) {
            const auto plan = plan_words(check_, {&word, 1});
            if (!plan) continue;
            if (plan->block.motion != nc::Function::None)
                apply(flow, plan->block.motion, word.range);
            for (std::size_t i = 0; i < plan->block.function_count; ++i) {
                apply(flow, plan->block.functions[i].function, word.range);
            }
        }
    }

    void calls(ExprId id, Flow& flow) {
        if (!id.is_valid()) return;
        const Expr& expr = check_.ast()[id];
        for (const ExprId child : expr.child) calls(child, flow);
        for (const ExprId child : check_.ast().exprs(expr.list)) calls(child, flow);
        if (expr.kind != ExprKind::Call || check_.ast()[expr.child[0]].kind != ExprKind::Name)
            return;
        const std::string_view name = check_.text(check_.ast()[expr.child[0]].text);
        const Name* found = check_.names.find(check_.here.module, name);
        if (found == nullptr) {
            if (const auto function = nc::find_function(name)) apply(flow, *function, expr.range);
            return;
        }
        if (found->what != Name::What::Function) return;
        const FunctionDecl& callee = check_.names.function(found->index);
        if (std::find(open_.begin(), open_.end(), found->index) != open_.end()) return;
        open_.push_back(found->index);
        const Flow after = follow(callee);
        open_.pop_back();
        for (const auto& [bit, setters] : after.setters) {
            // In the caller's eyes the call is what set it.
            for (const Setter& setter : setters) {
                flow.setters[bit].push_back({setter.function, expr.range});
            }
        }
    }

    void body(StmtId id, Flow& flow, bool may_skip) {
        // Twice: what the end of one pass leaves is there at the beginning of the next.
        loops_.push_back({});
        loops_.back().with_depth = restored_.size();
        loops_.back().on_break.is_reached = false;
        loops_.back().on_continue.is_reached = false;
        const Flow before = flow;
        for (int turn = 0; turn < 2; ++turn) {
            walk(id, flow);
            join(flow, loops_.back().on_continue);
        }
        if (may_skip) join(flow, before);
        join(flow, loops_.back().on_break);
        loops_.pop_back();
    }

    void list(syntax::List statements, Flow& flow) {
        for (const StmtId id : check_.ast().stmts(statements)) walk(id, flow);
    }

    void with(const Stmt& stmt, Flow& flow) {
        // Whatever it sets is set back on every way out: the groups of its head are as before.
        const Flow before = flow;
        const ModalMask mask = with_mask(check_, stmt);
        restored_.push_back({mask, before});
        for (ModalMask bit = 1; bit != 0; bit <<= 1) {
            if ((mask & bit) != 0) flow.setters.erase(bit);
        }
        walk(stmt.statement[0], flow);
        restored_.pop_back();
        restore(flow, mask, before);
    }

    static void restore(Flow& flow, ModalMask mask, const Flow& before) {
        for (ModalMask bit = 1; bit != 0; bit <<= 1) {
            if ((mask & bit) == 0) continue;
            const auto found = before.setters.find(bit);
            if (found == before.setters.end()) flow.setters.erase(bit);
            else flow.setters[bit] = found->second;
        }
    }

    void leave(Flow& flow, Flow& target, std::size_t with_depth) {
        Flow out = flow;
        for (std::size_t i = restored_.size(); i-- > with_depth;) {
            restore(out, restored_[i].mask, restored_[i].before);
        }
        join(target, out);
        flow.is_reached = false;
    }

    void walk(StmtId id, Flow& flow) {
        if (!id.is_valid() || !flow.is_reached) return;
        const Stmt& stmt = check_.ast()[id];
        for (const ExprId expression : stmt.expression) {
            if (stmt.kind != StmtKind::For && stmt.kind != StmtKind::DoWhile)
                calls(expression, flow);
        }
        switch (stmt.kind) {
            case StmtKind::Block: list(stmt.statements, flow); break;
            case StmtKind::Declaration: calls(check_.ast()[stmt.declaration].value, flow); break;
            case StmtKind::If: {
                Flow other = flow;
                walk(stmt.statement[0], flow);
                walk(stmt.statement[1], other);
                join(flow, other);
                break;
            }
            case StmtKind::While: body(stmt.statement[0], flow, true); break;
            case StmtKind::DoWhile: body(stmt.statement[0], flow, false); break;
            case StmtKind::For:
                walk(stmt.statement[0], flow);
                body(stmt.statement[1], flow, true);
                break;
            case StmtKind::ForEach: body(stmt.statement[0], flow, true); break;
            case StmtKind::Switch: {
                loops_.push_back({});
                loops_.back().is_switch = true;
                loops_.back().with_depth = restored_.size();
                loops_.back().on_break.is_reached = false;
                const Flow before = flow;
                flow.is_reached = false;
                for (const StmtId entry : check_.ast().stmts(stmt.statements)) {
                    join(flow, before);
                    list(check_.ast()[entry].statements, flow);
                }
                join(flow, before);
                join(flow, loops_.back().on_break);
                loops_.pop_back();
                break;
            }
            case StmtKind::Break:
                if (!loops_.empty()) leave(flow, loops_.back().on_break, loops_.back().with_depth);
                break;
            case StmtKind::Continue:
                for (std::size_t i = loops_.size(); i-- > 0;) {
                    if (loops_[i].is_switch) continue;
                    leave(flow, loops_[i].on_continue, loops_[i].with_depth);
                    break;
                }
                break;
            case StmtKind::Return: leave(flow, out_, 0); break;
            case StmtKind::ErrorStmt: flow.is_reached = false; break;
            case StmtKind::Words: words(stmt, flow); break;
            case StmtKind::With: with(stmt, flow); break;
            default: break;
        }
    }

    struct Restored {
        ModalMask mask = 0;
        Flow before;
    };

    Check& check_;
    Flow out_;
    std::vector<LoopFlow> loops_;
    std::vector<Restored> restored_;
    std::vector<std::uint32_t> open_;  // functions that are being followed
};

std::vector<nc::Function> preserved_members(Check& check, const syntax::Decl& decl) {
    const DryRun dry_run(check);  // words_mask has reported it
    std::vector<nc::Function> members;
    for (const syntax::Word& word : check.ast().word_run(decl.preserves)) {
        if (named_state(check, word) != 0) continue;
        if (const auto plan = plan_words(check, {&word, 1}); plan) {
            if (plan->block.motion != nc::Function::None) {
                members.push_back(plan->block.motion);
            } else if (plan->block.function_count > 0) {
                members.push_back(plan->block.functions[0].function);
            }
        }
    }
    return members;
}

void check_preserves(Check& check, const FunctionDecl& function, const syntax::Decl& decl) {
    std::optional<DryRun> dry_run(check);  // the words were reported where they are planned
    const Flow flow = PreservesCheck(check).follow(function);
    std::map<ModalMask, nc::Function> promised;
    std::map<ModalMask, std::string> names;
    for (const syntax::Word& word : check.ast().word_run(decl.preserves)) {
        const ModalMask mask = words_mask(check, {&word, 1}, true);
        if (mask == 0) continue;
        names[mask] = mask == kFrameBit ? "frames" : word_text(check, word);
        promised[mask] = nc::Function::None;
        if (named_state(check, word) != 0) continue;
        if (const auto plan = plan_words(check, {&word, 1}); plan) {
            promised[mask] = plan->block.motion != nc::Function::None ? plan->block.motion
                             : plan->block.function_count > 0 ? plan->block.functions[0].function
                                                              : nc::Function::None;
        }
    }
    dry_run.reset();
    for (const auto& [bit, member] : promised) {
        const auto found = flow.setters.find(bit);
        if (found == flow.setters.end()) continue;
        for (const Setter& setter : found->second) {
            if (setter.function == member && bit != kFrameBit) continue;
            check.report(diag::PreservesBroken, setter.range)
                .arg(function.name)
                .arg(names[bit])
                .arg(nc::info(setter.function).name)
                .note(decl.name_range, "it promises `preserves " + names[bit] + "` here")
                .fix("put it into `with … { }`, which sets it back on every way out");
            break;
        }
    }
}

}  // namespace kadr::sema
