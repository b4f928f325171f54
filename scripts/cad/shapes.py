"""Shapes through FreeCAD: found where Debian keeps it, and what all operations ask of a shape."""

import sys

sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD  # noqa: E402, F401  FreeCAD's modules are there only after it
import Part  # noqa: E402


def read(path):
    """The one solid, shell or compound of a STEP file."""
    shape = Part.Shape()
    shape.read(path)
    return shape


def diagonal(shape):
    return shape.BoundBox.DiagonalLength


def is_sound(shape):
    """Valid, and of one closed solid at least."""
    return bool(shape.isValid() and shape.Solids and shape.Volume > 0)
