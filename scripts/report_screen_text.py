"""The part of docs/report on the screen's filters: what the pictures' errors say, and the paper's figures as ours.

Segovia and Wald, Screen Space Spherical Harmonics Filters for Instant Global Illumination.
"""
from report_data import distinct, log_slope, one, read, screen_ms, where
from report_plots import FILTER_STYLE, SCREEN_SCENE, sets_line
from report_text import figure, listed, table

SIX_NUMBERS = ("irradiance", "irradiance-strict", "sg", "l1")  # of equal bytes


def cases(rows):
    """Each scene and pattern: how it is called, and its rows by filter."""
    for scene, pattern in distinct(rows, "scene", "pattern"):
        here = where(rows, scene=scene, pattern=pattern)
        yield f"{SCREEN_SCENE[scene]}, {pattern}", {row["filter"]: row for row in here}


def error_table(rows):
    lines = [[name] + [f"{here[one]['rmse']:.4f}, {screen_ms(here[one]):.0f} ms" for one in FILTER_STYLE] +
             [f"{here['bands alone']['rmse']:.4f}", f"{1e3 * here['radiance']['reference_s']:.0f} ms"]
             for name, here in cases(rows)]
    return table(["RMSE, time", *FILTER_STYLE, "bands alone", "reference"], lines)


def ratio_text(rows):
    """Whether radiance has at most half of irradiance's error."""
    held, missed = [], []
    for name, here in cases(rows):
        ratio = here["radiance"]["rmse"] / here["irradiance"]["rmse"]
        (held if ratio <= 0.5 else missed).append(f"{ratio:.2f} ({name})")
    return ("Radiance's error as a share of irradiance's: at most half in " +
            (f"{len(held)} cases, {listed(held)}" if held else "no case") + "; more in " +
            (f"{len(missed)}, {listed(missed)}." if missed else "none."))


def best_text(rows):
    """Which filter has the least error, of all and of those of six numbers."""
    lines = []
    for name, here in cases(rows):
        filtered = [here[one] for one in FILTER_STYLE if one != "none"]
        best = min(filtered, key=lambda row: row["rmse"])
        order = sorted((here[one] for one in SIX_NUMBERS), key=lambda row: row["rmse"])
        of_six = ", ".join(f"{row['filter']} {row['rmse']:.4f}" for row in order)
        lines.append(f"- {name}: {best['filter']} ({best['rmse']:.4f}, {screen_ms(best):.0f} ms). Of equal bytes: "
                     f"{of_six}.")
    return "\n".join(lines)


def strict_text(rows):
    worse = [name for name, here in cases(rows) if here["irradiance-strict"]["rmse"] > here["irradiance"]["rmse"]]
    return ("Where irradiance is filtered only between like shading normals, relief is kept and the pattern shows; its "
            f"RMSE is lower than irradiance's, except in {listed(worse)}." if worse else
            "Where irradiance is filtered only between like shading normals, relief is kept and the pattern shows; its "
            "RMSE is lower than irradiance's in all cases, and the picture (Fig. 2) says more than the number.")


def memory_text(rows):
    of = {row["filter"]: row["bytes"] for row in rows if row["bytes"] != ""}
    return (f"Memory per position in floats: {of['radiance']:.0f} bytes of radiance in three bands, "
            f"{of['irradiance']:.0f} of what classical filtering keeps, reflected light of body and gloss; "
            f"{of['radiance'] / of['irradiance']:.1f} times as much. SG and L1 take {of['sg']:.0f}.")


def sets_text(rows):
    slopes = [f"{log_slope(sets_line(rows, name)):.2f} ({name})" for name in distinct(rows, "filter")]
    ends = [f"{line[0][1]:.4f} to {line[-1][1]:.4f} ({name})" for name in distinct(rows, "filter")
            for line in [sets_line(rows, name)]]
    one_row = rows[0]
    return (f"{SCREEN_SCENE[one_row['scene']]}, {one_row['width']:.0f} x {one_row['height']:.0f}, "
            f"{one_row['samples']:.0f} samples in each set, over {one_row['seeds']:.0f} seeds, against a picture by all "
            "of many more sets of another seed (8 bits a channel). Slope of the error in the number of sets, "
            f"log-log: {listed(slopes)}; from the fewest sets to the most: {listed(ends)}. More sets bring a truer mean "
            "and a wider filter, which blurs: the slope is of both, and of independent samples alone would be -0.5.")


def picture(number, text):
    return f"![{text}](pictures/screen_{number}.png)"


def screen(folder):
    rows = read(folder, "screen")
    sweep, sets = where(rows, part="sweep"), where(rows, part="sets")
    return "\n\n".join([
        "## Screen", figure("screen", "error of the screen's filters against time"),
        f"RMSE of the tone-mapped picture ({sweep[0]['width']:.0f} x {sweep[0]['height']:.0f}, "
        f"{sweep[0]['samples']:.0f} samples and paths in each set, one bounce) against all sets at every pixel, by the "
        "time to sum a pixel's lights, filter and shade. Every filter sees the same lights, so the error is what "
        "filtering and, of radiance, the bands (dotted: they alone) do. The probe is a sky that the script makes.",
        best_text(sweep), ratio_text(sweep) + " The three points cast hard shadows, which every filter blurs.",
        strict_text(sweep), memory_text(sweep), error_table(sweep),
        figure("screen_sets", "error against the number of sets"), sets_text(sets),
        "### Segovia and Wald, Fig. 1, 2 and 4",
        picture(1, "four scenes, radiance and irradiance"),
        "Fig. 1, at 4x4: matte, bumped by three points, bumped glossy, and by a light probe. Above radiance filtered; "
        "below close-ups, radiance left and irradiance right.",
        picture(2, "reference, radiance, irradiance, irradiance-strict"),
        f"Fig. 2, at {sweep[-1]['pattern']}, by a light probe: the reference, radiance, irradiance, and irradiance with "
        "strict tests.",
        picture(4, "irradiance and radiance at four sizes of pattern"),
        f"Fig. 4, bumped, by the panel: irradiance above, radiance below, at {listed(distinct(sets, 'pattern'))}."])
