#!/usr/bin/env python3
"""Pictures and tables of what stability_envelope writes: docs/stability.md shows them.

    build/release/bin/stability_envelope > envelope.csv
    python3 tests/stability/plot_envelope.py envelope.csv docs/images/stability

Needs Debian's python3-matplotlib. Prints the table of the page in Markdown.
"""
import csv
import pathlib
import sys

import matplotlib

matplotlib.use('svg')
import matplotlib.pyplot as plt

matplotlib.rcParams.update({'svg.fonttype': 'none', 'svg.hashsalt': 'aureole', 'font.size': 8})

MODELS = ['fog', 'single', 'single-lut', 'hillaire', 'aureole', 'bruneton', 'reference']
COLORS = dict(zip(MODELS, ['tab:gray', 'tab:olive', 'tab:green', 'tab:red', 'tab:blue', 'tab:purple', 'tab:orange']))
BASES = {'earth': '-', 'small and hazy': ':'}
UNITS = {'altitude': 'm', 'sun elevation': 'degrees', 'radius': 'm', 'shell': 'm', 'scale height': 'm, of molecules',
         'extinction of haze': '1/km', 'extinction of all air': '1/km', 'sun radius': 'degrees',
         'table size': 'times the smallest, along every side'}
EARTH = {'altitude': 1, 'sun elevation': 45, 'radius': 6.36e6, 'shell': 1e5, 'scale height': 8e3, 'extinction of haze': 0.01,
         'extinction of all air': 0.01, 'albedo of haze': 0.9, 'albedo of ground': 0.1, 'g of haze': 0.8, 'sun radius': 0.27,
         'irradiance': 1, 'suns': 1, 'table size': 1}
LEAST, MOST, BOUND = 1e-7, 10, 0.01


def read(path):
    """{axis: {(half, model, base): {value: error}}}: the worst of a model's ways, of both backends, of sky and geometry; and where
    geometry is worse than the sky and above the bound: [(axis, base, half, model, value, sky, geometry)]."""
    axes, by_subject = {}, {}
    with open(path, encoding='utf-8') as file:
        for row in csv.DictReader(file):
            if row['subject'] == 'black':  # beside its own light: another bound
                continue
            model = row['model'].split(',')[0]
            # Where a rounding decides about an event, the rest of a path is another one: noise, of which p95 says more.
            error = float(row['p95' if model == 'reference' else 'max'])
            line = axes.setdefault(row['axis'], {}).setdefault((row['tables'] == 'half', model, row['base']), {})
            value = float(row['value'])
            line[value] = max(line.get(value, 0), error)
            at = by_subject.setdefault((row['axis'], row['base'], row['tables'] == 'half', model, value), {})
            at[row['subject']] = max(at.get(row['subject'], 0), error)
    worse = [(*at, e['sky'], e['geometry']) for at, e in by_subject.items() if e['geometry'] > max(e['sky'], BOUND)]
    return axes, worse


def text(value):
    return f'{value:.9g}' if abs(value) < 1e6 and (abs(value) >= 1e-3 or value == 0) else f'{value:.7g}'.replace('e+0', 'e').replace('e-0', 'e-')


def plot(axis, lines, folder):
    figure, panels = plt.subplots(1, 2, figsize=(9, 3.4), sharey=True)
    values = sorted({value for line in lines.values() for value in line})
    for half, panel in enumerate(panels):
        for (is_half, model, base), line in lines.items():
            if is_half == bool(half):
                x = [i for i, value in enumerate(values) if value in line]
                y = [min(max(line[values[i]], LEAST), MOST) for i in x]
                panel.plot(x, y, BASES[base], color=COLORS[model], linewidth=1)
        panel.axhline(BOUND, color='black', linewidth=0.6)
        panel.set_yscale('log')
        panel.set_ylim(LEAST, MOST)
        panel.set_xticks(range(len(values)), [text(value) for value in values], rotation=90)
        panel.grid(axis='y', linewidth=0.2)
        panel.set_title('tables in half floats' if half else 'float, or no tables', fontsize=8)
        panel.set_xlabel(f'{axis}, {UNITS[axis]}' if axis in UNITS else axis)
    panels[0].set_ylabel('largest relative error')
    handles = [plt.Line2D([], [], color=COLORS[m], linewidth=1, label=m + (', 95 of 100' if m == 'reference' else '')) for m in MODELS]
    handles += [plt.Line2D([], [], color='black', linestyle=style, linewidth=1, label=base) for base, style in BASES.items()]
    figure.tight_layout(rect=(0, 0.07, 1, 1))
    figure.legend(handles=handles, loc='lower center', ncol=9, frameon=False, fontsize=7)
    figure.savefig(folder / (axis.replace(' ', '_') + '.svg'), metadata={'Date': None})
    plt.close(figure)


def inside(axis, lines, half, base):
    """The range around Earth's value in which no model errs by more than the bound, and the largest error there by model."""
    values = sorted({v for line in lines.values() for v in line})
    bounds = {'reference': 3 * BOUND}
    bound = 2 * BOUND if half else BOUND
    fits = [all(line.get(v, 0) <= bounds.get(model, bound) for (h, model, b), line in lines.items() if h == half and b == base)
            for v in values]
    at = min(range(len(values)), key=lambda i: abs(values[i] - EARTH[axis]))
    if not fits[at]:
        return None
    low = high = at
    while low > 0 and fits[low - 1]:
        low -= 1
    while high < len(values) - 1 and fits[high + 1]:
        high += 1
    worst = {}
    for (h, model, b), line in lines.items():
        if h == half and b == base:
            worst[model] = max(worst.get(model, 0), max(line.get(v, 0) for v in values[low:high + 1]))
    return values[low], values[high], worst


def print_table(axes):
    for half in (False, True):
        models = [m for m in MODELS if not half or m not in ('fog', 'reference')]
        for base in BASES:
            print(f"\n{'half' if half else 'float'}, {base}\n\n| Axis | From | To | {' | '.join(models)} |\n|---|---|---|{'---|' * len(models)}")
            for axis, lines in axes.items():
                found = inside(axis, lines, half, base)
                cells = [f'{found[2][m]:.1e}' if m in found[2] else '' for m in models] if found else ['']
                print(f"| {axis} | {text(found[0]) if found else 'none'} | {text(found[1]) if found else ''} | {' | '.join(cells)} |")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    axes, worse = read(sys.argv[1])
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for axis, lines in axes.items():
        plot(axis, lines, folder)
    print_table(axes)
    print('\nGeometry worse than the sky, and by more than 1 %: axis, base, tables, model, value, sky, geometry')
    for axis, base, half, model, value, sky, geometry in worse:
        print(f"{axis}, {base}, {'half' if half else 'float'}, {model}, {text(value)}: {sky:.1e}, {geometry:.1e}")


if __name__ == '__main__':
    main()
