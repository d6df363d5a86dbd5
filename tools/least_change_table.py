#!/usr/bin/env python3
"""How little `flatten` changes for limits, and what it reaches within tolerances: tables of docs/notebook/least_change.md.

  least_change_table.py limits PLANISH OTHER FOLDER [NAME...]
  least_change_table.py tolerances PLANISH FOLDER [NAME...]

Lines for the OBJ patches of the folder of at most 30,000 vertices, or for those whose names begin with NAME.

limits: what two builds move, rms in % of the diagonal, for each of three limits; the sharpest new fold in degrees and the
processor time of both. Then, of the patches that OTHER moves, medians and the largest share of its move.

tolerances: for 0.2 and 1 % of the diagonal the rms strain that is left, in %, beside the least of ten runs of
`evolve --method auto --max-rms-strain L` that stay within the tolerance, new folds of 5 degrees and 0.05 of added
bending, the design among them; L goes in even shares from the strain of the design to 0.1 %.
"""
import json, math, os, resource, statistics, subprocess, sys, tempfile

MOST_VERTICES = 30_000
LIMITS = (("--max-strain", "2%@p99"), ("--max-rms-strain", "1%"), ("--material", "cotton"))
TOLERANCES = (0.002, 0.01)
MOST_FOLD, MOST_ADDED = 5.0, 0.05
RUNS, LEAST = 10, 0.001
MOVED = 1e-9


def lines_of(path, first):
    with open(path, encoding="utf-8") as file:
        return [line.split() for line in file if line.startswith(first)]


def diagonal_of(path):
    places = [[float(x) for x in line[1:4]] for line in lines_of(path, "v ")]
    return math.dist([min(axis) for axis in zip(*places)], [max(axis) for axis in zip(*places)])


def run(command):
    begin = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run([*command, "--json"], capture_output=True, text=True)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begin
    return (json.loads(done.stdout) if done.returncode in (0, 3) else None), seconds


def fold_of(evolve):
    return (evolve.get("sharpest_fold") or {"degrees": 0.0})["degrees"]


def flattened(program, path, flags):
    with tempfile.TemporaryDirectory() as folder:
        report, seconds = run([program, "flatten", path, "-o", folder, *flags])
    if report is None:
        return None
    evolve = report["evolve"]
    return {"moved": 100 * evolve["deviation"]["rms_over_diagonal"], "fold": fold_of(evolve), "seconds": seconds,
            "most": evolve["deviation"]["max"], "added": evolve["bending_added"] or 0.0, "stop": evolve["stop"],
            "kept": all(limit["kept"] for limit in report["limits"]), "strain": 100 * report["unfold"]["strain"]["rms"]}


def evolved(program, path, limit):
    with tempfile.TemporaryDirectory() as folder:
        surface = os.path.join(folder, "evolved.obj")
        report, _ = run([program, "evolve", path, "-o", surface, "--method", "auto", "--max-rms-strain", repr(limit)])
        pattern, _ = run([program, "unfold", surface, "-o", os.path.join(folder, "flat.svg"), "--least-stretch"])
    if report is None or pattern is None:
        return None
    return {"strain": 100 * pattern["strain"]["rms"], "most": report["deviation"]["max"], "fold": fold_of(report),
            "added": report["bending_added"] or 0.0}


def print_limits(program, other, paths):
    print("| patch | limit | moved, % | other | share | fold | other | kept | time, s | other |\n"
          "|---|---|---|---|---|---|---|---|---|---|")
    shares, times = {}, []
    for name, path in paths:
        for limit in LIMITS:
            new, old = flattened(program, path, limit), flattened(other, path, limit)
            if new is None or old is None:
                continue
            share = new["moved"] / old["moved"] if old["moved"] > MOVED else None
            if share is not None and old["kept"]:
                shares.setdefault(" ".join(limit), []).append(share)
                times.append(new["seconds"] / old["seconds"])
            print(f"| {name} | {limit[1]} | {new['moved']:.3f} | {old['moved']:.3f} | "
                  f"{'-' if share is None else f'{share:.2f}'} | {new['fold']:.1f} | {old['fold']:.1f} | "
                  f"{'yes' if new['kept'] else 'no'}{'' if new['kept'] == old['kept'] else ' (other not)'} | "
                  f"{new['seconds']:.1f} | {old['seconds']:.1f} |", flush=True)
    for limit, values in shares.items():
        print(f"\n{limit}: of {len(values)} that the other moves, {statistics.median(values):.2f} of its move in the median, "
              f"at most {max(values):.2f}", flush=True)
    if times:
        print(f"\ntime: {statistics.median(times):.1f} times in the median, at most {max(times):.1f}")


def is_within(result, tolerance):
    return result["most"] <= tolerance * (1 + 1e-9) and result["fold"] <= MOST_FOLD and result["added"] <= MOST_ADDED


def print_tolerances(program, paths):
    print("| patch | tolerance, % | left, % | best of ten | share | used | fold | added | time, s | stop |\n"
          "|---|---|---|---|---|---|---|---|---|---|")
    within, shares = [], []
    for name, path in paths:
        design = flattened(program, path, ("--max-deviation", "0", "--least-stretch"))
        if design is None:
            continue
        first = design["strain"] / 100
        limits = [first + (LEAST - first) * k / RUNS for k in range(1, RUNS + 1)] if first > LEAST else []
        others = [design, *filter(None, (evolved(program, path, limit) for limit in limits))]
        for tolerance in TOLERANCES:
            distance = tolerance * diagonal_of(path)
            found = flattened(program, path, ("--max-deviation", repr(distance)))
            best = min(other["strain"] for other in others if is_within(other, distance))
            within.append(is_within(found, distance))
            shares.append(found["strain"] / best if best > 0 else 1.0)
            print(f"| {name} | {100 * tolerance:g} | {found['strain']:.3f} | {best:.3f} | {shares[-1]:.2f} | "
                  f"{found['most'] / distance:.2f} | {found['fold']:.1f} | {found['added']:.3f} | {found['seconds']:.1f} | "
                  f"{found['stop']} |", flush=True)
    print(f"\nwithin the tolerance and smooth: {sum(within)} of {len(within)}; strain over the best of ten "
          f"{statistics.median(shares):.2f} in the median, at most {max(shares):.2f}")


def patches_of(folder, names):
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if name.endswith(".obj") and (not names or name.startswith(tuple(names))) \
                and len(lines_of(path, "v ")) <= MOST_VERTICES:
            yield os.path.splitext(name)[0], path


def main():
    arguments = sys.argv[1:]
    if arguments[:1] == ["limits"] and len(arguments) >= 4:
        print_limits(*arguments[1:3], patches_of(arguments[3], arguments[4:]))
    elif arguments[:1] == ["tolerances"] and len(arguments) >= 3:
        print_tolerances(arguments[1], patches_of(arguments[2], arguments[3:]))
    else:
        print(__doc__)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
