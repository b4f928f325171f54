#include "bspline/fitting/planes/tied_points.h"

#include "base/disjoint_sets.h"

#include <utility>

namespace qm {
namespace {

bool isTie(const LinearForm& equation) {
    return equation.unknowns.size() == 2 && equation.weights[0] == -equation.weights[1];
}

} // namespace

TiedPoints tiedPoints(std::size_t count, const std::vector<LinearForm>& equations) {
    DisjointSets ties(count);
    for (const LinearForm& equation : equations)
        if (isTie(equation)) ties.join(equation.unknowns[0], equation.unknowns[1]);
    TiedPoints tied;
    tied.setOf.resize(count);
    for (std::size_t point = 0; point < count; ++point) {
        const std::size_t first = ties.find(point);
        if (first == point) {
            tied.setOf[point] = tied.sizes.size();
            tied.sizes.push_back(0);
        }
        ++tied.sizes[tied.setOf[point] = tied.setOf[first]];
    }
    for (const LinearForm& equation : equations) {
        if (isTie(equation)) continue;
        LinearForm ofSets;
        for (std::size_t k = 0; k < equation.unknowns.size(); ++k)
            ofSets.add(tied.setOf[equation.unknowns[k]], equation.weights[k]);
        if (!ofSets.unknowns.empty()) tied.equations.push_back(std::move(ofSets));
    }
    return tied;
}

} // namespace qm
