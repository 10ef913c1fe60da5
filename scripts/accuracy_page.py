# SPDX-License-Identifier: Apache-2.0
"""docs/accuracy.md from what tests/bench/accuracy measured."""
from pathlib import Path

REFERENCE_PATHS = 1 << 17
CELLS = "cells, {} directions"
SPLITS = ["split", *(f"split, {n} hidden" for n in (1, 2, 4)), *(f"split, {n} views" for n in (12, 42, 92, 162, 362)), *(CELLS.format(n) for n in (92, 162, 362, 642))]
CLASSES = ["diffuse", "rough", "sharp"]
TEXT = (Path(__file__).resolve().parent / "accuracy_page.md").read_text()


def mean(rows, key):
    return sum(r[key] for r in rows) / len(rows)


def cell(rows):
    return f"{mean(rows, 'soft'):.3f} / {mean(rows, 'sun_lit'):.3f}".replace("0.", ".") if rows else ""


def table(head, lines):
    rule = ["---"] * len(head)
    return "\n".join("| " + " | ".join(line) + " |" for line in [head, rule, *lines])


class Rows:
    def __init__(self, rows):
        self.rows = rows

    def where(self, **wanted):
        return Rows([r for r in self.rows if all(r[k] == v for k, v in wanted.items())])

    def values(self, key):
        return sorted({r[key] for r in self.rows})

    def cells(self, classes):
        return [cell(self.where(**{"class": name}).rows) for name in classes]


def at_views(rows, paths):
    views = rows.where(place="views", paths=paths)
    boxes = views.where(method="boxes")
    lines = [["paths alone", *views.where(method="deposits").cells(CLASSES), ""]]
    for terms in boxes.values("terms"):
        found = boxes.where(terms=terms)
        lines.append([str(terms), *found.cells(CLASSES), f"{mean(found.rows, 'ms'):.2f}"])
    return table(["boxes", *CLASSES, "ms"], lines)


def bases(rows, paths):
    views = rows.where(place="views", paths=paths)
    lines = []
    for low, high in ((40, 60), (90, 100), (380, 390)):
        for method in ("boxes", "spherical harmonics", "Haar wavelets", "spherical Gaussians"):
            found = Rows([r for r in views.where(method=method).rows if low <= r["bytes"] <= high])
            if found.rows:
                label = f"{found.rows[0]['bytes']}"
                lines.append([label, method, *found.cells(CLASSES), f"{mean(found.rows, 'ms'):.1f}"])
    return table(["bytes", "basis", *CLASSES, "ms"], lines)


def between(rows):
    gloss = CLASSES[1:]
    place = rows.where(place="between")
    lines = [[name, *place.where(method=name).cells(gloss)] for name in ("deposits", "direct fit", *SPLITS)]
    sketch = place.where(method="sketch")
    for terms in sketch.values("terms"):
        for method in ("sketch", "sketch, literal weights", "three views blended", "mirror"):
            lines.append([f"{method}, {terms}", *place.where(method=method, terms=terms).cells(gloss)])
    return table(["scheme, boxes", *gloss], lines)


def by_alpha(rows):
    lines = []
    for place in [p for p in rows.values("place") if p.startswith("between, ")]:
        for scene in rows.where(place=place).values("scene"):
            found = rows.where(place=place, scene=scene)
            methods = [cell(found.where(method=name).rows) for name in ("direct fit", "split", CELLS.format(362))]
            lines.append([place.removeprefix("between, alpha "), scene, *methods])
    return table(["alpha", "scene", "direct fit, 8 boxes", "split", "cells"], lines)


def by_scene(rows):
    lines = []
    for scene in sorted({r["scene"] for r in rows.rows}):
        own = rows.where(scene=scene)
        for label, found in (
            ("at views", own.where(place="views", method="boxes", terms=8, paths=1024)),
            ("between, direct fit", own.where(place="between", method="direct fit")),
            ("between, sketch", own.where(place="between", method="sketch", terms=8)),
            ("between, split", own.where(place="between", method="split")),
            ("between, cells", own.where(place="between", method=CELLS.format(362))),
        ):
            lines.append([scene, label, *found.cells(CLASSES)])
    return table(["scene", "8 boxes, 1024 paths", *CLASSES], lines)


def cost(schemes):
    lines = []
    for scene, found in schemes.items():
        for label, f in found.items():
            figures = [f"{f['bytes']:.0f}", f"{f['raw']:.0f}", f"{f['bake_seconds']:.0f}", f"{f['frame_ms']:.0f}"]
            lines.append([scene, label, *figures])
    return table(["scene", "scheme", "bytes a texel", "before compression", "bake s", "frame ms"], lines)


def page(schemes, *results):
    """`schemes`: what whole assets cost, by scene and scheme; `results`: what runs of the bench measured under the same lights."""
    rows = Rows([row for result in results for row in result["rows"]])
    clean = max(rows.values("paths"))
    lights = {True: [], False: []}
    for light in results[0]["lights"]:
        lights[light["sun_lit"]].append(light["name"])
    fields = {
        "reference": f"{REFERENCE_PATHS:,}",
        "soft": ", ".join(lights[False]),
        "sun_lit": ", ".join(lights[True]),
        "clean": str(clean),
        "samples": str(max(rows.where(place="views").values("samples"))),
        "samples_between": str(max(rows.where(place="between").values("samples"))),
        "views": at_views(rows, 1024),
        "views_clean": at_views(rows, clean),
        "bases": bases(rows, 1024),
        "bases_clean": bases(rows, clean),
        "between": between(rows),
        "alphas": by_alpha(rows),
        "scenes": by_scene(rows),
        "cost": cost(schemes),
    }
    text = TEXT
    for name, value in fields.items():
        text = text.replace("{{" + name + "}}", value)
    assert "{{" not in text, text[text.index("{{") :][:30]
    return text
