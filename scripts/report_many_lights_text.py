"""The part of docs/report on many virtual lights within a tolerance."""
from report_data import distinct, log_slope, one, read, where
from report_plots import SCENE, planned_seconds
from report_text import figure, listed, table


def exponents(rows):
    """Of the time, by least squares over lights up to 10^5 and from there on."""
    said = []
    for scene in distinct(rows, "scene"):
        line = where(rows, scene=scene)
        parts = [[row for row in line if row["lights"] <= 1e5], [row for row in line if row["lights"] > 9e4]]
        slopes = [f"{log_slope([(row['lights'], planned_seconds(row)) for row in part]):.2f}"
                  for part in parts if len(part) > 1]
        said.append(f"{' and '.join(slopes)} ({SCENE[scene]})")
    return listed(said)


def tolerance_exponents(rows):
    return listed([f"{log_slope([(row['tolerance'], planned_seconds(row)) for row in where(rows, scene=scene)]):.2f} "
                   f"({SCENE[scene]})" for scene in distinct(rows, "scene")])


def cells(row):
    return [f"{row['lights_per_hit']:.0f}", f"{row['tree_s']:.2f}", f"{row['gather_s']:.2f}", f"{row['full_s']:.3g}",
            f"{100 * row['proved']:.3g} %", f"{100 * row['measured']:.3g} %", f"{1e-6 * row['planned_bytes']:.3g}",
            f"{1e-6 * row['full_bytes']:.3g}"]


TITLES = ["lights a hit", "tree, s", "gather, s", "in full, s", "error, proved", "measured", "MB", "in full"]


def few_text(rows):
    """What a plan gains where lights are few, against a run of the full gather."""
    said = []
    for full in where(rows, part="full"):
        planned = one(where(rows, part="tolerance", scene=full["scene"], lights=full["lights"]), tolerance=0.01)
        said.append(f"{full['gather_s'] / planned['gather_s']:.2f} times as fast in the {SCENE[full['scene']]}")
    lights = where(rows, part="full")[0]["lights"]
    return f"At {lights:.0f} lights and 1 %, against a run of the full gather: {listed(said)}."


def many_lights(folder):
    rows = read(folder, "many_lights")
    by_lights, by_tolerance = where(rows, part="lights"), where(rows, part="tolerance")
    most = max(distinct(by_tolerance, "lights"))
    at_most = where(by_tolerance, lights=most)
    return "\n\n".join([
        "## Many lights", figure("many_lights", "time and error of virtual lights drawn within a tolerance"),
        "Harmonics virtual lights drawn for many within a tolerance ([many_lights](../rooms/many_lights.md)), 5 bands, no "
        "visibility. The time in full is that of the hits at which the error was measured, extrapolated; the error is a "
        "root mean square over the picture, of that of the indirect light.",
        f"Exponent of the time in lights, at 1 %, up to 10^5 and from there on: {exponents(by_lights)}. In the tolerance, at "
        f"{most:.0f} lights: {tolerance_exponents(at_most)}.",
        few_text(rows),
        table(["lights, at 1 %", *TITLES], [[f"{row['lights']:.0f}, {row['scene']}", *cells(row)] for row in by_lights]),
        table([f"tolerance, {most:.0f} lights", *TITLES],
              [[f"{100 * row['tolerance']:g} %, {row['scene']}", *cells(row)] for row in at_most])])
