/// \file The normals on which neighbouring patches can agree.
#pragma once

#include "bspline/border_curves.h"
#include "bspline/border_normals.h"
#include "bspline/surfaces.h"

#include <array>
#include <vector>

namespace qm {

/// On every smooth border edge, at `normalParameters`, the mean of the normals that the patches on both sides
/// have. When patches turn to it in turns, it moves to where the stiffer one of both is.
class AgreedNormals {
public:
    explicit AgreedNormals(const BorderCurves& curves);

    /// Takes over a patch's present normals.
    void update(std::size_t number, const Patch& patch);

    /// Along all borders of a patch; zero where a border is not smooth or the patches are opposed.
    [[nodiscard]] OnBorder<std::vector<Point>> of(std::size_t patch) const;

    /// The angles between a patch's normals and its neighbours', in degrees, at all places of its smooth
    /// borders.
    [[nodiscard]] std::vector<double> kinks(std::size_t patch) const;

private:
    static constexpr std::size_t perEdge = normalShares.size();
    template <class Visitor> void visitSide(std::size_t patch, int side, const Visitor& visit) const;

    /// Normals on both sides.
    using Pair = std::array<Point, 2>;

    const Chains& chains_;
    std::vector<std::vector<Pair>> normals_; ///< by chain and place; a pair is of the chain's ways
    std::vector<std::vector<bool>> smooth_;  ///< by chain and edge
};

} // namespace qm
