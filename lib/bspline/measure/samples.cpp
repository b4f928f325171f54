#include "bspline/measure/samples.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace qm {

double largest(const Samples& samples) {
    double result = 0;
    for (const Sample& sample : samples)
        result = std::max(result, sample.value);
    return result;
}

double rootMeanSquare(const Samples& samples) {
    double sum = 0;
    double weights = 0;
    for (const auto& [value, weight] : samples) {
        sum += weight * value * value;
        weights += weight;
    }
    return weights > 0 ? std::sqrt(sum / weights) : 0;
}

double percentile95(Samples samples) {
    const auto weight = [](auto begin, auto end) {
        return std::accumulate(begin, end, 0.0,
                               [](double sum, const Sample& sample) { return sum + sample.weight; });
    };
    auto begin = samples.begin();
    auto end = samples.end();
    double above = 0.05 * weight(begin, end);
    if (!(above > 0)) return 0;
    while (end - begin > 1) {
        const auto middle = begin + (end - begin) / 2;
        std::nth_element(begin, middle, end, std::greater<>());
        const double upper = weight(begin, middle);
        if (upper > above) {
            end = middle;
        } else {
            above -= upper;
            begin = middle;
        }
    }
    return begin->value;
}

void append(Samples& samples, const Samples& more) {
    samples.insert(samples.end(), more.begin(), more.end());
}

} // namespace qm
