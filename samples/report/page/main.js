// Fills the page from the data in it.
'use strict';

function head(data) {
    const amount = (n, one, many) => `${n} ${n === 1 ? one : many}`;
    document.getElementById('measured').textContent =
        `Suite ${data.suite}: ${amount(data.scenes, 'scene', 'scenes')} of ${amount(data.classes.length, 'class', 'classes')}, ` +
        `${amount(data.settings.length, 'setting', 'settings')}, ${amount(data.results, 'result', 'results')}.`;
    const costs = data.classes.some((of) => of.settings.some(({costs}) => Object.keys(costs).length));
    const devices = [['Library', data.library ? `Aureole ${data.library}` : 'not named'], ['Errors measured on', data.device],
                     ['Costs measured on', costs && data.cost_device ? data.cost_device : NOT_MEASURED]];
    document.getElementById('devices').append(...devices.flatMap(
        ([term, text]) => [element('dt', {textContent: term}), element('dd', {textContent: text})]));
    for (const note of document.querySelectorAll('.note')) note.textContent = data.note;
}

document.addEventListener('DOMContentLoaded', () => {
    const data = JSON.parse(document.getElementById('data').textContent);
    const settings = new Map(data.settings.map((setting) => [setting.id, setting]));
    let sections = [];
    startTheme(() => sections.forEach((redraw) => redraw()));
    head(data);
    for (const form of document.forms) form.addEventListener('submit', (event) => event.preventDefault());
    sections = [fronts(data, settings), sun(data, settings), split(data), simplifications(data), pictures(data), numbers(data)];
    sections.forEach((redraw) => redraw());
});
