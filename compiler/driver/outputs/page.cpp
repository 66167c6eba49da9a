// page.cpp — `--page`: the machine in motion beside its program, for a browser.
#include "plot/page.h"

#include <cstdlib>

#include "base/diagnostics/page.h"
#include "base/text.h"
#include "driver/outputs.h"
#include "plot/page_trace.h"

namespace kadr::driver {

namespace {

using plot::PageLocation;
using plot::PageTexts;

/// The template: of the environment's KADR_PAGE, else what was installed or built. Nothing, with a
/// message: it is not there, or it is none.
std::optional<std::string> page_template(Session& session) {
    const char* chosen = std::getenv("KADR_PAGE");
    const std::string name =
        chosen != nullptr && *chosen != '\0' ? chosen : session.share().page_template;
    auto page = session.files().read(name);
    if (!page) {
        session.messages().report(diag::PageTemplateMissing).arg(name);
        return std::nullopt;
    }
    if (const auto missing = plot::missing_in_template(*page)) {
        session.messages().report(diag::PageTemplateBroken).arg(name).arg(*missing);
        return std::nullopt;
    }
    return *std::move(page);
}

class PageOutput final : public RunOutput {
  public:
    explicit PageOutput(const OutputParts& parts) : session_(parts.session), file_(parts.file) {}
    Wants wants() const override { return {.segments = true, .setpoints = true}; }

    Done look_on(Aside& aside) override;
    Done follow(Execution& execution) override;
    void see_segment(const motion::Segment& segment) override;
    void see_setpoints(std::span<const motion::Setpoint> some) override {
        for (const motion::Setpoint& setpoint : some) trace_->add(setpoint);
    }
    void finish(const RunFigures& figures) override;

  private:
    PageLocation source_location(SourceId source);
    void read_texts();

    Session& session_;
    Output& file_;
    std::string page_;  // the template
    const Execution* execution_ = nullptr;
    PageTexts texts_;
    std::string made_;  // ISO-7bit text as it came by, before its name is known
    std::optional<plot::PageTrace> trace_;
    plot::PageBlock block_;  // of the latest segment
    std::uint32_t line_ = 0;
    SourceId statement_;
    bool has_block_ = false;
};

/// Asks for the text that is made, or read from where it cannot be read again.
Done PageOutput::look_on(Aside& aside) {
    constexpr std::size_t kMostText = 4'000'000;  // bytes; more than a page takes of it
    auto page = page_template(session_);
    if (!page) return kFailed;
    page_ = std::move(*page);
    aside.tap = [this](std::string_view piece) {
        if (made_.size() < kMostText) made_ += piece;
    };
    return kDone;
}

Done PageOutput::follow(Execution& execution) {
    execution_ = &execution;
    const machine::Machine& machine = execution.machine();
    trace_.emplace(machine, plot::most_page_samples(machine), plot::most_page_blocks());
    const KadrProgram* program = execution.program();
    if (program == nullptr) return kDone;
    const std::string name = session_.output_name(program->file);
    texts_.append(texts_.index_of(name, true), session_.sources().text(program->file));
    return kDone;
}

PageLocation PageOutput::source_location(SourceId source) {
    const SourceRange range = execution_->statement(source);
    if (!range.file.is_valid()) return {};
    const Sources& sources = session_.sources();
    const std::int32_t text = texts_.index_of(session_.output_name(range.file), true);
    if (texts_.all()[static_cast<std::size_t>(text)].text.empty())
        texts_.append(text, sources.text(range.file));
    return {text, sources.locate(range.file, range.begin).line};
}

void PageOutput::see_segment(const motion::Segment& segment) {
    const bool is_known = has_block_ && segment.line == line_ && segment.source == statement_;
    if (!is_known) {
        has_block_ = true;
        line_ = segment.line;
        statement_ = segment.source;
        const TextLocation location = execution_->location_of(segment.line);
        block_.source = source_location(segment.source);
        block_.iso = {texts_.index_of(location.file, false), location.line};
    }
    trace_->add(block_, segment);
}

/// The ISO-7bit texts, as far as they are not there yet.
void PageOutput::read_texts() {
    for (std::size_t i = 0; i < texts_.all().size(); ++i) {
        const PageTexts::Text& text = texts_.all()[i];
        if (text.is_kadr || !text.text.empty()) continue;
        const auto index = static_cast<std::int32_t>(i);
        if (text.name == execution_->text_name() && !made_.empty()) {
            texts_.append(index, made_);
        } else if (auto read = session_.files().read(text.name)) {
            std::string lines = *std::move(read);
            end_lines_with_feeds(lines);
            texts_.append(index, lines);
        }
    }
}

void PageOutput::finish(const RunFigures& figures) {
    plot::PageHead head;
    head.title = figures.source;
    head.subtitle = subtitle_of(figures, trace_->machine());
    head.warning = warning_of(figures);
    trace_->finish();
    texts_.index_of(execution_->text_name(), false);
    read_texts();
    file_.write(plot::page_html(page_, head, *trace_, texts_));
}

}  // namespace

std::unique_ptr<RunOutput> make_page(const OutputParts& parts) {
    return std::make_unique<PageOutput>(parts);
}

}  // namespace kadr::driver
