// volk's implementation, compiled into this library under private names (see volk_private.h).
#include "volk_private.h"

#include <volk.c>  // NOLINT(bugprone-suspicious-include): meant
