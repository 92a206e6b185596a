// Editor around the page: it stores the file, applies edits and sends the tables.

import type { FromEditor, Requests } from "./protocol";

interface Editor {
  postMessage: (message: object) => void;
}

export type EditorMessage = Exclude<FromEditor, { kind: "answer" }>;

interface Waiting {
  resolve: (answer: unknown) => void;
  reject: (fault: Error) => void;
}

export class Host {
  private readonly waiting = new Map<number, Waiting>();
  private next = 0;

  private constructor(private readonly editor: Editor) {}

  /** Connects to the editor; `undefined` outside an editor. `take` receives messages that are not responses. */
  static connect(take: (message: EditorMessage) => void): Host | undefined {
    const editor = (window as { acquireVsCodeApi?: () => Editor }).acquireVsCodeApi?.();
    if (editor === undefined) {
      return undefined;
    }
    const host = new Host(editor);
    window.addEventListener("message", ({ data }: MessageEvent<unknown>) => {
      if (typeof data === "object" && data !== null && "kind" in data) {
        const message = data as FromEditor;
        if (message.kind === "answer") {
          host.answer(message);
        } else {
          take(message);
        }
      }
    });
    host.notify("ready");
    return host;
  }

  async request<Name extends keyof Requests>(command: Name, parameters: Requests[Name][0]): Promise<Requests[Name][1]> {
    const id = (this.next += 1);
    const answer = new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    this.editor.postMessage({ command, id, ...parameters });
    return (await answer) as Requests[Name][1];
  }

  notify(command: string, parameters: object = {}): void {
    this.editor.postMessage({ command, ...parameters });
  }

  private answer({ id, answer, fault }: FromEditor & { kind: "answer" }): void {
    const waiting = this.waiting.get(id);
    this.waiting.delete(id);
    if (fault === undefined) {
      waiting?.resolve(answer);
    } else {
      waiting?.reject(new Error(fault));
    }
  }
}
