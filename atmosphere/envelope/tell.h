// What is outside the envelope, to the log.
#pragma once

#include <aureole/envelope.h>
#include <aureole/model.h>

#include <vector>

namespace aureole::detail {

/// Tells what an air, or a view of one, is outside with: each field once, until it has been inside again.
class Teller {
public:
    /// `all`: the tellers of one air and its views, this one among them as long as it lives. Two views of one camera say the
    /// same but once.
    explicit Teller(std::vector<const Teller*>& all) : all_(all) { all_.push_back(this); }
    ~Teller() { std::erase(all_, this); }
    Teller(const Teller&) = delete;
    Teller& operator=(const Teller&) = delete;

    /// Warns of each field of `now` that was inside before, unless another of the tellers is outside with the same.
    void tell(std::vector<OutsideEnvelope> now);

private:
    [[nodiscard]] bool another_is(const OutsideEnvelope& outside) const;

    std::vector<const Teller*>& all_;
    std::vector<OutsideEnvelope> known_;  // the last `now`
};

/// What the model keeps in half floats, with twilight as dark as it is: the sky that is shown; tables for geometry.
[[nodiscard]] InHalfFloats kept_in_half(const Model& model, const AtmosphereParameters& parameters);

}  // namespace aureole::detail
