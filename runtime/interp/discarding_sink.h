// discarding_sink.h — a sink for what nobody is to be told. Internal to interp.
#pragma once

#include "base/diagnostic.h"

namespace kadr::interp {

class DiscardingSink final : public DiagnosticSink {
  public:
    void take(Diagnostic) override {}
};

}  // namespace kadr::interp
