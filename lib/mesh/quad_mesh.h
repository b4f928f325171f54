/// \file The mesh type and the handles of its elements, the only place where they are defined.
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

/// An oriented 2-manifold whose faces are all quads (docs/METHOD.md#words); `readMesh` guarantees this.
/// Vertices and faces are numbered as in the file; isolated vertices are kept. The halfedge of a face points
/// to the first vertex of the face in the file.
using QuadMesh = OpenMesh::PolyMesh_ArrayKernelT<QuadMeshTraits>;

using VertexId = OpenMesh::VertexHandle;
using HalfedgeId = OpenMesh::HalfedgeHandle;
using EdgeId = OpenMesh::EdgeHandle;
using FaceId = OpenMesh::FaceHandle;

} // namespace qm
