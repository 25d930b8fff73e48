// What the fit in fitted_test.cpp found; that test finds it again.
#include <aureole/spectrum.h>

#include "common/check.h"

namespace aureole::spectrum {

Wavelengths fitted(int n) {
    if (n == 3)
        return {.nm = {451, 535, 617},
                .to_rec709 = {{-613.337, -6915.55, 133827}, {-47650, 135274, -5758.47}, {192674, 926.545, -4050.09}}};
    if (n == 4)
        return {.nm = {448, 520, 568, 635},
                .to_rec709 = {{9446.21, -9845.16, 127064},
                              {-85301.5, 85177.9, 13358.3},
                              {117019, 60197.4, -15030.1},
                              {104558, -5437.52, -1006.87}}};
    if (n == 6)
        return {.nm = {440, 488, 541, 578, 617, 667},
                .to_rec709 = {{12251.6, -12886, 99035.8},
                              {-34251.3, 30252.3, 43817},
                              {-36774.1, 89167.6, -11036.4},
                              {76097, 27930.4, -4929.51},
                              {109122, -2088.9, -1722.18},
                              {19731, -2209.96, -148.43}}};
    aureole::detail::reject("n", std::to_string(n), "3, 4 or 6");
}

}  // namespace aureole::spectrum
