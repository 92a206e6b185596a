//! Runs the command in a folder with an application.

use std::fs;
use std::io::Write as _;
use std::net::TcpListener;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicU16, Ordering};

use tempfile::TempDir;
use val3_test::{EMPTY_STOP, Fixture};

/// A program without faults.
pub(crate) const CLEAN: &str = "num nCount\nnCount=nCount+1\n";
/// A program with an unknown name in line 2 of its code.
pub(crate) const FAULTY: &str = "num nCount\nnCuont=1\n";
/// A program whose only fault is the unusual spelling of a keyword.
pub(crate) const UNUSUAL: &str = "num nCount\nIF nCount==1\nnCount=2\nendIf\n";

/// Returns a port without a listener, below the ports that the system gives to outgoing connections, so that no other
/// test gets it before the server under test listens.
pub(crate) fn free_port() -> u16 {
    const FIRST: u16 = 12_000;
    const COUNT: u16 = 18_000;
    static NEXT: AtomicU16 = AtomicU16::new(0);
    // Test programs that run at the same time begin at different ports.
    let begin = std::process::id() * 100;
    (0..COUNT)
        .map(|_| u32::from(NEXT.fetch_add(1, Ordering::Relaxed)) + begin)
        .filter_map(|number| u16::try_from(number % u32::from(COUNT)).ok())
        .map(|number| FIRST + number)
        .find(|port| TcpListener::bind(("127.0.0.1", *port)).is_ok())
        .unwrap()
}

/// A temporary folder with the files of a listing, deleted on drop.
pub(crate) struct Folder(TempDir);

/// Output and exit code of a command.
#[derive(Debug)]
pub(crate) struct CommandOutput {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Folder {
    /// An empty folder.
    pub(crate) fn empty() -> Self {
        Self(TempDir::new().unwrap())
    }

    /// A folder with the files of a listing.
    pub(crate) fn with(listing: &str) -> Self {
        let folder = Self::empty();
        for (path, text) in Fixture::parse(listing).files {
            folder.write(&path, &text);
        }
        folder
    }

    /// Writes a file and the folders above it.
    pub(crate) fn write(&self, path: &str, text: &str) {
        let path = self.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// Reads a file.
    pub(crate) fn read(&self, path: &str) -> String {
        fs::read_to_string(self.path().join(path)).unwrap()
    }

    /// Links a variable in `usrapp/main/main.dtx`, which has no values yet.
    pub(crate) fn link(&self, name: &str, link: &str) {
        let path = "usrapp/main/main.dtx";
        let data = self.read(path);
        let (before, after) = data.split_once(&format!("name=\"{name}\"")).unwrap();
        let (head, rest) = after.split_once("/>").unwrap();
        let value = format!("<Value key=\"0\" link=\"{link}\" /></Data>");
        self.write(path, &format!("{before}name=\"{name}\"{head}>{value}{rest}"));
    }

    /// Runs `val3` in the folder.
    pub(crate) fn val3(&self, args: &[&str]) -> CommandOutput {
        run(self.command(args))
    }

    /// Prepares a `val3` command in the folder, without colours from the environment.
    ///
    /// Applications that are run or checked get the program `stop`, which a listing may omit.
    pub(crate) fn command(&self, args: &[&str]) -> Command {
        if args.iter().take(2).any(|arg| ["run", "dap", "check", "mcp"].contains(arg)) {
            add_stops(self.path());
        }
        self.exact_command(args)
    }

    /// As [`command`](Self::command), without changes to the files.
    pub(crate) fn exact_command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_val3"));
        command.args(args).current_dir(self.path());
        ["NO_COLOR", "FORCE_COLOR", "CLICOLOR_FORCE"].iter().for_each(|name| _ = command.env_remove(name));
        // The test has its own list of trusted folders.
        command.env("XDG_CONFIG_HOME", self.path().join(".config")).env_remove("VAL3_TRUST").env_remove("CI");
        command
    }

    /// Path of the folder.
    pub(crate) fn path(&self) -> &Path {
        self.0.path()
    }
}

/// Adds an empty program `stop` to each application in a folder that has only `start`.
pub(crate) fn add_stops(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for path in entries.map(|entry| entry.unwrap().path()) {
        if path.is_dir() && !path.is_symlink() {
            add_stops(&path);
        } else if path.extension().is_some_and(|extension| extension == "pjx")
            && path.is_file()
            && let Ok(text) = fs::read_to_string(&path)
            && text.contains("\"start.pgx\"")
            && !text.contains("stop.pgx")
        {
            let listed = "<Program file=\"start.pgx\" />";
            let both = format!("{listed}<Program file=\"stop.pgx\" />");
            fs::write(&path, text.replacen(listed, &both, 1)).unwrap();
            fs::write(path.with_file_name("stop.pgx"), EMPTY_STOP).unwrap();
        }
    }
}

/// Copies a folder with its content.
pub(crate) fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().map(Result::unwrap) {
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy_folder(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// Runs a command to its end.
pub(crate) fn run(mut command: Command) -> CommandOutput {
    let output = command.stdin(Stdio::null()).output().unwrap();
    CommandOutput {
        code: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: without_wall_time(&String::from_utf8(output.stderr).unwrap()),
    }
}

/// Removes the duration, which differs from run to run, from the notes of a run.
fn without_wall_time(notes: &str) -> String {
    notes.split_inclusive('\n').filter(|line| !line.starts_with("finished in ")).collect()
}

/// Runs `val3` in a folder with this standard input; each byte of the output becomes one character.
pub(crate) fn piped(folder: &Folder, args: &[&str], input: &[u8]) -> CommandOutput {
    let mut command = folder.command(args);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(input).unwrap();
    let output = child.wait_with_output().unwrap();
    CommandOutput {
        code: output.status.code().unwrap(),
        stdout: output.stdout.iter().map(|byte| char::from(*byte)).collect(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}
