/// \file The sub-meshes of a cut in the making: which vertices and particles each has, and how complicated it
/// is (docs/METHOD.md#mesh-cut).
#pragma once

#include "cut/cut.h"
#include "cut/measure.h"

#include <utility>
#include <vector>

namespace qm {

/// A sub-mesh while it may still be cut.
struct Piece {
    SubMeshId label;                       ///< of its vertices; no two pieces ever have the same
    std::vector<VertexId> vertices;        ///< ascending
    std::vector<std::size_t> separatrices; ///< that start inside, ascending: so do their sources
    SubMesh measures;
};

/// Vertices where particles start.
struct PieceSources {
    std::vector<VertexId> extraordinary; ///< ascending
    std::vector<VertexId> seeds;         ///< ascending
};

/// Divides pieces, and keeps the labels of all vertices.
class PieceDivision {
public:
    /// Both must outlive the object.
    PieceDivision(const QuadMesh& mesh, const BaseComplex& complex);

    /// The whole mesh but its isolated vertices.
    [[nodiscard]] Piece whole();

    /// Gives the parts of a piece labels and particles of their own; they have its terminals.
    /// \param partOf  of every vertex of the piece, 0 to count - 1
    [[nodiscard]] std::vector<Piece> divide(const Piece& piece, const std::vector<int>& partOf, int count);

    /// Gives the vertices of a piece its label again, after it has been divided.
    void restore(const Piece& piece);

    /// Of every vertex; changes with `divide` and `restore`.
    [[nodiscard]] const std::vector<SubMeshId>& labels() const { return labels_; }
    [[nodiscard]] VertexId sourceOf(std::size_t separatrix) const { return measure_.sourceOf(separatrix); }
    [[nodiscard]] PieceSources sourcesOf(const Piece& piece) const;

private:
    void measure(Piece& piece);

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    Measure measure_;
    std::vector<SubMeshId> labels_;
    SubMeshId nextLabel_{1};
};

} // namespace qm
