// The controls of the page: what they can be set to, showing a state in them, and reporting changes.
import { fault } from "./messages.js";
import { OWN_DEFAULTS } from "./state.js";

// The values of each key that is chosen from a list, with names where they differ from values.
const CHOICES = {
    model: [["teapot", "Teapot"], ["triangle", "Triangle"], ["square", "Square"], ["cube", "Cube"]],
    size: [["320x240"], ["384x288"], ["512x384"], ["640x480"], ["800x600"], ["1024x1024"], ["1280x720"], ["1920x1080"]],
    shader: [
        ["vertex-color", "Vertex colour"], ["unlit", "Unlit"], ["flat", "Flat"], ["gouraud", "Gouraud"],
        ["toon", "Toon"], ["phong", "Phong"], ["blinn-phong", "Blinn-Phong"], ["normals", "Normals"],
        ["depth", "Depth"],
    ],
    maps: [["on"], ["off"]],
    filter: [["nearest", "Nearest"], ["linear", "Linear"], ["mipmap", "Mipmap"]],
    shadows: [["off"], ["on"]],
    samples: [["1", "1"], ["4", "4 (antialiasing)"]],
    polygons: [["fill", "Fill"], ["line", "Lines"], ["point", "Points"]],
    cull: [["none", "None"], ["back", "Back"], ["front", "Front"]],
    convention: [["opengl", "OpenGL"], ["direct3d", "Direct3D"], ["vulkan", "Vulkan"]],
    magnify: [["1", "1×"], ["4", "4×"], ["16", "16×"], ["64", "64×"], ["255", "255×"]],
    threads: [["auto", "automatic"], ["1"], ["2"], ["3"], ["4"], ["8"], ["16"]],
    simd: [["auto", "automatic"], ["on"], ["off"]],
};

const DEFAULTS = {
    model: "teapot",
    size: "640x480",
    shader: "phong",
    maps: "on",
    filter: "mipmap",
    shadows: "off",
    samples: "1",
    polygons: "fill",
    cull: "none",
    convention: "opengl",
    ...OWN_DEFAULTS,
};

function addOption(select, value, name = value) {
    select.add(new Option(name, value));
}

export class Controls {
    // Calls change(key, value) for every change; an empty value means the default.
    constructor(form, change) {
        this.form = form;
        this.last = null; // the control that was changed last
        for (const [key, choices] of Object.entries(CHOICES))
            for (const [value, name] of choices)
                addOption(form.elements[key], value, name);
        this.fields = [...form.elements].filter((field) => field.name !== "");
        for (const field of this.fields)
            field.addEventListener("change", () => this.report(field, change));
        form.addEventListener("submit", (event) => event.preventDefault());
    }

    report(field, change) {
        this.last = field;
        const isUnreadable = field.validity.badInput;
        this.blame(field, isUnreadable ? "This is not a number." : change(field.name, field.value.trim()));
    }

    // Says at a control what is wrong with its value; an empty text: nothing.
    blame(field, text) {
        const subject = `control-${field.name}`;
        fault(subject, text, field.closest("label") ?? field);
        if (text) {
            field.setAttribute("aria-invalid", "true");
            field.setAttribute("aria-errormessage", `fault-${subject}`);
        } else {
            field.removeAttribute("aria-invalid");
            field.removeAttribute("aria-errormessage");
        }
    }

    // Shows a state: a Map of the picture's keys, and the page's own.
    show(state, own) {
        for (const field of this.fields) {
            const key = field.name;
            const value = own[key] ?? state.get(key) ?? DEFAULTS[key] ?? "";
            if (field.tagName === "SELECT" && ![...field.options].some((option) => option.value === value))
                addOption(field, value);
            if (field.value !== value)
                field.value = value;
            if (field.hasAttribute("aria-invalid"))
                this.blame(field, "");
        }
    }

    // The dropped model joins the list when there is one.
    nameDropped(name) {
        const select = this.form.elements.model;
        const option = [...select.options].find(({ value }) => value === "dropped");
        if (option)
            option.text = name;
        else
            addOption(select, "dropped", name);
    }
}
