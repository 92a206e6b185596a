//! Debugging through the process, as for a client: `cargo build --profile dist -p val3 && cargo bench --profile dist
//! --bench protocol`.
//!
//! Targets: 95 of 100 steps are completed in under 5 ms, a step back after 10 million lines in under 100 ms, and a page
//! from an array with 100,000 elements in under 5 ms.

#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a session that fails measures nothing"
)]
#![allow(clippy::disallowed_methods, reason = "it measures the time of a process")]

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use val3_test::Fixture;

/// Counts in a loop of three lines, each of which has a duration of 2 µs on the controller.
const LISTING: &str = "
num nMany[100000]
program start()
num l_n
begin
  while true
    l_n=l_n+1
    nMany[3]=l_n
  endWhile
end
";

/// Number of steps and pages, of which the slowest twentieth is ignored.
const SAMPLES: usize = 400;

/// Time after which the run goes back: longer than the duration of 10 million lines.
const RUN: Duration = Duration::from_secs(3);

/// A client of `val3 dap`.
struct Client {
    adapter: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    seq: i64,
}

impl Client {
    /// Starts a session that has stopped before the first line.
    fn launch(program: &str) -> Self {
        // Benches are in a folder next to the profile's binaries.
        let mut binary = std::env::current_exe().expect("the bench has a path");
        binary.pop();
        binary.pop();
        let mut command = Command::new(binary.join("val3"));
        let started = command.arg("dap").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut adapter = started.expect("build it first: cargo build --profile dist -p val3");
        let input = adapter.stdin.take().expect("a pipe");
        let output = BufReader::new(adapter.stdout.take().expect("a pipe"));
        let mut client = Self { adapter, input, output, seq: 0 };
        client.ask("initialize", &json!({ "adapterID": "val3" }));
        client.ask("launch", &json!({ "program": program, "stopOnEntry": true }));
        client.ask("configurationDone", &json!({}));
        client.event("stopped");
        client
    }

    fn send(&mut self, command: &str, arguments: &Value) {
        self.seq += 1;
        let request = json!({ "seq": self.seq, "type": "request", "command": command, "arguments": arguments });
        let body = request.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{body}", body.len()).expect("the adapter reads");
        self.input.flush().expect("the adapter reads");
    }

    fn message(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            self.output.read_line(&mut line).expect("the adapter writes");
            match line.trim().strip_prefix("Content-Length: ") {
                Some(number) => length = number.parse().expect("a number"),
                None => break,
            }
        }
        let mut body = vec![0; length];
        self.output.read_exact(&mut body).expect("the adapter writes");
        serde_json::from_slice(&body).expect("a message")
    }

    /// Sends a request, and returns the body from its response.
    fn ask(&mut self, command: &str, arguments: &Value) -> Value {
        self.send(command, arguments);
        loop {
            let mut message = self.message();
            if message["request_seq"] == self.seq {
                assert_eq!(message["success"], true, "{message}");
                return message["body"].take();
            }
        }
    }

    fn event(&mut self, name: &str) -> Value {
        loop {
            let mut message = self.message();
            if message["event"] == name {
                return message["body"].take();
            }
        }
    }

    /// Returns the time from a request that continues the run to the next stop.
    fn until_stopped(&mut self, command: &str, task: &Value) -> Duration {
        let started = Instant::now();
        self.send(command, &json!({ "threadId": task }));
        self.event("stopped");
        started.elapsed()
    }

    fn frame(&mut self, task: &Value) -> Value {
        self.ask("stackTrace", &json!({ "threadId": task }))["stackFrames"][0]["id"].take()
    }

    /// Returns the number of executed loops.
    fn loops(&mut self, task: &Value) -> u64 {
        let frame = self.frame(task);
        let value = self.ask("evaluate", &json!({ "expression": "l_n", "frameId": frame, "context": "watch" }));
        value["result"].as_str().and_then(|number| number.parse().ok()).expect("a number")
    }

    /// Returns the reference of the global data.
    fn globals(&mut self, task: &Value) -> Value {
        let frame = self.frame(task);
        let scopes = self.ask("scopes", &json!({ "frameId": frame }));
        let scopes = scopes["scopes"].as_array().expect("scopes");
        let globals = scopes.iter().find(|scope| scope["name"] == "Globals").expect("global data");
        globals["variablesReference"].clone()
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        // The process ends with the bench.
        let _ = self.adapter.kill();
        let _ = self.adapter.wait();
    }
}

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    for (path, text) in Fixture::parse(LISTING).files {
        let path = folder.path().join(path);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        std::fs::write(path, text).expect("a file");
    }
    let program = folder.path().join("usrapp/main");
    let mut client = Client::launch(program.to_str().expect("a path"));
    let task = client.ask("threads", &json!({}))["threads"][0]["id"].clone();

    let steps = (0..SAMPLES).map(|_| client.until_stopped("next", &task)).collect();
    report("step", steps);
    pages(&mut client, &task);

    client.ask("continue", &json!({ "threadId": task }));
    std::thread::sleep(RUN);
    client.until_stopped("pause", &task);
    println!("run of {} million lines", 3 * client.loops(&task) / 1_000_000);
    let back = (0..20).map(|_| client.until_stopped("stepBack", &task)).collect();
    report("line back", back);
}

/// Requests pages of the array at different positions.
fn pages(client: &mut Client, task: &Value) {
    let globals = client.globals(task);
    let variables = client.ask("variables", &json!({ "variablesReference": globals }));
    let variables = variables["variables"].as_array().expect("variables");
    let array = variables.iter().find(|found| found["name"] == "nMany").expect("the array");
    let reference = array["variablesReference"].clone();
    let durations = (0..SAMPLES).map(|number| page_duration(client, &reference, number * 200));
    report("page of an array of 100,000 elements", durations.collect());
}

/// Returns the duration of a request for 100 elements from `start`.
fn page_duration(client: &mut Client, array: &Value, start: usize) -> Duration {
    let started = Instant::now();
    let page = json!({ "variablesReference": array, "start": start, "count": 100, "filter": "indexed" });
    let found = client.ask("variables", &page);
    assert_eq!(found["variables"].as_array().map(Vec::len), Some(100));
    started.elapsed()
}

fn report(name: &str, mut times: Vec<Duration>) {
    times.sort_unstable();
    let at = |part: usize| times.get((times.len() - 1) * part / 100).map_or(0.0, |time| time.as_secs_f64() * 1e3);
    println!("{name}: median {:.2} ms, p95 {:.2} ms, longest {:.2} ms", at(50), at(95), at(100));
}
