#!/usr/bin/env python3
"""What rooms cost to compile, as a Markdown table on standard output: processor seconds of a unit of each room that uses
one function of it, by numbers of bands; the median of several runs, on a machine that does nothing else.

  table.py [BANDS...]      3 5 9 where none is given; CXX and CXXFLAGS as usual, g++ -O2 where they are not set
"""
import os
import pathlib
import resource
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
RUNS = 3
# From the first to what needs it; `standard` and `zonal` use nothing.
UNITS = ["standard", "zonal", "basis", "gradient", "lobe", "transform", "product", "environment", "fit", "light",
         "material", "gather", "grid", "fill", "screen", "field", "shader"]


def seconds(command):
    """Processor seconds of a command and what it starts."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    bands = [int(argument) for argument in sys.argv[1:]] or [3, 5, 9]
    compiler, flags = os.environ.get("CXX", "g++"), os.environ.get("CXXFLAGS", "-O2")
    # The plain compiler, and Eigen where Debian has it.
    command = [compiler, "-std=c++17", *flags.split(), f"-I{HERE.parent.parent / 'include'}",
               "-idirafter", "/usr/include/eigen3", "-c", "-o", os.devnull]

    def median(unit, n):
        return statistics.median(seconds([*command, f"-DBANDS={n}", str(HERE / f"{unit}.cpp")]) for _ in range(RUNS))

    median("standard", 3)  # the compiler itself, from the disk
    print(f"Compile time in processor seconds, `{compiler} -std=c++17 {flags}`, headers included, by bands:\n")
    print(f"| unit of `bench/compile/` | uses | {' | '.join(map(str, bands))} |")
    print(f"|:--|:--|{'--:|' * len(bands)}")
    for unit in UNITS:
        use = (HERE / f"{unit}.cpp").read_text().splitlines()[0].removeprefix("// ").rstrip(".")
        times = " | ".join(f"{median(unit, n):.2f}" for n in bands)
        print(f"| {unit} | {use} | {times} |", flush=True)


if __name__ == "__main__":
    main()
