"""Renders what docs/report needs by igi-render, and writes screen.csv and pictures; see report.sh.

    report_screen.py IGI_RENDER FOLDER [--quick|--full]
"""
import math
import pathlib
import sys
import tempfile

import numpy
from PIL import Image

from report_render import joined, reported, write

FIELDS = ["part", "scene", "width", "height", "pattern", "sets", "samples", "seeds", "filter", "bytes", "light_s",
          "filter_s", "shading_s", "reference_s", "rmse", "linear_rmse"]

# `samples`: of each set. `sets_size` and what follows: of the error against the number of sets, by pictures of `seeds`
# seeds, beside one of `reference_pattern`.
SHORT = {"size": (640, 512), "patterns": ["4x4", "8x8"], "samples": 8, "sets_size": (320, 256), "sets_samples": 4,
         "seeds": 3, "reference_pattern": "16x16", "sides": (1, 2, 4, 8)}
FULL = {**SHORT, "samples": 16, "seeds": 8}
QUICK = {"size": (40, 32), "patterns": ["4x4"], "samples": 1, "sets_size": (40, 32), "sets_samples": 2, "seeds": 1,
         "reference_pattern": "8x8", "sides": (2, 4)}  # shows that all is there
AVERAGED = ("reference", "radiance", "irradiance", "l1", "sg")  # of a comparison, against the number of sets

# Suns of the sky: direction (z up), cosine of the radius, radiance.
SUNS = [((0.5, -0.3, 0.75), 0.985, (60, 50, 36)), ((-0.7, 0.2, 0.5), 0.96, (6, 8, 14)),
        ((-0.2, -0.8, 0.6), 0.97, (14, 6, 3))]


def sky(width=256, height=128):
    """Equirectangular radiance: a gradient, dark ground, and a few suns."""
    theta = (numpy.arange(height) + 0.5)[:, None] * numpy.pi / height
    phi = (numpy.arange(width) + 0.5)[None, :] * 2 * numpy.pi / width
    way = numpy.stack(numpy.broadcast_arrays(numpy.sin(theta) * numpy.cos(phi), numpy.sin(theta) * numpy.sin(phi),
                                             numpy.cos(theta)), axis=-1)
    up = numpy.clip(way[..., 2:], 0, 1)
    picture = numpy.where(way[..., 2:] > 0, (1 - up) * [0.6, 0.55, 0.5] + up * [0.2, 0.35, 0.7], [0.08, 0.07, 0.06])
    for direction, cosine, radiance in SUNS:
        picture[way @ (numpy.array(direction) / numpy.linalg.norm(direction)) > cosine] = radiance
    return picture


def write_hdr(path, picture):
    """Radiance's RGBE, not compressed."""
    exponent = numpy.ceil(numpy.log2(picture.max(axis=-1, keepdims=True) * (256 / 255)))
    mantissa = numpy.rint(picture * 256 / 2 ** exponent)
    texels = numpy.concatenate([mantissa, exponent + 128], axis=-1).astype(numpy.uint8)
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {picture.shape[0]} +X {picture.shape[1]}\n"
    pathlib.Path(path).write_bytes(header.encode() + texels.tobytes())


def scenes(probe):
    """Arguments by name."""
    return {"diffuse": ["--scene", "atrium-diffuse", "--lighting", "area"],
            "bumped": ["--scene", "atrium-bumped", "--lighting", "three"],
            "bumped-area": ["--scene", "atrium-bumped", "--lighting", "area"],
            "bumped-glossy": ["--scene", "atrium-bumped-glossy", "--lighting", "area"],
            "probe": ["--scene", "courtyard", "--probe", str(probe)]}


def read(path):
    """Display values, 0 to 1."""
    return numpy.asarray(Image.open(path).convert("RGB")) / 255.0


class Renderer:
    def __init__(self, program, scratch):
        self.program, self.scratch = program, pathlib.Path(scratch)
        write_hdr(self.scratch / "sky.hdr", sky())
        self.scenes = scenes(self.scratch / "sky.hdr")

    def run(self, scene, size, pattern, samples, *options):
        """igi-render's JSON."""
        return reported(self.scratch, self.program, "--quiet", "--size", f"{size[0]}x{size[1]}", *self.scenes[scene],
                        "--pattern", pattern, "--sets", samples, *options)

    def compared(self, scene, pattern):
        """The folder of a comparison's pictures."""
        return self.scratch / f"{scene}_{pattern}"


def row(part, scene, size, pattern, samples, name, **numbers):
    columns, rows = map(int, pattern.split("x"))
    return {"part": part, "scene": scene, "width": size[0], "height": size[1], "pattern": pattern,
            "sets": columns * rows, "samples": samples, "filter": name, **numbers}


def sweep(renderer, plan):
    """Every filter beside all sets at every pixel."""
    size, samples = plan["size"], plan["samples"]
    for scene in renderer.scenes:
        for pattern in plan["patterns"]:
            facts = renderer.run(scene, size, pattern, samples, "--compare", renderer.compared(scene, pattern))
            same = {"part": "sweep", "scene": scene, "size": size, "pattern": pattern, "samples": samples}
            for one in facts["passes"]:
                yield row(**same, name=one["name"], bytes=one["bytes"] / (size[0] * size[1]),
                          light_s=one["light_seconds"], filter_s=one["filter_seconds"],
                          shading_s=one["shading_seconds"], reference_s=facts["reference"]["light_seconds"],
                          rmse=one["errors"]["rmse"], linear_rmse=one["errors"]["linear_rmse_relative_to_mean"])
            lost = facts["truncation"]
            yield row(**same, name="bands alone", rmse=lost["rmse"], linear_rmse=lost["linear_rmse_relative_to_mean"])


def mean_square(picture, other):
    return ((picture - other) ** 2).mean()


def by_sets(renderer, plan, scene="bumped-area"):
    """Error of the display values against the number of sets, each of as many samples, beside many more sets: the mean
    of two seeds, whose difference is twice the mean's own error. Of the squares that is taken off."""
    size, samples, most = plan["sets_size"], plan["sets_samples"], plan["reference_pattern"]
    folder = renderer.scratch / "sets"

    def pictures(pattern, seed):
        renderer.run(scene, size, pattern, samples, "--compare", folder, "--seed", seed)
        return {name: read(folder / f"{name}.png") for name in AVERAGED}

    one, other = (pictures(most, seed)["reference"] for seed in (1000, 2000))
    exact, own = (one + other) / 2, mean_square(one, other) / 4
    yield row("sets_reference", scene, size, most, samples, "reference", seeds=2, rmse=math.sqrt(own))
    for side in plan["sides"]:
        pattern, seeds = f"{side}x{side}", plan["seeds"]
        squares = [{name: mean_square(picture, exact) for name, picture in pictures(pattern, seed).items()}
                   for seed in range(1, seeds + 1)]
        for name in AVERAGED:
            rmse = math.sqrt(max(sum(square[name] for square in squares) / seeds - own, 0.0))
            yield row("sets", scene, size, pattern, samples, name, seeds=seeds, rmse=rmse)


# ---- Pictures: rows of them, each one file -----------------------------------------------------------------------------

# Corner and size of a close-up, of the picture's width and height; where the filters differ.
CLOSE_UP = {"diffuse": (0.22, 0.5), "bumped": (0.04, 0.46), "bumped-glossy": (0.58, 0.58), "probe": (0.72, 0.38)}
CLOSE_UP_SIZE = 0.2


def part_of(picture, corner, share=CLOSE_UP_SIZE):
    width, height = picture.size
    left, top = round(corner[0] * width), round(corner[1] * height)
    return picture.crop((left, top, left + round(share * width), top + round(share * height)))


class Pictures:
    def __init__(self, renderer, folder):
        self.renderer, self.folder = renderer, pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def open(self, scene, pattern, name):
        return Image.open(self.renderer.compared(scene, pattern) / f"{name}.png").convert("RGB")

    def save(self, name, picture):
        picture.save(self.folder / f"{name}.png", optimize=True)

    def with_close_ups(self, scene, shown, below, width):
        """A picture, and below it close-ups that together are as wide."""
        each = (width - 4 * (len(below) - 1)) // len(below)
        height = round(width * shown.size[1] / shown.size[0])
        closer = [part_of(picture, CLOSE_UP[scene]) for picture in below]
        closer = [picture.resize((each, round(each * picture.size[1] / picture.size[0])), Image.Resampling.NEAREST)
                  for picture in closer]
        return joined([shown.resize((width, height), Image.Resampling.BOX), joined(closer)], across=False)

    def figure_1(self, scenes=("diffuse", "bumped", "bumped-glossy", "probe"), pattern="4x4"):
        columns = []
        for scene in scenes:
            both = [self.open(scene, pattern, name) for name in ("radiance", "irradiance")]
            columns.append(self.with_close_ups(scene, both[0], both, 260))
        self.save("screen_1", joined(columns))

    def figure_2(self, pattern, scene="probe"):
        shown = [self.open(scene, pattern, name)
                 for name in ("reference", "radiance", "irradiance", "irradiance-strict")]
        self.save("screen_2", joined([self.with_close_ups(scene, picture, [picture], 256) for picture in shown]))

    def figure_4(self, plan, scene="bumped-area"):
        lines = []
        for name in ("irradiance", "radiance"):
            line = []
            for side in plan["sides"]:
                out = self.renderer.scratch / "one.png"
                self.renderer.run(scene, plan["size"], f"{side}x{side}", plan["samples"], "--filter", name, "--out", out)
                line.append(part_of(Image.open(out).convert("RGB"), (0.02, 0.4), 0.36))
            lines.append(joined(line))
        self.save("screen_4", joined(lines, across=False))


def main(program, folder, *options):
    plan = {"--quick": QUICK, "--full": FULL}[options[0]] if options else SHORT
    folder = pathlib.Path(folder)
    with tempfile.TemporaryDirectory() as scratch:
        renderer = Renderer(program, scratch)

        def rows():
            yield from sweep(renderer, plan)
            yield from by_sets(renderer, plan)
        write(folder / "screen.csv", FIELDS, rows())
        pictures = Pictures(renderer, folder / "pictures")
        pictures.figure_1()
        pictures.figure_2(plan["patterns"][-1])
        pictures.figure_4(plan)


if __name__ == "__main__":
    main(*sys.argv[1:])
