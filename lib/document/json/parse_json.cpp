#include "base/error.h"
#include "document/json/json.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <span>
#include <string_view>
#include <unordered_set>

namespace qm {

namespace {

constexpr std::size_t maxDepth = 100;

/// Builds a value from the parser's events. The library's own builder would keep the last of duplicate keys,
/// and search all keys of an object for every new key.
class Builder {
public:
    using number_integer_t = Json::number_integer_t;
    using number_unsigned_t = Json::number_unsigned_t;
    using number_float_t = Json::number_float_t;
    using string_t = Json::string_t;
    using binary_t = Json::binary_t;

    bool null() { return put(nullptr); }
    bool boolean(bool value) { return put(value); }
    bool number_integer(number_integer_t value) { return put(value); }
    bool number_unsigned(number_unsigned_t value) { return put(value); }
    bool number_float(number_float_t value, const string_t&) { return put(value); }
    bool string(string_t& value) { return put(std::move(value)); }
    bool binary(binary_t&) { return false; }
    bool start_array(std::size_t) { return open(false); }
    bool start_object(std::size_t) { return open(true); }
    bool key(string_t& key);
    bool end_array() { return close(); }
    bool end_object() { return close(); }
    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::json::exception& exception);

    Json result() { return std::move(values_.front()); }

    std::string problem;
    std::size_t position = 0; ///< byte position of the problem; 0 if only its pointer is known
    JsonPointer pointer;

private:
    /// An array or object that is not complete.
    struct Level {
        bool isObject = false;
        std::size_t firstValue = 0;
        std::size_t firstKey = 0;
        std::unordered_set<std::string> known{}; ///< keys; only for large objects
    };

    bool open(bool isObject) {
        if (levels_.size() >= maxDepth) return fail("nested more than " + std::to_string(maxDepth) + " deep");
        levels_.push_back({isObject, values_.size(), keys_.size()});
        return true;
    }
    bool close();
    template <class Value> bool put(Value&& value) {
        values_.emplace_back(std::forward<Value>(value));
        return true;
    }
    bool fail(std::string what);

    std::vector<Level> levels_;
    std::vector<Json> values_; ///< of all levels, in the order of the text
    std::vector<std::string> keys_;
};

bool Builder::key(string_t& key) {
    constexpr std::size_t small = 16;
    Level& level = levels_.back();
    const std::span before = std::span(keys_).subspan(level.firstKey);
    bool isNew = true;
    if (before.size() < small) {
        isNew = std::ranges::find(before, key) == before.end();
    } else {
        if (level.known.empty()) level.known.insert(before.begin(), before.end());
        isNew = level.known.insert(key).second;
    }
    keys_.push_back(std::move(key));
    return isNew || fail("this key occurs twice in one object");
}

bool Builder::close() {
    const auto [isObject, firstValue, firstKey, known] = std::move(levels_.back());
    levels_.pop_back();
    const std::span values = std::span(values_).subspan(firstValue);
    Json whole;
    if (isObject) {
        Json::object_t members;
        members.reserve(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            members.append(std::move(keys_[firstKey + i]), std::move(values[i]));
        keys_.resize(firstKey);
        whole = std::move(members);
    } else {
        whole = Json::array_t(std::move_iterator(values.begin()), std::move_iterator(values.end()));
    }
    values_.resize(firstValue);
    return put(std::move(whole));
}

bool Builder::fail(std::string what) {
    problem = std::move(what);
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const bool isLast = i + 1 == levels_.size();
        const std::size_t keys = isLast ? keys_.size() : levels_[i + 1].firstKey;
        const std::size_t values = isLast ? values_.size() : levels_[i + 1].firstValue;
        if (!levels_[i].isObject)
            pointer /= values - levels_[i].firstValue;
        else if (keys > levels_[i].firstKey)
            pointer /= keys_[keys - 1];
    }
    return false;
}

/// The library's message, shortened, without its exception number and position.
std::string reason(std::string message) {
    constexpr std::size_t longest = 200;
    constexpr std::array<std::string_view, 4> marks{"] ", "parse error at ", ": ",
                                                    "syntax error while parsing "};
    for (const std::string_view mark : marks) {
        const std::size_t found = message.find(mark);
        if (found < 100) message.erase(0, found + mark.size());
    }
    return message.size() <= longest ? message : message.substr(0, longest) + " ...";
}

bool Builder::parse_error(std::size_t where, const std::string&, const nlohmann::json::exception& exception) {
    position = where;
    return fail("is no JSON: " + reason(exception.what()));
}

/// Line and column of a byte, which is counted from 1.
std::string lineAndColumn(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, position == 0 ? 0 : position - 1);
    const auto line = std::ranges::count(before, '\n') + 1;
    const std::size_t lineStart = before.rfind('\n');
    const std::size_t column =
        lineStart == std::string_view::npos ? before.size() : before.size() - lineStart - 1;
    return "line " + std::to_string(line) + ", column " + std::to_string(column + 1);
}

} // namespace

Json parseJson(std::string_view text) {
    if (std::ranges::all_of(text, [](unsigned char c) { return std::isspace(c) != 0; }))
        throw Error("", "is empty", "Perhaps the tool before it in the pipe failed");
    Builder builder;
    if (!Json::sax_parse(text.begin(), text.end(), &builder))
        throw Error(builder.position > 0 ? lineAndColumn(text, builder.position)
                                         : builder.pointer.to_string().substr(0, 100),
                    builder.problem);
    return builder.result();
}

} // namespace qm
