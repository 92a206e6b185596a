//! A server in VAL 3 and a client in Python speak the simple message format of ROS-Industrial over TCP.

use std::io::Read;
use std::net::TcpListener;
use std::process::{Child, Command, Stdio};

use crate::support::{CommandOutput, Folder, run};

const SERVER: &str = include_str!("ros/server.listing");
const CLIENT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/it/ros/client.py");

/// A server that runs until the value goes.
struct Server {
    child: Child,
    _folder: Folder,
    feedback: u16,
    motion: u16,
}

impl Server {
    fn start() -> Self {
        let folder = Folder::with(SERVER);
        let [feedback, motion] = free_ports();
        let line = |name: &str, port: u16| format!(r"--line=Socket\{name}=server:{port}");
        let (first, second) = (line("Feedback", feedback), line("Motion", motion));
        let mut command = folder.command(&["run", "usrapp/main", "--time", "real", "--until", "120", &first, &second]);
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        Self { child: command.spawn().unwrap(), _folder: folder, feedback, motion }
    }

    /// The exit code and the messages of a server that ends on its own.
    fn end(mut self) -> (i32, String) {
        let code = self.child.wait().unwrap().code().unwrap();
        let mut said = String::new();
        self.child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        (code, said)
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Ports without listeners.
fn free_ports() -> [u16; 2] {
    let listeners = [0, 1].map(|_| TcpListener::bind("127.0.0.1:0").unwrap());
    listeners.map(|listener| listener.local_addr().unwrap().port())
}

/// The output of the client.
#[track_caller]
fn client(arguments: &[&str]) -> String {
    let mut command = Command::new("python3");
    command.arg(CLIENT).args(arguments);
    let CommandOutput { code, stdout, stderr } = run(command);
    assert_eq!((code, stderr.as_str()), (0, ""));
    stdout
}

#[test]
fn joints_and_status_are_streamed() {
    let server = Server::start();
    let joints = |sequence: u32| format!("joints kind=1 code=0 {sequence} 0 0.5 0 0 0 0 0 0 0 0\n");
    let status = "status kind=1 code=0 1 0 0 0 0 2 1\n".to_owned();
    let mut expected: Vec<String> = (0..5).map(joints).collect();
    expected.push(status.clone());
    expected.extend((5..10).map(joints));
    expected.push(status);
    assert_eq!(client(&["feedback", &server.feedback.to_string(), "12"]), expected.concat());
}

/// The point is answered before the move that it asks for.
#[test]
fn a_trajectory_point_is_answered() {
    let server = Server::start();
    let answer = client(&["motion", &server.motion.to_string(), "0.1", "0.2"]);
    assert_eq!(answer, "point kind=3 code=1 7\n");
    let (code, said) = server.end();
    assert_eq!(code, 1);
    assert!(said.contains("motion is not available yet: `movej` cannot be executed (task `motion`)"), "{said}");
    assert!(said.contains("movej(l_jGoal,flange,l_mFast)"), "{said}");
}
