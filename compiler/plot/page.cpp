#include "plot/page.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/json_writer.h"
#include "base/units.h"
#include "plot/base64.h"
#include "plot/svg_text.h"

namespace kadr::plot {

namespace {

// What a run puts in, in the order in which they stand in the template.
constexpr std::string_view kTitlePlace = "{{kadr:title}}";
constexpr std::string_view kDataPlace = "{{kadr:data}}";

constexpr std::size_t kSampleBytes = 5'500'000;  // of all samples in a page, as text
constexpr std::size_t kBlockBytes = 1'200'000;
constexpr std::size_t kBlockColumns = 6;  // of four bytes; and the time, of eight

/// Bytes of a row as they stand in a page.
constexpr std::size_t as_text(std::size_t bytes) { return (bytes * 4 + 2) / 3; }

void put_vector(JsonWriter& json, const path::Vec3& v) {
    json.array([&] { json.general(v.x()).general(v.y()).general(v.z()); });
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
    void put(JsonWriter& json) const {
        json.object([&] {
            json.key("unit").general(unit_);
            json.key("data").value(base64_of(std::span<const std::int32_t>(numbers_)));
        });
    }

  private:
    double unit_;
    std::vector<std::int32_t> numbers_;
};

template <typename Row, typename Take>
void put_column(JsonWriter& json, const std::vector<Row>& rows, double least, const Take& take) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(take(row));
    QuantizedColumn(values, least).put(json);
}

void put_axis(JsonWriter& json, const machine::MachineAxis& axis) {
    const double factor = axis.is_rotary ? deg_from_rad(1) : 1;
    json.object([&] {
        json.key("name").value(axis.name);
        json.key("letter").value(kAxisNames[index(axis.axis)]);
        json.key("rotary").value(axis.is_rotary);
        json.key("lower").general(factor * axis.lower);
        json.key("upper").general(factor * axis.upper);
        json.key("home").general(factor * axis.home);
    });
}

void put_joint(JsonWriter& json, const char* role, const machine::RotaryJoint& joint) {
    json.object([&] {
        json.key("role").value(role);
        json.key("letter").value(kAxisNames[index(joint.axis)]);
        json.key("side").value(joint.side == machine::ChainSide::Table ? "table" : "head");
        put_vector(json.key("direction"), joint.direction);
        put_vector(json.key("point"), joint.point);
        json.key("sign").general(joint.sign);
    });
}

void put_chain(JsonWriter& json, const machine::Kinematics& kinematics) {
    constexpr const char* kRoles[] = {"R1", "R2", "spin"};
    const machine::Chain& chain = kinematics.chain;
    json.object([&] {
        put_vector(json.key("toolDirection"), chain.tool_direction);
        json.key("compensatesParallel").value(chain.compensates_parallel);
        json.key("poleTolerance").general(deg_from_rad(kinematics.pole_tolerance));
        json.key("joints").array([&] {
            for (std::size_t k = 0; k < machine::kJoints; ++k) {
                if (chain.joints[k].is_present) put_joint(json, kRoles[k], chain.joints[k]);
            }
        });
    });
}

void put_machine(JsonWriter& json, const machine::Machine& machine) {
    json.object([&] {
        json.key("name").value(machine.name);
        json.key("title").value(machine.title);
        json.key("lathe").value(machine.is_lathe);
        json.key("axes").array([&] {
            for (const machine::MachineAxis& axis : machine.axes) put_axis(json, axis);
        });
        json.key("chain");
        if (machine.kinematics) put_chain(json, *machine.kinematics);
        else json.null();
    });
}

/// A tool as it hangs at the spindle; name and radius of one that the machine file has with this
/// length: of a tool the motion knows no more.
void put_tool(JsonWriter& json, const machine::Machine& machine, const path::Vec3& offset) {
    constexpr double kSameLength = 1e-6;  // mm
    const auto tool = std::ranges::find_if(machine.tools, [&](const machine::ToolData& data) {
        return std::abs(data.length - offset.norm()) < kSameLength;
    });
    const bool is_known = tool != machine.tools.end();
    const machine::ToolData* const named = is_known ? machine.find_tool(tool->number) : nullptr;
    json.object([&] {
        put_vector(json.key("offset"), offset);
        json.key("radius");
        if (is_known) json.general(tool->radius);
        else json.null();
        json.key("name").value(named == nullptr ? std::string() : named->name);
    });
}

void put_samples(JsonWriter& json, const PageTrace& trace) {
    constexpr double kTimeUnit = 1e-6;  // s
    constexpr double kUnit = 1e-5;      // mm or deg
    constexpr double kFeedUnit = 1e-3;  // mm/min
    using Sample = PageTrace::Sample;
    const std::vector<Sample>& samples = trace.samples();
    const auto put = [&](double unit, const auto& take) { put_column(json, samples, unit, take); };
    json.object([&] {
        json.key("count").value(samples.size());
        json.key("tolerance").general(trace.tolerance());
        json.key("time");
        put(kTimeUnit, [](const Sample& s) { return s.time; });
        json.key("feed");
        put(kFeedUnit, [](const Sample& s) { return s.feed; });
        json.key("axes").array([&] {
            for (std::size_t i = 0; i < trace.machine().axes.size(); ++i)
                put(kUnit, [i](const Sample& s) { return s.axis[i]; });
        });
    });
}

void put_blocks(JsonWriter& json, const PageTrace& trace) {
    const std::vector<PageBlock>& blocks = trace.blocks();
    const auto put = [&](JsonName name, const auto& take) {
        put_column(json.key(name), blocks, 1, take);
    };
    json.object([&] {
        json.key("count").value(blocks.size());
        json.key("kinds").array([&] {
            for (int i = 0; i < kKinds; ++i)
                json.value(kind_name(static_cast<motion::SegmentKind>(i)));
        });
        put_column(json.key("time"), blocks, 1e-6, [](const PageBlock& b) { return b.time; });
        put("kind", [](const PageBlock& b) { return static_cast<double>(b.kind); });
        put("tool", [](const PageBlock& b) { return double(b.tool); });
        put("isoText", [](const PageBlock& b) { return double(b.iso.text); });
        put("isoLine", [](const PageBlock& b) { return double(b.iso.line); });
        put("sourceText", [](const PageBlock& b) { return double(b.source.text); });
        put("sourceLine", [](const PageBlock& b) { return double(b.source.line); });
    });
}

void put_text(JsonWriter& json, const PageTexts::Text& text) {
    json.object([&] {
        json.key("name").value(text.name);
        json.key("kadr").value(text.is_kadr);
        json.key("cut").value(text.is_cut);
        json.key("text").value(text.text);
    });
}

/// What the page shows. Whatever stands in the texts of a program, no `</script>` and no `<!--` may
/// end or change the element before its end (HTML Living Standard, "Restrictions for contents of
/// script elements").
void append_data(std::string& out, const PageHead& head, const PageTrace& trace,
                 const PageTexts& texts) {
    JsonWriter json(out, JsonStyle::Script);
    json.object([&] {
        json.key("version").value(1);
        json.key("title").value(head.title);
        json.key("subtitle").value(head.subtitle);
        json.key("warning").value(head.warning);
        put_machine(json.key("machine"), trace.machine());
        json.key("tools").array([&] {
            for (const path::Vec3& offset : trace.tools()) put_tool(json, trace.machine(), offset);
        });
        put_samples(json.key("samples"), trace);
        put_blocks(json.key("blocks"), trace);
        json.key("texts").array([&] {
            for (const PageTexts::Text& text : texts.all()) put_text(json, text);
        });
    });
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

std::optional<std::string_view> missing_in_template(std::string_view page) {
    std::size_t at = 0;
    for (const std::string_view text : {kTitlePlace, kDataPlace}) {
        at = page.find(text, at);
        if (at == std::string_view::npos) return text;
    }
    return std::nullopt;
}

std::string page_html(std::string_view page, const PageHead& head, const PageTrace& trace,
                      const PageTexts& texts) {
    const std::size_t title_at = page.find(kTitlePlace);
    const std::size_t data_at = page.find(kDataPlace, title_at);
    const std::size_t behind_title = title_at + kTitlePlace.size();
    std::string out(page.substr(0, title_at));
    out += escaped(head.title);
    out += page.substr(behind_title, data_at - behind_title);
    append_data(out, head, trace, texts);
    out += page.substr(data_at + kDataPlace.size());
    return out;
}

}  // namespace kadr::plot
