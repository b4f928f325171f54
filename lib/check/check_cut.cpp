#include "base/at.h"
#include "base/number_text.h"
#include "check/check_sections.h"
#include "check/tracks/paths.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace qm::check {

bool checkLabels(const Neighbourhoods& around, const CutPart& part, Report& report) {
    const std::string place = "/cut/labels";
    const std::size_t before = report.total();
    if (part.subMeshes.empty()) report.violate("/cut/subMeshes", "sub-meshes", "there is none");
    if (part.labels.size() != at(around.vertices()))
        report.violate(place, "labels complete",
                       "there are " + std::to_string(part.labels.size()) + " labels for " +
                           std::to_string(around.vertices()) + " vertices");
    std::vector<char> used(part.subMeshes.size(), 0);
    for (std::size_t v = 0; v < part.labels.size(); ++v) {
        if (part.labels[v] >= 0 && at(part.labels[v]) < used.size())
            used[at(part.labels[v])] = 1;
        else
            report.violate(below(place, v), "label", "there is no sub-mesh of this number");
    }
    const bool usable = report.total() == before;
    for (std::size_t k = 0; k < used.size(); ++k)
        if (!used[k])
            report.violate(below("/cut/subMeshes", k), "sub-mesh empty", "no vertex bears its label");
    return usable;
}

void checkSubMeshes(const Neighbourhoods& around, const std::vector<LineNetwork>& networks,
                    const CutPart& part, Report& report) {
    for (std::size_t k = 0; k < part.subMeshes.size(); ++k) {
        const auto& subMesh = part.subMeshes[k];
        const LineNetwork& network = networks[k];
        const std::string here = below("/cut/subMeshes", k);
        checkNumber(subMesh.id, k, here, "sub-meshes", report);
        const double complexity = quasiComplexity(network);
        if (subMesh.quasiComplexity &&
            !(std::abs(*subMesh.quasiComplexity - complexity) <= 1e-6 * std::max(1.0, complexity)))
            report.violate(below(here, "quasiComplexity"), "U", "it is " + numberText(complexity));
        if (subMesh.ordinaryJunctions &&
            std::cmp_not_equal(*subMesh.ordinaryJunctions, network.ordinaryJunctions))
            report.violate(below(here, "ordinaryJunctions"), "n_j",
                           "it has " + std::to_string(network.ordinaryJunctions));
        if (subMesh.source) knownVertex(around, *subMesh.source, below(here, "source"), report);
        if (subMesh.sink) knownVertex(around, *subMesh.sink, below(here, "sink"), report);
    }
}

} // namespace qm::check
