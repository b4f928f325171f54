"""Every operation on every STEP file, each in a process of its own with limits, and tables of what came of it.

usage: run.py RESULTS KIND=FOLDER...      KIND is a word for the table; files are taken in the order of their names

Environment: ONLY, a regular expression for the files' names; OPERATIONS, one for the operations; LIMIT_SECONDS, of the processor
for one operation (default 120); LIMIT_MEGABYTES, of memory for one (default 4000); JOBS, operations at a time (default 1).
"""

import concurrent.futures
import json
import os
import pathlib
import re
import resource
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
SECONDS = int(os.environ.get("LIMIT_SECONDS", "120"))
MEGABYTES = int(os.environ.get("LIMIT_MEGABYTES", "4000"))
PROGRAMS = {
    "operations.py": ["valid", "smooth_faces", "analyser", "box_cut", "half_space_cut", "fillet", "offset", "thickness",
                      "tessellation"],
    "meshers.py": ["gmsh_surface", "gmsh_volume", "netgen_volume"],
}


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))
    resource.setrlimit(resource.RLIMIT_AS, (MEGABYTES << 20, MEGABYTES << 20))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(program, *words):
    """What a program answers, with the seconds of the processor that it took."""
    command = [sys.executable, HERE / program, *map(str, words)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, preexec_fn=limit,
                          start_new_session=True) as process:
        try:
            output = process.communicate(timeout=4 * SECONDS)[0]
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            output = process.communicate()[0]
    if output.strip():
        return json.loads(output)
    ending = {-24: f"more than {SECONDS} s", -9: f"more than {SECONDS} s"}.get(process.returncode)
    return {"ok": False, "note": ending or f"crash, status {process.returncode}"}


def row(kind, path, program, operation):
    """One line of the table: how often the operation was tried and done."""
    if operation != "fillet":
        answers = [run(program, operation, path)]
    else:
        found = run(program, "sharp", path)
        answers = [run(program, "fillet", path, edge) for edge in found["edges"]] if "edges" in found else [found]
    notes = sorted({answer["note"] for answer in answers if not answer["ok"]})
    return {"kind": kind, "model": path.stem, "operation": operation, "done": sum(answer["ok"] for answer in answers),
            "tried": len(answers), "note": "; ".join(notes)}


def summary(rows):
    """One line an operation: done of tried, for every kind."""
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    print("operation".ljust(16), *(kind.rjust(16) for kind in kinds))
    for operation in dict.fromkeys(row["operation"] for row in rows):
        cells = []
        for kind in kinds:
            group = [row for row in rows if row["kind"] == kind and row["operation"] == operation]
            cells.append(f"{sum(row['done'] for row in group)} of {sum(row['tried'] for row in group)}")
        print(operation.ljust(16), *(cell.rjust(16) for cell in cells))


def main():
    only, chosen = os.environ.get("ONLY", ""), os.environ.get("OPERATIONS", "")
    work = []
    for argument in sys.argv[2:]:
        kind, folder = argument.split("=", 1)
        for path in sorted(pathlib.Path(folder).glob("*.step")):
            if kind != "control" and not re.search(only, path.stem):
                continue
            work += [(kind, path, program, operation) for program, operations in PROGRAMS.items()
                     for operation in operations if re.search(chosen, operation)]
    print(f"{'kind':10} {'model':28} {'operation':16} {'done':>7}  note")
    rows = []
    with concurrent.futures.ThreadPoolExecutor(int(os.environ.get("JOBS", "1"))) as pool, \
            open(sys.argv[1], "w", encoding="utf-8") as results:
        for result in pool.map(lambda task: row(*task), work):
            rows.append(result)
            results.write(json.dumps(result) + "\n")
            count = f"{result['done']}/{result['tried']}"
            print(f"{result['kind']:10} {result['model']:28} {result['operation']:16} {count:>7}  {result['note']}", flush=True)
    print()
    summary(rows)


main()
