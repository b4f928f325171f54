#include "base/error.h"
#include "enumerate/state/line_stretch.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace qm::test {
namespace {

/// A line with the given arcs, a source at its beginning and possibly one at its end.
class OneLine {
public:
    /// \param states  one character per arc: 'x' in, '-' out, '.' free
    explicit OneLine(const std::string& states, bool sourceAtEnd = false) {
        Line line;
        line.forward = SeparatrixId(0);
        if (sourceAtEnd) line.backward = SeparatrixId(1);
        line.firstArc = ArcId(0);
        line.arcCount = static_cast<int>(states.size());
        graph_.lines = {line};
        for (std::size_t arc = 0; arc < states.size(); ++arc) {
            graph_.arcs.push_back({LineId(0), static_cast<int>(arc), static_cast<int>(arc) + 1});
            present_.push_back(states[arc] == 'x');
            if (states[arc] == '.') free_.emplace_back(arc);
        }
        graph_.junctionAfter.resize(states.size());
        costs_.resize(states.size(), 0);
    }

    OneLine& demand(IdVector<ArcId, ArcState> demands) {
        demands_ = std::move(demands);
        return *this;
    }
    /// Lets both particles only meet after this arc.
    OneLine& meetAfter(int arc) {
        walkers_ = Walkers({{LineId(0), {true, true, ArcId(arc)}}});
        return *this;
    }

    [[nodiscard]] std::vector<LineStretch> stretches() const { return stretchesOf(input(), LineId(0)); }
    /// The domains of all arcs of all stretches, in the notation of `states`; stretches are separated by a
    /// space.
    [[nodiscard]] std::string domains() const {
        std::string text;
        for (const LineStretch& stretch : stretches()) {
            if (!text.empty()) text += ' ';
            for (int k = stretch.first; k <= stretch.last; ++k) {
                const ArcState domain = domainOf(input(), LineId(0), stretch, k);
                text += domain == ArcState::free ? '.' : domain == ArcState::in ? 'x' : '-';
            }
        }
        return text;
    }

private:
    [[nodiscard]] ProblemInput input() const {
        return {graph_, costs_, ArcStates(present_, free_), demands_, {}, walkers_};
    }

    ArcGraph graph_;
    IdVector<ArcId, double> costs_;
    PresentArcs present_;
    std::vector<ArcId> free_;
    IdVector<ArcId, ArcState> demands_;
    Walkers walkers_;
};

TEST(LineStretch, ReachesFromTheFirstFreeArcToTheLast) {
    EXPECT_TRUE(OneLine("x--").stretches().empty());
    const auto stretches = OneLine("x.x.--").stretches();
    ASSERT_EQ(stretches.size(), 1U);
    EXPECT_EQ(stretches[0].first, 1);
    EXPECT_EQ(stretches[0].last, 3);
}

TEST(LineStretch, IsAnchoredWhereASourceIsReached) {
    const LineStretch reached = OneLine("xx..-x", true).stretches()[0];
    EXPECT_TRUE(reached.beforeIn && reached.beforeAnchored);
    EXPECT_FALSE(reached.afterIn || reached.afterAnchored);
    const LineStretch gap = OneLine("-x..xx", true).stretches()[0];
    EXPECT_TRUE(gap.beforeIn);
    EXPECT_FALSE(gap.beforeAnchored);
    EXPECT_TRUE(gap.afterIn && gap.afterAnchored);
    EXPECT_FALSE(OneLine("x..").stretches()[0].afterAnchored) << "no source is at the end";
    EXPECT_TRUE(OneLine("x..", true).stretches()[0].afterAnchored);
}

TEST(LineStretch, IsTwoWhereParticlesMeet) {
    const auto stretches = OneLine("....", true).meetAfter(1).stretches();
    ASSERT_EQ(stretches.size(), 2U);
    EXPECT_EQ(stretches[0].last, 1);
    EXPECT_EQ(stretches[1].first, 2);
    EXPECT_TRUE(stretches[0].beforeAnchored && stretches[1].afterAnchored);
    EXPECT_FALSE(stretches[0].afterIn || stretches[0].afterAnchored);
    EXPECT_FALSE(stretches[1].beforeIn || stretches[1].beforeAnchored);
    EXPECT_EQ(OneLine("xx..", true).meetAfter(1).stretches().size(), 1U) << "the meeting is settled";
}

TEST(LineStretch, LeavesArcsWhatTheRestOfTheLineAllows) {
    EXPECT_EQ(OneLine("....").domains(), "x...") << "the particle at the source walks";
    EXPECT_EQ(OneLine("....", true).domains(), "x..x");
    EXPECT_EQ(OneLine("x..-").domains(), "..");
    EXPECT_EQ(OneLine("x..x").domains(), "xx") << "what comes after must be reached from here";
    EXPECT_EQ(OneLine("-..-").domains(), "--") << "nobody gets here";
    EXPECT_EQ(OneLine("x.-.x", true).domains(), ".-.");
}

TEST(LineStretch, ObeysDemands) {
    constexpr ArcState in = ArcState::in, out = ArcState::out, any = ArcState::free;
    EXPECT_EQ(OneLine("....").demand({any, in, out, any}).domains(), "xx-.");
    EXPECT_EQ(OneLine("....").demand({in, any, any, any}).domains(), "x...");
    EXPECT_THROW((void)OneLine("....").demand({out, any, any, any}).domains(), Error);
    EXPECT_THROW((void)OneLine("-..-").demand({any, in, any, any}).domains(), Error);
}

} // namespace
} // namespace qm::test
