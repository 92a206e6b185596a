//! `val3 lsp` as a process.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Timeout above the shutdown time of a server on a busy machine.
const TIMEOUT: Duration = Duration::from_secs(30);

fn server(arguments: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_val3"))
        .arg("lsp")
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap()
}

fn send(server: &mut Child, message: &str) {
    let input = server.stdin.as_mut().unwrap();
    write!(input, "Content-Length: {}\r\n\r\n{message}", message.len()).unwrap();
    input.flush().unwrap();
}

/// Exit code of a server that ends although its input is open.
fn exit_code(server: &mut Child) -> Option<i32> {
    let started = Instant::now();
    while started.elapsed() < TIMEOUT {
        if let Some(status) = server.try_wait().unwrap() {
            return status.code();
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    server.kill().unwrap();
    panic!("the server does not end");
}

fn initialize(process: u32) -> String {
    let params = format!("{{\"processId\":{process},\"capabilities\":{{}}}}");
    format!("{{\"jsonrpc\":\"2.0\",\"id\":0,\"method\":\"initialize\",\"params\":{params}}}")
}

#[test]
fn a_session_ends_with_exit() {
    let folder = tempfile::tempdir().unwrap();
    let log = folder.path().join("val3.log");
    // Arguments that editors pass.
    let mut server = server(&["--stdio", "--clientProcessId=1", "--log", log.to_str().unwrap()]);
    send(&mut server, &initialize(std::process::id()));
    let mut output = BufReader::new(server.stdout.take().unwrap());
    let mut head = String::new();
    output.read_line(&mut head).unwrap();
    assert!(head.starts_with("Content-Length: "), "{head}");
    let drain = std::thread::spawn(move || output.read_to_end(&mut Vec::new()).unwrap());
    send(&mut server, r#"{"jsonrpc":"2.0","id":1,"method":"shutdown"}"#);
    send(&mut server, r#"{"jsonrpc":"2.0","method":"exit"}"#);
    assert_eq!(exit_code(&mut server), Some(0));
    drain.join().unwrap();
    assert!(std::fs::read_to_string(log).unwrap().contains("the session ends"));
}

#[test]
fn the_server_ends_with_its_input() {
    let mut server = server(&[]);
    drop(server.stdin.take());
    assert_eq!(exit_code(&mut server), Some(1));
}

#[cfg(unix)]
#[test]
fn the_server_ends_with_its_client() {
    let mut client = Command::new("sleep").arg("60").spawn().unwrap();
    let mut server = server(&[]);
    send(&mut server, &initialize(client.id()));
    // After the first response, the server watches the client process.
    let mut head = [0; 8];
    server.stdout.as_mut().unwrap().read_exact(&mut head).unwrap();
    client.kill().unwrap();
    client.wait().unwrap();
    assert_eq!(exit_code(&mut server), Some(1));
}
