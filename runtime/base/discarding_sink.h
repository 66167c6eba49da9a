// discarding_sink.h — a sink for what is not to be reported.
#pragma once

#include "base/diagnostic.h"

namespace kadr {

class DiscardingSink final : public DiagnosticSink {
  public:
    void take(Diagnostic) override {}
};

}  // namespace kadr
