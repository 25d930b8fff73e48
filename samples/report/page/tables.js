// The sections with tables and pictures.
'use strict';

function table(caption, titles, rows, textColumns = 1) {
    const cells = (name, texts) => texts.map((text, i) =>
        element(name, {textContent: text, className: i < textColumns ? 'text' : ''}));
    return element('table', {}, element('caption', {textContent: caption}),
                   element('thead', {}, element('tr', {}, ...cells('th', titles))),
                   element('tbody', {}, ...rows.map((row) => element('tr', {}, ...cells('td', row)))));
}

const missingText = (text) => element('div', {className: 'missing', textContent: text});

/** As summary.h worked it out. */
function saved({amount, share} = {}, unit) {
    if (amount === undefined) return NOT_MEASURED;
    return inUnit(amount, unit, {suffix: false}) + (share === null ? '' : ` (${Math.round(100 * share)} %)`);
}

const added = (error) => (error === null ? NOT_MEASURED : (error > 0 ? '+' : '') + inUnit(error, 'percent', {suffix: false}));

function simplifications(data) {
    const section = document.getElementById('simplifications'), place = section.querySelector('.table');
    const scenes = addSelect(section.querySelector('.controls'), 'Scenes', ['all', ...data.classes.map(({name}) => name)], redraw);
    const titles = ['Without', 'of', 'scenes', 'added median, %', 'added p95, %', 'geometry: added median, %', 'geometry: added p95, %',
                    ...data.cost_figures.map((figure) => `saved ${figure.title}`)];

    function redraw() {
        const classes = data.classes.filter(({name}) => scenes() === 'all' || name === scenes());
        place.replaceChildren(...classes.map((of) => {
            if (!of.simplifications.length) return missingText(`${of.name}: ${NOT_MEASURED}.`);
            return table(of.name, titles, of.simplifications.map((one) => [
                one.without.join(', '), one.baseline, String(one.scenes), added(one.added_median), added(one.added_p95),
                added(one.added_geometry_median), added(one.added_geometry_p95),
                ...data.cost_figures.map((figure) => saved(one.saved[figure.key], figure.unit))]), 2);
        }));
    }
    return redraw;
}

/** " (1.2 to 1.4)": of times, where 80 of 100 rounds lie. */
function spread(values, {key, unit}) {
    const ends = ['p10', 'p90'].map((end) => values[`${key}_${end}`]);
    return ends.includes(undefined) ? '' : ` (${ends.map((end) => inUnit(end, unit, {suffix: false})).join(' to ')})`;
}

function numbers(data) {
    const section = document.getElementById('numbers'), place = section.querySelector('.table');
    const form = section.querySelector('.controls');
    const scenes = addSelect(form, 'Scenes', data.classes.map(({name}) => name), redraw);
    const region = addSelect(form, 'Region of the first three', data.regions, redraw);
    const figures = [...data.scene_figures.map((figure) => ['errors', figure]), ...data.cost_figures.map((figure) => ['costs', figure])];

    function redraw() {
        const of = data.classes.find(({name}) => name === scenes());
        if (!of?.settings.length) return place.replaceChildren(missingText(`${scenes()}: ${NOT_MEASURED}.`));
        place.replaceChildren(table(
            of.name, ['Setting', 'scenes', 'median, %', 'p95, %', 'max, %', ...figures.map(([, figure]) => figure.title)],
            of.settings.map((summary) => [
                summary.setting, String(summary.scenes),
                ...STATISTICS.map(([key]) => inUnit(summary.regions[region()]?.[key], 'percent', {suffix: false})),
                ...figures.map(([kind, figure]) => inUnit(summary[kind][figure.key], figure.unit, {suffix: false}) +
                                                   spread(summary[kind], figure))])));
    }
    return redraw;
}

function pictures(data) {
    const section = document.getElementById('pictures'), place = section.querySelector('.triptych');
    const form = section.querySelector('.controls');
    if (!data.pictures.length) {
        place.append(missingText(`Pictures: ${NOT_MEASURED}.`));
        return () => {};
    }
    const ids = (key) => [...new Set(data.pictures.map((picture) => picture[key]))];
    const scene = addSelect(form, 'Scene', ids('scene'), redraw);
    const setting = addSelect(form, 'Setting', ids('setting').filter((id) => id !== 'truth'), redraw);

    function redraw() {
        const find = (id, key) => data.pictures.find((picture) => picture.scene === scene() && picture.setting === id && picture[key])?.[key];
        const shown = [['Truth', find('truth', 'png')], [setting(), find(setting(), 'png')],
                       [`Difference of ${setting()} from the truth, CIEDE2000: 0 black, 2.5 violet, 5 red, 7.5 yellow, 10 and more white`, find(setting(), 'difference_png')]];
        place.replaceChildren(...shown.map(([text, png]) => element(
            'figure', {}, png ? element('img', {src: `data:image/png;base64,${png}`, alt: `${text}, ${scene()}`}) : missingText(NOT_MEASURED),
            element('figcaption', {textContent: text}))));
    }
    return redraw;
}
