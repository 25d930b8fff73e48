// The header of an OpenEXR file, before OpenEXR's own reader believes it.
#pragma once

#include <cstddef>
#include <span>

namespace aureole::app {

/// Throws std::runtime_error unless every attribute is as long as its type says, ends in the file, and holds no count that goes
/// beyond it, and tiles have at most 2^24 points. OpenEXR's C++ reader makes room for up to 2 GiB of what an attribute promises
/// before it reads any of it, and takes from the file what a type needs, whatever length is given: what follows is then read as
/// attributes of other names and lengths.
void check_exr_header(std::span<const std::byte> file);

}  // namespace aureole::app
