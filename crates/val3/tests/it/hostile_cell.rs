//! An untrusted cell that attacks the user: files outside of it, sockets, devices, terminal sequences.
//!
//! Canary files are next to the cell, and a listener waits on a port that the cell names. No command reads or changes
//! the canaries, connects to the listener, writes control characters, hangs, or uses much memory.

#![cfg(target_os = "linux")]

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead as _, BufReader, ErrorKind, Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use rustix::fs::{Mode, mkfifoat};

use crate::support::Folder;

/// Timeout above the duration of any command on a busy machine. A slower command hangs.
const TIMEOUT: Duration = Duration::from_secs(120);

/// Maximum address space of a command, in KiB.
const MEMORY: u64 = 4 << 20;

/// Text that no output and no file may contain.
const SECRET: &str = "TOP-SECRET-4711";

/// A cell, and the files next to it.
struct HostileCell {
    folder: Folder,
    listener: TcpListener,
}

/// Result of a command.
struct Ending {
    command: String,
    code: Option<i32>,
    output: String,
}

/// Attacks in a cell. They are divided among several cells, because a command stops at the first rejected attack.
#[derive(Clone, Copy, Debug)]
struct Attacks {
    /// Text of `val3.toml`, which names external files and machines.
    settings: &'static str,
    /// Whether devices, pipes and links have the names of files.
    traps: bool,
    /// Whether names and code contain control characters.
    escapes: bool,
}

impl HostileCell {
    fn new(attacks: Attacks) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        listener.set_nonblocking(true).unwrap();
        let folder = Folder::empty();
        let cell = Self { folder, listener };
        cell.write_canaries();
        cell.write_application(attacks);
        if attacks.traps {
            cell.write_traps();
        }
        if !attacks.settings.is_empty() {
            let settings = attacks.settings.replace("PORT", &cell.port()).replace("OUTSIDE", &cell.outside());
            cell.folder.write("cell/val3.toml", &settings);
        }
        cell
    }

    fn port(&self) -> String {
        self.listener.local_addr().unwrap().port().to_string()
    }

    fn outside(&self) -> String {
        self.folder.path().join("outside").to_str().unwrap().to_owned()
    }

    /// Writes files next to the cell. Each contains the secret.
    fn write_canaries(&self) {
        let program = format!(
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n  \
             <Program name=\"start\">\n    <Code><![CDATA[begin\n  IF true\n  // {SECRET}\n  endIf\n  nothing=1\nend]]></Code>\n  \
             </Program>\n</Programs>\n"
        );
        self.folder.write("outside/prod/start.pgx", &program);
        self.folder.write("outside/secret.txt", SECRET);
        self.folder.write("outside/.bashrc", &format!("# {SECRET}\n"));
        self.folder.write("outside/base.json", &format!("{{\"secret\": \"{SECRET}\"}}\n"));
        self.folder.write("outside/lib/lib.pjx", &format!("<!-- {SECRET} -->"));
    }

    fn write_application(&self, attacks: Attacks) {
        let outside = self.outside();
        let escapes = if attacks.escapes { "\u{1b}]0;title\u{7}\u{9b}31m" } else { "" };
        let code = format!(
            "program start()\nbegin\n  sEscape=chr(27)+\"]0;title\"+chr(7)+chr(155)+\"31m\"\n\
             nFile=$fileOpen(\"X:/{outside}/secret.txt\",\"r\")\n$fileGet(nFile,sText,1)\n? sText[0]\n\
             nFile=$fileOpen(\"X:/{outside}/secret.txt\",\"w\")\n$fileSet(nFile,sText,1)\n\
             nFile=$fileOpen(\"Disk://../../outside/secret.txt\",\"r\")\n$fileGet(nFile,sText,1)\n? sText[0]\n\
             nFile=$fileOpen(\"Disk://self/../../../link/secret.txt\",\"w\")\n$fileSet(nFile,sText,1)\n\
             nFile=$fileOpen(\"Disk://usrapp/link/secret.txt\",\"w\")\n$fileSet(nFile,sText,1)\n\
             nFile=$fileOpen(\"Disk://val3.toml\",\"w\")\n$fileSet(nFile,sText,1)\n\
             nFile=$fileOpen(\"Disk://.git/config\",\"w\")\n$fileSet(nFile,sText,1)\n\
             nFile=$fileOpen(\"Disk://usrapp/.git/config\",\"w\")\n$fileSet(nFile,sText,1)\n\
             taskCreate \"talk\",10,talk()\n\
             ? sEscape+\"{escapes}\"\n? \"::error file=a::INJECTED\"\nlogMsg(sEscape)\npopUpMsg(sEscape)\ntitle(sEscape)\nput(sEscape)\n\
             delay(0.5)\n? \"{AT_END}\"\nend\n\
             program stop()\nbegin\nend\nprogram talk()\nbegin\n  siHost=sText[0]\n  siHost=\"GET / HTTP/1.0\"\nend\n"
        );
        let newline = if attacks.escapes { "\n" } else { "" };
        let data = "\n=== main/main.dtx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
            <Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n    \
            <Data name=\"nFile\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n    \
            <Data name=\"sText\" access=\"private\" xsi:type=\"array\" type=\"string\" size=\"1\" />\n    \
            <Data name=\"sEscape\" access=\"private\" xsi:type=\"array\" type=\"string\" size=\"1\" />\n    \
            <Data name=\"siHost\" access=\"private\" xsi:type=\"array\" type=\"sio\" size=\"1\"><Value key=\"0\" link=\"Socket\\host\" /></Data>\n    \
            <Data name=\"nHuge\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"65535,65535\" />\n  </Datas>\n</Database>";
        for (path, text) in val3_test::Fixture::parse(&format!("{code}{data}")).files {
            // Only one of the applications has data that exceed the memory limit.
            self.folder.write(
                &format!("cell/usr/{path}").replace("/main/main.", "/huge/huge.").replace("/main/", "/huge/"),
                &text,
            );
            let text = text.replace("65535,65535", "2");
            self.folder.write(&format!("cell/usr/{path}"), &text);
            self.folder.write(&format!("cell/n{newline}::error file=a::INJECTED{escapes}/{path}"), &text);
        }
        self.write_escape(&outside);
        self.folder.write("cell/usr/usrapp/main/tests/evil.toml", EVIL_TEST);
        let line = SIO.replace("PORT", &self.port());
        self.folder.write("cell/usr/configs/sio.cfx", &line);
    }

    /// Writes an application whose project names files outside of its folder.
    fn write_escape(&self, outside: &str) {
        let project = self.folder.read("cell/usr/usrapp/main/main.pjx");
        let foreign = format!(
            "<Program file=\"{outside}/prod/start.pgx\" />\n    <Program file=\"../../../../outside/secret.txt\" />\n    \
             <Program file=\"link/prod/start.pgx\" />\n    <Program file=\"zero.pgx\" />\n    <Program file=\"pipe.pgx\" />\n  </Programs>"
        );
        let project = project.replace("</Programs>", &foreign);
        assert!(project.contains("zero.pgx"), "{project}");
        self.folder.write("cell/usr/usrapp/escape/escape.pjx", &project);
        for file in ["start.pgx", "main.dtx"] {
            let text = self.folder.read(&format!("cell/usr/usrapp/main/{file}"));
            self.folder.write(&format!("cell/usr/usrapp/escape/{file}"), &text);
        }
    }

    /// Creates devices, pipes and links under the names of files.
    fn write_traps(&self) {
        let cell = self.folder.path().join("cell");
        symlink(self.outside(), cell.join("usr/usrapp/link")).unwrap();
        for folder in ["usr/usrapp/main", "usr/usrapp/escape", "usr/configs"] {
            let folder = cell.join(folder);
            symlink(self.outside(), folder.join("link")).unwrap();
            symlink("/dev/zero", folder.join("zero.pgx")).unwrap();
            pipe(&folder.join("pipe.pgx"));
        }
        symlink("/dev/zero", cell.join("usr/configs/cell.cfx")).unwrap();
        pipe(&cell.join("usr/configs/bio.cfx"));
        pipe(&cell.join("usr/usrapp/main/.editorconfig"));
        symlink(self.folder.path().join("outside/secret.txt"), cell.join("base.stl")).unwrap();
        symlink("/dev/zero", cell.join("add-on.xml")).unwrap();
    }

    /// Starts `val3` in the cell with a limited address space.
    fn start(&self, args: &[&str]) -> Child {
        Command::new("sh")
            .args(["-c", &format!("ulimit -v {MEMORY}; exec \"$0\" \"$@\""), env!("CARGO_BIN_EXE_val3")])
            .args(args)
            .current_dir(self.folder.path().join("cell"))
            .env("CI", "true")
            .env("GITHUB_ACTIONS", "true")
            .env("XDG_CONFIG_HOME", self.folder.path().join("config"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    }

    fn val3(&self, args: &[&str], input: &str) -> Ending {
        let mut child = self.start(args);
        // A command that has ended does not read its input.
        drop(child.stdin.take().unwrap().write_all(input.as_bytes()));
        let readers = [reader(child.stdout.take().unwrap()), reader(child.stderr.take().unwrap())];
        let started = Instant::now();
        let code = loop {
            if let Some(status) = child.try_wait().unwrap() {
                break status.code();
            }
            if started.elapsed() > TIMEOUT {
                child.kill().unwrap();
                panic!("`val3 {}` hangs", args.join(" "));
            }
            std::thread::sleep(Duration::from_millis(5));
        };
        let output = readers.map(|reader| String::from_utf8_lossy(&reader.join().unwrap()).into_owned()).concat();
        Ending { command: args.join(" "), code, output }
    }

    /// Serves the run, and requests its page if it is served.
    fn serve(&self) {
        let mut child = self.start(&["run", "usr/usrapp/main", "--serve", "127.0.0.1:0"]);
        let mut stderr = BufReader::new(child.stderr.take().unwrap()).lines();
        let note = stderr.find_map(|line| Some(line.unwrap().split_once("http://127.0.0.1:")?.1.to_owned()));
        if let Some((address, path)) = note.as_deref().and_then(|note| note.split_once('/')) {
            let address = format!("127.0.0.1:{address}");
            let mut stream = TcpStream::connect(&address).unwrap();
            write!(stream, "GET /{path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n").unwrap();
            let mut page = Vec::new();
            stream.read_to_end(&mut page).unwrap();
            assert!(page.starts_with(b"HTTP/1.1 ") && !contains(&page, SECRET), "the page shows the secret");
        }
        child.kill().unwrap();
        child.wait().unwrap();
        self.assert_no_connection("run --serve");
    }

    /// Checks that no command has connected to the listener.
    fn assert_no_connection(&self, command: &str) {
        let accepted = self.listener.accept();
        assert!(accepted.as_ref().is_err_and(|error| error.kind() == ErrorKind::WouldBlock), "{command}: {accepted:?}");
    }
}

fn reader(mut stream: impl std::io::Read + Send + 'static) -> std::thread::JoinHandle<Vec<u8>> {
    std::thread::spawn(move || {
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).unwrap();
        bytes
    })
}

fn pipe(path: &Path) {
    mkfifoat(rustix::fs::CWD, path, Mode::from_raw_mode(0o600)).unwrap();
}

/// Content of the regular files in a folder, by path. Links are not followed.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let kind = entry.file_type().unwrap();
        if kind.is_dir() {
            found.extend(files(&entry.path()));
        } else if kind.is_file() {
            found.insert(entry.path().to_string_lossy().into_owned(), fs::read(entry.path()).unwrap());
        }
    }
    found
}

/// A message of the language server protocol and the debug adapter protocol.
fn message(text: &str) -> String {
    format!("Content-Length: {}\r\n\r\n{text}", text.len())
}

impl Ending {
    fn assert_harmless(&self) {
        let Self { command, code, output } = self;
        // A signal or a panic is no valid result.
        assert!(code.is_some_and(|code| (0..=3).contains(&code)), "`{command}` ends with {code:?}: {output}");
        assert!(!output.contains(SECRET), "`{command}` shows the secret: {output}");
        // Pipes receive the exact output of a program. The tests in `strangers` check the output at a terminal.
        let raw = output.find(is_raw).filter(|_| !command.starts_with("run"));
        let raw = raw.map(|at| output[at..].chars().take(20).collect::<String>());
        assert_eq!(raw, None, "`{command}` writes control characters: {output:?}");
        let injected = output.lines().find(|line| line.starts_with("::error file=a"));
        assert_eq!(injected, None, "`{command}`");
    }
}

/// Whether the character controls a terminal.
fn is_raw(character: char) -> bool {
    character.is_control() && !matches!(character, '\n' | '\t' | '\r')
}

/// Text printed at the end of the cell's program.
const AT_END: &str = "everything tried";

/// A test whose recorded motion is a file outside of the cell.
const EVIL_TEST: &str = "application = \"..\"\nuntil = 2\n[expect]\ntrace = \"../../../../../outside/.bashrc\"\n";

/// A socket of the cell that connects to the listener.
const SIO: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<sio>
  <socketClt>
    <String name="name" value="host" />
    <Num name="portNumber" value="PORT" />
    <String name="serverIp" value="127.0.0.1" />
  </socketClt>
</sio>
"#;

/// Settings of the cell.
const SETTINGS: &str = r#"
roots = { X = "/" }
disk = "/"
add-ons = ["add-on.xml", "/dev/zero", "OUTSIDE/secret.txt"]
baseline = "OUTSIDE/base.json"
[run]
network = true
lines = { 'Socket\host' = "client:127.0.0.1:PORT" }
shapes = { base = "base.stl" }
"#;

/// Settings that only affect runs.
const SETTINGS_OF_RUNS: &str = r#"
roots = { X = "/" }
[run]
network = true
lines = { 'Socket\host' = "client:127.0.0.1:PORT" }
"#;

/// Arguments that run the cell's application.
const RUN: [&str; 4] = ["run", "usr/usrapp/main", "--until", "2"];

/// Commands, each with its standard input.
fn commands(root: &Path) -> Vec<(Vec<&'static str>, String)> {
    let run = |path: &'static str, more: &[&'static str]| [&["run", path, "--until", "2"], more].concat();
    let mut commands: Vec<(Vec<&str>, String)> = [
        vec!["check", "."],
        vec!["check", ".", "--format", "github"],
        vec!["check", ".", "--format", "concise"],
        vec!["check", ".", "--format", "json"],
        vec!["check", ".", "--format", "junit"],
        vec!["check", ".", "--format", "sarif"],
        vec!["check", "--diff", "."],
        vec!["check", "--motion", "."],
        vec!["check", "--fix", "."],
        vec!["check", "--add-suppressions", "."],
        vec!["fmt", "."],
        vec!["fmt", "--check", "."],
        RUN.to_vec(),
        run("usr/usrapp/main", &["--screen"]),
        run("usr/usrapp/main", &["--export", "page.html"]),
        run("usr/usrapp/main", &["--events", "events.jsonl"]),
        run("usr/usrapp/huge", &[]),
        run("usr/usrapp/escape", &[]),
        vec!["run", "usr/usrapp/main", "--scene"],
        vec!["eval", "--app", "usr/usrapp/main", "$fileOpen(\"X://etc/passwd\",\"r\")"],
        vec!["test", "."],
        vec!["test", "--update", "."],
        vec!["diff", "usr", "n\n::error file=a::INJECTED\u{1b}]0;title\u{7}\u{9b}31m"],
    ]
    .into_iter()
    .map(|args| (args, String::new()))
    .collect();
    let initialize = r#"{"jsonrpc":"2.0","id":0,"method":"initialize","params":{"processId":null,"rootUri":"ROOT","capabilities":{}}}"#;
    let session = [
        &initialize.replace("ROOT", &format!("file://{}", root.display())),
        r#"{"jsonrpc":"2.0","method":"initialized","params":{}}"#,
        r#"{"jsonrpc":"2.0","id":1,"method":"workspace/symbol","params":{"query":"start"}}"#,
        r#"{"jsonrpc":"2.0","id":2,"method":"shutdown"}"#,
        r#"{"jsonrpc":"2.0","method":"exit"}"#,
    ];
    commands.push((vec!["lsp"], session.map(message).concat()));
    let program = root.join("usr/usrapp/main");
    let debugger = [
        r#"{"seq":1,"type":"request","command":"initialize","arguments":{"adapterID":"val3"}}"#,
        &format!(
            r#"{{"seq":2,"type":"request","command":"launch","arguments":{{"program":"{}","until":2}}}}"#,
            program.display()
        ),
        r#"{"seq":3,"type":"request","command":"configurationDone","arguments":{}}"#,
    ];
    commands.push((vec!["dap"], debugger.map(message).concat()));
    commands
}

/// Executes every command. Returns the output of the application's run.
fn try_everything(attacks: Attacks) -> String {
    let cell = HostileCell::new(attacks);
    let root = cell.folder.path().join("cell");
    let outside = cell.folder.path().join("outside");
    let canaries = files(&outside);
    let own = fs::read(root.join("val3.toml")).ok();
    let mut run = String::new();
    for (args, input) in commands(&root) {
        let ending = cell.val3(&args, &input);
        ending.assert_harmless();
        if args == RUN {
            run.push_str(&ending.output);
        }
        cell.assert_no_connection(&ending.command);
        assert!(files(&outside) == canaries, "`{}` changes files beside the cell", ending.command);
        assert_eq!(fs::read(root.join("val3.toml")).ok(), own, "`{}`", ending.command);
    }
    cell.serve();
    let leaked = files(&root);
    let leaked: Vec<_> = leaked.iter().filter(|(_, text)| contains(text, SECRET)).map(|(path, _)| path).collect();
    assert_eq!(leaked, [""; 0], "files with the secret");
    assert!(!root.join("usr/.git").exists() && !root.join("usr/usrapp/.git").exists());
    run
}

/// Whether the bytes contain the text, in plain form or in base64.
fn contains(bytes: &[u8], text: &str) -> bool {
    use base64::Engine as _;
    let encoded = base64::engine::general_purpose::STANDARD_NO_PAD.encode(text);
    let middle = &encoded[..encoded.len() - 2];
    let has = |needle: &[u8]| bytes.windows(needle.len()).any(|window| window == needle);
    has(text.as_bytes()) || has(middle.as_bytes())
}

#[test]
fn a_hostile_program_reaches_nothing_outside() {
    let run = try_everything(Attacks { settings: "", traps: false, escapes: false });
    assert!(run.contains(AT_END), "the program does not end: {run}");
}

#[test]
fn hostile_settings_reach_nothing_outside() {
    for settings in [SETTINGS, SETTINGS_OF_RUNS] {
        try_everything(Attacks { settings, traps: false, escapes: false });
    }
}

#[test]
fn devices_and_links_reach_nothing_outside() {
    try_everything(Attacks { settings: "", traps: true, escapes: false });
}

#[test]
fn hostile_names_and_texts_reach_no_terminal() {
    try_everything(Attacks { settings: "", traps: false, escapes: true });
}

#[test]
fn everything_at_once_reaches_nothing_outside() {
    try_everything(Attacks { settings: SETTINGS, traps: true, escapes: true });
}
