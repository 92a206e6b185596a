// Stand-in for the part of `vscode` that the tests use. `Uri` behaves as in Theia: neither `Uri.from` nor the arguments
// of commands are instances of it.

export { holdDisk, Position, Range, reloadFirst, takeMessages, TextEdit, trusted, window, workspace, WorkspaceEdit } from "./documents";

interface Parts {
  scheme: string;
  path: string;
  query: string;
}

class BaseUri implements Parts {
  constructor(readonly scheme: string, readonly path: string, readonly query: string) {}

  static from({ scheme, path, query }: Parts): BaseUri {
    return new BaseUri(scheme, path, query);
  }

  toString(): string {
    return `${this.scheme}:${encodeURI(this.path)}${this.query && "?"}${encodeURIComponent(this.query)}`;
  }
}

export class Uri extends BaseUri {
  static parse(text: string): Uri {
    const [, scheme = "", path = "", query = ""] = /^(\w[\w-]*):(?:\/\/)?([^?]*)\??(.*)$/.exec(text) ?? [];
    return new Uri(scheme, decodeURI(path), decodeURIComponent(query));
  }

  get fsPath(): string {
    return this.path;
  }

  with(parts: Partial<Parts>): Uri {
    return new Uri(parts.scheme ?? this.scheme, parts.path ?? this.path, parts.query ?? this.query);
  }
}

/** No command is registered. */
export const commands = {
  executeCommand: (command: string): Promise<never> => Promise.reject(new Error(`command '${command}' not found`)),
};

export class EventEmitter<T> {
  private readonly listeners = new Set<(value: T) => void>();
  readonly event = (listener: (value: T) => void): void => void this.listeners.add(listener);

  fire(value: T): void {
    this.listeners.forEach((listener) => listener(value));
  }
}

export class Disposable {
  constructor(readonly dispose: () => void) {}
}

export class TreeItem {
  description: string | undefined;

  constructor(readonly label: string) {}
}

/** Returns a file as a command in Theia receives it. */
export function asArgument(uri: Uri): object {
  return BaseUri.from(uri);
}
