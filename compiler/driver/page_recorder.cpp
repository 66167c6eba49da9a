#include "driver/page_recorder.h"

#include <cstdlib>
#include <utility>

#include "base/diagnostics/page.h"
#include "base/text.h"

namespace kadr::driver {

namespace {

/// The template: of the environment's KADR_PAGE, else what was installed or built. Nothing, with a
/// message: it is not there, or it is none.
std::optional<std::string> page_template(Session& session) {
    const char* chosen = std::getenv("KADR_PAGE");
    const std::string name =
        chosen != nullptr && *chosen != '\0' ? chosen : session.share().page_template;
    auto page = read_file(name);
    if (!page) {
        session.messages().report(diag::PageTemplateMissing).arg(name);
        return std::nullopt;
    }
    if (const auto missing = plot::missing_in_template(*page)) {
        session.messages().report(diag::PageTemplateBroken).arg(name).arg(*missing);
        return std::nullopt;
    }
    return page;
}

}  // namespace

std::unique_ptr<PageRecorder> PageRecorder::open(Session& session) {
    auto page = page_template(session);
    if (!page) return nullptr;
    return std::unique_ptr<PageRecorder>(new PageRecorder(session, std::move(*page)));
}

void PageRecorder::look_on(Aside& aside) {
    constexpr std::size_t kMostText = 4'000'000;  // bytes; more than a page takes of it
    aside.tap = [this](std::string_view piece) {
        if (made_.size() < kMostText) made_ += piece;
    };
}

void PageRecorder::follow(const Execution& execution) {
    execution_ = &execution;
    const machine::Machine& machine = execution.machine();
    trace_ = std::make_unique<plot::PageTrace>(machine, plot::most_page_samples(machine),
                                               plot::most_page_blocks());
    const KadrProgram* program = execution.program();
    if (program == nullptr) return;
    const std::string name = session_.output_name(program->file);
    texts_.append(texts_.index_of(name, true), session_.sources().text(program->file));
}

plot::PageLocation PageRecorder::source_location(SourceId source) {
    const SourceRange range = execution_->statement(source);
    if (!range.file.is_valid()) return {};
    const Sources& sources = session_.sources();
    const std::int32_t text = texts_.index_of(session_.output_name(range.file), true);
    if (texts_.all()[static_cast<std::size_t>(text)].text.empty())
        texts_.append(text, sources.text(range.file));
    return {text, sources.locate(range.file, range.begin).line};
}

void PageRecorder::add(const motion::Segment& segment) {
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
void PageRecorder::read_texts() {
    for (std::size_t i = 0; i < texts_.all().size(); ++i) {
        const plot::PageTexts::Text& text = texts_.all()[i];
        if (text.is_kadr || !text.text.empty()) continue;
        const auto index = static_cast<std::int32_t>(i);
        if (text.name == execution_->text_name() && !made_.empty()) {
            texts_.append(index, made_);
        } else if (auto read = read_file(text.name)) {
            end_lines_with_feeds(*read);
            texts_.append(index, *read);
        }
    }
}

void PageRecorder::write(const plot::PageHead& head, Output& out) {
    trace_->finish();
    texts_.index_of(execution_->text_name(), false);
    read_texts();
    out.write(plot::page_html(page_, head, *trace_, texts_));
}

}  // namespace kadr::driver
