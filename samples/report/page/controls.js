// Choices above charts and tables, colours, and the two themes.
'use strict';

function element(name, properties = {}, ...children) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
}

/** A labelled <select> in the form; `options` are texts or [value, text]. The function it returns says what is chosen. */
function addSelect(form, label, options, onChange, chosen = undefined) {
    const select = element('select', {name: label});
    for (const option of options) {
        const [value, text] = Array.isArray(option) ? option : [option, option];
        select.append(element('option', {value, textContent: text}));
    }
    if (chosen !== undefined) select.value = chosen;
    select.addEventListener('change', onChange);
    form.append(element('label', {textContent: label + ' '}, select));
    return () => select.value;
}

const STATISTICS = [['median', 'median'], ['p95', '95th percentile'], ['max', 'maximum']];

/** In each theme: tones that differ for readers who see few colours, in an order that keeps neighbours apart. */
const SERIES = {
    light: ['#2a78d6', '#eb6834', '#1baf7a', '#eda100', '#e87ba4', '#008300', '#4a3aa7', '#e34948'],
    dark: ['#3987e5', '#d95926', '#199e70', '#c98500', '#d55181', '#00a000', '#9085e9', '#e66767'],
};
const PARTS = {light: ['#eda100', '#1baf7a', '#4a3aa7'], dark: ['#c98500', '#199e70', '#9085e9']};

const theme = () => document.documentElement.dataset.theme;
const token = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** Model to colour, the same in every chart; models in the order of the settings. */
function modelColours(data) {
    const models = [...new Set(data.settings.map((setting) => setting.model))];
    return new Map(models.map((model, i) => [model, SERIES[theme()][i % SERIES.light.length]]));
}

function startTheme(onChange) {
    const dark = window.matchMedia('(prefers-color-scheme: dark)');
    const set = (name) => {
        document.documentElement.dataset.theme = name;
        onChange();
    };
    document.getElementById('theme').addEventListener('click', () => set(theme() === 'dark' ? 'light' : 'dark'));
    dark.addEventListener('change', () => set(dark.matches ? 'dark' : 'light'));
    document.documentElement.dataset.theme = dark.matches ? 'dark' : 'light';
}
