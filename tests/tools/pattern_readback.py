#!/usr/bin/python3
"""Reads the files of a pattern with other readers and compares them with seams.json, point by point.

    pattern_readback.py FOLDER       a folder that `croquis garment pattern` wrote

DXF by ezdxf: cut and sew lines of every block. SVG and PDF by their paths, in millimetres: the test square's sides and
every cut line, wherever the sheet has it. PDF pages are put together again by their crosses' grid: each stretch of a
cut line must be on some page. Exit code 1 when anything is off by more than 0.1 mm; 77 when ezdxf is missing.
"""
import json
import math
import re
import sys
import xml.etree.ElementTree
import zlib

try:
    import ezdxf
except ImportError:
    print("ezdxf is missing: apt install python3-ezdxf")
    sys.exit(77)

LIMIT_MM = 0.1


def apart(a, b):
    return max(math.dist(p, q) for p, q in zip(a, b)) if len(a) == len(b) else math.inf


def from_first(points):
    return [(x - points[0][0], y - points[0][1]) for x, y in points]


def check_dxf(folder, pattern):
    document = ezdxf.readfile(f"{folder}/pattern.dxf")
    inserts = list(document.modelspace().query("INSERT"))
    assert len(inserts) == len(pattern["pieces"]), "one insert a piece"
    worst = 0.0
    for insert, piece in zip(inserts, pattern["pieces"]):
        lines = {}
        for line in document.blocks[insert.dxf.name].query("POLYLINE"):
            lines.setdefault(line.dxf.layer, []).append([tuple(p)[:2] for p in line.points()])
        worst = max(worst, apart(lines["1"][0], piece["cut_line"]))
        assert len(lines["14"]) == len(piece["sides"])
        for line, side in zip(lines["14"], piece["sides"]):
            worst = max(worst, apart(line, side["points"]))
    return worst


def check_svg(folder, pattern):
    root = xml.etree.ElementTree.parse(f"{folder}/pattern.svg").getroot()
    view = [float(v) for v in root.get("viewBox").split()]
    scale = float(root.get("width").removesuffix("mm")) / view[2]
    cuts, frames = [], []
    for path in root.iter("{http://www.w3.org/2000/svg}path"):
        points = [(float(x) * scale, -float(y) * scale) for x, y in re.findall(r"(-?[\d.]+),(-?[\d.]+)", path.get("d"))]
        {"cut": cuts, "frame": frames}.get(path.get("class"), []).append(points)
    worst = max(abs(math.dist(frames[0][i], frames[0][i + 1]) - 100.0) for i in range(3))
    for points, piece in zip(cuts, pattern["pieces"], strict=True):
        worst = max(worst, apart(from_first(points), from_first(piece["cut_line"])))
    return worst, cuts


def pdf_paths(bytes_of_file):
    """For each page with drawing: its subpaths in mm, y down from the page's upper edge, and the page's height."""
    height = float(re.search(rb"/MediaBox \[ ?0 0 [\d.]+ ([\d.]+)", bytes_of_file).group(1))
    for match in re.finditer(rb"/Filter /FlateDecode\s*>>\s*stream\r?\n", bytes_of_file):
        try:
            text = zlib.decompressobj().decompress(bytes_of_file[match.end():]).decode("latin-1")
        except zlib.error:
            continue
        if " re W" not in text and " m" not in text:
            continue
        matrix, stack, paths, numbers = (1, 0, 0, 1, 0, 0), [], [], []
        for word in text.split():
            if re.fullmatch(r"-?[\d.]+", word):
                numbers.append(float(word))
                continue
            if word == "q":
                stack.append(matrix)
            elif word == "Q":
                matrix = stack.pop()
            elif word == "cm":
                a, b, c, d, e, f = numbers[-6:]
                A, B, C, D, E, F = matrix
                matrix = (a * A + b * C, a * B + b * D, c * A + d * C, c * B + d * D, e * A + f * C + E, e * B + f * D + F)
            elif word in ("m", "l"):
                x, y = numbers[-2:]
                A, B, C, D, E, F = matrix
                point = ((x * A + y * C + E) * 25.4 / 72, (height - (x * B + y * D + F)) * 25.4 / 72)
                if word == "m":
                    paths.append([])
                paths[-1].append(point)
            numbers = []
        if paths:
            yield paths


def off_line(point, ring):
    """Distance of a point from a closed line."""
    least = math.inf
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        dx, dy = bx - ax, by - ay
        size = dx * dx + dy * dy
        t = 0.0 if size == 0 else max(0.0, min(1.0, ((point[0] - ax) * dx + (point[1] - ay) * dy) / size))
        least = min(least, math.hypot(ax + t * dx - point[0], ay + t * dy - point[1]))
    return least


def check_pdf(folder, name, size, cuts):
    """Cairo keeps a path whole on each page that it comes near to, and joins points in a row: every point of the longest
    path of a page must lie on one cut line of the sheet, the page being moved by whole steps."""
    data = open(f"{folder}/pattern-{name}.pdf", "rb").read()
    box = [float(v) for v in re.search(rb"/MediaBox \[ ?0 0 ([\d.]+) ([\d.]+)", data).groups()]
    worst = max(abs(box[0] * 25.4 / 72 - size[0]), abs(box[1] * 25.4 / 72 - size[1]))
    rings = [[(x, -y) for x, y in cut] for cut in cuts]
    width, height = (max(p[k] for ring in rings for p in ring) for k in (0, 1))
    step_x, step_y = size[0] - 30.0, size[1] - 30.0
    met, pages = set(), 0
    for paths in pdf_paths(data):
        for path in sorted((p for p in paths if len(p) > 12), key=len)[-len(cuts):]:
            best = (math.inf, None)
            for row in range(int(height / step_y) + 1):
                for column in range(int(width / step_x) + 1):
                    moved = [(x - 10 + column * step_x, y - 10 + row * step_y) for x, y in path]
                    for k, ring in enumerate(rings):
                        if best[0] < LIMIT_MM or off_line(moved[0], ring) > LIMIT_MM or off_line(moved[5], ring) > LIMIT_MM:
                            continue
                        best = min(best, (max(off_line(p, ring) for p in moved), k))
            if best[1] is None:
                continue  # a sew line
            worst = max(worst, best[0])
            met.add(best[1])
        pages += 1
    assert met == set(range(len(cuts))), f"{name}: cut lines of pieces {set(range(len(cuts))) - met} are on no page"
    return worst, pages


def main():
    folder = sys.argv[1]
    with open(f"{folder}/seams.json") as file:
        pattern = json.load(file)
    figures = {"dxf": check_dxf(folder, pattern)}
    figures["svg"], cuts = check_svg(folder, pattern)
    for name, size in {"a4": (210, 297), "a3": (297, 420), "letter": (215.9, 279.4)}.items():
        figures[name], pages = check_pdf(folder, name, size, cuts)
        print(f"{name}: {pages} pages")
    for name, worst in figures.items():
        print(f"{name}: within {worst:.4f} mm")
    mismatch = max((seam["mismatch"] for seam in pattern["seams"]), default=0.0)
    print(f"{len(pattern['pieces'])} pieces, {len(pattern['seams'])} seams, mismatch up to {100 * mismatch:.3f} %")
    return 0 if max(figures.values()) <= LIMIT_MM else 1


if __name__ == "__main__":
    sys.exit(main())
