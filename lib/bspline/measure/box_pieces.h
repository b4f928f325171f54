/// \file The polynomials of which a surface consists over a rectangle of parameters.
#pragma once

#include "bspline/measure/paired_surfaces.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace qm {

/// The ends along u and along v.
using ParameterBox = std::array<std::array<double, 2>, 2>;

/// A part of a box over which the surface is one polynomial.
struct BoxPiece {
    const BezierPiece& piece;    ///< over this part alone
    std::array<double, 2> width; ///< of the part, along u and v
    std::array<std::array<bool, 2>, 2>
        isAtEnd; ///< along u and v: whether it touches the first and the last side of the box
};

/// Reuses its memory, so every thread needs its own.
class BoxPieces {
public:
    explicit BoxPieces(const PairedSurfaces& surfaces) : surfaces_(surfaces) {}

    /// \param box       within the patch
    /// \param function  called with every `BoxPiece`
    /// \return false, without any call, if there are too many pieces for a useful bound
    template <class Function>
    bool visit(std::size_t surface, std::size_t patch, const ParameterBox& box, const Function& function) {
        const Cell first = surfaces_.cellAt({patch, {box[0][0], box[1][0]}});
        const Cell last = surfaces_.cellAt({patch, {box[0][1], box[1][1]}});
        constexpr std::size_t many = 9;
        constexpr double minWidth = 1e-12; // where a box only touches a cell: derivatives are divided by it
        if ((last.interval[0] - first.interval[0] + 1) * (last.interval[1] - first.interval[1] + 1) > many)
            return false;
        Cell cell = first;
        for (auto& row = cell.interval[1] = first.interval[1]; row <= last.interval[1]; ++row)
            for (auto& column = cell.interval[0] = first.interval[0]; column <= last.interval[0]; ++column) {
                std::array<double, 2> begin{};
                std::array<double, 2> end{};
                BoxPiece result{part_, {}, {}};
                for (std::size_t k = 0; k < 2; ++k) {
                    const auto [from, to] = surfaces_.range(cell, k);
                    begin[k] = std::clamp((box[k][0] - from) / (to - from), 0.0, 1.0);
                    end[k] = std::clamp((box[k][1] - from) / (to - from), 0.0, 1.0);
                    result.width[k] = (to - from) * std::max(end[k] - begin[k], minWidth);
                    result.isAtEnd[k] = {cell.interval[k] == first.interval[k],
                                         cell.interval[k] == last.interval[k]};
                }
                surfaces_.get(surface, cell, cell_);
                restrict(cell_, begin, end, part_);
                function(result);
            }
        return true;
    }

private:
    const PairedSurfaces& surfaces_;
    BezierPiece cell_;
    BezierPiece part_;
};

} // namespace qm
