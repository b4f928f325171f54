#include "enumerate/enumerate.h"

#include "base/at.h"
#include "base/deadline.h"
#include "base/decimal.h"
#include "base/error.h"
#include "base/parallel.h"
#include "enumerate/paper/plain_graph.h"
#include "enumerate/sub_mesh_search.h"
#include "layout/corners.h"

#include <mutex>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// The product of the counts of all sub-meshes; none if one of them is unknown.
std::optional<std::string> countOfAll(const Enumeration& enumeration) {
    std::vector<std::string> counts;
    for (const SubMeshId subMesh : enumeration.subMeshes.ids()) {
        if (!enumeration.part.holds(subMesh)) continue;
        const auto& count = enumeration.subMeshes[subMesh].count;
        if (!count) return {};
        counts.push_back(*count);
    }
    return decimalProduct(counts);
}

/// Traces the plain motorcycle graph, which is one process on the whole mesh.
Enumeration enumeratePlain(const SearchedMesh& searched, const EnumerationOptions& options) {
    if (searched.subMeshes.count != 1)
        throw Error("/cut", "the plain motorcycle graph is traced on the whole mesh", "Leave qm-cut out");
    MotorcycleGraph graph = plainMotorcycleGraph(
        searched.mesh, searched.complex,
        edgeCosts(searched.mesh, searched.dihedralAngles, options.cost, searched.constraints));
    if (!obeyConstraints(searched.mesh, graph.tracks, searched.constraints))
        throw Error("/constraints", "the plain motorcycle graph does not obey them",
                    "Leave --method plain out");
    if (options.cost.terms.segments != 0)
        graph.cost += cornerCost(options.cost.terms) *
                      static_cast<double>(
                          Corners(searched.mesh, searched.subMeshes).between(graph.tracks, SubMeshId(0)));
    Enumeration result;
    result.subMeshes.push_back({graph.cost, std::nullopt, std::nullopt, {graph}, {}});
    return result;
}

void verifyAsked(const SubMeshes& subMeshes, const EnumerationOptions& options) {
    if (options.graphClass == GraphClass::motorcycle) return;
    if (subMeshes.count != 1)
        throw Error(
            "/cut",
            "class tmesh is searched on the whole mesh: its tracks are no particles' that could go on "
            "in another sub-mesh",
            "Leave qm-cut out");
    if (options.method != Method::optimum)
        throw Error("class tmesh", "only the method optimum knows it", "Leave --method out");
}

} // namespace

Enumeration enumerateGraphs(const SearchedMesh& searched, const EnumerationOptions& options,
                            const Control& control) {
    const SubMeshes& subMeshes = searched.subMeshes;
    verifyAsked(subMeshes, options);
    Enumeration result;
    if (options.method == Method::plain) {
        result = enumeratePlain(searched, options);
    } else {
        const SubMeshSearch search(searched, options);
        std::vector<SubMeshId> asked;
        for (const SubMeshId subMesh : subMeshes.ids())
            if (options.part.holds(subMesh)) asked.push_back(subMesh);
        const Deadline deadline(control, options.timeLimit);
        std::mutex mutex;
        std::size_t finished = 0;
        result.subMeshes.resize(at(subMeshes.count));
        parallelFor(asked.size(), control.jobs, [&](std::size_t k) {
            SubMeshSearch::Found found = search.search(asked[k], deadline.control());
            const std::lock_guard lock(mutex);
            result.subMeshes[asked[k]] = std::move(found.subMesh);
            result.complete = result.complete && found.complete;
            control.progress(static_cast<double>(++finished) / static_cast<double>(asked.size()));
        });
    }
    result.cost = options.cost;
    result.graphClass = options.graphClass;
    result.method = options.method;
    result.part = options.part;
    result.count = countOfAll(result);
    return result;
}

bool listGraphs(const SearchedMesh& searched, const EnumerationOptions& options, ListedGraphs which,
                const GraphListing& listing, const Control& control) {
    const SubMeshes& subMeshes = searched.subMeshes;
    verifyAsked(subMeshes, options);
    const SubMeshSearch search(searched, options);
    const Deadline deadline(control, options.timeLimit);
    const Control limited = deadline.control();
    for (const SubMeshId subMesh : subMeshes.ids()) {
        if (options.part.holds(subMesh) && !search.list(subMesh, which, listing, limited)) return false;
        control.progress((subMesh.value() + 1.0) / subMeshes.count);
    }
    return true;
}

} // namespace qm
