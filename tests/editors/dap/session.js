// A session of VS Code's debug adapter client with `val3 dap`. Each message from the adapter is validated against the
// schema of the protocol, and each event is stored until a test has requested it.
const assert = require("node:assert/strict");
const { once } = require("node:events");
const { join } = require("node:path");
const { after } = require("node:test");
const Ajv = require("ajv");
const { DebugClient } = require("@vscode/debugadapter-testsupport");
const specification = require(join(process.env.VAL3_ROOT, "crates/val3-dap/schema/debugAdapterProtocol.json"));

/** Longest wait for a response or an event, in ms. */
const TIMEOUT = 60_000;

/** Sessions of this file. After a failed test, `node --test` would wait for the test's adapter. */
const started = [];
after(() => started.forEach((session) => session.kill()));

const ajv = new Ajv({ strict: false, validateFormats: false, allErrors: true });
ajv.addSchema({ definitions: specification.definitions }, "dap");

/**
 * Throws if a message does not have the form of the protocol. For requests and events `val3/…` only the envelope is
 * validated.
 */
function validate(message) {
  const name = message.event ?? message.command;
  const capital = name.slice(0, 1).toUpperCase() + name.slice(1);
  const kind = message.event === undefined ? "Response" : "Event";
  const definition = name.includes("/") ? kind : message.success === false ? "ErrorResponse" : `${capital}${kind}`;
  const check = ajv.getSchema(`dap#/definitions/${definition}`);
  assert.ok(check, `the protocol has no ${definition}`);
  assert.ok(check(message), `${ajv.errorsText(check.errors)} in ${JSON.stringify(message)}`);
}

/** Returns a promise that fails after a timeout. */
async function inTime(promise, what) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`no ${what} within ${TIMEOUT} ms`)), TIMEOUT).unref();
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

  /** Begins a session. `before` configures it after the adapter is initialized. */
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

  /** Starts a session without a launch: with a new adapter, or with the adapter that listens on a port. */
  static async start(client = {}, port = undefined) {
    const session = new Session();
    await session.client.start(port);
    session.process = session.client._adapterProcess;
    started.push(session);
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

  /** Sends a request, and returns the body of its response. */
  async ask(command, args) {
    const answer = await inTime(this.client.send(command, args), `answer to ${command} ${JSON.stringify(args)}`);
    if (this.fault !== undefined) throw this.fault;
    return answer.body;
  }

  /** Sends a request that fails, and returns the reason. */
  async refused(command, args) {
    return this.ask(command, args).then(
      (body) => assert.fail(`${command} was answered: ${JSON.stringify(body)}`),
      (reason) => reason.message,
    );
  }

  /** Returns the body of the next event that no test has requested. */
  async event(name) {
    const known = this.events.get(name)?.shift();
    if (known !== undefined) return known;
    const next = new Promise((resolve) => {
      if (!this.waiting.has(name)) this.waiting.set(name, []);
      this.waiting.get(name).push(resolve);
    });
    return inTime(next, `event ${name}`);
  }

  /** Returns the next event for which `test` is true. Previous events are discarded. */
  async eventWhere(name, test) {
    for (;;) {
      const body = await this.event(name);
      if (test(body)) return body;
    }
  }

  /** Returns the bodies of the received events that no test has requested. */
  arrived(name) {
    return this.events.get(name)?.splice(0) ?? [];
  }

  /** Waits for a stop with this reason, and sets the thread of the session to the stopped task. */
  async stopped(reason) {
    const stop = await this.event("stopped");
    assert.equal(stop.reason, reason, JSON.stringify(stop));
    this.thread = stop.threadId;
    return stop;
  }

  /** Continues the task, and waits for a stop with this reason. */
  async run(command, reason, args = {}) {
    await this.ask(command, { threadId: this.thread, ...args });
    return this.stopped(reason);
  }

  async frames(thread = this.thread) {
    return (await this.ask("stackTrace", { threadId: thread })).stackFrames;
  }

  /** Returns `program:line` of the innermost frame. */
  async place(thread = this.thread) {
    const [{ name, line }] = await this.frames(thread);
    return `${/:(\w+)\(\)/.exec(name)[1]}:${line}`;
  }

  /** Returns the variables of a scope of a frame. */
  async scope(name, depth = 0) {
    const frame = (await this.frames())[depth];
    const { scopes } = await this.ask("scopes", { frameId: frame.id });
    const found = scopes.find((scope) => scope.name === name);
    assert.ok(found, `no scope ${name} among ${scopes.map((scope) => scope.name)}`);
    return { ...found, variables: await this.inside(found) };
  }

  /** Returns the variables nested in a variable or scope. */
  async inside({ variablesReference }, page = {}) {
    return (await this.ask("variables", { variablesReference, ...page })).variables;
  }

  /** Returns the variable `name` of a scope. */
  async variable(scope, name, depth = 0) {
    const { variables } = await this.scope(scope, depth);
    const found = variables.find((variable) => variable.name === name);
    assert.ok(found, `no ${name} among ${variables.map((variable) => variable.name)}`);
    return found;
  }

  /** Returns the value of an expression in the innermost frame. */
  async evaluate(expression, context = "watch", more = {}) {
    const [{ id }] = await this.frames();
    return (await this.ask("evaluate", { expression, frameId: id, context, ...more })).result;
  }

  /** Sets the breakpoints of a file, and returns their resolved lines. */
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

  /** Disconnects, and returns the exit code of the adapter. */
  async end() {
    const { process } = this;
    const exit = process.exitCode === null ? once(process, "exit") : [process.exitCode];
    await this.ask("disconnect");
    process.stdin.end();
    const [code] = await inTime(exit, "end of the adapter");
    return code;
  }

  /** Ends the adapter if no test has done it. */
  kill() {
    if (this.process?.exitCode === null) this.process.kill("SIGKILL");
  }
}

/** Debugs a program with `test`. The adapter ends without a fault, or like the program. */
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
