"""Which patch stands for which of the paper's, and what is taken where the folder of patches is
missing: built-in samples of the same sizes."""

import dataclasses
import pathlib

SAMPLES = ["panel", "saddle", "dome"]  # those that are not flattenable
SAMPLE_SIZES = [1000, 2000, 4000]


@dataclasses.dataclass(frozen=True)
class Patch:
    path: pathlib.Path
    what: str

    @property
    def name(self):
        return self.path.stem


BODY = "MakeHuman, CC0"
GARMENT = "GarmentCode, MIT"
# Role -> file, what it is, and the sample in its place.
ROLES = {
    "rises": ("mhf_back_4k.obj", f"back panel; {BODY}", ("dome", 4234)),
    "falls": ("gc_front_4k.obj", f"front panel; {GARMENT}", ("panel", 4234)),
    "table 0": ("mhf_back_4k.obj", f"back panel; {BODY}", ("panel", 4234)),
    "table 1": ("mhf_front_5k.obj", f"front panel, rough; {BODY}", ("panel", 5088)),
    "table 2": ("trouser_leg_13k.obj", f"trouser leg with folds; {BODY}", ("panel", 12859)),
    "table 3": (
        "jumpsuit_front_60k.ply",
        "front of a jumpsuit, divided at midpoints; C. Dumery et al., MIT",
        ("panel", 59513),
    ),
    "table 4": (
        "mhf_front_195k.ply",
        f"front panel, divided at midpoints; {BODY}",
        ("panel", 195093),
    ),
    "least norm 0": ("gc_front_4k.obj", f"front panel; {GARMENT}", ("panel", 4234)),
    "least norm 1": ("shoe_vamp_4k.obj", f"toe of a shoe; {BODY}", ("saddle", 4234)),
    "least norm 2": ("hat_fedora_2k.obj", f"whole hat; {BODY}", ("dome", 2000)),
    "directions": ("gc_front_4k.obj", f"front panel; {GARMENT}", ("panel", 4234)),
}
# One surface at two densities, for the measures that depend on it.
TWO_DENSITIES = ["gc_back_5k.obj", "gc_back_60k.ply"]
SMALL_BYTES = 500_000  # some 5,500 vertices as OBJ


class Patches:
    """@param folder of patches, or None"""

    def __init__(self, folder, program):
        self.folder, self.program = folder, program

    def in_role(self, role):
        file, what, (sample, vertices) = ROLES[role]
        if self.folder and (self.folder / file).exists():
            return Patch(self.folder / file, what)
        return Patch(self.program.sample(sample, vertices), "built-in sample")

    def two_densities(self):
        found = [self.folder / file for file in TWO_DENSITIES] if self.folder else []
        return [path for path in found if path.exists()]

    def small(self):
        """All small ones, for figures over many patches."""
        if not self.folder:
            return [self.program.sample(name, n) for name in SAMPLES for n in SAMPLE_SIZES]
        return sorted(p for p in self.folder.glob("*.obj") if p.stat().st_size < SMALL_BYTES)
