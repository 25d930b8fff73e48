#!/usr/bin/env python3
"""Doxygen's input filter: a comment that stands for several declarations is given to each of them. Lines stay where they are.

    share_comments.py HEADER     `--self-test` checks the rules.

Shared are the comment behind (or above) a line that declares several variables, and the comment above a function by overloads of it that follow
at once.
"""
import pathlib
import re
import sys

# "double least = 0, most = 0;  ///< Both included.": type, declarators, comment.
SEVERAL = re.compile(r'^(?!\s*using )(?P<type>\s*(?:inline |static |constexpr |const )*[\w:]+(?:<[\w:, ]+>)?) (?P<names>[*]?\w+[^;()]*,[^;()]*);'
                     r'\s*(?:///< *(?P<line>.*)|/\*\*< *(?P<block>.*?) *\*/)?$')
FUNCTION = re.compile(r'^\s*(?:\[\[nodiscard\]\] |static |constexpr |virtual |inline )*[\w:<>,&* ]*?\b(?P<name>\w+)\(')
ABOVE = re.compile(r'^\s*///(?!<) ?(.*)$')


def declared(line, above):
    """A line of several declarators as one of several declarations."""
    match = SEVERAL.match(line)
    comment = match and (match['line'] or match['block'] or above)
    if not comment:
        return line
    names = [name.strip() for name in re.split(r',(?![^{]*\})', match['names'])]
    return match['type'] + ' ' + f'; /**< {comment} */ {match["type"].strip()} '.join(names) + f'; /**< {comment} */'


def shared(text):
    result, comment, name, open_function = [], [], '', False
    for line in text.split('\n'):
        above = ABOVE.match(line)
        function = FUNCTION.match(line)
        if above:
            comment, name = (comment if not name else []) + [above[1]], ''
        elif function and not open_function:
            if comment and name == function['name'] and '///<' not in line:
                line = '/** ' + ' '.join(comment) + ' */ ' + line.lstrip()
            name = function['name'] if comment else ''
        elif not open_function:
            line = declared(line, ' '.join(comment) if not name else '')
            comment, name = [], ''
        # A declaration goes on in the next line.
        open_function = not above and (function is not None or open_function) and not line.split('//')[0].rstrip().endswith((';', '}', '{'))
        result.append(line)
    return '\n'.join(result)


TEXT = """/// One.
/// More.
int f(int a,
      int b);
int f(double a);
int g(int a);

/// Size.
int width = 1, height = 2;
double x{}, y = 0;  ///< Both.
    uint32_t a, b; /**< In C. */
const char *c, *d; /**< Text. */
int alone = 3;  ///< Alone.
int none, said;
using A = B<C, D>;  ///< Either.
"""
SHARED = """/// One.
/// More.
int f(int a,
      int b);
/** One. More. */ int f(double a);
int g(int a);

/// Size.
int width = 1; /**< Size. */ int height = 2; /**< Size. */
double x{}; /**< Both. */ double y = 0; /**< Both. */
    uint32_t a; /**< In C. */ uint32_t b; /**< In C. */
const char *c; /**< Text. */ const char *d; /**< Text. */
int alone = 3;  ///< Alone.
int none, said;
using A = B<C, D>;  ///< Either.
"""

if __name__ == '__main__':
    if sys.argv[1] == '--self-test':
        found = shared(TEXT)
        sys.exit(0 if found == SHARED else f'self-test: found\n{found}')
    sys.stdout.write(shared(pathlib.Path(sys.argv[1]).read_text(encoding='utf-8')))
