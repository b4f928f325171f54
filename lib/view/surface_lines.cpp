#include "base/at.h"
#include "layout/sides.h"
#include "view/layers.h"
#include "view/surface_samples.h"

#include <cmath>

namespace qm {
namespace {

/// The lattice on all patches, whose points are numbered throughout.
class Lattice {
public:
    Lattice(const std::vector<Segment>& segments, std::size_t steps) : steps_(steps) {
        std::size_t first = 0;
        for (const Segment& segment : segments) {
            parts_.push_back({first, segment.size});
            first += width(segment.size[0]) * width(segment.size[1]);
        }
    }

    /// \param along  mesh edges from the beginning of the side, walking round the patch, times `steps`
    [[nodiscard]] std::uint32_t onSide(std::size_t patch, int side, std::size_t along) const {
        const auto& [first, size] = parts_[patch];
        const std::size_t right = width(size[0]) - 1, top = width(size[1]) - 1;
        const auto [i, j] = placeOnSide<std::size_t>({right, top}, side, along);
        return static_cast<std::uint32_t>(first + j * (right + 1) + i);
    }
    [[nodiscard]] std::size_t steps() const { return steps_; }

private:
    [[nodiscard]] std::size_t width(int edges) const { return at(edges) * steps_ + 1; }

    struct Part {
        std::size_t first;
        std::array<int, 2> size;
    };
    std::vector<Part> parts_;
    std::size_t steps_;
};

/// The four sides of every patch.
LineLayer borderCurves(const std::vector<Segment>& segments, const Lattice& lattice) {
    LineLayer curves = newLines("curves", "borders of patches", "border", "");
    curves.base = Base::surfaces;
    for (std::size_t k = 0; k < segments.size(); ++k)
        for (int side = 0; side < 4; ++side) {
            const std::size_t edges = at(segments[k].size[directionAlong(side)]);
            for (std::size_t along = 0; along <= edges * lattice.steps(); ++along)
                curves.points.push_back(lattice.onSide(k, side, along));
            endItem(curves);
            addFigure(curves.items, "of patch", k);
            addFigure(curves.items, "side", side);
        }
    return curves;
}

/// The smooth borders, each as long as a mesh edge.
LineLayer smoothBorders(const Viewed& viewed, const Lattice& lattice, const BorderMarks& marks) {
    LineLayer jumps = newLines("jumps", "normal angle across smooth borders", "piece of a smooth border", "");
    jumps.base = Base::surfaces;
    jumps.mapped = {Scale::rising,           {},       "angle between normals, degrees",
                    "angle between normals", "\u00b0", viewed.maxNormalAngle};
    const auto borders = borderEdges(viewed.mesh, *viewed.layout);
    const auto angles = normalAngles(viewed.mesh, *viewed.layout, viewed.surfaces->patches, borders, marks);
    for (std::size_t k = 0; k < borders.size(); ++k) {
        if (std::isnan(angles[k])) continue;
        const BorderPlace& place = borders[k].places.front();
        const std::size_t begin = at(place.position) * lattice.steps();
        for (std::size_t along = begin; along <= begin + lattice.steps(); ++along)
            jumps.points.push_back(lattice.onSide(place.patch, place.side, along));
        endItem(jumps);
        addFigure(jumps.items, "between patch", place.patch);
        addFigure(jumps.items, "and patch", borders[k].places.back().patch);
        addFigure(jumps.items, "angle between normals, degrees", angles[k]);
        jumps.items.columns.back().rough = true;
    }
    return jumps;
}

/// Nets and knots are drawn of the patches themselves.
LineLayer derivedLines(const char* name, const char* title, Base base, const char* noun) {
    auto lines = newLayer<LineLayer>(name, title, noun);
    lines.base = base;
    return lines;
}

} // namespace

void addSurfaceLines(Scene& scene, const Viewed& viewed, const BorderMarks& marks) {
    const std::vector<Segment>& segments = viewed.layout->segments;
    const Lattice lattice(segments, scene.patches.steps);
    scene.lines.push_back(borderCurves(segments, lattice));
    scene.lines.push_back(smoothBorders(viewed, lattice, marks));
    scene.lines.push_back(derivedLines("net", "control nets", Base::net, "control net"));
    scene.lines.push_back(derivedLines("knots", "knot lines", Base::knots, "knot line"));
}

} // namespace qm
