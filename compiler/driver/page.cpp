#include "driver/page.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <span>

#include "base/diagnostics/page.h"
#include "base/render.h"
#include "base/text.h"
#include "base/units.h"
#include "driver/base64.h"
#include "driver/svg_text.h"

namespace kadr::driver {

namespace {

// What a run puts in, in the order in which they stand in the template.
constexpr std::string_view kTitlePlace = "{{kadr:title}}";
constexpr std::string_view kDataPlace = "{{kadr:data}}";

constexpr std::size_t kSampleBytes = 5'500'000;  // of all samples in a page, as text
constexpr std::size_t kBlockBytes = 1'200'000;
constexpr std::size_t kBlockColumns = 6;  // of four bytes; and the time, of eight

/// Bytes of a row as they stand in a page.
constexpr std::size_t as_text(std::size_t bytes) { return (bytes * 4 + 2) / 3; }

/// A number for JSON, which has no infinite ones.
std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : std::string("null");
}

std::string vector_text(const path::Vec3& v) {
    return fmt::format("[{},{},{}]", number(v.x()), number(v.y()), number(v.z()));
}

const char* kind_name(motion::SegmentKind kind) {
    switch (kind) {
        case motion::SegmentKind::Rapid: return "rapid";
        case motion::SegmentKind::Feed: return "feed";
        case motion::SegmentKind::Dwell: return "dwell";
        case motion::SegmentKind::ToolChange: return "tool change";
        case motion::SegmentKind::Orient: return "spindle orientation";
        case motion::SegmentKind::Hold: return "feed hold";
        case motion::SegmentKind::Wait: return "waiting for the machine";
        case motion::SegmentKind::External: return "external motion";
        case motion::SegmentKind::Jump: return "scanner jump";
        case motion::SegmentKind::Mark: return "scanner mark";
    }
    return "";
}
constexpr int kKinds = static_cast<int>(motion::SegmentKind::Mark) + 1;

/// Numbers as whole multiples of a unit that is as small as 32 bits let it be, but not smaller than
/// `least`.
class QuantizedColumn {
  public:
    QuantizedColumn(const std::vector<double>& values, double least) : unit_(least) {
        constexpr double kMost = 2147483647;
        double largest = 0;
        for (const double value : values) largest = std::max(largest, std::abs(value));
        while (largest > kMost * unit_) unit_ *= 10;
        for (const double value : values)
            numbers_.push_back(static_cast<std::int32_t>(std::lround(value / unit_)));
    }
    std::string json() const {
        return fmt::format("{{\"unit\":{},\"data\":\"{}\"}}", number(unit_),
                           base64_of(std::span<const std::int32_t>(numbers_)));
    }

  private:
    double unit_;
    std::vector<std::int32_t> numbers_;
};

template <typename Row, typename Take>
std::string column_of(const std::vector<Row>& rows, double least, const Take& take) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(take(row));
    return QuantizedColumn(values, least).json();
}

std::string axis_json(const machine::MachineAxis& axis) {
    const double factor = axis.is_rotary ? deg_from_rad(1) : 1;
    return fmt::format(R"({{"name":{},"letter":"{}","rotary":{},"lower":{},"upper":{},"home":{}}})",
                       json_string(axis.name), kAxisNames[index(axis.axis)], axis.is_rotary,
                       number(factor * axis.lower), number(factor * axis.upper),
                       number(factor * axis.home));
}

std::string chain_json(const machine::Kinematics& kinematics) {
    const machine::Chain& chain = kinematics.chain;
    constexpr const char* kRoles[] = {"R1", "R2", "spin"};
    std::string joints;
    for (std::size_t k = 0; k < machine::kJoints; ++k) {
        const machine::RotaryJoint& joint = chain.joints[k];
        if (!joint.is_present) continue;
        put(joints,
            R"({}{{"role":"{}","letter":"{}","side":"{}","direction":{},"point":{},"sign":{}}})",
            joints.empty() ? "" : ",", kRoles[k], kAxisNames[index(joint.axis)],
            joint.side == machine::ChainSide::Table ? "table" : "head",
            vector_text(joint.direction), vector_text(joint.point), joint.sign);
    }
    return fmt::format(
        R"({{"toolDirection":{},"compensatesParallel":{},"poleTolerance":{},"joints":[{}]}})",
        vector_text(chain.tool_direction), chain.compensates_parallel,
        number(deg_from_rad(kinematics.pole_tolerance)), joints);
}

std::string machine_json(const machine::Machine& machine) {
    std::string axes;
    for (const machine::MachineAxis& axis : machine.axes)
        axes += (axes.empty() ? "" : ",") + axis_json(axis);
    return fmt::format(R"({{"name":{},"title":{},"lathe":{},"axes":[{}],"chain":{}}})",
                       json_string(machine.name), json_string(machine.title), machine.is_lathe,
                       axes,
                       machine.kinematics ? chain_json(*machine.kinematics) : std::string("null"));
}

/// The tools as they hang at the spindle; names and radii of those that the machine file has with
/// this length: of a tool the motion knows no more.
std::string tools_json(const PageTrace& trace) {
    constexpr double kSameLength = 1e-6;  // mm
    std::string tools;
    for (const path::Vec3& offset : trace.tools()) {
        const auto& known = trace.machine().tools;
        const auto tool = std::ranges::find_if(known, [&](const machine::ToolData& data) {
            return std::abs(data.length - offset.norm()) < kSameLength;
        });
        const bool is_known = tool != known.end();
        const machine::ToolData* const named =
            is_known ? trace.machine().find_tool(tool->number) : nullptr;
        put(tools, R"({}{{"offset":{},"radius":{},"name":{}}})", tools.empty() ? "" : ",",
            vector_text(offset), is_known ? number(tool->radius) : "null",
            json_string(named == nullptr ? std::string() : named->name));
    }
    return tools;
}

std::string samples_json(const PageTrace& trace) {
    constexpr double kTimeUnit = 1e-6;  // s
    constexpr double kUnit = 1e-5;      // mm or deg
    constexpr double kFeedUnit = 1e-3;  // mm/min
    using Sample = PageTrace::Sample;
    const std::vector<Sample>& samples = trace.samples();
    std::string axes;
    for (std::size_t i = 0; i < trace.machine().axes.size(); ++i) {
        axes += (axes.empty() ? "" : ",") +
                column_of(samples, kUnit, [i](const Sample& s) { return s.axis[i]; });
    }
    return fmt::format(R"({{"count":{},"tolerance":{},"time":{},"feed":{},"axes":[{}]}})",
                       samples.size(), number(trace.tolerance()),
                       column_of(samples, kTimeUnit, [](const Sample& s) { return s.time; }),
                       column_of(samples, kFeedUnit, [](const Sample& s) { return s.feed; }), axes);
}

std::string blocks_json(const PageTrace& trace) {
    const std::vector<PageBlock>& blocks = trace.blocks();
    const auto column = [&](const auto& take) { return column_of(blocks, 1, take); };
    std::string kinds;
    for (int i = 0; i < kKinds; ++i) {
        put(kinds, "{}\"{}\"", i > 0 ? "," : "", kind_name(static_cast<motion::SegmentKind>(i)));
    }
    return fmt::format(
        R"({{"count":{},"kinds":[{}],"time":{},"kind":{},"tool":{},"isoText":{},"isoLine":{},)"
        R"("sourceText":{},"sourceLine":{}}})",
        blocks.size(), kinds, column_of(blocks, 1e-6, [](const PageBlock& b) { return b.time; }),
        column([](const PageBlock& b) { return static_cast<double>(b.kind); }),
        column([](const PageBlock& b) { return double(b.tool); }),
        column([](const PageBlock& b) { return double(b.iso.text); }),
        column([](const PageBlock& b) { return double(b.iso.line); }),
        column([](const PageBlock& b) { return double(b.source.text); }),
        column([](const PageBlock& b) { return double(b.source.line); }));
}

std::string texts_json(const PageTexts& texts) {
    std::string out;
    for (const PageTexts::Text& text : texts.all()) {
        put(out, R"({}{{"name":{},"kadr":{},"cut":{},"text":{}}})", out.empty() ? "" : ",",
            json_string(text.name), text.is_kadr, text.is_cut, json_string(text.text));
    }
    return out;
}

/// JSON inside of a `<script>`: whatever stands in the texts of a program, no `</script>` and no
/// `<!--` may end or change the element before its end (HTML Living Standard, "Restrictions for
/// contents of script elements"). `<` stands in JSON only within strings, where it may be escaped.
std::string inside_script(const std::string& json) {
    std::string out;
    out.reserve(json.size() + json.size() / 64);
    for (const char c : json) {
        if (c == '<') out += "\\u003c";
        else out += c;
    }
    return out;
}

}  // namespace

std::int32_t PageTexts::index_of(std::string_view name, bool is_kadr) {
    const auto known = std::ranges::find(texts_, name, &Text::name);
    if (known != texts_.end()) return static_cast<std::int32_t>(known - texts_.begin());
    texts_.push_back({std::string(name), is_kadr, {}, false});
    return static_cast<std::int32_t>(texts_.size() - 1);
}

void PageTexts::append(std::int32_t index, std::string_view piece) {
    Text& text = texts_[static_cast<std::size_t>(index)];
    if (text.is_cut || piece.empty()) return;
    const std::size_t count = std::min(piece.size(), room_);
    text.text += piece.substr(0, count);
    room_ -= count;
    if (count == piece.size()) return;
    text.is_cut = true;
    // A line that is there is there wholly.
    const std::size_t end = text.text.rfind('\n');
    text.text.resize(end == std::string::npos ? 0 : end + 1);
}

std::size_t most_page_samples(const machine::Machine& machine) {
    constexpr std::size_t kColumn = 4;  // bytes
    const std::size_t columns = machine.axes.size() + 2;
    return kSampleBytes / as_text(kColumn * columns);
}

std::size_t most_page_blocks() { return kBlockBytes / as_text(4 * (kBlockColumns + 1)); }

std::optional<std::string> page_template(Session& session) {
    const char* chosen = std::getenv("KADR_PAGE");
    const std::string name =
        chosen != nullptr && *chosen != '\0' ? chosen : session.share().page_template;
    const auto page = read_file(name);
    if (!page) {
        session.messages().report(diag::PageTemplateMissing).arg(name);
        return std::nullopt;
    }
    std::size_t at = 0;
    for (const std::string_view text : {kTitlePlace, kDataPlace}) {
        at = page->find(text, at);
        if (at != std::string::npos) continue;
        session.messages().report(diag::PageTemplateBroken).arg(name).arg(text);
        return std::nullopt;
    }
    return *page;
}

std::string page_html(std::string_view page, const PageHead& head, const PageTrace& trace,
                      const PageTexts& texts) {
    const std::string data = fmt::format(
        R"({{"version":1,"title":{},"subtitle":{},"warning":{},"machine":{},"tools":[{}],)"
        R"("samples":{},"blocks":{},"texts":[{}]}})",
        json_string(head.title), json_string(head.subtitle), json_string(head.warning),
        machine_json(trace.machine()), tools_json(trace), samples_json(trace), blocks_json(trace),
        texts_json(texts));
    const std::size_t title_at = page.find(kTitlePlace);
    const std::size_t data_at = page.find(kDataPlace, title_at);
    const std::size_t behind_title = title_at + kTitlePlace.size();
    std::string out(page.substr(0, title_at));
    out += escaped(head.title);
    out += page.substr(behind_title, data_at - behind_title);
    out += inside_script(data);
    out += page.substr(data_at + kDataPlace.size());
    return out;
}

}  // namespace kadr::driver
