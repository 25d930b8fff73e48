#include "scene/section.h"

#include "io/csv.h"
#include "io/file.h"

#include <toml++/toml.h>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

namespace aureole::app {

struct Section::Impl {
    std::shared_ptr<const toml::table> document;  // keeps `table` alive
    const toml::table* table = nullptr;
    std::string file;
    std::string path;  // "atmosphere.term[1]"; empty for the document itself
    std::set<std::string, std::less<>> asked;

    const toml::node* find(std::string_view key) {
        asked.emplace(key);
        return table->get(key);
    }
};

namespace {

std::string print_range(Range range) { return "in [" + print_number(range.low) + ", " + print_number(range.high) + "]"; }

std::string print_node(const toml::node& node) {
    std::ostringstream out;
    if (const auto* text = node.as_string())
        out << '"' << text->get() << '"';
    else if (const auto* integer = node.as_integer())
        out << integer->get();
    else if (const auto* real = node.as_floating_point())
        out << print_number(real->get());
    else if (const auto* flag = node.as_boolean())
        out << (flag->get() ? "true" : "false");
    else if (const auto* array = node.as_array(); array && array->size() <= 8) {
        out << '[';
        const char* between = "";
        for (const toml::node& element : *array) out << std::exchange(between, ", ") << print_node(element);
        out << ']';
    } else if (array)
        out << "an array of " << array->size();
    else if (node.is_table())
        out << "a table";
    else
        out << "a date or time";
    return out.str();
}

std::optional<double> as_number(const toml::node& node) {
    if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
    if (const auto* real = node.as_floating_point()) return real->get();
    return std::nullopt;
}

/// toml++ makes a table for each part of a dotted key and frees them by recursion: a line of dots takes more stack than there
/// is. What looks like a key: dots that nothing but names and blanks stands between.
void check_keys(std::string_view text, const std::string& name) {
    constexpr int most_parts = 100;
    int dots = 0, line = 1;
    char before = '\n';
    for (const char c : text) {
        if (c == '\n') ++line;
        if (std::string_view("\n=,{}").find(c) != std::string_view::npos || (c == '.' && before == '.'))
            dots = 0;
        else if (c == '.' && ++dots > most_parts)
            throw Error(ErrorCode::invalid_argument, name + ":" + std::to_string(line) +
                                                         ": not TOML of ours: a key of more than " +
                                                         std::to_string(most_parts) + " parts");
        before = c;
    }
}

bool inside(double value, Range range) { return value >= range.low && value <= range.high; }  // false for NaN

}  // namespace

Section::Section(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

bool Section::has(std::string_view key) const { return impl_->find(key) != nullptr; }

bool Section::is_text(std::string_view key) const {
    const toml::node* node = impl_->find(key);
    return node && node->is_string();
}

std::string Section::where(std::string_view key) const {
    const toml::node* node = key.empty() ? nullptr : impl_->table->get(key);
    const auto line = (node ? node->source() : impl_->table->source()).begin.line;
    std::string name = impl_->path;
    if (!key.empty()) name.append(name.empty() ? "" : ".").append(key);
    return impl_->file + ":" + std::to_string(line) + ": " + name;
}

void Section::reject(std::string_view key, std::string_view value, std::string_view allowed) const {
    throw Error(ErrorCode::invalid_argument, where(key), value, allowed);
}

std::optional<double> Section::number(std::string_view key, Range range) {
    const toml::node* node = impl_->find(key);
    if (!node) return std::nullopt;
    const std::optional<double> value = as_number(*node);
    if (!value || !inside(*value, range)) reject(key, print_node(*node), "a number " + print_range(range));
    return value;
}

std::optional<std::vector<double>> Section::numbers(std::string_view key, Range range) {
    const toml::node* node = impl_->find(key);
    if (!node) return std::nullopt;
    const toml::array* array = node->as_array();
    if (!array) reject(key, print_node(*node), "an array of numbers " + print_range(range));
    std::vector<double> values;
    for (const toml::node& element : *array) {
        const std::optional<double> value = as_number(element);
        if (!value || !inside(*value, range))
            reject(key, print_node(element) + " as element " + std::to_string(values.size()), "numbers " + print_range(range));
        values.push_back(*value);
    }
    return values;
}

std::optional<Rgb> Section::rgb(std::string_view key, Range range) {
    const toml::node* node = impl_->find(key);
    if (!node) return std::nullopt;
    const std::string allowed = "a number, or [red, green, blue], each " + print_range(range);
    if (const std::optional<double> grey = as_number(*node)) {
        if (!inside(*grey, range)) reject(key, print_node(*node), allowed);
        return Rgb(*grey);
    }
    const toml::array* array = node->as_array();
    if (!array || array->size() != 3) reject(key, print_node(*node), allowed);
    const std::vector<double> values = *numbers(key, range);
    return Rgb(values[0], values[1], values[2]);
}

std::optional<bool> Section::boolean(std::string_view key) {
    const toml::node* node = impl_->find(key);
    if (!node) return std::nullopt;
    if (!node->is_boolean()) reject(key, print_node(*node), "true or false");
    return node->as_boolean()->get();
}

std::optional<std::string> Section::text(std::string_view key) {
    const toml::node* node = impl_->find(key);
    if (!node) return std::nullopt;
    if (!node->is_string()) reject(key, print_node(*node), "a text in quotes");
    return node->as_string()->get();
}

std::optional<std::vector<std::string>> Section::texts(std::string_view key) {
    const toml::node* node = impl_->find(key);
    if (!node) return std::nullopt;
    if (node->is_string()) return std::vector{node->as_string()->get()};
    const toml::array* array = node->as_array();
    if (!array) reject(key, print_node(*node), "a text in quotes, or an array of texts");
    std::vector<std::string> values;
    for (const toml::node& element : *array) {
        if (!element.is_string())
            reject(key, print_node(element) + " as element " + std::to_string(values.size()), "texts in quotes");
        values.push_back(element.as_string()->get());
    }
    return values;
}

std::optional<std::size_t> Section::choice(std::string_view key, std::span<const std::string_view> choices) {
    const toml::node* node = impl_->find(key);
    if (!node) return std::nullopt;
    std::string all;
    std::size_t index = 0;
    for (const std::string_view name : choices) {
        if (node->is_string() && node->as_string()->get() == name) return index;
        all.append(all.empty() ? "" : ", ").append("\"").append(name).append("\"");
        ++index;
    }
    reject(key, print_node(*node), all);
}

std::optional<Section> Section::section(std::string_view key) {
    const toml::node* node = impl_->find(key);
    if (!node) return std::nullopt;
    if (!node->is_table()) reject(key, print_node(*node), "a table");
    auto impl = std::make_shared<Impl>(*impl_);
    impl->table = node->as_table();
    impl->path.append(impl->path.empty() ? "" : ".").append(key);
    impl->asked.clear();
    return Section(std::move(impl));
}

std::vector<Section> Section::sections(std::string_view key) {
    const toml::node* node = impl_->find(key);
    if (!node) return {};
    const toml::array* array = node->as_array();
    if (!array || !array->is_homogeneous(toml::node_type::table)) reject(key, print_node(*node), "an array of tables");
    std::vector<Section> result;
    for (const toml::node& element : *array) {
        auto impl = std::make_shared<Impl>(*impl_);
        impl->table = element.as_table();
        impl->path.append(impl->path.empty() ? "" : ".")
            .append(key)
            .append("[")
            .append(std::to_string(result.size()))
            .append("]");
        impl->asked.clear();
        result.push_back(Section(std::move(impl)));
    }
    return result;
}

std::string Section::printed(std::string_view key) const {
    const toml::node* node = impl_->table->get(key);
    return node ? print_node(*node) : "nothing";
}

void Section::finish() const {
    for (const auto& [key, node] : *impl_->table) {
        if (impl_->asked.contains(key.str())) continue;
        std::string known;
        for (const std::string& name : impl_->asked) known.append(known.empty() ? "" : ", ").append(name);
        reject(key.str(), "this key", known.empty() ? "none" : known);
    }
}

TomlDocument::TomlDocument(const std::filesystem::path& path)
    : TomlDocument(read_text(path, 1 << 26), path.filename().string()) {}

TomlDocument::TomlDocument(std::string_view text, const std::string& name) {
    check_keys(text, name);
    try {
        auto table = std::make_shared<const toml::table>(toml::parse(text, name));
        root_ = std::make_shared<Section::Impl>();
        root_->table = table.get();
        root_->document = std::move(table);
        root_->file = name;
    } catch (const toml::parse_error& problem) {
        throw Error(ErrorCode::invalid_argument, name + ":" + std::to_string(problem.source().begin.line) +
                                                     ": not TOML: " + std::string(problem.description()));
    }
}

Section TomlDocument::root() const { return Section(root_); }

}  // namespace aureole::app
