#include "export/files/step_file.h"

#include "base/number_text.h"

#include <cstddef>
#include <cstdint>

namespace qm {
namespace {

/// Some programs read lines of limited length.
constexpr std::size_t lineLength = 110;

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

void appendParameter(std::string& text, double value) {
    const std::size_t begin = text.size();
    appendNumber(text, value);
    const std::size_t exponent = text.find('e', begin);
    if (exponent != std::string::npos) text[exponent] = 'E';
    if (text.find('.', begin) == std::string::npos)
        text.insert(exponent == std::string::npos ? text.size() : exponent, 1, '.');
}

void appendParameter(std::string& text, int value) {
    appendNumber(text, value);
}

void appendParameter(std::string& text, bool value) {
    text += value ? ".T." : ".F.";
}

void appendParameter(std::string& text, StepId value) {
    text += '#';
    appendNumber(text, value.number);
}

void appendParameter(std::string& text, StepToken value) {
    text += value.text;
}

void appendParameter(std::string& text, std::string_view value) {
    text.append("'").append(value).append("'");
}

StepId StepFile::addComplex(std::string_view records) {
    return addText("(" + std::string(records) + ")");
}

StepId StepFile::addText(std::string_view entity) {
    data_ += '#';
    appendNumber(data_, ++count_);
    data_ += '=';
    appendBroken(data_, entity);
    data_ += ";\n";
    return {count_};
}

std::string StepFile::text(std::string_view name, std::string_view date, std::string_view schema) const {
    std::string result = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('";
    result.append(name).append("','").append(date);
    result.append("',(''),(''),'quadmesh','quadmesh','');\nFILE_SCHEMA(('");
    result.append(schema).append("'));\nENDSEC;\nDATA;\n").append(data_);
    return result + "ENDSEC;\nEND-ISO-10303-21;\n";
}

} // namespace qm
