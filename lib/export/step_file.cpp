#include "export/step_file.h"

#include "base/bytes.h"
#include "base/number_text.h"

#include <cstddef>

namespace qm {
namespace {

/// Some programs read lines of limited length.
constexpr std::size_t lineLength = 110;

template <class Values, class Function>
void appendList(std::string& text, const Values& values, const Function& f) {
    char before = '(';
    for (const auto& value : values) {
        text += before;
        f(value);
        before = ',';
    }
    text += values.empty() ? "()" : ")";
}

/// Broken after commas.
void appendBroken(std::string& text, std::string_view line) {
    while (line.size() > lineLength) {
        const std::size_t comma = line.rfind(',', lineLength - 1);
        if (comma == std::string_view::npos) break;
        text += line.substr(0, comma + 1);
        text += '\n';
        line.remove_prefix(comma + 1);
    }
    text += line;
}

} // namespace

StepText& StepText::raw(std::string_view text) {
    text_ += text;
    return *this;
}

StepText& StepText::real(double value) {
    const std::size_t begin = text_.size();
    appendNumber(text_, value);
    const std::size_t exponent = text_.find('e', begin);
    if (exponent != std::string::npos) text_[exponent] = 'E';
    if (text_.find('.', begin) == std::string::npos)
        text_.insert(exponent == std::string::npos ? text_.size() : exponent, 1, '.');
    return *this;
}

StepText& StepText::integer(int value) {
    appendNumber(text_, value);
    return *this;
}

StepText& StepText::flag(bool value) {
    return raw(value ? ".T." : ".F.");
}

StepText& StepText::id(StepId entity) {
    text_ += '#';
    return integer(entity.number);
}

StepText& StepText::reals(std::span<const double> values) {
    appendList(text_, values, [&](double value) { real(value); });
    return *this;
}

StepText& StepText::integers(std::span<const int> values) {
    appendList(text_, values, [&](int value) { integer(value); });
    return *this;
}

StepText& StepText::ids(std::span<const StepId> entities) {
    appendList(text_, entities, [&](StepId entity) { id(entity); });
    return *this;
}

StepId StepFile::add(const StepText& entity) {
    data_ += '#';
    appendNumber(data_, ++count_);
    data_ += '=';
    appendBroken(data_, entity.text());
    data_ += ";\n";
    return {count_};
}

std::string StepFile::text(std::string_view name, std::string_view schema) const {
    // A file says when it was made; ours shall not differ from run to run.
    std::string result = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('";
    result.append(name).append(
        "','1970-01-01T00:00:00',(''),(''),'quadmesh','quadmesh','');\nFILE_SCHEMA(('");
    result.append(schema).append("'));\nENDSEC;\nDATA;\n").append(data_);
    return result + "ENDSEC;\nEND-ISO-10303-21;\n";
}

} // namespace qm
