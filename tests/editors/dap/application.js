// Applications for the tests, written to scratch folders. Programs are written as VAL 3 code with their declarations:
//
//   program add(num x_nValue, num& x_nTotal)
//     num l_nBefore
//   begin
//     …
//   end
const { mkdirSync, mkdtempSync, readFileSync, realpathSync, rmSync, writeFileSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");

const NAMESPACE = "http://www.staubli.com/robotics/VAL3";
const HEADER = `<?xml version="1.0" encoding="utf-8"?>`;
const INSTANCE = `xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"`;
/** Data types whose names in data files differ. */
const DATA_TYPES = { joint: "jointRx", point: "pointRx" };

class Application {
  /**
   * `programs` is VAL 3 code, `data` maps declarations (`num nMany[4]`) to the XML attributes of their first value, and
   * `libraries` maps identifiers to applications. An application with `start` gets an empty `stop`, which controllers
   * require.
   */
  constructor(name, { programs = "", data = {}, libraries = {} }) {
    // The adapter uses the path without symbolic links.
    this.cell = realpathSync(mkdtempSync(join(tmpdir(), "val3-dap-")));
    this.name = name;
    this.write(name, { programs, data, libraries });
  }

  write(name, { programs, data, libraries }) {
    const folder = this.folder(name);
    mkdirSync(folder, { recursive: true });
    const files = programs.split(/^(?=program )/m).filter((text) => text.trim() !== "").map((text) => program(text));
    const has = (wanted) => files.some(({ name }) => name === wanted);
    if (has("start") && !has("stop")) files.push(program("program stop()\nbegin\nend\n"));
    for (const { name, text } of files) writeFileSync(join(folder, `${name}.pgx`), text);
    writeFileSync(join(folder, `${name}.dtx`), database(data));
    const aliases = Object.entries(libraries).map(([alias, library]) => {
      this.write(alias, { programs: "", data: {}, libraries: {}, ...library });
      return `<Library alias="${alias}" path="Disk://${alias}/${alias}.pjx" />`;
    });
    const list = files.map(({ name }) => `<Program file="${name}.pgx" />`);
    writeFileSync(join(folder, `${name}.pjx`), project(name, list, aliases));
  }

  /** Returns the folder of the application, or of one of its libraries. */
  folder(name = this.name) {
    return join(this.cell, "usr", "usrapp", name);
  }

  file(program, name = this.name) {
    return join(this.folder(name), `${program}.pgx`);
  }

  /** Returns the first line with `text` in a program's file, from 1. */
  line(program, text, name = this.name) {
    const lines = readFileSync(this.file(program, name), "utf8").split("\n");
    const at = lines.findIndex((line) => line.includes(text));
    if (at < 0) throw new Error(`${program} has no line with ${text}`);
    return at + 1;
  }

  /** Replaces a text in the file of a program. */
  edit(program, from, to) {
    const text = readFileSync(this.file(program), "utf8");
    if (!text.includes(from)) throw new Error(`${program} does not contain ${from}`);
    writeFileSync(this.file(program), text.replace(from, to));
  }

  remove() {
    rmSync(this.cell, { recursive: true, force: true });
  }
}

function project(name, programs, libraries) {
  return `${HEADER}
<Project xmlns="${NAMESPACE}/Project/3">
  <Parameters version="s7.11.3" stackSize="5000" millimeterUnit="true" />
  <Programs>${programs.join("")}</Programs>
  <Database><Data file="${name}.dtx" /></Database>
  <Libraries>${libraries.join("")}</Libraries>
  <Types />
</Project>`;
}

function database(data) {
  const rows = Object.entries(data).map(([declaration, value]) => {
    const [, type, name, size] = /^(\w+) (\w+)(?:\[([\d ]+)\])?$/.exec(declaration);
    const first = value === "" ? "" : `<Value key="0" ${value} />`;
    return `<Data name="${name}" access="public" xsi:type="array" type="${DATA_TYPES[type] ?? type}" size="${size ?? 1}">${first}</Data>`;
  });
  return `${HEADER}
<Database ${INSTANCE} xmlns="${NAMESPACE}/Data/2">
  <Datas>${rows.join("")}</Datas>
</Database>`;
}

/** Parses the name and the file of a program. */
function program(text) {
  const [, name, parameters, locals, code] = /^program (\w+)\((.*)\)\n([^]*?)^(begin\n[^]*?^end)$/m.exec(text);
  const parameter = (declaration) => {
    const [, type, reference, name] = /^(\w+)(&?) (\w+)$/.exec(declaration.trim());
    return `<Parameter name="${name}" type="${type}" xsi:type="element"${reference === "&" ? ` use="reference"` : ""} />`;
  };
  const local = (declaration) => {
    const [, type, name, size] = /^(\w+) (\w+)(?:\[(\d+)\])?$/.exec(declaration.trim());
    return `<Local name="${name}" type="${type}" xsi:type="array" size="${size ?? 1}" />`;
  };
  const given = parameters.split(",").filter((part) => part.trim() !== "").map(parameter);
  const own = locals.split("\n").filter((line) => line.trim() !== "").map(local);
  return { name, text: `${HEADER}
<Programs ${INSTANCE} xmlns="${NAMESPACE}/Program/2">
  <Program name="${name}" access="public">
    <Parameters xmlns="${NAMESPACE}/Param/1">${given.join("")}</Parameters>
    <Locals>${own.join("")}</Locals>
    <Code><![CDATA[${code}]]></Code>
  </Program>
</Programs>` };
}

module.exports = { Application };
