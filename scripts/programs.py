"""The programs below tests/, examples/ and stdlib/, and how each wants to be run: what its folder
and its comments say."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
DIALECTS = ["dialects", "tests/control/dialects", "examples/dialects"]
TEXTS = {".nc", ".NC", ".mpf", ".MPF", ".spf", ".SPF", ".ngc", ".iso", ".i", ".cnc"}


def programs_below(*folders):
    """Kadr sources and ISO-7bit texts, in the order of their paths."""
    return sorted(path for folder in folders for path in (ROOT / folder).rglob("*")
                  if path.is_file() and (path.suffix == ".kadr" or path.suffix in TEXTS))


def dialects_of(path, text):
    """For which controls a program is meant."""
    said = re.search(r"^// dialect: (\S+)", text, re.M)
    if said:
        return [said[1]]
    parts = path.relative_to(ROOT).parts
    if path.suffix == ".kadr":
        lathe = "-m lathe" in text or "lathe" in path.name
        return ["sinumerik", "fanuc-lathe"] if lathe else ["sinumerik", "fanuc"]
    for part in reversed(parts[:-1]):
        for folder in DIALECTS:
            if (ROOT / folder / f"{part}.xml").exists():
                return [part if folder == DIALECTS[0] else str(ROOT / folder / f"{part}.xml")]
        if part == "rs274":
            return [str(ROOT / "tests/rs274/linuxcnc.xml")]
    return ["sinumerik" if path.suffix.lower() in (".mpf", ".spf") else "fanuc"]


def machine_of(text):
    """The options that name the stock machine of a program; none: its control's own."""
    said = re.search(r"machine: ([\w-]+)", text)
    name = said[1] if said else ""
    if name == "five-axis":
        return ["-m", "trunnion-ac"]
    if name == "lathe" or "-m lathe" in text:
        return ["-m", "lathe"]
    return ["-m", name] if (ROOT / f"runtime/machines/{name}.xml").exists() else []
