#!/usr/bin/env python3
"""Runs the benchmarks and prints what they say as a table; README.md explains the rows.

    bench/run.py BUILD                 all rows
    bench/run.py BUILD --only expand   rows whose name contains the word
    bench/run.py BUILD --readme        also writes the table into README.md

BUILD is a Release build folder configured with -DKADR_BENCH=ON. Peers that are not installed are
left out and named. CPU time is the least of several runs, memory the greatest of one.
"""

import argparse
import datetime
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
PROGRAMS = HERE / "programs"
BLOCKS = 1_000_000
LINES = 10_000
RUNS = 5
STARTS = 50
LINUXCNC_PLAN = 1.9  # µs a line in its planner, 50 lines deep; measured when Kadr was designed


class BenchError(Exception):
    """A program failed, or wrote something else than its peer."""


@dataclass
class Cost:
    cpu: float   # s, user and system
    wall: float  # s
    peak: float  # MiB


@dataclass
class Row:
    work: str
    kadr: str
    peer: str
    ratio: str
    budget: str
    verdict: str


class Bench:
    def __init__(self, build, folder):
        self.build = build
        self.folder = folder
        self.rows = []
        self.missing = set()

    # ------------------------------------------------------------ measuring

    def cost(self, command, runs=RUNS, output=None):
        """The least CPU and elapsed time of several runs, and the greatest memory."""
        best = None
        for _ in range(runs):
            now = self.cost_of_one(command, output)
            if best is None:
                best = now
            best = Cost(min(best.cpu, now.cpu), min(best.wall, now.wall), max(best.peak, now.peak))
        return best

    def cost_of_one(self, command, output):
        """One run through the measuring program, which reports on file descriptor 3."""
        reader, writer = os.pipe()
        script = 'exec 3>&"$0"; exec "$@"'
        shell = ["bash", "-c", script, str(writer), str(self.build / "bench_measure"), *command]
        with open(output or os.devnull, "wb") as sink:
            result = subprocess.run(shell, stdout=sink, stderr=subprocess.PIPE, cwd=self.folder,
                                    pass_fds=[writer], check=False)
        os.close(writer)
        with os.fdopen(reader) as pipe:
            words = pipe.read().split()
        if len(words) != 4 or words[3] != "0":
            message = result.stderr.decode(errors="replace")
            raise BenchError(f"failed: {' '.join(map(str, command))}\n{message}")
        return Cost(float(words[0]), float(words[1]), float(words[2]) / 1024)

    def output_of(self, command):
        return subprocess.run(command, capture_output=True, cwd=self.folder, check=True).stdout

    def items(self, *arguments):
        """Items a second of `bench_runtime`, the best of several runs."""
        best = 0.0
        for _ in range(RUNS):
            output = self.output_of([self.build / "bench_runtime", *map(str, arguments)])
            count, seconds = output.split()
            best = max(best, int(count) / float(seconds))
        return best

    def kadr(self, *arguments):
        return [str(self.build / "kadr"), *map(str, arguments)]

    def has(self, program):
        if shutil.which(program):
            return True
        self.missing.add(program)
        return False

    def add(self, work, kadr, peer="", ratio="", budget="", verdict=""):
        self.rows.append(Row(work, kadr, peer, ratio, budget, verdict))
        print(f"{work}: {kadr} | {peer} | {ratio}", file=sys.stderr)

    # ------------------------------------------------------------ rows

    def expand(self):
        """One million blocks from a loop, the same bytes from everybody."""
        source = PROGRAMS / "expand.kadr"
        command = self.kadr("expand", source, "-d", HERE / "dialect.xml")
        text = self.folder / "expanded.nc"
        mine = self.cost(command, output=text)
        peers = {
            "C++ to_chars": [self.build / "bench_to_chars"],
            "C++ libfmt": [self.build / "bench_fmt"],
            "Lua 5.4": ["lua5.4", PROGRAMS / "expand.lua"],
            "Python 3": [sys.executable, PROGRAMS / "expand.py"],
        }
        for name, peer in peers.items():
            if not self.has(peer[0]):
                continue
            other = self.cost_of_same_text(peer, text)
            limits = (0.5, 0.8) if name == "C++ to_chars" else None
            self.compare(f"expand a loop, against {name}", BLOCKS, mine, other, limits)

        mine = self.cost([*command, "--verbose-modal"], output=text)
        other = self.cost_of_same_text([self.build / "bench_to_chars", BLOCKS, "repeat"], text)
        self.compare("… with `--verbose-modal` (G1 in every line), against C++ to_chars", BLOCKS,
                     mine, other)

    def interpret(self):
        """One million flat blocks, read and interpreted."""
        flat = self.flat_program(BLOCKS)
        mine = self.cost(self.check_command(flat))
        if self.has("rs274"):
            other = self.cost(["rs274", "-g", str(flat)], runs=2)
            self.compare("read and interpret flat blocks, against rs274", BLOCKS, mine, other,
                         (20, 50))
            self.add("… memory", mib(mine.peak), mib(other.peak))
        plain = self.folder / "plain.mpf"
        signs = self.folder / "signs.mpf"
        plain.write_bytes(flat.read_bytes().replace(b"G21", b"G71", 1))
        signs.write_bytes(re.sub(rb"([XYZF])(?=[-.0-9])", rb"\1=", plain.read_bytes()))
        without = self.cost(self.check_command(plain, "sinumerik"))
        signed = self.cost(self.check_command(signs, "sinumerik"))
        self.compare("… SINUMERIK, `X=1.5` in every word, against `X1.5`", BLOCKS, signed, without,
                     (0.33, 0.9))
        for room in ("read", "interpret"):
            speed = self.items(room, flat, "iso")
            self.add(f"… `bench_runtime {room}`", rate(speed, "blocks"))

    def macro(self):
        """A loop of the control's own language with one move a pass."""
        passes = {"nc": BLOCKS, "mpf": BLOCKS, "ngc": BLOCKS // 10}
        other = None
        if self.has("rs274"):
            cost = self.cost(["rs274", "-g", str(PROGRAMS / "macro.ngc")], runs=2)
            other = passes["ngc"] / cost.cpu
        for suffix, dialect in {"nc": "fanuc", "mpf": "sinumerik"}.items():
            mine = self.cost(self.kadr("check", PROGRAMS / f"macro.{suffix}", "-d", dialect,
                                       "-m", HERE / "machine.xml"))
            moves = passes[suffix] / mine.cpu
            ratio = moves / other if other else 0
            self.add(f"macro loops, {dialect}, against rs274 O-words", rate(moves, "moves"),
                     rate(other, "moves") if other else "", f"{ratio:.0f}" if other else "",
                     *(reached(ratio, (20, 50)) if other else ("", "")))

    def parse(self):
        """Sources of 10,000 lines: what parsing and checking take, and what Lua's compiler does."""
        for shape, write in {"statements": statements, "one sum": one_sum}.items():
            source = self.folder / "long.kadr"
            script = self.folder / "long.lua"
            write(source, script, LINES)
            size = source.stat().st_size
            parsing, checking = map(float, self.output_of(
                [self.build / "bench_parse", source]).split())
            micros = parsing / size * 1e6
            self.add(f"parse {LINES} lines, {shape}", f"{parsing * 1e3:.0f} ms, {micros:.2f} µs/byte",
                     "", "", "1 µs/byte", judge(1 / micros, 1, float("inf")))
            self.add("… and check them", f"{checking * 1e3:.0f} ms")
            mine = self.cost(self.kadr("check", source))
            if self.has("luac5.4"):
                other = self.cost(["luac5.4", "-p", script])
                self.add("… `kadr check`, against luac -p of as many lines", f"{mine.cpu * 1e3:.0f} ms",
                         f"{other.cpu * 1e3:.0f} ms", f"{other.cpu / mine.cpu:.2f}")

    def evaluate(self):
        """Loops without output."""
        for name in ("loop", "trigonometry", "array", "calls"):
            source = PROGRAMS / f"{name}.kadr"
            command = self.kadr("expand", source, "-d", HERE / "dialect.xml")
            mine = self.cost(command)
            for peer, call in {"Lua 5.4": ["lua5.4"], "LuaJIT -joff": ["luajit", "-joff"]}.items():
                if not self.has(call[0]):
                    continue
                script = [*call, str(PROGRAMS / f"{name}.lua")]
                result = self.output_of(script).decode().strip()
                if result not in self.output_of(command).decode():
                    raise BenchError(f"{name}: Kadr does not come to {result}")
                other = self.cost(script)
                ratio = other.cpu / mine.cpu
                limits = (1, 2) if peer == "Lua 5.4" else None
                self.add(f"evaluate `{name}`, against {peer}", f"{mine.cpu:.3f} s",
                         f"{other.cpu:.3f} s", f"{ratio:.2f}", *reached(ratio, limits))

    def motion(self):
        """Planning and sampling inside one process."""
        for depth in (50, 1024, 20000):
            time = 1e6 / self.items("plan", depth)  # µs a line
            self.add(f"plan lines, look-ahead {depth}", f"{time:.2f} µs",
                     f"{LINUXCNC_PLAN} µs (LinuxCNC, 50 deep)", f"{LINUXCNC_PLAN / time:.1f}",
                     "1 µs, aim 0.3", judge(1 / time, 1, 1 / 0.3))
        time = 1e6 / self.items("plan", 1024, "smooth")
        self.add("… under a limit of the jerk, look-ahead 1024", f"{time:.2f} µs", "", "",
                 "1 µs, aim 0.3", judge(1 / time, 1, 1 / 0.3))
        time = 1e6 / self.items("plan", 1024, "circles")
        self.add("plan cells of fast circles, look-ahead 1024", f"{time:.2f} µs", "", "", "", "")
        for kind in ("lines", "arcs", "helices"):
            setpoints = self.items("sample", kind)
            # What the laser paper reached along lines and along splines.
            self.add(f"sample {kind}", rate(setpoints, "setpoints"), "50 kHz (laser paper)",
                     f"{setpoints / 5e4:.0f}", "5 M/s, aim 20", judge(setpoints, 5e6, 20e6))
        for kind in ("cspline", "bspline", "nurbs", "poly", "involute"):
            setpoints = self.items("curves", kind)
            self.add(f"sample {kind}", rate(setpoints, "setpoints"), "10 kHz (laser paper)",
                     f"{setpoints / 1e4:.0f}", "1 M/s, aim 5", judge(setpoints, 1e6, 5e6))
            setpoints = self.items("curves", kind, "whole")
            self.add("… text to setpoints", rate(setpoints, "setpoints"), "10 kHz (laser paper)",
                     f"{setpoints / 1e4:.0f}", "", "")
        for machine, length in (("trunnion-ac", 20), ("head-cb", 20), ("trunnion-ac", 1)):
            setpoints = self.items("five_axis", machine, length)
            self.add(f"five axes, {machine}, lines of {length} mm: text to setpoints",
                     rate(setpoints, "setpoints"), "", "", "1 M/s, aim 3",
                     judge(setpoints, 1e6, 3e6))

    def memory(self):
        """Peak memory must not grow with the program."""
        source = PROGRAMS / "expand.kadr"
        for blocks in (BLOCKS, 10 * BLOCKS):
            flat = self.flat_program(blocks)
            commands = {
                "expand": self.kadr("expand", source, "-d", HERE / "dialect.xml", "-D",
                                    f"blocks={blocks}"),
                "check": self.check_command(flat),
                "run": self.kadr("run", flat, "-d", "iso", "-m", HERE / "machine.xml", "--summary",
                                 "json"),
            }
            for name, command in commands.items():
                peak = self.cost(command, runs=1).peak
                self.add(f"memory of `kadr {name}`, {blocks // BLOCKS} M blocks", mib(peak), "", "",
                         "64 MiB, aim 32", judge(1 / peak, 1 / 64, 1 / 32))

    def start(self):
        """A ten-line program, process start included."""
        for dialect in ("iso", "fanuc", "sinumerik"):
            command = self.kadr("expand", PROGRAMS / "start.kadr", "-d", dialect)
            mine = self.cost(command, runs=STARTS)
            self.add(f"start: ten lines, {dialect}", f"{mine.wall * 1e3:.1f} ms", "", "",
                     "20 ms, aim 5", judge(1 / mine.wall, 50, 200))
        if self.has("lua5.4"):
            lua = self.cost(["lua5.4", "-e", ""], runs=STARTS)
            self.add("start: an empty Lua program, to compare", "", f"{lua.wall * 1e3:.1f} ms")

    # ------------------------------------------------------------ parts of rows

    def compare(self, work, blocks, mine, other, limits=None):
        ratio = other.cpu / mine.cpu
        shown = f"{ratio:.2f}" if ratio < 10 else f"{ratio:.0f}"
        self.add(work, rate(blocks / mine.cpu, "blocks"), rate(blocks / other.cpu, "blocks"), shown,
                 *reached(ratio, limits))

    def cost_of_same_text(self, peer, text):
        """What the peer costs that must write the same bytes."""
        other_text = self.folder / "peer.nc"
        other = self.cost([*map(str, peer)], output=other_text)
        if other_text.read_bytes() != text.read_bytes():
            raise BenchError(f"{peer[0]} writes other bytes than kadr")
        return other

    def check_command(self, flat, dialect="iso"):
        return self.kadr("check", flat, "-d", dialect, "-m", HERE / "machine.xml")

    # ------------------------------------------------------------ input

    def flat_program(self, blocks):
        """The expanded blocks as a program that rs274 and Kadr read."""
        path = self.folder / f"flat-{blocks}.ngc"
        if not path.exists():
            body = subprocess.Popen([self.build / "bench_to_chars", str(blocks), "flat"],
                                    stdout=subprocess.PIPE)
            with open(path, "wb") as out:
                out.write(b"N1 G17 G21 G94 F1000\n")
                out.flush()
                shutil.copyfileobj(body.stdout, out)
                out.write(b"M30\n")
            body.wait()
        return path


def statements(source, script, lines):
    """The statements that programs are made of, in turn, as Kadr and as Lua."""
    kadr = ["length r{0} = {0}mm + r * 2;", "if (r{1} > 5mm) {{ r += 1mm; }} else {{ r -= 0.5mm; }}",
            "G1 X=r*cos({0}deg) Y=r*sin({0}deg) F200;", "for (int i = 0; i < {0}; i++) r += i * 1mm;",
            "G0 X{0} Y-{0}.5 Z5; // a comment"]
    lua = ["local r{0} = {0} + r * 2", "if r{1} > 5 then r = r + 1 else r = r - 0.5 end",
           "G(1, r * math.cos({0}), r * math.sin({0}), 200)", "for i = 0, {0} - 1 do r = r + i end",
           "G(0, {0}, -{0}.5, 5) -- a comment"]
    # Lua has no more than 200 locals in a function; both are cut into functions of 100 lines.
    for path, rows, begin, end in ((source, kadr, "cycle c{0}(length r) {{", "}}"),
                                   (script, lua, "local function c{0}(r)", "end c{0}(1)")):
        text = []
        for part in range(lines // 100):
            text.append(begin.format(part))
            for i in range(98):
                text.append(rows[i % 5].format(i + 1, i))
            text.append(end.format(part))
        calls = " ".join(f"c{part}({part}mm);" for part in range(lines // 100))
        if path is source:
            text.append(f"program long() {{ {calls} }}")
        path.write_text("\n".join(text) + "\n")


def one_sum(source, script, lines):
    """One expression with a term a line."""
    terms = "\n    + ".join(f"a * {i}" for i in range(lines))
    source.write_text(f"program long(int a = 1) {{ int s = {terms}; note \"{{s}}\"; }}\n")
    script.write_text(f"local a = 1 local s = {terms} print(s)\n")


def rate(items, what):
    if items >= 1e6:
        return f"{items / 1e6:.2f} M {what}/s"
    return f"{items / 1e3:.0f} k {what}/s"


def mib(size):
    return f"{size:.0f} MiB"


def reached(value, limits):
    """The columns budget and verdict of a row with these limits; empty without."""
    if limits is None:
        return "", ""
    budget, aim = limits
    return f"{budget}, aim {aim}", judge(value, budget, aim)


def judge(value, budget, aim):
    return "aim" if value >= aim else "budget" if value >= budget else "**missed**"


def table(rows):
    lines = ["| work | Kadr | peer | ratio | budget | reached |", "|" + " --- |" * 6]
    for row in rows:
        cells = (row.work, row.kadr, row.peer, row.ratio, row.budget, row.verdict)
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def machine_line():
    model = platform.processor() or platform.machine()
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    return f"{model}, {os.cpu_count()} cores, {datetime.date.today().isoformat()}"


def write_readme(text):
    readme = HERE / "README.md"
    begin, end = "<!-- figures -->\n", "<!-- end of figures -->\n"
    page = readme.read_text()
    head, rest = page.split(begin)
    tail = rest.split(end)[1]
    readme.write_text(f"{head}{begin}\n{text}\n\n{end}{tail}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("--only", default="", help="rows whose group contains this word")
    parser.add_argument("--readme", action="store_true", help="write the table into README.md")
    options = parser.parse_args()
    groups = ("parse", "expand", "interpret", "macro", "evaluate", "motion", "memory", "start")
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options.build.resolve(), Path(folder))
        for group in groups:
            if options.only in group:
                try:
                    getattr(bench, group)()
                except BenchError as error:
                    failed = True
                    print(f"{group}: {error}", file=sys.stderr)
    text = f"{machine_line()}\n\n{table(bench.rows)}"
    if bench.missing:
        text += f"\n\nNot installed, left out: {', '.join(sorted(bench.missing))}."
    print(text)
    if options.readme and not failed:
        write_readme(text)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
