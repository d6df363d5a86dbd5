"""Reads our DXF files with ezdxf."""

import sys

import roundtrip
from roundtrip import check, near

try:
    import ezdxf
    from ezdxf import bbox
    from ezdxf.lldxf.encoding import decode_dxf_unicode
except ImportError:
    roundtrip.skip("python3-ezdxf")

MILLIMETRES = 4
# ezdxf 0.18 says so of every R12 file with polylines in blocks, also of those that it wrote itself.
OWN_QUIRK = "entity with invalid owner handle #None"


def load(path, in_blocks=False):
    document = ezdxf.readfile(path)
    audit = document.audit()
    check(not audit.errors, f"{path.name}: errors {[error.message for error in audit.errors]}")
    fixes = [fix.message for fix in audit.fixes]
    if in_blocks:
        fixes = [fix for fix in fixes if not (fix.startswith("Deleted SEQEND") and OWN_QUIRK in fix)]
    check(not fixes, f"{path.name}: fixes {fixes}")
    if not in_blocks:
        check(document.units == MILLIMETRES, f"{path.name}: unit {document.units}")
        check(document.header["$INSUNITS"] == MILLIMETRES, f"{path.name}: $INSUNITS")
    return document


def names(document):
    return [layer.dxf.name for layer in document.layers if layer.dxf.name not in ("0", "Defpoints")]


def extents(entities):
    box = bbox.extents(entities)
    return (*box.extmin.vec2, *box.extmax.vec2)


def loops(space, layer):
    return [line for line in space.query("POLYLINE") if line.dxf.layer == layer]


def check_generic(path, cut="cut", has_text=True):
    document = load(path)
    space = document.modelspace()
    lines = loops(space, cut)
    check(all(line.is_closed and line.is_2d_polyline for line in lines), f"{path.name}: not closed")
    # The hole comes before the outline around it, which frees the piece.
    hole, outline, circle = lines[:3]
    square = extents([outline])
    for found, wanted in zip(square, (20.0, 30.0, 120.0, 130.0)):
        near(found, wanted, 1e-9, f"{path.name}: square")
    near(extents([circle])[2], 280.0, 0.0006, f"{path.name}: circle")
    check(len(hole) == 250 and len(circle) == 720, f"{path.name}: number of corners")
    for point in circle.points():
        near(abs(complex(point[0] - 220.0, point[1] - 100.0)), 60.0, 0.0008, "radius")
    grain = loops(space, "grain")
    check(len(grain) == 1 and not grain[0].is_closed, f"{path.name}: the grain line is open")
    check(not document.layers.get("notes__hidden").is_on(), f"{path.name}: the notes are hidden")
    check(document.layers.get(cut).is_on(), f"{path.name}: the cut is to be seen")
    check(document.layers.get(cut).dxf.color == 1, f"{path.name}: the cut is red")
    low, high = document.header["$EXTMIN"], document.header["$EXTMAX"]
    drawn = extents(space.query("POLYLINE"))
    check(low[0] <= drawn[0] and low[1] <= drawn[1], f"{path.name}: $EXTMIN")
    check(high[0] >= drawn[2] and high[1] >= drawn[3], f"{path.name}: $EXTMAX")
    texts = [decode_dxf_unicode(text.dxf.text) for text in space.query("TEXT")]
    wanted = ["Größe 38 (100%%) \\ ± 0.5° × €", "middle − half", "Łódź 布"]
    check(texts == (wanted if has_text else []), f"{path.name}: texts {texts}")
    return document


def check_blocks(path):
    document = load(path, in_blocks=True)
    space = document.modelspace()
    inserts = space.query("INSERT")
    check([insert.dxf.name for insert in inserts] == ["front_ONE", "back_ONE"], f"{path.name}: pieces")
    blocks = [block for block in document.blocks if not block.name.startswith("*")]
    check([block.name for block in blocks] == ["front_ONE", "back_ONE"], f"{path.name}: blocks")
    check(not space.query("POLYLINE"), f"{path.name}: a line outside of the blocks")
    front, back = blocks
    for layer, count in (("1", 1), ("11", 1), ("14", 1)):
        check(len(loops(front, layer)) == count, f"{path.name}: layer {layer}")
    near(extents(loops(front, "1"))[2], 120.0, 1e-9, f"{path.name}: boundary")
    near(extents(loops(front, "11"))[2], 90.0, 1e-9, f"{path.name}: cut-out")
    layers = [line.dxf.layer for line in back.query("POLYLINE")]
    check(layers in (["1"], ["1", "84"]), f"{path.name}: back {layers}")
    notes = [text.dxf.text.lower() for text in back.query("TEXT")]
    check("piece name: back" in notes, f"{path.name}: {notes}")
    style = [text.dxf.text.lower() for text in space.query("TEXT")]
    check("units: metric" in style, f"{path.name}: unit")


def main():
    folder = roundtrip.known_files()
    generic = check_generic(folder / "generic.dxf")
    check(generic.dxfversion == "AC1009", f"version {generic.dxfversion}")
    check(names(generic) == ["cut", "seam", "grain", "notes__hidden", "label"], str(names(generic)))
    check_generic(folder / "strokes.dxf", has_text=False)
    renamed = load(folder / "renamed.dxf")
    check(names(renamed) == ["LASER", "grain", "notes__hidden", "label"], str(names(renamed)))
    check(len(loops(renamed.modelspace(), "LASER")) == 4, "joined layers")
    for profile in ("aama", "astm", "clo", "lectra", "optitex", "gerber"):
        check_blocks(folder / f"{profile}.dxf")
    print("DXF: all as written")


if __name__ == "__main__":
    sys.exit(main())
