#!/usr/bin/env python3
"""The application as a user sees it: results, one clear line and exit code 2 for every fault, nothing partial left behind.

Usage: cli_test.py AUREOLE SCENES [BACKEND [quick]]; works in a folder of its own, which goes with it. Exit code 77: there is no device to test on.
On Vulkan it checks what a device does; options, files and tables are the same code on every backend, and are checked on the CPU.
"quick" leaves out what takes a slow build minutes: pictures of every model, the bench, a plan that is measured, the truth of a second scene.
"""
import atexit
import os
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True  # the tree is not ours to write to

from cli_checks import pictures, plans, program, suites, tables, traces
from cli_checks.runner import FOLDER, ON_VULKAN, QUICK, failures, timed, vulkan_runs


def check_everywhere():
    timed(pictures.check_render)
    timed(pictures.check_places_that_take_no_files)
    timed(pictures.check_options_of_another_backend)
    timed(pictures.check_interrupted_sequence)
    result = timed(tables.check_probe)
    timed(traces.check_trace)
    if not QUICK:
        timed(program.check_bench)
        timed(plans.check_measured_plan)
    return result


def check_on_cpu(probed):
    timed(program.check_help)
    timed(program.check_devices)
    timed(program.check_bench_faults)
    timed(pictures.check_render_options)
    timed(pictures.check_render_faults)
    timed(tables.check_tables_that_take_no_files)
    timed(tables.check_probe_faults)
    timed(tables.check_score, probed)
    timed(traces.check_trace_again)
    timed(traces.check_interrupted_trace)
    timed(traces.check_trace_faults)
    timed(suites.check_report)
    timed(suites.check_truth)
    timed(suites.check_fit, timed(suites.check_measure))
    timed(suites.check_measure_faults)
    timed(plans.check_plan)


if ON_VULKAN and not vulkan_runs():
    print('skipped: no usable Vulkan device')
    sys.exit(77)
scratch = tempfile.mkdtemp(prefix='aureole_cli_')
atexit.register(shutil.rmtree, scratch)
os.chdir(scratch)
FOLDER.mkdir()
probed = check_everywhere()
if ON_VULKAN:
    timed(suites.check_measure)
else:
    check_on_cpu(probed)
print('\n'.join(failures) if failures else 'the command line keeps its word')
sys.exit(1 if failures else 0)
