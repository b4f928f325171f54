#include "check/tracks/check_segments.h"

#include "base/at.h"
#include "base/positions.h"

#include <algorithm>

namespace qm::check {

namespace {

/// Turns the vertices of a face so that it begins with `first`.
/// \return false if that is none of them
bool turn(std::array<int, 4>& quad, int first) {
    const auto found = std::ranges::find(quad, first);
    std::rotate(quad.begin(), found, quad.end());
    return quad.front() == first;
}

bool sizeFits(const LayoutPart::Segment& segment) {
    const auto [a, b] = segment.size;
    return a >= 1 && b >= 1 && at(a) * at(b) == segment.faces.size();
}

} // namespace

std::vector<int> gridOf(const CheckedMesh& mesh, const LayoutPart::Segment& segment,
                        const std::string& pointer, Report& report) {
    if (!sizeFits(segment)) {
        report.violate(below(pointer, "faces"), "grid", "a grid of this size has another number of faces");
        return {};
    }
    const std::size_t columns = at(segment.size[0]);
    const std::size_t width = columns + 1;
    std::vector<int> grid(width * (at(segment.size[1]) + 1), -1);
    grid[0] = segment.corners[0];
    for (std::size_t f = 0; f < segment.faces.size(); ++f) {
        const std::string here = below(pointer, "faces", f);
        const int face = segment.faces[f];
        if (face < 0 || at(face) >= mesh.quads.size()) {
            report.violate(here, "face", "the mesh has no face of this number");
            return {};
        }
        const std::size_t corner = f / columns * width + f % columns;
        auto quad = mesh.quads[at(face)];
        bool fits = turn(quad, grid[corner]);
        const std::array<std::size_t, 4> places{corner, corner + 1, corner + 1 + width, corner + width};
        for (std::size_t i = 1; i < 4 && fits; ++i) {
            int& vertex = grid[places[i]];
            fits = vertex < 0 || vertex == quad[i];
            vertex = quad[i];
        }
        if (!fits) {
            report.violate(here, "grid", "this face does not join the faces before it as a grid");
            return {};
        }
    }
    return grid;
}

std::vector<int> soundGridOf(const CheckedMesh& mesh, const LayoutPart::Segment& segment) {
    Report unused;
    return gridOf(mesh, segment, "", unused);
}

namespace {

class SegmentCheck {
public:
    SegmentCheck(const CheckedMesh& mesh, const Neighbourhoods& around, std::span<const char> onTrack,
                 const LayoutPart& part, Report& report)
        : mesh_(mesh), around_(around), onTrack_(onTrack), part_(part), report_(report),
          segmentOf_(at(around.faces()), -1), inside_(at(around.edges()), 0) {}

    void run() {
        for (std::size_t s = 0; s < part_.segments.size(); ++s)
            segment(s);
        everyFace();
        borders();
    }

private:
    void segment(std::size_t s) {
        const auto& segment = part_.segments[s];
        const std::string here = below("/layout/segments", s);
        checkNumber(segment.id, s, here, "segments", report_);
        for (std::size_t f = 0; f < segment.faces.size(); ++f) {
            const int face = segment.faces[f];
            if (face < 0 || face >= around_.faces()) continue; // the grid reports it
            int& owner = segmentOf_[at(face)];
            if (owner >= 0)
                report_.violate(below(here, "faces", f), "tiling",
                                "the face lies also in segment " + std::to_string(owner));
            owner = static_cast<int>(s);
        }
        const auto grid = gridOf(mesh_, segment, here, report_);
        if (grid.empty()) return;
        sides(segment, grid, here);
        markInside(segment, grid);
    }

    /// Side k leads from corner k to corner k + 1 along the grid's border, faces on the left.
    void sides(const LayoutPart::Segment& segment, const std::vector<int>& grid, const std::string& here) {
        const std::size_t a = at(segment.size[0]);
        const std::size_t b = at(segment.size[1]);
        const std::size_t width = a + 1;
        std::array<std::vector<int>, 4> border;
        for (std::size_t i = 0; i <= a; ++i) {
            border[0].push_back(grid[i]);
            border[2].push_back(grid[b * width + a - i]);
        }
        for (std::size_t j = 0; j <= b; ++j) {
            border[1].push_back(grid[j * width + a]);
            border[3].push_back(grid[(b - j) * width]);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            if (segment.corners[k] != border[k].front())
                report_.violate(below(here, "corners", k), "corner",
                                "the grid's corner is vertex " + std::to_string(border[k].front()));
            const auto& side = segment.sides[k];
            const auto differs = std::mismatch(side.begin(), side.end(), border[k].begin(), border[k].end());
            if (differs.first == side.end() && differs.second == border[k].end()) continue;
            const std::string list = below(here, "sides", k);
            if (differs.first == side.end() || differs.second == border[k].end())
                report_.violate(list, "side",
                                "the grid's side has " + std::to_string(border[k].size()) + " vertices");
            else
                report_.violate(below(list, positionIn(side, differs.first)), "side",
                                "the grid's side has vertex " + std::to_string(*differs.second) + " here");
        }
    }

    /// Marks the edges between two faces of the grid.
    void markInside(const LayoutPart::Segment& segment, const std::vector<int>& grid) {
        const std::size_t a = at(segment.size[0]);
        const std::size_t b = at(segment.size[1]);
        const std::size_t width = a + 1;
        const auto mark = [&](std::size_t from, std::size_t to) {
            inside_[at(around_.edge(around_.stepBetween(grid[from], grid[to])))] = 1;
        };
        for (std::size_t j = 0; j < b; ++j)
            for (std::size_t i = 1; i < a; ++i)
                mark(j * width + i, (j + 1) * width + i);
        for (std::size_t j = 1; j < b; ++j)
            for (std::size_t i = 0; i < a; ++i)
                mark(j * width + i, j * width + i + 1);
    }

    void everyFace() {
        for (int face = 0; face < around_.faces(); ++face)
            if (segmentOf_[at(face)] < 0)
                report_.violate("/layout/segments", "tiling",
                                "face " + std::to_string(face) + " lies in no segment");
    }

    void borders() {
        for (int step = 0; step < around_.steps(); ++step) {
            const std::size_t edge = at(around_.edge(step));
            if (around_.from(step) > around_.to(step) || around_.boundary(step)) continue;
            const int left = segmentOf_[at(around_.leftFace(step))];
            if (left < 0) continue;
            if ((inside_[edge] != 0) == (onTrack_[edge] != 0))
                report_.violate(below("/layout/segments", at(left)), "border",
                                "the edge between vertices " + std::to_string(around_.from(step)) + " and " +
                                    std::to_string(around_.to(step)) +
                                    (inside_[edge] ? " is inside, on a track" : " is border, on no track"));
        }
    }

    const CheckedMesh& mesh_;
    const Neighbourhoods& around_;
    std::span<const char> onTrack_;
    const LayoutPart& part_;
    Report& report_;
    std::vector<int> segmentOf_; ///< by face
    std::vector<char> inside_;   ///< by edge
};

} // namespace

void checkSegments(const CheckedMesh& mesh, const Neighbourhoods& around, std::span<const char> onTrack,
                   const LayoutPart& part, Report& report) {
    SegmentCheck(mesh, around, onTrack, part, report).run();
}

} // namespace qm::check
