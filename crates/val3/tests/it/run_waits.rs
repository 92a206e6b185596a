//! Notes of waiting runs: where tasks wait, and why time is real.

use std::io::{BufRead as _, BufReader};
use std::process::Stdio;

use crate::support::Folder;

/// Reads the error output of a run until a line contains `text`, and ends the run.
fn told(folder: &Folder, arguments: &[&str], text: &str) -> String {
    let mut command = folder.command(arguments);
    let mut run = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    let mut told = String::new();
    for line in BufReader::new(run.stderr.take().unwrap()).lines() {
        told += &(line.unwrap() + "\n");
        if told.contains(text) {
            break;
        }
    }
    run.kill().unwrap();
    run.wait().unwrap();
    told
}

/// A task that waits in `code`, and another task that keeps the clock running.
fn waiting(code: &str) -> Folder {
    Folder::with(&format!(
        "
sio siHost
num nKey
joint jTo
mdesc mSlow
string sText
public bool bGo
program poll()
begin
  while true
    delay(0.5)
  endWhile
end
program work()
begin
  {code}
end
program start()
begin
  taskCreate \"poll\",10,poll()
  taskCreate \"work\",10,work()
end
"
    ))
}

#[test]
fn a_silent_run_names_the_waits_of_its_tasks() {
    for (code, reason) in [
        ("wait(bGo)", "task `work` waits for a condition at"),
        ("nKey=get()", "task `work` waits for the operator (`get`) at"),
        (
            "jTo.j1=10\n  movej(jTo,flange,mSlow)\n  waitEndMove()",
            "task `work` waits for the arm (`waitEndMove`), which has no power",
        ),
        ("bGo=true\n  setMutex(bGo)", "task `work` waits for another task (`setMutex`) at"),
        ("taskSuspend(\"work\")", "task `work` is suspended at"),
        ("while true\n    delay(0)\n  endWhile", "task `work` waits for time (`delay`) at"),
    ] {
        let folder = waiting(code);
        let told = told(&folder, &["run"], "help: Ctrl-C");
        assert!(told.contains("note: the run continues, after ") && told.contains(reason), "{code}: {told}");
    }
    let folder = Folder::with("delay(3600)\n");
    let told = told(&folder, &["run", "--time", "real"], "help: Ctrl-C");
    assert!(told.contains("task `main~` waits for time (`delay`)"), "{told}");
}

/// Data with `siHost` linked to the socket `host`.
const HOST: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1"><Value key="0" link="Socket\host" /></Data>
  </Datas>
</Database>"#;

#[test]
fn a_run_whose_time_becomes_real_says_so_once() {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let program = "program start()\nbegin\n  delay(1)\n  sioCtrl(siHost,\"timeout\",0.1)\n  siHost=\"a\"\n  delay(0.1)\n  siHost=\"b\"\nend\n";
    let folder = Folder::with(&format!("{program}{HOST}"));
    folder.write("day.toml", "[[at]]\nt = 100\nreceive = { 'Socket\\host' = \"x\" }\n");
    let end = format!(r"--line=Socket\host=client:{}", listener.local_addr().unwrap());
    let line = [end.as_str(), "--until=2", "--until-ok"];
    let run = folder.val3(&[&["run", "usrapp/main"], &line[..]].concat());
    let note =
        "note: task `main~` has a peer on `Socket\\host`: time is real; `receive` in a script keeps it virtual\n";
    assert_eq!(run.stderr.matches("time is real").count(), 1, "{run:?}");
    assert!(run.stderr.contains(note), "{run:?}");
    let run = folder.val3(&["run", "usrapp/main", "--script", "day.toml", "--until", "2", "--until-ok"]);
    assert!(!run.stderr.contains("time is real"), "{run:?}");
    let server = ["--line", r"Socket\host=server:0", "--until=2", "--until-ok"];
    let run = folder.val3(&[&["run", "usrapp/main"], &server[..]].concat());
    assert!(!run.stderr.contains("time is real"), "{run:?}");
    let run = folder.val3(&[&["run", "usrapp/main", "--time", "real"], &line[..]].concat());
    assert!(!run.stderr.contains("time is real"), "{run:?}");
}

/// Strings end with a carriage return unless configured otherwise.
#[test]
fn received_bytes_without_the_end_of_a_string_are_named() {
    let folder = Folder::with(&format!("program start()\n  string l_sText\nbegin\n  l_sText=siHost\nend\n{HOST}"));
    let arguments = ["run", "usrapp/main", "--script", "day.toml", "--until", "2"];
    folder.write("day.toml", "[[at]]\nt = 1\nreceive = { 'Socket\\host' = \"GO\\n\" }\n");
    let run = folder.val3(&arguments);
    let note = "\n  `Socket\\host` has received 3 bytes without the end of a string, the byte 13\n";
    assert!(run.stderr.contains(note), "{run:?}");
    folder.write("day.toml", "[[at]]\nt = 1\nreceive = { 'Socket\\host' = \"GO\\r\" }\n");
    assert_eq!(folder.val3(&arguments).code, 0);
}
