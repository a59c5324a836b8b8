#!/usr/bin/env python3
"""How well drawings of Quick, Draw! find the models of an index, class by class, as Markdown tables.

    quickdraw_report.py CROQUIS INDEX FOLDER [--map FILE.csv] [--every N] [--jobs N]

FOLDER holds CATEGORY.ndjson files, a drawing a line. A class of the index is looked for with the drawings of the category
of its name, or of the one that FILE.csv (columns shrec13_class and quickdraw_category) gives it; classes without one are
no queries, but their models are there to be found. --every N takes every Nth drawing of a category, the first included.
"""

import argparse
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

MEASURES = ["NN", "FT", "ST", "E", "DCG", "AP", "first_5", "first_10"]


def run(command):
    """Its one JSON object; what it says on standard error is passed on."""
    done = subprocess.run(command, stdout=subprocess.PIPE, check=False)
    if not done.stdout:
        sys.exit(f"{command[0]} ended with {done.returncode}")
    return json.loads(done.stdout)


def class_sizes(croquis, index):
    sizes = {}
    for model in run([croquis, "index", "list", "--db", index, "--json"])["models"]:
        sizes[model["class"]] = sizes.get(model["class"], 0) + 1
    return sizes


def categories(classes, map_file):
    if map_file is None:
        return {name: name for name in classes}
    with open(map_file, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {row["shrec13_class"]: row["quickdraw_category"] for row in rows if row["quickdraw_category"]}


def write_list(path, classes, category_of, folder, every):
    """One line a drawing; how many there are of each class."""
    drawings = {}
    with open(path, "w", encoding="utf-8") as out:
        for name in sorted(classes):
            file = folder / f"{category_of.get(name, '')}.ndjson"
            if not file.is_file():
                continue
            with open(file, encoding="utf-8") as lines:
                count = sum(1 for line in lines if line.strip())
            chosen = range(0, count, every)
            drawings[name] = len(chosen)
            out.writelines(f"{file}:{line}\t{name}\n" for line in chosen)
    return drawings


def print_rows(report):
    print("| | NN | FT | ST | E | DCG | AP | first 5 | first 10 |\n|---|---|---|---|---|---|---|---|---|")
    for name, metrics in report["rows"].items():
        print(f"| {name} | " + " | ".join(f"{metrics[m]:.3f}".lstrip("0") for m in MEASURES) + " |")


def print_classes(report, sizes, drawings, columns=3):
    """Per cent of drawings with a model of their class first and among the first ten, fused."""
    cells = []
    for name, rows in sorted(report["by_class"].items()):
        fused = rows["fused"]
        cells.append(f"{name} | {sizes[name]} | {drawings[name]} | {100 * fused['NN']:.0f} | {100 * fused['first_10']:.0f}")
    print("| " + " | | ".join(["class | models | drawings | NN | first 10"] * columns) + " |")
    print("|" + "---|" * (6 * columns - 1))
    height = -(-len(cells) // columns)
    for row in range(height):
        line = [cells[k] if k < len(cells) else " | | | | " for k in range(row, height * columns, height)]
        print("| " + " | | ".join(line) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("croquis")
    parser.add_argument("index")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--map")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    sizes = class_sizes(options.croquis, options.index)
    with tempfile.TemporaryDirectory() as folder:
        listed = f"{folder}/drawings.list"
        drawings = write_list(listed, sizes, categories(sizes, options.map), options.folder.resolve(), max(1, options.every))
        if not drawings:
            sys.exit("no class of the index has drawings in that folder")
        report = run([options.croquis, "eval", "sketches", listed, "--db", options.index, "--json", "--jobs",
                      str(options.jobs)])
    print(f"{report['queries']} drawings of {len(drawings)} classes, {report['models']} models\n")
    print_rows(report)
    print()
    print_classes(report, sizes, drawings)


if __name__ == "__main__":
    main()
