// What the charts are: Vega-Lite specifications from rows of numbers.
'use strict';

function config() {
    const ink = token('ink-soft');
    const axis = {labelColor: ink, titleColor: ink, domainColor: token('line'), tickColor: token('line'), gridColor: token('line'),
                  gridOpacity: 0.6, titleFontWeight: 500, labelFontSize: 11, titleFontSize: 12, labelLimit: 300};
    return {background: 'transparent', font: 'system-ui, "DejaVu Sans", sans-serif', view: {stroke: null}, axis};
}

/** Tooltip of rows that have `tips`: [title, text] each, the same titles in every row. */
function tooltip(rows) {
    const tips = rows.length ? rows[0].tips : [];
    return tips.map(([title], i) => ({field: `tip${i}`, title, type: 'nominal'}));
}

const withTips = (row) => ({...row, ...Object.fromEntries(row.tips.map(([, text], i) => [`tip${i}`, text]))});

/** Log axes have no zero: it is drawn at half the least value there is, and said to be zero by its tooltip. */
function lift(values) {
    const positive = values.filter((value) => value > 0);
    const floor = positive.length ? Math.min(...positive) / 2 : 1e-6;
    return (value) => Math.max(value, floor);
}

/** Bounds of a log axis around the values, with some room. */
function bounds(values) {
    return [Math.min(...values) / 1.4, Math.max(...values) * 1.4];
}

const logAxis = (field, title, values, format) => ({
    field, type: 'quantitative', title, scale: {type: 'log', domain: bounds(values), nice: false},
    axis: {format, labelOverlap: true, tickCount: 6},
});

const colour = (field, colours) =>
    ({field, type: 'nominal', legend: null, scale: {domain: [...colours.keys()], range: [...colours.values()]}});

const wholeChart = (height, more) => ({
    width: 'container', height, autosize: {type: 'fit', contains: 'padding'},
    config: config(), ...more,
});

/** Rows: x, y (both > 0), model, whole, tips. Front: those of the rows that are on it, from cheap to exact. */
function frontChart(rows, front, titles, colours) {
    const x = logAxis('x', titles.x, rows.map((row) => row.x), titles.xFormat);
    const y = logAxis('y', titles.y, rows.map((row) => row.y), '~r');
    const on = new Set(front);
    return wholeChart(280, {
        layer: [
            {
                data: {values: front.map(({x, y}) => ({x, y}))},
                mark: {type: 'line', interpolate: 'step-after', color: token('ink-soft'), strokeWidth: 1.5},
                encoding: {x, y},
            },
            {
                data: {values: rows.map((row) => withTips({...row, on: on.has(row)}))},
                params: [{name: 'view', select: {type: 'interval', zoom: 'wheel![event.shiftKey]'}, bind: 'scales'}],
                mark: {type: 'point', size: 80, strokeWidth: 2, cursor: 'pointer'},
                encoding: {
                    x, y, color: colour('model', colours),
                    fill: {condition: {test: 'datum.whole', ...colour('model', colours)}, value: token('surface')},
                    opacity: {condition: {test: 'datum.on', value: 1}, value: 0.6},
                    tooltip: tooltip(rows),
                },
            },
        ],
    });
}

/** Rows: elevation, y (> 0), setting, model, dash (strokes), tips. */
function sunChart(rows, title, colours) {
    const encoding = {
        x: {field: 'elevation', type: 'quantitative', title: "Sun's elevation, degrees", scale: {nice: false, padding: 8},
            axis: {tickCount: 10}},
        y: logAxis('y', title, rows.map((row) => row.y), '~r'),
        color: colour('model', colours),
        detail: {field: 'setting', type: 'nominal'},
    };
    return wholeChart(340, {
        data: {values: rows.map(withTips)},
        layer: [
            {mark: {type: 'line', strokeWidth: 2}, encoding: {...encoding, strokeDash: {field: 'dash', type: 'nominal', scale: null}}},
            {mark: {type: 'point', filled: true, size: 55, opacity: 1}, encoding: {...encoding, tooltip: tooltip(rows)}},
        ],
    });
}

/** Rows: setting, part, order, value, tips; totals: setting, value. Log: points side by side instead of bars on each other. */
function splitChart(rows, totals, settings, title, colours, log) {
    const parts = [...colours.keys()];
    const values = [...rows, ...totals].map((row) => row.value);
    const x = log ? logAxis('value', title, values, '~r')
                  : {field: 'value', type: 'quantitative', title, axis: {format: '~r'}};
    const y = {field: 'setting', type: 'nominal', title: null, sort: settings};
    const encoding = {x: log ? x : {...x, stack: 'zero'}, y, color: colour('part', colours), tooltip: tooltip(rows)};
    return wholeChart(50 + 22 * settings.length, {
        layer: [
            {
                data: {values: rows.map((row) => withTips({...row, order: parts.indexOf(row.part)}))},
                mark: log ? {type: 'point', filled: true, size: 80, opacity: 1} : {type: 'bar', height: 11},
                encoding: log ? encoding : {...encoding, order: {field: 'order', type: 'quantitative'}},
            },
            ...(totals.length ? [{
                data: {values: totals.map(withTips)},
                mark: {type: 'tick', color: token('ink'), thickness: 2.5, size: 19},
                encoding: {x, y, tooltip: tooltip(totals)},
            }] : []),
        ],
    });
}
