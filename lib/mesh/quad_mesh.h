/// \file The mesh type, defined here and nowhere else, and its element handles.
#pragma once

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

namespace qm {

using Point = OpenMesh::Vec3d;

struct QuadMeshTraits : OpenMesh::DefaultTraits {
    using Point = qm::Point;
    using Normal = qm::Point;
    VertexAttributes(OpenMesh::Attributes::None);
    HalfedgeAttributes(OpenMesh::Attributes::None);
    EdgeAttributes(OpenMesh::Attributes::None);
    FaceAttributes(OpenMesh::Attributes::None);
};

/// An oriented 2-manifold whose faces are all quads (docs/METHOD.md#words), as `readMesh` guarantees it.
/// Vertices and faces are numbered as in the file; isolated vertices are kept. A face's first vertex in the
/// file is the vertex that its halfedge points to.
using QuadMesh = OpenMesh::PolyMesh_ArrayKernelT<QuadMeshTraits>;

using VertexId = OpenMesh::VertexHandle;
using HalfedgeId = OpenMesh::HalfedgeHandle;
using EdgeId = OpenMesh::EdgeHandle;
using FaceId = OpenMesh::FaceHandle;

} // namespace qm
