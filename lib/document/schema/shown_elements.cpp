#include "document/schema/shown_elements.h"

#include "base/infinity.h"

#include <numeric>

namespace qm {

std::vector<std::size_t> shownElements(const Json::array_t& array) {
    constexpr std::size_t shortArray = 8;
    const auto all = [&array] {
        std::vector<std::size_t> positions(array.size());
        std::iota(positions.begin(), positions.end(), std::size_t{0});
        return positions;
    };
    if (array.size() <= shortArray) return all();

    std::vector<std::size_t> shown;
    std::size_t minAt = 0;
    std::size_t maxAt = 0;
    double minValue = infinity;
    double maxValue = -minValue;
    for (std::size_t i = 0; i < array.size(); ++i) {
        if (!array[i].is_number()) return all();
        if (shown.empty() && array[i].is_number_float() && !wholeNumber(array[i])) shown.push_back(i);
        const auto value = array[i].get<double>();
        if (value < minValue) {
            minValue = value;
            minAt = i;
        }
        if (value > maxValue) {
            maxValue = value;
            maxAt = i;
        }
    }
    shown.push_back(minAt);
    shown.push_back(maxAt);
    return shown;
}

} // namespace qm
