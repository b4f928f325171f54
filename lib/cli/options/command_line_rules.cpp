#include "cli/options/command_line_rules.h"

namespace qm {

void assignOperands(const std::vector<std::string>& words, const std::vector<Operand>& declared,
                    const std::vector<std::string*>& targets, std::vector<std::string>* more) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool isMore = i >= targets.size();
        if (isMore && more == nullptr) throw UsageError("unexpected operand " + words[i]);
        if (words[i].empty())
            throw UsageError((isMore ? "operand " + std::to_string(i + 1) : declared[i].name) + " is empty");
        if (isMore)
            more->push_back(words[i]);
        else
            *targets[i] = words[i];
    }
    for (std::size_t i = words.size(); i < declared.size(); ++i)
        if (declared[i].required) throw UsageError(declared[i].name + " is missing");
}

void requireEffects(const std::vector<OptionCondition>& conditions, const std::set<std::string>& given) {
    for (const OptionCondition& condition : conditions)
        for (const std::string& name : condition.names)
            if (given.contains(name) && !condition.holds())
                throw UsageError("--" + name + " has no effect without " + condition.what + ". Leave it out");
}

} // namespace qm
