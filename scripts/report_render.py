"""What the parts of docs/report share that run programs: their JSON, CSV files, and pictures beside each other."""
import csv
import json
import os
import pathlib
import subprocess

from PIL import Image


def reported(scratch, *command):
    """The JSON that a program writes of its run."""
    report = pathlib.Path(scratch) / "report.json"
    subprocess.run([*map(str, command), "--report", str(report)], check=True)
    return json.loads(report.read_text(encoding="utf-8"))


def write(path, fields, rows):
    """Row by row, under another name until it is whole."""
    unfinished = path.with_suffix(".tmp")
    with open(unfinished, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, fields, restval="", lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()})
            file.flush()
    os.replace(unfinished, path)


def joined(pictures, across=True, gap=4):
    """Beside each other, or below."""
    widths, heights = zip(*(picture.size for picture in pictures))
    gaps = gap * (len(pictures) - 1)
    size = (sum(widths) + gaps, max(heights)) if across else (max(widths), sum(heights) + gaps)
    whole, at = Image.new("RGB", size, "white"), 0
    for picture in pictures:
        whole.paste(picture, (at, 0) if across else (0, at))
        at += picture.size[0 if across else 1] + gap
    return whole
