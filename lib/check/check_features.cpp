#include "check/check_sections.h"
#include "check/tracks/paths.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace qm::check {

namespace {

bool isClosed(const FeaturesPart::Curve& curve) {
    return curve.vertices.front() == curve.vertices.back();
}

void checkStraight(const Neighbourhoods& around, const FeaturesPart::Curve& curve, std::vector<int> steps,
                   const std::string& pointer, Report& report) {
    // A closed loop that is straight throughout goes on from its last edge to its first.
    if (isClosed(curve) && around.passable(curve.vertices.front())) steps.push_back(steps.front());
    const std::size_t bend = firstBend(around, steps);
    if (bend < steps.size())
        report.violate(below(pointer, std::min(bend + 1, curve.vertices.size() - 1)), "straight on",
                       "the curve does not go straight on across vertex " +
                           std::to_string(around.from(steps[bend])));
}

/// A step along the curve from its seed; -1 if the seed is not on it.
int seedStep(const Neighbourhoods& around, const std::vector<int>& steps, int seed) {
    for (const int step : steps)
        if (around.from(step) == seed) return step;
    return around.to(steps.back()) == seed ? around.back(steps.back()) : -1;
}

} // namespace

std::vector<int> checkFeatures(const Neighbourhoods& around, const FeaturesPart& part, Report& report) {
    std::vector<int> seedSteps;
    std::unordered_map<int, std::size_t> curveOfSeed;
    std::unordered_set<int> ids;
    for (std::size_t i = 0; i < part.curves.size(); ++i) {
        const auto& curve = part.curves[i];
        const std::string here = below("/features/curves", i);
        if (!ids.insert(curve.id).second) report.violate(below(here, "id"), "id", "another curve has it too");
        const auto steps = readPath(around, curve.vertices, below(here, "vertices"), report);
        if (!steps) continue;
        checkStraight(around, curve, *steps, below(here, "vertices"), report);

        const std::string seedPlace = below(here, "seed");
        if (!knownVertex(around, curve.seed, seedPlace, report)) continue;
        const int step = seedStep(around, *steps, curve.seed);
        if (step < 0) report.violate(seedPlace, "seed on curve", "the seed is no vertex of its curve");
        if (!around.passable(curve.seed))
            report.violate(seedPlace, "seed regular", "a seed must be a regular vertex inside the mesh");
        const auto [other, unique] = curveOfSeed.emplace(curve.seed, i);
        if (!unique)
            report.violate(seedPlace, "seed unique",
                           "it is also the seed of curve " + std::to_string(other->second));
        if (step >= 0 && around.passable(curve.seed) && unique) seedSteps.push_back(step);
    }
    return seedSteps;
}

} // namespace qm::check
