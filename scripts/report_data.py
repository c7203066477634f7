"""What report.py reads from the CSV files, and the little arithmetic that plots and text share."""
import csv
import math
import pathlib


def number_or_text(text):
    try:
        return float(text)
    except ValueError:
        return text


def read(folder, name, convert=number_or_text):
    """Rows as dictionaries; none where the file is not there."""
    path = pathlib.Path(folder) / f"{name}.csv"
    if not path.exists():
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return [{key: convert(value) for key, value in row.items()} for row in csv.DictReader(file)]


def where(rows, **conditions):
    return [row for row in rows if all(row[key] == value for key, value in conditions.items())]


def one(rows, **conditions):
    found = where(rows, **conditions)
    return found[0] if found else None


def distinct(rows, *keys):
    """The values of a key, or of several as tuples, in the order in which they come."""
    values = (tuple(row[key] for key in keys) for row in rows)
    return list(dict.fromkeys(value if len(keys) > 1 else value[0] for value in values))


def pareto(rows, x, y):
    """The rows that no other beats in both, by increasing x."""
    front, least = [], math.inf
    for row in sorted(rows, key=lambda row: (x(row), y(row))):
        if y(row) < least:
            front.append(row)
            least = y(row)
    return front


def interpolated(points, x):
    """y at x, on straight lines between points in log-log; None outside."""
    points = sorted(points)
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 < x1 and x0 <= x <= x1:
            t = math.log(x / x0) / math.log(x1 / x0)
            return math.exp(math.log(y0) + t * math.log(y1 / y0))
    return None


def line_fit(points):
    """a and b of y ~ a + b x by least squares, and the greatest relative residual."""
    mean_x, mean_y = (sum(values) / len(points) for values in zip(*points))
    b = sum((x - mean_x) * (y - mean_y) for x, y in points) / sum((x - mean_x) ** 2 for x, _ in points)
    a = mean_y - b * mean_x
    return a, b, max(abs(a + b * x - y) / y for x, y in points)


def gather_ms(row):
    """What a picture's virtual lights take: to make them and to gather them."""
    return 1e3 * (row["lights_s"] + row["gather_s"])


def screen_ms(row):
    """What a filter's picture takes once there are lights: to sum them, to filter and to shade."""
    return 1e3 * (row["light_s"] + row["filter_s"] + row["shading_s"])


def log_slope(points):
    """b of y ~ a x^b."""
    return line_fit([(math.log(x), math.log(y)) for x, y in points])[1]


LOOKUPS = 640 * 512  # of a picture, where the time of a grid and its lookups is one number


def frame_ms(row):
    return row["build_ms"] + 1e-6 * LOOKUPS * row["lookup_ns"]


# What tells two variants of a method apart, and how it is said.
VARIANT = {"vpl_clamp": "clamped at {:.0f} r", "vsl_samples": "{:.0f} samples", "vsgl_texels": "{:.0f}² texels",
           "bands": "{:.0f} bands", "emission_bands": "emission {:.0f}", "paths": "{:.0f} to a pixel"}
METHOD = {"vpl": "VPL", "vsl": "VSL", "vsgl": "VSGL", "vsgl-2024": "VSGL of 2024", "hvl": "HVL",
          "hvl-zonal": "zonal HVL", "path": "paths"}


def variant(row):
    said = [text.format(row[key]) for key, text in VARIANT.items()
            if row.get(key, "") not in ("", 0) and not (key == "emission_bands" and row[key] == 3)]
    return ", ".join([METHOD[row["method"]], *said])
