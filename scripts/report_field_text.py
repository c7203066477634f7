"""The part of docs/report on light fields: errors against the truth, times, and the paper's figures as ours.

Löw, Ynnerman, Larsson, Unger, HDR light probe sequence resampling for realtime incident light field rendering.
"""
from report_data import distinct, log_slope, one, read, where
from report_plots import FIELD_NAME, FIELD_SETUP, bake_line
from report_text import figure, listed, table


def grid_name(resolution):
    return f"{resolution:.0f}³"


def plain(rows, **conditions):
    return where(rows, method="linear", interpolation="trilinear", **conditions)


def turn_text(rows):
    """By how much error falls with each finer grid, and where it is least."""
    lines = []
    for setup, probes, spacing in distinct(rows, "setup", "probes", "spacing"):
        line = plain(rows, setup=setup, probes=probes)
        least = min(line, key=lambda row: row["error"])
        steps = listed([f"{after['error'] / before['error']:.2f} (to {grid_name(after['resolution'])})"
                        for before, after in zip(line, line[1:])])
        lines.append(f"- {FIELD_SETUP[setup]}, {probes:.0f} probes: least at {grid_name(least['resolution'])} "
                     f"({least['error']:.3f}), where cells are {1 / (least['resolution'] - 1) / spacing:.2f} of the "
                     f"probes' distance. Times as much with each finer grid: {steps}.")
    return "\n".join(lines)


def method_text(rows, method, interpolation="trilinear"):
    """Error over that of the linear fit, trilinear, at each resolution."""
    most = distinct(rows, "probes")[-1]
    shares = []
    for setup in distinct(rows, "setup"):
        for row in where(rows, setup=setup, probes=most, method=method, interpolation=interpolation):
            own = plain(rows, setup=setup, probes=most, resolution=row["resolution"])[0]
            shares.append(row["error"] / own["error"])
    return f"{min(shares):.2f} to {max(shares):.2f}"


def error_table(rows):
    resolutions, lines = distinct(rows, "resolution"), []
    for setup, probes, method, interpolation in distinct(rows, "setup", "probes", "method", "interpolation"):
        here = where(rows, setup=setup, probes=probes, method=method, interpolation=interpolation)
        cells = [one(here, resolution=resolution) for resolution in resolutions]
        name = FIELD_NAME[method] + (", Hermite" if interpolation == "hermite" else "")
        lines.append([f"{FIELD_SETUP[setup]}, {probes:.0f} probes: {name}",
                      *(f"{row['error']:.3f}, {row['bake_s']:.2f} s" if row else "-" for row in cells)])
    return table(["error, time", *map(grid_name, resolutions)], lines)


def time_text(rows):
    most = distinct(rows, "probes")[-1]
    by_probes = listed([f"{log_slope(bake_line(rows, 'probes', method='linear', resolution=resolution)):.2f} "
                        f"({grid_name(resolution)})" for resolution in distinct(rows, "resolution")])
    by_points = bake_line(rows, "resolution", method="linear", probes=most)
    slow = bake_line(rows, "resolution", method="space", probes=most)[-1]
    fast = dict(by_points)[slow[0]]
    last = by_points[-1][1] / by_points[-2][1] if by_points[-2][0] * 8 == by_points[-1][0] else None
    eight = f"; the last eightfold takes {last:.1f} times as long" if last else ""
    return (f"Exponent of the time, fitted: {by_probes} in probes, "
            f"{log_slope(by_points):.2f} in grid points ({most:.0f} probes){eight}. The paper's steps take {slow[1]:.2f} s "
            f"for {slow[0]:.0f} points, {slow[1] / fast:.0f} times as long as the plane. Sorting the samples of "
            f"{most:.0f} pictures takes {max(row['sort_s'] for row in where(rows, probes=most)):.2f} s, once.")


def picture_errors(pictures, **conditions):
    return listed([f"{row['rmse']:.4f} ({grid_name(row['resolution'])})" for row in where(pictures, **conditions)])


def field(folder):
    rows, pictures = (where(read(folder, "field"), part=part) for part in ("error", "picture"))
    thing = where(pictures, setup="spots", scene="figures")
    first = rows[0]
    shown = [f"{row['rmse']:.4f} ({row['scene']}, {FIELD_SETUP[row['setup']]})" for row in pictures
             if row["scene"] in ("table", "matte", "glossy")]
    middle = one(pictures, scene="matte")["resolution"]
    return "\n\n".join([
        "## Field", figure("field", "error of light fields against the grid's resolution"),
        f"Light probes of {first['texels']:.0f} x {first['texels']:.0f} texels, {first['samples']:.0f} paths in each, one "
        "at random in each cell of a cube, become grids of 25 coefficients, RGB. Error: RMS of the difference from the "
        f"path-traced coefficients at {first['places']:.0f} random places, over their RMS; trilinear but where Hermite is "
        "said. Above, by the linear fit; below, of most probes. Both set-ups have hard edges of light all over the volume.",
        turn_text(rows),
        f"Error over that of the linear fit, all resolutions: mean {method_text(rows, 'mean')}, nearest repair "
        f"{method_text(rows, 'nearest')}, the paper's steps {method_text(rows, 'space')}, Hermite "
        f"{method_text(rows, 'linear', 'hermite')}. Across hard edges a fit knows little more than a mean; on smooth "
        "light it errs much less ([field](../rooms/field.md)). The paper's steps are means too, and were baked on coarse "
        "grids alone, for their time.",
        error_table(rows), figure("field_time", "time of resampling"), time_text(rows),
        "### Löw et al., Fig. 9, 10 and 11",
        "![reference and four grids](pictures/field_9.png)",
        f"Fig. 9, {FIELD_SETUP['spots']}: path-traced, then by grids of "
        f"{listed([grid_name(row['resolution']) for row in thing])}. RMSE of the picture: "
        f"{picture_errors(pictures, scene='figures')}. Things neither light nor shadow each other, in the reference "
        "too. Finer than probes are dense, an edge becomes no line but blots; the ball's rings are of five bands, not of "
        "the grid.",
        "![table, matte and glossy things in two set-ups](pictures/field_10.png)",
        f"Fig. 10: a table, matte and glossy things, {FIELD_SETUP['projector']}, then {FIELD_SETUP['spots']}. Above by a "
        f"grid of {grid_name(middle)}, below path-traced. RMSE: {listed(shown)}.",
        "![columns: reference and three grids](pictures/field_11.png)",
        f"Fig. 11, more geometry, {FIELD_SETUP['projector']}: path-traced, then by three grids. RMSE: "
        f"{picture_errors(pictures, scene='columns')}."])
