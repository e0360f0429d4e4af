// Turns the lessons' Markdown into HTML: headings, paragraphs, lists, tables, code that is indented
// or fenced, and within a line `code`, **bold**, links and pictures. The lessons use nothing else, and a
// line that would need more is an error.

export function escape(text) {
    return text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");
}

export function anchor(text) {
    return text.toLowerCase().replace(/[^a-z0-9 _-]/g, "").replace(/ /g, "-");
}

// Returns the HTML of one line or paragraph. linkTo says where a link leads; null: it stays text.
export function inline(text, linkTo) {
    return text.split(/(`[^`]+`)/).map((part, i) => {
        if (i % 2)
            return `<code>${escape(part.slice(1, -1))}</code>`;
        return escape(part).replace(/\*\*([^*]+)\*\*/g, "<strong>$1</strong>");
    }).join("").replace(/\[([^\]]+)\]\(([^() ]+)\)/g, (all, words, target) => {
        const to = linkTo(target);
        return to === null ? words : `<a href="${to}">${words}</a>`;
    });
}

function table(rows, linkTo) {
    const cells = (row, tag) => row.replace(/^\| ?| ?\|$/g, "").split("|")
        .map((cell) => `<${tag}>${inline(cell.trim(), linkTo)}</${tag}>`).join("");
    const head = rows[0].replace(/[| ]/g, "") ? `<thead><tr>${cells(rows[0], "th")}</tr></thead>` : "";
    const body = rows.slice(2).map((row) => `<tr>${cells(row, "td")}</tr>`).join("\n");
    return `<div class="wide"><table>${head}<tbody>${body}</tbody></table></div>`;
}

// Splits a document into blocks: {kind, text} with the kinds heading, picture, code, list, table and
// paragraph. A heading has a level, a picture a target, code a language.
export function blocks(document) {
    const lines = document.split("\n");
    const result = [];
    for (let i = 0; i < lines.length;) {
        const line = lines[i];
        const take = (matches) => {
            const from = i;
            while (i < lines.length && matches(lines[i]))
                ++i;
            return lines.slice(from, i);
        };
        let match;
        if (line === "") {
            ++i;
        } else if ((match = /^(#+) (.*)$/.exec(line))) {
            result.push({kind: "heading", level: match[1].length, text: match[2]});
            ++i;
        } else if ((match = /^!\[(.*)\]\((.*)\)$/.exec(line))) {
            result.push({kind: "picture", text: match[1], target: match[2]});
            ++i;
        } else if ((match = /^```(.*)$/.exec(line))) {
            ++i;
            result.push({kind: "code", language: match[1], text: take((l) => l !== "```").join("\n")});
            ++i;
        } else if (line.startsWith("    ")) {
            const code = take((l) => l === "" || l.startsWith("    ")).map((l) => l.slice(4));
            result.push({kind: "code", language: "", text: code.join("\n").trimEnd()});
        } else if (line.startsWith("- ")) {
            const items = take((l) => l.startsWith("- ") || l.startsWith("  "));
            result.push({kind: "list", text: items.join("\n")});
        } else if (line.startsWith("|")) {
            result.push({kind: "table", text: take((l) => l.startsWith("|")).join("\n")});
        } else {
            const text = take((l) => l !== "" && !/^(#+ |```|- |\||!\[)/.test(l)).join("\n");
            if (!text)
                throw new Error(`Markdown that is not understood: ${line}`);
            result.push({kind: "paragraph", text});
        }
    }
    return result;
}

// Returns the HTML of a block. `label` names the region of a block of code for screen readers.
export function html(block, linkTo) {
    const text = (part) => inline(part, linkTo);
    switch (block.kind) {
    case "heading": {
        const id = anchor(block.text);
        return `<h${block.level} id="${id}">${text(block.text)}</h${block.level}>`;
    }
    case "picture":
        return `<img src="${linkTo(block.target)}" alt="${escape(block.text)}">`;
    case "code":
        return `<pre class="block" tabindex="0" role="region" aria-label="Code"><code>${escape(block.text)}</code></pre>`;
    case "list":
        return `<ul>${block.text.split(/^- /m).slice(1).map((item) => `<li>${text(item.trim())}</li>`).join("\n")}</ul>`;
    case "table":
        return table(block.text.split("\n"), linkTo);
    default:
        return `<p>${text(block.text)}</p>`;
    }
}
