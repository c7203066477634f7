"""The gradient paper's Tables 3, 4 and 5 in its layout, its figures beside those of grid-render; see benchmarks.sh.

    benchmark_tables.py picture FILE.ppm             a picture for the textured panels, no texel of it black
    benchmark_tables.py table_3|table_4|table_5 FOLDER    of the reports in it
"""
import json
import math
import sys

# Table 3: lights, then milliseconds without and with gradients, interpolation, total, reference, and MAE x 10^3.
TABLE_3 = [
    ("Drone & Horse", 1793, 3.18, 5.30, 6.73, 12.93, 139.11, 0.2022),
    ("Dragon", 578, 0.84, 1.82, 12.41, 15.21, 76.54, 0.2372),
    ("Perseverance", 512, 0.86, 1.39, 10.17, 12.62, 55.40, 0.1310),
    ("Armadillo & Buddha", 242, 0.34, 0.66, 10.51, 11.56, 30.50, 0.1920),
    ("Conference, texture", 900, 1.49, 2.63, 11.53, 15.65, 115.51, 0.9656),
    ("Living Room, texture", 2500, 4.36, 7.84, 11.30, 20.02, 325.07, 0.7445),
    ("Fertility", 800, 1.46, 2.26, 28.56, 31.47, 133.01, 0.0340),
    ("White Room", 722, 1.19, 2.07, 14.58, 17.86, 119.49, 0.0779),
]
# Table 4: MAE x 10^3 by the number of lights; the last column is Fig. 12's.
TABLE_4_LIGHTS = [288, 512, 800, 722]
TABLE_4 = [
    ("spheres, zonal", "spheres", [1.866, 1.865, 1.865, 1.540]),
    ("spheres, interpolated", "spheres", [0.192, 0.192, 0.193, 0.079]),
    ("spheres", "triangles", [15.86, 15.76, 15.67, 62.08]),
    ("triangles as spheres", "triangles", [0.096, 0.068, 0.121, 0.129]),
    ("spheres, interpolated", "triangles, interpolated", [15.93, 15.83, 15.75, 62.13]),
    ("triangles as spheres, interpolated", "triangles, interpolated", [0.215, 0.165, 0.174, 0.176]),
    ("spheres, interpolated", "triangles", None),
    ("triangles as spheres, interpolated", "triangles", None),
    ("triangles, interpolated", "triangles", None),
]
PASSES = {"spheres": "spheres", "triangles": "triangles", "triangles as spheres": "triangle-spheres"}
# Table 5: bands, then milliseconds of the grid, interpolation, total and reference.
TABLE_5 = [(5, 1.39, 7.65, 9.04, 45.25), (7, 2.43, 26.14, 28.57, 77.18), (9, 3.35, 132.29, 135.64, 148.04)]


def report(folder, name):
    with open(f"{folder}/{name}.json", encoding="utf-8") as file:
        return json.load(file)


def print_table(titles, rows):
    print("| " + " | ".join(titles) + " |")
    print("|:--" + "|--:" * (len(titles) - 1) + "|")
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def beside(paper, here, digits):
    return [f"{paper:.{digits}f}" if paper is not None else "-", f"{here:.{digits}f}"]


def describe(facts):
    options, threads = facts["options"], facts["machine"]["threads"]
    size = f"{options['width']} x {options['height']}"
    print(f"Paper: GeForce RTX 2080, mostly 1920 x 1080. Here: {threads} processor threads, the built-in atrium, {size},")
    print(f"antialias {options['antialias']}. Each title: the paper | here.\n")


def milliseconds(passes):
    """With gradients, interpolation, their sum, the reference."""
    hermite = passes["hermite"]
    grid, shading = 1e3 * hermite["grid"]["seconds"], 1e3 * hermite["shading_seconds"]
    return [grid, shading, grid + shading, 1e3 * passes["reference"]["shading_seconds"]]


def table_3(folder):
    rows = []
    for scene, lights, value, *paper, paper_mae in TABLE_3:
        facts = report(folder, f"lights_{lights}")
        passes = facts["passes"]
        assert facts["counts"]["lights"] == lights
        row = [scene, str(lights)] + beside(value, 1e3 * passes["trilinear"]["grid"]["seconds"], 2)
        here = milliseconds(passes)
        for theirs, ours in zip(paper, here):
            row += beside(theirs, ours, 2)
        row += beside(paper[3] / paper[2], here[3] / here[2], 1)
        rows.append(row + beside(paper_mae, 1e3 * passes["hermite"]["errors"]["mae"], 4))
    print("Gradient paper, Table 3: ms and MAE on a grid of 8 x 8 x 8, Hermite; the paper's totals include its SSAO\n")
    describe(facts)
    titles = ["scene of the paper", "lights"]
    for title in ["values, ms", "with gradients, ms", "interpolation, ms", "total, ms", "reference, ms", "speed-up",
                  "MAE x 10^3"]:
        titles += [title, "here"]
    print_table(titles, rows)


def pass_name(title):
    shape, *how = title.split(", ")
    return PASSES[shape] + {"": "", "zonal": "-zonal", "interpolated": "-hermite"}[how[0] if how else ""]


def table_4(folder):
    reports = [report(folder, f"shapes_{lights}") for lights in TABLE_4_LIGHTS]
    rows = []
    for picture, reference, paper in TABLE_4:
        row = [f"{picture} | {reference}"]
        for column, facts in enumerate(reports):
            errors = facts["comparisons"][f"{pass_name(picture)}-against-{pass_name(reference)}"]["errors"]
            row += beside(paper[column] if paper else None, 1e3 * errors["mae"], 3)
        rows.append(row)
    print("Gradient paper, Table 4: MAE x 10^3 by the number of lights (the last column is the paper's Fig. 12)\n")
    describe(reports[0])
    print("A light here is a lantern: one sphere, or a square of two triangles.\n")
    titles = ["picture", "against"]
    for lights in TABLE_4_LIGHTS:
        titles += [str(lights), "here"]
    print_table(titles, rows)


def table_5(folder):
    rows = []
    for bands, *paper in TABLE_5:
        facts = report(folder, f"bands_{bands}")
        here = milliseconds(facts["passes"])
        row = [str(bands)]
        for theirs, ours in zip(paper, here):
            row += beside(theirs, ours, 2)
        rows.append(row + beside(paper[3] / paper[2], here[3] / here[2], 1))
    print("Gradient paper, Table 5: ms by the number of bands, 512 lights on a grid of 8 x 8 x 8\n")
    describe(facts)
    titles = ["bands"]
    for title in ["with gradients, ms", "interpolation, ms", "total, ms", "reference, ms", "speed-up"]:
        titles += [title, "here"]
    print_table(titles, rows)


def picture(path):
    """Coloured waves, 100 x 25."""
    width, height = 100, 25
    pixels = bytes(
        round(140 + 100 * math.sin(0.13 * x + 2 * channel) * math.cos(0.35 * y - channel))
        for y in range(height) for x in range(width) for channel in range(3))
    with open(path, "wb") as file:
        file.write(b"P6 %d %d 255\n" % (width, height) + pixels)


if __name__ == "__main__":
    {"picture": picture, "table_3": table_3, "table_4": table_4, "table_5": table_5}[sys.argv[1]](sys.argv[2])
