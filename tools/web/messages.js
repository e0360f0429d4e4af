// What the page says beside its pictures: what is wrong, and what screen readers are told.

const $ = (id) => document.getElementById(id);

// Shows what is wrong, one message for each subject; an empty text takes it away. The message stands behind `cause`,
// the element that caused it, or without one in the corner of the page, where it moves nothing.
export function fault(subject, text, cause = null) {
    const id = `fault-${subject}`;
    $(id)?.remove();
    if (!text)
        return;
    const message = document.createElement("p");
    message.id = id;
    message.className = "fault";
    if (cause) {
        message.setAttribute("role", "alert");
    } else {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = "Dismiss";
        button.onclick = () => message.remove();
        message.append(button);
    }
    message.append(Object.assign(document.createElement("span"), { textContent: text }));
    if (cause)
        cause.after(message);
    else
        $("alert").append(message);
}

export function words(error) {
    return error?.message || String(error);
}

// Tells screen readers, when nothing else has been told for a while.
let speaking = 0;
export function say(text, delay = 0) {
    clearTimeout(speaking);
    speaking = setTimeout(() => ($("spoken").textContent = text), delay);
}

export async function copy(text, what) {
    try {
        await navigator.clipboard.writeText(text);
        say(`${what} copied`);
        return true;
    } catch (error) {
        fault("copy", `The browser does not let the page copy: ${words(error)}. ${what}: ${text}`);
        return false;
    }
}
