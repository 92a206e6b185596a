//! A serial line on a pseudo terminal, through `val3 run --line` (3.7).

use std::fs::{File, OpenOptions};
use std::io::{Read, Write};
use std::process::Stdio;

use rustix::termios::{ControlModes, tcgetattr};

use crate::support::Folder;
use crate::terminal::pair;

/// Communicates with the device: greets, sends two texts back, sends bytes, waits for a text that never arrives.
const PROGRAM: &str = r#"
sio siLine
string sText
num nBytes[5]
num nByte
num nAt
program start()
begin
  ? sioCtrl(siLine,"baudRate",19200)
  ? sioCtrl(siLine,"parity","even")
  ? sioCtrl(siLine,"bits",7)
  ? sioCtrl(siLine,"stopBits",2)
  ? sioCtrl(siLine,"endOfString",13)
  ? sioCtrl(siLine,"timeout",5)
  ? sioCtrl(siLine,"baudRate",0)
  ? sioCtrl(siLine,"port",1000)
  siLine="ready"
  sText=siLine
  ? sText
  sText=siLine
  ? sText
  nBytes[0]=1
  nBytes[1]=255
  nBytes[2]=13
  nBytes[3]=10
  nBytes[4]=0
  ? sioSet(siLine,nBytes)
  for nAt=0 to 4
    while sioGet(siLine,nByte)==0
      delay(0.004)
    endWhile
    ? nByte
  endFor
  ? sioCtrl(siLine,"timeout",0.2)
  ? sioGet(siLine,nByte)
  sText=siLine
end
"#;

/// The cell with the program, whose variable is linked to `Serial\port1`.
fn cell() -> Folder {
    let folder = Folder::with(PROGRAM);
    folder.link("siLine", r"Serial\port1");
    folder
}

/// Reads `count` bytes.
fn read(line: &mut File, count: usize) -> Vec<u8> {
    let mut bytes = vec![0; count];
    line.read_exact(&mut bytes).unwrap();
    bytes
}

/// Simulates the device at the other end.
fn answer(mut device: File) {
    assert_eq!(read(&mut device, 6), b"ready\r");
    // A text may arrive in parts, and two texts may arrive together.
    device.write_all(b"fir").unwrap();
    device.write_all(b"st\rsecond \xc3\xa9\r").unwrap();
    assert_eq!(read(&mut device, 5), [1, 255, 13, 10, 0], "bytes are sent as they are");
    device.write_all(&[0, 10, 13, 200, 7]).unwrap();
}

#[test]
fn a_serial_line_carries_texts_and_bytes_both_ways() {
    let folder = cell();
    let (device, name) = pair();
    // Both ends are kept open, so that the settings can be inspected.
    let end = OpenOptions::new().read(true).write(true).open(&name).unwrap();
    let line = format!("Serial\\port1=serial:{name}");
    let mut command =
        folder.command(&["run", "--until", "20", "--line", &line, "--events", "events.jsonl", "usrapp/main"]);
    let child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let played = device.try_clone().unwrap();
    let played = std::thread::spawn(move || answer(played));
    let output = child.wait_with_output().unwrap();
    let stdout = String::from_utf8(output.stdout).unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(stdout, EXPECTED, "{stderr}");
    assert_eq!(output.status.code(), Some(1));
    played.join().unwrap();
    assert!(stderr.contains("error[125]") && stderr.contains("sText=siLine"), "{stderr}");
    let modes = tcgetattr(&end).unwrap();
    assert_eq!((modes.input_speed(), modes.output_speed()), (19_200, 19_200));
    assert!(modes.control_modes.contains(ControlModes::CSTOPB), "two stop bits: {modes:?}");
    let replay =
        folder.val3(&["run", "--line", "Serial\\port1=serial:/no/such", "--replay", "events.jsonl", "usrapp/main"]);
    assert_eq!((replay.code, replay.stdout.as_str()), (1, EXPECTED), "{replay:?}");
}

/// Output of the program: results of valid settings, an invalid value and an invalid setting, then texts, bytes, and a
/// timeout.
const EXPECTED: &str = "0\n0\n0\n0\n0\n0\n-3\n-5\nfirst\nsecond é\n5\n0\n10\n13\n200\n7\n0\n0\n";

#[test]
fn a_line_without_a_device_is_refused() {
    let run = cell().val3(&["run", "--line", "Serial\\port1=serial:/no/such/device", "usrapp/main"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{run:?}");
    assert!(run.stderr.contains("/no/such/device") && run.stderr.contains("help:"), "{run:?}");
}

#[test]
fn an_unknown_line_is_rejected_with_the_names_of_all_lines() {
    let folder = cell();
    let run = folder.val3(&["run", "--line", r"Socket\prot1=server:0", "usrapp/main"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{run:?}");
    assert!(run.stderr.contains(r"neither the cell nor the application has a line `Socket\prot1`"), "{run:?}");
    assert!(run.stderr.contains(r"name one of these lines: Serial\port1"), "{run:?}");
    // Letter case is ignored, as for links.
    let run = folder.val3(&["run", "--until=0.1", "--line", r"serial\PORT1=serial:/no/such/device", "usrapp/main"]);
    assert!(run.stderr.contains("cannot open the device"), "{run:?}");
}

#[test]
fn a_line_of_a_program_without_lines_is_rejected() {
    let run =
        Folder::with("program start()\nbegin\nend\n").val3(&["run", "--line", r"Socket\host=server:0", "usrapp/main"]);
    assert_eq!(run.code, 2, "{run:?}");
    assert!(run.stderr.contains("link a variable of the type `sio` to it"), "{run:?}");
}
