/// \file The polynomials of which a surface consists over a rectangle of parameters.
#pragma once

#include "bspline/measure/paired_surfaces.h"

#include <boost/container/static_vector.hpp>

#include <array>
#include <cstddef>

namespace qm {

/// A part of a box over which the surface is one polynomial. Directions are those of the box's patch.
struct BoxPiece {
    const BezierPiece& piece;    ///< over this part alone
    std::array<double, 2> width; ///< of the part, along u and v
    /// Along u and v: whether it touches the first and the last side of the box.
    std::array<std::array<bool, 2>, 2> isAtEnd;
};

/// A part of a box that lies in one patch.
struct BoxPart {
    std::size_t patch = 0;
    ParameterBox box; ///< in this patch's parameters
    int turns = 0;    ///< counter-clockwise quarters from directions of the box to those of this patch
    std::array<std::array<bool, 2>, 2> isAtEnd; ///< as of `BoxPiece`
};

/// The own one, and one beyond either end of a direction.
using BoxParts = boost::container::static_vector<BoxPart, 3>;

/// Divides a box among patches. What reaches beyond a side of its own patch continues in the neighbour, if
/// only one lies there and meets it, for as far as that reaches; what is left over is cut off. A box that
/// reaches beyond two neighbouring sides continues beyond one of them.
/// \param patch  whose parameters those of the box are
[[nodiscard]] BoxParts boxParts(const PairedSurfaces& surfaces, std::size_t patch, const ParameterBox& box);

/// Reuses its memory, so every thread needs its own.
class BoxPieces {
public:
    explicit BoxPieces(const PairedSurfaces& surfaces) : surfaces_(surfaces), cell_(surfaces) {}

    /// \param box       divided by `boxParts`
    /// \param function  called with every `BoxPiece`
    /// \return false, without any call, if there are too many pieces for a useful bound
    template <class Function>
    bool visit(std::size_t surface, std::size_t patch, const ParameterBox& box, const Function& function) {
        const BoxParts parts = boxParts(surfaces_, patch, box);
        constexpr std::size_t many = 9;
        std::size_t number = 0;
        for (const BoxPart& part : parts)
            number += cellsOf(part).number();
        if (number > many) return false;
        for (const BoxPart& part : parts) {
            const Cells cells = cellsOf(part);
            for (std::size_t row = cells.first[1]; row <= cells.last[1]; ++row)
                for (std::size_t column = cells.first[0]; column <= cells.last[0]; ++column)
                    function(take(surface, part, cells, {column, row}));
        }
        return true;
    }

private:
    /// Those that a part touches.
    struct Cells {
        std::array<std::size_t, 2> first;
        std::array<std::size_t, 2> last;

        [[nodiscard]] std::size_t number() const {
            return (last[0] - first[0] + 1) * (last[1] - first[1] + 1);
        }
    };

    [[nodiscard]] Cells cellsOf(const BoxPart& part) const;
    [[nodiscard]] BoxPiece take(std::size_t surface, const BoxPart& part, const Cells& cells,
                                const std::array<std::size_t, 2>& interval);

    const PairedSurfaces& surfaces_;
    LastPiece cell_;
    BezierPiece restricted_;
    BezierPiece piece_;
};

} // namespace qm
