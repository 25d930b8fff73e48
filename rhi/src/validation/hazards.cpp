#include "hazards.h"

#include <optional>

namespace aureole::rhi::validation {
namespace {

bool is_depth(const TextureRecord& texture) { return texture.desc.format == Format::d32_float; }
bool is_depth(const BufferRecord&) { return false; }

/// Depth textures may be read in either of the two sampled states.
template <class Record>
bool allows(const Record& record, State wanted) {
    const State state = record.contents.state;
    if (state == wanted) return true;
    return is_depth(record) && wanted == State::sampled && state == State::depth_read;
}

/// What is wrong with this access; empty if nothing.
template <class Record>
std::string complain(const Access<Record>& access, const std::string& who) {
    const Record& record = *access.record;
    const Contents& c = record.contents;
    const std::string start = who + ": " + quoted(record);
    const char* verb = access.write ? "written" : "read";
    if (!c.writer.empty() && (access.write || !allows(record, access.state)))
        return start + " is " + verb + " without a barrier after its last write (" + c.writer + ")";
    if (!allows(record, access.state))
        return start + " is in state " + to_string(c.state) + "; needed: " + to_string(access.state);
    if (!access.write && !c.defined) return start + " is read, but nothing has been written into it";
    return {};
}

template <class Record>
void check_all(std::span<const Access<Record>> accesses, const std::string& who, Reporter& reporter) {
    for (const auto& access : accesses)
        if (const std::string text = complain(access, who); !text.empty()) reporter.misuse(text);
}

template <class Record>
void note_all(std::span<const Access<Record>> accesses, const std::string& who) {
    for (const auto& access : accesses)
        if (access.write) access.record->contents.writer = who, access.record->contents.defined = true;
}

/// The usage that a resource needs to be moved to a state (none: any will do), and whether it can be in that state at all.
struct Needed {
    Usage usage = Usage::none;
    bool possible = true;
};
Needed needed_usage(const TextureRecord& texture, State state) {
    const std::optional<Usage> usage = texture_usage_for(state);
    if (!usage || state == State::undefined || (state == State::general && !texture.of_host)) return {Usage::none, false};
    return {*usage};
}
Needed needed_usage(const BufferRecord& buffer, State state) {
    switch (state) {
        case State::copy_source:
            return {has(buffer.desc.usage, Usage::upload) ? Usage::none : Usage::copy_source};
        case State::copy_destination: {
            // Constants are updated, read-back buffers are copied into: both need no further usage.
            const bool implied = has(buffer.desc.usage, Usage::constants) || has(buffer.desc.usage, Usage::read_back);
            return {implied ? Usage::none : Usage::copy_destination};
        }
        case State::constants:
            return {Usage::constants};
        default:
            break;
    }
    return {Usage::none, false};
}

template <class Record>
std::string complain_move(const Record& record, State before, State after) {
    const std::string start = "barrier: " + quoted(record);
    const Needed needed = needed_usage(record, after);
    if (!needed.possible) return start + " cannot be moved to state " + to_string(after);
    if (!has(record.desc.usage, needed.usage))
        return start + " has usage " + to_string(record.desc.usage) + "; state " + to_string(after) + " needs " +
               to_string(needed.usage);
    if (before != State::undefined && before != record.contents.state)
        return start + " is in state " + to_string(record.contents.state) + ", not in " + to_string(before);
    return {};
}

template <class Record>
void move_any(Record& record, State before, State after, bool keeps_contents, Reporter& reporter) {
    const std::string text = complain_move(record, before, after);
    // From here on as the caller believes: one mistake is told once.
    Contents& c = record.contents;
    c.state = after;
    c.writer.clear();
    if (before == State::undefined && !keeps_contents) c.defined = false;
    if (!text.empty()) reporter.misuse(text);
}

}  // namespace

void use(std::span<const TextureAccess> textures, std::span<const BufferAccess> buffers, const std::string& who,
         Reporter& reporter) {
    check_all(textures, who, reporter);
    check_all(buffers, who, reporter);
    note_all(textures, who);
    note_all(buffers, who);
}

void move(TextureRecord& texture, State before, State after, Reporter& reporter) {
    move_any(texture, before, after, false, reporter);
}
void move(BufferRecord& buffer, State before, State after, Reporter& reporter) {
    move_any(buffer, before, after, true, reporter);
}

void finish(Contents& contents) { contents.writer.clear(); }

}  // namespace aureole::rhi::validation
