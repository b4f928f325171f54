/// \file A length as users give it, "0.1%" or "0.05".
#pragma once

namespace qm {

struct Length {
    double value = 0;
    /// Whether it is relative to the bounding box's diagonal; otherwise in the mesh's unit.
    bool percent = true;

    [[nodiscard]] double length(double diagonal) const { return percent ? value / 100 * diagonal : value; }
    friend bool operator==(const Length&, const Length&) = default;
};

} // namespace qm
