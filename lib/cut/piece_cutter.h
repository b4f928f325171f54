/// \file Makes one piece of the mesh simpler by cutting it (docs/METHOD.md#mesh-cut).
#pragma once

#include "basecomplex/base_complex.h"
#include "cut/cut.h"
#include "cut/energy.h"
#include "cut/label_components.h"
#include "cut/pieces.h"
#include "cut/surface_distances.h"
#include "cut/terminals.h"

#include <vector>

namespace qm {

/// Works on one piece at a time, in time linear in that piece; results depend on nothing else.
class PieceCutter {
public:
    /// All must outlive the object.
    PieceCutter(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& dihedralAngles,
                const CutOptions& options);

    /// The whole mesh but its isolated vertices.
    [[nodiscard]] Piece whole() { return division_.whole(); }

    /// \return the parts of the piece; nothing if it is simple enough or gets no simpler
    [[nodiscard]] std::vector<Piece> simplify(const Piece& piece);

private:
    std::vector<Piece> cut(const Piece& piece);
    std::vector<Piece> separate(const Piece& piece);
    std::vector<Piece> cutBetween(const Piece& piece, Terminals kind);
    std::vector<Piece> divideBetween(const Piece& piece, const PieceSources& sources,
                                     const TerminalPair& terminals);

    const QuadMesh& mesh_;
    const CutOptions& options_;
    PieceDivision division_;
    LabelComponents components_;
    SurfaceDistances distances_;
    Energy energy_;
};

} // namespace qm
