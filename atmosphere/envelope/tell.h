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

/// Of all terms together, each at its greatest density, in the channel where it is greatest.
[[nodiscard]] double greatest_extinction_per_m(const AtmosphereParameters& parameters);

/// What of a model's tables ends in twilight.
[[nodiscard]] KeptInTables kept_in_tables(const Model& model, const AtmosphereParameters& parameters);

}  // namespace aureole::detail
