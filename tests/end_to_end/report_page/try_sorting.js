// Sorts every table of a report by every column, by mouse and by keyboard.

/// Of a column: values of its cells from above, null where a cell has none; and what aria-sort says.
function readColumn(table, column) {
    const cells = [...table.tBodies[0].rows].map((row) => row.cells[column]);
    return {
        values: cells.map((cell) => {
            const value = cell.dataset.value;
            if (value === 'nan') return null;
            if (value !== undefined) return Number(value.replace('inf', 'Infinity'));
            return cell.textContent.trim() || null;
        }),
        said: [...table.tHead.rows[0].cells].map((head) => head.getAttribute('aria-sort')),
    };
}

/// Whether a comes before b, or with it.
function inOrder(a, b, direction) {
    if (b === null) return true;
    if (a === null) return false;
    const [aIsText, bIsText] = [typeof a === 'string', typeof b === 'string'];
    if (aIsText !== bIsText) return bIsText;
    if (aIsText) return direction * a.localeCompare(b, 'en', { numeric: true }) <= 0;
    return direction > 0 ? a <= b : a >= b;
}

/// @returns {Promise<string[]>} problems
export async function trySorting(page) {
    const problems = [];
    const tables = page.locator('table.sortable');
    for (let t = 0; t < await tables.count(); ++t) {
        const table = tables.nth(t), buttons = table.locator('thead button');
        for (let column = 0; column < await buttons.count(); ++column) {
            const button = buttons.nth(column);
            const tries = [['click', 1, () => button.click()],
                           ['Enter', -1, () => button.press('Enter')],
                           ['Space', 1, () => button.press('Space')]];
            for (const [how, direction, act] of tries) {
                await act();
                const { values, said } = await table.evaluate(readColumn, column);
                const sorted = values.every(
                    (value, n) => n === 0 || inOrder(values[n - 1], value, direction));
                const word = direction > 0 ? 'ascending' : 'descending';
                const told = said.every((own, n) => own === (n === column ? word : null));
                if (!sorted || !told)
                    problems.push(`table ${t}, column ${column}, ${how}: ` +
                                  `${JSON.stringify(values)}, aria-sort ${said}`);
            }
        }
    }
    return problems;
}
