// Hands on a picture: mouse, touch and keyboard move the camera, and choose pixels.
//
//   mouse      drag turns; with Shift or another button it pans; the wheel zooms; a click chooses
//   touch      one finger turns, two pan and zoom; a tap chooses
//   keyboard   arrows turn, with Shift they pan, + and - zoom; X begins and ends the pixel cursor

const CLICK = 4; // a pointer that moves less, in CSS pixels, clicks
const KEY_STEP = 12; // pixels of the picture for an arrow key
const WHEEL_STEP = 100; // wheel units for a step of zoom
const PINCH_STEP = 1.1; // the ratio of a step of zoom

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

// Collects parts of steps until they are whole.
class Steps {
    constructor() {
        this.rest = [0, 0];
    }

    take(x, y) {
        this.rest = [this.rest[0] + x, this.rest[1] + y];
        const whole = this.rest.map(Math.trunc);
        this.rest = this.rest.map((rest, i) => rest - whole[i]);
        return whole;
    }
}

// Calls hand.turn, pan, zoom(…) in whole pixels of the picture, hand.choose(x, y) for a pixel
// (y from the bottom), hand.cursor(key, fast) for keys of the pixel cursor. The cursor is on while
// hand.hasCursor() is true; hand.toggleCursor() begins or ends it.
export function attach(canvas, hand) {
    const pointers = new Map();
    const steps = new Steps();
    const zooms = new Steps();
    let moved = 0;
    let pinch = 0;

    const scale = () => canvas.width / canvas.getBoundingClientRect().width;
    const isStill = (event) => event.pointerType === "touch" && getComputedStyle(canvas).touchAction !== "none";

    const middle = () => {
        const all = [...pointers.values()];
        return [0, 1].map((i) => all.reduce((sum, at) => sum + at[i], 0) / all.length);
    };
    const spread = () => {
        const [a, b] = [...pointers.values()];
        return Math.hypot(a[0] - b[0], a[1] - b[1]);
    };

    canvas.addEventListener("pointerdown", (event) => {
        if (pointers.size === 0)
            moved = 0;
        pointers.set(event.pointerId, [event.clientX, event.clientY]);
        if (pointers.size === 2)
            pinch = spread();
        if (!isStill(event))
            canvas.setPointerCapture(event.pointerId);
    });

    canvas.addEventListener("pointermove", (event) => {
        const before = pointers.get(event.pointerId);
        if (!before || pointers.size > 2)
            return;
        const from = middle();
        pointers.set(event.pointerId, [event.clientX, event.clientY]);
        const to = middle();
        const [right, down] = [0, 1].map((i) => (to[i] - from[i]) * scale());
        moved += Math.hypot(event.clientX - before[0], event.clientY - before[1]);
        if (moved < CLICK || isStill(event))
            return;
        const whole = steps.take(right, down);
        const pans = pointers.size === 2 || event.shiftKey || (event.buttons & ~1) !== 0;
        if (whole[0] !== 0 || whole[1] !== 0)
            (pans ? hand.pan : hand.turn)(...whole);
        if (pointers.size === 2 && pinch > 0) {
            const [zoom] = zooms.take(Math.log(spread() / pinch) / Math.log(PINCH_STEP), 0);
            pinch = spread();
            if (zoom !== 0)
                hand.zoom(zoom);
        }
    });

    const end = (event, mayChoose) => {
        const had = pointers.delete(event.pointerId);
        if (!had || !mayChoose || moved >= CLICK || pointers.size > 0 || event.button > 0)
            return;
        const box = canvas.getBoundingClientRect();
        const place = (at, from, length, count) =>
            Math.min(count - 1, Math.max(0, Math.floor(((at - from) / length) * count)));
        const x = place(event.clientX, box.left, box.width, canvas.width);
        const y = place(event.clientY, box.top, box.height, canvas.height);
        hand.choose(x, canvas.height - 1 - y);
    };
    canvas.addEventListener("pointerup", (event) => end(event, true));
    canvas.addEventListener("pointercancel", (event) => end(event, false));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());

    canvas.addEventListener(
        "wheel",
        (event) => {
            event.preventDefault();
            const lines = event.deltaMode === 0 ? 1 : 33;
            const [zoom] = zooms.take((-event.deltaY * lines) / WHEEL_STEP, 0);
            if (zoom !== 0)
                hand.zoom(zoom);
        },
        { passive: false }
    );

    canvas.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey)
            return;
        const arrow = ARROWS[event.key];
        const isCursor = hand.hasCursor();
        if (event.key === "x" || event.key === "X" || (isCursor && event.key === "Escape"))
            hand.toggleCursor();
        else if (isCursor && (arrow || event.key === "Enter"))
            hand.cursor(arrow ?? null, event.shiftKey);
        else if (arrow)
            (event.shiftKey ? hand.pan : hand.turn)(arrow[0] * KEY_STEP, arrow[1] * KEY_STEP);
        else if (event.key === "+" || event.key === "=")
            hand.zoom(1);
        else if (event.key === "-" || event.key === "_")
            hand.zoom(-1);
        else
            return;
        event.preventDefault();
    });
}
