#include "mesh/extent.h"

#include "base/error.h"
#include "base/number_text.h"

#include <algorithm>

namespace qm {

void verifyExtent(const BoundingBox& box) {
    constexpr double smallest = 1e-30;
    constexpr double largest = 1e30;
    constexpr double farthest = 1e7;            // times the extent: 9 of 16 digits remain
    const double extent = box.size().max_abs(); // its square may be 0
    const double distance = std::max(box.low.max_abs(), box.high.max_abs());
    if (extent == 0) throw Error("", "all vertices lie at one place", "Is it another format?");
    if (extent < smallest || distance > largest)
        throw Error("",
                    "it is " + roundedText(extent) + " across, with coordinates up to " +
                        roundedText(distance) + ": too " + (extent < smallest ? "small" : "large") +
                        " to compute with",
                    "Scale the model");
    if (distance > farthest * extent)
        throw Error("",
                    "it is " + roundedText(extent) + " across and " + roundedText(distance) +
                        " away from the origin, where coordinates have too few digits",
                    "Move the model to the origin");
}

} // namespace qm
