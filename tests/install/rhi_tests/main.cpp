// A host's test program: outside_rhi_tests [PART OF A CHECK'S NAME]...
#include <aureole/cpu/cpu_device.h>
#include <aureole/rhi_tests/conformance.h>

int main(int argc, char** argv) {
    const auto mine = aureole::cpu::create_cpu_device();
    return aureole::conformance::run_main({mine->device(), mine->queue(), true}, argc, argv);
}
