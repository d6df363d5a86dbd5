#!/usr/bin/env python3
"""How small a limit of strain patterns keep, and what that costs: the table of docs/notebook/unfold.md.

  limits_table.py PLANISH FOLDER [NAME...]

A line for each patch of the folder (.obj and .ply), or for those whose names begin with NAME, laid flat as it is:

  largest     largest strain of an edge at least stretch, %
  smallest    the smallest limit that a pattern keeps, over the largest strain
  rms at it   rms strain under 1.1 times that limit, over that at least stretch
  at 0.55     whether a limit of 0.55 times the largest strain is kept, and the rms strain as before
  time        of both, and of the search for the smallest limit, each over that of `unfold` without a limit; worth
              reading on a quiet machine only

then medians over those whose largest strain is 0.1 % or more. Patches whose borders forbid flatness are left out.
"""
import json, os, statistics, subprocess, sys, tempfile, time

# Their borders forbid flatness: left out.
LEFT_OUT = ("cowhead", "face", "fish_side", "gc_hood", "goathead", "hat_crown", "hat_fedora", "spothead")
NO_STRAIN = 0.001


def run(command):
    begin = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True)
    seconds = time.monotonic() - begin
    if done.returncode not in (0, 3):
        return None, seconds
    return json.loads(done.stdout), seconds


def limit(share):
    return f"{100 * min(1.0, share)!r}%"


def table_row(program, path, flat):
    unfold = [program, "unfold", path, "-o", flat, "--json"]
    plain, plain_seconds = run(unfold)
    if plain is None:
        return None
    largest, rms = plain["strain"]["max"], plain["strain"]["rms"]
    row = {"largest": 100 * largest, "flat": largest < NO_STRAIN}
    if row["flat"]:
        return row
    search, search_seconds = run([*unfold, "--max-strain", limit(0.05 * largest)])
    smallest = search["limits"][0]["reached"]
    near, near_seconds = run([*unfold, "--max-strain", limit(1.1 * smallest)])
    half, half_seconds = run([*unfold, "--max-strain", limit(0.55 * largest)])
    row.update(smallest=smallest / largest, near=near["strain"]["rms"] / rms, near_kept=near["limits"][0]["kept"],
               half=half["strain"]["rms"] / rms, half_kept=half["limits"][0]["kept"],
               flips=near["flipped_triangles"] + half["flipped_triangles"],
               near_time=near_seconds / plain_seconds, half_time=half_seconds / plain_seconds,
               search_time=search_seconds / plain_seconds)
    return row


def print_row(name, row):
    if row["flat"]:
        print(f"| {name} | {row['largest']:.2g} | flat as it is | | | | | |", flush=True)
        return
    print(f"| {name} | {row['largest']:.3g} | {row['smallest']:.3f} | {row['near']:.3f}{'' if row['near_kept'] else ' missed'} "
          f"| {row['half']:.3f}{'' if row['half_kept'] else ' missed'} | {row['near_time']:.1f} | {row['half_time']:.1f} "
          f"| {row['search_time']:.1f} |", flush=True)


def print_medians(rows):
    def median(key):
        return statistics.median(row[key] for row in rows)

    print(f"\n{len(rows)} that are not flat as they are: smallest limit "
          f"{median('smallest'):.3f} of the largest strain, at most {max(row['smallest'] for row in rows):.3f}; "
          f"rms under 1.1 times that {median('near'):.3f} times; 0.55 kept on {sum(row['half_kept'] for row in rows)}, "
          f"rms {median('half'):.3f} times, at most 1.2 on {sum(row['half'] <= 1.2 for row in rows)}; "
          f"flipped triangles {sum(row['flips'] for row in rows)}; time {median('near_time'):.1f}, "
          f"{median('half_time'):.1f} and {median('search_time'):.1f} times, at most "
          f"{max(row['near_time'] for row in rows):.1f}, {max(row['half_time'] for row in rows):.1f} and "
          f"{max(row['search_time'] for row in rows):.1f}")


def main():
    if len(sys.argv) < 3:
        print(__doc__)
        return 2
    program, folder, wanted = sys.argv[1], sys.argv[2], tuple(sys.argv[3:]) or ("",)
    rows = []
    print("| patch | largest, % | smallest | rms at it | at 0.55 | time | at 0.55 | search |\n|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as out:
        for name in sorted(os.listdir(folder)):
            stem = os.path.splitext(name)[0]
            if not name.endswith((".obj", ".ply")) or not stem.startswith(wanted) or stem.startswith(LEFT_OUT):
                continue
            row = table_row(program, os.path.join(folder, name), os.path.join(out, "flat.obj"))
            if row is None:
                continue
            print_row(stem, row)
            if not row["flat"]:
                rows.append(row)
    if rows:
        print_medians(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
