"""The part of docs/report on the screen's filters: what the pictures' errors say, and the paper's figures as ours.

Segovia and Wald, Screen Space Spherical Harmonics Filters for Instant Global Illumination.
"""
from report_data import distinct, log_slope, one, read, screen_ms, where
from report_plots import FILTER_STYLE, SCREEN_SCENE, SETS_NAME, sets_line
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
    shares = {name: here["radiance"]["rmse"] / here["irradiance"]["rmse"] for name, here in cases(rows)}
    said = {half: listed([f"{share:.3f} ({name})" for name, share in shares.items() if (share <= 0.5) == half])
            for half in (True, False)}
    return (f"Radiance's error as a share of irradiance's: at most half: {said[True]}. More than half: {said[False]}. "
            "The three points cast hard shadows, which every filter blurs.")


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
    return (f"Memory per position, in floats and with the padding of rows: {of['radiance']:.0f} bytes of radiance in three bands, "
            f"{of['irradiance']:.0f} of what classical filtering keeps, reflected light of body and gloss; "
            f"{of['radiance'] / of['irradiance']:.1f} times as much. SG and L1 take {of['sg']:.0f}.")


def doubt_text(reference, rows):
    """What the slopes are worth, by the reference's own error."""
    least = min(row["rmse"] for row in rows)
    if reference["rmse"] <= least:
        return ""
    return (f" **These slopes are not decided**: the least error here is {least:.4f}, less than that of what it is "
            "compared with.")


def sets_text(folder):
    rows, (reference,) = (where(read(folder, "screen"), part=part) for part in ("sets", "sets_reference"))
    lines = {SETS_NAME.get(name, name): sets_line(rows, name) for name in distinct(rows, "filter")}
    slopes = [f"{log_slope(line):.2f} ({name})" for name, line in lines.items()]
    ends = [f"{line[0][1]:.4f} to {line[-1][1]:.4f} ({name})" for name, line in lines.items()]
    return (f"The scene is: {SCREEN_SCENE[reference['scene']]}, {reference['width']:.0f} x {reference['height']:.0f}; "
            f"{reference['samples']:.0f} samples in each set, over {rows[0]['seeds']:.0f} seeds. It is compared with "
            f"the mean of {reference['seeds']:.0f} other seeds, each of {reference['sets']:.0f} sets, all at every pixel; "
            f"its own RMSE, {reference['rmse']:.4f}, is taken off, in squares. By PNG files. Slope of the error in the "
            f"number of sets, log-log: {listed(slopes)}. From {rows[0]['sets']:.0f} to {rows[-1]['sets']:.0f} sets the "
            f"error goes from {listed(ends)}. All sets at every pixel show what sampling "
            "alone does; more sets also widen the filter, which blurs." + doubt_text(reference, rows))


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
        best_text(sweep), ratio_text(sweep),
        strict_text(sweep), memory_text(sweep), error_table(sweep),
        figure("screen_sets", "error against the number of sets"), sets_text(folder),
        "### Segovia and Wald, Fig. 1, 2 and 4",
        picture(1, "four scenes, radiance and irradiance"),
        "Fig. 1, at 4x4: matte, bumped by three points, bumped glossy, and by a light probe. Above radiance filtered; "
        "below close-ups, radiance left and irradiance right.",
        picture(2, "reference, radiance, irradiance, irradiance-strict"),
        f"Fig. 2, at {sweep[-1]['pattern']}, by a light probe: the reference, radiance, irradiance, and irradiance with "
        "strict tests.",
        picture(4, "irradiance and radiance at four sizes of pattern"),
        f"Fig. 4, bumped, by the panel: irradiance above, radiance below, at {listed(distinct(sets, 'pattern'))}."])
