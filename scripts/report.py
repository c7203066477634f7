"""docs/report from its CSV files: plots, and README.md with tables and what they say; see report.sh.

    report.py plot FOLDER
"""
import pathlib
import sys

import report_plots
from report_data import LOOKUPS, METHOD, distinct, frame_ms, interpolated, one, read, where
from report_field_text import field
from report_many_lights_text import many_lights
from report_gather_text import gather
from report_screen_text import screen
from report_text import figure, listed, table


def bytes_text(kibibytes):
    return f"{kibibytes:.0f} KiB" if kibibytes < 1024 else f"{kibibytes / 1024:.1f} MiB"


# ---- What it was made on ---------------------------------------------------------------------------------------------

def machine(folder):
    rows = []
    for part in PARTS:
        facts = {row["fact"]: row["value"] for row in read(folder, f"{part}.machine", str)}
        if not facts:
            continue
        changed = f" and {facts['changed']} changed files" if facts["changed"] != "0" else ""
        rows.append([f"[{part}]({part}.csv)", facts["run"].lstrip("-"), facts["date"], facts["commit"] + changed,
                     f"{facts['processor']}, {facts['threads']} threads", facts["load"], facts["compiler"]])
    return table(["part", "run", "date", "commit", "processor", "load before", "compiler"], rows)


# ---- Evaluation ------------------------------------------------------------------------------------------------------

def evaluation(folder):
    rows = read(folder, "evaluation")
    lines = []
    for quantity, form in distinct(rows, "quantity", "form"):
        line = [f"{report_plots.QUANTITY[quantity]}: {report_plots.FORM_NAME[form]}"]
        for scalar in ("float", "double", "packet"):
            for bands in (5, 10):
                row = one(rows, quantity=quantity, form=form, scalar=scalar, bands=bands)
                line.append(f"{row['ns']:.2f} ns, {row['error']:.0e}" if row else "-")  # quick data has few bands
        lines.append(line)
    titles = ["greatest error, time"] + [f"{scalar}, {bands}" for scalar in ("float", "double", "packet")
                                         for bands in (5, 10)]
    lanes = max(row["lanes"] for row in rows)
    gains = {quantity: one(rows, quantity=quantity, form=form, scalar="float", bands=5)["ns"] /
             one(rows, quantity=quantity, form=form, scalar="packet", bands=5)["ns"]
             for quantity, form in (("evaluation", "evaluate"), ("gradient", "evaluate_with_gradient"), ("cap", "cap"),
                                    ("rotation", "orient"))}
    worst = max(where(rows, quantity="cap", form="cap_legendre", scalar="float"), key=lambda row: row["error"])
    stable = max(where(rows, quantity="cap", form="cap", scalar="float"), key=lambda row: row["error"])
    return "\n\n".join([
        "## Evaluation", figure("evaluation", "error and time of basis, gradient, cap and rotation"),
        "The greatest error, in units of the degree's largest value (of a cap: of its largest coefficient), over "
        "directions of which half are near a pole, and caps of which half are small, down to 1e-4 radians; ns per "
        "direction, cap or lobe on one thread. Numbers at points: bands. Filled: no other form or scalar is both "
        "faster and more accurate at this number of bands.",
        f"In packets of {lanes:.0f} floats 5 bands are "
        f"{listed([f'{gain:.1f} ({quantity})' for quantity, gain in gains.items()])} times as fast as one by one. "
        f"For small caps the papers' form errs by {worst['error']:.1g} of the cap's largest coefficient in float, "
        f"the stable one by {stable['error']:.1g}.", table(titles, lines)])


# ---- Interpolation ---------------------------------------------------------------------------------------------------

def equal(rows, method, x, value, error):
    """A method's error at a given memory or time, between its resolutions."""
    return interpolated([(x(row), row[error]) for row in where(rows, method=method)], value)


def ratio_text(found, own):
    return f"{found / own:.3g}" if found else "-"


def interpolation(folder):
    rows = read(folder, "interpolation")
    hermite = where(rows, method="hermite")
    lines, best = [], []
    for row in hermite:
        memory = [equal(rows, method, lambda r: r["kibibytes"], row["kibibytes"], "value_error")
                  for method in ("trilinear", "taylor")]
        time = [equal(rows, method, frame_ms, frame_ms(row), "value_error") for method in ("trilinear", "taylor")]
        gradient = equal(rows, "trilinear", lambda r: r["kibibytes"], row["kibibytes"], "gradient_error")
        best.append((row["resolution"], memory[0], time[0], row["value_error"]))
        lines.append([f"{row['resolution']:.0f}³", bytes_text(row["kibibytes"]), f"{frame_ms(row):.0f}",
                      f"{row['value_error']:.1e}", *(ratio_text(found, row["value_error"]) for found in memory + time),
                      f"{row['gradient_error']:.1e}", ratio_text(gradient, row["gradient_error"])])
    by_memory = [f"{size:.0f}³" for size, memory, _, error in best if memory and memory < error]
    by_time = [f"{size:.0f}³" for size, _, time, error in best if time and time < error]
    titles = ["Hermite grid", "memory", "ms", "error", "trilinear, equal memory", "Taylor, equal memory",
              "trilinear, equal time", "Taylor, equal time", "error of gradients", "trilinear's gradients, equal memory"]
    taylor = [one(rows, method="taylor", resolution=row["resolution"])["value_error"] / row["value_error"]
              for row in where(rows, method="trilinear") if one(rows, method="taylor", resolution=row["resolution"])]
    return "\n\n".join([
        "## Interpolation", figure("interpolation", "error of the interpolations by memory and time"),
        f"{rows[0]['bands']:.0f} bands of {rows[0]['lights']:.0f} sphere lights about a box, RGB: mean error at "
        "random places over the mean coefficient (or gradient). Trilinear interpolation needs values alone: its grid "
        f"counts a quarter of the memory, and is filled without gradients. The time is that of the grid and of "
        f"{LOOKUPS} lookups, of coefficients without their gradients, on one thread.",
        f"Trilinear interpolation is better than Hermite's in equal memory at {listed(by_memory)}, in equal time at "
        f"{listed(by_time)}; elsewhere Hermite's is. At equal resolution, and four times the memory, Taylor's error is "
        f"{min(taylor):.2f} to {max(taylor):.2f} of the trilinear one. The columns of "
        "factors say how many times Hermite's error the others have.",
        table(titles, lines)])


# ---- Triangles -------------------------------------------------------------------------------------------------------

def triangles_table(rows):
    bands = distinct(rows, "bands")
    lines = []
    for method, triangles, nodes in distinct(rows, "method", "triangles", "nodes"):
        if nodes > 7:
            continue
        same = [one(rows, method=method, triangles=triangles, nodes=nodes, bands=number) for number in bands]
        exact = f"{nodes:.0f} node{'s' if nodes > 1 else ''} per edge"
        name = f"{triangles:.0f} spheres" if method == "spheres" else exact
        lines.append([name] + [text for row in same for text in (
            f"{row['ns']:.0f}", f"{row['value_error']:.1e}", f"{row['gradient_error']:.1e}")])
    titles = [title for number in bands for title in (f"{number:.0f} bands: ns", "error", "of gradients")]
    return table(["the square as", *titles], lines)


def triangles(folder):
    rows = read(folder, "triangles")
    said = []
    for bands in distinct(rows, "bands"):
        sphere = max(where(rows, method="spheres", bands=bands), key=lambda row: row["triangles"])
        faster = min((row for row in where(rows, method="quadrature", bands=bands)
                      if row["value_error"] <= sphere["value_error"]), key=lambda row: row["ns"], default=None)
        if faster:
            said.append(f"at {bands:.0f} bands {faster['nodes']:.0f} nodes beat {sphere['triangles']:.0f} spheres, "
                        f"{sphere['ns'] / faster['ns']:.0f} times as fast")
    return "\n\n".join([
        "## Triangles", figure("triangles", "error and time of triangles by quadrature and as spheres"),
        "A square light of radiance 1 over a plane: as two triangles, exactly but for the quadrature on their edges, "
        "and cut into many, each approximated by a sphere. Values and gradients in packets of receivers; greatest "
        "error over the greatest coefficient.",
        f"One colour: {listed(said)}. A light of as many colours as triangles would need all of them either way.",
        triangles_table(rows)])


# ---- Stiff inputs ----------------------------------------------------------------------------------------------------

def stiff(folder):
    rows = read(folder, "stiff")
    said = []
    for plot, ours, theirs, name in (("cap", "differences", "legendre", "caps"), ("gradient", "ladder", "sloan_like", "gradients"),
                                     ("solid_angle", "edges", "corners", "solid angles"), ("degree", "basis", "in_z", "the basis")):
        worst = {form: max(row["y"] for row in where(rows, plot=plot, form=form)) for form in (ours, theirs)}
        other = "no number" if worst[theirs] >= report_plots.NO_NUMBER else f"{worst[theirs]:.1e}"
        said.append(f"{name} {worst[ours]:.1e} ({other})")
    slopes = {plot: max(row["y"] for row in where(rows, plot=plot) if row["form"].startswith("gradient"))
              for plot in ("pan", "fly_by")}
    return "\n\n".join([
        "## Stiff inputs", figure("stiff", "errors where sizes, distances and degrees are extreme; ways through and past a sphere"),
        "In float, against wider numbers, relative to the largest coefficient, component or, of each degree, value. Greatest error "
        f"of the library's form, and in brackets of the papers' (of the basis, of the recurrence in z): {listed(said)}.",
        f"A sphere light's value has no step at its surface; its gradient, which is infinite there, ends at {slopes['pan']:.0f} over the "
        f"radius. On the way past, {slopes['fly_by']:.0f}. Tests, \"stiff lights\", hold both to bounds."])


# ---- Materials -------------------------------------------------------------------------------------------------------

SHOWN_BANDS = (3, 5, 7, 9, 15, 21)


def bands_for(rows, error):
    return next((f"{row['bands']:.0f}" for row in rows if row["error"] <= error), "> 21")


def materials_table(rows):
    lines = []
    for material, source in distinct(rows, "material", "source"):
        here = where(rows, material=material, source=source)
        plain = where(here, window="none")
        errors = [f"{one(plain, bands=bands)['error']:.3f}" for bands in SHOWN_BANDS]
        windowed = [f"{one(here, bands=9, window=window)['error']:.3f}" for window in ("sinc", "hann")]
        lines.append([material, source, bands_for(plain, 0.1), bands_for(plain, 0.05), *errors, *windowed])
    titles = ["material", "source", "bands for 10 %", "for 5 %", *(f"{bands} bands" for bands in SHOWN_BANDS), "9, sinc",
              "9, Hann"]
    return table(titles, lines)


def window_text(rows):
    windowed = [row for row in rows if row["window"] != "none" and row["bands"] > 1]
    plain = {(row["material"], row["quantity"], row["bands"]): row["error"] for row in where(rows, window="none")}
    better = [row for row in windowed if row["error"] < plain[row["material"], row["quantity"], row["bands"]]]
    return (f"A window lowers this error in {len(better)} of {len(windowed)} cases: what it is for, ringing, is not "
            "what the mean square measures.")


def materials(folder):
    rows = read(folder, "materials")
    return "\n\n".join([
        "## Materials", figure("materials", "error of materials by bands and windows"),
        "What N bands of a BRDF miss: relative error in L2 over the hemisphere, mean over outgoing angles of 0, 30, "
        "60 and 75 degrees. The receiver's function holds the cosine (the figure, and the first table); the "
        "emitter's is without it, and its error is multiplied by it (the second table).", window_text(rows),
        materials_table(where(rows, quantity="receiver")), materials_table(where(rows, quantity="emitter"))])


# ---- Furnace ---------------------------------------------------------------------------------------------------------

def percent(row):
    return f"{100 * (row['relative_energy'] - 1):+.1f}"


def furnace(folder):
    rows = read(folder, "furnace")
    lights = max(distinct(rows, "lights"))
    here = where(rows, lights=lights)
    columns = distinct(here, "material", "degrees")
    shown = [(method, bands) for method, bands in distinct(here, "method", "bands")
             if bands in (0, 3, 5, 9, 15, 21)]
    lines = [[METHOD.get(method, method.replace("vpl", "VPL").replace("vsl", "VSL")) +
              (f", {bands:.0f} bands" if bands else "")] +
             [percent(one(here, method=method, bands=bands, material=material, degrees=degrees))
              for material, degrees in columns] for method, bands in sorted(shown, key=lambda key: (key[0], key[1]))]
    titles = ["bias, %"] + [f"{material}, {degrees:.0f}°" for material, degrees in columns]
    bias = {}
    for row in where(here, method="hvl"):
        if row["bands"] >= 5:
            bias[row["material"]] = max(bias.get(row["material"], 0), abs(100 * (row["relative_energy"] - 1)))
    kept = listed([f"{most:.1f} % ({material})" for material, most in bias.items()])
    one_band = [row["relative_energy"] for row in where(here, method="hvl", bands=1)]
    return "\n\n".join([
        "## Furnace", figure("furnace", "bias of HVL in a white furnace by bands"),
        "A closed white sphere whose walls send out equal radiance, by virtual lights: the energy that a patch of a "
        "material on the wall reflects, against what it reflects of uniform light. Visibility has no part in it.",
        f"With {lights:.0f} lights, HVL of 5 bands or more keep the energy within {kept}; one band keeps "
        f"{100 * min(one_band):.0f} to {100 * max(one_band):.0f} %. A test, \"furnace\", holds the biases to bounds.",
        table(titles, lines)])


# ---- Probe -----------------------------------------------------------------------------------------------------------

def probe(folder):
    rows = read(folder, "probe")
    environments, lines = distinct(rows, "environment"), []
    files = distinct(where(rows, source="file"), "environment")
    for form, size in distinct(rows, "form", "bytes"):
        here = where(rows, form=form)
        errors = sorted(row["rmse"] for row in here)
        worst = max(here, key=lambda row: row["rmse"])
        lines.append([form.replace(";", ","), f"{size:.0f}", f"{100 * errors[len(errors) // 2]:.2f}",
                      f"{100 * worst['rmse']:.1f} ({worst['environment']})",
                      f"{100 * max(row['greatest'] for row in here):.0f}",
                      f"{min(row['least'] for row in here):.2f}"])
    titles = ["form, RGB", "bytes", "median error, %", "worst, %", "greatest at a normal, %", "least value"]
    return "\n\n".join([
        "## Probe", figure("probe", "error of irradiance by what is kept of a probe, against bytes"),
        f"Irradiance by what is kept of a probe, against the sum over all texels, in {len(environments)} environments, "
        f"{len(files)} of which are pictures of real ones ({listed(files)}): root mean square over normals and channels, "
        "in units of that of irradiance, as are the greatest error and the least value. What is not bytes or halves is "
        "floats; halves need half of the bytes, and err as much.", table(titles, lines)])


PARTS = {"gather": gather, "many_lights": many_lights, "evaluation": evaluation, "interpolation": interpolation, "triangles": triangles,
         "stiff": stiff, "materials": materials, "furnace": furnace, "probe": probe, "screen": screen, "field": field}


def main(command, folder):
    if command != "plot":
        sys.exit(__doc__)
    for draw in report_plots.ALL:
        draw(folder)
    text = ["# Report", "Written by `scripts/report.sh`, whose parts can be run one by one; every figure and number "
            "comes from the CSV files beside it, by `scripts/report.py plot docs/report`.", machine(folder)]
    text += [write(folder) for part, write in PARTS.items() if read(folder, part)]
    (pathlib.Path(folder) / "README.md").write_text("\n\n".join(text) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
