// Source of messages: a recording in the page, an enclosing editor, or the server that sent the page.

import { Inbox } from "./inbox";
import type { Message } from "./protocol";
import { framesOf } from "./recording";
import type { Store } from "./store";

/** Milliseconds between attempts to reconnect. */
const AGAIN = 1000;

/** Milliseconds without a message after which the server counts as silent. It sends the clock each second. */
const SILENCE = 3000;

/** Milliseconds for which a recording is read before the page is drawn. */
const READING = 400;

interface Editor {
  postMessage: (message: object) => void;
}

export function connect(store: Store): void {
  const recording = document.getElementById("recording")?.textContent;
  const editor = (window as { acquireVsCodeApi?: () => Editor }).acquireVsCodeApi?.();
  if (recording) {
    void playRecording(store, recording);
  } else if (editor !== undefined) {
    followEditor(store, editor);
  } else {
    openSocket(store, new URL("socket", location.href.replace(/^http/, "ws")));
  }
}

async function playRecording(store: Store, encoded: string): Promise<void> {
  try {
    const inbox = new Inbox(store);
    let begun = performance.now();
    for (const frame of await framesOf(encoded)) {
      inbox.add("text" in frame ? frame.text : frame.samples);
      if (performance.now() - begun > READING) {
        inbox.empty();
        await drawn();
        begun = performance.now();
      }
    }
    inbox.empty();
    store.chosen.value = store.chosen.peek() ?? 0;
  } catch (fault) {
    store.lost.value = `The recording cannot be read: ${fault instanceof Error ? fault.message : String(fault)}`;
  }
}

/** Waits until the browser has drawn the page. */
function drawn(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve));
}

function followEditor(store: Store, editor: Editor): void {
  store.send = (command) => editor.postMessage(command);
  store.openLine.value = (source) => editor.postMessage({ command: "reveal", source });
  store.launch.value = (noDebug) => editor.postMessage({ command: "launch", noDebug });
  const inbox = new Inbox(store);
  window.addEventListener("message", ({ data }: MessageEvent<unknown>) => {
    for (const message of Array.isArray(data) ? data : [data]) {
      if (message instanceof ArrayBuffer) {
        inbox.add(message);
      } else if (ArrayBuffer.isView(message)) {
        inbox.add(message.buffer.slice(message.byteOffset, message.byteOffset + message.byteLength) as ArrayBuffer);
      } else if (typeof message === "object" && message !== null && "kind" in message) {
        inbox.add(message as Message);
      }
    }
  });
  editor.postMessage({ command: "ready" });
}

function openSocket(store: Store, address: URL): void {
  const socket = new WebSocket(address);
  socket.binaryType = "arraybuffer";
  socket.addEventListener("open", () => (store.send = (command) => socket.send(JSON.stringify(command))));
  const inbox = new Inbox(store);
  let silence: number | undefined;
  const hear = (): void => {
    clearTimeout(silence);
    store.isSilent.value = false;
    silence = window.setTimeout(() => (store.isSilent.value = true), SILENCE);
  };
  socket.addEventListener("message", ({ data }: MessageEvent<string | ArrayBuffer>) => {
    hear();
    inbox.add(data);
  });
  socket.addEventListener("close", () => {
    clearTimeout(silence);
    store.isSilent.value = false;
    inbox.empty();
    const hasEnded = store.end.peek() !== undefined;
    store.lose(hasEnded ? "The run and its server have ended." : "The connection to the run is lost.");
    // A later server on this address may have the same secret, so the page tries to connect again.
    setTimeout(() => openSocket(store, address), AGAIN);
  });
}
