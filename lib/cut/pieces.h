/// \file The sub-meshes of a cut in the making: which vertices and particles each has, and how complicated it
/// is (docs/METHOD.md#mesh-cut).
#pragma once

#include "cut/cut.h"
#include "cut/measure.h"

#include <vector>

namespace qm {

/// A sub-mesh while it may still be cut.
struct Piece {
    std::vector<VertexId> vertices;         ///< ascending
    std::vector<SeparatrixId> separatrices; ///< that start inside, ascending: so do their sources
    SubMesh measures;
};

/// Vertices where particles start.
struct PieceSources {
    std::vector<VertexId> extraordinary; ///< ascending
    std::vector<VertexId> seeds;         ///< ascending
};

/// Divides one piece after the other. Only the vertices of the piece at work have labels.
class PieceDivision {
public:
    /// Both must outlive the object.
    PieceDivision(const QuadMesh& mesh, const BaseComplex& complex);

    /// The whole mesh but its isolated vertices.
    [[nodiscard]] Piece whole();

    /// Gives all vertices of a piece the same label, also after it has been divided.
    void label(const Piece& piece);

    /// Gives the parts of a piece at work labels and particles of their own; they have its terminals.
    /// \param partOf  of every vertex of the piece, 0 to count - 1
    [[nodiscard]] std::vector<Piece> divide(const Piece& piece, const std::vector<int>& partOf, int count);

    /// Takes the labels from the vertices of a piece.
    void unlabel(const Piece& piece);

    /// Of every vertex.
    [[nodiscard]] const std::vector<SubMeshId>& labels() const { return labels_; }
    [[nodiscard]] VertexId sourceOf(SeparatrixId separatrix) const { return measure_.sourceOf(separatrix); }
    [[nodiscard]] PieceSources sourcesOf(const Piece& piece) const;

private:
    void setLabels(const Piece& piece, SubMeshId label);
    void measure(Piece& piece, SubMeshId label);

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    Measure measure_;
    std::vector<SubMeshId> labels_;
};

} // namespace qm
