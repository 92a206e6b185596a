// An invented data file as tables, and an editor around the page that applies simple edits to them.
import { pathToFileURL } from "node:url";

const column = (id, kind = "number", more = {}) => ({ id, title: id, unit: null, kind, choices: [], default: kind === "number" ? "0" : "", ...more });
const POSE = ["x", "y", "z"].map((id) => column(id, "number", { unit: "mm" })).concat(["rx", "ry", "rz"].map((id) => column(id, "number", { unit: "°" })));
const FATHER = column("fatherId", "father", { title: "father", choices: ["world[0]", "fPallet[0]"], default: "world[0]" });
const CONFIG = [["shoulder", "lefty righty ssame"], ["elbow", "epositive enegative esame"], ["wrist", "wpositive wnegative wsame"]]
  .map(([id, choices]) => column(id, "choice", { choices: choices.split(" "), default: choices.split(" ")[2] }));
const type = (name, columns, fields = []) => ({ name, columns, fields, containers: ["array", "collection"] });
/** Names may contain HTML. */
export const HOSTILE = "<img src=x onerror=alert(1)>";

export const TYPES = [
  type("bool", [column("value", "bool", { default: "false" })]), type("num", [column("value")]), type("string", [column("value", "text")]),
  type("frame", [...POSE, FATHER]), type("pointRx", [...POSE, ...CONFIG, FATHER]), type("dio", [column("link", "link", { choices: ["BasicIO-1\\%I0"] })]),
  type("Slot", [], [{ name: "pPick", type: "pointRx", container: "array", size: [1] }, { name: "sID", type: "string", container: "array", size: [1] }]),
];

const datum = (name, type, values, more = {}) => ({ name, access: "private", type, container: "array", size: [1], range: { start: { line: 0, character: 0 }, end: { line: 0, character: 1 } }, values, ...more });
const point = (key, x, y) => ({ key, texts: [String(x), String(y), null, "180", null, null, "lefty", null, null, "fPallet[0]"] });

export function tables({ points = 6, elements = 3 } = {}) {
  return {
    version: 1, dialect: "new", problem: null, types: TYPES,
    data: [
      ...Array.from({ length: points }, (_, index) => datum(`pPoint${index}`, "pointRx", [point("0", index * 1.5, (index * 37) % 1000)], { access: index % 2 === 0 ? "public" : "private" })),
      datum("pTray", "pointRx", [point("1", 10, 20)], { size: [elements] }),
      datum("fPallet", "frame", [{ key: "0", texts: ["500", "200", null, null, null, "30", "world[0]"] }]),
      datum("bReady", "bool", [{ key: "0", texts: ["true"] }]), datum("bStop", "bool", []),
      datum("nTimes", "num", [{ key: "2,1", texts: ["7.5"] }], { size: [3, 2] }),
      datum("nDone", "num", [{ key: "bag", texts: [null] }, { key: "box", texts: ["4"] }], { container: "collection", size: [2] }),
      datum("sState", "string", [{ key: "0", texts: [HOSTILE] }]), datum("sLong", "string", [{ key: "0", texts: ["a text that is much longer than the cell in which it is shown, so that its end is cut off"] }]),
      datum("diPart", "dio", [{ key: "0", texts: ["BasicIO-1\\%I0"] }]),
      datum("tSlot", "Slot", [{ key: "0", texts: [], fields: [{ ...datum("pPick", "pointRx", [point("0", 1, 2)]) }] }], { size: [2] }),
    ],
    findings: [
      { place: { name: "fPallet", key: "0" }, column: "fatherId", severity: "error", code: "V0301", message: "There is no frame `world2`." },
      { place: { name: "bStop" }, column: null, severity: "warning", code: "V0501", message: "`bStop` is never used." },
    ],
  };
}

/** Runs in the page, before its script: responds to its requests like the server does for single values. */
export function fakeEditor(initial) {
  let tables = initial;
  globalThis.sent = [];
  const post = (message) => setTimeout(() => globalThis.postMessage(message));
  const setCell = ({ place, column, text }) => {
    const datum = tables.data.find(({ name }) => name === place.name);
    const columns = tables.types.find(({ name }) => name === datum.type).columns;
    const index = columns.findIndex(({ id }) => id === column);
    if (columns[index].kind === "number" && text !== null && !Number.isFinite(Number(text))) {
      return `\`${text}\` is not a number.`;
    }
    const empty = { key: place.key, texts: columns.map(() => null) };
    const others = datum.values.filter(({ key }) => key !== place.key);
    const value = datum.values.find(({ key }) => key === place.key) ?? empty;
    const changed = { ...datum, values: [...others, { ...value, texts: value.texts.with(index, text) }] };
    tables = { ...tables, data: tables.data.map((other) => (other === datum ? changed : other)) };
    return null;
  };
  const apply = (edits, isChecked) => {
    const before = tables;
    let refused = null;
    for (const edit of edits) {
      switch (edit.kind) {
        case "set": refused ??= edit.cells.map(setCell).find((fault) => fault !== null) ?? null; break;
        case "delete": tables = { ...tables, data: tables.data.filter(({ name }) => !edit.names.includes(name)) }; break;
        case "access": tables = { ...tables, data: tables.data.map((datum) => (edit.names.includes(datum.name) ? { ...datum, access: edit.access } : datum)) }; break;
        case "add": tables = { ...tables, data: [...tables.data, { name: edit.name, type: edit.type, access: edit.access, container: edit.container, size: edit.size, values: [] }] }; break;
        default: break;
      }
    }
    if (isChecked || refused !== null) {
      tables = before;
    } else {
      post({ kind: "tables", tables });
    }
    return { refused, findings: [] };
  };
  const answer = ({ command, edits, check, names }) => {
    switch (command) {
      case "edit": return apply(edits, check);
      case "uses": return names.map((name) => ({ name, file: "start.pgx", uri: "file:///start.pgx", line: 4, character: 2, text: `${name}=true` }));
      case "poses": return names.map((name) => ({ name, key: "0", world: [1, 2, 3, 0, 0, 90], chain: "world", reach: "reachable", why: null, joints: [0, 0, 90, 0, 90, 0] }));
      default: return { refused: null, findings: [] };
    }
  };
  globalThis.acquireVsCodeApi = () => ({
    postMessage: (message) => {
      if (message.command === "ready") {
        post({ kind: "tables", tables });
      } else if (message.id !== undefined) {
        globalThis.sent.push(message);
        post({ kind: "answer", id: message.id, answer: answer(message) });
      }
    },
  });
}

export const PAGE = pathToFileURL(new URL("../../dist/data.html", import.meta.url).pathname).href;
