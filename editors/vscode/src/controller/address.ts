// Address of a controller. The rules are those of `val3 pull`, which checks the address once more.

import { existsSync } from "node:fs";
import { join, resolve } from "node:path";

export const EXAMPLE = "ftp://maintenance@192.168.0.254";

/** Returns the fault of an entered address; `undefined` if it can be used. Folders are relative to `folder`. */
export function addressFault(text: string, folder: string): string | undefined {
  const address = text.trim();
  if (address === "") {
    return `Enter an address such as ${EXAMPLE}, or the folder of an emulator.`;
  }
  const [, scheme, rest = ""] = /^([^/]*):\/\/(.*)$/.exec(address) ?? [];
  if (scheme === undefined) {
    const isEmulator = existsSync(join(resolve(folder, address), "usr"));
    return isEmulator ? undefined : `This folder contains no usr. For a controller, enter an address such as ${EXAMPLE}.`;
  }
  if (!/^ftps?$/i.test(scheme)) {
    return `Only ftp:// and ftps:// addresses and folders are supported, for example ${EXAMPLE}.`;
  }
  return serverFault(rest);
}

/** Returns the fault of the part after `ftp://` or `ftps://`: a profile, a host, and optionally a port and a folder. */
function serverFault(rest: string): string | undefined {
  const [authority = ""] = rest.split("/");
  const at = authority.lastIndexOf("@");
  if (authority.slice(0, Math.max(at, 0)).includes(":")) {
    return "The address is stored and shown, so it contains no password. VS Code prompts for it.";
  }
  const [, host = "", port] = /^(\[[^\]]+\]|[^:]*)(?::(.*))?$/.exec(authority.slice(at + 1)) ?? [];
  if (host === "") {
    return `The host is missing, for example ${EXAMPLE}.`;
  }
  const isPort = port === undefined || (/^\d{1,5}$/.test(port) && Number(port) > 0 && Number(port) < 65536);
  return isPort ? undefined : "The port is a number from 1 to 65535.";
}

/** Returns the profile and the host of a server's address; `undefined` for a folder. */
export function serverOf(address: string): { profile: string; host: string } | undefined {
  const [, profile = "default", host] = /^ftps?:\/\/(?:([^/]*)@)?([^/]+)/i.exec(address) ?? [];
  return host === undefined ? undefined : { profile, host };
}
