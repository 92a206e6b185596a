// Items of the view "VAL 3", without an editor.

import assert from "node:assert/strict";
import { test } from "node:test";
import type { LibraryCandidate, TreeData, TreeProgram, TreeProject, TreeReference } from "../src/serverRequests";
import { sections } from "../src/tree/candidates";
import type { Item } from "../src/tree/graph";
import { dataIcon, programIcon } from "../src/tree/icons";
import { TreeModel, type TreeNode } from "../src/tree/nodes";

const range = { start: { line: 0, character: 0 }, end: { line: 0, character: 1 } };
const uriOf = (name: string): string => `file:///${name}/${name}.pjx`;
const item = (name: string, detail: string): Item => ({ name, detail, range, location: { uri: "file:///x", range } });
const program = (name: string, isPublic = false): TreeProgram => ({ ...item(name, "()"), public: isPublic, runs: name === "start" });
const datum = (name: string, value: string | null, type = "num"): TreeData =>
  ({ ...item(name, type), public: false, type, sizes: [1], isCollection: false, value });
const reference = (name: string, target: string, ...loaded: string[]): TreeReference =>
  ({ ...item(name, `Disk://${target}`), project: uriOf(target), loaded: loaded.map(uriOf) });

function project(name: string, kind: TreeProject["kind"], parts: Partial<TreeProject>): TreeProject {
  return { name, uri: uriOf(name), kind, hasTypes: true, programs: [], data: [], libraries: [], types: [], ...parts };
}

const CELL = [
  project("alone", "library", { programs: [program("start")] }),
  project("tray", "library", { data: [datum("nTrayPick", "1")] }),
  project("part", "library", { programs: [program("pick", true)], libraries: [reference("tray", "tray")] }),
  project("bag", "library", { programs: [program("pick", true)] }),
  project("Slot", "type", { data: [datum("nHeight", "2")] }),
  project("main", "application", {
    programs: [program("start"), program("place")],
    data: [datum("nCount", "5"), datum("sName", "box", "string")],
    libraries: [reference("part", "part", "bag"), { ...reference("gone", "gone") }],
    types: [reference("Slot", "Slot")],
  }),
  project("mainTest", "tests", { programs: [program("start")], libraries: [reference("main", "main")] }),
];

const roots = (projects: TreeProject[], filter = ""): TreeNode[] => new TreeModel(projects, filter, () => "folder").roots();

/** Formats the labels of items, with two spaces per level. */
function drawn(nodes: readonly TreeNode[], indent = ""): string[] {
  return nodes.flatMap((node) => [`${indent}${node.label}`, ...drawn(node.children?.() ?? [], `${indent}  `)]);
}

function find(nodes: readonly TreeNode[], ...path: string[]): TreeNode {
  const [first, ...rest] = path;
  const found = nodes.find(({ label }) => label === first);
  assert.ok(found, `${String(first)} is not among ${nodes.map(({ label }) => label).join()}`);
  return rest.length === 0 ? found : find(found.children?.() ?? [], ...rest);
}

test("applications come first, then tests, then what neither uses", () => {
  assert.deepEqual(roots(CELL).map(({ label }) => label), ["main", "mainTest", "Not Used by an Application"]);
  assert.deepEqual(drawn([find(roots(CELL), "Not Used by an Application")]).slice(1, 2), ["  alone"]);
  const libraries = CELL.filter(({ name }) => name === "part" || name === "tray");
  assert.deepEqual(roots(libraries).map(({ label }) => label), ["part", "tray"]);
});

test("an application has its libraries and types below it, with what is loaded in their place", () => {
  assert.deepEqual(drawn([find(roots(CELL), "main")]), [
    "main",
    "  Programs", "    place", "    start",
    "  Data", "    nCount", "    sName",
    "  Libraries", "    gone", "    part",
    "      Programs", "        pick",
    "      Libraries", "        tray", "          Data", "            nTrayPick",
    "      Loaded in Its Place", "        bag", "          Programs", "            pick",
    "  Types", "    Slot", "      Data", "        nHeight",
  ]);
});

test("values and access are shown and spoken", () => {
  const main = find(roots(CELL), "main");
  assert.equal(find([main], "main", "Data", "nCount").description, "num = 5");
  assert.equal(find([main], "main", "Data", "sName").description, 'string = "box"');
  assert.equal(find([main], "main", "Data", "sName").spoken, 'sName, private string, "box"');
  assert.equal(find([main], "main", "Libraries", "part", "Programs", "pick").spoken, "pick, public program, ()");
  assert.match(find([main], "main", "Libraries", "gone").tooltip, /there is no project at this path/);
  assert.notDeepEqual(programIcon(true), programIcon(false));
  assert.notEqual(dataIcon("pointRx", true).id, dataIcon("num", true).id);
  assert.deepEqual(dataIcon("pointRs", true), dataIcon("point", true));
});

test("the menus find what an item can do", () => {
  const main = find(roots(CELL), "main");
  assert.deepEqual(main.context, ["project", "file", "hasTypes", "runs"]);
  assert.deepEqual(find([main], "main", "Programs", "place").context, ["program", "named", "file"]);
  assert.deepEqual(find([main], "main", "Libraries", "gone").context, ["named", "file"]);
  assert.equal(find([main], "main", "Libraries").project?.name, "main");
  assert.equal(find([main], "main", "Libraries", "part").project?.name, "part");
});

test("a filter leaves the names that contain it, with what is above them", () => {
  assert.deepEqual(drawn(roots(CELL, "PICK")), [
    "main",
    "  Libraries", "    part",
    "      Programs", "        pick",
    "      Libraries", "        tray", "          Data", "            nTrayPick",
    "      Loaded in Its Place", "        bag", "          Programs", "            pick",
    "mainTest",
    "  Libraries", "    main", "      Libraries", "        part",
    "          Programs", "            pick",
    "          Libraries", "            tray", "              Data", "                nTrayPick",
    "          Loaded in Its Place", "            bag", "              Programs", "                pick",
  ]);
  assert.equal(new TreeModel(CELL, "pick", () => "").count, 3);
  assert.deepEqual(roots(CELL, "nothing has it"), []);
  assert.equal(find(roots(CELL, "pick"), "main", "Libraries", "part").isOpen, true);
});

test("a project whose name alone contains the filter shows all its content", () => {
  assert.deepEqual(drawn(roots(CELL, "alone")), ["Not Used by an Application", "  alone", "    Programs", "      start"]);
});

test("projects that use each other in a circle end", () => {
  const circle = [
    project("a", "application", { libraries: [reference("b", "b")] }),
    project("b", "library", { libraries: [reference("a", "a")] }),
  ];
  assert.deepEqual(drawn(roots(circle)), ["a", "  Libraries", "    b", "      Libraries", "        a"]);
});

test("many data are grouped by type", () => {
  const data = Array.from({ length: 41 }, (_, index) => datum(`n${index}`, "0", index < 30 ? "num" : "pointRx"));
  const group = find(roots([project("a", "application", { data })]), "a", "Data");
  assert.equal(group.description, "41");
  assert.deepEqual(group.children?.().map(({ label, description }) => [label, description]), [["num", "30"], ["pointRx", "11"]]);
  assert.equal(find([group], "Data", "num").children?.()[10]?.label, "n10");
});

test("names that are declared twice have ids of their own", () => {
  const [first, second] = find(roots([project("a", "application", { data: [datum("nA", "1"), datum("nA", "2")] })]), "a", "Data").children?.() ?? [];
  assert.notEqual(first?.id, second?.id);
});

const candidate = (name: string, parts: Partial<LibraryCandidate>): LibraryCandidate => ({
  uri: uriOf(name), kind: "library", name, path: `Disk://${name}`, libraries: [], types: [],
  publicPrograms: 1, publicData: 0, fits: [], libraryCircle: false, typeCircle: false, ...parts,
});

test("libraries of the cell come first, circles last; types need fields", () => {
  const candidates = [
    candidate("main", { kind: "application", libraryCircle: true }),
    candidate("io", { libraries: ["io"] }),
    candidate("bag", { fits: ["part"], publicData: 2 }),
  ];
  assert.deepEqual(sections(candidates, "library").map(({ heading, choices }) => [heading, ...choices.map(({ label }) => label)]), [
    ["Libraries", "bag"], ["Already There", "io"], ["Would Use This Project in a Circle", "main"],
  ]);
  assert.equal(sections(candidates, "library")[0]?.choices[0]?.detail, "library · 1 public program · 2 public data · can be loaded as part");
  assert.deepEqual(sections(candidates, "type").map(({ choices }) => choices.map(({ detail }) => detail)), [["library · 2 fields"]]);
});
