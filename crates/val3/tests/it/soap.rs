//! `val3 run --controller`: clients of the SOAP interface of a run.

use std::io::{Read as _, Write as _};
use std::net::TcpStream;
use std::process::{Child, Stdio};
use std::time::Duration;

use expect_test::expect;
use rustix::process::{Pid, Signal, kill_process};

use crate::support::Folder;
use crate::waiting::{OutputLines, ended};

/// Run with clients.
struct ControlledRun {
    process: Child,
    stderr: OutputLines,
    address: String,
    folder: Folder,
}

impl ControlledRun {
    fn of(code: &str, options: &[&str]) -> Self {
        let folder = Folder::with(code);
        let run = ["run", "usrapp/main", "--controller", "0"];
        let mut command = folder.command(&[&run, options].concat());
        let mut process = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
        let stderr = OutputLines::of(process.stderr.take().unwrap());
        let note = stderr.wait_for("http://");
        let address = note.trim().rsplit("http://").next().unwrap().trim_end_matches('/').to_owned();
        Self { process, stderr, address, folder }
    }

    /// Body of the answer to a request of the first server.
    fn ask(&self, session: &str, request: &str) -> String {
        let body = format!(
            "<s:Envelope xmlns:s='http://www.w3.org/2003/05/soap-envelope' xmlns:v='CS8ServerV0'><s:Header>{session}\
             </s:Header><s:Body>{request}</s:Body></s:Envelope>"
        );
        let mut stream = TcpStream::connect(&self.address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
        let length = body.len();
        let head = "POST / HTTP/1.1\r\nHost: robot\r\nConnection: close\r\nContent-Type: application/soap+xml";
        write!(stream, "{head}\r\nContent-Length: {length}\r\n\r\n{body}").unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        answer.split_once("Body>").unwrap().1.to_owned()
    }

    /// Logs in. Returns the session for the header.
    fn login(&self) -> String {
        let answer = self.ask("", "<v:login><user>default</user></v:login>");
        let sid = answer.split_once("<sid>").unwrap().1.split_once('<').unwrap().0;
        format!("<v:sessionId>{sid}</v:sessionId>")
    }

    /// Joints in rad.
    fn joints(&self, session: &str) -> Vec<f64> {
        let answer = self.ask(session, "<v:getRobotJointPos><robot>0</robot></v:getRobotJointPos>");
        answer.split("<item>").skip(1).map(|item| item.split_once('<').unwrap().0.parse().unwrap()).collect()
    }

    /// Exit code and the rest of the error output after Ctrl-C.
    fn interrupt(&mut self) -> (i32, String) {
        kill_process(Pid::from_child(&self.process), Signal::INT).unwrap();
        (ended(&mut self.process).code().unwrap(), self.stderr.rest())
    }
}

impl Drop for ControlledRun {
    fn drop(&mut self) {
        // The process has already ended, unless the test has failed.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

#[test]
fn joints_are_those_of_the_trace_in_radians() {
    let start = ["--start", "10,20,80,-30,40,50", "--trace-all", "trace.csv"];
    let mut run = ControlledRun::of("delay(100)\n", &start);
    let session = run.login();
    let joints = run.joints(&session);
    assert_eq!(run.interrupt().0, 130);
    let trace = run.folder.read("trace.csv");
    let mut lines = trace.lines();
    let columns: Vec<&str> = lines.next().unwrap().split(',').collect();
    let first: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| first[columns.iter().position(|column| *column == name).unwrap()].parse::<f64>().unwrap();
    let traced: Vec<f64> = (1..=6).map(|axis| column(&format!("j{axis}")).to_radians()).collect();
    assert_eq!(joints.len(), 6);
    assert!(joints.iter().zip(&traced).all(|(read, traced)| (read - traced).abs() < 1e-6), "{joints:?} {traced:?}");
}

#[test]
fn the_controller_remains_when_the_application_has_ended() {
    let mut run = ControlledRun::of("delay(0.01)\n", &[]);
    let session = run.login();
    std::thread::sleep(Duration::from_millis(200));
    assert_eq!(run.joints(&session).len(), 6);
    assert_eq!(run.interrupt().0, 130);
}

#[test]
fn a_run_with_a_limit_ends() {
    let mut run = ControlledRun::of("delay(100)\n", &["--until", "0.5", "--until-ok"]);
    assert_eq!(ended(&mut run.process).code(), Some(0));
    assert!(TcpStream::connect(&run.address).is_err());
}

/// `val3 status --soap` reads what the virtual controller offers.
#[test]
fn a_controller_shows_its_state() {
    let mut run = ControlledRun::of("delay(100)\n", &["--start", "10,20,80,-30,40,50"]);
    let shown = run.folder.val3(&["status", "--soap", &run.address]);
    assert_eq!(shown.code, 0, "{}", shown.stderr);
    expect![[r#"
        ADDRESS: interface 1.2
        arm 0: tx2_90-S1
          joints  10.000 20.000 80.000 -30.000 40.000 50.000
          flange  666.249 135.614 257.445 -16.539 135.287 30.613 in world
        in memory: Disk://main/main.pjx
        task main~: running, start line 2: delay(100)
    "#]]
    .assert_eq(&shown.stdout.replace(&run.address, "ADDRESS"));
    let json = run.folder.val3(&["status", "--format", "json", "--soap", &format!("http://{}/", run.address)]);
    let document: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!(document["tasks"][0]["line"], 2);
    let joints: Vec<f64> =
        document["arms"][0]["joints"].as_array().unwrap().iter().filter_map(serde_json::Value::as_f64).collect();
    assert!(joints.iter().zip([10.0, 20.0, 80.0, -30.0, 40.0, 50.0]).all(|(read, set)| (read - set).abs() < 1e-9));
    let stranger = run.folder.val3(&["status", "--soap", &format!("nobody@{}", run.address)]);
    assert_eq!(stranger.code, 2);
    assert!(stranger.stderr.contains("rejects the login of the profile `nobody`"), "{}", stranger.stderr);
    run.interrupt();
    let silent = run.folder.val3(&["status", "--soap", &run.address]);
    assert!(silent.code == 2 && silent.stderr.contains("does not answer `login`"), "{}", silent.stderr);
}
