#include "bspline/fitting/free_unknowns.h"

namespace qm {

std::vector<bool> withNeighbours(const SmoothNetwork& network, std::vector<bool> patches, int rings) {
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<bool> before = patches;
        for (const Stretch& stretch : network.stretches)
            for (const std::size_t side : {0U, 1U})
                if (before[stretch.sides[side].patch]) patches[stretch.sides[1 - side].patch] = true;
    }
    return patches;
}

FreeUnknowns::FreeUnknowns(const std::vector<PatchSpace>& spaces, const std::vector<bool>& isFree) {
    for (std::size_t patch = 0; patch < spaces.size(); ++patch)
        for (std::size_t k = 0; k < spaces[patch].size(); ++k)
            numbers_.push_back(isFree[patch] ? count_++ : none);
}

LinearForm FreeUnknowns::among(const LinearForm& form) const {
    LinearForm result;
    for (std::size_t k = 0; k < form.unknowns.size(); ++k) {
        if (!isFree(form.unknowns[k])) continue;
        result.unknowns.push_back(number(form.unknowns[k]));
        result.weights.push_back(form.weights[k]);
    }
    return result;
}

} // namespace qm
