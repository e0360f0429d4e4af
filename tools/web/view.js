// The three pictures on the page: each pixel of a picture is a whole number of pixels of the screen, and all
// three are magnified together, down to single pixels with their centres and the edges of triangles.

export const MOST = 64; // how far a picture is magnified at most

const CENTRES_AT = 24; // so large a pixel, in pixels of the screen, shows its centre
const NUMBERS_AT = 60; // and so large a one its channels
const UNITS = 256; // snapped coordinates in a pixel
const EDGES = ["#ffb000", "#33c1ff", "#ff6f91", "#7bd65a", "#c79bff", "#ffffff"];

// Sizes that the page begins with, with as many pixels of the screen as there is room for.
export const SIZES = [[640, 480], [512, 384], [384, 288], [320, 240]];

const GAP = 8; // between pictures, in CSS pixels
const NARROW = 832; // so narrow a page shows one picture below the other

// How many pixels of the screen are in a row of one picture.
export function roomOf(width, ratio) {
    const room = width < NARROW ? width : (width - 2 * GAP) / 3;
    return Math.max(1, Math.floor(room * ratio));
}

export function factorOf(width, room) {
    return Math.max(1, Math.floor(room / width));
}

// The size that fills a room best, as "WIDTHxHEIGHT": of several the largest, the smallest if none has room.
export function sizeFor(room) {
    const filled = ([width]) => width * factorOf(width, room);
    const fitting = SIZES.filter(([width]) => width <= room);
    return fitting.reduce((best, size) => (filled(size) > filled(best) ? size : best), fitting[0] ?? SIZES.at(-1)).join("x");
}

function clamp(value, least, most) {
    return Math.min(most, Math.max(least, value));
}

export class View {
    // `place` is what holds the pictures; `canvases` are by name. changed() is called after the magnification has.
    constructor(place, canvases, changed) {
        this.place = place;
        this.canvases = canvases;
        this.changed = changed;
        this.pictures = new Map();
        this.size = null;
        this.scale = 1;
        this.corner = [0, 0]; // the upper left corner of what is seen, in pixels of the picture
        this.edges = null; // what is drawn over pixels: { pixel, fragments } of an explained pixel
        addEventListener("resize", () => this.size && this.draw());
    }

    room() {
        return roomOf(this.place.clientWidth, devicePixelRatio);
    }

    // Shows a picture whose bottom row is first. Alpha is not shown: a canvas would mix the page in.
    show(name, pixels, width, height) {
        this.fit(width, height);
        const image = new ImageData(width, height);
        const from = new Uint32Array(pixels.buffer, pixels.byteOffset, width * height);
        const to = new Uint32Array(image.data.buffer);
        for (let y = 0; y < height; ++y) {
            const row = (height - 1 - y) * width;
            for (let x = 0; x < width; ++x)
                to[y * width + x] = from[row + x] | 0xff000000;
        }
        if (!this.pictures.has(name))
            this.pictures.set(name, document.createElement("canvas"));
        const picture = this.pictures.get(name);
        picture.width = width;
        picture.height = height;
        picture.getContext("2d").putImageData(image, 0, 0);
        this.drawOne(name);
    }

    // Makes room for pictures of a size. Another size than before is seen whole.
    fit(width, height) {
        const isOther = this.size?.join() !== [width, height].join();
        this.size = [width, height];
        if (isOther)
            this.whole();
        const factor = factorOf(width, this.room());
        for (const canvas of Object.values(this.canvases)) {
            if (canvas.width !== width * factor || canvas.height !== height * factor) {
                canvas.width = width * factor;
                canvas.height = height * factor;
            }
            canvas.style.width = `${canvas.width / devicePixelRatio}px`;
            canvas.style.height = `${canvas.height / devicePixelRatio}px`;
        }
    }

    draw() {
        this.fit(...this.size);
        for (const name of this.pictures.keys())
            this.drawOne(name);
        this.changed();
    }

    drawOne(name) {
        const canvas = this.canvases[name];
        const [width, height] = this.size;
        const factor = canvas.width / width;
        const context = canvas.getContext("2d");
        const [x, y] = this.corner;
        context.imageSmoothingEnabled = false;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.drawImage(this.pictures.get(name), x, y, width / this.scale, height / this.scale, 0, 0, canvas.width, canvas.height);
        const pixel = factor * this.scale;
        if (pixel >= CENTRES_AT)
            this.drawPixels(context, name, pixel);
        if (pixel >= CENTRES_AT / 3)
            this.drawEdges(context, pixel);
    }

    // The pixels' borders and centres, and their channels where there is room.
    drawPixels(context, name, pixel) {
        const [width, height] = this.size;
        const [x0, y0] = this.corner;
        const texels = this.pictures.get(name).getContext("2d", { willReadFrequently: true });
        context.lineWidth = 1;
        context.font = `${Math.round(pixel / 6)}px ui-monospace, monospace`;
        context.textAlign = "center";
        for (let y = Math.floor(y0); y < Math.min(height, y0 + height / this.scale); ++y) {
            for (let x = Math.floor(x0); x < Math.min(width, x0 + width / this.scale); ++x) {
                const [left, top] = [(x - x0) * pixel, (y - y0) * pixel];
                context.strokeStyle = "#8888";
                context.strokeRect(left, top, pixel, pixel);
                context.fillStyle = "#fff";
                context.strokeStyle = "#000";
                context.beginPath();
                context.arc(left + pixel / 2, top + pixel / 2, Math.max(1.5, pixel / 20), 0, 2 * Math.PI);
                context.fill();
                context.stroke();
                if (pixel < NUMBERS_AT)
                    continue;
                const [red, green, blue] = texels.getImageData(x, y, 1, 1).data;
                context.fillStyle = 0.3 * red + 0.6 * green + 0.1 * blue > 110 ? "#000" : "#fff";
                context.fillText(`${red} ${green} ${blue}`, left + pixel / 2, top + pixel * 0.9, pixel * 0.94);
            }
        }
    }

    // The edges of the triangles of the explained pixel, as they are after rounding.
    drawEdges(context, pixel) {
        if (!this.edges)
            return;
        const [, height] = this.size;
        const [x0, y0] = this.corner;
        this.edges.fragments.forEach(({ corners }, i) => {
            if (!corners || corners.length < 3)
                return;
            context.beginPath();
            for (const [x, y] of corners)
                context.lineTo((x / UNITS + 0.5 - x0) * pixel, (height - 0.5 - y / UNITS - y0) * pixel);
            context.closePath();
            for (const [color, width] of [["#000", 4], [EDGES[i % EDGES.length], 2]]) {
                context.strokeStyle = color;
                context.lineWidth = width;
                context.stroke();
            }
        });
        const [x, y] = this.edges.pixel;
        context.strokeStyle = "#fff";
        context.lineWidth = 3;
        context.strokeRect((x - x0) * pixel, (height - 1 - y - y0) * pixel, pixel, pixel);
    }

    // ---- Places ----

    // The place in the picture under a place on the screen, in pixels from the upper left corner.
    placeAt(canvas, clientX, clientY) {
        const box = canvas.getBoundingClientRect();
        const [width, height] = this.size;
        return [
            this.corner[0] + ((clientX - box.left) / box.width) * (width / this.scale),
            this.corner[1] + ((clientY - box.top) / box.height) * (height / this.scale),
        ];
    }

    // The pixel there, y from the bottom.
    pixelAt(canvas, clientX, clientY) {
        const [x, y] = this.placeAt(canvas, clientX, clientY).map(Math.floor);
        const [width, height] = this.size;
        return [clamp(x, 0, width - 1), height - 1 - clamp(y, 0, height - 1)];
    }

    // Where the centre of a pixel is seen, as shares of the canvas from its upper left corner; null outside.
    shareOf(x, y) {
        const [width, height] = this.size;
        const shares = [
            ((x + 0.5 - this.corner[0]) / width) * this.scale,
            ((height - y - 0.5 - this.corner[1]) / height) * this.scale,
        ];
        return shares.every((share) => share >= 0 && share <= 1) ? shares : null;
    }

    // Pixels of the picture in a CSS pixel.
    pixelsPerCss(canvas) {
        return this.size[0] / this.scale / canvas.getBoundingClientRect().width;
    }

    // ---- Magnification ----

    isMagnified() {
        return this.scale > 1;
    }

    whole() {
        this.scale = 1;
        this.corner = [0, 0];
    }

    // Magnifies around a place of the picture, which stays where it is seen.
    magnify(factor, place) {
        const before = this.scale;
        this.scale = clamp(before * factor, 1, MOST);
        if (this.scale < 1.02)
            this.scale = 1;
        this.moveTo([0, 1].map((i) => place[i] - (place[i] - this.corner[i]) * (before / this.scale)));
    }

    // Moves what is seen by pixels of the picture.
    slide(right, down) {
        this.moveTo([this.corner[0] + right, this.corner[1] + down]);
    }

    moveTo(corner) {
        this.corner = corner.map((at, i) => clamp(at, 0, this.size[i] - this.size[i] / this.scale));
        this.draw();
    }

    // Moves what is seen so that a pixel is in it.
    reveal(x, y) {
        if (this.shareOf(x, y))
            return;
        const [width, height] = this.size;
        this.moveTo([x + 0.5 - width / this.scale / 2, height - y - 0.5 - height / this.scale / 2]);
    }

    middle() {
        return this.corner.map((at, i) => at + this.size[i] / this.scale / 2);
    }
}
