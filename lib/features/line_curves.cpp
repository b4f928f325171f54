#include "features/line_curves.h"

#include "base/at.h"
#include "mesh/roundness.h"
#include "mesh/topology.h"

#include <algorithm>

namespace qm {
namespace {

/// Finds the curves of one line.
class LineSearch {
public:
    LineSearch(const MeshLine& line, const SharpMesh& sharp)
        : sharp_(sharp), mesh_(sharp.mesh), options_(sharp.options), line_(line),
          count_(static_cast<int>(line.halfedges.size())) {
        for (const HalfedgeId halfedge : line.halfedges)
            lengthUpTo_.push_back(lengthUpTo_.back() + mesh_.calc_edge_length(halfedge));
    }

    void addTo(std::vector<FeatureCurve>& curves) const {
        for (const Run& run : runs({0, count_}, options_.rho)) {
            if (run.edges() >= options_.tau) {
                addSections(run, curves);
                continue;
            }
            for (const Run& part : runs(run, options_.shortRho))
                if (isHeld(part)) addSections(part, curves);
        }
    }

private:
    /// Edges of the line, by their positions; on a closed line, these continue beyond its end.
    struct Run {
        int begin, end;
        [[nodiscard]] int edges() const { return end - begin; }
    };

    /// \param k  on a closed line, up to twice their number
    [[nodiscard]] HalfedgeId halfedgeAt(int k) const {
        return line_.halfedges[at(k < count_ ? k : k - count_)];
    }

    [[nodiscard]] double angle(HalfedgeId halfedge) const {
        return sharp_.dihedralAngles[at(mesh_.edge_handle(halfedge))];
    }

    [[nodiscard]] bool isAllRound(const Run& run) const { return line_.closed && run.edges() == count_; }

    /// All maximal runs of edges sharper than rho within another run.
    [[nodiscard]] std::vector<Run> runs(Run within, double rho) const {
        const auto isSharp = [&](int k) { return angle(halfedgeAt(k)) > rho; };
        if (isAllRound(within)) { // begin where no run is divided
            int blunt = 0;
            while (blunt < count_ && isSharp(blunt))
                ++blunt;
            if (blunt == count_) return {within};
            within = {blunt, blunt + count_};
        }
        std::vector<Run> result;
        for (int k = within.begin; k < within.end; ++k) {
            if (!isSharp(k)) continue;
            if (result.empty() || result.back().end < k) result.push_back({k, k});
            result.back().end = k + 1;
        }
        return result;
    }

    /// Whether both ends of a run are held, or it has none.
    [[nodiscard]] bool isHeld(const Run& run) const {
        return isAllRound(run) || (isHeld(mesh_.opposite_halfedge_handle(halfedgeAt(run.begin))) &&
                                   isHeld(halfedgeAt(run.end - 1)));
    }

    /// Whether a curve that arrives there ends at the boundary, or at edges that are as sharp.
    [[nodiscard]] bool isHeld(HalfedgeId arriving) const {
        const VertexId vertex = mesh_.to_vertex_handle(arriving);
        if (mesh_.is_boundary(vertex)) return true;
        const HalfedgeId back = mesh_.opposite_halfedge_handle(arriving);
        return std::ranges::any_of(mesh_.voh_range(vertex), [&](HalfedgeId leaving) {
            return leaving != back && angle(leaving) > options_.shortRho;
        });
    }

    [[nodiscard]] bool isFarFromSources(const Run& run) const {
        if (line_.closed) return true;
        const auto isFar = [this](VertexId lineEnd, const Run& between) {
            return isRegular(mesh_, lineEnd) ||
                   (between.edges() > options_.zeta && lengthOf(between) >= sharp_.minDistance);
        };
        return (isFar(mesh_.from_vertex_handle(line_.halfedges.front()), {0, run.begin}) ||
                isCrossed(mesh_.opposite_halfedge_handle(halfedgeAt(run.begin)))) &&
               (isFar(mesh_.to_vertex_handle(line_.halfedges.back()), {run.end, count_}) ||
                isCrossed(halfedgeAt(run.end - 1)));
    }

    /// Whether a sharp line crosses where a curve arrives. Its track stops whatever comes from beyond, so
    /// that sources there are of no use to the curve.
    [[nodiscard]] bool isCrossed(HalfedgeId arriving) const {
        if (!continuesStraight(mesh_, mesh_.to_vertex_handle(arriving))) return false;
        const HalfedgeId back = mesh_.opposite_halfedge_handle(arriving);
        const auto [blunter, sharper] = std::minmax(
            {angle(mesh_.cw_rotated_halfedge_handle(back)), angle(mesh_.ccw_rotated_halfedge_handle(back))});
        return blunter > options_.rho && sharper > options_.shortRho;
    }

    [[nodiscard]] double lengthOf(const Run& run) const {
        const auto lengthUpTo = [this](int position) {
            const std::size_t count = line_.halfedges.size(), turns = at(position) / count;
            return static_cast<double>(turns) * lengthUpTo_.back() + lengthUpTo_[at(position) % count];
        };
        return lengthUpTo(run.end) - lengthUpTo(run.begin);
    }

    [[nodiscard]] std::vector<HalfedgeId> halfedgesOf(const Run& run) const {
        std::vector<HalfedgeId> halfedges;
        for (int k = run.begin; k < run.end; ++k)
            halfedges.push_back(halfedgeAt(k));
        return halfedges;
    }

    /// Adds what a run is divided into where sharp lines cross, if it is long and no line of a round part. No
    /// graph has all of a net of lines, as each is cracked once at most; with a seed in every section the
    /// sections are lines of their own.
    void addSections(Run run, std::vector<FeatureCurve>& curves) const {
        if (lengthOf(run) < sharp_.minLength) return;
        if (roundness(mesh_, halfedgesOf(run)) > options_.maxRoundness) return;
        if (isAllRound(run)) run = fromCrossing();
        // Every section has a vertex for its seed that no sharp line crosses.
        const auto isFree = [&](int k) { return !isCrossed(halfedgeAt(k - 1)); };
        int lastFree = run.end - 1;
        while (lastFree > run.begin && !isFree(lastFree))
            --lastFree;
        bool hasFree = false;
        Run section{run.begin, run.begin};
        while (section.end < run.end) {
            ++section.end;
            const bool isHere = section.end < run.end && isFree(section.end);
            hasFree = hasFree || isHere;
            const bool divides = hasFree && !isHere && section.end < lastFree;
            if (section.end < run.end && !divides) continue;
            hasFree = false;
            if (isFarFromSources(section))
                curves.push_back({.halfedges = halfedgesOf(section), .seed = VertexId()});
            section.begin = section.end;
        }
    }

    /// All of a closed line, from the first place where it can be divided.
    [[nodiscard]] Run fromCrossing() const {
        int begin = 0;
        while (begin < count_ && !isCrossed(halfedgeAt(begin + count_ - 1)))
            ++begin;
        begin %= count_;
        return {begin, begin + count_};
    }

    const SharpMesh& sharp_;
    const QuadMesh& mesh_;
    const FeatureOptions& options_;
    const MeshLine& line_;
    int count_;                         ///< of its edges
    std::vector<double> lengthUpTo_{0}; ///< from the line's beginning to every position
};

} // namespace

void addCurvesOf(const MeshLine& line, const SharpMesh& sharp, std::vector<FeatureCurve>& curves) {
    LineSearch(line, sharp).addTo(curves);
}

} // namespace qm
