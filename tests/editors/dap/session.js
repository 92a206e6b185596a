// A session of the client of VS Code's debug adapters with `val3 dap`. Each message of the adapter is checked against the
// schema of the protocol, and each event is kept until a test has asked for it.
const assert = require("node:assert/strict");
const { once } = require("node:events");
const { join } = require("node:path");
const Ajv = require("ajv");
const { DebugClient } = require("@vscode/debugadapter-testsupport");
const specification = require(join(process.env.VAL3_ROOT, "crates/val3-dap/schema/debugAdapterProtocol.json"));

/** The longest wait for an answer or an event. */
const PATIENCE = 60_000;

const ajv = new Ajv({ strict: false, validateFormats: false, allErrors: true });
ajv.addSchema({ definitions: specification.definitions }, "dap");

/** Throws if a message does not have the form of the protocol. Of requests and events `val3/…` the envelope counts. */
function validate(message) {
  const name = message.event ?? message.command;
  const capital = name.slice(0, 1).toUpperCase() + name.slice(1);
  const kind = message.event === undefined ? "Response" : "Event";
  const definition = name.includes("/") ? kind : message.success === false ? "ErrorResponse" : `${capital}${kind}`;
  const check = ajv.getSchema(`dap#/definitions/${definition}`);
  assert.ok(check, `the protocol has no ${definition}`);
  assert.ok(check(message), `${ajv.errorsText(check.errors)} in ${JSON.stringify(message)}`);
}

/** A promise that fails when it takes too long. */
async function inTime(promise, what) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`no ${what} within ${PATIENCE} ms`)), PATIENCE).unref();
  });
  return Promise.race([promise, late]).finally(() => clearTimeout(timer));
}

class Session {
  constructor() {
    this.client = new DebugClient(process.env.VAL3_SERVER, "dap", "val3");
    this.events = new Map();
    this.waiting = new Map();
    this.fault = undefined;
    this.exitCode = 0;
    const dispatch = this.client.dispatch.bind(this.client);
    this.client.dispatch = (body) => {
      const message = JSON.parse(body);
      try {
        validate(message);
      } catch (fault) {
        this.fault ??= fault;
      }
      dispatch(body);
      if (message.event !== undefined) this.keep(message.event, message.body ?? {});
    };
  }

  /** Begins a session. `before` configures it, after the adapter is initialized. */
  static async launch(program, { client = {}, before = async () => {}, ...options } = {}) {
    const session = await Session.start(client);
    try {
      const launched = session.ask("launch", { program, ...options });
      await Promise.race([session.event("initialized"), launched]);
      await before(session);
      await session.ask("configurationDone");
      await launched;
      return session;
    } catch (fault) {
      session.kill();
      const said = session.arrived("output").map(({ output }) => output).join("");
      throw new Error(`${fault.message}\n${said}`, { cause: fault });
    }
  }

  /** A session that is not launched: with a new adapter, or with the one that listens on a port. */
  static async start(client = {}, port = undefined) {
    const session = new Session();
    await session.client.start(port);
    session.process = session.client._adapterProcess;
    session.capabilities = await session.ask("initialize", {
      adapterID: "val3", linesStartAt1: true, columnsStartAt1: true, pathFormat: "path",
      supportsInvalidatedEvent: true, supportsVariableType: true, supportsVariablePaging: true, ...client,
    });
    return session;
  }

  keep(name, body) {
    if (name === "exited") this.exitCode = body.exitCode;
    const waiting = this.waiting.get(name)?.shift();
    if (waiting !== undefined) return waiting(body);
    if (!this.events.has(name)) this.events.set(name, []);
    this.events.get(name).push(body);
  }

  /** The body of the answer to a request. */
  async ask(command, args) {
    const answer = await inTime(this.client.send(command, args), `answer to ${command} ${JSON.stringify(args)}`);
    if (this.fault !== undefined) throw this.fault;
    return answer.body;
  }

  /** Why a request is refused. */
  async refused(command, args) {
    return this.ask(command, args).then(
      (body) => assert.fail(`${command} was answered: ${JSON.stringify(body)}`),
      (reason) => reason.message,
    );
  }

  /** The body of the next event that no test has asked for. */
  async event(name) {
    const known = this.events.get(name)?.shift();
    if (known !== undefined) return known;
    const next = new Promise((resolve) => {
      if (!this.waiting.has(name)) this.waiting.set(name, []);
      this.waiting.get(name).push(resolve);
    });
    return inTime(next, `event ${name}`);
  }

  /** The next event for which `test` holds. Those before it are dropped. */
  async eventWhere(name, test) {
    for (;;) {
      const body = await this.event(name);
      if (test(body)) return body;
    }
  }

  /** The bodies of the events that have arrived and no test has asked for. */
  arrived(name) {
    return this.events.get(name)?.splice(0) ?? [];
  }

  /** Waits for a stop with this reason, whose task the session then is about. */
  async stopped(reason) {
    const stop = await this.event("stopped");
    assert.equal(stop.reason, reason, JSON.stringify(stop));
    this.thread = stop.threadId;
    return stop;
  }

  /** Lets the task run, and waits for a stop with this reason. */
  async run(command, reason, args = {}) {
    await this.ask(command, { threadId: this.thread, ...args });
    return this.stopped(reason);
  }

  async frames(thread = this.thread) {
    return (await this.ask("stackTrace", { threadId: thread })).stackFrames;
  }

  /** `program:line` of the innermost frame. */
  async place(thread = this.thread) {
    const [{ name, line }] = await this.frames(thread);
    return `${/:(\w+)\(\)/.exec(name)[1]}:${line}`;
  }

  /** The variables of a scope of a frame. */
  async scope(name, depth = 0) {
    const frame = (await this.frames())[depth];
    const { scopes } = await this.ask("scopes", { frameId: frame.id });
    const found = scopes.find((scope) => scope.name === name);
    assert.ok(found, `no scope ${name} among ${scopes.map((scope) => scope.name)}`);
    return { ...found, variables: await this.inside(found) };
  }

  /** The variables inside of one, or of a scope. */
  async inside({ variablesReference }, page = {}) {
    return (await this.ask("variables", { variablesReference, ...page })).variables;
  }

  /** The variable `name` of a scope. */
  async variable(scope, name, depth = 0) {
    const { variables } = await this.scope(scope, depth);
    const found = variables.find((variable) => variable.name === name);
    assert.ok(found, `no ${name} among ${variables.map((variable) => variable.name)}`);
    return found;
  }

  /** The value of an expression in the innermost frame. */
  async evaluate(expression, context = "watch", more = {}) {
    const [{ id }] = await this.frames();
    return (await this.ask("evaluate", { expression, frameId: id, context, ...more })).result;
  }

  /** Sets the breakpoints of a file, and gives where they are. */
  async setBreakpoints(path, ...breakpoints) {
    const wanted = breakpoints.map((wanted) => (typeof wanted === "number" ? { line: wanted } : wanted));
    return (await this.ask("setBreakpoints", { source: { path }, breakpoints: wanted })).breakpoints;
  }

  /** Sets a breakpoint on data of the innermost frame. */
  async watchData(name, options = {}) {
    const [{ id }] = await this.frames();
    const info = await this.ask("dataBreakpointInfo", { name, frameId: id });
    assert.ok(info.dataId, info.description);
    const breakpoints = [{ dataId: info.dataId, ...options }];
    return [info, (await this.ask("setDataBreakpoints", { breakpoints })).breakpoints[0]];
  }

  /** Leaves, and gives the exit code of the adapter. */
  async end() {
    const { process } = this;
    const exit = process.exitCode === null ? once(process, "exit") : [process.exitCode];
    await this.ask("disconnect");
    process.stdin.end();
    const [code] = await inTime(exit, "end of the adapter");
    return code;
  }

  /** Ends the adapter if a test has not. */
  kill() {
    if (this.process?.exitCode === null) this.process.kill("SIGKILL");
  }
}

/** Debugs a program with `test`. The adapter ends without a fault, or as the program. */
async function debug(program, options, test) {
  const session = await Session.launch(program, options);
  try {
    await test(session);
    assert.equal(await session.end(), session.exitCode);
  } finally {
    session.kill();
  }
}

module.exports = { Session, debug };
