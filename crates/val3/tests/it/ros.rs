//! A server in VAL 3 and a client in Python exchange ROS-Industrial simple messages over TCP.

use std::process::{Child, Command, Stdio};

use crate::support::{CommandOutput, Folder, free_port, run};

const SERVER: &str = include_str!("ros/server.listing");
const CLIENT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/it/ros/client.py");

/// A server that is killed on drop.
struct Server {
    child: Child,
    _folder: Folder,
    feedback: u16,
    motion: u16,
}

impl Server {
    fn start() -> Self {
        let folder = Folder::with(SERVER);
        let [feedback, motion] = [free_port(), free_port()];
        let line = |name: &str, port: u16| format!(r"--line=Socket\{name}=server:{port}");
        let (first, second) = (line("Feedback", feedback), line("Motion", motion));
        let mut command = folder.command(&["run", "usrapp/main", "--time", "real", "--until", "600", &first, &second]);
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        Self { child: command.spawn().unwrap(), _folder: folder, feedback, motion }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Output of the client.
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

/// The server acknowledges recorded points, and the arm moves to them. Meanwhile, it sends its joint position.
#[test]
fn a_trajectory_is_answered_and_followed() {
    let server = Server::start();
    let (motion, feedback) = (server.motion.to_string(), server.feedback.to_string());
    let answer = client(&["motion", &motion, &feedback, "10,5,85,0,45,0", "40,-10,95,10,60,5", "60,0,90,0,90,-20"]);
    let answers = "point kind=3 code=1 0\npoint kind=3 code=1 1\npoint kind=3 code=1 2\npoint kind=3 code=1 -3\n";
    // The server adds half a degree to the second joint.
    assert_eq!(answer, format!("{answers}moved 60.000 0.500 0.000 0.000 0.000 0.000\n"));
}
