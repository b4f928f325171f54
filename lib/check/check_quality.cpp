#include "base/at.h"
#include "base/number_text.h"
#include "check/check_sections.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace qm::check {

namespace {

constexpr const char* place = "/layout/quality";

bool between(double min, double value, double max) {
    const double slack = 1e-6 * std::max(1.0, std::abs(max));
    return value >= min - slack && value <= max + slack;
}

/// Vertices where a side of one segment ends within a side of another.
double tJoints(const Neighbourhoods& around, const LayoutPart& part) {
    std::vector<char> ends(at(around.vertices()), 0);
    std::vector<char> within(at(around.vertices()), 0);
    for (const auto& segment : part.segments)
        for (const auto& side : segment.sides) {
            ends[at(side.front())] = 1;
            for (std::size_t i = 1; i + 1 < side.size(); ++i)
                within[at(side[i])] = 1;
        }
    double count = 0;
    for (std::size_t v = 0; v < ends.size(); ++v)
        count += ends[v] && within[v];
    return count;
}

/// Longer to shorter side of every segment, ascending.
std::vector<double> aspects(const LayoutPart& part) {
    std::vector<double> all;
    for (const auto& segment : part.segments) {
        const auto [shorter, longer] = std::minmax(segment.size[0], segment.size[1]);
        all.push_back(static_cast<double>(longer) / shorter);
    }
    std::ranges::sort(all);
    return all;
}

/// The part of the sharp edges' angle that lies on tracks. An angle that rounding decides may be anything.
void checkSharpness(const Angles& angles, std::span<const char> onTrack, const LayoutPart& part,
                    Report& report) {
    double captured = 0;
    double missed = 0;
    double perhapsCaptured = 0;
    double perhapsMissed = 0;
    for (std::size_t edge = 0; edge < onTrack.size(); ++edge) {
        if (angles.doubt[edge] > 0)
            (onTrack[edge] ? perhapsCaptured : perhapsMissed) += angles.doubt[edge];
        else if (angles.angle[edge] > *part.quality.rho)
            (onTrack[edge] ? captured : missed) += angles.angle[edge];
    }
    const double sharp = captured + missed;
    if (!(sharp > 0)) return;
    const double min = captured / (sharp + perhapsMissed);
    const double max = (captured + perhapsCaptured) / (sharp + perhapsCaptured);
    if (!between(min, *part.quality.capturedSharpness, max))
        report.violate(below(place, "capturedSharpness"), "quality", "it is " + numberText(max));
}

} // namespace

void checkQuality(const Neighbourhoods& around, const Angles& angles, std::span<const char> onTrack,
                  const LayoutPart& part, Report& report) {
    const auto expect = [&](const std::optional<double>& claimed, const char* key, double min, double max) {
        if (claimed && !between(min, *claimed, max))
            report.violate(below(place, key), "quality", "it is " + numberText(max));
    };
    const auto number = static_cast<double>(part.segments.size());
    expect(part.quality.segments, "segments", number, number);
    if (part.quality.tJoints) {
        const double joints = tJoints(around, part);
        expect(part.quality.tJoints, "tJoints", joints, joints);
    }
    if (part.quality.capturedSharpness && part.quality.rho) checkSharpness(angles, onTrack, part, report);
    if (part.cost && part.lowerBound) {
        const double gap = *part.cost - *part.lowerBound;
        expect(part.quality.gap, "gap", gap, gap);
    }
    const auto sorted = aspects(part);
    if (sorted.empty()) return;
    // Between two middle elements any median will do.
    expect(part.quality.medianAspect, "medianAspect", sorted[(sorted.size() - 1) / 2],
           sorted[sorted.size() / 2]);
    expect(part.quality.maxAspect, "maxAspect", sorted.back(), sorted.back());
}

} // namespace qm::check
