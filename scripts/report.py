"""docs/report from its CSV files: plots, and README.md with tables and what they say; see report.sh.

    report.py plot FOLDER
"""
import pathlib
import sys

import report_plots
from report_data import (LOOKUPS, METHOD, distinct, frame_ms, gather_ms, interpolated, line_fit, one, pareto, read, variant, where)
from report_plots import SCENE, VISIBILITY

PARTS = ["gather", "evaluation", "interpolation", "triangles", "materials", "furnace"]


def table(titles, rows):
    lines = ["| " + " | ".join(titles) + " |", "|:--" + "|--:" * (len(titles) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


def figure(name, text):
    return f"![{text}]({name}.svg)"


def listed(words):
    return " and ".join(filter(None, [", ".join(words[:-1]), words[-1]])) if words else "none"


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


# ---- The gather ------------------------------------------------------------------------------------------------------

def best_at_most(rows, time):
    """The least error among what takes no longer."""
    return min((row for row in rows if gather_ms(row) <= time), key=lambda row: row["rmse"], default=None)


def reference_text(folder, sweep):
    size = sweep[0]["width"]
    said = [f"{row['rmse']:.4f} in the {SCENE[row['scene']]} ({row['paths_per_pixel']:.0f} paths per pixel)"
            for row in read(folder, "references") if row["width"] == size]
    return ("The reference's own RMSE, from two renderings of different seeds, is "
            f"{listed(said)}; the bar below a point is what it adds.")


def front_text(rows):
    lines = []
    for visibility in distinct(rows, "visibility"):
        for scene in distinct(rows, "scene"):
            here = where(rows, scene=scene, visibility=visibility)
            front = pareto(here, gather_ms, lambda row: row["rmse"])
            methods = [METHOD[name] for name in distinct(front, "method")]
            best = front[-1]
            lines.append(f"- {SCENE[scene]}, {VISIBILITY[visibility]}: on the front {listed(methods)}; the least error is "
                         f"{best['rmse']:.4f}, of {variant(best)}, {best['lights']:.0f} lights, "
                         f"{gather_ms(best):.0f} ms.")
    return "\n".join(lines)


def band_text(rows):
    """What bands bring where nothing is glossy, and where much is."""
    lines = []
    for scene in distinct(rows, "scene"):
        here = where(rows, scene=scene, visibility="none", method="hvl", emission_bands=3)
        lights = max(distinct(here, "lights"))
        few, many = (one(here, bands=bands, lights=lights) for bands in (3, 9))
        lines.append(f"{few['rmse']:.4f} to {many['rmse']:.4f} in the {SCENE[scene]}")
    return f"From 3 bands to 9, {lights:.0f} HVL without visibility go from an RMSE of {listed(lines)}."


def source_text(folder):
    source = one(read(folder, "scenes"), scene="measured")["materials"]
    if source.startswith("measured: "):
        return f"The measured materials are {source[len('measured: '):]} of the MERL database."
    return ("The third scene's materials are **not measured**: no files were at hand, and three were written from models, "
            "in the MERL format and at its resolution, and read as measured ones are.")


def gather(folder):
    sweep = where(read(folder, "gather"), part="sweep")
    return "\n\n".join([
        "## Gather", figure("gather", "error of pictures against the time of their virtual lights"),
        f"RMSE of the tone-mapped picture ({sweep[0]['width']:.0f} x {sweep[0]['height']:.0f}, one bounce, direct light "
        "included) against path tracing, by the time that virtual lights and gather take; the projection of materials, "
        "once per material, is not in it. Lines join numbers of lights. Filled: on the front.",
        reference_text(folder, sweep), source_text(folder), front_text(sweep), band_text(sweep),
        table_1(folder), table_2(folder), figure_12(folder)])


TABLE_1 = {(64, 3): 6.6, (64, 5): 7.8, (64, 7): 10.3, (64, 9): 18.6, (196, 3): 19.8, (196, 5): 23.5, (196, 7): 30.4,
           (196, 9): 56.1, (400, 3): 41.0, (400, 5): 48.6, (400, 7): 62.7, (400, 9): 115.3}


def growth(times):
    """How far the times are from a line in the lights, and from one in the bands squared, and what a light costs without
    any bands, as a share of what it costs with most: of the latter line."""
    lights, bands = sorted({key[0] for key in times}), sorted({key[1] for key in times})
    in_lights = max(line_fit([(count, times[count, number]) for count in lights])[2] for number in bands)
    fixed, _, in_bands = line_fit([(number ** 2, times[lights[-1], number]) for number in bands])
    return in_lights, in_bands, fixed / times[lights[-1], bands[-1]]


def table_1(folder):
    rows = where(read(folder, "gather"), part="table_1")
    here = {(int(row["lights"]), int(row["bands"])): 1e3 * row["gather_s"] for row in rows}
    lines = [[lights] + [text for bands in (3, 5, 7, 9)
                         for text in (f"{TABLE_1[lights, bands]:.1f}", f"{here[lights, bands]:.1f}")]
             for lights in (64, 196, 400)]
    titles = ["HVL"] + [title for bands in (3, 5, 7, 9) for title in (f"{bands} bands", "here")]
    text = []
    for name, times in (("The paper's own times", TABLE_1), ("Ours", here)):
        in_lights, in_bands, fixed = growth(times)
        text.append(f"{name} are within {100 * in_lights:.0f} % of a line in the lights, which "
                    f"{'holds' if in_lights < 0.15 else 'fails'}, and within {100 * in_bands:.0f} % of one in the square of "
                    f"the bands, which {'holds' if in_bands < 0.15 else 'fails'}; {100 * fixed:.0f} % of the time at 9 bands "
                    "does not depend on them.")
    return "\n\n".join([
        "### HVL, Table 1: gather, ms",
        f"3 bands of emission; the paper's teaser on an RTX 2080, and here the glossy atrium, {rows[0]['width']:.0f} x "
        f"{rows[0]['height']:.0f}, on the processor. The paper calls the cost linear in the lights and quadratic in the "
        "bands.", table(titles, lines), " ".join(text)])


# Lights, samples or bands, gather in ms, RMSE, PSNR, SSIM.
TABLE_2 = {"10b": ("400", "", 13, 0.054, 25.20, 0.977), "10c": ("1928", "", 61, 0.088, 21.10, 0.981),
           "11b": ("10k", "", 500, 0.040, 27.91, 0.984), "10d": ("400", "25 samples", 254, 0.043, 27.24, 0.974),
           "10e": ("256", "9 samples", 63, 0.043, 27.26, 0.972), "10a": ("400", "5 bands", 61, 0.039, 28.01, 0.980),
           "11a": ("1.5k", "9 bands", 500, 0.039, 28.24, 0.983)}


def table_2_lines(rows):
    lines = []
    for label, (lights, more, ms, rmse, psnr, ssim) in TABLE_2.items():
        row = one(rows, label=label)
        lines.append([f"{METHOD[row['method']]} {label}", more, lights, f"{row['lights']:.0f}", ms,
                      f"{gather_ms(row):.0f}", f"{rmse:.3f}", f"{row['rmse']:.4f}", f"{psnr:.2f}",
                      f"{row['psnr_db']:.2f}", f"{ssim:.3f}", f"{row['ssim']:.3f}"])
    return lines


def verdict(hvl, rival, noise):
    """Whether the HVL's RMSE is the lower, as the paper says; decided only where the difference is larger than what the
    reference's own error adds to it."""
    added = hvl["rmse"] - max(hvl["rmse"] ** 2 - noise ** 2, 0) ** 0.5
    difference = rival["rmse"] - hvl["rmse"]
    said = f"{METHOD['hvl']} {hvl['rmse']:.4f} in {gather_ms(hvl):.0f} ms, {METHOD[rival['method']]} {rival['rmse']:.4f} " \
           f"in {gather_ms(rival):.0f} ms"
    if abs(difference) <= added:
        return f"**not decided**: {said}, apart by less than the reference's error adds ({added:.4f})"
    return f"**{'holds' if difference > 0 else 'fails'}**: {said}"


EQUAL_TIME = [("10a", "10c", "Fig. 10 a and c"), ("10a", "10e", "Fig. 10 a and e"), ("11a", "11b", "Fig. 11 a and b")]


def picture_row(labels, rows, reference=True):
    shown = [one(rows, label=label) for label in labels]
    titles = [f"{row['label'][2:]}: {variant(row)}, {row['lights']:.0f} lights, {gather_ms(row):.0f} ms, "
              f"RMSE {row['rmse']:.4f}" for row in shown]
    pictures = [f"![]({row['picture']})" for row in shown]
    if reference:
        titles, pictures = titles + ["path tracing"], pictures + ["![](pictures/reference.png)"]
    return "\n".join(["| " + " | ".join(titles) + " |", "|" + " --- |" * len(titles), "| " + " | ".join(pictures) + " |"])


def table_2(folder):
    rows = where(read(folder, "gather"), part="table_2")
    noise = one(read(folder, "references"), scene="glossy", width=rows[0]["width"])["rmse"]
    titles = ["figure", "", "lights", "here", "ms", "here", "RMSE", "here", "PSNR, dB", "here", "SSIM", "here"]
    text = ["### HVL, Table 2, and Fig. 10 and 11",
            f"The glossy atrium, {rows[0]['width']:.0f} x {rows[0]['height']:.0f}, for the paper's own scenes. 10a, 10b and "
            "10d have equal counts; 10a, 10c and 10e equal time, and so 11a and 11b. The reference's own RMSE is "
            f"{noise:.4f}. The paper says that at equal time HVL have the lower RMSE."]
    for visibility in distinct(rows, "visibility"):
        here = where(rows, visibility=visibility)
        lines = [f"- {name}: {verdict(one(here, label=hvl), one(here, label=rival), noise)}."
                 for hvl, rival, name in EQUAL_TIME]
        text += [f"**{VISIBILITY[visibility].capitalize()}**" + (", as in the paper." if visibility == "none" else "."),
                 table(titles, table_2_lines(here)), "\n".join(lines), picture_row(["10a", "10b", "10c"], here, False),
                 picture_row(["10d", "10e"], here), picture_row(["11a", "11b"], here)]
    return "\n\n".join(text)


def figure_12(folder):
    rows = where(read(folder, "gather"), part="figure_12")
    best = min(rows, key=lambda row: row["rmse"])
    return "\n\n".join([
        "### HVL, Fig. 12",
        f"Zonal HVL, VPL and VSGL at equal time in the glossy atrium. The least RMSE is that of {variant(best)}.",
        picture_row(["12a", "12b"], rows, False), picture_row(["12c"], rows)])


# ---- Evaluation ------------------------------------------------------------------------------------------------------

def evaluation(folder):
    rows = read(folder, "evaluation")
    lines = []
    for quantity, form in distinct(rows, "quantity", "form"):
        line = [f"{report_plots.QUANTITY[quantity]}: {report_plots.FORM_NAME[form]}"]
        for scalar in ("float", "double", "packet"):
            for bands in (5, 10):
                row = one(rows, quantity=quantity, form=form, scalar=scalar, bands=bands)
                line.append(f"{row['ns']:.2f} ns, {row['error']:.0e}")
        lines.append(line)
    titles = ["greatest error, time"] + [f"{scalar}, {bands}" for scalar in ("float", "double", "packet")
                                         for bands in (5, 10)]
    lanes = max(row["lanes"] for row in rows)
    gains = {quantity: one(rows, quantity=quantity, form=form, scalar="float", bands=5)["ns"] /
             one(rows, quantity=quantity, form=form, scalar="packet", bands=5)["ns"]
             for quantity, form in (("evaluation", "evaluate"), ("gradient", "gradient"), ("cap", "cap-stable"),
                                    ("rotation", "orient"))}
    worst = max(where(rows, quantity="cap", form="cap-legendre", scalar="float"), key=lambda row: row["error"])
    stable = max(where(rows, quantity="cap", form="cap-stable", scalar="float"), key=lambda row: row["error"])
    return "\n\n".join([
        "## Evaluation", figure("evaluation", "error and time of basis, gradient, cap and rotation"),
        "The greatest error, in units of the degree's largest value (of a cap: of its largest coefficient), over "
        "directions of which half are near a pole, and caps of which half are small, down to 1e-4 radians; ns per "
        "direction, cap or lobe on one thread. Numbers at points: bands. Filled: no other form or scalar is both faster "
        "and more accurate at this number of bands.",
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
              "trilinear, equal time", "Taylor, equal time", "error of gradients", "trilinear's, equal memory"]
    taylor = [one(rows, method="taylor", resolution=row["resolution"])["value_error"] / row["value_error"]
              for row in where(rows, method="trilinear") if one(rows, method="taylor", resolution=row["resolution"])]
    return "\n\n".join([
        "## Interpolation", figure("interpolation", "error of the interpolations by memory and time"),
        f"{rows[0]['bands']:.0f} bands of {rows[0]['lights']:.0f} sphere lights about a box, RGB: mean error at random "
        "places over the mean coefficient (or gradient). Trilinear interpolation needs values alone: its grid counts a "
        f"quarter of the memory, and is filled without gradients. The time is that of the grid and of {LOOKUPS} lookups, "
        "of coefficients without their gradients, on one thread.",
        f"Trilinear interpolation is better than Hermite's in equal memory at {listed(by_memory)}, in equal time at "
        f"{listed(by_time)}; elsewhere Hermite's is. At equal resolution, and four times the memory, Taylor's error is {min(taylor):.2f} to {max(taylor):.2f} "
        "of the trilinear one. The columns of factors say how many times Hermite's error the others have.",
        table(titles, lines)])


# ---- Triangles -------------------------------------------------------------------------------------------------------

def triangles_table(rows):
    bands = distinct(rows, "bands")
    lines = []
    for method, triangles, nodes in distinct(rows, "method", "triangles", "nodes"):
        if nodes > 7:
            continue
        same = [one(rows, method=method, triangles=triangles, nodes=nodes, bands=number) for number in bands]
        name = f"{triangles:.0f} spheres" if method == "spheres" else f"{nodes:.0f} node{'s' if nodes > 1 else ''} per edge"
        lines.append([name] + [text for row in same for text in (
            f"{row['ns']:.0f}", f"{row['value_error']:.1e}", f"{row['gradient_error']:.1e}")])
    titles = [title for number in bands for title in (f"{number:.0f} bands: ns", "error", "of gradients")]
    return table(["", *titles], lines)


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
        "A square light of radiance 1 over a plane: as two triangles, exactly but for the quadrature on their edges, and "
        "cut into many, each approximated by a sphere. Values and gradients in packets of receivers; greatest error over "
        "the greatest coefficient.",
        f"One colour: {listed(said)}. A light of as many colours as triangles would need all of them either way.",
        triangles_table(rows)])


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
    titles = ["material", "", "bands for 10 %", "for 5 %", *(f"{bands} bands" for bands in SHOWN_BANDS), "9, sinc",
              "9, Hann"]
    return table(titles, lines)


def window_text(rows):
    windowed = [row for row in rows if row["window"] != "none" and row["bands"] > 1]
    plain = {(row["material"], row["quantity"], row["bands"]): row["error"] for row in where(rows, window="none")}
    better = [row for row in windowed if row["error"] < plain[row["material"], row["quantity"], row["bands"]]]
    return (f"A window lowers this error in {len(better)} of {len(windowed)} cases: what it is for, ringing, is not what "
            "the mean square measures.")


def materials(folder):
    rows = read(folder, "materials")
    return "\n\n".join([
        "## Materials", figure("materials", "error of materials by bands and windows"),
        "What N bands of a BRDF miss: relative error in L2 over the hemisphere, mean over outgoing angles of 0, 30, 60 and "
        "75 degrees. The receiver's function holds the cosine (the figure, and the first table); the emitter's is without "
        "it, and its error is multiplied by it (the second table).", window_text(rows),
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


def main(command, folder):
    if command != "plot":
        sys.exit(__doc__)
    for draw in report_plots.ALL:
        draw(folder)
    write = {part: globals()[part] for part in PARTS}
    text = ["# Report", "Written by `scripts/report.sh`, whose parts can be run one by one; every figure and number comes "
            "from the CSV files beside it, by `scripts/report.py plot docs/report`.", machine(folder)]
    text += [write[part](folder) for part in PARTS if read(folder, part)]
    (pathlib.Path(folder) / "README.md").write_text("\n\n".join(text) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
