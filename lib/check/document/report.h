/// \file What a check found: the violations, each with its place, and what proved true; as people and
/// programs read it.
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace qm::check {

/// One place where a document is not true.
struct Violation {
    std::string pointer;     ///< JSON pointer of the place; empty for the whole document
    std::string rule;        ///< short name of the rule, such as "A2" or "tiling"
    std::string explanation; ///< one sentence without a full stop
};

/// Collects violations. A document that is wrong everywhere breaks rules by the million, so only the first
/// `kept` are stored; all are counted.
class Report {
public:
    explicit Report(std::size_t kept = 1000) : kept_(kept) {}

    void violate(std::string pointer, std::string rule, std::string explanation) {
        if (total_++ < kept_)
            violations_.push_back({std::move(pointer), std::move(rule), std::move(explanation)});
    }
    /// Takes in what another report holds.
    void add(const Report& other) {
        for (const Violation& violation : other.violations_)
            if (violations_.size() < kept_) violations_.push_back(violation);
        total_ += other.total_;
        verified_.insert(verified_.end(), other.verified_.begin(), other.verified_.end());
    }
    /// Notes what has been looked at and found true, for the summary.
    void verify(std::string what) { verified_.push_back(std::move(what)); }

    [[nodiscard]] bool ok() const { return total_ == 0; }
    [[nodiscard]] std::size_t total() const { return total_; }
    [[nodiscard]] const std::vector<Violation>& violations() const { return violations_; }
    [[nodiscard]] const std::vector<std::string>& verified() const { return verified_; }

private:
    std::size_t kept_;
    std::size_t total_ = 0;
    std::vector<Violation> violations_;
    std::vector<std::string> verified_;
};

/// A pointer further down: by a key or an index for every level.
template <class... Steps> [[nodiscard]] std::string below(std::string pointer, const Steps&... steps) {
    const auto text = [](const auto& step) {
        if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(step)>>)
            return std::to_string(step);
        else
            return std::string(step);
    };
    ((pointer += "/" + text(steps)), ...);
    return pointer;
}

/// Reports an element of a list whose id is not its place there.
/// \param here    pointer of the element
/// \param plural  of what it is
inline void checkNumber(int id, std::size_t place, const std::string& here, const std::string& plural,
                        Report& report) {
    if (std::cmp_not_equal(id, place))
        report.violate(below(here, "id"), "id", plural + " are numbered from 0 in their order");
}

/// One line for each thing that was found true, and the verdict.
[[nodiscard]] std::string reportText(const Report& report);

/// An object with "ok", "verified", "violations" (those that were kept) and "violationCount", ending in a
/// line break.
[[nodiscard]] std::string reportJson(const Report& report);

/// The violations as lines without line breaks, `pointer: rule: explanation`: at most `max`, and one more
/// line that says how many there are if those are not all.
[[nodiscard]] std::vector<std::string> violationLines(const Report& report, std::size_t max);

} // namespace qm::check
