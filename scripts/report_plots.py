"""The figures of docs/report, each from its CSV file alone."""
import math
import pathlib

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

from report_data import (METHOD, VARIANT, distinct, frame_ms, gather_ms, log_slope, one, pareto, read, screen_ms, where)

# Okabe and Ito's colours, which the colour-blind tell apart.
BLACK, ORANGE, SKY, GREEN, BLUE, RED, PURPLE = ("#000000", "#E69F00", "#56B4E9", "#009E73", "#0072B2", "#D55E00",
                                                "#CC79A7")
METHOD_STYLE = {"vpl": (RED, "o"), "vsl": (ORANGE, "s"), "vsgl": (PURPLE, "D"),
                "vsgl-2024": (SKY, "p"), "hvl": (BLUE, "^"), "hvl-zonal": (GREEN, "v")}
SCENE = {"diffuse": "diffuse atrium", "glossy": "glossy atrium", "measured": "measured materials"}
VISIBILITY = {"none": "no visibility", "centre": "visibility of centres"}
FRONT = {"color": BLACK, "linewidth": 0.9, "linestyle": (0, (4, 2)), "zorder": 1}

plt.rcParams.update({
    "font.size": 9, "axes.titlesize": 9, "legend.fontsize": 8, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#E4E4E4", "grid.linewidth": 0.6, "axes.axisbelow": True, "lines.linewidth": 1.1,
    "lines.markersize": 4.5, "legend.frameon": False, "figure.facecolor": "white", "svg.hashsalt": "zonal"})


def panels(rows, columns, width=9.0, height=3.0, **options):
    figure, axes = plt.subplots(rows, columns, figsize=(width, height * rows), squeeze=False, layout="constrained",
                                **options)
    return figure, axes


def legend_below(figure, handles, columns):
    figure.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0), ncols=columns)


def save(figure, folder, name):
    """Equal data give equal files. An error where a panel has nothing in it."""
    for axis in figure.axes:
        if axis.get_visible() and not all(map(math.isfinite, axis.dataLim.extents)):
            raise ValueError(f"{name}: no rows to draw in the panel \"{axis.get_title() or axis.get_ylabel()}\"")
    figure.savefig(pathlib.Path(folder) / f"{name}.svg", bbox_inches="tight",
                   metadata={"Date": None})
    plt.close(figure)


def key(label, **style):
    return matplotlib.lines.Line2D([], [], label=label, **style)


FRONT_KEY = key("Pareto front", **FRONT)


def draw_front(axis, rows, x, y):
    front = pareto(rows, x, y)
    axis.plot([x(row) for row in front], [y(row) for row in front], **FRONT)


def fill_of(is_on_front, colour):
    return colour if is_on_front else "white"


VARIANT_KEYS = ("method", *VARIANT)


def plain_ticks(axis):
    """0.03, 0.04, 0.06 where an axis spans a decade or so."""
    axis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axis.set_minor_locator(matplotlib.ticker.LogLocator(subs=(2, 3, 4, 6), numticks=20))
    axis.set_minor_formatter(matplotlib.ticker.FormatStrFormatter("%g"))


def gather_panel(axis, rows, noise):
    for name in distinct(rows, *VARIANT_KEYS):
        line = where(rows, **dict(zip(VARIANT_KEYS, name)))
        axis.plot([gather_ms(row) for row in line], [row["rmse"] for row in line], color=METHOD_STYLE[name[0]][0],
                  alpha=0.5, linewidth=0.7, zorder=2)
    front = pareto(rows, gather_ms, lambda row: row["rmse"])
    for row in rows:
        colour, marker = METHOD_STYLE[row["method"]]
        axis.vlines(gather_ms(row), max(row["rmse"] ** 2 - noise ** 2, 0) ** 0.5, row["rmse"], color=colour,
                    linewidth=3, alpha=0.35)
        axis.plot(gather_ms(row), row["rmse"], marker, color=colour, zorder=3, markersize=3.8,
                  markerfacecolor=fill_of(row in front, colour))
    draw_front(axis, rows, gather_ms, lambda row: row["rmse"])
    axis.text(0.02, 0.03, f"reference: {noise:.4f}", transform=axis.transAxes, size=8, color="#555555")
    axis.set(xscale="log", yscale="log")


def gather(folder):
    rows, references = where(read(folder, "gather"), part="sweep"), read(folder, "references")
    if not rows:
        return
    scenes, visibilities = distinct(rows, "scene"), distinct(rows, "visibility")
    figure, axes = panels(len(visibilities), len(scenes), height=3.1, sharex=True, sharey=True)
    for line, visibility in zip(axes, visibilities):
        for axis, scene in zip(line, scenes):
            here = where(rows, scene=scene, visibility=visibility)
            if here:
                gather_panel(axis, here, one(references, scene=scene, width=here[0]["width"])["rmse"])
            axis.set_title(f"{SCENE[scene]}, {VISIBILITY[visibility]}")
        line[0].set_ylabel("RMSE of the picture")
    for axis in axes[-1]:
        axis.set_xlabel("virtual lights and gather, ms")
    plain_ticks(axes[0][0].yaxis)
    handles = [key(METHOD[name], color=colour, marker=marker, linewidth=0.7)
               for name, (colour, marker) in METHOD_STYLE.items()]
    legend_below(figure, handles + [FRONT_KEY, key("what the reference's error adds", color="#888888", linewidth=3)], 7)
    save(figure, folder, "gather")


FORM_COLOUR = {"evaluate": BLUE, "evaluate_with_gradient": BLUE, "cap": BLUE, "orient": BLUE, "polynomial": ORANGE,
               "polynomial_gradient": ORANGE, "sloan_like": RED, "cap_legendre": RED, "cap_closed_form": ORANGE}
FORM_NAME = {"evaluate": "recurrences", "evaluate_with_gradient": "ladder", "cap": "differences (stable)",
             "orient": "recurrences", "polynomial": "polynomials", "polynomial_gradient": "polynomials",
             "sloan_like": "Sloan's like, by angles", "cap_legendre": "Legendre polynomials",
             "cap_closed_form": "closed forms"}
SCALAR_MARKER = {"float": "o", "double": "s", "packet": "^"}
QUANTITY = {"evaluation": "basis", "gradient": "basis and gradient", "cap": "spherical cap, zonal",
            "rotation": "zonal lobe turned (SLS05)"}


def evaluation(folder):
    rows = read(folder, "evaluation")
    if not rows:
        return
    figure, axes = panels(2, 2, height=3.4)
    for axis, quantity in zip(axes.flat, QUANTITY):
        here = where(rows, quantity=quantity)
        for form, scalar in distinct(here, "form", "scalar"):
            colour, marker = FORM_COLOUR[form], SCALAR_MARKER[scalar]
            line = [row for row in where(here, form=form, scalar=scalar) if row["error"] > 0]
            axis.plot([row["ns"] for row in line], [row["error"] for row in line], color=colour, alpha=0.5,
                      linewidth=0.7)
            for row in line:
                front = pareto(where(here, bands=row["bands"]), lambda r: r["ns"], lambda r: r["error"])
                axis.plot(row["ns"], row["error"], marker, color=colour, markerfacecolor=fill_of(row in front, colour))
                if form in ("evaluate", "evaluate_with_gradient", "cap", "orient") and row["bands"] in (3, 5, 10):
                    axis.annotate(f"{row['bands']:.0f}", (row["ns"], row["error"]), (0, 5), size=7,
                                  textcoords="offset points", ha="center")
        axis.set(xscale="log", yscale="log", xlabel="ns per item", ylabel="greatest error", title=QUANTITY[quantity])
        forms = [form for form in distinct(here, "form")]
        axis.legend(handles=[key(FORM_NAME[form], color=FORM_COLOUR[form]) for form in forms],
                    loc=(0.5, 0.2 if quantity == "cap" else 0.42))
    handles = [key(scalar, color="#666666", marker=marker, linestyle="") for scalar, marker in SCALAR_MARKER.items()]
    handles += [key("on the front of its bands", color="#666666", marker="o", linestyle=""),
                key("beaten", color="#666666", marker="o", markerfacecolor="white", linestyle="")]
    legend_below(figure, handles, 5)
    save(figure, folder, "evaluation")


INTERPOLATION = {"trilinear": (ORANGE, "o"), "taylor": (RED, "s"), "hermite": (BLUE, "^")}


def interpolation(folder):
    rows = read(folder, "interpolation")
    if not rows:
        return
    figure, axes = panels(1, 3)
    views = [("memory, KiB", lambda row: row["kibibytes"], "value_error", "mean error of coefficients"),
             ("grid and one picture's lookups, ms", frame_ms, "value_error", "mean error of coefficients"),
             ("memory, KiB", lambda row: row["kibibytes"], "gradient_error", "mean error of gradients")]
    for axis, (label, x, error, name) in zip(axes[0], views):
        for method, (colour, marker) in INTERPOLATION.items():
            line = where(rows, method=method)
            axis.plot([x(row) for row in line], [row[error] for row in line], color=colour, alpha=0.5)
        front = pareto(rows, x, lambda row: row[error])
        for row in rows:
            colour, marker = INTERPOLATION[row["method"]]
            axis.plot(x(row), row[error], marker, color=colour, markerfacecolor=fill_of(row in front, colour))
        draw_front(axis, rows, x, lambda row: row[error])
        axis.set(xscale="log", yscale="log", xlabel=label, ylabel=name)
    handles = [key(name, color=colour, marker=marker) for name, (colour, marker) in INTERPOLATION.items()]
    legend_below(figure, handles + [FRONT_KEY], 4)
    save(figure, folder, "interpolation")


def triangles(folder):
    rows = read(folder, "triangles")
    if not rows:
        return
    bands = distinct(rows, "bands")
    figure, axes = panels(1, len(bands), sharey=True)
    styles = {"quadrature": (BLUE, "o", "nodes"), "spheres": (ORANGE, "s", "triangles")}
    for axis, number in zip(axes[0], bands):
        here = where(rows, bands=number)
        front = pareto(here, lambda row: row["ns"], lambda row: row["value_error"])
        for method, (colour, marker, count) in styles.items():
            line = where(here, method=method)
            axis.plot([row["ns"] for row in line], [row["value_error"] for row in line], color=colour, alpha=0.5)
            for row in line:
                axis.plot(row["ns"], row["value_error"], marker, color=colour,
                          markerfacecolor=fill_of(row in front, colour))
                above = {"textcoords": "offset points", "size": 7, "color": colour}
                if method == "spheres" or row["nodes"] <= 5:
                    axis.annotate(f"{row[count]:.0f}", (row["ns"], row["value_error"]), (5, 3), **above)
        draw_front(axis, here, lambda row: row["ns"], lambda row: row["value_error"])
        axis.set(xscale="log", yscale="log", xlabel="ns per receiver", title=f"{number:.0f} bands")
    axes[0][0].set_ylabel("greatest error")
    legend_below(figure, [key("exactly: nodes per edge", color=BLUE, marker="o"),
                          key("as spheres: how many triangles", color=ORANGE, marker="s"), FRONT_KEY], 3)
    save(figure, folder, "triangles")


STIFF_FORM = {"differences": (BLUE, "differences"), "legendre": (RED, "Legendre polynomials, as printed"),
              "closed": (ORANGE, "closed forms"), "ladder": (BLUE, "ladder"),
              "sloan_like": (RED, "by angles, Sloan's like, as printed"),
              "direct": (ORANGE, "by angles, direct, as printed"),
              "edges": (BLUE, "from the edges"), "corners": (RED, "from the corners, as printed"),
              "sphere": (GREEN, "as a sphere"), "basis": (BLUE, "basis, by differences"), "in_z": (RED, "basis, in z"),
              "cap": (GREEN, "cap"), "cap_derivative": (PURPLE, "its derivative"), "phong": (ORANGE, "Phong, 1000"),
              "gaussian": (SKY, "Gaussian, 1000")}
STIFF_ERRORS = {"cap": ("cap, 10 bands", "radius over distance"),
                "gradient": ("gradient, 10 bands", "sine of the pole's distance"),
                "solid_angle": ("a triangle's solid angle", "distance over size"), "degree": ("each degree", "degree")}
STIFF_WAYS = {"pan": ("through a sphere's surface", "height above it, in radii", 1e-6, (1e-6, 1e-3, 1)),
              "fly_by": ("past a sphere, 1.001 radii from its centre", "way along, in radii", 1, (1, 1e3, 1e6))}
NO_NUMBER = 1e9


def stiff(folder):
    rows = read(folder, "stiff")
    if not rows:
        return
    figure, axes = panels(4, 2, height=3.1)
    for axis, (plot, (title, x)) in zip(axes[:2].flat, STIFF_ERRORS.items()):
        for form in distinct(where(rows, plot=plot), "form"):
            colour, label = STIFF_FORM[form]
            line = [row for row in where(rows, plot=plot, form=form) if row["y"] < NO_NUMBER]
            axis.plot([row["x"] for row in line], [max(row["y"], 1e-9) for row in line], color=colour, label=label)
        axis.set(xscale="linear" if plot == "degree" else "log", yscale="log", xlabel=x, title=title)
        axis.legend(fontsize=7)
    for line in axes[:2]:
        line[0].set_ylabel("relative error in float")
    for line, what in zip(axes[2:], ("value", "gradient")):
        for axis, (plot, (title, x, threshold, ticks)) in zip(line, STIFF_WAYS.items()):
            for degree, colour in enumerate((BLACK, BLUE, ORANGE, GREEN)):
                points = sorted((row["x"], row["y"]) for row in where(rows, plot=plot, form=f"{what} {degree}"))
                axis.plot(*zip(*points), color=colour, label=f"degree {degree}")
            axis.set_xscale("symlog", linthresh=threshold)
            axis.set_xticks([-tick for tick in reversed(ticks)] + [0, *ticks])
            if what == "gradient":
                axis.set_yscale("log")
            axis.set(xlabel=x, title=title)
            free = "upper left" if plot == "fly_by" else "center left" if what == "value" else "upper right"
            axis.legend(fontsize=7, loc=free)
        line[0].set_ylabel(f"{what}, order 0" if what == "value" else "length of the gradient")
    save(figure, folder, "stiff")


WINDOW_STYLE = {"none": (BLUE, "-"), "sinc": (ORANGE, "--"), "hann": (RED, ":")}


def materials(folder):
    rows = where(read(folder, "materials"), quantity="receiver")
    if not rows:
        return
    names = distinct(rows, "material")
    columns = 3
    figure, axes = panels(-(-len(names) // columns), columns, height=1.9, sharex=True, sharey=True)
    for axis, name in zip(axes.flat, names):
        for window, (colour, dashes) in WINDOW_STYLE.items():
            line = where(rows, material=name, window=window)
            axis.plot([row["bands"] for row in line], [row["error"] for row in line], color=colour, linestyle=dashes,
                      linewidth=1.4)
        axis.set(yscale="log", title=name, xticks=[1, 5, 9, 13, 17, 21])
    for axis in axes.flat[len(names):]:
        axis.set_visible(False)
    for line in axes:
        line[0].set_ylabel("relative error")
    for axis in axes[-1]:
        axis.set_xlabel("bands")
    legend_below(figure, [key(f"window: {name}", color=colour, linestyle=dashes)
                          for name, (colour, dashes) in WINDOW_STYLE.items()], 3)
    save(figure, folder, "materials")


def furnace(folder):
    rows = read(folder, "furnace")
    if not rows:
        return
    names, counts = distinct(rows, "material"), distinct(rows, "lights")
    shades = dict(zip(counts, (SKY, BLUE, BLACK, PURPLE)))
    figure, axes = panels(2, len(names), height=2.3, sharex=True, sharey="row")
    for line, method in zip(axes, ("hvl", "hvl-zonal")):
        for axis, name in zip(line, names):
            for lights in counts:
                for degrees, dashes in ((0, "-"), (60, ":")):
                    here = where(rows, method=method, material=name, lights=lights, degrees=degrees)
                    axis.plot([row["bands"] for row in here], [100 * (row["relative_energy"] - 1) for row in here],
                              dashes, color=shades[lights])
            axis.axhline(0, color="#888888", linewidth=0.8)
            axis.set(title=f"{METHOD[method]}, {name}", xticks=[1, 5, 9, 15, 21])
        line[0].set_ylabel("bias of energy, %")
    for axis in axes[-1]:
        axis.set_xlabel("bands")
    handles = [key(f"{lights:.0f} lights", color=shades[lights]) for lights in counts]
    handles += [key("seen from the normal", color="#666666"), key("from 60 degrees", color="#666666", linestyle=":")]
    legend_below(figure, handles, len(handles))
    save(figure, folder, "furnace")


PROBE_STYLE = {"3 bands; floats": (BLACK, "o"), "3 bands; halves": (BLACK, "s"), "3 bands; bytes by band": (BLACK, "v"),
               "3 bands; bytes": (BLACK, "D"), "ZH3; solved": (BLUE, "o"), "ZH3; hallucinated": (SKY, "^"),
               "2 bands": (RED, "o"), "2 bands; non-linear": (ORANGE, "s"), "six floats": (PURPLE, "o"),
               "six floats; non-linear": (GREEN, "s")}


def probe(folder):
    rows = read(folder, "probe")
    if not rows:
        return
    sources = [(source, title) for source, title in (("file", "pictures of real ones"), ("made", "made ones"))
               if where(rows, source=source)]
    figure, axes = panels(1, len(sources), height=3.6, sharex=True, sharey=True)
    # Forms of equal size side by side.
    shift = {"six floats": 0.97, "six floats; non-linear": 1.03, "ZH3; hallucinated": 0.98, "2 bands; non-linear": 1.03}
    for axis, (source, title) in zip(axes[0], sources):
        for form, (colour, marker) in PROBE_STYLE.items():
            here = where(rows, source=source, form=form)
            errors = sorted(100 * row["rmse"] for row in here)
            x = here[0]["bytes"] * shift.get(form, 1)
            axis.plot([x] * len(errors), errors, "_", color=colour, alpha=0.6, markersize=5)
            axis.plot(x, errors[len(errors) // 2], marker, color=colour, zorder=3)
        axis.set(xscale="log", yscale="log", xlabel="bytes of a probe, RGB", title=f"environments: {title}",
                 xticks=[24, 33, 45, 54, 60, 108])
        axis.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
        axis.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
        plain_ticks(axis.yaxis)
    axes[0][0].set_ylabel("error of irradiance, %")
    handles = [key(form.replace(";", ","), color=colour, marker=marker, linestyle="")
               for form, (colour, marker) in PROBE_STYLE.items()]
    handles.append(key("an environment (filled: median)", color="#888888", marker="_", linestyle=""))
    legend_below(figure, handles, 4)
    save(figure, folder, "probe")


FILTER_STYLE = {"radiance": (BLUE, "^"), "irradiance": (RED, "o"), "irradiance-strict": (ORANGE, "s"),
                "sg": (GREEN, "v"), "l1": (PURPLE, "D"), "none": (BLACK, "x")}
SCREEN_SCENE = {"diffuse": "matte, panel", "bumped": "bumped, three points", "bumped-area": "bumped, panel",
                "bumped-glossy": "bumped glossy, panel", "probe": "courtyard, light probe"}


def screen_panel(axis, rows):
    filtered = [row for row in rows if row["filter"] in FILTER_STYLE]
    for row in filtered:
        colour, marker = FILTER_STYLE[row["filter"]]
        axis.plot(screen_ms(row), row["rmse"], marker, color=colour)
    draw_front(axis, filtered, screen_ms, lambda row: row["rmse"])
    for row in where(rows, filter="bands alone"):
        axis.axhline(row["rmse"], color=SKY, linestyle=":")
    axis.set(xscale="log", yscale="log")


def screen(folder):
    rows = where(read(folder, "screen"), part="sweep")
    if not rows:
        return
    scenes, patterns = distinct(rows, "scene"), distinct(rows, "pattern")
    figure, axes = panels(len(patterns), len(scenes), width=11.0, height=2.6, sharex="row", sharey=True)
    for line, pattern in zip(axes, patterns):
        for axis, scene in zip(line, scenes):
            screen_panel(axis, where(rows, scene=scene, pattern=pattern))
            axis.set_title(f"{SCREEN_SCENE[scene]}, {pattern}", size=8)
            axis.set_xlabel("light, filter and shading, ms")
        line[0].set_ylabel("RMSE of the picture")
    for axis in axes.flat:
        plain_ticks(axis.xaxis)
    plain_ticks(axes[0][0].yaxis)
    handles = [key(name, color=colour, marker=marker, linestyle="")
               for name, (colour, marker) in FILTER_STYLE.items()]
    legend_below(figure, handles + [FRONT_KEY, key("bands alone, nothing filtered", color=SKY, linestyle=":")], 8)
    save(figure, folder, "screen")


SETS_STYLE = {**FILTER_STYLE, "reference": (BLACK, ".")}
SETS_NAME = {"reference": "all sets at every pixel"}


def sets_line(rows, name):
    return [(row["sets"], row["rmse"]) for row in where(rows, filter=name)]


def screen_sets(folder):
    rows = where(read(folder, "screen"), part="sets")
    if not rows:
        return
    figure, axes = panels(1, 1, width=5.5, height=3.2)
    axis = axes[0][0]
    for name in distinct(rows, "filter"):
        line, (colour, marker) = sets_line(rows, name), SETS_STYLE[name]
        label = f"{SETS_NAME.get(name, name)}, slope {log_slope(line):.2f}"
        axis.plot(*zip(*line), color=colour, marker=marker, label=label)
    axis.set(xscale="log", yscale="log", xlabel="sets of lights", ylabel="RMSE of the picture",
             xticks=distinct(rows, "sets"))
    axis.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axis.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    plain_ticks(axis.yaxis)
    axis.legend(loc="upper left", bbox_to_anchor=(1, 1))
    save(figure, folder, "screen_sets")


FIELD_STYLE = {"linear": (BLUE, "o"), "mean": (ORANGE, "s"), "nearest": (GREEN, "v"), "space": (RED, "D")}
FIELD_NAME = {"linear": "linear fit", "mean": "mean", "nearest": "linear fit, nearest repair", "space": "the paper's steps"}
FIELD_SETUP = {"projector": "area light and projector", "spots": "half-blocked spot and cone"}


def grid_ticks(axis, values):
    axis.set_xticks(values, [f"{value:.0f}" for value in values])
    axis.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())


def field_axis(axis, rows, **titles):
    axis.set(xscale="log", yscale="log", xlabel="grid points along an edge", **titles)
    grid_ticks(axis, distinct(rows, "resolution"))


def field(folder):
    """Above, error by number of probes; below, of most probes by method."""
    rows = where(read(folder, "field"), part="error")
    if not rows:
        return
    counts, setups = distinct(rows, "probes"), distinct(rows, "setup")
    shades = dict(zip(counts, (SKY, PURPLE, BLUE)))
    figure, axes = panels(2, len(setups), height=3.0, sharex=True, sharey=True)
    for column, setup in zip(axes.T, setups):
        here = where(rows, setup=setup)
        for probes in counts:
            line = where(here, probes=probes, method="linear", interpolation="trilinear")
            column[0].plot([row["resolution"] for row in line], [row["error"] for row in line], "o-",
                           color=shades[probes])
        for method, interpolation in distinct(where(here, probes=counts[-1]), "method", "interpolation"):
            colour, marker = FIELD_STYLE[method]
            line = where(here, probes=counts[-1], method=method, interpolation=interpolation)
            column[1].plot([row["resolution"] for row in line], [row["error"] for row in line], color=colour,
                           marker=marker, linestyle=":" if interpolation == "hermite" else "-")
        column[0].set(title=FIELD_SETUP[setup])
        for axis in column:
            field_axis(axis, rows)
    for axis in axes[:, 0]:
        axis.set_ylabel("error / RMS of coefficients")
    plain_ticks(axes[0][0].yaxis)
    handles = [key(f"{probes:.0f} probes", color=shades[probes], marker="o") for probes in counts]
    handles += [key(FIELD_NAME[method], color=colour, marker=marker) for method, (colour, marker) in FIELD_STYLE.items()]
    legend_below(figure, handles + [key("linear fit, Hermite", color=BLUE, marker="o", linestyle=":")], 4)
    save(figure, folder, "field")


def bake_line(rows, x, **conditions):
    """Seconds that bakes take, the mean of the set-ups, against probes or vertices."""
    chosen = where(rows, interpolation="trilinear", **conditions)
    groups = [(value, [row["bake_s"] for row in where(chosen, **{x: value})]) for value in distinct(chosen, x)]
    return [(value ** 3 if x == "resolution" else value, sum(times) / len(times)) for value, times in groups]


def field_time(folder):
    rows = where(read(folder, "field"), part="error")
    if not rows:
        return
    most = distinct(rows, "probes")[-1]
    figure, axes = panels(1, 2, height=2.9)
    for resolution, colour in zip(distinct(rows, "resolution"), (SKY, GREEN, ORANGE, BLUE)):
        axes[0][0].plot(*zip(*bake_line(rows, "probes", method="linear", resolution=resolution)), "o-", color=colour,
                        label=f"{resolution:.0f}³ points")
    axes[0][0].set(xscale="log", yscale="log", xlabel="probes", ylabel="resampling, s", title="linear fit")
    axes[0][0].legend(loc="upper center", bbox_to_anchor=(0.5, 0.86), ncols=2)
    for method in ("linear", "mean", "space"):
        colour, marker = FIELD_STYLE[method]
        axes[0][1].plot(*zip(*bake_line(rows, "resolution", method=method, probes=most)), color=colour, marker=marker,
                        label=FIELD_NAME[method])
    axes[0][1].set(xscale="log", yscale="log", xlabel="grid points", title=f"{most:.0f} probes")
    axes[0][1].legend()
    plain_ticks(axes[0][0].xaxis)
    save(figure, folder, "field_time")


SCENE_STYLE = {"diffuse": (ORANGE, "o"), "glossy": (BLUE, "^"), "measured": (GREEN, "s")}


def planned_seconds(row):
    return row["tree_s"] + row["gather_s"]


def many_lights(folder):
    """Time against lights; error against tolerance; time against tolerance."""
    rows = read(folder, "many_lights")
    if not rows:
        return
    figure, (axes,) = panels(1, 3, height=3.0)
    by_lights = where(rows, part="lights")
    by_tolerance = where(rows, part="tolerance")
    most = max(distinct(by_tolerance, "lights"))
    for scene, (colour, marker) in SCENE_STYLE.items():
        line = where(by_lights, scene=scene)
        axes[0].plot([row["lights"] for row in line], [planned_seconds(row) for row in line], color=colour, marker=marker)
        axes[0].plot([row["lights"] for row in line], [row["full_s"] for row in line], color=colour, linestyle=":")
        line = where(by_tolerance, scene=scene, lights=most)
        tolerances = [row["tolerance"] for row in line]
        axes[1].plot(tolerances, [row["proved"] for row in line], color=colour, linestyle="--")
        axes[1].plot(tolerances, [row["measured"] for row in line], color=colour, marker=marker)
        axes[2].plot(tolerances, [planned_seconds(row) for row in line], color=colour, marker=marker)
        axes[2].plot(tolerances, [row["full_s"] for row in line], color=colour, linestyle=":")
    axes[1].plot(tolerances, tolerances, **FRONT)
    axes[0].set(xscale="log", yscale="log", xlabel="lights", ylabel="tree and gather, s", title="1 %, 1280 x 720")
    axes[1].set(xscale="log", yscale="log", xlabel="tolerance", ylabel="error", title=f"{most:.0f} lights")
    axes[2].set(xscale="log", yscale="log", xlabel="tolerance", ylabel="tree and gather, s", title=f"{most:.0f} lights")
    handles = [key(SCENE[scene], color=colour, marker=marker) for scene, (colour, marker) in SCENE_STYLE.items()]
    handles += [key("in full", color=BLACK, linestyle=":"), key("error, proved", color=BLACK, linestyle="--"),
                key("tolerance", **FRONT)]
    legend_below(figure, handles, 6)
    save(figure, folder, "many_lights")


def overview(folder):
    """The README's: one panel each of the basis, virtual lights and grids, beside the rivals."""
    basis, interpolation_rows = read(folder, "evaluation"), read(folder, "interpolation")
    pictures = where(read(folder, "gather"), part="sweep", scene="glossy", visibility="centre")
    if not (basis and interpolation_rows and pictures):
        return
    figure, axes = panels(1, 3, height=2.9)
    axis = axes[0][0]
    forms = {"evaluate_with_gradient": "zonal", "polynomial_gradient": "polynomials", "sloan_like": "by angles"}
    for form, label in forms.items():
        for scalar, dashes in (("float", "-"), ("packet", ":")):
            line = where(basis, quantity="gradient", form=form, scalar=scalar)
            axis.plot([row["bands"] for row in line], [row["ns"] for row in line], dashes,
                      color=FORM_COLOUR[form], label=label if scalar == "float" else None)
    lanes = max(row["lanes"] for row in basis)
    axis.set(yscale="log", xlabel="bands", ylabel="ns per direction", title="basis and gradient")
    axis.plot([], [], ":", color="#666666", label=f"in packets of {lanes:.0f}")

    axis = axes[0][1]
    for method, (colour, marker) in METHOD_STYLE.items():
        front = pareto(where(pictures, method=method), gather_ms, lambda row: row["rmse"])
        axis.plot([gather_ms(row) for row in front], [row["rmse"] for row in front], color=colour, marker=marker,
                  label=METHOD[method])
    axis.set(xscale="log", yscale="log", xlabel="virtual lights and gather, ms", ylabel="RMSE of the picture",
             title="glossy atrium, by their best variants")
    for ticks in (axis.xaxis, axis.yaxis):
        plain_ticks(ticks)

    axis = axes[0][2]
    for method, (colour, marker) in INTERPOLATION.items():
        line = where(interpolation_rows, method=method)
        axis.plot([row["kibibytes"] for row in line], [row["value_error"] for row in line], color=colour, marker=marker,
                  label=method)
    axis.set(xscale="log", yscale="log", xlabel="memory of the grid, KiB", ylabel="mean error of coefficients",
             title="64 lights on a grid")
    for axis, columns in zip(axes[0], (2, 3, 3)):
        axis.legend(loc="upper center", bbox_to_anchor=(0.5, -0.24), ncols=columns)
    save(figure, folder, "overview")


ALL = [gather, many_lights, evaluation, interpolation, triangles, stiff, materials, furnace, probe, screen, screen_sets, field,
       field_time, overview]
