// Numbers with their units, as the tables in Markdown have them.
'use strict';

const NOT_MEASURED = 'not measured';

/** Three digits at most, without an exponent. Infinity comes as null: JSON has none. */
function shortNumber(value) {
    if (value === null || value === Infinity) return '∞';
    const size = Math.abs(value);
    if (size === 0) return '0';
    if (size < 0.5e-4) return '<0.0001';
    const decimals = Math.min(Math.max(2 - Math.floor(Math.log10(size)), 0), 4);
    const text = value.toFixed(decimals);
    return text.includes('.') ? text.replace(/\.?0+$/, '') : text;
}

function count(value) {
    for (const [unit, name] of [[1e9, ' G'], [1e6, ' M'], [1e3, ' k']])
        if (Math.abs(value) >= unit) return shortNumber(value / unit) + name;
    return shortNumber(value);
}

/** How each unit of the data is shown: factor and name on axes, text in tables and hovers. */
const UNITS = {
    percent: {factor: 100, suffix: ' %'},
    delta_e: {factor: 1, suffix: ''},
    milliseconds: {factor: 1, suffix: ' ms'},
    count: {factor: 1, suffix: ''},
    bytes: {factor: 1 / (1024 * 1024), suffix: ' MiB'},
};

function inUnit(value, unit, {suffix = true} = {}) {
    if (value === undefined) return NOT_MEASURED;
    const shown = unit === 'count' ? count(value) : shortNumber(value === null ? null : value * UNITS[unit].factor);
    return shown + (suffix ? UNITS[unit].suffix : '');
}

const percent = (value) => inUnit(value, 'percent');

/** A figure's title without its unit. */
const bareTitle = (figure) => figure.title.replace(/, [^,]*$/, '');
