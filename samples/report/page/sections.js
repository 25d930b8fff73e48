// The sections with charts. Each function fills its section and returns the function that draws it again.
'use strict';

/** How many charts have been asked for and are not drawn yet; a test waits for none. */
let undrawn = 0;

function panel(grid, name, heading) {
    const chart = element('div', {className: 'chart'});
    chart.dataset.chart = name;
    const made = element('div', {className: 'panel'}, ...(heading ? [element('h3', {textContent: heading})] : []), chart);
    grid.append(made);
    return chart;
}

function draw(chart, specification) {
    if (chart.view) chart.view.finalize();
    ++undrawn;
    const options = {renderer: 'svg', mode: 'vega-lite', tooltip: {theme: theme()},
                     actions: {export: true, source: false, compiled: false, editor: false}};
    vegaEmbed(chart, specification, options)
        .then(({view}) => { chart.view = view; })
        .catch((problem) => {
            chart.replaceChildren(element('div', {className: 'failure', textContent: `This chart failed: ${problem.message}`}));
            console.error(`${chart.dataset.chart}: ${problem.message}`);
        })
        .finally(() => { --undrawn; });
}

function say(chart, text) {
    chart.replaceChildren(element('div', {className: 'missing', textContent: text}));
}

/** Away with charts that were drawn. */
function clear(grid) {
    for (const chart of grid.querySelectorAll('.chart')) if (chart.view) chart.view.finalize();
    grid.replaceChildren();
}

const unlist = (names) => (names.length ? ` Not drawn: ${names.join('; ')}.` : '');

/** Everything known of a setting in a class, for its tooltip. */
function tipsOf(data, summary, region) {
    const error = summary.regions[region];
    return [
        ['setting', summary.setting], ['scenes', String(summary.scenes)],
        ...STATISTICS.map(([key, text]) => [`${text} (${region})`, error ? percent(error[key]) : NOT_MEASURED]),
        ...data.scene_figures.map((figure) => [bareTitleOrDeltaE(figure), inUnit(summary.errors[figure.key], figure.unit)]),
        ...data.cost_figures.map((figure) => [bareTitle(figure), inUnit(summary.costs[figure.key], figure.unit)]),
    ];
}

const bareTitleOrDeltaE = (figure) => (figure.unit === 'delta_e' ? figure.title : bareTitle(figure));

/** From cheap to dear, those that are more exact than all that are cheaper. */
function paretoFront(rows) {
    const front = [];
    for (const row of [...rows].sort((a, b) => a.cost - b.cost || a.error - b.error))
        if (!front.length || row.error < front.at(-1).error) front.push(row);
    return front;
}

function fronts(data, settings) {
    const section = document.getElementById('fronts');
    const [form, legend, grid] = ['.controls', '.legend', '.grid'].map((name) => section.querySelector(name));
    const hidden = new Set();
    const statistic = addSelect(form, 'Error', STATISTICS, redraw, 'p95');
    const region = addSelect(form, 'Region', data.regions, redraw);
    const cost = addSelect(form, 'Cost', data.cost_figures.map((figure) => [figure.key, figure.title]), redraw);

    function showLegend(colours) {
        legend.replaceChildren(...[...colours].map(([model, colour]) => {
            const swatch = element('span', {className: 'swatch'});
            swatch.style.background = colour;
            const button = element('button', {type: 'button', title: 'Show or hide'}, swatch, model);
            button.setAttribute('aria-pressed', String(!hidden.has(model)));
            button.addEventListener('click', () => {
                if (!hidden.delete(model)) hidden.add(model);
                redraw();
            });
            return button;
        }));
    }

    function rowsOf(scenes, figure) {
        const rows = [], missing = [];
        for (const summary of scenes.settings) {
            const setting = settings.get(summary.setting);
            if (hidden.has(setting.model)) continue;
            const error = summary.regions[region()]?.[statistic()], price = summary.costs[figure.key];
            if (error === undefined || price === undefined) missing.push(`${summary.setting} (${NOT_MEASURED})`);
            else if (error === null) missing.push(`${summary.setting} (∞)`);
            // Over fewer scenes it is no peer of those that were measured in all.
            else if (summary.scenes < scenes.scenes) missing.push(`${summary.setting} (${summary.scenes} of ${scenes.scenes} scenes)`);
            else rows.push({cost: price, error, model: setting.model, setting: summary.setting, tips: tipsOf(data, summary, region()),
                            whole: setting.without.length === 0});
        }
        const liftX = lift(rows.map((row) => row.cost)), liftY = lift(rows.map((row) => row.error));
        for (const row of rows) {
            row.x = liftX(row.cost) * UNITS[figure.unit].factor;
            row.y = liftY(row.error) * 100;
        }
        return {rows, missing};
    }

    function redraw() {
        const colours = modelColours(data), figure = data.cost_figures.find(({key}) => key === cost());
        showLegend(colours);
        clear(grid);
        for (const scenes of data.classes) {
            const chart = panel(grid, `fronts: ${scenes.name}`, `${scenes.name} (scenes: ${scenes.scenes})`);
            const {rows, missing} = rowsOf(scenes, figure);
            if (!rows.length) {
                say(chart, `${figure.title} or error in region ${region()}: ${NOT_MEASURED}.`);
                continue;
            }
            const front = paretoFront(rows);
            const title = STATISTICS.find(([key]) => key === statistic())[1];
            draw(chart, frontChart(rows, front, {x: figure.title, xFormat: figure.unit === 'count' ? '~s' : '~r',
                                                 y: `${title} of the error (${region()}), %`}, colours));
            const list = front.map((row) => `${row.setting} (${inUnit(row.cost, figure.unit)}, ${percent(row.error)})`);
            chart.after(
                element('details', {}, element('summary', {textContent: `On the front: ${front.length} of ${rows.length}`}),
                        element('ol', {}, ...list.map((textContent) => element('li', {textContent})))),
                ...(missing.length ? [element('p', {textContent: unlist(missing).trim()})] : []));
        }
    }
    return redraw;
}

const DASHES = [[1, 0], [6, 3], [2, 3], [8, 3, 2, 3], [12, 4], [4, 2]];

function sun(data, settings) {
    const section = document.getElementById('sun');
    const [form, list, grid] = ['.controls', '.settings', '.grid'].map((name) => section.querySelector(name));
    const chosen = new Set(firstOfEachModel(data.settings));
    const scenes = addSelect(form, 'Scenes', data.classes.map(({name}) => name), redraw);
    const statistic = addSelect(form, 'Error', STATISTICS, redraw, 'p95');
    const region = addSelect(form, 'Region', data.regions, redraw);

    /** A dash for each chosen setting of a model. */
    function dashes() {
        const used = new Map();
        return new Map(data.settings.filter(({id}) => chosen.has(id)).map(({id, model}) => {
            const place = used.get(model) ?? 0;
            used.set(model, place + 1);
            return [id, DASHES[place % DASHES.length]];
        }));
    }

    function showList(colours, dash) {
        list.replaceChildren(...data.settings.map(({id, model}) => {
            const box = element('input', {type: 'checkbox', checked: chosen.has(id), name: id});
            box.addEventListener('change', () => {
                if (!chosen.delete(id)) chosen.add(id);
                redraw();
            });
            const line = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
            line.setAttribute('width', 30);
            line.setAttribute('height', 8);
            line.innerHTML = `<path d="M0 4H30" stroke="${colours.get(model)}" stroke-width="2" ` +
                             `stroke-dasharray="${(dash.get(id) ?? DASHES[0]).join(' ')}"/>`;
            return element('label', {}, box, line, id);
        }));
    }

    function redraw() {
        const colours = modelColours(data), dash = dashes();
        showList(colours, dash);
        clear(grid);
        const chart = panel(grid, 'sun');
        const rows = [], missing = [];
        for (const point of data.classes.find(({name}) => name === scenes())?.by_sun ?? []) {
            if (!chosen.has(point.setting)) continue;
            const error = point.regions[region()]?.[statistic()];
            if (error === null) missing.push(`${point.setting} at ${point.sun_elevation_deg}° (∞)`);
            if (error === undefined || error === null) continue;
            rows.push({setting: point.setting, model: settings.get(point.setting).model, elevation: point.sun_elevation_deg, error,
                       dash: dash.get(point.setting),
                       tips: [["sun's elevation", `${point.sun_elevation_deg}°`], ...tipsOf(data, point, region())]});
        }
        const liftY = lift(rows.map((row) => row.error));
        for (const row of rows) row.y = liftY(row.error) * 100;
        if (!rows.length) return say(chart, `Error of the chosen settings in region ${region()}: ${NOT_MEASURED}.`);
        const title = STATISTICS.find(([key]) => key === statistic())[1];
        draw(chart, sunChart(rows, `${title} of the error (${region()}), %`, colours));
        const shown = new Set(rows.map((row) => row.setting));
        const unmeasured = [...chosen].filter((id) => !shown.has(id)).map((id) => `${id} (${NOT_MEASURED})`);
        chart.after(element('p', {textContent: `Drawn: ${[...shown].join(', ')}.${unlist([...missing, ...unmeasured])}`}));
    }
    return redraw;
}

/** Of each model the setting that speaks for it: all kept, default quality, plain colours, as far as there is one. */
function firstOfEachModel(settings) {
    const rank = ({without, quality, spectral}) => 4 * (without.length > 0) + 2 * (quality !== 'default') + (spectral !== 'rgb');
    const best = new Map();
    for (const setting of settings)
        if (!best.has(setting.model) || rank(setting) < rank(best.get(setting.model))) best.set(setting.model, setting);
    return [...best.values()].map(({id}) => id);
}

function split(data) {
    const section = document.getElementById('split');
    const [form, legend, grid] = ['.controls', '.legend', '.grid'].map((name) => section.querySelector(name));
    const scenes = addSelect(form, 'Scenes', data.classes.map(({name}) => name), redraw);
    const what = addSelect(form, 'Of', [...data.regions, ...data.split_figures], redraw);
    const statistic = addSelect(form, 'Error', STATISTICS, redraw, 'p95');
    const scale = addSelect(form, 'Scale', [['linear', 'linear, stacked'], ['log', 'logarithmic, side by side']], redraw);

    function redraw() {
        const colours = new Map(data.parts.map((part, i) => [part, PARTS[theme()][i]]));
        legend.replaceChildren(...[...colours].map(([part, colour]) => {
            const swatch = element('span', {className: 'swatch square'});
            swatch.style.background = colour;
            return element('span', {}, swatch, part);
        }));
        clear(grid);
        const chart = panel(grid, 'split');
        const rows = [], totals = [], order = [], missing = [];
        for (const summary of data.classes.find(({name}) => name === scenes())?.settings ?? []) {
            const parts = summary.split[what()] ?? {};
            const errors = data.parts.map((part) => [part, parts[part]?.[statistic()]]);
            if (errors.every(([, error]) => error === undefined)) {
                missing.push(`${summary.setting} (${NOT_MEASURED})`);
                continue;
            }
            order.push(summary.setting);
            // Of a figure the class has the worst scene's.
            const total = summary.regions[what()]?.[statistic()] ?? (statistic() === 'median' ? undefined : summary.errors[what()]);
            const tips = [['setting', summary.setting], ...errors.map(([part, error]) => [part, percent(error)]),
                          ['each direction\'s three together', percent(parts.sum?.[statistic()])], [what(), percent(total)]];
            for (const [part, error] of errors) {
                if (error === null) missing.push(`${part} of ${summary.setting} (∞)`);
                else if (error !== undefined) rows.push({setting: summary.setting, part, error, tips});
            }
            if (typeof total === 'number') totals.push({setting: summary.setting, error: total, tips});
        }
        if (!rows.length) return say(chart, `What the errors are made of: ${NOT_MEASURED}.`);
        const log = scale() === 'log', lifted = lift([...rows, ...totals].map((row) => row.error));
        for (const row of [...rows, ...totals]) row.value = (log ? lifted(row.error) : row.error) * 100;
        const title = STATISTICS.find(([key]) => key === statistic())[1];
        draw(chart, splitChart(rows, totals, order, `${title} of each part (${what()}), %`, colours, log));
        if (missing.length) chart.after(element('p', {textContent: unlist(missing).trim()}));
    }
    return redraw;
}
