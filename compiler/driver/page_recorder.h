// page_recorder.h — looks on while a program runs, and keeps what its page shows.
#pragma once

#include <memory>
#include <string>

#include "driver/execution.h"
#include "driver/output.h"
#include "driver/session.h"
#include "plot/page.h"
#include "plot/page_trace.h"

namespace kadr::driver {

class PageRecorder {
  public:
    /// Null: there is no template, which was reported. All references outlive the recorder.
    static std::unique_ptr<PageRecorder> open(Session& session);

    /// Asks for the text that is made, or read from where it cannot be read again.
    void look_on(Aside& aside);
    /// The execution that is looked at.
    void follow(const Execution& execution);

    /// In the thread that executes; the line of the segment is that of its block.
    void add(const motion::Segment& segment);
    void add(const motion::Setpoint& setpoint) { trace_->add(setpoint); }

    /// Behind the last setpoint.
    void write(const plot::PageHead& head, Output& out);

  private:
    PageRecorder(Session& session, std::string page) : session_(session), page_(std::move(page)) {}
    plot::PageLocation source_location(SourceId source);
    void read_texts();

    Session& session_;
    std::string page_;
    const Execution* execution_ = nullptr;
    plot::PageTexts texts_;
    std::string made_;  // ISO-7bit text as it came by, before its name is known
    std::unique_ptr<plot::PageTrace> trace_;
    plot::PageBlock block_;  // of the latest segment
    std::uint32_t line_ = 0;
    SourceId statement_;
    bool has_block_ = false;
};

}  // namespace kadr::driver
