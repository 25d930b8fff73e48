// The rules of states and barriers.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "records.h"
#include "reporter.h"

namespace aureole::rhi::validation {

/// One use of a resource by one command.
template <class Record>
struct Access {
    Record* record = nullptr;
    State state = State::undefined;  ///< The state in which this use is allowed.
    bool write = false;
};
using TextureAccess = Access<TextureRecord>;
using BufferAccess = Access<BufferRecord>;

/// Checks all accesses of one command, reports what is wrong, and notes the writes. `who` is the command, as in messages:
/// `dispatch of pipeline "sky"`.
void use(std::span<const TextureAccess> textures, std::span<const BufferAccess> buffers, const std::string& who,
         Reporter& reporter);

/// One entry of a barrier.
void move(TextureRecord& texture, State before, State after, Reporter& reporter);
void move(BufferRecord& buffer, State before, State after, Reporter& reporter);

/// Everything recorded has finished.
void finish(Contents& contents);

}  // namespace aureole::rhi::validation
