// Opens a report of the laboratory in headless Chromium, wide and narrow, light and dark, on paper
// and without JavaScript, and looks for what a reader would miss:
//     node check_report.js CHROMIUM DIRECTORY PICTURES
// DIRECTORY holds report.html; screenshots and the printed page go to PICTURES.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { HtmlValidate } from 'html-validate';
import { chromium } from 'playwright-core';
import { lookAtPage } from './look_at_page.js';
import { trySorting } from './try_sorting.js';

const [program, directory, pictures] = process.argv.slice(2);
const file = path.resolve(directory, 'report.html');
const address = pathToFileURL(file).href;
const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const problems = [];

function expect(condition, problem) {
    if (!condition) problems.push(problem);
}

/// The page's source by the rules of HTML 5.
async function checkSource() {
    const validator = new HtmlValidate({
        root: true,
        extends: ['html-validate:standard', 'html-validate:a11y'],
    });
    const report = await validator.validateString(readFileSync(file, 'utf8'));
    for (const { messages } of report.results)
        for (const { line, column, message, ruleId } of messages)
            problems.push(`line ${line}:${column}: ${message} (${ruleId})`);
}

/// A page that reports what it should not do: say something, load something.
async function open(browser, options, name) {
    const context = await browser.newContext(options);
    const page = await context.newPage();
    page.on('console', (message) => problems.push(`${name}: console: ${message.text()}`));
    page.on('pageerror', (error) => problems.push(`${name}: ${error}`));
    page.on('request', (request) => {
        const url = request.url();
        if (url !== address && !url.startsWith('data:')) problems.push(`${name}: requests ${url}`);
    });
    await context.route(/^(?!file:|data:)/, (route) => route.abort());
    await page.goto(address);
    return page;
}

/// Tables are sorted once wide and once narrow: colours do not matter to that.
async function checkScreen(browser, width, colorScheme) {
    const name = `${width}-${colorScheme}`;
    const page = await open(browser, { viewport: { width, height: 900 }, colorScheme }, name);
    await page.waitForFunction(() => [...document.querySelectorAll('video')].every(
        (video) => video.readyState >= 1 || video.error));
    const seen = await page.evaluate(lookAtPage);
    for (const problem of seen.problems) problems.push(`${name}: ${problem}`);
    const dark = colorScheme === 'dark';
    expect(dark ? seen.luminance < 0.02 : seen.luminance > 0.9, `${name}: background`);
    for (const link of seen.links)
        expect(existsSync(path.resolve(directory, decodeURIComponent(link))), `${name}: ${link}`);
    await page.screenshot({ path: path.join(pictures, `${name}.png`), fullPage: true });
    await page.evaluate(axe);
    const { violations, passes } = await page.evaluate(() => globalThis.axe.run());
    for (const { id, nodes } of violations)
        for (const node of nodes) problems.push(`${name}: axe: ${id}: ${node.html}`);
    expect(passes.some(({ id }) => id === 'color-contrast'), `${name}: no contrast was measured`);
    if (width > 1000 !== dark)
        for (const problem of await trySorting(page)) problems.push(`${name}: ${problem}`);
    console.log(`${name}: ${seen.figures} figures, ${seen.tables} sortable tables, ` +
                `${passes.length} rules of axe passed`);
    await page.context().close();
    return seen;
}

async function checkPaper(browser, sections) {
    const page = await open(browser, { viewport: { width: 1280, height: 900 },
                                       colorScheme: 'dark' }, 'paper');
    await page.emulateMedia({ media: 'print' });
    const paper = await page.evaluate(() => ({
        background: getComputedStyle(document.body).backgroundColor,
        nav: getComputedStyle(document.querySelector('nav')).display,
    }));
    expect(paper.background === 'rgb(255, 255, 255)', `paper: background ${paper.background}`);
    expect(paper.nav === 'none', 'paper: the contents are printed');
    const pdf = await page.pdf({ preferCSSPageSize: true });
    writeFileSync(path.join(pictures, 'paper.pdf'), pdf);
    const pages = pdf.toString('latin1').match(/\/Type\s*\/Page\b/g)?.length ?? 0;
    expect(pages > sections, `paper: ${pages} pages for ${sections} sections`);
    console.log(`paper: ${pages} pages`);
    await page.context().close();
}

async function checkWithoutScript(browser, figures) {
    const page = await open(browser, { viewport: { width: 390, height: 900 },
                                       javaScriptEnabled: false }, 'no script');
    expect(await page.locator('figure:visible').count() === figures, 'no script: figures');
    expect(await page.locator('th button').count() === 0, 'no script: buttons that do nothing');
    await page.context().close();
}

mkdirSync(pictures, { recursive: true });
await checkSource();
const browser = await chromium.launch({ executablePath: program, args: ['--no-sandbox'] });
let seen;
for (const width of [1280, 390])
    for (const colorScheme of ['light', 'dark'])
        seen = await checkScreen(browser, width, colorScheme);
await checkPaper(browser, seen.sections);
await checkWithoutScript(browser, seen.figures);
await browser.close();
for (const problem of problems) console.log(problem);
console.log(problems.length === 0 ? 'good' : 'NOT GOOD');
process.exit(problems.length === 0 ? 0 : 1);
