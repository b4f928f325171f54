#include "base/number_text.h"
#include "document/json/json.h"

#include <stdexcept>

namespace qm {

namespace {

constexpr std::size_t lineWidth = 100;
constexpr std::size_t indentWidth = 2;

void appendString(std::string& text, const std::string& value) {
    static constexpr char hex[] = "0123456789abcdef";
    text += '"';
    for (const char c : value) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            (text += '\\') += c;
        else if (c == '\n')
            text += "\\n";
        else if (c == '\t')
            text += "\\t";
        else if (byte < 0x20)
            ((text += "\\u00") += hex[byte >> 4]) += hex[byte & 15];
        else
            text += c;
    }
    text += '"';
}

void appendScalar(std::string& text, const Json& value) {
    switch (value.type()) {
    case Json::value_t::string:
        return appendString(text, value.get_ref<const std::string&>());
    case Json::value_t::boolean:
        text += value.get<bool>() ? "true" : "false";
        return;
    case Json::value_t::number_integer:
        return appendNumber(text, value.get<std::int64_t>());
    case Json::value_t::number_unsigned:
        return appendNumber(text, value.get<std::uint64_t>());
    case Json::value_t::number_float: {
        const double number = value.get<double>();
        if (!std::isfinite(number)) throw std::logic_error("a number in a document is not finite");
        return appendNumber(text, withoutSignOfZero(number));
    }
    default:
        text += "null";
    }
}

class Printer {
public:
    explicit Printer(std::string& text) : text_(text) {}

    /// Writes a value on one line.
    /// \return false if it does not fit before `limit`; then a part of it has been written
    bool inOneLine(const Json& value, std::size_t limit) {
        if (value.is_object()) return inOneLine(value.get_ref<const Json::object_t&>(), limit);
        if (value.is_array()) return inOneLine(value.get_ref<const Json::array_t&>(), limit);
        appendScalar(text_, value);
        return text_.size() <= limit;
    }

    /// \param column  where the value begins
    /// \param indent  indentation of the line on which the value begins
    void pretty(const Json& value, std::size_t column, std::size_t indent) {
        const std::size_t start = text_.size();
        // Leaves one column for a comma.
        if (!value.is_structured() || value.empty()) {
            inOneLine(value, std::string::npos);
        } else if (column + 1 >= lineWidth || !inOneLine(value, start + lineWidth - column - 1)) {
            text_.resize(start);
            if (value.is_object())
                members(value.get_ref<const Json::object_t&>(), indent);
            else
                elements(value.get_ref<const Json::array_t&>(), indent);
        }
    }

private:
    bool inOneLine(const Json::object_t& object, std::size_t limit) {
        return listed("{}", object, limit, [&](const auto& member) {
            appendKey(member.first);
            return inOneLine(member.second, limit);
        });
    }

    bool inOneLine(const Json::array_t& array, std::size_t limit) {
        return listed("[]", array, limit, [&](const Json& value) { return inOneLine(value, limit); });
    }

    template <class List, class Write>
    bool listed(std::string_view brackets, const List& list, std::size_t limit, const Write& write) {
        text_ += brackets.front();
        for (auto element = list.begin(); element != list.end(); ++element) {
            if (element != list.begin()) text_ += ", ";
            if (!write(*element)) return false;
        }
        text_ += brackets.back();
        return text_.size() <= limit;
    }

    void appendKey(const std::string& key) {
        appendString(text_, key);
        text_ += ": ";
    }

    void newLine(std::size_t indent) {
        text_ += '\n';
        text_.append(indent, ' ');
    }

    void members(const Json::object_t& object, std::size_t indent) {
        text_ += '{';
        const std::size_t inner = indent + indentWidth;
        for (auto member = object.begin(); member != object.end(); ++member) {
            if (member != object.begin()) text_ += ',';
            newLine(inner);
            const std::size_t start = text_.size();
            appendKey(member->first);
            pretty(member->second, inner + text_.size() - start, inner);
        }
        newLine(indent);
        text_ += '}';
    }

    void elements(const Json::array_t& array, std::size_t indent) {
        text_ += '[';
        const std::size_t inner = indent + indentWidth;
        std::size_t lineStart = 0;
        std::string scalar;
        bool filling = false; // the present line holds scalars only
        for (auto value = array.begin(); value != array.end(); ++value) {
            if (value != array.begin()) text_ += ',';
            if (value->is_structured()) {
                newLine(inner);
                pretty(*value, inner, inner);
                filling = false;
                continue;
            }
            scalar.clear();
            appendScalar(scalar, *value);
            if (filling && text_.size() + 1 + scalar.size() - lineStart < lineWidth) {
                text_ += ' ';
            } else {
                newLine(inner);
                lineStart = text_.size() - inner;
                filling = true;
            }
            text_ += scalar;
        }
        newLine(indent);
        text_ += ']';
    }

    std::string& text_;
};

} // namespace

std::string printJson(const Json& value) {
    std::string text;
    Printer(text).pretty(value, 0, 0);
    text += '\n';
    return text;
}

std::string printJsonLine(const Json& value) {
    std::string text;
    Printer(text).inOneLine(value, std::string::npos);
    text += '\n';
    return text;
}

} // namespace qm
