// inspection.h — what can be seen of a run that stands: frames, their scopes, the variables of
// each. Nothing is evaluated before somebody asks for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "driver/debug/stop.h"
#include "driver/execution.h"

namespace kadr::driver {

class Inspection {
  public:
    /// Elements of a list that are given unless somebody asks for more.
    static constexpr std::size_t kElementsAtOnce = 100;

    explicit Inspection(const Session& session) : session_(session) {}
    void follow(Execution& execution) { execution_ = &execution; }

    /// The run stands; what was named before is forgotten.
    void begin(const Stop& stop);
    /// The innermost first: of a stop in front of a statement the functions of the Kadr program,
    /// then the programs of the control, else the other way round.
    const std::vector<StackFrame>& frames() const { return frames_; }
    /// Of a frame, by its index.
    std::vector<Scope> scopes(std::size_t frame);
    /// The variables of a scope or the parts of a value; of a list so many from there on.
    std::vector<Variable> variables(VariablesRef of, std::size_t first = 0,
                                    std::size_t most = kElementsAtOnce);
    /// Codes, feed, speed, tool, offsets and the positions.
    TraceState state() const;

  private:
    /// What a VariablesRef stands for.
    struct Named {
        std::size_t frame = 0;
        Scope::Kind kind = Scope::Kind::Locals;
        const sema::NamedVariable* variable = nullptr;  // null: the scope itself
        std::vector<std::uint32_t> path;                // to a part of it
    };
    /// What a frame stands for: a call of the Kadr program, or a level of the control's.
    struct Origin {
        expand::RunningCall call;
        std::size_t level = 0;
    };

    void add_functions(const Stop& stop);
    void add_programs(const Stop& stop);
    SourceRange statement_at(std::uint32_t instruction) const;
    VariablesRef name(Named named);
    Variable seen(const Named& at, std::string shown_name);
    std::vector<Variable> parts(const Named& of, std::size_t first, std::size_t most);
    std::vector<Variable> named_variables(const Named& scope);
    std::vector<Variable> control_variables(const Named& scope) const;
    std::vector<Variable> modal_variables(const Named& scope) const;

    const Session& session_;
    Execution* execution_ = nullptr;
    std::vector<StackFrame> frames_;
    std::vector<Origin> origins_;  // of the frames
    std::vector<Named> named_;     // by VariablesRef, from 1
};

}  // namespace kadr::driver
