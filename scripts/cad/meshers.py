"""Meshes of a STEP file by gmsh and Netgen: prints one line of JSON as operations.py does.

usage: meshers.py gmsh_surface|gmsh_volume|netgen_volume FILE
"""

import subprocess
import sys
import tempfile

import shapes
from shapes import verdict

SIZE = 0.05  # of elements, as a share of the diagonal
TRIANGLE, TETRAHEDRON = 2, 4  # in gmsh's files


def tetrahedron_volume(corners):
    a, b, c, d = corners
    u, v, w = ([p[k] - a[k] for k in range(3)] for p in (b, c, d))
    return abs(u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2])
               + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


def filled(shape, tetrahedra):
    """Whether tetrahedra, each four points, fill the solid."""
    volume = sum(map(tetrahedron_volume, tetrahedra))
    off = abs(volume - shape.Volume) / shape.Volume
    return verdict(off < 0.15, f"volume off by {off:.2g}")


def gmsh(path, dimension):
    """Nodes and elements of a mesh by gmsh, or what it complains of."""
    size = SIZE * shapes.diagonal(shapes.read(path))
    with tempfile.TemporaryDirectory() as folder:
        file = f"{folder}/mesh.msh"
        run = subprocess.run(["gmsh", f"-{dimension}", "-v", "3", "-nt", "1", "-clmax", str(size), "-format", "msh2",
                              path, "-o", file], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        complaint = next((line for line in run.stdout.splitlines() if line.startswith("Error")), None)
        if complaint or run.returncode:
            return None, None, complaint or f"ended with status {run.returncode}"
        with open(file, encoding="ascii") as lines:
            sections = lines.read().split("$Nodes\n")[1]
    nodes, elements = sections.split("$EndNodes\n$Elements\n")
    points = {row[0]: [float(x) for x in row[1:]] for row in map(str.split, nodes.splitlines()[1:])}
    rows = [row.split() for row in elements.split("$EndElements")[0].splitlines()[1:]]
    return points, rows, None


def gmsh_surface(path):
    _, rows, complaint = gmsh(path, 2)
    if complaint:
        return verdict(False, complaint)
    return verdict(any(int(row[1]) == TRIANGLE for row in rows), "no triangles")


def gmsh_volume(path):
    points, rows, complaint = gmsh(path, 3)
    if complaint:
        return verdict(False, complaint)
    return filled(shapes.read(path), [[points[k] for k in row[-4:]] for row in rows if int(row[1]) == TETRAHEDRON])


def netgen_volume(path):
    from netgen.NgOCC import LoadOCCGeometry
    shape = shapes.read(path)
    mesh = LoadOCCGeometry(path).GenerateMesh(maxh=SIZE * shapes.diagonal(shape))
    points = mesh.Points()
    return filled(shape, [[points[k].p for k in element.vertices] for element in mesh.Elements3D()])


def main():
    operation, path = sys.argv[1:]
    meshers = {mesher.__name__: mesher for mesher in (gmsh_surface, gmsh_volume, netgen_volume)}
    shapes.answer(lambda: meshers[operation](path))


main()
