"""The functions of the package, a module for each verb of the program. Written by tools/generate.py."""
