"""Renders what docs/report needs by hvl-render, and writes references.csv, gather.csv, scenes.csv and pictures; see
report.sh.

    report_gather.py HVL_RENDER ZONAL_REPORT_DATA FOLDER [--quick|--full]
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile

from report_render import reported, write

FIELDS = ["part", "label", "scene", "width", "height", "visibility", "method", "lights", "bands", "emission_bands",
          "vsl_samples", "vsgl_texels", "vpl_clamp", "paths", "material_s", "lights_s", "gather_s", "rmse", "psnr_db", "ssim",
          "linear_rmse", "picture"]

# `repeats`: of the runs of the tables, whose times are medians. `measured`: the most lights there. VPL and VSL look such
# a BRDF up for every light, and its zonal projection takes a minute. `variants`: methods, and what makes them what they
# are.
SHORT = {
    "repeats": 3, "size": (128, 104), "paths": 512, "big_size": (256, 208), "big_paths": 256,
    "lights": {"none": [64, 256, 1024], "centre": [64, 256]}, "most_points": 4096,
    "measured": {"vpl": 256, "vsl": 256, "hvl-zonal": 0},
    "variants": {
        "none": [("vpl", {}), ("vpl", {"vpl_clamp": 1}), ("vsl", {"vsl_samples": 4}), ("vsl", {"vsl_samples": 16}),
                 ("vsgl", {"vsgl_texels": 4}), ("vsgl-2024", {"vsgl_texels": 1}), ("vsgl-2024", {"vsgl_texels": 4}),
                 ("hvl", {"bands": 3}), ("hvl", {"bands": 5}), ("hvl", {"bands": 9}), ("hvl-zonal", {"bands": 15})],
        "centre": [("vpl", {}), ("vpl", {"vpl_clamp": 1}), ("vsl", {"vsl_samples": 16}), ("vsgl", {"vsgl_texels": 1}),
                   ("vsgl", {"vsgl_texels": 4}), ("vsgl-2024", {"vsgl_texels": 1}), ("vsgl-2024", {"vsgl_texels": 4}),
                   ("hvl", {"bands": 3}), ("hvl", {"bands": 9}), ("hvl-zonal", {"bands": 15})]},
}
EVERY_VARIANT = [("vpl", {}), ("vpl", {"vpl_clamp": 1}), ("vsl", {"vsl_samples": 4}), ("vsl", {"vsl_samples": 16}),
                 ("vsl", {"vsl_samples": 64}), ("vsgl", {"vsgl_texels": 1}), ("vsgl", {"vsgl_texels": 4}),
                 ("vsgl", {"vsgl_texels": 8}), ("vsgl-2024", {"vsgl_texels": 1}), ("vsgl-2024", {"vsgl_texels": 4}),
                 ("vsgl-2024", {"vsgl_texels": 8}), ("hvl", {"bands": 3}), ("hvl", {"bands": 5}), ("hvl", {"bands": 7}),
                 ("hvl", {"bands": 9}), ("hvl", {"bands": 5, "emission_bands": 5}), ("hvl-zonal", {"bands": 5}),
                 ("hvl-zonal", {"bands": 9}), ("hvl-zonal", {"bands": 15})]
FULL = {
    "repeats": 5, "size": (320, 256), "paths": 1024, "big_size": (1280, 1024), "big_paths": 512,
    "lights": {"none": [64, 144, 256, 576, 1024, 2304, 4096], "centre": [64, 256, 1024]}, "most_points": 16384, "measured": {},
    "variants": {"none": EVERY_VARIANT, "centre": EVERY_VARIANT},
}


QUICK = {  # shows that all is there
    "repeats": 1, "size": (32, 26), "paths": 4, "big_size": (40, 32), "big_paths": 4,
    "lights": {"none": [16], "centre": [16]}, "most_points": 64, "measured": {},
    "variants": dict.fromkeys(
        ("none", "centre"), [("vpl", {}), ("vsgl", {}), ("vsgl-2024", {}), ("hvl", {"bands": 3}), ("hvl", {"bands": 9})]),
}


def measured_files(report_data, folder):
    """Three files of the MERL database, or of models in its format; and which of the two."""
    data = pathlib.Path(os.environ.get("ZONAL_DATA", "")) / "merl"
    files = sorted(data.glob("*.binary")) if "ZONAL_DATA" in os.environ else []
    if len(files) >= 3:
        return files[:3], "measured: " + " ".join(file.stem for file in files[:3])
    subprocess.run([report_data, "merl", folder], check=True)
    return [pathlib.Path(folder) / f"{name}.binary" for name in ("gold", "lacquer", "stone")], "written from models"


def scenes(files):
    """Arguments by name. The atrium has these materials; the third file is that of its floor."""
    metal, lacquer, stone = files
    given = {"gold": metal, "red plastic": lacquer, "porcelain": lacquer, "light tile": stone, "dark tile": stone}
    measured = [text for name, file in given.items() for text in ("--material", f"{name}={file}")]
    return {"diffuse": ["--scene", "atrium-diffuse"], "glossy": ["--scene", "atrium-glossy"],
            "measured": ["--scene", "atrium", *measured]}


def errors_of(facts):
    errors = facts["errors"]
    return {"rmse": errors["rmse"], "psnr_db": errors["psnr_db"], "ssim": errors["ssim"],
            "linear_rmse": errors["linear_rmse_relative_to_mean"]}


class Renderer:
    def __init__(self, program, report_data, folder, scratch, repeats):
        self.repeats = repeats
        self.program, self.folder, self.scratch = program, pathlib.Path(folder), pathlib.Path(scratch)
        files, self.source = measured_files(report_data, scratch)
        self.scenes = scenes(files)
        (self.folder / "pictures").mkdir(parents=True, exist_ok=True)

    def run(self, scene, size, method, **options):
        """hvl-render's JSON."""
        command = [self.program, "--quiet", "--antialias", "1", "--size", f"{size[0]}x{size[1]}", *self.scenes[scene],
                   "--method", method]
        if method == "hvl":
            command += ["--material-cache", self.scratch]
        for name, value in options.items():
            command += ["--" + name.replace("_", "-"), value]
        return reported(self.scratch, *command)

    def reference(self, scene, size, paths, picture="second.exr"):
        """Renders it twice, with different seeds: the difference is the error of either, times the root of 2."""
        facts = {}
        for seed in (1, 2):
            compare = {"reference": self.reference_file(scene, size)} if seed == 2 else {}
            out = self.reference_file(scene, size) if seed == 1 else self.scratch / picture
            facts = self.run(scene, size, "path", bounces=1, spp=paths, seed=seed, out=out, **compare)
        errors = facts["errors"]
        noise = {name: errors[key] / 2 ** 0.5 for name, key in (("rmse", "rmse"),
                                                                ("linear_rmse", "linear_rmse_relative_to_mean"))}
        return {"scene": scene, "width": size[0], "height": size[1],
                "paths_per_pixel": facts["counts"]["paths_per_pixel"], "paths_s": facts["seconds"]["paths"], **noise}

    def reference_file(self, scene, size):
        return self.scratch / f"{scene}_{size[0]}.exr"

    def render(self, scene, size, method, picture, **options):
        """hvl-render's JSON of a picture, compared with the reference."""
        out = self.folder / picture if picture else self.scratch / "picture.png"
        return self.run(scene, size, method, out=out, reference=self.reference_file(scene, size), **options)

    def row(self, part, label, scene, size, method, picture="", **options):
        facts = self.render(scene, size, method, picture, **options)
        seconds, used = facts["seconds"], facts["options"]
        count = facts["counts"]["virtual_lights"]
        mine = {"hvl": ["bands", "emission_bands"], "hvl-zonal": ["bands"], "vsl": ["vsl_samples"],
                "vsgl": ["vsgl_texels"], "vsgl-2024": ["vsgl_texels"], "vpl": ["vpl_clamp"]}.get(method, [])
        return {"part": part, "label": label, "scene": scene, "width": size[0], "height": size[1],
                "visibility": used["visibility"], "method": method,
                "lights": count // used["vsgl_texels"] ** 2 if "vsgl_texels" in mine else count,
                **{name: used[name] for name in mine},
                "material_s": seconds.get("material projection", 0), "lights_s": seconds["virtual lights"],
                "gather_s": seconds["gather"], **errors_of(facts), "picture": picture}

    def paths_row(self, part, label, scene, size, visibility, seconds, picture):
        """Path tracing, of one bounce like all others, by as many paths a pixel as the time allows, at least one. Its
        random numbers are none of the reference's."""
        def trace(paths):
            return self.render(scene, size, "path", picture, bounces=1, spp=paths, seed=3)
        once = trace(4)
        facts = trace(max(1, round(4 * seconds / once["seconds"]["paths"])))
        return {"part": part, "label": label, "scene": scene, "width": size[0], "height": size[1],
                "visibility": visibility, "method": "path", "lights": 0, "paths": facts["counts"]["paths_per_pixel"],
                "material_s": 0, "lights_s": 0, "gather_s": facts["seconds"]["paths"], **errors_of(facts),
                "picture": picture}

    def median_row(self, *arguments, **options):
        rows = [self.row(*arguments, **options) for _ in range(self.repeats)]
        return sorted(rows, key=lambda row: row["gather_s"])[self.repeats // 2]


def light_counts(plan, scene, visibility, method):
    counts = plan["lights"][visibility]
    if method == "vpl" and visibility == "none":
        counts = counts + [plan["most_points"]]
    most = plan["measured"].get(method, math.inf) if scene == "measured" else math.inf
    return [count for count in counts if count <= most]


def sweep(renderer, plan):
    for scene in renderer.scenes:
        for visibility, variants in plan["variants"].items():
            for method, options in variants:
                for lights in light_counts(plan, scene, visibility, method):
                    yield renderer.row("sweep", "", scene, plan["size"], method, visibility=visibility, lights=lights,
                                       **options)


def table_1(renderer, plan):
    for lights in (64, 196, 400):
        for bands in (3, 5, 7, 9):
            yield renderer.median_row("table_1", "", "glossy", plan["big_size"], "hvl", lights=lights, bands=bands)


def seconds_of(row):
    return row["lights_s"] + row["gather_s"]


def table_2(renderer, plan, visibility):
    """Rows of Table 2, and their pictures for Fig. 10 and 11. Equal time is that of the HVL of each figure."""
    def render(label, method, **options):
        picture = f"pictures/figure_{label}_{visibility}.png"
        return renderer.median_row("table_2", label, "glossy", plan["big_size"], method, picture,
                                   visibility=visibility, **options)

    def trace(label, hvl):  # it sees what stands between, whatever the lights do
        return renderer.paths_row("table_2", label, "glossy", plan["big_size"], visibility, seconds_of(hvl),
                                  f"pictures/figure_{label}_{visibility}.png")

    hvl_10 = render("10a", "hvl", lights=400, bands=5)
    yield hvl_10
    yield render("10b", "vpl", lights=400)
    yield render("10c", "vpl", time_budget=seconds_of(hvl_10))
    yield render("10d", "vsl", lights=400, vsl_samples=25)
    yield render("10e", "vsl", time_budget=seconds_of(hvl_10), vsl_samples=9)
    yield trace("10p", hvl_10)
    hvl_11 = render("11a", "hvl", lights=1500, bands=9)
    yield hvl_11
    yield render("11b", "vpl", time_budget=seconds_of(hvl_11))
    yield trace("11p", hvl_11)


def figure_12(renderer, plan):
    """At equal time, that of 400 zonal HVL of 15 bands."""
    def render(label, method, **options):
        return renderer.median_row("figure_12", label, "glossy", plan["big_size"], method,
                                   f"pictures/figure_{label}.png", **options)

    zonal = render("12a", "hvl-zonal", lights=400, bands=15)
    yield zonal
    yield render("12b", "vpl", time_budget=seconds_of(zonal))
    yield render("12c", "vsgl", time_budget=seconds_of(zonal), vsgl_texels=14)
    yield render("12d", "vsgl-2024", time_budget=seconds_of(zonal), vsgl_texels=14)


def main(program, report_data, folder, *options):
    plan = {"--quick": QUICK, "--full": FULL}[options[0]] if options else SHORT
    folder = pathlib.Path(folder)
    with tempfile.TemporaryDirectory() as scratch:
        renderer = Renderer(program, report_data, folder, scratch, plan["repeats"])
        write(folder / "scenes.csv", ["scene", "materials"],
              [{"scene": scene, "materials": renderer.source if scene == "measured" else "models"}
               for scene in renderer.scenes])
        references = [renderer.reference(scene, plan["size"], plan["paths"]) for scene in renderer.scenes]
        references.append(renderer.reference("glossy", plan["big_size"], plan["big_paths"],
                                             folder.absolute() / "pictures/reference.png"))
        write(folder / "references.csv", list(references[0]), references)

        def rows():
            yield from sweep(renderer, plan)
            yield from table_1(renderer, plan)
            for visibility in ("none", "centre"):
                yield from table_2(renderer, plan, visibility)
            yield from figure_12(renderer, plan)
        write(folder / "gather.csv", FIELDS, rows())


if __name__ == "__main__":
    main(*sys.argv[1:])
