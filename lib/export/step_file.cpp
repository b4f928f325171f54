#include "export/step_file.h"

#include "base/bytes.h"
#include "base/number_text.h"

#include <cstddef>
#include <cstdint>

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

std::string stepText(std::string_view utf8, std::size_t limit) {
    std::string result;
    for (std::size_t at = 0; at < utf8.size();) {
        const auto lead = static_cast<unsigned char>(utf8[at]);
        const std::size_t length = lead < 0xc0 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
        const std::size_t before = result.size();
        if (lead >= ' ' && lead <= '~' && lead != ',') {
            result += utf8[at];
            if (lead == '\'' || lead == '\\') result += utf8[at]; // these two are doubled
        } else {
            std::uint32_t letter = length == 1 ? lead : lead & (0x7fU >> length);
            for (std::size_t k = 1; k < length && at + k < utf8.size(); ++k)
                letter = letter << 6U | (static_cast<unsigned char>(utf8[at + k]) & 0x3fU);
            const bool isShort = letter < 0x10000;
            result += isShort ? "\\X2\\" : "\\X4\\";
            for (unsigned shift = isShort ? 16 : 32; shift > 0; shift -= 4)
                result += "0123456789ABCDEF"[letter >> (shift - 4) & 15U];
            result += "\\X0\\";
        }
        if (result.size() > limit) {
            result.resize(before);
            break;
        }
        at += length;
    }
    return result;
}

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

std::string StepFile::text(const StepHeader& header, std::string_view schema) const {
    std::string result = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('";
    result.append(header.name).append("','").append(header.date);
    result.append("',(''),(''),'quadmesh','quadmesh','');\nFILE_SCHEMA(('");
    result.append(schema).append("'));\nENDSEC;\nDATA;\n").append(data_);
    return result + "ENDSEC;\nEND-ISO-10303-21;\n";
}

} // namespace qm
