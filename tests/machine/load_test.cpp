// Machine files: what they mean, and what is said about their mistakes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "base/disk_files.h"
#include "machine/machine.h"

namespace kadr::machine::load_test {
namespace {

const std::string kStock = std::string(KADR_ROOT) + "/runtime/machines";

/// A machine file that lives as long as the test.
class TemporaryFile {
  public:
    explicit TemporaryFile(const std::string& text)
        : path_(
              (std::filesystem::temp_directory_path() /
               ("kadr-machine-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + ".xml"))
                  .string()) {
        std::ofstream(path_, std::ios::binary) << text;
    }
    ~TemporaryFile() { std::remove(path_.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

struct Loaded {
    std::optional<Machine> machine;
    Sources sources;
    DiagnosticList diagnostics;
};

void load(const std::string& text, Loaded& loaded) {
    const TemporaryFile file(text);
    loaded.machine = load_machine(file.path(), {}, loaded.sources, loaded.diagnostics);
}

constexpr const char* kAxisX =
    R"(<axis name="X" limits="-300..300 mm" velocity="30 m/min" acceleration="5 m/s2"/>)";

TEST(MachineFile, StockMachinesLoad) {
    for (const char* name :
         {"mill", "mill-fast", "lathe", "laser", "scanner", "trunnion-ac", "trunnion-bc", "head-cb",
          "head-ab", "mixed-cb", "nutating", "rotary-a", "borer", "six-axis"}) {
        SCOPED_TRACE(name);
        Sources sources;
        DiagnosticList diagnostics;
        const auto machine = load_machine(name, {kStock}, sources, diagnostics);
        ASSERT_TRUE(machine);
        EXPECT_TRUE(diagnostics.all().empty());
        EXPECT_EQ(machine->name, name);
        EXPECT_FALSE(machine->title.empty());
        EXPECT_EQ(machine->is_lathe, machine->name == "lathe");
        EXPECT_EQ(machine->find(Axis::Y) == nullptr, machine->is_lathe);
        EXPECT_NE(machine->find(Axis::Z), nullptr);
        EXPECT_EQ(machine->work_offsets.size(), 1u);
    }
}

TEST(MachineFile, ListsByName) {
    const auto machines = list({kStock, "/no/such/folder"}, disk());
    ASSERT_EQ(machines.size(), 17u);
    std::map<std::string, std::string> axes;
    for (const MachineSummary& machine : machines) axes[machine.name] = machine.axes;
    EXPECT_EQ(axes["laser"], "X Y Z");
    EXPECT_EQ(axes["lathe"], "X Z");
    EXPECT_EQ(axes["mill"], "X Y Z");
    EXPECT_EQ(axes["trunnion-ac"], "X Y Z A C");
    EXPECT_EQ(axes["borer"], "X Y Z W B");
    EXPECT_EQ(axes["six-axis"], "X Y Z A B C");
    EXPECT_TRUE(std::ranges::is_sorted(machines, {}, &MachineSummary::name));
}

TEST(MachineFile, ValuesAreCanonical) {
    Loaded loaded;
    load(
        R"(<machine name="m" title="t &amp; t" tick="0.5 ms" max_feed="20 m/min" max_speed="6000 rpm"
                     orient_time="300 ms" tool_change_time="4 s"
                     corner_tolerance="0.1 mm" compressor_tolerance="5 um">
              <axis name="X" limits="-0.5..0.25 m" velocity="30 m/min" acceleration="5 m/s2"
                    jerk="100 m/s3" corner_jump="6 mm/s" curvature_jump="0.2 m/s2" home="1in" home2="-50 mm" home4="0.2 m"/>
              <axis name="C" velocity="60 rpm" acceleration="180 deg/s2" home="90 deg" home3="0.5 rad"/>
              <tool number="3" name="drill" length="120.5 mm" radius="4250 um"/>
              <tool number="3" edge="2" length="118 mm" radius="4 mm"/>
              <tool number="4" length="80 mm" length_x="-60.25 mm" radius="0.8 mm" tip="3"/>
              <spindle number="3" max_speed="12000 rpm"/>
              <spindle number="2" orient_time="0.2 s"/>
              <offset number="2" x="-10 mm" c="45 deg"/>
              <function code="M10" takes="400 ms"/>
              <function code="M9" takes="0.1 s" waits="no"/>
              <function code="M63" takes="2 s" acts="with"/>
            </machine>)",
        loaded);
    ASSERT_TRUE(loaded.machine);
    const Machine& machine = *loaded.machine;
    EXPECT_EQ(machine.title, "t & t");
    EXPECT_DOUBLE_EQ(machine.tick, 0.0005);
    EXPECT_DOUBLE_EQ(machine.max_feed, 20000.0 / 60);
    EXPECT_DOUBLE_EQ(machine.max_speed, 100);
    EXPECT_DOUBLE_EQ(machine.orient_time, 0.3);
    EXPECT_DOUBLE_EQ(machine.tool_change_time, 4);
    ASSERT_EQ(machine.spindles.size(), 2u);
    EXPECT_EQ(machine.spindles[0].number, 2);
    EXPECT_TRUE(machine.has_spindle(1) && machine.has_spindle(2) && machine.has_spindle(3));
    EXPECT_FALSE(machine.has_spindle(0) || machine.has_spindle(4));
    EXPECT_DOUBLE_EQ(machine.max_speed_of(1), 100);
    EXPECT_DOUBLE_EQ(machine.max_speed_of(2), 0) << "no limit";
    EXPECT_DOUBLE_EQ(machine.max_speed_of(3), 200);
    EXPECT_DOUBLE_EQ(machine.orient_time_of(0), 0.3) << "no number is the first one";
    EXPECT_DOUBLE_EQ(machine.orient_time_of(2), 0.2);
    EXPECT_DOUBLE_EQ(machine.orient_time_of(3), 0);
    ASSERT_EQ(machine.functions.size(), 3u);
    const MachineFunction* clamp = machine.find_function(10);
    ASSERT_NE(clamp, nullptr);
    EXPECT_DOUBLE_EQ(clamp->takes, 0.4);
    EXPECT_EQ(clamp->acts, FunctionTime::BeforeMotion);
    EXPECT_TRUE(clamp->waits);
    EXPECT_EQ(machine.find_function(9)->acts, FunctionTime::AfterMotion);
    EXPECT_FALSE(machine.find_function(9)->waits);
    EXPECT_EQ(machine.find_function(63)->acts, FunctionTime::WithMotion);
    EXPECT_EQ(machine.find_function(11), nullptr);
    EXPECT_DOUBLE_EQ(machine.corner_tolerance, 0.1);
    EXPECT_DOUBLE_EQ(machine.compressor_tolerance, 0.005);
    ASSERT_EQ(machine.axes.size(), 2u);
    const MachineAxis& x = machine.axes[0];
    EXPECT_DOUBLE_EQ(x.lower, -500);
    EXPECT_DOUBLE_EQ(x.upper, 250);
    EXPECT_DOUBLE_EQ(x.velocity, 500);
    EXPECT_DOUBLE_EQ(x.acceleration, 5000);
    EXPECT_DOUBLE_EQ(x.jerk, 1e5);
    ASSERT_TRUE(x.corner_jump && x.curvature_jump);
    EXPECT_DOUBLE_EQ(*x.corner_jump, 6);
    EXPECT_DOUBLE_EQ(*x.curvature_jump, 200);
    EXPECT_DOUBLE_EQ(x.home, 25.4);
    EXPECT_EQ(x.further_homes[0], -50);
    EXPECT_EQ(x.further_homes[1], std::nullopt);
    ASSERT_TRUE(x.further_homes[2]);
    EXPECT_DOUBLE_EQ(*x.further_homes[2], 200);
    const MachineAxis& c = machine.axes[1];
    EXPECT_TRUE(c.is_rotary);
    EXPECT_DOUBLE_EQ(c.velocity, 2 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(c.acceleration, std::numbers::pi);
    EXPECT_DOUBLE_EQ(c.home, std::numbers::pi / 2);
    ASSERT_TRUE(c.further_homes[1]);
    EXPECT_DOUBLE_EQ(*c.further_homes[1], 0.5);
    EXPECT_EQ(c.lower, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(c.jerk, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(c.corner_jump || c.curvature_jump) << "those of the tick";
    ASSERT_NE(machine.find_tool(3), nullptr);
    EXPECT_DOUBLE_EQ(machine.find_tool(3)->length, 120.5);
    EXPECT_DOUBLE_EQ(machine.find_tool(3)->radius, 4.25);
    EXPECT_EQ(machine.find_tool(3)->tip, 0);
    EXPECT_EQ(machine.find_tool(3)->edge, 1);
    EXPECT_DOUBLE_EQ(machine.find_tool(4)->length_x, -60.25);
    EXPECT_EQ(machine.find_tool(4)->tip, 3);
    EXPECT_EQ(machine.find_tool(5), nullptr);
    ASSERT_EQ(machine.work_offsets.size(), 3u);
    EXPECT_DOUBLE_EQ(machine.work_offsets[1][0], 0);
    EXPECT_DOUBLE_EQ(machine.work_offsets[2][0], -10);
    EXPECT_DOUBLE_EQ(machine.work_offsets[2][index(Axis::C)], 45);
}

TEST(MachineFile, DrivesAreInSiUnits) {
    Loaded loaded;
    load(std::string(R"(<machine name="m">)") + kAxisX +
             R"(<spindle_drive inertia="1500 kg cm2" torque_constant="2 Nm/A" time_constant="4 ms"
                               friction="4 Nm" damping="0.01 Nm s" max_current="90 A"/>
                <feed_drive gain="50 1/s" time_constant="5 ms" feed_forward="80 %"/>
                <cutting force="1.2 kN"/></machine>)",
         loaded);
    ASSERT_TRUE(loaded.machine);
    ASSERT_TRUE(loaded.machine->drives);
    const Drives& drives = *loaded.machine->drives;
    EXPECT_DOUBLE_EQ(drives.spindle.inertia, 0.15);
    EXPECT_DOUBLE_EQ(drives.spindle.torque_constant, 2);
    EXPECT_DOUBLE_EQ(drives.spindle.time_constant, 0.004);
    EXPECT_DOUBLE_EQ(drives.spindle.friction, 4);
    EXPECT_DOUBLE_EQ(drives.spindle.damping, 0.01);
    EXPECT_DOUBLE_EQ(drives.spindle.max_current, 90);
    EXPECT_DOUBLE_EQ(drives.feed.gain, 50);
    EXPECT_DOUBLE_EQ(drives.feed.time_constant, 0.005);
    EXPECT_DOUBLE_EQ(drives.feed.feed_forward, 0.8);
    EXPECT_DOUBLE_EQ(drives.cutting_force, 1200);
    EXPECT_FALSE(loaded.machine->laser);
}

TEST(MachineFile, OneDriveAloneIsNone) {
    Loaded loaded;
    load(std::string(R"(<machine name="m">)") + kAxisX +
             R"(<feed_drive gain="50 1/s" time_constant="5 ms"/></machine>)",
         loaded);
    ASSERT_TRUE(loaded.machine);
    EXPECT_FALSE(loaded.machine->drives);
}

TEST(MachineFile, LasersArePulsedOrContinuous) {
    Loaded pulsed;
    load(std::string(R"(<machine name="m">)") + kAxisX +
             R"(<laser pulse="0.04 kHz" tolerance="10 %" mode="stop"/></machine>)",
         pulsed);
    ASSERT_TRUE(pulsed.machine);
    ASSERT_TRUE(pulsed.machine->laser);
    EXPECT_DOUBLE_EQ(pulsed.machine->laser->pulse, 40);
    EXPECT_DOUBLE_EQ(pulsed.machine->laser->tolerance, 0.1);
    EXPECT_EQ(pulsed.machine->laser->mode, PulseMode::Stop);
    Loaded continuous;
    load(std::string(R"(<machine name="m">)") + kAxisX +
             R"(<laser power="1.5 kW" least_power="80 W"/></machine>)",
         continuous);
    ASSERT_TRUE(continuous.machine);
    EXPECT_EQ(continuous.machine->laser->pulse, 0);
    EXPECT_DOUBLE_EQ(continuous.machine->laser->power, 1500);
    EXPECT_DOUBLE_EQ(continuous.machine->laser->least_power, 80);
}

/// One mistake: the code, the text that the message underlines, and the words of its fix.
struct Mistake {
    const char* name;
    const char* xml;  // inside <machine name="m"> beside a good axis X, or the whole file
    const char* code;
    const char* marked;
    const char* fix;  // replacement or words; "" for none
};

void expect_mistake(const Mistake& mistake) {
    SCOPED_TRACE(mistake.name);
    const std::string xml = mistake.xml;
    Loaded loaded;
    load(xml.starts_with("<machine") || xml.starts_with("<mill") || xml.empty()
             ? xml
             : std::string("<machine name=\"m\">") + kAxisX + xml + "</machine>",
         loaded);
    EXPECT_FALSE(loaded.machine);
    ASSERT_EQ(loaded.diagnostics.all().size(), 1u) << "one mistake, one message";
    const Diagnostic& said = loaded.diagnostics.all()[0];
    EXPECT_EQ(said.row->code, mistake.code) << said.message();
    if (said.range.file.is_valid()) {
        EXPECT_EQ(loaded.sources.text(said.range), mistake.marked);
    }
    const std::string fix = said.fixes.empty()                  ? ""
                            : said.fixes[0].replacement.empty() ? said.fixes[0].text
                                                                : said.fixes[0].replacement;
    EXPECT_EQ(fix, mistake.fix);
}

TEST(MachineFile, MistakesOfStructure) {
    for (
        const Mistake& mistake :
        {Mistake{"broken off", "<machine name=\"m\"", "K9101", "\"", ""},
         {"nothing", "", "K9101", "", ""},
         {"another file", "<mill/>", "K9102", "mill", ""},
         {"unknown element", "<axes/>", "K9103", "axes", "axis"},
         {"unknown below", "<tool number=\"1\"><edge/></tool>", "K9103", "edge", ""},
         {"unknown attribute", "<tool number=\"1\" lenght=\"3 mm\"/>", "K9104", "lenght", "length"},
         {"missing attribute", "<tool length=\"3 mm\"/>", "K9105", "tool", ""},
         {"machine without name",
          R"(<machine><axis name="X" velocity="1 m/s" acceleration="1 m/s2"/></machine>)", "K9105",
          "machine", ""},
         {"doubled attribute", "<tool number=\"1\" number=\"2\"/>", "K9107", "number", ""},
         {"no axes", "<machine name=\"m\"/>", "K6015", "machine", ""},
         {"stray text", "five tools", "K9108", "five tools", ""},
         {"doubled axis", kAxisX, "K6014", "X", ""},
         {"doubled tool", "<tool number=\"1\"/><tool number=\"1\"/>", "K6014", "1", ""},
         {"doubled first edge", "<tool number=\"1\"/><tool number=\"1\" edge=\"1\"/>", "K6014", "1",
          ""},
         {"doubled edge",
          R"(<tool number="1" edge="2"/><tool number="1"/><tool number="1" edge="2"/>)", "K6014",
          "2", ""},
         {"edge alone", R"(<tool number="1" edge="3"/>)", "K6312", "3", ""},
         {"edge with a name", R"(<tool number="1"/><tool number="1" edge="2" name="drill"/>)",
          "K6313", "drill", ""},
         {"doubled probe",
          R"(<probe><plane axis="Z" at="0 mm"/></probe><probe><plane axis="Z" at="0 mm"/></probe>)",
          "K6014", "probe", ""},
         {"a probe that meets nothing", R"(<probe radius="3 mm"/>)", "K6351", "probe", ""},
         {"a flat block", R"(<probe><block from="0 0 5 mm" to="5 4 5 mm"/></probe>)", "K6350",
          "5 4 5 mm", ""},
         {"doubled datum", R"(<data name="R1" value="1"/><data name="R1" value="2"/>)", "K6014",
          "R1", ""},
         {"datum without a value", R"(<data name="R1"/>)", "K9105", "data", ""},
         {"doubled name of an axis",
          R"(<axis name="Y" machine_name="M1" velocity="1 m/s" acceleration="5 m/s2"/>)"
          R"(<axis name="Z" machine_name="M1" velocity="1 m/s" acceleration="5 m/s2"/>)",
          "K6014", "M1", ""},
         {"doubled offset", "<offset number=\"1\"/><offset number=\"1\"/>", "K6014", "1", ""}}) {
        expect_mistake(mistake);
    }
}

TEST(MachineFile, MistakesOfAnAxis) {
    for (
        const Mistake& mistake :
        {Mistake{"no velocity", R"(<axis name="Y" acceleration="5 m/s2"/>)", "K9105", "axis", ""},
         {"no acceleration", R"(<axis name="Y" velocity="5 m/s"/>)", "K9105", "axis", ""},
         {"not a name", R"(<axis name="Q" velocity="30 m/min" acceleration="5 m/s2"/>)", "K6013",
          "Q", ""},
         {"lower case", R"(<axis name="y" velocity="30 m/min" acceleration="5 m/s2"/>)", "K6013",
          "y", "Y"},
         {"not a number", R"(<axis name="Y" velocity="fast" acceleration="5 m/s2"/>)", "K6007",
          "fast", ""},
         {"four dots",
          R"(<axis name="Y" limits="-3....3 mm" velocity="1 m/s" acceleration="5 m/s2"/>)", "K6007",
          "-3....3 mm", ""},
         {"not a range",
          R"(<axis name="Y" limits="300 mm" velocity="1 m/s" acceleration="5 m/s2"/>)", "K6007",
          "300 mm", ""},
         {"comma", R"(<axis name="Y" limits="-1,5..3 mm" velocity="1 m/s" acceleration="5 m/s2"/>)",
          "K6007", "-1,5..3 mm", "write the point of a decimal: `-1.5`"},
         {"no unit", R"(<axis name="Y" velocity="30" acceleration="5 m/s2"/>)", "K6008", "30",
          "write `m/min`, `mm/min`, `mm/s`, `m/s` or `in/min` after the number"},
         {"unit of time", R"(<axis name="Y" velocity="30 s" acceleration="5 m/s2"/>)", "K6009",
          "30 s", "write `m/min`, `mm/min`, `mm/s`, `m/s` or `in/min`"},
         {"rotary in metres", R"(<axis name="C" velocity="30 m/min" acceleration="5 deg/s2"/>)",
          "K6009", "30 m/min", "write `rpm`, `deg/s`, `deg/min` or `rad/s`"},
         {"reversed",
          R"(<axis name="Y" limits="3..-3 mm" velocity="1 m/s" acceleration="5 m/s2"/>)", "K6010",
          "3..-3 mm", ""},
         {"no room", R"(<axis name="Y" limits="3..3 mm" velocity="1 m/s" acceleration="5 m/s2"/>)",
          "K6010", "3..3 mm", ""},
         {"no speed", R"(<axis name="Y" velocity="0 m/min" acceleration="5 m/s2"/>)", "K6011",
          "0 m/min", ""},
         {"negative jerk",
          R"(<axis name="Y" velocity="1 m/s" acceleration="5 m/s2" jerk="-1 m/s3"/>)", "K6011",
          "-1 m/s3", ""},
         {"no jump at corners",
          R"(<axis name="Y" velocity="1 m/s" acceleration="5 m/s2" corner_jump="0 mm/s"/>)",
          "K6011", "0 mm/s", ""},
         {"a jump of the velocity as an acceleration",
          R"(<axis name="Y" velocity="1 m/s" acceleration="5 m/s2" corner_jump="1 m/s2"/>)",
          "K6009", "1 m/s2", "write `m/min`, `mm/min`, `mm/s`, `m/s` or `in/min`"},
         {"negative jump of the acceleration",
          R"(<axis name="Y" velocity="1 m/s" acceleration="5 m/s2" jerk="9 m/s3" curvature_jump="-1 m/s2"/>)",
          "K6011", "-1 m/s2", ""},
         {"jump of the acceleration without jerk",
          R"(<axis name="Y" velocity="1 m/s" acceleration="5 m/s2" curvature_jump="1 m/s2"/>)",
          "K6024", "1 m/s2", ""},
         {"home outside",
          R"(<axis name="Y" limits="1..3 mm" velocity="1 m/s" acceleration="5 m/s2" home="5 mm"/>)",
          "K6016", "5 mm", ""}}) {
        expect_mistake(mistake);
    }
}

TEST(MachineFile, MistakesOfValues) {
    const std::string axis = std::string(kAxisX) + "</machine>";
    const std::string kind = R"(<machine name="m" kind="lath">)" + axis;
    const std::string tick = R"(<machine name="m" tick="0 ms">)" + axis;
    const std::string long_tick = R"(<machine name="m" tick="100 s">)" + axis;
    const std::string time = R"(<machine name="m" tool_change_time="-1 s">)" + axis;
    for (
        const Mistake& mistake :
        {Mistake{"kind", kind.c_str(), "K6017", "lath", "lathe"},
         {"tick", tick.c_str(), "K6011", "0 ms", ""},
         {"long tick", long_tick.c_str(), "K6019", "100 s", ""},
         {"negative time", time.c_str(), "K6012", "-1 s", ""},
         {"negative radius", R"(<tool number="1" radius="-1 mm"/>)", "K6012", "-1 mm", ""},
         {"no such edge", R"(<tool number="1"/><tool number="1" edge="13"/>)", "K6018", "13", ""},
         {"edge zero", R"(<tool number="1" edge="0"/>)", "K6018", "0", ""},
         {"spindle one", R"(<spindle number="1"/>)", "K6018", "1", ""},
         {"spindle five", R"(<spindle number="5"/>)", "K6018", "5", ""},
         {"spindle twice", R"(<spindle number="2"/><spindle number="2"/>)", "K6014", "2", ""},
         {"slow spindle", R"(<spindle number="2" max_speed="0 rpm"/>)", "K6011", "0 rpm", ""},
         {"no such tip", R"(<tool number="1" tip="10"/>)", "K6018", "10", ""},
         {"offset G54", R"(<offset number="G54"/>)", "K6018", "G54", ""},
         {"offset zero", R"(<offset number="0"/>)", "K6018", "0", ""},
         {"offset too large", R"(<offset number="99999999999999999999"/>)", "K6018",
          "99999999999999999999", ""},
         {"share above the whole",
          R"(<feed_drive gain="50 1/s" time_constant="5 ms" feed_forward="120 %"/>)", "K6020",
          "120 %", ""},
         {"negative share", R"(<laser pulse="40 Hz" tolerance="-1 %"/>)", "K6020", "-1 %", ""},
         {"share without percent", R"(<laser pulse="40 Hz" tolerance="0.1"/>)", "K6008", "0.1",
          "write `%` after the number"},
         {"pulse between ticks", R"(<laser pulse="30 Hz" tolerance="0.5 %"/>)", "K6022", "30 Hz",
          ""},
         {"no inertia",
          R"(<spindle_drive inertia="0 kg m2" torque_constant="2 Nm/A" time_constant="4 ms"/>)",
          "K6011", "0 kg m2", ""},
         {"pulse in rpm", R"(<laser pulse="40 rpm"/>)", "K6009", "40 rpm", "write `Hz` or `kHz`"},
         {"time of a tool change", R"(<function code="M6" takes="4 s"/>)", "K6212", "M6", ""},
         {"time of an end", R"(<function code="M30" takes="4 s"/>)", "K6212", "M30", ""},
         {"no M function", R"(<function code="G10" takes="4 s"/>)", "K6212", "G10", ""},
         {"no number", R"(<function code="Mx" takes="4 s"/>)", "K6212", "Mx", ""},
         {"function without time", R"(<function code="M10"/>)", "K9105", "function", ""},
         {"acts sometime", R"(<function code="M10" takes="1 s" acts="late"/>)", "K6017", "late",
          ""},
         {"waits perhaps", R"(<function code="M10" takes="1 s" waits="si"/>)", "K6017", "si", ""},
         {"doubled function",
          R"(<function code="M10" takes="1 s"/><function code="M10" takes="2 s"/>)", "K6014", "M10",
          ""},
         {"functions", R"(<scanner on="66" off="66" field="110 mm" jump_speed="8 m/s"/>)", "K6225",
          "66", ""},
         {"control's function", R"(<scanner on="3" off="66" field="110 mm" jump_speed="8 m/s"/>)",
          "K6018", "3", ""},
         {"three numbers",
          R"(<scanner on="66" off="67" field="110 mm" jump_speed="8 m/s" matrix="1 0 0"/>)",
          "K6220", "1 0 0", ""},
         {"a flat field",
          R"(<scanner on="66" off="67" field="110 mm" jump_speed="8 m/s" matrix="1 2 2 4"/>)",
          "K6220", "1 2 2 4", ""},
         {"late beam",
          R"(<scanner on="66" off="67" field="110 mm" jump_speed="8 m/s" laser_off_delay="1 us"/>)",
          "K6221", "1 us", ""},
         {"early beam",
          R"(<scanner on="66" off="67" field="110 mm" jump_speed="8 m/s" laser_on_delay="-1 us"/>)",
          "K6221", "-1 us", ""},
         {"no field", R"(<scanner on="66" off="67" field="0 mm" jump_speed="8 m/s"/>)", "K6011",
          "0 mm", ""},
         {"no table",
          R"(<scanner on="66" off="67" field="1 m" jump_speed="8 m/s" correction="no.csv"/>)",
          "K9001", "no.csv", ""},
         {"doubled drive", R"(<cutting force="1 kN"/><cutting force="2 kN"/>)", "K6014", "cutting",
          ""}}) {
        expect_mistake(mistake);
    }
}

TEST(MachineFile, EveryMistakeIsFoundAtOnce) {
    Loaded loaded;
    load(R"(<machine name="m" tick="0 s">
              <axis name="X" velocity="1" acceleration="5 m/s2"/>
              <axis nam="Y" velocity="1 m/s" acceleration="5 m/s2"/>
            </machine>)",
         loaded);
    std::string codes;
    for (const Diagnostic& said : loaded.diagnostics.all())
        codes += std::string(said.row->code) + " ";
    EXPECT_EQ(codes, "K9104 K6011 K6008 ");
    const Diagnostic& unit = loaded.diagnostics.all()[2];
    const LineColumn place = loaded.sources.locate(unit.range.file, unit.range.begin);
    EXPECT_EQ(place.line, 2u);
    EXPECT_EQ(place.column, 40u);
}

TEST(MachineFile, UnknownName) {
    Sources sources;
    DiagnosticList diagnostics;
    EXPECT_FALSE(load_machine("mil", {kStock}, sources, diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].row->code, "K6001");
    EXPECT_EQ(diagnostics.all()[0].fixes.at(0).text, "there is `mill`");
    EXPECT_EQ(diagnostics.all()[0].notes.at(0).text,
              "known are `borer`, `head-ab`, `head-cb`, `laser`, `lathe`, `lathe-c`, "
              "`lathe-set-up`, `mill`, `mill-fast`, `mill-set-up`, "
              "`mixed-cb`, `nutating`, `rotary-a`, `scanner`, `six-axis`, `trunnion-ac`, "
              "`trunnion-bc`");
}

TEST(MachineFile, UnreadableFile) {
    Sources sources;
    DiagnosticList diagnostics;
    EXPECT_FALSE(load_machine("/no/such/machine.xml", {kStock}, sources, diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].row->code, "K9001");
}

TEST(MachineFile, ADeepFileIsNoFall) {
    std::string deep = "<machine name=\"m\">";
    for (int i = 0; i < 100000; ++i) deep += "<a>";
    for (int i = 0; i < 100000; ++i) deep += "</a>";
    Loaded loaded;
    load(deep + "</machine>", loaded);
    EXPECT_FALSE(loaded.machine);
    ASSERT_EQ(loaded.diagnostics.all().size(), 1u);
    EXPECT_EQ(loaded.diagnostics.all()[0].row->code, "K9101");
}

}  // namespace
}  // namespace kadr::machine::load_test
