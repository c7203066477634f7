"""Renders the atrium by hvl-render --tolerance for docs/report, against the number of lights and the tolerance, and writes
many_lights.csv; see report.sh.

    report_many_lights.py HVL_RENDER REPORT_DATA FOLDER [--quick|--full]
"""
import pathlib
import sys
import tempfile

from report_gather import measured_files, scenes
from report_render import reported, write

FIELDS = ["part", "scene", "lights", "tolerance", "tree_s", "gather_s", "lights_per_hit", "proved", "measured", "checked",
          "planned_bytes", "full_bytes", "full_s"]

SHORT = {"size": (1280, 720), "lights": (100, 1024, 10000, 99856, 1000000), "most_lights": 3162 ** 2,
         "tolerance_size": (640, 360), "tolerances": (0.1, 0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001), "few": (400, 99856),
         "scenes": ("diffuse", "glossy", "measured"), "checked": 2000, "checked_of_most": 100}
FULL = {**SHORT, "tolerance_size": (1280, 720)}
QUICK = {"size": (48, 40), "lights": (16, 400), "most_lights": 1024, "tolerance_size": (48, 40),
         "tolerances": (0.1, 0.01), "few": (400,), "scenes": ("diffuse",), "checked": 500, "checked_of_most": 100}  # shows that all is there


class Renderer:
    def __init__(self, program, arguments, scratch):
        self.program, self.arguments, self.scratch = program, arguments, scratch

    def run(self, scene, size, lights, tolerance, *more):
        return reported(self.scratch, self.program, "--quiet", "--antialias", 1, "--size", f"{size[0]}x{size[1]}",
                        *self.arguments[scene], "--material-cache", self.scratch, "--lights", lights, "--out",
                        pathlib.Path(self.scratch) / "picture.png", *(["--tolerance", tolerance] if tolerance else []), *more)

    def row(self, part, scene, size, lights, tolerance, checked):
        """Times of a run that checks nothing, errors of one that does."""
        facts = self.run(scene, size, lights, tolerance)
        plan = self.run(scene, size, lights, tolerance, "--check", min(1.0, checked / (size[0] * size[1])))["plan"]
        times = facts["seconds"]
        return {"part": part, "scene": scene, "lights": facts["counts"]["virtual_lights"], "tolerance": tolerance,
                "tree_s": times["virtual lights"], "gather_s": times["gather"], "lights_per_hit": plan["lights_per_hit"],
                "proved": plan["proved_error"], "measured": plan["measured_error"], "checked": plan["checked_hits"],
                "planned_bytes": plan["light_bytes"]["planned"], "full_bytes": plan["light_bytes"]["full"],
                "full_s": plan["full_gather_seconds"]}


def rows(renderer, settings):
    for scene in renderer.arguments:
        for lights in settings["lights"]:
            yield renderer.row("lights", scene, settings["size"], lights, 0.01, settings["checked"])
    # A check of the most lights takes longer than all else: one scene's, by few hits.
    yield renderer.row("lights", "diffuse", settings["size"], settings["most_lights"], 0.01, settings["checked_of_most"])
    for scene in renderer.arguments:
        for lights in settings["few"]:
            for tolerance in settings["tolerances"]:
                yield renderer.row("tolerance", scene, settings["tolerance_size"], lights, tolerance,
                                   settings["checked"])
            facts = renderer.run(scene, settings["tolerance_size"], lights, 0) if lights <= 1000 else None
            if facts:
                yield {"part": "full", "scene": scene, "lights": lights, "tolerance": 0,
                       "tree_s": facts["seconds"]["virtual lights"], "gather_s": facts["seconds"]["gather"]}


def main(program, report_data, folder, *mode):
    settings = {"--quick": QUICK, "--full": FULL}.get(mode[0] if mode else "", SHORT)
    with tempfile.TemporaryDirectory() as scratch:
        files, _ = measured_files(report_data, scratch)
        arguments = {scene: scenes(files)[scene] for scene in settings["scenes"]}
        renderer = Renderer(program, arguments, scratch)
        write(pathlib.Path(folder) / "many_lights.csv", FIELDS, rows(renderer, settings))


if __name__ == "__main__":
    main(*sys.argv[1:])
