// Validates every recorded message against the types of the protocol.
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

const schema = makeSchema();
const ajv = new Ajv({ strict: false, allErrors: false });
ajv.addSchema(schema, "protocol");

/** Returns validators for the types in `Params` or `Results`, by method. */
function validators(list) {
  const methods = schema.definitions[list].properties;
  const path = (method) => `protocol#/definitions/${list}/properties/${encodeURIComponent(method.replaceAll("~", "~0").replaceAll("/", "~1"))}`;
  return new Map(Object.keys(methods).map((method) => [method, ajv.compile({ $ref: path(method) })]));
}

const PARAMS = validators("Params");
const RESULTS = validators("Results");
/** Requests beyond the protocol need no types, but must conform to existing types. */
const isUntyped = (types, method) => method.startsWith("val3/") && !types.has(method);

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
    return params === undefined || params === null || isUntyped(PARAMS, method) ? undefined : judge(PARAMS.get(method), method, params);
  }
  const asked = open.get(`${from === "client" ? "server" : "client"} ${id}`);
  if (asked === undefined) {
    return error !== undefined && id === null ? undefined : `an answer to no request: ${id}`;
  } else if (error !== undefined) {
    return Number.isInteger(error.code) && typeof error.message === "string" ? undefined : "an error without code or message";
  }
  return isUntyped(RESULTS, asked) ? undefined : judge(RESULTS.get(asked), `the answer to ${asked}`, result);
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
const refused = [["textDocument/hover", { contents: 5 }], ["textDocument/rename", { changes: [] }]];
const tooKind = refused.filter(([method, answer]) => judge(RESULTS.get(method), method, answer) === undefined);
faults.push(...tooKind.map(([method]) => `a wrong answer to ${method} is not noticed`));
[...new Set(faults)].slice(0, 20).forEach((found) => console.log(found));
const failed = faults.length > 0 ? 1 : 0;
console.log(`${passed} messages are as the protocol has them`);
console.log(`test result: ${failed ? "FAILED" : "ok"}. ${passed > 0 ? 1 - failed : 0} passed; ${passed > 0 ? failed : 1} failed; messages`);
process.exitCode = passed > 0 ? failed : 1;
