#!/usr/bin/env python3
"""What shells complete, and the manual page: asked of the shells and of man themselves, compared with what the program's help says.

Usage: manual_test.py AUREOLE. Of the shells those that are installed; bash always is. Without man-db the page's words alone are checked.
"""
import re
import shutil
import subprocess
import sys
import tempfile

AUREOLE = sys.argv[1]
failures = []


def output(*command, text=None):
    done = subprocess.run(command, input=text, capture_output=True, text=True, timeout=60)
    if done.returncode != 0 or done.stderr:
        failures.append(f'{command[:4]}: exit {done.returncode}: {done.stderr}')
    return done.stdout


def expect(truth, what):
    if not truth:
        failures.append(what)


def options_of(command):
    """As the help declares them."""
    found = set()
    for line in output(AUREOLE, *command, '--help').splitlines():
        match = re.match(r'\s+((?:-\w,)?--[a-z-]+(?:,--[a-z-]+)*|-\w)\b', line)
        if match:
            found.update(match.group(1).split(','))
    return found


def complete(script, *words):
    """What bash offers for the last word."""
    line = ' '.join(f"'{word}'" for word in ('aureole', *words))
    code = f'{script}\nCOMP_WORDS=({line}); COMP_CWORD={len(words)}; _aureole; printf "%s\\n" "${{COMPREPLY[@]}}"'
    return set(output('bash', '--norc', '-c', code).split())


def check_bash(commands):
    script = output(AUREOLE, 'completion', 'bash')
    expect(complete(script, '') == set(commands) | options_of([]), f'commands: {complete(script, "")}')
    expect(complete(script, 're') == {'render', 'report'}, f're: {complete(script, "re")}')
    for command in commands:
        offered = complete(script, command, '-')
        expect(offered == options_of([command]), f'{command} -: {sorted(offered ^ options_of([command]))}')
    backends = {'auto', 'vulkan', 'cpu', 'cpu-double'}
    for words in (['--backend', ''], ['--backend', '='], ['--backend', '=', '']):
        expect(complete(script, 'render', 'a.toml', *words) == backends, f'{words}: {complete(script, "render", "a.toml", *words)}')
    expect(complete(script, '--verbose', 'probe', '--model', 'sing') == {'single', 'single-lut'}, '--model sing')
    expect(complete(script, 'bench', '--quality', 'low,hi') == {'low,high'}, f'a list: {complete(script, "bench", "--quality", "low,hi")}')
    expect(complete(script, 'completion', '') == {'bash', 'zsh', 'fish'}, 'a word by its place')
    expect(complete(script, 'render', '') == complete(script, 'render', '-o', 'x') == set(), 'files are left to bash')


def check_other_shells(commands):
    for shell in ('zsh', 'fish'):
        script = output(AUREOLE, 'completion', shell)
        for command in commands:
            missing = [name for name in options_of([command]) if name.lstrip('-') not in script]
            expect(command in script and not missing, f'{shell}: {command}: {missing}')
        if shutil.which(shell):
            output(shell, '-n', '/dev/stdin', text=script)
    if shutil.which('fish'):
        script = output(AUREOLE, 'completion', 'fish')
        offered = output('fish', '--no-config', '-c', script + "\ncomplete -C 'aureole render --backend cpu'")
        expect({line.split('\t')[0] for line in offered.splitlines()} == {'cpu', 'cpu-double'}, f'fish: {offered}')


def check_page(commands):
    page = output(AUREOLE, 'man')
    shown = page.replace('\\-', '-')
    for command in commands:
        expect(f'.SS {command}\n' in shown, f'man: {command}')
        missing = [name for name in options_of([command]) if f'\\fB{name}\\fR' not in shown]
        expect(not missing, f'man: {command}: {missing}')
    if shutil.which('man'):
        with tempfile.NamedTemporaryFile('w', suffix='.1', encoding='utf-8') as file:
            file.write(page)
            file.flush()
            text = output('man', '--warnings', '-E', 'UTF-8', '-l', '-Tutf8', '-Z', file.name)
        expect(len(text) > len(page) / 2, 'man shows the page')


help_text = output(AUREOLE, '--help')
names = re.findall(r'^  ([a-z]+)  ', help_text[help_text.index('Subcommands:'):].split('\n\n')[0], re.M)
expect(len(names) > 10, f'commands: {names}')
check_bash(names)
check_other_shells(names)
check_page(names)
print('\n'.join(failures) if failures else f'{len(names)} commands: completed and described')
sys.exit(1 if failures else 0)
