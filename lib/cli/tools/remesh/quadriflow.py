"""QuadriFlow as it stands in Blender: from triangles to quads, both as plain OBJ.

usage: blender --background --python quadriflow.py -- SCAN QUADS COUNT PRESERVE_SHARP PRESERVE_BOUNDARY SEED
"""
import sys

import bpy

scan, quads, count, sharp, boundary, seed = sys.argv[sys.argv.index("--") + 1:]

points, faces = [], []
with open(scan, encoding="ascii") as lines:
    for line in lines:
        kind, *words = line.split()
        if kind == "v":
            points.append([float(word) for word in words])
        elif kind == "f":
            faces.append([int(word) - 1 for word in words])

mesh = bpy.data.meshes.new("scan")
mesh.from_pydata(points, [], faces)
thing = bpy.data.objects.new("scan", mesh)
bpy.context.collection.objects.link(thing)
bpy.context.view_layer.objects.active = thing
thing.select_set(True)

done = bpy.ops.object.quadriflow_remesh(
    mode="FACES",
    target_faces=int(count),
    seed=int(seed),
    use_preserve_sharp=bool(int(sharp)),
    use_preserve_boundary=bool(int(boundary)),
    use_mesh_symmetry=False,
)
# It leaves alone what it can do nothing with.
if done != {"FINISHED"} or any(len(face.vertices) != 4 for face in thing.data.polygons):
    sys.exit("QuadriFlow gave up")

with open(quads, "w", encoding="ascii") as result:
    for vertex in thing.data.vertices:
        result.write("v {!r} {!r} {!r}\n".format(*vertex.co))
    for face in thing.data.polygons:
        result.write("f " + " ".join(str(k + 1) for k in face.vertices) + "\n")
