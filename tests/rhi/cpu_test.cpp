#include <aureole/cpu/cpu_device.h>
#include <doctest/doctest.h>

#include "rhi/conformance.h"

using namespace aureole;

TEST_CASE("the CPU device in float does what every device must") {
    const auto device = cpu::create_cpu_device({});
    conformance::run_all({device->device(), device->queue(), true});
}

TEST_CASE("the CPU device in double does what every device must") {
    const auto device = cpu::create_cpu_device({.precision = cpu::Precision::float64});
    conformance::run_all({device->device(), device->queue(), true});
}

TEST_CASE("the CPU device with one thread does what every device must") {
    const auto device = cpu::create_cpu_device({.threads = 1});
    conformance::run_all({device->device(), device->queue(), true});
}
