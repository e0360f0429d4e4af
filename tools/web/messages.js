// What the page says beside its pictures: what is wrong, and what screen readers are told.

const $ = (id) => document.getElementById(id);

// Shows what is wrong, one message for each subject; an empty text takes it away.
export function fault(subject, text) {
    const id = `fault-${subject}`;
    $(id)?.remove();
    if (!text)
        return;
    const message = document.createElement("p");
    const button = document.createElement("button");
    message.id = id;
    message.className = "fault";
    button.type = "button";
    button.textContent = "Dismiss";
    button.onclick = () => message.remove();
    message.append(button, Object.assign(document.createElement("span"), { textContent: text }));
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
