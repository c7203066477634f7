"""Captures, bakes and renders light fields for docs/report by the field- programs, and writes field.csv and pictures;
see report.sh.

    report_field.py FIELD_CAPTURE FIELD_BAKE FIELD_RENDER FOLDER [--quick|--full]
"""
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

from report_render import joined, reported, write

FIELDS = ["part", "setup", "probes", "spacing", "texels", "samples", "resolution", "method", "interpolation", "error",
          "sort_s", "bake_s", "places", "rmse", "scene", "paths"]

# `probes`: cubes, one probe at random in each cell. `space`: the largest grid by the paper's steps.
SHORT = {"texels": 64, "samples": 8, "probes": (125, 343, 1000), "resolutions": (8, 16, 32, 64), "space": 16,
         "hermite": 32, "places": 200, "truth_samples": 16384, "size": (240, 176), "paths": 64}
FULL = {**SHORT, "texels": 128, "samples": 16, "space": 32, "places": 500, "paths": 256}
QUICK = {"texels": 16, "samples": 1, "probes": (8, 27), "resolutions": (4, 8), "space": 4, "hermite": 8, "places": 20,
         "truth_samples": 256, "size": (48, 40), "paths": 4}  # shows that all is there
SETUPS = ("projector", "spots")
METHODS = {"linear": [], "mean": ["--estimate", "mean"], "nearest": ["--repair", "nearest"], "space": ["--path", "space"]}


# ---- Grids, and what they say at a place ----------------------------------------------------------------------------

class Grid:
    """A file of floats as grid_file.hpp has it."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        bands, *self.resolution = numpy.frombuffer(data, "<u4", 4, 12)
        self.low, self.high = numpy.frombuffer(data, "<f4", 6, 28).astype(float).reshape(2, 3)
        numbers = numpy.frombuffer(data, "<f4", int(numpy.frombuffer(data, "<u8", 1, 52)[0]), 60)
        self.blocks = numbers.reshape(*self.resolution[::-1], -1, 3 * bands * bands)

    def at(self, places, interpolation):
        """Coefficients, by the formula of interpolation_weights.hpp."""
        cells = numpy.array(self.resolution) - 1.0
        where = numpy.clip((places - self.low) / (self.high - self.low) * cells, 0, cells)
        corner = numpy.minimum(where.astype(int), cells.astype(int) - 1)
        t, size = where - corner, (self.high - self.low) / cells
        ends = [numpy.stack([1 - t, t]), t * (1 - t) * (1 - 2 * t) * numpy.array([1, -1])[:, None, None],
                size * t * (1 - t) * numpy.stack([1 - t, -t])]
        total = 0
        for far in numpy.ndindex(2, 2, 2):
            linear, bump, slope = ([end[far[axis], :, axis] for axis in range(3)] for end in ends)
            x, y, z = (corner + far).T
            blocks = self.blocks[z, y, x]
            weights = [numpy.prod(linear, axis=0)]
            if interpolation == "hermite":
                other = [linear[(axis + 1) % 3] * linear[(axis + 2) % 3] for axis in range(3)]
                weights[0] = weights[0] + sum(bump[axis] * other[axis] for axis in range(3))
                weights += [slope[axis] * other[axis] for axis in range(3)]
            total = total + sum(weight[:, None] * blocks[:, block] for block, weight in enumerate(weights))
        return total


def relative_rms(values, truth):
    return math.sqrt(((values - truth) ** 2).sum() / (truth ** 2).sum())


# ---- Fields ------------------------------------------------------------------------------------------------------------

class Fields:
    def __init__(self, capture, bake, render, scratch, plan):
        self.capture_program, self.bake_program, self.render_program = capture, bake, render
        self.scratch, self.plan = pathlib.Path(scratch), plan

    def folder(self, setup, probes):
        return self.scratch / f"{setup}_{probes}"

    def capture(self, setup, *options):
        subprocess.run([self.capture_program, "--quiet", "--setup", setup, *map(str, options)], check=True)

    def capture_all(self):
        for setup in SETUPS:
            for probes in self.plan["probes"]:
                self.capture(setup, "--probes", probes, "--layout", "random", "--size", self.plan["texels"],
                             "--samples", self.plan["samples"], "--out", self.folder(setup, probes))

    def box(self, setup):
        """Of the volume, as field-capture says it: low and high corner."""
        settings = (self.folder(setup, self.plan["probes"][0]) / "settings.txt").read_text(encoding="utf-8")
        return next(line.split()[1:] for line in settings.splitlines() if line.startswith("box "))

    def truth(self, setup):
        """Random places in the volume, and the coefficients that arrive there."""
        low, high = numpy.array(self.box(setup), float).reshape(2, 3)
        places, out = self.scratch / "places.txt", self.scratch / "truth.csv"
        numpy.savetxt(places, numpy.random.default_rng(1).uniform(low, high, (self.plan["places"], 3)))
        self.capture(setup, "--truth", places, "--bands", 5, "--truth-samples", self.plan["truth_samples"], "--out", out)
        numbers = numpy.loadtxt(out, delimiter=",", skiprows=1)
        return numbers[:, :3], numbers[:, 3:]

    def grid_file(self, setup, probes, resolution, method):
        return self.scratch / f"{setup}_{probes}_{resolution}_{method}.grid"

    def bake(self, setup, probes, resolution, method, *options):
        folder = self.folder(setup, probes)
        facts = reported(self.scratch, self.bake_program, folder / "sequence.txt", "--quiet", "--grid", resolution, "--box",
                         ",".join(self.box(setup)), "--out", self.grid_file(setup, probes, resolution, method), "--work",
                         folder / "work", "--keep-work", *METHODS[method], *options)
        return {"probes": facts["counts"]["probes"], "bake_s": facts["seconds"]["resampling"],
                "sort_s": facts["seconds"]["sorting pictures"]}


def errors(fields, plan):
    """Of every grid; Hermite's of a bake with gradients, whose values are those without."""
    for setup in SETUPS:
        places, truth = fields.truth(setup)
        most = plan["probes"][-1]
        bakes = [(probes, resolution, "linear") for probes in plan["probes"] for resolution in plan["resolutions"]]
        bakes += [(most, resolution, method) for method in ("mean", "nearest", "space")
                  for resolution in plan["resolutions"] if method != "space" or resolution <= plan["space"]]
        bakes += [(most, resolution, "linear") for resolution in plan["resolutions"] if resolution <= plan["hermite"]]
        for index, (probes, resolution, method) in enumerate(bakes):
            interpolation = "hermite" if (probes, resolution, method) in bakes[:index] else "trilinear"
            facts = fields.bake(setup, probes, resolution, method, *["--gradients"] * (interpolation == "hermite"))
            found = Grid(fields.grid_file(setup, probes, resolution, method)).at(places, interpolation)
            yield {"part": "error", "setup": setup, "spacing": round(probes ** (-1 / 3), 6), "texels": plan["texels"],
                   "samples": plan["samples"], "resolution": resolution, "method": method,
                   "interpolation": interpolation, "error": relative_rms(found, truth), "places": plan["places"],
                   **facts}


# ---- Pictures ----------------------------------------------------------------------------------------------------------

def lathe(lines, foot, outline, sides=24):
    """A surface of revolution about y, as OBJ; outline: radius and height, upwards."""
    first = sum(line.startswith("v ") for line in lines) + 1
    for radius, height in outline:
        for i in range(sides):
            angle = 2 * math.pi * i / sides
            lines.append(f"v {foot[0] + radius * math.cos(angle):.5f} {height:.5f} {foot[1] + radius * math.sin(angle):.5f}")
    for ring in range(len(outline) - 1):
        for i in range(sides):
            a, b = first + ring * sides + i, first + ring * sides + (i + 1) % sides
            lines.append(f"f {a} {a + sides} {b + sides} {b}")


def write_columns(path, count=12):
    """A ring of columns about a bowl: the scene with more geometry."""
    lines = []
    for i in range(count):
        angle = 2 * math.pi * i / count
        lathe(lines, (math.cos(angle), math.sin(angle)),
              [(0.2, 0), (0.2, 0.06), (0.12, 0.1), (0.1, 0.9), (0.18, 0.95), (0.18, 1), (0, 1)])
    lathe(lines, (0, 0), [(0.3, 0), (0.1, 0.1), (0.1, 0.25), (0.5, 0.5), (0.55, 0.6), (0.5, 0.58), (0, 0.3)], 48)
    pathlib.Path(path).write_text("\n".join(lines) + "\n", encoding="utf-8")


class Pictures:
    def __init__(self, fields, plan, folder):
        self.fields, self.plan, self.folder = fields, plan, pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.rows = []
        write_columns(fields.scratch / "columns.obj")
        self.things = {"figures": [], "table": ["--object", "table"], "matte": ["--material", "*=matte:0.7,0.7,0.7"],
                       "glossy": ["--material", "ball=phong:0.7,0.7,0.7,10", "--material", "knot=phong:0.7,0.7,0.7,10",
                                  "--material", "vase=phong:0.7,0.7,0.7,10"],
                       "columns": ["--object", fields.scratch / "columns.obj"]}

    def pair(self, setup, resolution, thing):
        """By the grid, and by paths."""
        out, most = self.fields.scratch / "compared", self.plan["probes"][-1]
        facts = reported(self.fields.scratch, self.fields.render_program, "--quiet", "--grid",
                         self.fields.grid_file(setup, most, resolution, "linear"), "--reference", setup, "--compare", out,
                         "--size", "{}x{}".format(*self.plan["size"]), "--samples", self.plan["paths"],
                         *self.things[thing])
        self.rows.append({"part": "picture", "setup": setup, "probes": most, "resolution": resolution, "scene": thing,
                          "paths": self.plan["paths"], "rmse": facts["errors"]["rmse"]})
        return [Image.open(out / f"{name}.png").convert("RGB") for name in ("grid", "reference")]

    def save(self, name, picture):
        picture.save(self.folder / f"{name}.png", optimize=True)

    def by_resolution(self, setup, resolutions, thing):
        """The reference, then each grid."""
        pairs = [self.pair(setup, resolution, thing) for resolution in resolutions]
        return joined([pairs[0][1], *(pair[0] for pair in pairs)])

    def figure_9(self):
        self.save("field_9", self.by_resolution("spots", self.plan["resolutions"], "figures"))

    def figure_10(self):
        resolution = self.plan["resolutions"][-2]
        columns = [joined(self.pair(setup, resolution, thing), across=False)
                   for setup in SETUPS for thing in ("table", "matte", "glossy")]
        self.save("field_10", joined(columns))

    def figure_11(self):
        self.save("field_11", self.by_resolution("projector", self.plan["resolutions"][:3], "columns"))


def main(capture, bake, render, folder, *options):
    plan = {"--quick": QUICK, "--full": FULL}[options[0]] if options else SHORT
    folder = pathlib.Path(folder)
    with tempfile.TemporaryDirectory() as scratch:
        fields = Fields(capture, bake, render, scratch, plan)
        pictures = Pictures(fields, plan, folder / "pictures")

        def rows():
            fields.capture_all()
            yield from errors(fields, plan)
            for draw in (pictures.figure_9, pictures.figure_10, pictures.figure_11):
                draw()
            yield from pictures.rows
        write(folder / "field.csv", FIELDS, rows())


if __name__ == "__main__":
    main(*sys.argv[1:])
