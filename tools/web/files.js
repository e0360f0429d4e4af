// Takes the files of a model that were dropped or chosen, and says how far it is.
import { fault, words } from "./messages.js";

const $ = (id) => document.getElementById(id);

// Shows a sentence, and with a share from 0 to 1 a bar.
function tell(text, share = null) {
    const line = document.createElement("p");
    line.textContent = text;
    const bar = document.createElement("progress");
    if (share !== null)
        bar.value = share;
    bar.setAttribute("aria-label", text);
    $("model-report").replaceChildren(line, bar);
}

// The browser must have shown a sentence before the page's thread is busy.
function shown() {
    return new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
}

// Reads the model and hands it to all that draw. ready(model) is called when they have it. Without success the
// model before stays, and the reason stands where files are chosen.
export async function useFiles(files, { drawers, ready }) {
    if (files.length === 0)
        return;
    const report = $("model-report");
    fault("model", "");
    tell(`Reading ${files.map((file) => file.name).join(", ")} …`, 0);
    try {
        const { describeModel, readModel } = await import("./model.js");
        const engine = await drawers.createEngine();
        const model = await readModel(engine, files, async (text, share) => {
            tell(text, share);
            await shown();
        });
        tell("Handing the model to the workers …");
        await shown();
        await drawers.useModel(model, engine);
        report.replaceChildren(...describeModel(model));
        ready(model);
    } catch (error) {
        report.replaceChildren();
        fault("model", `The model cannot be used. ${words(error)}`, $("files-help"));
        $("files-help").scrollIntoView({ block: "nearest", behavior: "smooth" });
    }
}
