#!/usr/bin/env python3
"""Turns one kernel file into a C++ source that holds it as SPIR-V, as GLSL text and as a CPU class.

Called by aureole_add_shaders and aureole_add_shader_library (AureoleShaders.cmake), which explain the rules. Standard library
only.
"""
import argparse
import os
import re
import struct
import subprocess
import sys
import tempfile

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"\s*(//.*)?$')
GUARD = re.compile(r'^\s*#\s*ifndef\s+(\w+)\s*\n\s*#\s*define\s+\1\b', re.M)


class KernelError(Exception):
    """A message for the author of the kernel, with file and line where known."""


def strip_comments(text):
    """Blanks out comments and keeps the lines."""
    def blank(match):
        return '\n' * match.group(0).count('\n')
    return re.sub(r'/\*.*?\*/|//[^\n]*', blank, text, flags=re.S)


class Flattener:
    """Replaces #include lines by the files' lines and remembers where each line came from."""

    def __init__(self, include_dirs):
        self.include_dirs = include_dirs
        self.lines = []    # text
        self.origins = []  # (file, line number), parallel to lines
        self.files = []    # every file read, in order

    def emit(self, line, origin):
        self.lines.append(line)
        self.origins.append(origin)

    def resolve(self, name, including_file, number):
        for folder in [os.path.dirname(including_file)] + self.include_dirs:
            candidate = os.path.normpath(os.path.join(folder, name))
            if os.path.isfile(candidate):
                return candidate
        searched = ', '.join([os.path.dirname(including_file)] + self.include_dirs)
        raise KernelError(f'{including_file}:{number}: error: cannot find "{name}" in {searched}')

    def add_file(self, path, included_from=None):
        if path in self.files:
            return
        with open(path, encoding='utf-8') as f:
            text = f.read()
        if included_from and not GUARD.match(strip_comments(text).lstrip()):
            raise KernelError(f'{path}:1: error: an included file must start with an include guard (#ifndef/#define)')
        self.files.append(path)
        for number, line in enumerate(text.splitlines(), 1):
            match = INCLUDE.match(line)
            if match:
                self.add_file(self.resolve(match.group(1), path, number), included_from=path)
            else:
                self.emit(line, (path, number))

    def text(self):
        return '\n'.join(self.lines) + '\n'


def run_tool(command):
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def locate(output, origins, source):
    """Rewrites glslang's "ERROR: <source>:12: ..." so that it names the author's file and line, as C++ compilers do."""
    def rewrite(match):
        line = int(match.group(2))
        path, number = origins[line - 1] if 0 < line <= len(origins) else (source, line)
        return f'{path}:{number}: {match.group(1).lower()}: '
    pattern = r'(ERROR|WARNING): (?:' + re.escape(source) + r'|0):(\d+): '
    return re.sub(pattern, rewrite, output)


def preprocess(glslang, stage, source, origins):
    code, output = run_tool([glslang, '-E', '-S', stage, source])
    if code != 0:
        raise KernelError(locate(output, origins, source))
    return output


def compile_spirv(args, stage, source, origins, folder):
    """SPIR-V words, optimized and validated."""
    spirv = os.path.join(folder, 'kernel.spv')
    code, output = run_tool([args.glslang, '-V', '--target-env', 'vulkan1.1', '-S', stage, '-o', spirv, source])
    if code != 0:
        raise KernelError(locate(output, origins, source))
    if 'WARNING' in output:
        sys.stderr.write(locate(output, origins, source))
    if args.spirv_opt:
        optimized = os.path.join(folder, 'optimized.spv')
        code, output = run_tool([args.spirv_opt, '--target-env=vulkan1.1', '-O', spirv, '-o', optimized])
        if code != 0:
            raise KernelError(f'{args.kernel}:1: error: spirv-opt failed\n{output}')
        spirv = optimized
    code, output = run_tool([args.spirv_val, '--target-env', 'vulkan1.1', spirv])
    if code != 0:
        raise KernelError(f'{args.kernel}:1: error: invalid SPIR-V\n{output}')
    with open(spirv, 'rb') as f:
        data = f.read()
    return [int.from_bytes(data[i:i + 4], 'little') for i in range(0, len(data), 4)]


SLOT = re.compile(
    r'layout\s*\(\s*set\s*=\s*0\s*,\s*binding\s*=\s*(?P<slot>\d+)\s*(?:,\s*std140\s*)?\)\s*uniform\s+'
    r'(?:(?P<sampler>sampler2D|sampler3D|samplerCube)\s+(?P<sampler_name>\w+)\s*;'
    r'|writeonly\s+(?P<image>image2DArray|image2D|image3D)\s+(?P<image_name>\w+)\s*;'
    r'|\w+_uniforms\s*\{\s*\w+\s+(?P<block_name>\w+)\s*;\s*\})')
ANY_SLOT = re.compile(r'layout\s*\([^)]*binding\s*=')
LOCAL_SIZE = re.compile(r'layout\s*\(\s*local_size_x\s*=\s*(\d+)\s*,\s*local_size_y\s*=\s*(\d+)\s*,\s*local_size_z\s*=\s*(\d+)\s*\)\s*in\s*;')
PUSH = re.compile(r'layout\s*\(\s*push_constant\s*,\s*std430\s*\)\s*uniform\s+\w+_push\s*\{\s*\w+\s+(\w+)\s*;\s*\}')
CONSTANT = re.compile(r'layout\s*\(\s*constant_id\s*=\s*(\d+)\s*\)\s*const\s+(int|bool|float)\s+(\w+)\s*=\s*([^;]+);')
CONSTANT_KINDS = {'int': 'integer', 'bool': 'boolean', 'float': 'real'}
DIMENSIONS = {'sampler2D': 'd2', 'image2D': 'd2', 'sampler3D': 'd3', 'image3D': 'd3', 'samplerCube': 'cube', 'image2DArray': 'cube'}


# Members of the CPU class's base (cpu_kernel.h): a resource of such a name would hide them.
RESERVED = {'arguments_', 'specialization', 'sampled', 'storage', 'uniforms', 'pushed', 'widen', 'kernel_main', 'real'}


def constant_bits(kernel, kind, name, value):
    """The default of a specialization constant, a literal, as the 32 bits that stand for it."""
    literal = re.sub(r'^float\s*\((.*)\)$', r'\1', value.strip()).replace(' ', '')
    try:
        if kind == 'bool':
            return {'false': 0, 'true': 1}[literal]
        if kind == 'int':
            return struct.unpack('<I', struct.pack('<i', int(literal)))[0]
        return struct.unpack('<I', struct.pack('<f', float(literal)))[0]
    except (KeyError, ValueError, OverflowError, struct.error):
        raise KernelError(f'{kernel}:1: error: the default of {name} is {value.strip()}; allowed: a literal of its type') from None


class Interface:
    """Slots, group size, push constants and specialization constants, read from the preprocessed source."""

    def __init__(self, text, kernel, stage):
        self.slots = []  # (slot, kind, dimension, name)
        for m in SLOT.finditer(text):
            if m['sampler']:
                entry = ('sampled_texture', DIMENSIONS[m['sampler']], m['sampler_name'])
            elif m['image']:
                entry = ('storage_texture', DIMENSIONS[m['image']], m['image_name'])
            else:
                entry = ('constants', 'd2', m['block_name'])
            self.slots.append((int(m['slot']),) + entry)
        if len(ANY_SLOT.findall(text)) != len(self.slots):
            raise KernelError(f'{kernel}:1: error: a resource is not declared by one of the macros of prelude.glsl')
        self.slots.sort()
        numbers = [s[0] for s in self.slots]
        for n in numbers:
            if numbers.count(n) > 1:
                raise KernelError(f'{kernel}:1: error: slot {n} is declared twice')
        if numbers and numbers[-1] > 31:
            raise KernelError(f'{kernel}:1: error: slot {numbers[-1]} is not allowed; allowed: 0 to 31')

        sizes = LOCAL_SIZE.findall(text)
        if len(sizes) != (1 if stage == 'comp' else 0):
            raise KernelError(f'{kernel}:1: error: a compute kernel has one LOCAL_SIZE(x, y, z), a fragment kernel has none')
        self.local_size = [int(v) for v in sizes[0]] if sizes else [1, 1, 1]

        self.constants = sorted((int(id), CONSTANT_KINDS[kind], constant_bits(kernel, kind, constant, value), constant)
                                for id, kind, constant, value in CONSTANT.findall(text))

        pushes = PUSH.findall(text)
        if len(pushes) > 1:
            raise KernelError(f'{kernel}:1: error: PUSH_CONSTANTS may stand only once')
        self.push = pushes[0] if pushes else None
        for resource in [s[3] for s in self.slots] + pushes:
            if resource in RESERVED:
                raise KernelError(f'{kernel}:1: error: a resource cannot be called {resource}: the word is taken')


def cpp_words(words):
    rows = [', '.join(f'0x{w:08x}' for w in words[i:i + 12]) for i in range(0, len(words), 12)]
    return ',\n    '.join(rows)


def cpp_text(text):
    """Raw string literals, in pieces that every compiler accepts."""
    pieces = [text[i:i + 8000] for i in range(0, len(text), 8000)]
    return '\n    '.join(f'R"__glsl({p})__glsl"' for p in pieces)


def cpp_source(name, stage, kernel, text, words, interface):
    cls = f'{name}_kernel'
    slots = ''.join(f'    {{{slot}, rhi::SlotKind::{kind}, rhi::Dimension::{dimension}, "{slot_name}"}},\n'
                    for slot, kind, dimension, slot_name in interface.slots)
    slot_table = f'constexpr rhi::SlotDesc slots[] = {{\n{slots}}};\n' if interface.slots else ''
    constants = ''.join(f'    {{{id}, rhi::ConstantKind::{kind}, 0x{bits:08x}, "{constant}"}},\n'
                        for id, kind, bits, constant in interface.constants)
    constant_table = f'constexpr rhi::ConstantDesc constants[] = {{\n{constants}}};\n' if interface.constants else ''
    push_size = f'sizeof(kernels::{cls}<float>::{interface.push})' if interface.push else '0'
    stage_name = 'compute' if stage == 'comp' else 'fragment'
    return f'''// Generated from {os.path.basename(kernel)} by shader_tool.py.
#include <aureole/rhi/kernel/cpu_kernel.h>

namespace aureole::kernels {{
namespace {{
AUREOLE_DEFINE_CPU_KERNEL({cls})
#include "{kernel}"
}};
}}  // namespace
}}  // namespace aureole::kernels

namespace aureole::shaders {{
namespace {{
constexpr std::uint32_t spirv[] = {{
    {cpp_words(words)}}};
constexpr std::string_view glsl =
    {cpp_text(text)};
{slot_table}{constant_table}constexpr std::size_t push_constant_bytes = {push_size};
static_assert(push_constant_bytes % 16 == 0, "push constants consist of vec4 and mat4");
static_assert(push_constant_bytes <= 128, "devices guarantee no more than 128 bytes of push constants");
}}  // namespace

extern const rhi::Shader {name};
constinit const rhi::Shader {name} = {{
    .name = "{name}",
    .stage = rhi::Stage::{stage_name},
    .local_size = {{{', '.join(str(v) for v in interface.local_size)}}},
    .push_constant_bytes = push_constant_bytes,
    .slots = {'slots' if interface.slots else '{}'},
    .spirv = spirv,
    .glsl = glsl,
    .cpu = AUREOLE_CPU_ENTRY(kernels::{cls}),
    .constants = {'constants' if interface.constants else '{}'},
}};
}}  // namespace aureole::shaders
'''


def write_whole(path, text):
    """Through a temporary file: an interrupted build never leaves half a source."""
    temporary = path + '.tmp'
    with open(temporary, 'w', encoding='utf-8') as f:
        f.write(text)
    os.replace(temporary, path)


def escape_for_make(path):
    return path.replace('\\', '\\\\').replace(' ', '\\ ').replace('#', '\\#').replace('$', '$$')


def write_depfile(args, files):
    dependencies = ' \\\n  '.join(escape_for_make(f) for f in files)
    write_whole(args.depfile, f'{escape_for_make(args.output)}: \\\n  {dependencies}\n')


def make_kernel(args):
    name, stage = re.fullmatch(r'(\w+)\.(comp|frag)\.glsl', os.path.basename(args.kernel)).groups()
    flat = Flattener(args.include)
    for line in ('#version 450', '#ifdef GL_EXT_control_flow_attributes',
                 '#extension GL_EXT_control_flow_attributes : enable', '#define AUREOLE_CONTROL_FLOW_ATTRIBUTES', '#endif'):
        flat.emit(line, (args.kernel, 1))
    flat.add_file(args.prelude)
    flat.add_file(args.kernel)
    text = flat.text()
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, 'kernel.glsl')
        with open(source, 'w', encoding='utf-8') as f:
            f.write(text)
        interface = Interface(preprocess(args.glslang, stage, source, flat.origins), args.kernel, stage)
        words = compile_spirv(args, stage, source, flat.origins, folder)
    write_whole(args.output, cpp_source(name, stage, args.kernel, text, words, interface))
    write_depfile(args, flat.files)


# Global names of the kernel language: what the macros of prelude.glsl declare, structs and functions.
GLOBALS = [re.compile(pattern, re.M) for pattern in (
    r'^(?:CONST|SPEC_\w+|SAMPLER_\w+|UNIFORMS)\(\s*\w+\s*,\s*(\w+)', r'^UNIFORMS\([^,]*,[^,]*,\s*(\w+)', r'^struct\s+(\w+)',
    r'^\w+\s+(\w+)\s*\(')]
WORD_OR_COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|\b[A-Za-z_]\w*\b', re.S)
MACRO = re.compile(r'^\s*#\s*define\s+(\w+)', re.M)


def foreign_shader_text(text):
    """Puts "aureole_private_" before the global names that are not Aureole's by their own, and ends with #undef of such macros, so
    that a shader which includes the text keeps its names."""
    names = {name for pattern in GLOBALS for name in pattern.findall(strip_comments(text))}
    names = {name for name in names if not name.lower().startswith('aureole')}
    macros = [name for name in dict.fromkeys(MACRO.findall(text)) if not name.startswith('AUREOLE_')]
    macros.append('AUREOLE_PRELUDE_GLSL')  # so that another such text behind this one has the prelude's macros again
    renamed = WORD_OR_COMMENT.sub(lambda m: ('aureole_private_' if m[0] in names else '') + m[0], text)
    return renamed + '\n' + ''.join(f'#undef {name}\n' for name in macros)


def make_library(args):
    """One GLSL text of the prelude, a file and all that it includes: for shaders of others."""
    flat = Flattener(args.include)
    flat.add_file(args.prelude)
    flat.add_file(args.library)
    write_whole(args.output, foreign_shader_text(flat.text()))
    write_depfile(args, flat.files)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    commands = parser.add_subparsers(required=True)
    kernel = commands.add_parser('kernel', help='make the C++ source of one kernel')
    kernel.add_argument('kernel')
    kernel.add_argument('--prelude', required=True)
    kernel.add_argument('-I', dest='include', action='append', default=[])
    kernel.add_argument('--glslang', required=True)
    kernel.add_argument('--spirv-val', required=True)
    kernel.add_argument('--spirv-opt')
    kernel.add_argument('--output', required=True)
    kernel.add_argument('--depfile', required=True)
    kernel.set_defaults(run=make_kernel)
    library = commands.add_parser('library', help='make one self-contained GLSL text')
    library.add_argument('library')
    library.add_argument('--prelude', required=True)
    library.add_argument('-I', dest='include', action='append', default=[])
    library.add_argument('--output', required=True)
    library.add_argument('--depfile', required=True)
    library.set_defaults(run=make_library)
    args = parser.parse_args()
    try:
        args.run(args)
    except KernelError as error:
        sys.exit(str(error).rstrip())


if __name__ == '__main__':
    main()
