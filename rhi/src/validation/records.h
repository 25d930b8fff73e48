// What the validation device knows about each object.
#pragma once

#include <aureole/rhi/checks.h>
#include <aureole/rhi/device.h>

#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace aureole::rhi::validation {

/// State and history of a texture's or buffer's contents.
struct Contents {
    State state = State::undefined;
    bool defined = false;  ///< Something was written, and no barrier has thrown it away.
    std::string writer;    ///< What wrote since the last barrier; empty: nothing.
};

struct TextureRecord {
    static constexpr const char* kind = "texture";
    TextureDesc desc;
    Contents contents;
    bool of_host = false;
    State host_state = State::undefined;  ///< Of a host's texture, at the start and the end of every list.
    std::uint64_t last_frame = 0;         ///< The last frame that uses it.
    [[nodiscard]] const std::string& name() const { return desc.name; }
};
struct BufferRecord {
    static constexpr const char* kind = "buffer";
    BufferDesc desc;
    Contents contents;
    std::uint64_t last_frame = 0;
    [[nodiscard]] const std::string& name() const { return desc.name; }
};
struct SamplerRecord {
    static constexpr const char* kind = "sampler";
    SamplerDesc desc;
    std::uint64_t last_frame = 0;
    [[nodiscard]] const std::string& name() const { return no_name; }
    static inline const std::string no_name;
};
struct PipelineRecord {
    static constexpr const char* kind = "pipeline";
    std::string given_name;
    const Shader* shader = nullptr;
    Format target_format = Format::undefined;
    std::uint64_t last_frame = 0;
    [[nodiscard]] const std::string& name() const { return given_name; }
    [[nodiscard]] PipelineFacts facts() const { return {given_name, shader, target_format}; }
};
struct BindingSetRecord {
    static constexpr const char* kind = "binding set";
    std::string given_name;
    const Shader* shader = nullptr;
    std::vector<Binding> bindings;
    std::uint64_t last_frame = 0;
    [[nodiscard]] const std::string& name() const { return given_name; }
    [[nodiscard]] BindingSetFacts facts() const { return {given_name, shader}; }
};

template <class Record>
[[nodiscard]] std::string quoted(const Record& record) {
    return field_name(Record::kind, record.name(), "");
}

/// The objects of one kind. Names of destroyed ones are remembered for a while, to be told in messages.
template <class Handle, class Record>
class Records {
public:
    void add(Handle handle, Record record) { alive_.insert_or_assign(handle.value, std::move(record)); }

    [[nodiscard]] Record* find(Handle handle) {
        const auto found = alive_.find(handle.value);
        return found == alive_.end() ? nullptr : &found->second;
    }
    [[nodiscard]] const Record* find(Handle handle) const { return const_cast<Records*>(this)->find(handle); }

    void destroy(Handle handle) {
        const auto found = alive_.find(handle.value);
        destroyed_.emplace_back(handle.value, quoted(found->second));
        if (destroyed_.size() > remembered) destroyed_.pop_front();
        alive_.erase(found);
    }

    /// Why a handle that is not alive cannot be used.
    [[nodiscard]] std::string explain(Handle handle) const {
        if (!handle) return std::string("no ") + Record::kind + " is given";
        for (const auto& [value, name] : destroyed_)
            if (value == handle.value) return name + " is used after it was destroyed";
        return std::string("unknown ") + Record::kind + " (handle " + std::to_string(handle.value) + ")";
    }

    [[nodiscard]] auto& alive() { return alive_; }

private:
    static constexpr std::size_t remembered = 1024;
    std::unordered_map<std::uint64_t, Record> alive_;
    std::deque<std::pair<std::uint64_t, std::string>> destroyed_;
};

}  // namespace aureole::rhi::validation
