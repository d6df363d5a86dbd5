#!/usr/bin/env python3
"""Runs notebooks from top to bottom, in a folder of their own, and ends with 1 where a cell fails.

    bindings/python/tools/notebooks.py NOTEBOOK...
"""

import os
import sys
import tempfile

import nbformat
from jupyter_client import AsyncKernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError


def own_kernel():
    """Python as it runs this file; Debian's kernel would be that of the system."""
    manager = AsyncKernelManager(kernel_name="python3")
    manager.kernel_spec.argv[0] = sys.executable
    return manager


def fault_of(path):
    """What is wrong with a notebook, or None."""
    notebook = nbformat.read(path, as_version=4)
    if any(cell.get("outputs") for cell in notebook.cells):
        return "it is committed with outputs"
    with tempfile.TemporaryDirectory() as folder:
        try:
            client = NotebookClient(notebook, km=own_kernel(), timeout=300, resources={"metadata": {"path": folder}})
            client.execute()
        except CellExecutionError as error:
            return str(error)
    return None


def main():
    os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # words about a debugger that is not used
    faults = {path: fault_of(path) for path in sys.argv[1:]}
    for path, fault in faults.items():
        print(f"{path}: {fault or 'done'}")
    return 1 if any(faults.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
