/// \file How closely something is fitted, from place to place.
#pragma once

#include "bspline/deviation.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

/// At a vertex of the mesh.
struct Closeness {
    double share = 1;   ///< of the tolerance
    bool slides = true; ///< distances are told from tangent planes

    friend bool operator==(const Closeness&, const Closeness&) = default;
};

/// Between two places, a linear function of `where` from 0 to 1.
[[nodiscard]] inline Closeness between(const Closeness& a, const Closeness& b, double where) {
    if (where == 0) return a;
    if (where == 1) return b;
    return {(1 - where) * a.share + where * b.share, a.slides && b.slides};
}

/// Asks for more around places where patches deviate: first for a smaller share, then for an end of sliding,
/// then for that farther around. \param places  of every patch \param closeness  by vertex index
void comeCloser(const QuadMesh& mesh, const Layout& layout, const DeviatingPlaces& places, double tolerance,
                std::vector<Closeness>& closeness);

} // namespace qm
