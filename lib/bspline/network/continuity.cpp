#include "bspline/network/continuity.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace qm {
namespace {

/// The knots of both strips strictly between two parameters, ascending; each as often as in the strip that
/// has it more often.
std::vector<double> knotsBetween(double begin, double end, const StripPair& strips) {
    std::vector<double> knots;
    std::ranges::set_union(strips[0].knots(), strips[1].knots(), std::back_inserter(knots));
    std::erase_if(knots, [&](double knot) { return knot <= begin || knot >= end; });
    return knots;
}

/// A control point of a refined cubic: the arguments of its polar form, and a parameter in its support.
struct RefinedPoint {
    std::array<double, 3> at{};
    double within = 0;
};

/// All control points between two parameters in the common refinement of both strips.
std::vector<RefinedPoint> refinedPoints(double begin, double end, const StripPair& strips) {
    std::vector<double> knots(4, begin);
    std::ranges::copy(knotsBetween(begin, end, strips), std::back_inserter(knots));
    knots.insert(knots.end(), 4, end);
    std::vector<RefinedPoint> points;
    for (std::size_t k = 0; k + 4 < knots.size(); ++k) {
        std::size_t widest = k;
        for (std::size_t i = k; i < k + 4; ++i)
            if (knots[i + 1] - knots[i] > knots[widest + 1] - knots[widest]) widest = i;
        points.push_back(
            {{knots[k + 1], knots[k + 2], knots[k + 3]}, (knots[widest] + knots[widest + 1]) / 2});
    }
    return points;
}

/// Where the tangent ratio is zero, both sides' derivatives are splines of one kind.
void addOppositeDerivatives(double begin, double end, const StripPair& strips,
                            std::vector<LinearForm>& equations) {
    for (const RefinedPoint& point : refinedPoints(begin, end, strips)) {
        LinearForm form;
        for (const BorderStrip& strip : strips)
            strip.addBlossom(Across::derivative, point.at, point.within, 1, form);
        equations.push_back(std::move(form));
    }
}

/// Elsewhere the tangent ratio times the derivative along the border has to be a cubic between knots, as the
/// derivatives across are. It is if the ratio is linear; where it is quadratic, the border has to be, too.
/// Then an equation holds if it does at four places. To demand it at five would come to the same, but in
/// short intervals the fifth hardly differs from the others, and rounding decides.
void addCollocation(const SmoothRun& run, double begin, double end, const StripPair& strips,
                    std::vector<LinearForm>& equations) {
    constexpr int places = 4; // as many as a cubic has coefficients
    const BorderStrip& first = strips[0];
    std::vector<double> ends{begin};
    for (const double knot : knotsBetween(begin, end, strips))
        if (knot > ends.back()) ends.push_back(knot);
    ends.push_back(end);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        const double middle = (ends[k] + ends[k + 1]) / 2;
        if (!run.ratio.isLinear) {
            LinearForm third; // derivative, of cubics exactly
            first.addDerivativeAlong(ends[k], middle, 1, third);
            first.addDerivativeAlong(middle, middle, -2, third);
            first.addDerivativeAlong(ends[k + 1], middle, 1, third);
            equations.push_back(std::move(third));
        }
        for (int place = 0; place < places; ++place) {
            const double at = ends[k] + (ends[k + 1] - ends[k]) * place / (places - 1);
            LinearForm form;
            for (const BorderStrip& strip : strips)
                strip.addValue(Across::derivative, at, middle, 1, form);
            first.addDerivativeAlong(at, middle, -run.ratio(at - run.begin), form);
            equations.push_back(std::move(form));
        }
    }
}

} // namespace

void addPositionEquations(const Stretch& stretch, const StripPair& strips,
                          std::vector<LinearForm>& equations) {
    for (const RefinedPoint& point : refinedPoints(0, stretch.length(), strips)) {
        LinearForm form;
        strips[0].addBlossom(Across::position, point.at, point.within, 1, form);
        strips[1].addBlossom(Across::position, point.at, point.within, -1, form);
        equations.push_back(std::move(form));
    }
}

void addTangentEquations(const SmoothRun& run, const StripPair& strips, std::vector<LinearForm>& equations) {
    const TangentRatio& ratio = run.ratio;
    double begin = run.begin;
    double end = run.end;
    if (ratio.isLinear) {
        addCollocation(run, begin, end, strips, equations);
        return;
    }
    if (ratio.atEnd[0] != 0) {
        addCollocation(run, begin, begin + ratio.reach[0], strips, equations);
        begin += ratio.reach[0];
    }
    if (ratio.atEnd[1] != 0) {
        addCollocation(run, end - ratio.reach[1], end, strips, equations);
        end -= ratio.reach[1];
    }
    if (begin < end) addOppositeDerivatives(begin, end, strips, equations);
}

} // namespace qm
