"""What engineers do with a solid, one operation a call: prints one line of JSON about what came of it.

usage: operations.py OPERATION FILE [NUMBER]

{"ok": done as it should be, "note": what is wrong}. `sharp` says {"edges": numbers of the edges to fillet}.
"""

import collections
import math
import sys

import shapes
from FreeCAD import Vector
from shapes import failure, verdict

Part = shapes.Part

OFFSET = 0.01  # of the diagonal
RADIUS = 0.005  # of fillets
DEFLECTION = 0.001  # of tessellations
SHARP = math.radians(20)  # between the normals of two faces
FILLETS = 12  # edges tried, the longest
ARCS, INTERSECTIONS = 0, 2  # how an offset joins faces


def valid(shape):
    return verdict(shapes.is_sound(shape), "no valid closed solid")


def analyser(shape):
    """OpenCASCADE's check of what Boolean operations need."""
    try:
        shape.check(True)
    except ValueError as error:
        kinds = collections.Counter(line.split(":")[-1].strip() for line in str(error).splitlines()[1:] if line.strip())
        return verdict(False, ", ".join(f"{count} {kind}" for kind, count in sorted(kinds.items())))
    return verdict(True)


def smooth_faces(shape):
    """No surface has a knot so often that it counts as C0 there."""
    creased = 0
    for face in shape.Faces:
        surface = face.Surface
        if not isinstance(surface, Part.BSplineSurface):
            continue
        inner_u = surface.getUMultiplicities()[1:-1]
        inner_v = surface.getVMultiplicities()[1:-1]
        creased += max(inner_u, default=0) >= surface.UDegree or max(inner_v, default=0) >= surface.VDegree
    return verdict(creased == 0, f"{creased} of {len(shape.Faces)} faces")


def is_divided(shape, inside, outside):
    """Whether two parts are sound and together what they were cut from."""
    if not shapes.is_sound(inside) or not shapes.is_sound(outside):
        return verdict(False, "a part is no valid solid")
    whole = shapes.volume(shape)
    off = abs(shapes.volume(inside) + shapes.volume(outside) - whole) / whole
    return verdict(off < 2e-3, f"volume off by {off:.1e}")


def box_cut(shape):
    box = shape.BoundBox
    corner = box.Center + Vector(box.XLength, box.YLength, box.ZLength) * 0.013
    tool = Part.makeBox(box.XLength, box.YLength, box.ZLength, corner - Vector(box.XLength, 0, 0))
    return is_divided(shape, shape.common(tool), shape.cut(tool))


def half_space_cut(shape):
    middle = shape.BoundBox.Center
    normal = Vector(0.83, 0.41, 0.37)
    half = shapes.diagonal(shape)
    plane = Part.Plane(middle, normal).toShape(-half, half, -half, half)
    tool = plane.makeHalfSpace(middle + normal)
    return is_divided(shape, shape.common(tool), shape.cut(tool))


def angle_at(shape, edge):
    """Between the normals of an edge's two faces, in its middle."""
    faces = shape.ancestorsOfType(edge, Part.Face)
    if len(faces) != 2:
        return 0
    middle = edge.valueAt((edge.FirstParameter + edge.LastParameter) / 2)
    normals = [face.normalAt(*face.Surface.parameter(middle)) for face in faces]
    return normals[0].getAngle(normals[1])


def sharp(shape):
    """The longest edges where faces meet at an angle, and which are long enough for a fillet."""
    found = []
    for number, edge in enumerate(shape.Edges):
        if edge.Length >= 4 * RADIUS * shapes.diagonal(shape) and angle_at(shape, edge) > SHARP:
            found.append((-round(edge.Length, 9), number))
    return {"edges": [number for _, number in sorted(found)[:FILLETS]]}


def fillet(shape, number):
    made = shape.makeFillet(RADIUS * shapes.diagonal(shape), [shape.Edges[number]])
    return verdict(shapes.is_sound(made), "result is no valid solid")


def any_join(make):
    """Arcs or intersections where faces part, whichever does it: FreeCAD offers both."""
    notes = []
    for join in (ARCS, INTERSECTIONS):
        try:
            answer = make(join)
        except Exception as error:  # FreeCAD throws many kinds
            answer = failure(error)
        if answer["ok"]:
            return answer
        notes.append(answer["note"])
    return verdict(False, ", ".join(dict.fromkeys(notes)))


def offset(shape):
    by = OFFSET * shapes.diagonal(shape)

    def make(join):
        made = shape.makeOffsetShape(by, 1e-4 * by, join=join)
        if not shapes.is_sound(made):
            return verdict(False, "result is no valid solid")
        grown = (made.Volume - shape.Volume) / (by * shape.Area)
        return verdict(0.7 < grown < 1.5, f"volume grows by {grown:.2f} of the expected")

    return any_join(make)


def opening(shape):
    """The largest face that others meet at an angle all around, if there is one: OpenCASCADE opens no other."""
    def is_framed(face):
        return all(angle_at(shape, edge) > SHARP for edge in face.Edges)
    by_area = sorted(shape.Faces, key=lambda face: -round(face.Area, 9))
    return next(filter(is_framed, by_area), by_area[0])


def thickness(shape):
    by = OFFSET * shapes.diagonal(shape)
    opened = opening(shape)

    def make(join):
        made = shape.makeThickness([opened], -by, 1e-4 * by, False, False, 0, join)
        if not shapes.is_sound(made):
            return verdict(False, "result is no valid solid")
        wall = made.Volume / (by * (shape.Area - opened.Area))
        return verdict(0.6 < wall < 1.3, f"volume is {wall:.2f} of the expected")

    return any_join(make)


def passes_through(start, end, triangle):
    """Whether a stretch passes through a triangle."""
    a, b, c = triangle
    normal = (b - a).cross(c - a)
    before, after = normal.dot(start - a), normal.dot(end - a)
    if before * after >= 0:
        return False
    point = start + (end - start) * (before / (before - after))
    return all((q - p).cross(point - p).dot(normal) >= 0 for p, q in ((a, b), (b, c), (c, a)))


def really_cross(*triangles):
    """FreeCAD takes triangles for crossing, too, that only come near each other."""
    corners = [[Vector(*point) for point in triangle.Points] for triangle in triangles]
    return any(passes_through(one[k - 1], one[k], other)
               for one, other in (corners, reversed(corners)) for k in range(3))


def tessellation(shape):
    mesh = shapes.mesh(shape, DEFLECTION)
    if not mesh.isSolid():
        return verdict(False, "not closed")
    facets = mesh.Facets
    suspects = mesh.getSelfIntersections() if mesh.hasSelfIntersections() else []
    crossings = sum(really_cross(facets[one], facets[other]) for one, other, *_ in filter(None, suspects))
    return verdict(crossings == 0, f"{crossings} of {mesh.CountFacets} triangles cross")


def main():
    operation, path = sys.argv[1:3]
    numbers = [int(text) for text in sys.argv[3:]]
    shapes.answer(lambda: globals()[operation](shapes.read(path), *numbers))


main()
