// Hands on a picture: mouse, touch and keyboard move the camera, magnify the picture and choose pixels.
//
//   mouse      drag turns; with Shift or another button it moves the camera; a click chooses. The wheel scrolls
//              the page; with Ctrl or Cmd, or when the keyboard has come to the picture, it magnifies
//   touch      one finger turns, two move the camera and magnify; a tap chooses
//   keyboard   arrows turn, with Shift they move the camera, + and - go nearer and away; Z magnifies, with
//              Shift back; X begins and ends the pixel cursor
//
// In a magnified picture a drag moves what is seen.

const CLICK = 4; // a pointer that moves less, in CSS pixels, clicks
const KEY_STEP = 12; // pixels of the picture for an arrow key
const WHEEL_DOUBLES = 240; // wheel units for twice the magnification
const KEY_FACTOR = 2; // of magnification

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

// Calls hand.turn and hand.pan in whole pixels of the picture, hand.zoom in steps, hand.choose(x, y) for a pixel
// (y from the bottom), hand.magnify(factor, place) with a place of the picture or null for the middle, hand.cursor(key,
// fast) for keys of the pixel cursor. The cursor is on while hand.hasCursor() is true; hand.toggleCursor() begins or
// ends it. hand.scrolled() is called when the wheel scrolls the page. hand.view is the View of the picture.
export function attach(canvas, hand) {
    const pointers = new Map();
    const steps = new Steps();
    const { view } = hand;
    let moved = 0;
    let pinch = 0;

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

    const drag = (event, right, down) => {
        const isPan = pointers.size === 2 || event.shiftKey || (event.buttons & ~1) !== 0;
        if (view.isMagnified() && !event.shiftKey) {
            view.slide(-right, -down);
            return;
        }
        const whole = steps.take(right, down);
        if (whole[0] !== 0 || whole[1] !== 0)
            (isPan ? hand.pan : hand.turn)(...whole);
    };

    canvas.addEventListener("pointermove", (event) => {
        const before = pointers.get(event.pointerId);
        if (!before || pointers.size > 2)
            return;
        const from = middle();
        pointers.set(event.pointerId, [event.clientX, event.clientY]);
        const to = middle();
        moved += Math.hypot(event.clientX - before[0], event.clientY - before[1]);
        if (moved < CLICK || isStill(event))
            return;
        const scale = view.pixelsPerCss(canvas);
        drag(event, (to[0] - from[0]) * scale, (to[1] - from[1]) * scale);
        if (pointers.size === 2 && pinch > 0) {
            hand.magnify(spread() / pinch, view.placeAt(canvas, ...to));
            pinch = spread();
        }
    });

    const end = (event, mayChoose) => {
        const had = pointers.delete(event.pointerId);
        if (!had || !mayChoose || moved >= CLICK || pointers.size > 0 || event.button > 0)
            return;
        hand.choose(...view.pixelAt(canvas, event.clientX, event.clientY));
    };
    canvas.addEventListener("pointerup", (event) => end(event, true));
    canvas.addEventListener("pointercancel", (event) => end(event, false));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());

    canvas.addEventListener(
        "wheel",
        (event) => {
            if (!event.ctrlKey && !event.metaKey && !canvas.matches(":focus-visible")) {
                hand.scrolled();
                return;
            }
            event.preventDefault();
            const units = event.deltaMode === 0 ? 1 : 33;
            hand.magnify(2 ** ((-event.deltaY * units) / WHEEL_DOUBLES), view.placeAt(canvas, event.clientX, event.clientY));
        },
        { passive: false }
    );

    canvas.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey)
            return;
        const arrow = ARROWS[event.key];
        const isCursor = hand.hasCursor();
        const key = event.key.toLowerCase();
        if (key === "x" || (isCursor && key === "escape"))
            hand.toggleCursor();
        else if (key === "z")
            hand.magnify(event.shiftKey ? 1 / KEY_FACTOR : KEY_FACTOR, null);
        else if (isCursor && (arrow || key === "enter"))
            hand.cursor(arrow ?? null, event.shiftKey);
        else if (arrow)
            (event.shiftKey ? hand.pan : hand.turn)(arrow[0] * KEY_STEP, arrow[1] * KEY_STEP);
        else if (key === "+" || key === "=")
            hand.zoom(1);
        else if (key === "-" || key === "_")
            hand.zoom(-1);
        else
            return;
        event.preventDefault();
    });
}
