#!/usr/bin/env python3
"""Replays drawings through the kiosk and asks whether it found what `croquis query` finds for the same drawings.

    replay_equals_query.py CROQUIS INDEX FOLDER [--classes MAP.csv] [--count 200] [--seed 1] [--top 10] [--shots DIR]

FOLDER holds Quick-Draw files (one drawing a line). With --classes only the categories that the map names in its
column `quickdraw_category` are used. COUNT drawings are chosen by SEED among all lines of all these files and played
by one headless kiosk, one after the other; --shots also has it paint pictures of each. Then each is queried by a
process of its own, and the ids of the TOP best models, in their order, have to be the same. Prints what differs, and
the times of each stage. Exit code 0 when no replay failed and all rankings were equal.
"""

import argparse
import csv
import json
import math
import random
import subprocess
import sys
from pathlib import Path

STAGES = ("silhouette", "describe", "search")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("croquis")
    parser.add_argument("index")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--classes", type=Path)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--top", type=int, default=10, choices=range(1, 11), metavar="1..10")
    parser.add_argument("--shots")
    parser.add_argument("--size", help="of the pictures, WIDTHxHEIGHT")
    return parser.parse_args()


def choose_drawings(arguments):
    """FILE:LINE of the chosen drawings, in the order in which they are played."""
    files = sorted(arguments.folder.glob("*.ndjson"))
    if arguments.classes:
        with open(arguments.classes, newline="", encoding="utf-8") as text:
            wanted = {row["quickdraw_category"] for row in csv.DictReader(text)}
        files = [file for file in files if file.stem in wanted]
    drawings = []
    for file in files:
        with open(file, encoding="utf-8") as text:
            drawings += [f"{file}:{number}" for number, line in enumerate(text) if line.strip()]
    if len(drawings) < arguments.count:
        sys.exit(f"{arguments.folder}: {len(drawings)} drawings, fewer than the {arguments.count} asked for")
    return random.Random(arguments.seed).sample(drawings, arguments.count)


def replay(arguments, drawings):
    command = [arguments.croquis, "kiosk", "--headless", "--json", "--db", arguments.index]
    if arguments.shots:
        command += ["--shots", arguments.shots]
    if arguments.size:
        command += ["--size", arguments.size]
    for drawing in drawings:
        command += ["--replay", drawing]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if not done.stdout:
        sys.exit(f"the kiosk gave no report and ended with {done.returncode}")
    return json.loads(done.stdout)["replays"], done.returncode


def query(arguments, drawing):
    """The ids of the best models and the times; no ids and the reason where nothing could be searched for."""
    command = [arguments.croquis, "query", drawing, "--db", arguments.index, "--json", "--top", str(arguments.top)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return [], None, done.stderr.strip()
    answer = json.loads(done.stdout)
    return [result["id"] for result in answer["results"]], answer["ms"], ""


def share_below(values, share):
    """The smallest value that at least this share of the values does not exceed."""
    return sorted(values)[max(0, math.ceil(share * len(values)) - 1)]


def print_times(title, times):
    print(f"{title}, {len(times)} drawings, milliseconds:")
    for stage in STAGES:
        values = [ms[stage] for ms in times]
        median, p95 = share_below(values, 0.5), share_below(values, 0.95)
        print(f"  {stage:<10}  median {median:7.2f}   p95 {p95:7.2f}   max {max(values):7.2f}")


def main():
    arguments = parse_arguments()
    drawings = choose_drawings(arguments)
    replays, exit_code = replay(arguments, drawings)
    faults = failed = unsearchable = 0
    kiosk_times, query_times = [], []
    if [r["drawing"] for r in replays] != drawings:
        print(f"the kiosk reports {len(replays)} replays, not the {len(drawings)} given")
        faults += 1
    for played in replays:
        failed += played["failure"] != ""
        if played["failure"]:
            print(f"{played['drawing']}: {played['failure']}")
        ids, ms, why = query(arguments, played["drawing"])
        if played["ids"][: arguments.top] != ids:
            faults += 1
            print(f"{played['drawing']}: the kiosk found {played['ids'][: arguments.top]}, the query {ids} {why}")
        if not ids:
            unsearchable += 1
            continue
        if played["ids"]:
            kiosk_times.append(played["ms"])
        query_times.append(ms)
    if kiosk_times:
        print_times("kiosk, last search of each replay", kiosk_times)
    if query_times:
        print_times("query", query_times)
    searches = sum(played["searches"] for played in replays)
    print(f"{len(replays)} drawings replayed, {searches} searches: {failed} failed, {faults} differ from the query, "
          f"{unsearchable} with nothing to search for")
    sys.exit(0 if failed == 0 and faults == 0 and exit_code == 0 else 1)


if __name__ == "__main__":
    main()
