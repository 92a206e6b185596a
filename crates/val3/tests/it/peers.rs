//! Sockets of a run with real peers. The run receives their data and survives their faults, and its recording is
//! replayed without them.

use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream, UdpSocket};
use std::thread::{JoinHandle, sleep, spawn};
use std::time::{Duration, Instant};

use crate::support::{CommandOutput, Folder, free_port};

/// Timeout of a peer that waits for the run.
const TIMEOUT: Duration = Duration::from_secs(20);

const DATA: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1">
      <Value key="0" link="Socket\host" />
    </Data>
    <Data name="nByte" access="private" xsi:type="array" type="num" size="100" />
    <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
    <Data name="sText" access="private" xsi:type="array" type="string" size="1" />
  </Datas>
</Database>"#;

/// An application with `siHost` linked to `Socket\host`.
fn application(programs: &str) -> Folder {
    Folder::with(&format!("{programs}\n{DATA}"))
}

/// Runs the application with `Socket\host` at `end`, in real time, so that a server waits for its client.
fn run(folder: &Folder, end: &str, more: &[&str]) -> CommandOutput {
    let line = format!(r"--line=Socket\host={end}");
    folder.val3(&[&["run", &line, "--time", "real", "--until", "20", "--events", "events.jsonl"], more].concat())
}

/// Connects to a server as soon as it listens.
fn call(port: u16) -> TcpStream {
    let started = Instant::now();
    loop {
        match TcpStream::connect((Ipv4Addr::LOCALHOST, port)) {
            Ok(stream) => {
                stream.set_read_timeout(Some(TIMEOUT)).unwrap();
                return stream;
            }
            Err(error) if started.elapsed() > TIMEOUT => panic!("nobody listens at {port}: {error}"),
            Err(_) => sleep(Duration::from_millis(5)),
        }
    }
}

/// Sends a text and returns the response, without its end character.
fn ask(stream: &TcpStream, text: &str) -> String {
    let mut out = stream;
    out.write_all(text.as_bytes()).unwrap();
    let mut answer = Vec::new();
    BufReader::new(stream).read_until(b'\r', &mut answer).unwrap();
    assert_eq!(answer.pop(), Some(b'\r'), "{answer:?}");
    String::from_utf8(answer).unwrap()
}

/// Replays the run without peers, and checks that the output is identical.
#[track_caller]
fn replays(folder: &Folder, end: &str, first: &CommandOutput) {
    let recorded = folder.read("events.jsonl");
    assert!(recorded.contains(r#""kind":"line""#), "{recorded}");
    folder.write("recorded.jsonl", &recorded);
    let again = run(folder, end, &["--replay", "recorded.jsonl"]);
    assert_eq!((again.code, &again.stdout), (first.code, &first.stdout));
    let repeated = folder.read("events.jsonl");
    let events = |record: &str| record.lines().skip(1).map(str::to_owned).collect::<Vec<_>>();
    assert!(events(&repeated) == events(&recorded), "other events");
}

const ECHO: &str = r#"
program start()
begin
  sioCtrl(siHost,"timeout",10)
  do
    sText=siHost
    ? sText
    siHost="got "+sText
  until sText=="end"
end
"#;

#[test]
fn a_server_is_recorded_and_replayed() {
    let folder = application(ECHO);
    let port = free_port();
    let peer = spawn(move || {
        let stream = call(port);
        let answers = ["one\r", "two\r", "grün\r", "end\r"].map(|text| ask(&stream, text));
        assert_eq!(answers, ["got one", "got two", "got grün", "got end"]);
    });
    let end = format!("server:{port}");
    folder.write("val3.toml", &format!("run.lines = {{ 'Socket\\host' = \"{end}\" }}"));
    let first = folder.val3(&["run", "--time", "real", "--until", "20", "--events", "events.jsonl"]);
    peer.join().unwrap();
    assert_eq!((first.code, first.stdout.as_str()), (0, "one\ntwo\ngrün\nend\n"), "{first:?}");
    assert!(folder.read("events.jsonl").contains(r#""kind":"clock","wall":true"#), "it waits for its peer");
    replays(&folder, &end, &first);
}

/// A server that reads one line and responds, for `calls` connections.
fn host(listener: TcpListener, calls: usize) -> JoinHandle<Vec<String>> {
    spawn(move || {
        let mut lines = Vec::new();
        for _ in 0..calls {
            let (stream, _) = listener.accept().unwrap();
            lines.push(respond(&stream));
        }
        lines
    })
}

/// Reads a line and responds to it. Returns the line.
fn respond(mut stream: &TcpStream) -> String {
    stream.set_read_timeout(Some(TIMEOUT)).unwrap();
    let mut line = Vec::new();
    BufReader::new(stream).read_until(b'\r', &mut line).unwrap();
    stream.write_all(b"welcome\r").unwrap();
    String::from_utf8(line).unwrap()
}

#[test]
fn a_client_reconnects_and_is_replayed() {
    let folder = application(
        r#"
program start()
begin
  sioCtrl(siHost,"timeout",10)
  for nCount=1 to 2
    siHost="hello "+toString("",nCount)
    sText=siHost
    ? sText
    ? clearBuffer(siHost)
    ? clearBuffer(siHost)
  endFor
end
"#,
    );
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let end = format!("client:127.0.0.1:{}", listener.local_addr().unwrap().port());
    let peer = host(listener, 2);
    let first = run(&folder, &end, &[]);
    assert_eq!(peer.join().unwrap(), ["hello 1\r", "hello 2\r"]);
    assert_eq!(first.code, 0, "{first:?}");
    assert!(first.stdout.starts_with("welcome\n") && first.stdout.matches("-1\n").count() >= 2, "{first:?}");
    replays(&folder, &end, &first);
}

#[test]
fn datagrams_are_recorded_and_replayed() {
    let folder = application(ECHO);
    let port = free_port();
    let peer = spawn(move || {
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        socket.connect((Ipv4Addr::LOCALHOST, port)).unwrap();
        socket.set_read_timeout(Some(Duration::from_millis(50))).unwrap();
        let started = Instant::now();
        let mut answer = [0; 64];
        for text in ["one\r", "end\r"] {
            // Datagrams are lost until the run listens.
            let heard = loop {
                assert!(started.elapsed() < TIMEOUT);
                let _ = socket.send(text.as_bytes());
                match socket.recv(&mut answer) {
                    Ok(count) => break answer[..count].to_vec(),
                    Err(_) => sleep(Duration::from_millis(5)),
                }
            };
            assert_eq!(heard, format!("got {text}").as_bytes());
        }
    });
    let end = format!("udp:{port}");
    let first = run(&folder, &end, &[]);
    peer.join().unwrap();
    assert_eq!((first.code, first.stdout.as_str()), (0, "one\nend\n"), "{first:?}");
    replays(&folder, &end, &first);
}

/// An endless stream that is faster than the program: unread bytes are not buffered, and time advances.
#[test]
fn a_flood_is_read_string_by_string() {
    let folder = application(
        r#"
program start()
begin
  sioCtrl(siHost,"timeout",10)
  for nCount=1 to 500
    sText=siHost
    if len(sText)!=128
      ? "short"
    endIf
  endFor
  ? sioGet(siHost,nByte)
  ? clearBuffer(siHost)>=0
end
"#,
    );
    let port = free_port();
    let peer = spawn(move || {
        let mut stream = call(port);
        let flood = [b'x'; 65_536];
        let mut sent = 0;
        while let Ok(count @ 1..) = stream.write(&flood) {
            sent += count;
            assert!(sent < 1 << 30, "it takes everything");
        }
        sent
    });
    let first = run(&folder, &format!("server:{port}"), &[]);
    assert!(peer.join().unwrap() >= 500 * 128);
    assert_eq!((first.code, first.stdout.as_str()), (0, "100\ntrue\n"), "{first:?}");
}

/// If a peer connects and sends nothing or an incomplete text, only its task gets the timeout error (125).
#[test]
fn a_stalled_peer_times_out() {
    let folder = application(
        r#"
program listen()
begin
  sText=siHost
end
program start()
begin
  sioCtrl(siHost,"timeout",0.2)
  nCount=sioGet(siHost,nByte)
  while nCount<0
    nCount=sioGet(siHost,nByte)
  endWhile
  ? nCount
  taskCreate "listen",10,listen()
  wait(taskStatus("listen")!=1)
  ? taskStatus("listen")
  ? sioGet(siHost,nByte)
  taskKill("listen")
end
"#,
    );
    let port = free_port();
    let peer = spawn(move || {
        let mut stream = call(port);
        stream.write_all(b"?").unwrap();
        let mut rest = Vec::new();
        let _ = stream.read_to_end(&mut rest);
    });
    let first = run(&folder, &format!("server:{port}"), &[]);
    peer.join().unwrap();
    assert_eq!((first.code, first.stdout.as_str()), (0, "1\n125\n-1\n"), "{first:?}");
}

/// If a peer does not read, `sioSet` returns the number of sent bytes, or -1, after the timeout.
#[test]
fn a_peer_that_does_not_read_times_out() {
    let folder = application(
        r#"
program start()
begin
  sioCtrl(siHost,"timeout",0.2)
  while sioGet(siHost,nByte)<0
  endWhile
  do
    nCount=sioSet(siHost,nByte)
  until nCount!=size(nByte)
  ? nCount<size(nByte)
end
"#,
    );
    let port = free_port();
    let (done, wait) = std::sync::mpsc::channel::<()>();
    let peer = spawn(move || {
        let mut stream = call(port);
        stream.write_all(b"?").unwrap();
        let _ = wait.recv_timeout(TIMEOUT);
    });
    let line = format!(r"--line=Socket\host=server:{port}");
    let first = folder.val3(&["run", &line, "--time", "real", "--until", "60"]);
    drop(done);
    peer.join().unwrap();
    assert_eq!((first.code, first.stdout.as_str()), (0, "true\n"), "{first:?}");
}

/// Peers that reset the connection with unread bytes in both directions. The server accepts the next connection.
#[test]
fn a_reset_ends_only_its_connection() {
    let folder = application(ECHO);
    let port = free_port();
    let peer = spawn(move || {
        for _ in 0..3 {
            let mut stream = call(port);
            socket2::SockRef::from(&stream).set_linger(Some(Duration::ZERO)).unwrap();
            stream.write_all(b"half a wor").unwrap();
            drop(stream);
        }
        // The run may still process earlier connections.
        let started = Instant::now();
        loop {
            let mut stream = call(port);
            let mut answer = [0; 4];
            match stream.write_all(b"end\r").and_then(|()| stream.read_exact(&mut answer)) {
                Ok(()) => return stream.shutdown(Shutdown::Both).unwrap_or_default(),
                Err(error) => assert!(started.elapsed() < TIMEOUT && error.kind() != ErrorKind::TimedOut, "{error}"),
            }
        }
    });
    let first = run(&folder, &format!("server:{port}"), &[]);
    peer.join().unwrap();
    assert_eq!(first.code, 0, "{first:?}");
    assert!(first.stdout.ends_with("end\n"), "{first:?}");
    replays(&folder, &format!("server:{port}"), &first);
}

/// With a task that never waits, virtual time must not skip a timeout of two seconds.
#[test]
fn a_busy_task_does_not_block_a_peer() {
    let folder = application(
        r#"
program listen()
begin
  sText=siHost
  ? sText
end
program start()
begin
  sioCtrl(siHost,"timeout",2)
  taskCreate "listen",10,listen()
  do
    nCount=nCount+1
  until taskStatus("listen")!=1
end
"#,
    );
    let port = free_port();
    let peer = spawn(move || {
        let mut stream = call(port);
        sleep(Duration::from_millis(300));
        stream.write_all(b"late\r").unwrap();
    });
    let first = run(&folder, &format!("server:{port}"), &[]);
    peer.join().unwrap();
    assert_eq!((first.code, first.stdout.as_str()), (0, "late\n"), "{first:?}");
}
