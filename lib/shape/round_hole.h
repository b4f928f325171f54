/// \file From square holes to round ones.
#pragma once

namespace qm {

/// A square hole in a square frame, both centred at the origin; the hole becomes a circle, the frame's
/// outside stays.
struct RoundHole {
    double hole = 0.5;   ///< half the side of the hole
    double frame = 1.5;  ///< half the side of the frame
    double radius = 0.5; ///< of the circle, smaller than `frame`

    struct Place {
        double x = 0;
        double y = 0;
    };
    /// How far out a point is: 0 on the hole's border, 1 on the frame's.
    [[nodiscard]] double outwardness(Place place) const;
    /// Where the point of the frame in this direction would be, that far out.
    [[nodiscard]] Place at(Place direction, double outwardness) const;
    /// Points outside the frame stay.
    [[nodiscard]] Place moved(Place place) const;
};

} // namespace qm
