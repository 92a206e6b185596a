// Validates every recorded message against the types of the protocol and the schema of the server's own requests.
const { cpSync, mkdirSync, readdirSync, readFileSync, writeFileSync } = require("node:fs");
const { join } = require("node:path");
const Ajv = require("ajv").default;
const { createGenerator } = require("ts-json-schema-generator");

const TRACES = join(process.env.VAL3_OUTPUT, "traces");
/** Clients that do not conform to the protocol: only the server's messages to them are validated. */
const LIBERAL = new Set(["lsp-mode.jsonl"]);

/** Creates the schema next to the packages, where TypeScript finds the types of the protocol. */
function makeSchema() {
  const folder = join(process.env.VAL3_TOOLS, "node", "schema");
  mkdirSync(folder, { recursive: true });
  cpSync(join(__dirname, "messages.ts"), join(folder, "messages.ts"));
  const options = { target: "ES2022", module: "Node16", moduleResolution: "Node16", strict: true, skipLibCheck: true, types: [] };
  writeFileSync(join(folder, "tsconfig.json"), JSON.stringify({ compilerOptions: options, files: ["messages.ts"] }));
  const config = { path: join(folder, "messages.ts"), tsconfig: join(folder, "tsconfig.json"), type: "*", additionalProperties: true, skipTypeCheck: true };
  return createGenerator(config).createSchema("*");
}

/** Returns the schema of the requests `val3/…`, in which the protocol describes edits. */
function ownSchema() {
  const path = join(__dirname, "..", "..", "..", "editors", "schema", "server-requests.schema.json");
  const own = JSON.parse(readFileSync(path, "utf8"));
  // Ajv supports the keywords, but not the declared version of the specification.
  delete own.$schema;
  own.$defs.WorkspaceEdit = { $ref: "protocol#/definitions/WorkspaceEdit" };
  return own;
}

const schema = makeSchema();
const own = ownSchema();
const ajv = new Ajv({ strict: false, validateFormats: false });
ajv.addSchema(schema, "protocol");
ajv.addSchema(own, "own");

/** Returns a validator for each of these methods; `member` names a part of the method's type. */
function validators(root, methods, member = "") {
  const escaped = (method) => encodeURIComponent(method.replaceAll("~", "~0").replaceAll("/", "~1"));
  return Object.keys(methods).map((method) => [method, ajv.compile({ $ref: `${root}/properties/${escaped(method)}${member}` })]);
}

const protocolTypes = (list) => validators(`protocol#/definitions/${list}`, schema.definitions[list].properties);
const ownTypes = (member) => validators("own#/$defs/ServerRequests", own.$defs.ServerRequests.properties, `/properties/${member}`);

const PARAMS = new Map([...protocolTypes("Params"), ...ownTypes("params")]);
const RESULTS = new Map([...protocolTypes("Results"), ...ownTypes("result")]);

/** Returns the fault of a message; `undefined` if it is valid. Stores the requests, to which responses refer. */
function fault({ from, message }, open) {
  if (message.jsonrpc !== "2.0") {
    return "not JSON-RPC 2.0";
  }
  const { method, id, params, result, error } = message;
  if (method !== undefined) {
    if (id !== undefined) {
      open.set(`${from} ${id}`, method);
    }
    return params === undefined || params === null ? undefined : judge(PARAMS.get(method), method, params);
  }
  const asked = open.get(`${from === "client" ? "server" : "client"} ${id}`);
  if (asked === undefined) {
    return error !== undefined && id === null ? undefined : `an answer to no request: ${id}`;
  } else if (error !== undefined) {
    return Number.isInteger(error.code) && typeof error.message === "string" ? undefined : "an error without code or message";
  }
  return judge(RESULTS.get(asked), `the answer to ${asked}`, result);
}

function judge(validate, what, value) {
  if (validate === undefined) {
    return `no type is known for ${what}`;
  }
  return validate(value) ? undefined : `${what}: ${ajv.errorsText(validate.errors)}`;
}

let passed = 0;
const faults = [];
for (const name of readdirSync(TRACES)) {
  let open = new Map();
  for (const line of readFileSync(join(TRACES, name), "utf8").trim().split("\n")) {
    const recorded = JSON.parse(line);
    if (recorded.message.method === "initialize") {
      open = new Map();
    }
    const judged = fault(recorded, open);
    const found = recorded.from === "client" && LIBERAL.has(name) ? undefined : judged;
    passed += found === undefined ? 1 : 0;
    faults.push(...(found === undefined ? [] : [`${name}, from the ${recorded.from}: ${found}\n  ${line.slice(0, 300)}`]));
  }
}

// A validator that accepts everything would be useless.
const refused = [
  ["textDocument/hover", { contents: 5 }],
  ["textDocument/rename", { changes: [] }],
  ["val3/addLibrary", { changes: [] }],
  ["val3/data", { resultId: 5 }],
];
const tooKind = refused.filter(([method, answer]) => judge(RESULTS.get(method), method, answer) === undefined);
faults.push(...tooKind.map(([method]) => `a wrong answer to ${method} is not noticed`));
[...new Set(faults)].slice(0, 20).forEach((found) => console.log(found));
const failed = faults.length > 0 ? 1 : 0;
console.log(`${passed} messages are as the protocol has them`);
console.log(`test result: ${failed ? "FAILED" : "ok"}. ${passed > 0 ? 1 - failed : 0} passed; ${passed > 0 ? failed : 1} failed; messages`);
process.exitCode = passed > 0 ? failed : 1;
