//! Damaged files and special files: no command reports success for them, blocks on them, or fills the memory.

use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::os::unix::fs::{PermissionsExt as _, symlink};
use std::os::unix::net::UnixListener;
use std::process::{ChildStdin, Stdio};
use std::sync::mpsc;
use std::time::Duration;

use rustix::fs::{CWD, FileType, Mode, mknodat};
use serde_json::{Value, json};

use crate::dap_client::Session;
use crate::support::{CommandOutput, Folder};

/// Timeout above the duration of any command on a busy machine. A slower command hangs.
const TIMEOUT: Duration = Duration::from_secs(120);

/// A cell with all file types.
const CELL: &str = r#"
num nCount=3
program start()
begin
  nCount=nCount+1
end
=== /configs/arm.cfx
<?xml version="1.0" encoding="utf-8" ?>
<arm>
  <String name="arm" value="tx2_60-S1" />
  <String name="mount" value="floor" />
</arm>
=== /configs/cell.cfx
<?xml version="1.0" encoding="utf-8" ?>
<cell>
  <String name="language" value="english" />
  <Float name="cycleTime" value="0.004" />
</cell>
=== /configs/controller.cfx
<?xml version="1.0" encoding="utf-8" ?>
<controller>
  <String name="serialNumber" value="1" />
  <Bool name="simulMode" value="true" />
</controller>
=== /configs/sio.cfx
<?xml version="1.0" encoding="utf-8" ?>
<sio>
  <socketClt>
    <String name="name" value="host" />
  </socketClt>
</sio>
=== /configs/bio.cfx
<?xml version="1.0" encoding="utf-8" ?>
<bio>
  <bioDin index="0" name="bIn0" />
  <bioDout index="0" name="bOut0" />
</bio>
=== /app/val3.Motion.anthro.cfx
<?xml version="1.0" encoding="utf-8" ?>
<Language xmlns="http://www.staubli.com/robotics/VAL3/1">
  <Functions>
    <Func>
      <Name>$stop</Name>
      <Return>void</Return>
      <Class>Modifier</Class>
    </Func>
  </Functions>
</Language>
"#;

/// Files of the project.
const PROJECT_FILES: [&str; 3] = ["usrapp/main/main.pjx", "usrapp/main/main.dtx", "usrapp/main/start.pgx"];

/// Files of the cell, without the tables of add-ons.
const CELL_FILES: [&str; 5] =
    ["configs/arm.cfx", "configs/cell.cfx", "configs/controller.cfx", "configs/sio.cfx", "configs/bio.cfx"];

const TABLE: &str = "app/val3.Motion.anthro.cfx";

/// A kind of damage.
struct Damage {
    /// Creates the damaged entry at a path, from the bytes of the original file.
    apply: fn(&str, &[u8]),
    /// Text in every message about the entry.
    name: &'static str,
    /// Whether the content is text of which only a part is readable. For project files, the faults have locations.
    is_text: bool,
}

const DAMAGES: [Damage; 13] = [
    Damage { apply: utf16, name: "UTF-16", is_text: false },
    Damage { apply: |path, _| fs::write(path, b"").unwrap(), name: "it is empty", is_text: false },
    Damage { apply: |path, _| fs::write(path, b"\r\n ").unwrap(), name: "it is empty", is_text: false },
    Damage { apply: |path, bytes| fs::write(path, vec![0; bytes.len()]).unwrap(), name: "NUL bytes", is_text: false },
    Damage { apply: half_nul, name: "NUL bytes", is_text: false },
    Damage { apply: lfs_pointer, name: "Git LFS pointer", is_text: false },
    Damage { apply: |path, _| fs::write(path, b"PK\x03\x04\x14\0").unwrap(), name: "ZIP archive", is_text: false },
    Damage { apply: folder, name: "it is a folder", is_text: false },
    Damage { apply: pipe, name: "it is a pipe", is_text: false },
    Damage { apply: |path, _| drop(UnixListener::bind(path).unwrap()), name: "it is a socket", is_text: false },
    Damage { apply: denied, name: "permission denied", is_text: false },
    Damage { apply: cut, name: "", is_text: true },
    Damage { apply: conflict, name: "merge conflict", is_text: true },
];

fn utf16(path: &str, bytes: &[u8]) {
    let text = String::from_utf8(bytes.to_vec()).unwrap();
    let units = text.encode_utf16().flat_map(u16::to_le_bytes);
    fs::write(path, [0xFF, 0xFE].into_iter().chain(units).collect::<Vec<u8>>()).unwrap();
}

fn half_nul(path: &str, bytes: &[u8]) {
    fs::write(path, [&bytes[..bytes.len() / 2], &vec![0; 512]].concat()).unwrap();
}

fn lfs_pointer(path: &str, _: &[u8]) {
    fs::write(path, "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a2146\nsize 12345\n").unwrap();
}

fn folder(path: &str, _: &[u8]) {
    fs::create_dir(path).unwrap();
}

fn pipe(path: &str, _: &[u8]) {
    mknodat(CWD, path, FileType::Fifo, Mode::from_raw_mode(0o600), 0).unwrap();
}

fn denied(path: &str, bytes: &[u8]) {
    fs::write(path, bytes).unwrap();
    fs::set_permissions(path, fs::Permissions::from_mode(0o000)).unwrap();
}

/// Whether the user is root, for whom missing permissions have no effect.
fn is_root() -> bool {
    rustix::process::getuid().is_root()
}

fn cut(path: &str, bytes: &[u8]) {
    fs::write(path, &bytes[..bytes.len() * 2 / 3]).unwrap();
}

fn conflict(path: &str, bytes: &[u8]) {
    let text = String::from_utf8(bytes.to_vec()).unwrap();
    let middle = text.lines().count() / 2;
    let lines: Vec<&str> = text.lines().collect();
    let (before, after) = lines.split_at(middle);
    let conflict = ["<<<<<<< HEAD", after[0], "=======", after[0], ">>>>>>> theirs"];
    fs::write(path, [before, &conflict, &after[1..]].concat().join("\n")).unwrap();
}

/// The cell with one damaged file.
fn damaged(file: &str, damage: &Damage) -> Folder {
    let folder = Folder::with(CELL);
    let path = folder.path().join(file);
    let bytes = fs::read(&path).unwrap();
    fs::remove_file(&path).unwrap();
    (damage.apply)(path.to_str().unwrap(), &bytes);
    folder
}

fn damages() -> impl Iterator<Item = &'static Damage> {
    DAMAGES.iter().filter(|damage| damage.name != "permission denied" || !is_root())
}

/// Runs a command that must terminate, and returns its output.
fn ends(folder: &Folder, args: &[&str]) -> CommandOutput {
    let mut command = folder.command(args);
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let (out, err) = (child.stdout.take().unwrap(), child.stderr.take().unwrap());
    let (sender, receiver) = mpsc::channel();
    for stream in [Box::new(out) as Box<dyn std::io::Read + Send>, Box::new(err)] {
        let sender = sender.clone();
        std::thread::spawn(move || {
            let mut text = String::new();
            let mut stream = stream;
            stream.read_to_string(&mut text).unwrap();
            // There is no receiver after a timeout.
            let _ = sender.send(text);
        });
    }
    let texts: Vec<String> = (0..2).map_while(|_| receiver.recv_timeout(TIMEOUT).ok()).collect();
    if texts.len() < 2 {
        child.kill().unwrap();
        panic!("{args:?} hangs");
    }
    CommandOutput { code: child.wait().unwrap().code().unwrap(), stdout: texts.concat(), stderr: String::new() }
}

/// Describes a missing report of the damaged file. The exit code is 1 for text with errors and for files that a
/// comparison shows as text, otherwise 2.
fn fault(file: &str, damage: &Damage, args: &[&str], run: &CommandOutput) -> Option<String> {
    let name = file.rsplit('/').next().unwrap();
    let is_finding = args[0] == "diff" || damage.is_text && PROJECT_FILES.contains(&file);
    let code = if is_finding { run.code != 0 } else { run.code == 2 };
    // A comparison names the changed program.
    let names_file = run.stdout.contains(name) || args[0] == "diff" && run.stdout.contains("start()");
    let names_damage =
        run.stdout.contains(damage.name) || damage.name == "merge conflict" && run.stdout.contains("<<<");
    (!(code && names_file && names_damage))
        .then(|| format!("{file}, {}, {args:?}: exit code {}\n{}", damage.name, run.code, run.stdout))
}

/// Checks that each command reports every damage in each file.
fn assert_law(files: &[&str], commands: &[&[&str]]) {
    let mut faults = Vec::new();
    for file in files {
        for damage in damages() {
            for args in commands {
                let folder = damaged(file, damage);
                let before = Folder::with(CELL);
                let before = before.path().to_str().unwrap();
                let args: Vec<&str> = args.iter().map(|arg| if *arg == "BEFORE" { before } else { arg }).collect();
                faults.extend(fault(file, damage, &args, &ends(&folder, &args)));
            }
        }
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn the_undamaged_cell_is_clean() {
    let folder = Folder::with(CELL);
    for args in [&["check"][..], &["run", "usrapp/main"], &["fmt", "--check"]] {
        let run = folder.val3(args);
        assert_eq!(run.code, 0, "{run:?}");
    }
}

#[test]
fn check_reports_every_file_that_it_cannot_read() {
    let commands: [&[&str]; 4] =
        [&["check"], &["check", "usrapp/main"], &["check", "--fix"], &["check", "--format", "json"]];
    assert_law(&PROJECT_FILES, &commands);
    assert_law(&CELL_FILES, &commands[..3]);
    assert_law(&[TABLE], &commands[..3]);
}

#[test]
fn runs_refuse_every_file_that_they_cannot_read() {
    let commands: [&[&str]; 2] = [&["run", "usrapp/main"], &["eval", "--app", "usrapp/main", "nCount"]];
    assert_law(&PROJECT_FILES, &commands);
    assert_law(&CELL_FILES, &commands);
    assert_law(&[TABLE], &commands);
}

#[test]
fn the_formatter_reports_programs_that_it_cannot_read() {
    assert_law(&PROJECT_FILES[2..], &[&["fmt", "--check"], &["fmt"], &["fmt", "--diff", "usrapp/main/start.pgx"]]);
}

#[test]
fn comparisons_report_every_file_that_they_cannot_read() {
    assert_law(&PROJECT_FILES, &[&["diff", "BEFORE", "."], &["diff", ".", "BEFORE"]]);
    assert_law(&CELL_FILES, &[&["diff", "BEFORE", "."]]);
}

#[test]
fn tests_report_every_file_that_they_cannot_read() {
    let mut faults = Vec::new();
    for file in PROJECT_FILES.iter().chain(&CELL_FILES).chain(&[TABLE]) {
        for damage in damages() {
            let folder = Folder::with(CELL);
            assert_eq!(folder.val3(&["test", "--init", "usrapp/main"]).code, 0);
            let path = folder.path().join(file);
            let bytes = fs::read(&path).unwrap();
            fs::remove_file(&path).unwrap();
            (damage.apply)(path.to_str().unwrap(), &bytes);
            let args = ["test", "usrapp"];
            faults.extend(fault(file, damage, &args, &ends(&folder, &args)));
        }
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// The device is the target of a link to the outside of the cell.
#[test]
fn a_link_to_a_device_is_not_read() {
    for file in PROJECT_FILES.iter().chain(&CELL_FILES).chain(&[TABLE]) {
        let damage = Damage { apply: |path, _| symlink("/dev/zero", path).unwrap(), name: "", is_text: false };
        for args in [&["check"][..], &["run", "usrapp/main"]] {
            let run = ends(&damaged(file, &damage), args);
            let name = file.rsplit('/').next().unwrap();
            assert!(run.code != 0 && run.stdout.contains(name), "{file}, {args:?}: {run:?}");
        }
    }
}

#[test]
fn debuggers_are_told_the_file() {
    for file in PROJECT_FILES.iter().chain(&CELL_FILES).chain(&[TABLE]) {
        let folder = damaged(file, &DAMAGES[1]);
        let mut session = Session::new();
        session.request("initialize", json!({ "adapterID": "val3" }));
        let mut reason = session.refused("launch", json!({ "program": folder.path().join("usrapp/main") }));
        if reason.contains("debug console") {
            reason = session.event("output")["output"].to_string();
        }
        assert!(
            reason.contains(file.rsplit('/').next().unwrap()) && reason.contains("it is empty"),
            "{file}: {reason}"
        );
    }
}

#[test]
fn editors_are_told_the_file() {
    for file in PROJECT_FILES.iter().chain(&CELL_FILES).chain(&[TABLE]) {
        let folder = damaged(file, &DAMAGES[1]);
        let name = file.rsplit('/').next().unwrap();
        let found = published(&folder, |text| text.contains(name) && text.contains("it is empty"));
        assert!(found, "{file}");
    }
}

/// Whether the server publishes an expected message within its first minutes in the folder.
fn published(folder: &Folder, is_expected: impl Fn(&str) -> bool) -> bool {
    let mut server = folder.command(&["lsp"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut input = server.stdin.take().unwrap();
    let uri = format!("file://{}", folder.path().to_str().unwrap());
    let params = json!({ "processId": null, "capabilities": {}, "rootUri": uri });
    send(&mut input, &json!({ "jsonrpc": "2.0", "id": 0, "method": "initialize", "params": params }));
    send(&mut input, &json!({ "jsonrpc": "2.0", "method": "initialized", "params": {} }));
    let mut output = BufReader::new(server.stdout.take().unwrap());
    let (sender, receiver) = mpsc::channel();
    std::thread::spawn(move || {
        let mut head = String::new();
        while output.read_line(&mut head).is_ok_and(|count| count > 0) {
            let Some(length) = head.strip_prefix("Content-Length: ").and_then(|text| text.trim().parse().ok()) else {
                head.clear();
                continue;
            };
            head.clear();
            output.read_line(&mut head).unwrap();
            let mut body = vec![0; length];
            if output.read_exact(&mut body).is_err() || sender.send(String::from_utf8(body).unwrap()).is_err() {
                return;
            }
            head.clear();
        }
    });
    let mut found = false;
    while !found {
        let Ok(message) = receiver.recv_timeout(TIMEOUT) else { break };
        found = is_expected(&message);
    }
    server.kill().unwrap();
    server.wait().unwrap();
    found
}

fn send(input: &mut ChildStdin, message: &Value) {
    let message = message.to_string();
    write!(input, "Content-Length: {}\r\n\r\n{message}", message.len()).unwrap();
    input.flush().unwrap();
}
