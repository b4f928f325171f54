#include "export/boundary/face_order.h"

#include <GeomAbs_SurfaceType.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// Faces side by side around a vertex, with smooth edges between them.
using Fan = std::vector<std::size_t>;

/// The faces on both sides of an edge.
using Meeting = std::array<std::size_t, 2>;

/// The fans at one vertex; faces that close around it are none.
/// \param meetings  of its smooth edges
void addFans(const std::vector<Meeting>& meetings, std::vector<Fan>& fans) {
    std::map<std::size_t, std::vector<std::size_t>> neighbours;
    for (const Meeting& meeting : meetings)
        for (const std::size_t k : {0U, 1U})
            neighbours[meeting.at(k)].push_back(meeting.at(1 - k));
    std::set<std::size_t> isDone;
    for (const auto& [first, beside] : neighbours) {
        if (beside.size() > 1 || isDone.contains(first)) continue;
        Fan fan{first};
        for (std::size_t length = 0; length < fan.size();) {
            length = fan.size();
            isDone.insert(fan.back());
            for (const std::size_t face : neighbours[fan.back()])
                if (!isDone.contains(face)) fan.push_back(face);
        }
        fans.push_back(std::move(fan));
    }
}

/// Of three faces and more; two are neighbours in any order.
std::vector<Fan> fansOf(const Boundary& boundary) {
    const auto facesOf = facesOfEdges(boundary);
    std::vector<bool> isSharp(boundary.vertices.size());
    std::vector<std::vector<Meeting>> meetingsAt(boundary.vertices.size());
    for (std::size_t e = 0; e < boundary.edges.size(); ++e)
        for (const std::size_t vertex : boundary.edges[e].ends)
            if (boundary.edges[e].isSmooth && facesOf[e].size() == 2)
                meetingsAt[vertex].push_back({facesOf[e][0], facesOf[e][1]});
            else
                isSharp[vertex] = true;
    std::vector<Fan> fans;
    for (std::size_t vertex = 0; vertex < meetingsAt.size(); ++vertex)
        if (isSharp[vertex]) addFans(meetingsAt[vertex], fans);
    std::erase_if(fans, [](const Fan& fan) { return fan.size() < 3; });
    return fans;
}

/// Faces are listed in the order of their ranks, which change on the way.
struct Rank {
    int kind = 0;          ///< of its surface: planes come first
    int detached = 0;      ///< number of fans with faces that are listed, none of them a neighbour
    int minusAttached = 0; ///< minus the number of fans with a neighbour that is listed
    std::size_t face = 0;
    auto operator<=>(const Rank&) const = default; // NOLINT(modernize-use-nullptr): no pointer
};

/// Which faces are listed, and the ranks of the others.
class FaceOrder {
public:
    explicit FaceOrder(const Boundary& boundary)
        : fans_(fansOf(boundary)), isListed_(fans_.size()), places_(boundary.faces.size()) {
        for (std::size_t f = 0; f < boundary.faces.size(); ++f) {
            const auto kind = GeomAdaptor_Surface(boundary.faces[f].surface).GetType();
            ranks_.push_back({std::min<int>(kind, GeomAbs_BezierSurface), 0, 0, f});
        }
        for (std::size_t k = 0; k < fans_.size(); ++k)
            for (std::size_t p = 0; p < fans_[k].size(); ++p)
                places_[fans_[k][p]].push_back({k, p});
    }

    /// \param faces  of one part
    std::vector<std::size_t> order(const std::vector<std::size_t>& faces) {
        for (const std::size_t face : faces)
            unlisted_.insert(ranks_[face]);
        std::vector<std::size_t> result;
        while (!unlisted_.empty()) {
            result.push_back(unlisted_.begin()->face);
            unlisted_.erase(unlisted_.begin());
            for (const Place& place : places_[result.back()])
                list(place);
        }
        return result;
    }

private:
    struct Place {
        std::size_t fan = 0;
        std::size_t position = 0;
    };

    void list(const Place& place) {
        const Fan& fan = fans_[place.fan];
        std::vector<bool>& isListed = isListed_[place.fan];
        const bool isFirst = isListed.empty();
        isListed.resize(fan.size());
        isListed[place.position] = true;
        for (const std::size_t p : {place.position - 1, place.position + 1}) { // wraps below 0
            if (p >= fan.size() || isListed[p]) continue;
            const std::size_t beyond = 2 * p - place.position;
            const bool wasAttached = beyond < fan.size() && isListed[beyond];
            if (!wasAttached) change(fan[p], isFirst ? 0 : -1, -1);
        }
        if (!isFirst) return;
        for (std::size_t p = 0; p < fan.size(); ++p)
            if (p + 1 < place.position || p > place.position + 1) change(fan[p], 1, 0);
    }

    void change(std::size_t face, int detached, int minusAttached) {
        unlisted_.erase(ranks_[face]);
        ranks_[face].detached += detached;
        ranks_[face].minusAttached += minusAttached;
        unlisted_.insert(ranks_[face]);
    }

    std::vector<Fan> fans_;
    std::vector<std::vector<bool>> isListed_; ///< by fan and position; empty before the first
    std::vector<std::vector<Place>> places_;  ///< by face
    std::vector<Rank> ranks_;                 ///< by face
    std::set<Rank> unlisted_;
};

} // namespace

void orderFaces(Boundary& boundary) {
    FaceOrder order(boundary);
    for (BoundaryPart& part : boundary.parts)
        part.faces = order.order(part.faces);
}

} // namespace qm
