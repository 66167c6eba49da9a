#!/usr/bin/env python3
"""Records what LinuxCNC's interpreter says about programs/*.ngc into expected/*.jsonl.

Needs the Debian package linuxcnc-uspace; the tests do not. Run it with Debian's own python3
(/usr/bin/python3), for which that package brings its modules:

    /usr/bin/python3 tests/rs274/record.py            # record all programs
    /usr/bin/python3 tests/rs274/record.py --check    # compare with what is recorded, write nothing

The same interpreter is asked twice. `rs274 -g` prints every canonical call, but with four decimals
only; its Python door (`gcode.parse`, what the AXIS preview draws from) hands over full doubles, but
of motions, dwells, feeds and offsets alone. The two lists are joined call by call, and the join
fails if they differ by more than the printed digits can hide.

README.md says what the neutral form is and how canonical calls become it.
"""

import argparse
import ctypes
import itertools
import json
import math
import multiprocessing
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).resolve().parent
MM_PER_INCH = 25.4
# gcode.parse hands over inches, and rs274 takes its tables in inches.
PRINTED_DIGITS = 1e-4

# Calls that both doors report, by the name that rs274 prints.
SHARED = {
    "STRAIGHT_TRAVERSE": "straight_traverse",
    "STRAIGHT_FEED": "straight_feed",
    "ARC_FEED": "arc_feed",
    "DWELL": "dwell",
    "SET_FEED_RATE": "set_feed_rate",
    "SET_G5X_OFFSET": "set_g5x_offset",
    "SET_G92_OFFSET": "set_g92_offset",
    "USE_TOOL_LENGTH_OFFSET": "tool_offset",
}
# Arguments of these calls that are lengths; all others are numbers or angles.
LENGTHS = {
    "straight_traverse": range(0, 3),
    "straight_feed": range(0, 3),
    "arc_feed": (0, 1, 2, 3, 5),
    "set_feed_rate": range(0, 1),
    "set_g5x_offset": range(1, 4),
    "set_g92_offset": range(0, 3),
    "tool_offset": range(0, 3),
}


class RecordingError(Exception):
    """The interpreter failed, or said something for which there is no rule here."""


@dataclass
class Call:
    """A canonical call: lengths in mm, feeds in mm/min or mm/rev, angles in degrees."""

    name: str
    line: int  # of the program, from 1; 0 before the first block
    arguments: list


# ---------------------------------------------------------------- asking the interpreter


def read_machine(path):
    """Tool lengths and work offsets, mm, of the machine that Kadr uses in the same test."""
    root = xml.etree.ElementTree.parse(path).getroot()
    tools = {int(t.get("number")): millimetres(t.get("length")) for t in root.iter("tool")}
    offsets = {}
    for offset in root.iter("offset"):
        offsets[int(offset.get("number"))] = [millimetres(offset.get(a)) for a in "xyz"]
    return tools, offsets


def millimetres(text):
    number, unit = text.split()
    if unit != "mm":
        raise RecordingError(f"`{text}` is not in mm")
    return float(number)


def write_tables(folder, tools, offsets, scale):
    """The interpreter's tool table and parameter file; `scale` turns mm into its unit."""
    table = "".join(f"T{n} P{n} Z{length * scale!r}\n" for n, length in sorted(tools.items()))
    (folder / "tool.tbl").write_text(table)
    required = [*range(5161, 5170), *range(5181, 5190), *range(5210, 5221)]
    required += itertools.chain(*(range(5221 + 20 * i, 5231 + 20 * i) for i in range(9)))
    values = dict.fromkeys(required, 0.0)
    values[5220] = 1.0  # G54 is active at the start
    for number, xyz in offsets.items():
        for axis, value in enumerate(xyz):
            values[5221 + 20 * (number - 1) + axis] = value * scale
    text = "".join(f"{number} {value!r}\n" for number, value in sorted(values.items()))
    (folder / "machine.var").write_text(text)


def number_by_line(text):
    """The program with every N word replaced by the number of its line, which rs274 prints."""
    lines = []
    for number, line in enumerate(text.splitlines(), start=1):
        skip, rest = re.fullmatch(r"(\s*/?)\s*(?:N\d+)?(.*)", line).groups()
        lines.append(f"{skip.strip()}N{number} {rest}\n")
    return "".join(lines)


def printed_calls(program, folder, is_block_delete):
    """What rs274 prints, units as they stand there, and the unit that held for each call."""
    command = ["rs274", "-g", "-v", "machine.var", "-t", "tool.tbl", program.name]
    if is_block_delete:
        command.insert(1, "-b")
    output = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False).stdout
    if "PROGRAM_END()" not in output:
        raise RecordingError(f"rs274 did not reach the end:\n{output}")
    calls = []
    scale, line = 1.0, 0
    for text in output.splitlines():
        match = re.fullmatch(r"\s*\d+ N(\S+)\s+(\w+)\((.*)\)\s*", text)
        if not match:
            continue
        number, name, arguments = match.groups()
        if number.isdigit():
            line = int(number)
        if name == "USE_LENGTH_UNITS":
            scale = MM_PER_INCH if "INCHES" in arguments else 1.0
        if name == "COMMENT":
            calls.append((Call(name, line, [arguments.strip('"')]), scale))
            continue
        values = [word for word in re.split(r"[\s,]+", arguments) if word]
        calls.append((Call(name, line, [as_number(word) for word in values]), scale))
    return calls


def as_number(word):
    try:
        return float(word)
    except ValueError:
        return word


class Recorder:
    """The canon of gcode.parse: notes every call of interest with its full precision."""

    def __init__(self, parameter_file, tools, is_block_delete):
        self.parameter_file = str(parameter_file)
        self.tools = [(0, 0.0), *sorted(tools.items())]  # in the order of the tool table
        self.is_block_delete = is_block_delete
        self.calls = []

    def get_external_length_units(self):
        return 1.0  # mm

    def get_external_angular_units(self):
        return 1.0  # degrees

    def get_axis_mask(self):
        return 0x1FF

    def get_block_delete(self):
        return self.is_block_delete

    def check_abort(self):
        return False

    def get_tool(self, pocket):
        number, length = self.tools[pocket] if pocket < len(self.tools) else (-1, 0.0)
        return (number, 0.0, 0.0, length, *([0.0] * 9), 0)

    def next_line(self, state):
        pass

    def __getattr__(self, name):
        if name in SHARED.values():
            return lambda *arguments: self.calls.append((name, list(arguments)))
        if name.startswith("_") or name == "state":
            raise AttributeError(name)
        return lambda *arguments: None


def exact_calls(program, folder, tools, is_block_delete):
    """The calls of the Python door, lengths in mm."""
    import gcode  # of linuxcnc-uspace

    recorder = Recorder(folder / "machine.var", tools, is_block_delete)
    result, line = gcode.parse(str(program), recorder, "G21", "")
    if result > gcode.MIN_ERROR:
        raise RecordingError(f"{program.name}:{line}: {gcode.strerror(result)}")
    for name, arguments in recorder.calls:
        for index in LENGTHS.get(name, ()):
            arguments[index] *= MM_PER_INCH
    return recorder.calls


def load_tool_table(folder):
    """gcode.parse finds tools in a memory-mapped table that a running LinuxCNC would have made."""
    tooldata = ctypes.CDLL("libtooldata.so.0", mode=ctypes.RTLD_GLOBAL)
    statistics = ctypes.create_string_buffer(1 << 20)
    tooldata._Z17tool_mmap_creatorPK13EMC_TOOL_STATi(statistics, 0)
    tooldata._Z17tooldata_add_initi(0)
    if tooldata._Z13tooldata_loadPKcPPc(str(folder / "tool.tbl").encode(), None) != 0:
        raise RecordingError("the tool table was not loaded")


def join(printed, exact):
    """The printed calls with the full precision of the exact ones."""
    remaining = iter(exact)
    joined = []
    for call, scale in printed:
        if call.name not in SHARED:
            joined.append(call)
            continue
        name, arguments = next(remaining, (None, None))
        if name != SHARED[call.name]:
            raise RecordingError(f"the two doors differ: {call} is {name} {arguments}")
        check_alike(call, scale, name, arguments)
        joined.append(Call(call.name, call.line, arguments))
    left = [name for name, _ in remaining if name != "set_feed_rate"]
    if left:
        raise RecordingError(f"the Python door says more than rs274: {left}")
    return joined


def check_alike(call, scale, name, arguments):
    for index, shown in enumerate(call.arguments):
        value = arguments[index]
        unit = scale if index in LENGTHS.get(name, ()) else 1.0
        if abs(shown * unit - value) > PRINTED_DIGITS * unit:
            raise RecordingError(f"the two doors differ: {call} is {name} {arguments}")


# ---------------------------------------------------------------- canonical calls → neutral form


@dataclass
class State:
    """What canonical calls leave to those behind them."""

    words: list  # text of each line without comments, for what canonical calls do not tell
    axes: str    # X Y Z, and the rotary axes if the program names them
    shows_exact_stop: bool  # only where G61 stands: rs274's cycles stop exactly by themselves
    plane: str = "XY"
    feed: float = 0.0
    feed_mode: str = "per_minute"
    is_exact: bool = False
    work_offset: list = field(default_factory=lambda: [0.0] * 6)
    set_position: list = field(default_factory=lambda: [0.0] * 6)
    tool_length: float = 0.0    # as rs274 counts it: at once
    acting_length: float = 0.0  # as the neutral form counts it: from the first motion of Z
    position: list = None       # base system, mm and deg, tool length `tool_length` counted
    tool: int = 0
    spindle: str = "stop"
    speed: float = 0.0
    is_cutting_speed: bool = False
    coolant: str = "off"
    told_spindle: tuple = ("stop",)
    told_coolant: str = "off"
    commands: list = field(default_factory=list)


PLANES = {"CANON_PLANE_XY": "XY", "CANON_PLANE_XZ": "ZX", "CANON_PLANE_YZ": "YZ"}
# First, second and third axis of a plane, as indices into X Y Z.
PLANE_AXES = {"XY": (0, 1, 2), "ZX": (2, 0, 1), "YZ": (1, 2, 0)}


def neutral_commands(calls, text):
    """The commands of a program in the order of their effect."""
    words = [re.sub(r"\([^)]*\)|;.*", "", line).upper() for line in text.splitlines()]
    has_rotary = any(re.search("[ABC]", line) for line in words)
    has_exact_stop = any("G61" in line for line in words)
    state = State(words=["", *words], axes="XYZABC" if has_rotary else "XYZ",
                  shows_exact_stop=has_exact_stop)
    end_line = next(call.line for call in calls if call.name == "PROGRAM_END")
    for call in calls:
        if call.line == end_line and call.name not in MOTIONS and call.name != "PROGRAM_END":
            continue  # the end resets the machine; that is not the program's doing
        handler = HANDLERS.get(call.name)
        if handler is None and call.name not in IGNORED:
            raise RecordingError(f"no rule for {call}")
        if handler:
            handler(state, call)
        if call.name == "PROGRAM_END":
            break
    return state.commands


def emit(state, call, op, **values):
    """Appends a command; spindle and coolant first if they changed since the last one."""
    spindle = ("stop",)
    if state.spindle != "stop":
        spindle = (state.spindle, state.speed, state.is_cutting_speed)
    if spindle != state.told_spindle:
        state.told_spindle = spindle
        command = {"op": "spindle", "mode": state.spindle}
        if len(spindle) > 1:
            command["cutting_speed" if state.is_cutting_speed else "speed"] = state.speed
        state.commands.append({**command, "iso": call.line})
    if state.coolant != state.told_coolant:
        state.told_coolant = state.coolant
        state.commands.append({"op": "coolant", "mode": state.coolant, "iso": call.line})
    state.commands.append({"op": op, **values, "iso": call.line})


def base(state, coordinates):
    """Program coordinates of rs274 in the base system."""
    offsets = zip(state.work_offset, state.set_position)
    return [value + g5x + g92 for value, (g5x, g92) in zip(coordinates, offsets)]


def move(state, call, op, to, **values):
    """A motion to `to` (base system, tip of the tool as rs274 counts it)."""
    words = state.words[call.line]
    is_machine = re.search(r"G0*53(?!\d)", words) is not None
    slide_z = to[2] + state.tool_length
    moves_z = state.position is None or abs(slide_z - state.position[2]) > 1e-9 or "Z" in words
    if moves_z and not is_machine and state.acting_length != state.tool_length:
        state.acting_length = state.tool_length
        emit(state, call, "tool_length", length=round9(state.tool_length))
    was = state.position
    state.position = [to[0], to[1], slide_z, *to[3:]]
    if was and op != "arc" and max(abs(a - b) for a, b in zip(was, state.position)) < 1e-9:
        return  # a motion to where the machine stands; cycles of rs274 are full of them
    shown = list(state.position)
    if not is_machine:
        shown[2] -= state.acting_length
    command = {"to": {axis: round9(value) for axis, value in zip(state.axes, shown)}}
    if is_machine:
        command["machine_coordinates"] = True
    emit(state, call, op, **command, **values)


def feed_words(state, length):
    feed = state.feed
    if state.feed_mode == "inverse_time":
        feed = state.feed / length  # rs274 has turned F into mm/min; F is what it was made from
    words = {"feed": round9(feed)}
    if state.feed_mode != "per_minute":
        words["feed_mode"] = state.feed_mode
    if state.is_exact and state.shows_exact_stop:
        words["exact_stop"] = True
    return words


def straight_traverse(state, call):
    move(state, call, "rapid", base(state, call.arguments[:6]))


def straight_feed(state, call):
    to = base(state, call.arguments[:6])
    start = [*state.position]
    delta = [to[i] + (state.tool_length if i == 2 else 0) - start[i] for i in range(3)]
    length = math.hypot(*delta)
    move(state, call, "line", to, **feed_words(state, length or 1.0))


def arc_feed(state, call):
    first_end, second_end, *center_in_plane, rotation, axis_end = call.arguments[:6]
    rotary = call.arguments[6:]
    if abs(rotation) != 1:
        raise RecordingError(f"additional turns are no common core: {call}")
    first, second, axis = PLANE_AXES[state.plane]
    to = [0.0] * 3
    center = [0.0] * 3
    to[first], to[second], to[axis] = first_end, second_end, axis_end
    center[first], center[second] = center_in_plane
    to = base(state, [*to, *rotary[:3]])
    center = base(state, [*center, 0, 0, 0])[:3]
    start = state.position[:3]
    start[2] -= state.tool_length
    center[axis] = start[axis]
    turn = arc_sweep(start, to, center, first, second, rotation)
    radius = math.hypot(start[first] - center[first], start[second] - center[second])
    length = math.hypot(turn * radius, to[axis] - start[axis])
    if state.tool_length != state.acting_length and axis != 2:
        center[2] += state.tool_length - state.acting_length
    move(state, call, "arc", to, center=[round9(c) for c in center], plane=state.plane,
         dir="cw" if rotation < 0 else "ccw", sweep=round9(turn),
         **feed_words(state, length))


def arc_sweep(start, to, center, first, second, rotation):
    """Angle that the arc runs through, rad, > 0; an end equal to the start is a full turn."""
    begin = math.atan2(start[second] - center[second], start[first] - center[first])
    end = math.atan2(to[second] - center[second], to[first] - center[first])
    sweep = (end - begin) if rotation > 0 else (begin - end)
    # rs274 takes ends closer than 1e-6 of a turn for the same.
    while sweep <= 1e-6:
        sweep += 2 * math.pi
    return sweep


def comment(state, call):
    """rs274 tells the feed mode in a comment of its own."""
    modes = {"units per minute": "per_minute", "units per revolution": "per_revolution",
             "inverse time": "inverse_time"}
    match = re.fullmatch(r"interpreter: feed mode set to (.*)", call.arguments[0])
    if match:
        state.feed_mode = modes[match.group(1)]


def set_value(name):
    return lambda state, call: setattr(state, name, call.arguments[0])


def set_constant(name, value):
    return lambda state, call: setattr(state, name, value)


def set_offset(name, first):
    return lambda state, call: setattr(state, name, call.arguments[first:first + 6])


def change_tool(state, call):
    state.tool = int(call.arguments[0])
    emit(state, call, "tool", tool=state.tool)


def spindle_mode(state, call):
    state.is_cutting_speed = call.arguments[-1] > 0


MOTIONS = {"STRAIGHT_TRAVERSE": straight_traverse, "STRAIGHT_FEED": straight_feed,
           "ARC_FEED": arc_feed}
HANDLERS = {
    **MOTIONS,
    "COMMENT": comment,
    "DWELL": lambda state, call: emit(state, call, "dwell", time=call.arguments[0]),
    "SET_FEED_RATE": set_value("feed"),
    "SELECT_PLANE": lambda state, call: setattr(state, "plane", PLANES[call.arguments[0]]),
    "SET_G5X_OFFSET": set_offset("work_offset", 1),
    "SET_G92_OFFSET": set_offset("set_position", 0),
    "USE_TOOL_LENGTH_OFFSET": lambda state, call: setattr(state, "tool_length", call.arguments[2]),
    "SET_MOTION_CONTROL_MODE": lambda state, call: setattr(
        state, "is_exact", call.arguments[0] != "CANON_CONTINUOUS"),
    "CHANGE_TOOL": change_tool,
    "SET_SPINDLE_SPEED": lambda state, call: setattr(state, "speed", call.arguments[1]),
    "SET_SPINDLE_MODE": spindle_mode,
    "START_SPINDLE_CLOCKWISE": set_constant("spindle", "cw"),
    "START_SPINDLE_COUNTERCLOCKWISE": set_constant("spindle", "ccw"),
    "STOP_SPINDLE_TURNING": set_constant("spindle", "stop"),
    "FLOOD_ON": set_constant("coolant", "flood"),
    "MIST_ON": set_constant("coolant", "mist"),
    "FLOOD_OFF": set_constant("coolant", "off"),
    "MIST_OFF": set_constant("coolant", "off"),
    "PROGRAM_STOP": lambda state, call: emit(state, call, "stop"),
    "OPTIONAL_PROGRAM_STOP": lambda state, call: emit(state, call, "optional_stop"),
    "PROGRAM_END": lambda state, call: emit(state, call, "end"),
}
# Calls that say nothing that a command of Kadr would.
IGNORED = {
    "USE_LENGTH_UNITS", "SET_XY_ROTATION", "SET_FEED_REFERENCE", "ON_RESET", "SET_FEED_MODE",
    "SELECT_TOOL", "START_CHANGE", "SET_NAIVECAM_TOLERANCE", "PALLET_SHUTTLE",
}


def round9(value):
    """Nine decimals of a mm: below every tolerance, and the same text on every machine."""
    return round(value, 9) + 0.0


# ---------------------------------------------------------------- files


def record(program, tables):
    """The lines of the program's file of commands."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            return record_in(program, Path(folder), tables)
        except RecordingError as error:
            raise RecordingError(f"{program.name}: {error}") from None


def record_in(program, folder, tables):
    text = program.read_text()
    is_block_delete = "block delete on" in text.splitlines()[0]
    copy = folder / program.name
    copy.write_text(number_by_line(text))
    os.environ["HOME"] = str(folder)  # where the interpreter keeps a memory-mapped tool table
    write_tables(folder, *tables, scale=1 / MM_PER_INCH)
    printed = printed_calls(copy, folder, is_block_delete)
    write_tables(folder, *tables, scale=1.0)
    load_tool_table(folder)
    exact = exact_calls(copy, folder, tables[0], is_block_delete)
    commands = neutral_commands(join(printed, exact), text)
    return "".join(json.dumps(command, separators=(",", ":")) + "\n" for command in commands)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("programs", nargs="*", help="names without suffix; all by default")
    options = parser.parse_args()
    tables = read_machine(HERE / "machine.xml")
    programs = sorted((HERE / "programs").glob("*.ngc"))
    if options.programs:
        programs = [p for p in programs if p.stem in options.programs]
    # One process a program: the interpreter's tool table can be set up once in a process.
    with multiprocessing.Pool(maxtasksperchild=1) as pool:
        texts = pool.starmap(record, [(program, tables) for program in programs], chunksize=1)
    changed = 0
    for program, text in zip(programs, texts):
        expected = HERE / "expected" / f"{program.stem}.jsonl"
        if expected.exists() and expected.read_text() == text:
            continue
        changed += 1
        print(f"{program.stem}: {'differs from its record' if options.check else 'recorded'}")
        if not options.check:
            expected.write_text(text)
    return 1 if options.check and changed else 0


if __name__ == "__main__":
    sys.exit(main())
