// Page of the pendant. It shows the received user page, and sends pressed keys.
(() => {
  const COLUMNS = 40;
  const ROWS = 14;
  const MENU = ["F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8"];
  /** Labels of the pendant's keys by name. */
  const KEYS = { Esc: "Esc", Left: "◂", Up: "▴", Down: "▾", Right: "▸", Bksp: "⌫", Return: "↵" };
  /** Names of the pendant's keys by keyboard key. */
  const NAMES = {
    Escape: "Esc", Enter: "Return", Backspace: "Bksp", ArrowLeft: "Left", ArrowRight: "Right", ArrowUp: "Up",
    ArrowDown: "Down", PageUp: "PgUp", PageDown: "PgDn", Home: "Home", End: "End",
  };

  const vscode = acquireVsCodeApi();
  const element = (id) => document.getElementById(id);
  const press = (key) => vscode.postMessage({ key });

  function addKey(parent, name, label) {
    const button = document.createElement("button");
    button.textContent = label;
    button.title = `Key ${name}`;
    // The pendant keeps the focus, so that typing continues.
    button.addEventListener("mousedown", (event) => event.preventDefault());
    button.addEventListener("click", () => press(name));
    element(parent).append(button);
  }

  function keyOf({ key, ctrlKey, metaKey, altKey }) {
    if (ctrlKey || metaKey || altKey) {
      return undefined;
    }
    return NAMES[key] ?? (MENU.includes(key) || key.length === 1 ? key : undefined);
  }

  MENU.forEach((name) => addKey("menu", name, name));
  Object.entries(KEYS).forEach(([name, label]) => addKey("keys", name, label));
  element("pendant").addEventListener("keydown", (event) => {
    const key = keyOf(event);
    // A key on a focused button presses that button.
    if (key !== undefined && event.target === element("pendant")) {
      event.preventDefault();
      event.stopPropagation();
      press(key);
    }
  });
  window.addEventListener("message", ({ data }) => {
    const lines = Array.from({ length: ROWS }, (_, row) => (data.lines[row] ?? "").padEnd(COLUMNS));
    element("title").textContent = data.title || data.screen || "User page";
    element("page").textContent = lines.join("\n");
  });
  vscode.postMessage("ready");
})();
