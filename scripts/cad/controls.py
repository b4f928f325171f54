"""STEP files to compare with: solids as a CAD system makes them. usage: controls.py FOLDER"""

import math
import sys

import shapes
from FreeCAD import Vector

Part = shapes.Part


def filleted_block():
    """A block with a drilled hole, all its edges rounded."""
    block = Part.makeBox(60, 40, 20).cut(Part.makeCylinder(8, 20, Vector(40, 20, 0)))
    return block.makeFillet(3, block.Edges)


def flange():
    """A disc with a hub, a bore and a circle of bolt holes; the hub's foot is rounded."""
    solid = Part.makeCylinder(50, 10).fuse(Part.makeCylinder(25, 35)).removeSplitter()
    foot = [edge for edge in solid.Edges
            if abs(edge.CenterOfMass.z - 10) < 1e-6 and abs(edge.BoundBox.XMax - 25) < 1e-6 and edge.Length > 30]
    solid = solid.makeFillet(4, foot)
    solid = solid.cut(Part.makeCylinder(12, 35))
    for k in range(6):
        angle = 2 * math.pi * k / 6
        solid = solid.cut(Part.makeCylinder(4, 10, Vector(38 * math.cos(angle), 38 * math.sin(angle), 0)))
    return solid


def swept_bracket():
    """A channel's section swept along a plane free curve: B-spline faces between plane ends."""
    path = Part.BSplineCurve()
    path.interpolate([Vector(0, 0, 0), Vector(60, 0, 15), Vector(100, 0, 60), Vector(110, 0, 120)],
                     InitialTangent=Vector(1, 0, 0), FinalTangent=Vector(0, 0, 1))
    corners = [(-12, -8), (12, -8), (12, 8), (8, 8), (8, -4), (-8, -4), (-8, 8), (-12, 8)]
    section = Part.Face(Part.makePolygon([Vector(0, y, z) for y, z in corners + corners[:1]]))
    return Part.Wire([path.toShape()]).makePipe(section)


def main():
    for make in (filleted_block, flange, swept_bracket):
        shape = make()
        assert shape.isValid(), make.__name__
        shape.exportStep(f"{sys.argv[1]}/{make.__name__}.step")


main()
