"""The blocks in Python."""
import sys
from math import cos, pi, sin


def number(value):
    """`12.5`: three decimals at most, no zeros behind the last digit that counts."""
    text = f"{value:.3f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def main():
    blocks = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    write = sys.stdout.write
    write("N10 G90\n")
    for i in range(blocks):
        angle = i * 0.37 * (pi / 180)
        motion = " G1" if i == 0 else ""
        write(f"N{10 * (i + 2)}{motion} X{number(100 * cos(angle))} Y{number(100 * sin(angle))}"
              f" Z{number(i * 0.001)}\n")


main()
