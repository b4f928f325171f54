#include "bspline/fitting/system/free_unknowns.h"

namespace qm {

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
