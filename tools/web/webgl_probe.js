// Experiments with WebGL about one pixel: it draws one triangle alone, and returns what its shader has there
// before anything is rounded to bytes; and it returns where its vertex shader puts corners.
import { mapsOf, probesOf, programTexts } from "./shaders.js";

const ABSENT = 1e30; // no value of a shader is as large

export class WebGLProbe {
    // Uses a renderer (webgl.js) that has drawn the description last.
    constructor(renderer, description) {
        this.renderer = renderer;
        this.gl = renderer.gl;
        this.description = description;
        this.hasFloats = this.gl.getExtension("EXT_color_buffer_float") !== null;
    }

    // How many bits of a pixel corners are rounded to, as the driver says.
    subpixelBits() {
        return this.gl.getParameter(this.gl.SUBPIXEL_BITS);
    }

    // The row of the framebuffer that is row y of the picture, counted from the bottom.
    row(y) {
        return this.description.topDown ? this.description.height - 1 - y : y;
    }

    // Draws a triangle alone. Returns the values of its fragment at a pixel by name, a Map; null if it has none
    // there, or if this WebGL has no framebuffer of floats.
    values(number, primitive, x, y) {
        const { gl, renderer, description } = this;
        const draw = description.draws[number];
        if (!this.hasFloats || !isFilled(draw))
            return null;
        const framebuffer = gl.createFramebuffer();
        const buffer = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
        // The viewport stays that of the picture, so that corners are rounded as in the picture.
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32F, description.width, description.height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, buffer);
        try {
            const found = new Map();
            for (const { names, text } of probesOf(draw)) {
                const value = this.drawProbe(draw, primitive, x, this.row(y), text);
                if (!value)
                    return null;
                names.forEach((name, c) => found.set(name, value[c]));
            }
            return found;
        } finally {
            gl.disable(gl.SCISSOR_TEST);
            gl.deleteFramebuffer(framebuffer);
            gl.deleteRenderbuffer(buffer);
            renderer.forgetElements();
        }
    }

    drawProbe(draw, primitive, x, row, text) {
        const { gl, renderer, description } = this;
        const mesh = renderer.meshes[draw.mesh];
        const value = new Float32Array(4);
        renderer.prepare(renderer.programOf(programTexts(draw, description, text)), draw, description);
        gl.viewport(0, 0, description.width, description.height);
        gl.enable(gl.SCISSOR_TEST);
        gl.scissor(x, row, 1, 1);
        gl.colorMask(true, true, true, true);
        gl.clearBufferfv(gl.COLOR, 0, [ABSENT, ABSENT, ABSENT, ABSENT]);
        gl.disable(gl.DEPTH_TEST);
        gl.disable(gl.BLEND);
        renderer.setCulling(draw);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.elements);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.indices.slice(3 * primitive, 3 * primitive + 3), gl.DYNAMIC_DRAW);
        gl.drawElements(gl.TRIANGLES, 3, gl.UNSIGNED_INT, 0);
        gl.bindVertexArray(null);
        gl.readPixels(x, row, 1, 1, gl.RGBA, gl.FLOAT, value);
        return value[0] === ABSENT ? null : [...value];
    }

    // Where the corners of a triangle lie in the window, by WebGL's vertex shader; null if one of them lies behind
    // the eye.
    corners(number, primitive) {
        const { gl, renderer, description } = this;
        const draw = description.draws[number];
        const mesh = renderer.meshes[draw.mesh];
        const program = renderer.programOf(programTexts(draw, description), ["gl_Position"]);
        const buffer = gl.createBuffer();
        const feedback = gl.createTransformFeedback();
        const clip = new Float32Array(12);
        renderer.prepare(program, draw, description);
        gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, feedback);
        gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, buffer);
        gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, 48, gl.DYNAMIC_READ);
        gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
        gl.enable(gl.RASTERIZER_DISCARD);
        gl.beginTransformFeedback(gl.POINTS);
        for (const index of mesh.indices.subarray(3 * primitive, 3 * primitive + 3))
            gl.drawArrays(gl.POINTS, index, 1);
        gl.endTransformFeedback();
        gl.disable(gl.RASTERIZER_DISCARD);
        gl.bindVertexArray(null);
        gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
        gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, buffer);
        gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, clip);
        gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, null);
        gl.deleteTransformFeedback(feedback);
        gl.deleteBuffer(buffer);
        return windowOf([0, 4, 8].map((at) => [...clip.subarray(at, at + 4)]), description);
    }

    // Triangles whose nearest edge is nearly at a place of the window, or that have it inside: [number of the draw,
    // primitive], the nearest to the edge first.
    trianglesNear(place, count = 12) {
        const { renderer, description } = this;
        const found = [];
        description.draws.forEach((draw, number) => {
            if (!isFilled(draw))
                return;
            const { positions, indices } = renderer.meshes[draw.mesh];
            const places = windowPlaces(draw.clipFromModel, positions, description);
            for (let i = 0; i + 2 < indices.length; i += 3) {
                const distance = distanceTo(places, indices[i], indices[i + 1], indices[i + 2], place);
                if (distance > -NEAR && distance < NEAR)
                    found.push({ number, primitive: i / 3, distance });
            }
        });
        found.sort((a, b) => Math.abs(a.distance) - Math.abs(b.distance));
        return found.slice(0, count).map(({ number, primitive }) => [number, primitive]);
    }
}

// Corners are rounded by less than a quarter of a pixel: OpenGL asks for four bits.
const NEAR = 0.25;

function isFilled(draw) {
    return draw.topology === "triangles" && draw.polygons === "fill";
}

function windowOf(clips, { width, height }) {
    if (clips.some(([, , , w]) => !(w > 0)))
        return null;
    return clips.map(([x, y, , w]) => [(x / w * 0.5 + 0.5) * width, (y / w * 0.5 + 0.5) * height]);
}

// The places of all vertices in the window, x and y; NaN for those behind the eye.
function windowPlaces(m, { numbers, components }, { width, height }) {
    const places = new Float64Array(numbers.length / components * 2);
    for (let i = 0, at = 0; i < places.length; i += 2, at += components) {
        const p = [0, 1, 2, 3].map((c) => (c < components ? numbers[at + c] : c === 3 ? 1 : 0));
        const row = (r) => m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r] * p[3];
        const w = row(3) > 0 ? row(3) : NaN;
        places[i] = (row(0) / w * 0.5 + 0.5) * width;
        places[i + 1] = (row(1) / w * 0.5 + 0.5) * height;
    }
    return places;
}

// The distance from the nearest edge, above 0 inside; NaN where a corner has no place.
function distanceTo(places, i, j, k, [x, y]) {
    const edge = (a, b) => {
        const [dx, dy] = [places[2 * b] - places[2 * a], places[2 * b + 1] - places[2 * a + 1]];
        return (dx * (y - places[2 * a + 1]) - dy * (x - places[2 * a])) / Math.hypot(dx, dy);
    };
    const area = (places[2 * j] - places[2 * i]) * (places[2 * k + 1] - places[2 * i + 1]) -
        (places[2 * j + 1] - places[2 * i + 1]) * (places[2 * k] - places[2 * i]);
    const sign = area < 0 ? -1 : 1;
    return Math.min(sign * edge(i, j), sign * edge(j, k), sign * edge(k, i));
}
