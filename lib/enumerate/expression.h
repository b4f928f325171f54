/// \file Sums of columns, as rows and costs of a formulation are made of.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace qm {

/// A linear expression over columns and a constant.
struct Expression {
    std::vector<std::pair<int, double>> terms;
    double constant = 0;

    Expression& add(int column, double weight) {
        const auto known = std::ranges::find(terms, column, [](const auto& term) { return term.first; });
        if (known == terms.end())
            terms.emplace_back(column, weight);
        else
            known->second += weight;
        return *this;
    }
    Expression& add(const Expression& other, double factor) {
        for (const auto& [column, weight] : other.terms)
            add(column, factor * weight);
        constant += factor * other.constant;
        return *this;
    }
};

} // namespace qm
