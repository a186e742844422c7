// What can be seen of a report in the browser. The function runs in the page: it uses nothing from
// around it.

/// @returns {{problems: string[], links: string[], figures: number, tables: number,
///            sections: number, luminance: number}} luminance of the background, from 0 to 1
export function lookAtPage() {
    const problems = [];
    const expect = (condition, problem) => { if (!condition) problems.push(problem); };
    const all = (selector, root = document) => [...root.querySelectorAll(selector)];

    const scroller = document.scrollingElement;
    expect(scroller.scrollWidth <= innerWidth,
           `the page is ${scroller.scrollWidth} wide in a window of ${innerWidth}`);
    expect(document.documentElement.lang !== '', 'no language');
    expect(all('main').length === 1 && all('nav').length === 1 && all('h1').length === 1,
           'not one main, one nav, one h1');

    const ids = all('[id]').map((element) => element.id);
    expect(new Set(ids).size === ids.length, 'an id comes twice');
    let level = 1;
    for (const heading of all('h1, h2, h3, h4')) {
        const own = Number(heading.localName[1]);
        expect(own <= level + 1, `${heading.textContent}: level ${own} after ${level}`);
        level = own;
    }
    for (const link of all('a[href^="#"]'))
        expect(document.getElementById(link.getAttribute('href').slice(1)), `no ${link.hash}`);
    for (const use of all('use'))
        expect(document.getElementById(use.getAttribute('href').slice(1)), 'a mark is not defined');

    for (const figure of all('figure')) {
        const drawing = figure.querySelector('svg, img, video');
        const { width, height } = drawing.getBoundingClientRect();
        expect(width > 20 && height > 20, `${figure.id}: ${width} x ${height}`);
        expect(figure.querySelector('figcaption').textContent.trim() !== '', 'no caption');
        if (drawing.localName === 'svg') {
            expect(drawing.getAttribute('role') === 'img', `${figure.id}: not an image`);
            for (const part of ['title', 'desc'])
                expect(drawing.querySelector(`:scope > ${part}`).textContent !== '',
                       `${figure.id}: no ${part}`);
            const text = drawing.querySelector('text');
            expect(getComputedStyle(text).color === getComputedStyle(document.body).color,
                   `${figure.id}: text is not of the page's colour`);
        } else if (drawing.localName === 'img') {
            expect(drawing.naturalWidth > 0 && drawing.alt !== '', `${figure.id}: picture`);
        } else {
            expect(drawing.videoWidth > 0 && drawing.ariaLabel !== '', `${figure.id}: video`);
        }
    }

    const rgb = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
    const [red, green, blue] = rgb.map((part) => (part / 255) ** 2.2);
    return {
        problems,
        links: all('a:not([href^="#"])').map((link) => link.getAttribute('href')),
        figures: all('figure').length,
        tables: all('table.sortable').length,
        sections: all('section.experiment').length,
        luminance: 0.2126 * red + 0.7152 * green + 0.0722 * blue,
    };
}
