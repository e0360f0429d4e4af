// Draws a scene with the visitor's WebGL2, from page_describe's description. The picture is read
// back, so that it can be compared byte by byte.
import { mapsOf, programTexts } from "./shaders.js";

const ATTRIBUTES = ["position", "color", "normal", "texcoord", "tangent"];
const ABSENT = { color: [1, 1, 1, 1], normal: [0, 0, 0, 1], texcoord: [0, 0, 0, 1], tangent: [0, 0, 0, 1] };
const MODES = { points: "POINTS", lines: "LINES", triangles: "TRIANGLES" };
const WRAPS = { "repeat": "REPEAT", "mirrored-repeat": "MIRRORED_REPEAT" };
const UNITS = ["diffuse", "normal", "specular", "glow", "shadow"];

export class WebGLError extends Error {}

export class WebGLRenderer {
    constructor() {
        this.canvas = document.createElement("canvas");
        this.canvas.width = this.canvas.height = 1;
        const gl = this.canvas.getContext("webgl2", {
            alpha: true,
            antialias: false,
            depth: false,
            stencil: false,
            premultipliedAlpha: false,
            preserveDrawingBuffer: true,
            powerPreference: "high-performance",
        });
        if (!gl)
            throw new WebGLError("this browser has no WebGL2, or it is switched off");
        this.gl = gl;
        gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        gl.disable(gl.DITHER);
        this.programs = new Map();
        this.meshes = [];
        this.shadows = [];
        this.contents = null;
        this.target = null;
    }

    // What draws, in the words of the driver.
    name() {
        const info = this.gl.getExtension("WEBGL_debug_renderer_info");
        const name = info && this.gl.getParameter(info.UNMASKED_RENDERER_WEBGL);
        return name || this.gl.getParameter(this.gl.RENDERER);
    }

    isLost() {
        return this.gl.isContextLost();
    }

    // Draws and returns the picture, the bottom row first, and the time in milliseconds that it
    // took with reading it back. Meshes and maps are uploaded again if the description's contents are
    // others, or are in the memory of another module.
    draw(description, memory) {
        const gl = this.gl;
        const { width, height } = description;

        this.useTarget(width, height, description.samples);
        if (this.contents !== description.contents || this.memory !== memory)
            this.uploadAll(description, memory);
        const pixels = new Uint8Array(width * height * 4);
        this.finish();

        const started = performance.now();
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.target.drawn);
        gl.viewport(0, 0, width, height);
        gl.disable(gl.SCISSOR_TEST);
        gl.colorMask(true, true, true, true);
        gl.depthMask(true);
        gl.clearColor(...description.clear);
        gl.clearDepth(1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        for (const draw of description.draws)
            this.drawOne(draw, description);
        if (this.target.resolved !== this.target.drawn) {
            gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.target.drawn);
            gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, this.target.resolved);
            gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
        }
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.target.resolved);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        const milliseconds = performance.now() - started;

        if (description.topDown)
            turnUpsideDown(pixels, width, height);
        const error = gl.getError();
        if (error !== gl.NO_ERROR)
            throw new WebGLError(`WebGL reports the error 0x${error.toString(16)}`);
        return { pixels, milliseconds };
    }

    // Waits until everything before has been done. gl.finish alone does not in all browsers.
    finish() {
        const gl = this.gl;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.target.resolved);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    }

    // ---- The framebuffer ----

    useTarget(width, height, samples) {
        const gl = this.gl;
        const have = this.target;
        if (have && have.width === width && have.height === height && have.samples === samples)
            return;
        const most = gl.getParameter(gl.MAX_RENDERBUFFER_SIZE);
        if (width > most || height > most)
            throw new WebGLError(`this WebGL draws at most ${most} pixels in a row`);
        if (have) {
            [have.drawn, have.resolved].forEach((buffer) => gl.deleteFramebuffer(buffer));
            have.buffers.forEach((buffer) => gl.deleteRenderbuffer(buffer));
            this.target = null; // what follows may fail
        }
        const buffers = [];
        const make = (count, format, attachment) => {
            const buffer = gl.createRenderbuffer();
            buffers.push(buffer);
            gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
            if (count > 1)
                gl.renderbufferStorageMultisample(gl.RENDERBUFFER, count, format, width, height);
            else
                gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
            gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, buffer);
        };
        const frame = (count, hasDepth) => {
            const framebuffer = gl.createFramebuffer();
            gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
            make(count, gl.RGBA8, gl.COLOR_ATTACHMENT0);
            if (hasDepth)
                make(count, gl.DEPTH_COMPONENT32F, gl.DEPTH_ATTACHMENT);
            if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
                throw new WebGLError(`WebGL has no framebuffer of ${width}x${height}, ${count} samples`);
            return framebuffer;
        };
        const drawn = frame(samples, true);
        const resolved = samples > 1 ? frame(1, false) : drawn;
        this.target = { width, height, samples, drawn, resolved, buffers };
    }

    // ---- Meshes and maps ----

    uploadAll(description, memory) {
        this.contents = null;
        this.meshes.forEach((mesh) => this.freeMesh(mesh));
        new Set(this.shadows).forEach((shadow) => shadow && this.gl.deleteTexture(shadow));
        const draws = [...description.draws].sort((a, b) => a.mesh - b.mesh);
        this.meshes = draws.map((draw) => this.uploadMesh(draw, memory));
        this.shadows = this.uploadShadows(draws, memory);
        this.contents = description.contents;
        this.memory = memory;
    }

    uploadMesh(draw, memory) {
        const gl = this.gl;
        const mesh = { buffers: [], textures: {}, array: gl.createVertexArray() };
        gl.bindVertexArray(mesh.array);
        ATTRIBUTES.forEach((name, location) => {
            const from = draw.attributes[name];
            if (!from)
                return;
            const numbers = new Float32Array(memory.buffer, from.at >>> 0, draw.vertices * from.components);
            this.uploadBuffer(mesh, gl.ARRAY_BUFFER, numbers);
            gl.enableVertexAttribArray(location);
            gl.vertexAttribPointer(location, from.components, gl.FLOAT, false, 0, 0);
        });
        mesh.indices = this.indicesOf(draw, memory);
        mesh.positions = this.positionsOf(draw, memory);
        mesh.elements = gl.createBuffer();
        mesh.buffers.push(mesh.elements);
        mesh.count = 0;
        for (const kind of mapsOf(draw))
            if (kind !== "shadow")
                mesh.textures[kind] = this.uploadMap(draw.maps[kind], draw.sampler, memory);
        return mesh;
    }

    uploadBuffer(mesh, target, numbers) {
        const gl = this.gl;
        const buffer = gl.createBuffer();
        mesh.buffers.push(buffer);
        gl.bindBuffer(target, buffer);
        gl.bufferData(target, numbers, gl.STATIC_DRAW);
    }

    // Kept: edges and culled lines are made of them. The module's memory may move.
    indicesOf(draw, memory) {
        return new Uint32Array(memory.buffer, draw.indices.at >>> 0, draw.indices.count).slice();
    }

    positionsOf(draw, memory) {
        const { at, components } = draw.attributes.position;
        const numbers = new Float32Array(memory.buffer, at >>> 0, draw.vertices * components);
        return { numbers: numbers.slice(), components };
    }

    freeMesh(mesh) {
        mesh.buffers.forEach((buffer) => this.gl.deleteBuffer(buffer));
        Object.values(mesh.textures).forEach((texture) => this.gl.deleteTexture(texture));
        this.gl.deleteVertexArray(mesh.array);
    }

    // All levels are those that Gnomon has made: WebGL would average them in another way.
    uploadMap(map, sampler, memory) {
        const gl = this.gl;
        const texture = gl.createTexture();
        let at = map.at >>> 0;
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        for (let level = 0; level < map.levels; ++level) {
            const width = Math.max(1, map.width >> level);
            const height = Math.max(1, map.height >> level);
            const texels = new Uint8Array(memory.buffer, at, width * height * 4);
            gl.texImage2D(gl.TEXTURE_2D, level, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
            at += texels.length;
        }
        const filter = (name) => gl[name.toUpperCase().replaceAll("-", "_")];
        // WebGL has no border: the shaders add it to the edge.
        const wrap = (name) => gl[WRAPS[name] ?? "CLAMP_TO_EDGE"];
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAX_LEVEL, map.levels - 1);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter(sampler.minify));
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter(sampler.magnify));
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wrap(sampler.wrapS));
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wrap(sampler.wrapT));
        return texture;
    }

    // The shadow maps of draws; draws with the same map share a texture. The maps are Gnomon's own,
    // so that the pictures differ only by what WebGL makes of them.
    uploadShadows(draws, memory) {
        const textures = new Map();
        return draws.map((draw) => {
            if (!mapsOf(draw).includes("shadow"))
                return null;
            const map = draw.maps.shadow;
            if (!textures.has(map.at))
                textures.set(map.at, this.uploadShadow(map, memory));
            return textures.get(map.at);
        });
    }

    uploadShadow(map, memory) {
        const gl = this.gl;
        const texture = gl.createTexture();
        const depths = new Float32Array(memory.buffer, map.at >>> 0, map.width * map.height);
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT32F, map.width, map.height, 0,
            gl.DEPTH_COMPONENT, gl.FLOAT, depths);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
        return texture;
    }

    // ---- Programs ----

    program(draw, description) {
        return this.programOf(programTexts(draw, description));
    }

    // A program of two texts. `captured` are outputs of its vertex shader that transform feedback keeps.
    programOf(texts, captured = []) {
        const key = [texts.vertex, texts.fragment, ...captured].join("\0");
        if (!this.programs.has(key))
            this.programs.set(key, this.link(texts, captured));
        return this.programs.get(key);
    }

    link(texts, captured) {
        const gl = this.gl;
        const handle = gl.createProgram();
        const compile = (type, text) => {
            const shader = gl.createShader(type);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
                throw new WebGLError(`a shader is refused: ${gl.getShaderInfoLog(shader)}`);
            gl.attachShader(handle, shader);
        };
        compile(gl.VERTEX_SHADER, texts.vertex);
        compile(gl.FRAGMENT_SHADER, texts.fragment);
        if (captured.length > 0)
            gl.transformFeedbackVaryings(handle, captured, gl.INTERLEAVED_ATTRIBS);
        gl.linkProgram(handle);
        if (!gl.getProgramParameter(handle, gl.LINK_STATUS))
            throw new WebGLError(`a program is refused: ${gl.getProgramInfoLog(handle)}`);

        const at = {};
        for (let i = gl.getProgramParameter(handle, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
            const { name } = gl.getActiveUniform(handle, i);
            at[name] = gl.getUniformLocation(handle, name);
        }
        return { handle, at };
    }

    // A uniform that the program does not use has the location null, and setting it does nothing.
    setUniforms({ at }, draw, { light }) {
        const gl = this.gl;
        const matrix = (name, value) => value && at[name] && gl.uniformMatrix4fv(at[name], false, value);
        const vector = (name, value) => value && at[name] && gl.uniform3fv(at[name], value);
        const number = (name, value) => at[name] && gl.uniform1f(at[name], value);
        matrix("clip_from_model", draw.clipFromModel);
        matrix("world_from_model", draw.worldFromModel);
        matrix("shadow_from_world", draw.shadowFromWorld);
        if (at.normal_matrix)
            gl.uniformMatrix3fv(at.normal_matrix, false, draw.normalMatrix);
        vector("light_direction", draw.lightDirection);
        vector("ambient", light.ambient);
        vector("diffuse", light.diffuse);
        vector("eye", draw.eye);
        vector("specular", draw.specular);
        if (at.exponent)
            gl.uniform1ui(at.exponent, draw.exponent);
        number("bands", draw.bands);
        number("alpha_cutoff", draw.alphaCutoff);
        number("black", draw.black);
        number("white", draw.white);
        number("point_size", draw.pointSize ?? 1);
        UNITS.forEach((kind, unit) => at[`${kind}_map`] && gl.uniform1i(at[`${kind}_map`], unit));
    }

    // ---- Drawing ----

    // Binds a program with the uniforms, maps and attributes of a draw.
    prepare(program, draw, description) {
        const gl = this.gl;
        const mesh = this.meshes[draw.mesh];
        gl.useProgram(program.handle);
        this.setUniforms(program, draw, description);
        mapsOf(draw).forEach((kind) => {
            gl.activeTexture(gl.TEXTURE0 + UNITS.indexOf(kind));
            gl.bindTexture(gl.TEXTURE_2D, kind === "shadow" ? this.shadows[draw.mesh] : mesh.textures[kind]);
        });
        gl.bindVertexArray(mesh.array);
        ATTRIBUTES.forEach((name, location) => {
            if (!draw.attributes[name] && ABSENT[name])
                gl.vertexAttrib4fv(location, ABSENT[name]);
        });
    }

    drawOne(draw, description) {
        const gl = this.gl;
        const mesh = this.meshes[draw.mesh];
        this.prepare(this.program(draw, description), draw, description);
        this.setState(draw);
        const polygons = { fill: "triangles", line: "lines", point: "points" }[draw.polygons];
        const mode = gl[MODES[draw.topology === "triangles" ? polygons : draw.topology]];
        this.useElements(draw, mesh);
        gl.drawElements(mode, mesh.count, gl.UNSIGNED_INT, 0);
        gl.bindVertexArray(null);
    }

    setState(draw) {
        const gl = this.gl;
        const set = (state, isOn) => isOn ? gl.enable(state) : gl.disable(state);
        set(gl.DEPTH_TEST, draw.depthTest);
        gl.depthFunc(gl.LESS);
        gl.depthMask(draw.depthWrite);
        set(gl.BLEND, draw.blend !== "none");
        if (draw.blend === "mix")
            gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        else
            gl.blendFuncSeparate(gl.ONE, gl.ZERO, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        this.setCulling(draw);
    }

    setCulling(draw) {
        const gl = this.gl;
        if (draw.cull === "none") {
            gl.disable(gl.CULL_FACE);
            return;
        }
        gl.enable(gl.CULL_FACE);
        gl.cullFace(draw.cull === "front" ? gl.FRONT : gl.BACK);
        gl.frontFace(draw.frontClockwise ? gl.CW : gl.CCW);
    }

    // The elements of all meshes are uploaded again before they are drawn.
    forgetElements() {
        this.meshes.forEach((mesh) => (mesh.elementsKey = null));
    }

    // WebGL has no polygon mode, so edges are drawn as lines and corners as points. The indices of a draw
    // that mixes are sorted anew for each camera.
    useElements(draw, mesh) {
        const gl = this.gl;
        const polygons = draw.topology === "triangles" ? draw.polygons : "fill";
        const culled = polygons !== "fill" && draw.cull !== "none";
        const key = polygons + (culled ? JSON.stringify([draw.cull, draw.clipFromModel]) : "");
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.elements);
        if (mesh.elementsKey === key && draw.blend !== "mix")
            return;
        if (draw.blend === "mix")
            mesh.indices = this.indicesOf(draw, this.memory);
        let indices = culled ? visibleTriangles(mesh, draw) : mesh.indices;
        if (polygons === "line")
            indices = edgesOf(indices);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.DYNAMIC_DRAW);
        mesh.count = indices.length;
        mesh.elementsKey = key;
    }
}

// Where y points down in clip space, the top row of the picture is drawn as the bottom row of the
// framebuffer, by Gnomon too. So rules that depend on y are the same.
function turnUpsideDown(pixels, width, height) {
    const row = 4 * width;
    for (let low = 0, high = height - 1; low < high; ++low, --high) {
        const kept = pixels.slice(low * row, (low + 1) * row);
        pixels.copyWithin(low * row, high * row, (high + 1) * row);
        pixels.set(kept, high * row);
    }
}

function edgesOf(triangles) {
    const edges = new Uint32Array(triangles.length * 2);
    for (let i = 0, to = 0; i < triangles.length; i += 3) {
        for (let k = 0; k < 3; ++k) {
            edges[to++] = triangles[i + k];
            edges[to++] = triangles[i + (k + 1) % 3];
        }
    }
    return edges;
}

// The triangles that culling leaves, by the sign of their area in clip space (Olano and Greer 1997).
function visibleTriangles(mesh, draw) {
    const m = draw.clipFromModel;
    const { numbers, components } = mesh.positions;
    const corner = (index) => {
        const p = numbers.subarray(index * components, index * components + components);
        const row = (r) => m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * (p[2] ?? 0) + m[12 + r] * (p[3] ?? 1);
        return [row(0), row(1), row(3)];
    };
    const left = [];
    for (let i = 0; i < mesh.indices.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map((k) => corner(mesh.indices[i + k]));
        const area =
            a[0] * (b[1] * c[2] - c[1] * b[2]) +
            a[1] * (b[2] * c[0] - c[2] * b[0]) +
            a[2] * (b[0] * c[1] - c[0] * b[1]);
        const isFront = draw.frontClockwise ? area < 0 : area > 0;
        if (isFront !== (draw.cull === "front"))
            left.push(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
    }
    return new Uint32Array(left);
}
