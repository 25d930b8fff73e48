// Every equation of a built site is one that KaTeX renders: equations.cjs KATEX.js SITE. Exit code 1 if one is not.
const fs = require('fs'), path = require('path');
const katex = require(path.resolve(process.argv[2]));

function* pages(folder) {
    for (const entry of fs.readdirSync(folder, {withFileTypes: true})) {
        const file = path.join(folder, entry.name);
        if (entry.isDirectory()) {
            if (entry.name !== 'api') yield* pages(file);
        } else if (entry.name.endsWith('.html')) yield file;
    }
}
const plain = text => text.replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&#39;/g, "'").replace(/&amp;/g, '&');

let count = 0, wrong = 0;
for (const file of pages(process.argv[3])) {
    const html = fs.readFileSync(file, 'utf8');
    for (const match of html.matchAll(/<(?:span|div) class="arithmatex">\s*([\s\S]*?)\s*<\/(?:span|div)>/g)) {
        const text = plain(match[1]);
        ++count;
        try {
            katex.renderToString(text.slice(2, -2), {displayMode: text.startsWith('\\['), throwOnError: true, strict: 'error'});
        } catch (problem) {
            ++wrong;
            console.log(`${path.relative(process.argv[3], file)}: ${problem.message}`);
        }
    }
}
console.log(`${count} equations, ${wrong} of them not understood`);
process.exit(wrong > 0 || count === 0 ? 1 : 0);
