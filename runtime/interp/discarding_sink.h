// discarding_sink.h — a sink for what is not to be reported. Internal to interp.
#pragma once

#include "base/diagnostic.h"

namespace kadr::interp {

class DiscardingSink final : public DiagnosticSink {
  public:
    void take(Diagnostic) override {}
};

}  // namespace kadr::interp
