#include "base/at.h"
#include "base/positions.h"
#include "document/options/options_json.h"
#include "document/sections/enumeration_section.h"
#include "document/sections/mesh_paths.h"
#include "layout/corners.h"
#include "layout/tracks.h"

#include <algorithm>
#include <optional>
#include <unordered_set>

namespace qm {
namespace {

std::optional<std::string> readCount(const JsonPlace& place) {
    constexpr std::size_t maxDigits = 100000; // longer numbers take other programs quadratic time to convert
    if (place.isNull()) return {};
    const std::string& text = place.text();
    const bool digits = text.find_first_not_of("0123456789") == std::string::npos;
    if (!digits || text.empty() || (text.size() > 1 && text.front() == '0') || text.size() > maxDigits)
        place.fail("is no whole number in decimal digits without leading zeros");
    return text;
}

class Reader {
public:
    Reader(const EnumerationContext& context, GraphClass graphClass)
        : context_(context), mesh_(context.mesh), graphClass_(graphClass),
          ofBaseComplex_(mesh_, context.baseComplex), ofComplex_(mesh_, context.complex),
          onLine_(edgesOnLines(mesh_, context.complex)) {
        if (context.terms.segments != 0) corners_.emplace(mesh_, context.subMeshes);
    }

    SubMeshGraphs subMesh(const JsonPlace& place, SubMeshId id) {
        SubMeshGraphs result;
        result.lowerBound = place["lowerBound"].numberOrNull();
        if (const auto count = place.find("count")) result.count = readCount(*count);
        const JsonPlace graphs = place["graphs"];
        for (std::size_t i = 0; i < graphs.size(); ++i) {
            result.graphs.push_back(graph(graphs[i], id));
            if (i > 0 && result.graphs[i].cost < result.graphs[i - 1].cost &&
                !sameCost(result.graphs[i].cost, result.graphs[i - 1].cost))
                graphs.failAt(i, "costs less than the graph before it", "Put the cheapest first");
        }
        if (!result.graphs.empty()) result.cost = result.graphs.front().cost;
        verifyCost(place, result.cost);
        if (result.cost && result.lowerBound && *result.lowerBound > *result.cost &&
            !sameCost(*result.lowerBound, *result.cost))
            place["lowerBound"].fail("is above the cost of the first graph",
                                     "Set it to null, or run qm-enum again");
        if (const auto samples = place.find("samples"))
            for (const JsonPlace& sample : samples->elements())
                result.samples.push_back(graph(sample, id));
        return result;
    }

private:
    MotorcycleGraph graph(const JsonPlace& place, SubMeshId id) {
        MotorcycleGraph result;
        std::unordered_set<int> edges;
        for (const JsonPlace& trackPlace : place["tracks"].elements()) {
            result.add(track(trackPlace, id));
            const std::vector<HalfedgeId>& path = result.tracks.back().halfedges;
            for (std::size_t k = 0; k < path.size(); ++k)
                if (!edges.insert(mesh_.edge_handle(path[k]).idx()).second)
                    trackPlace["vertices"].failAt(k + 1, "the edge to this vertex lies on a track already");
        }
        if (corners_)
            result.cost +=
                cornerCost(context_.terms) * static_cast<double>(corners_->between(result.tracks, id));
        verifyCost(place, result.cost);
        return result;
    }

    Track track(const JsonPlace& place, SubMeshId id) {
        const JsonPlace vertices = place["vertices"];
        Track result = trackOf(mesh_, pathAt(mesh_, vertices), context_.edgeCosts);
        verifySource(place, result.halfedges.front());
        if (graphClass_ == GraphClass::tmesh)
            verifyOnLines(vertices, result.halfedges);
        else
            verifyWay(vertices, result.halfedges);
        verifyStartsInside(vertices, result.halfedges, id);
        return result;
    }

    void verifySource(const JsonPlace& place, HalfedgeId first) const {
        if (const auto separatrix = place.find("separatrix")) {
            if (separatrix->whole(0) != ofBaseComplex_.startingWith(first).value())
                separatrix->fail("is not the separatrix that begins with the track's first edge");
        }
        if (const auto source = place.find("source")) {
            if (vertexAt(mesh_, *source) != mesh_.from_vertex_handle(first))
                source->fail("is not the first vertex of the track");
        }
    }

    void verifyWay(const JsonPlace& vertices, const std::vector<HalfedgeId>& path) const {
        const SeparatrixId id = ofComplex_.startingWith(path.front());
        if (!id.valid()) vertices.failAt(0, "no particle starts here in this direction");
        const std::vector<HalfedgeId>& way = context_.complex.separatrices[id].halfedges;
        const std::size_t same =
            positionIn(path, std::mismatch(path.begin(), path.end(), way.begin(), way.end()).first);
        if (same < path.size())
            vertices.failAt(same + 1, same == way.size() ? "the particle's way ends before this vertex"
                                                         : "the particle's way does not turn to this vertex");
    }

    void verifyOnLines(const JsonPlace& vertices, const std::vector<HalfedgeId>& path) const {
        requireStraight(mesh_, path, vertices);
        for (std::size_t k = 0; k < path.size(); ++k)
            if (!onLine_[at(mesh_.edge_handle(path[k]))])
                vertices.failAt(k + 1, "the edge to this vertex lies on no separatrix");
    }

    /// If a line leaves a sub-mesh and returns over the same vertex, one track may cover both stretches.
    void verifyStartsInside(const JsonPlace& vertices, const std::vector<HalfedgeId>& path,
                            SubMeshId id) const {
        if (context_.subMeshes.of(mesh_.from_vertex_handle(path.front())) != id)
            vertices.failAt(0, "the track starts in another sub-mesh");
    }

    const EnumerationContext& context_;
    const QuadMesh& mesh_;
    GraphClass graphClass_;
    SeparatrixIndex ofBaseComplex_;
    SeparatrixIndex ofComplex_;
    std::vector<bool> onLine_;       ///< of every edge, whether it lies on a separatrix
    std::optional<Corners> corners_; ///< only if corners have a cost
};

} // namespace

GraphCost readCost(const JsonPlace& section) {
    GraphCost cost{{section["alpha"].number(), section["epsilon"].number()}, {}};
    if (const auto terms = section.find("terms"))
        forEachTerm(cost.terms, [&](const char* name, double& weight) {
            if (const auto given = terms->find(name)) weight = given->number();
        });
    return cost;
}

Enumeration readEnumeration(const EnumerationContext& context, const JsonPlace& section) {
    if (const auto part = section.find("part"))
        part->fail("is one of several parts of a search", "Unite them with qm-enum --join");
    Enumeration result;
    result.cost = readCost(section);
    if (const auto given = section.find("class")) readChoice(*given, result.graphClass);
    if (result.graphClass == GraphClass::tmesh && context.subMeshes.count != 1)
        section["class"].fail("is tmesh, but the mesh is cut", "Run qm-enum again");
    readChoice(section["method"], result.method);
    result.count = readCount(section["count"]);
    result.complete = section["complete"].boolean();

    const JsonPlace subMeshes = section["subMeshes"];
    if (subMeshes.size() != at(context.subMeshes.count))
        subMeshes.fail("has " + std::to_string(subMeshes.size()) + " entries, the mesh is cut into " +
                       std::to_string(context.subMeshes.count));
    Reader reader(context, result.graphClass);
    for (std::size_t i = 0; i < subMeshes.size(); ++i) {
        verifyPositionId(subMeshes[i], i);
        result.subMeshes.push_back(reader.subMesh(subMeshes[i], SubMeshId(i)));
    }
    return result;
}

} // namespace qm
