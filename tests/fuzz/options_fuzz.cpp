/// \file Any words, read as a command line, are either refused with one sentence or set options to values in
/// their ranges; and the text shown for an option sets it to the same value again. The first byte chooses the
/// options, every line is a word.
#include "base/error.h"
#include "cli/options/command_line.h"
#include "cli/options/general_options.h"
#include "cli/tools/export_date.h"
#include "document/options/options_json.h"
#include "view/view_options.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

using Type = qm::OptionRecord::Type;

void require(bool condition) {
    if (!condition) std::abort();
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

/// Checks that a refusal is a sentence, and that options otherwise have allowed values.
void exercise(std::vector<std::string> words, const std::vector<qm::OptionRecord>& options) {
    words.insert(words.begin(), "tool");
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);
    qm::CommandLine line;
    try {
        line = qm::readCommandLine(static_cast<int>(words.size()), pointers.data(), options);
    } catch (const qm::UsageError& error) {
        require(!std::string_view(error.what()).empty());
        return;
    }
    for (const qm::OptionRecord& option : options) {
        const std::string shown = option.show();
        if (option.type == Type::flag || shown.empty()) continue;
        if (!line.given.contains(option.name)) continue;
        require(option.assign(shown).empty());
        require(option.show() == shown);
    }
}

template <class Options> void exerciseTable(const std::vector<std::string>& words) {
    Options values;
    qm::GeneralOptions general;
    std::vector<qm::OptionRecord> options = qm::describeGeneral(general, true, true);
    qm::describe(values, [&](const char* name, auto& value, const qm::Range& range, const char* help) {
        options.push_back(qm::makeOption(name, value, range, help));
    });
    exercise(words, options);
    // The document's record of the options can be written and read.
    const qm::Json json = qm::optionsToJson(values);
    require(qm::Json::parse(qm::printJson(json)) == json);
}

/// Tries the texts that tools parse themselves.
void exerciseTexts(const std::vector<std::string>& words) {
    const auto refusable = [](const auto& read) {
        try {
            (void)read();
        } catch (const qm::Error&) {
            // Refused, as most words should be.
        }
    };
    for (const std::string& word : words) {
        refusable([&] { return qm::parseLayers(word); });
        refusable([&] { return qm::parseDirection(word); });
        refusable([&] { return qm::parseSection(word); });
        refusable([&] { return qm::parseSize(word); });
        if (word != "mesh") refusable([&] { return qm::exportDate(word, ""); });
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto words = linesOf({reinterpret_cast<const char*>(data) + 1, size - 1});
    static constexpr std::array exercises = {exerciseTable<qm::FeatureOptions>,
                                             exerciseTable<qm::CutOptions>,
                                             exerciseTable<qm::EnumerationOptions>,
                                             exerciseTable<qm::MergeOptions>,
                                             exerciseTable<qm::PruneOptions>,
                                             exerciseTable<qm::FitOptions>,
                                             exerciseTexts};
    exercises.at(data[0] % exercises.size())(words);
    return 0;
}
