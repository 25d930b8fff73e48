#!/usr/bin/env python3
"""docs/cli.md names every option of every command, and no other.

    cli_test.py AUREOLE docs/cli.md

The section "Where it runs" counts for every command that has --backend.
"""
import re
import subprocess
import sys

OPTION = re.compile(r'--[a-z][a-z-]*')
COMMON = {'--help'}


def help_of(program, *command):
    done = subprocess.run([program, *command, '--help'], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout


def options_of(text):
    """Options that a help text declares: at the start of a line, after their short form if they have one."""
    found = set()
    for line in text.splitlines():
        match = re.match(r'\s+((?:-\w,)?--[a-z-]+(?:,--[a-z-]+)*)\b', line)
        if match:
            found.update(OPTION.findall(match.group(1)))
    return found - COMMON


def sections_of(page):
    """Options in the first cells of each section's tables."""
    sections, title = {}, ''
    for line in page.splitlines():
        if line.startswith('## '):
            title = line[3:].strip()
            sections[title] = set()
        elif line.startswith('| ') and title:
            sections[title].update(OPTION.findall(line.split('|')[1]))
    return sections


def check(program, page):
    text = help_of(program)
    commands = re.findall(r'^  ([a-z]+)  ', text[text.index('Subcommands:'):].split('\n\n')[0], re.M)
    sections = sections_of(page)
    shared = sections.get('Where it runs', set())
    problems = [] if commands else ['no command found in the help text']
    for command in commands:
        if command not in sections:
            problems.append(f'no section on {command}')
            continue
        real = options_of(help_of(program, command))
        said = sections[command] | (shared if '--backend' in real else set())
        problems += [f'{command}: {option} is not documented' for option in sorted(real - said)]
        problems += [f'{command}: {option} does not exist' for option in sorted(said - real)]
    return problems


if __name__ == '__main__':
    with open(sys.argv[2], encoding='utf-8') as f:
        report = check(sys.argv[1], f.read())
    print('\n'.join(report) if report else 'the page names every option')
    sys.exit(1 if report else 0)
