"""Shapes through FreeCAD: found where Debian keeps it, what all operations ask of a shape, and how they answer."""

import json
import math
import os
import sys

sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD  # noqa: E402, F401  FreeCAD's modules are there only after it
import Part  # noqa: E402

ANGLE = math.radians(30)  # of meshes, between the normals of neighbours, as FreeCAD proposes


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


def mesh(shape, deflection):
    """Triangles no farther from the shape than a share of its diagonal."""
    import MeshPart
    return MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection * diagonal(shape), AngularDeflection=ANGLE,
                                  Relative=False)


def volume(shape):
    """Of a mesh of it: the integrals that OpenCASCADE computes over trimmed spline faces are off by up to a per cent."""
    return mesh(shape, 3e-4).Volume


def verdict(ok, note=""):
    return {"ok": bool(ok), "note": "" if ok else note}


def failure(error):
    return verdict(False, (" ".join(str(error).split()) or type(error).__name__)[:80])


def answer(operation):
    """Prints what an operation says as one line of JSON, and ends the process."""
    sys.stdout.flush()
    answers = os.dup(1)
    os.dup2(2, 1)  # libraries talk on standard output
    try:
        result = operation()
    except Exception as error:  # FreeCAD and Netgen throw many kinds
        result = failure(error)
    os.write(answers, (json.dumps(result) + "\n").encode())
    os._exit(0)  # destructors of broken shapes may fail
