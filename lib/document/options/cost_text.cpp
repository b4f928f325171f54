#include "document/options/cost_text.h"

#include "base/number_text.h"

namespace qm {
namespace {

constexpr CostTerms noTerms{0, 0, 0, 0};

/// Reads one term.
/// \return false if the text is no term
bool addTerm(std::string_view text, double sign, CostTerms& terms) {
    double weight = 1;
    if (const std::size_t star = text.find('*'); star != std::string_view::npos) {
        if (!parseNumber(text.substr(0, star), weight)) return false;
        text.remove_prefix(star + 1);
    }
    bool known = false;
    forEachTerm(terms, [&](std::string_view name, double& sum) {
        if (name != text) return;
        sum += sign * weight;
        known = true;
    });
    return known;
}

/// The end of the first term: the next sign that does not belong to an exponent, as in 1e-3.
std::size_t endOfTerm(std::string_view text) {
    for (std::size_t k = 1; k < text.size(); ++k) {
        const bool exponent = (text[k - 1] == 'e' || text[k - 1] == 'E') && k >= 2 &&
                              (text[k - 2] == '.' || (text[k - 2] >= '0' && text[k - 2] <= '9'));
        if ((text[k] == '+' || text[k] == '-') && !exponent) return k;
    }
    return text.size();
}

} // namespace

std::string costText(const CostTerms& terms) {
    std::string text;
    forEachTerm(terms, [&text](const char* name, double weight) {
        if (weight == 0) return;
        if (weight > 0 && !text.empty()) text += '+';
        if (weight == -1)
            text += '-';
        else if (weight != 1)
            text += numberText(weight) + '*';
        text += name;
    });
    return text.empty() ? "0" : text;
}

std::string parseCost(std::string_view text, CostTerms& terms) {
    CostTerms sum = noTerms;
    for (bool more = text != "0"; more; more = !text.empty()) {
        const std::size_t end = endOfTerm(text);
        const bool isNegative = text.starts_with('-');
        const std::size_t begin = isNegative || text.starts_with('+') ? 1 : 0;
        const std::string_view term = text.substr(begin, end - begin);
        if (!addTerm(term, isNegative ? -1 : 1, sum))
            return "'" + std::string(term) +
                   "' is no term: dihedral, length, segments or custom, or a number, * and one of them";
        text.remove_prefix(end);
    }
    terms = sum;
    return {};
}

} // namespace qm
