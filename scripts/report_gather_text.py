"""The part of docs/report on the gather: what the pictures' errors say, and HVL's tables and figures beside ours.

HVL: Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022.
"""
from report_data import METHOD, distinct, gather_ms, line_fit, one, pareto, read, variant, where
from report_plots import SCENE, VISIBILITY
from report_text import figure, listed, table


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
            lines.append(f"- {SCENE[scene]}, {VISIBILITY[visibility]}: on the front {listed(methods)}; the least "
                         f"error is {best['rmse']:.4f}, of {variant(best)}, {best['lights']:.0f} lights, "
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


def leak_text(rows):
    """What walls stop, and what it does to a method that loses energy."""
    said, worse = [], []
    for scene in distinct(rows, "scene"):
        for method in ("vpl", "vsgl", "vsgl-2024"):
            here = where(rows, scene=scene, method=method)
            here = where(here, vsgl_texels=max(distinct(here, "vsgl_texels")))
            lights = max(row["lights"] for row in where(here, visibility="centre"))
            same = [where(here, visibility=visibility, lights=lights)[0]["rmse"] for visibility in ("none", "centre")]
            said.append(f"{lights:.0f} {METHOD[method]} from {same[0]:.4f} to {same[1]:.4f} ({SCENE[scene]})")
            worse += [METHOD[method]] * (same[1] > same[0])
    text = ("Without visibility light leaks through walls. With that of the lights' centres, the RMSE goes: of "
            f"{listed(said)}.")
    if "VSGL" in worse and "VPL" not in worse:
        text += " VSGL get worse by it: they lose energy (Furnace), which had offset the leak."
        if "VSGL of 2024" not in worse:
            text += " Those of 2024 keep theirs, and get better."
    return text


def source_text(folder):
    source = one(read(folder, "scenes"), scene="measured")["materials"]
    if source.startswith("measured: "):
        return f"The measured materials are {source[len('measured: '):]} of the MERL database."
    return ("The third scene's materials are **not measured**: no files were at hand, and three were written from "
            "models, in the MERL format and at its resolution, and read as measured ones are.")


def gather(folder):
    sweep = where(read(folder, "gather"), part="sweep")
    return "\n\n".join([
        "## Gather", figure("gather", "error of pictures against the time of their virtual lights"),
        f"RMSE of the tone-mapped picture ({sweep[0]['width']:.0f} x {sweep[0]['height']:.0f}, one bounce, direct "
        "light included) against path tracing, by the time that virtual lights and gather take; the projection of "
        "materials, once per material, is not in it. Lines join numbers of lights. Filled: on the front.",
        reference_text(folder, sweep), source_text(folder), front_text(sweep), leak_text(sweep), band_text(sweep),
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
    titles = ["HVL"] + [f"{bands} bands, {whose}" for bands in (3, 5, 7, 9) for whose in ("paper", "zonal")]
    text = []
    for name, times in (("The paper's times", TABLE_1), ("zonal's", here)):
        in_lights, in_bands, fixed = growth(times)
        text.append(f"{name} are within {100 * in_lights:.0f} % of a line in the lights, which "
                    f"{'holds' if in_lights < 0.15 else 'fails'}, and within {100 * in_bands:.0f} % of one in the "
                    f"square of the bands, which {'holds' if in_bands < 0.15 else 'fails'}; {100 * fixed:.0f} % of "
                    "the time at 9 bands does not depend on them.")
    return "\n\n".join([
        "### HVL, Table 1: gather, ms",
        f"3 bands of emission. The paper: its teaser, on an RTX 2080. zonal: the glossy atrium, {rows[0]['width']:.0f} "
        f"x {rows[0]['height']:.0f}, on the processor; so it is the growth that compares, not the times. The paper "
        "calls the cost linear in the lights and quadratic in the bands.", table(titles, lines), " ".join(text)])


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
    for label, beside in (("10p", "in 10a's time"), ("11p", "in 11a's time")):
        row = one(rows, label=label)
        lines.append([f"path tracing, {beside}", f"{row['paths']:.0f} to a pixel", "", "", "", f"{gather_ms(row):.0f}",
                      "", f"{row['rmse']:.4f}", "", f"{row['psnr_db']:.2f}", "", f"{row['ssim']:.3f}"])
    return lines


# What may be said of a claim, by what came out; the numbers are put in. A rival of a few lights, or in another time, is
# none.
FEWEST_LIGHTS, MOST_APART = 16, 1.5


def outcome(hvl, rival, noise):
    """Whether the HVL's RMSE is the lower, as the paper says; decided only where the difference is larger than what the
    reference's own error adds to it."""
    if rival["lights"] < FEWEST_LIGHTS:
        return "no comparison: too few"
    if not 1 / MOST_APART <= gather_ms(rival) / gather_ms(hvl) <= MOST_APART:
        return "no comparison: times apart"
    added = hvl["rmse"] - max(hvl["rmse"] ** 2 - noise ** 2, 0) ** 0.5
    difference = rival["rmse"] - hvl["rmse"]
    return "not decided" if abs(difference) <= added else "holds" if difference > 0 else "fails"


SAID = {
    "holds": "{hvl} leave {hvl_rmse} where {rival} leave {rival_rmse}, in the same time.",
    "fails": "{rival} leave {rival_rmse}, less than the {hvl_rmse} of {hvl}. A ray to each light costs the same for both, "
             "and the HVL's blur weighs more where the leak through walls is gone.",
    "not decided": "{hvl} leave {hvl_rmse} and {rival} {rival_rmse}: no further apart than the reference's own error.",
    "no comparison: too few": "in the {hvl_ms} ms of {hvl} there is room for {rival} ({rival_ms} ms), with an RMSE of "
                              "{rival_rmse}.",
    "no comparison: times apart": "{hvl} take {hvl_ms} ms and {rival} {rival_ms} ms.",
}


def counted(row):
    more = [text for text in variant(row).split(", ")[1:]]
    return f"{row['lights']:.0f} {METHOD[row['method']]}" + (f" of {', '.join(more)}" if more else "")


def verdict(hvl, rival, noise):
    found = outcome(hvl, rival, noise)
    return f"**{found.split(':')[0]}**: " + SAID[found].format(
        hvl=counted(hvl), rival=counted(rival), hvl_rmse=f"{hvl['rmse']:.4f}", rival_rmse=f"{rival['rmse']:.4f}",
        hvl_ms=f"{gather_ms(hvl):.0f}", rival_ms=f"{gather_ms(rival):.0f}")


EQUAL_TIME = [("10a", "10c", "Fig. 10 a and c"), ("10a", "10e", "Fig. 10 a and e"), ("11a", "11b", "Fig. 11 a and b")]


def picture_row(labels, rows, reference=True):
    shown = [one(rows, label=label) for label in labels]
    titles = [", ".join(filter(None, [
        f"{row['label'][2:]}: {variant(row)}" if row["method"] != "path" else variant(row),
        f"{row['lights']:.0f} light{'s' * (row['lights'] > 1)}" if row["lights"] else "",
        f"{gather_ms(row):.0f} ms", f"RMSE {row['rmse']:.4f}"])) for row in shown]
    pictures = [f"![]({row['picture']})" for row in shown]
    if reference:
        titles, pictures = titles + ["the reference"], pictures + ["![](pictures/reference.png)"]
    rule = " --- ".join("|" * (len(titles) + 1))
    return "\n".join(["| " + " | ".join(titles) + " |", rule, "| " + " | ".join(pictures) + " |"])


def table_2(folder):
    rows = where(read(folder, "gather"), part="table_2")
    noise = one(read(folder, "references"), scene="glossy", width=rows[0]["width"])["rmse"]
    titles = ["method and figure", "setting", *(f"{what}, {whose}" for what in ("lights", "ms", "RMSE", "PSNR", "SSIM")
                                                for whose in ("paper", "zonal"))]
    text = ["### HVL, Table 2, and Fig. 10 and 11",
            f"The glossy atrium, {rows[0]['width']:.0f} x {rows[0]['height']:.0f}, for the paper's scenes and "
            "hardware: compare the rows of a column, not the two columns. 10a, 10b and 10d have equal counts; 10a, 10c "
            f"and 10e equal time, and so 11a and 11b. The reference's own RMSE is {noise:.4f}. The paper says that at "
            "equal time HVL have the lower RMSE."]
    for visibility in distinct(rows, "visibility"):
        here = where(rows, visibility=visibility)
        lines = [f"- {name}: {verdict(one(here, label=hvl), one(here, label=rival), noise)}"
                 for hvl, rival, name in EQUAL_TIME]
        text += [f"**{VISIBILITY[visibility].capitalize()}**" + (", as in the paper." if visibility == "none" else "."),
                 table(titles, table_2_lines(here)), "\n".join(lines), picture_row(["10a", "10b", "10c"], here, False),
                 picture_row(["10d", "10e", "10p"], here), picture_row(["11a", "11b", "11p"], here)]
    return "\n\n".join(text)


def figure_12(folder):
    rows = where(read(folder, "gather"), part="figure_12")
    best = min(rows, key=lambda row: row["rmse"])
    return "\n\n".join([
        "### HVL, Fig. 12",
        "Zonal HVL, VPL and VSGL of both kinds at equal time in the glossy atrium. The least RMSE is that of "
        f"{variant(best)}.", picture_row(["12a", "12b"], rows, False), picture_row(["12c", "12d"], rows)])
