"""Methods from outside as `compare --with` runs them. Ends with 77 where numpy is not installed.

compare_with.py PLANISH
"""

import json
import pathlib
import signal
import subprocess
import sys
import time

import support

PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "examples/python/own_program.py"


def compared(planish, patch, *commands, methods="none"):
    """The run of each method by its name."""
    words = [planish, "compare", patch, "--methods", methods, "--json"]
    for command in commands:
        words += ["--with", command]
    done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=120)
    return {run["method"]: run for run in json.loads(done.stdout)["runs"]}, done.stderr


def python(code):
    """A command that runs a line of Python without spaces."""
    return f"'{sys.executable}' -c '{code}' {{in}} {{out}}"


def check_example(planish):
    # Its name would do harm in a shell.
    patch = "a patch; touch harm $(touch harm) 'x.obj"
    support.output_of(planish, "sample", "panel", "--vertices", "500", "-o", patch)
    runs, _ = compared(planish, patch, f"umbrella='{sys.executable}' '{PROGRAM}' {{in}} {{out}}", methods="classical")
    umbrella = runs["umbrella"]
    support.expect(umbrella["error"] is None, f"the example failed: {umbrella['error']}")
    support.expect(umbrella["after"]["e_max"] < umbrella["before"]["e_max"], "the example takes no defects out")
    support.expect(umbrella["deviation"]["max"] > 0, "the example moves nothing")
    support.expect("border" not in umbrella, "the example moves the border")
    support.expect(not pathlib.Path("harm").exists(), "a shell took part")


def check_failures(planish):
    support.output_of(planish, "sample", "dome", "--vertices", "200", "-o", "dome.obj")
    runs, said = compared(
        planish, "dome.obj", f"code={python('exit(3)')}", "missing=no-such-program-here {in} {out}",
        f"idle={python('print(42)')}", f"killed={python('import os;os.kill(os.getpid(),9)')}",
    )  # fmt: skip
    for name, words in {"code": "ended with code 3", "missing": "cannot be started: No such file",
                        "idle": "wrote no mesh", "killed": "was ended by signal 9"}.items():
        error = runs[name]["error"]
        support.expect(error["code"] == "method_failed" and words in error["message"], f"{name}: {error}")
    support.expect("42" in said, "what a program prints is lost")


def check_end(planish):
    """Asked to end, the program ends the other one and what that started."""
    command = f"slow=sh -c 'echo $$ > started; sleep 60 & wait' {{in}} {{out}}"
    words = [planish, "compare", "dome.obj", "--methods", "none", "--with", command]
    with subprocess.Popen(words, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL) as run:
        started = pathlib.Path("started")
        for _ in range(600):
            if started.exists() and started.read_text().strip():
                break
            time.sleep(0.05)
        run.send_signal(signal.SIGTERM)
        support.expect(run.wait(timeout=60) == 130, "it does not end as interrupted")
    group = started.read_text().strip()
    processes = [line.split(None, 2) for line in support.output_of("ps", "-eo", "pgid=,stat=,args=").splitlines()]
    left = [process for process in processes if process[0] == group and not process[1].startswith("Z")]
    support.expect(not left, f"processes are left: {left}")


def main():
    try:
        import numpy  # noqa: F401
    except ImportError:
        print("skipped: numpy is not installed")
        sys.exit(support.SKIPPED)
    planish = support.program_from_arguments(__doc__)
    support.skip_without("ps")
    with support.own_folder():
        check_example(planish)
        check_failures(planish)
        check_end(planish)


if __name__ == "__main__":
    main()
