//! Executes one document's commands in order.

use std::os::unix::process::CommandExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;
use std::{fs, io};

use crate::support::{Folder, copy_folder};

use super::block::{self, Block, commands, recipe};

/// Timeout of a command.
const LONGEST: Duration = Duration::from_secs(60);

/// Setup of every session: a git repository with two commits, and `val3` and `cargo run` as commands.
const BEGIN: &str = r#"
git init -q -b main .
git config --global user.name Reader; git config --global user.email reader@example.com
git add . && git commit -qm "The examples" && git commit -qm "No change" --allow-empty
"#;

/// Shell functions for every command: they replace commands that build `val3` by the binary of this build.
const FUNCTIONS: &str = r#"
cargo() { [ "$1 $2 $3" = "run --release --" ] && shift 3 && val3 "$@"; }
"#;

/// A shell's folders, and the last block's output.
pub(super) struct Session {
    folder: Folder,
    place: PathBuf,
    output: String,
}

impl Session {
    /// Starts a session in a folder within a copy of the examples in `root`.
    pub(super) fn start(root: &Path, start: &str) -> Self {
        let folder = Folder::empty();
        let copy = folder.path().join("val3");
        copy_folder(&root.join("examples"), &copy.join("examples"));
        let mut session = Self { place: copy, folder, output: String::new() };
        assert_eq!(session.shell(BEGIN), Some(0), "{}", session.output);
        session.place = session.place.join(start);
        session
    }

    /// Executes a block. Returns the wrong lines with their numbers.
    pub(super) fn execute(&mut self, block: &Block<'_>) -> Vec<String> {
        match block.info {
            "sh" => self.execute_all(commands(block)),
            // Recipes for services, whose steps are shell lines.
            "yaml" | "groovy" => self.execute_all(recipe(block)),
            "text output" => self.compare(block),
            _ if hides_commands(block) => {
                vec![format!("{}: commands belong to a block `sh`, without a prompt", block.line)]
            }
            _ => match block.attribute("file") {
                Some(file) => {
                    let written = self.write(file, block);
                    written
                        .err()
                        .map(|error| format!("{}: cannot write {file}: {error}", block.line))
                        .into_iter()
                        .collect()
                }
                None => Vec::new(),
            },
        }
    }

    fn execute_all(&mut self, commands: Vec<block::Command>) -> Vec<String> {
        let mut faults = Vec::new();
        let mut output = String::new();
        for command in commands {
            let code = self.shell(&command.text);
            output.push_str(&self.output);
            if code != Some(command.code) {
                let code = code.map_or("does not end".to_owned(), |code| format!("exits with {code}"));
                faults.push(format!("{}: {} {code}\n{}", command.line, command.text, self.output));
            }
        }
        self.output = output;
        faults
    }

    /// Executes a line, and stores its output and its final working folder. `None` if it does not terminate.
    fn shell(&mut self, line: &str) -> Option<i32> {
        let [output, place] = ["output", "place"].map(|name| self.folder.path().join(name));
        fs::write(&place, self.place.to_str().unwrap()).unwrap();
        let file = fs::File::create(&output).unwrap();
        let mut shell = Command::new("bash");
        let script = format!("{FUNCTIONS}\n{line}\ncode=$?\npwd >'{}'\nexit $code", place.display());
        shell.arg("-c").arg(script).current_dir(&self.place).stdin(Stdio::null());
        shell.stdout(file.try_clone().unwrap()).stderr(file);
        let commands = Path::new(env!("CARGO_BIN_EXE_val3")).parent().unwrap();
        shell.env("PATH", format!("{}:{}", commands.display(), std::env::var_os("PATH").unwrap().display()));
        shell.env("HOME", self.folder.path()).env("XDG_CONFIG_HOME", self.folder.path().join(".config"));
        shell.env_remove("NO_COLOR").env_remove("VAL3_TRUST").env_remove("CI");
        let mut shell = shell.process_group(0).spawn().unwrap();
        let mut left = LONGEST;
        let code = loop {
            match shell.try_wait().unwrap() {
                Some(status) => break status.code(),
                None if left.is_zero() => {
                    // Kills the process group, which includes the commands that the shell has started.
                    let group = format!("-{}", shell.id());
                    assert!(Command::new("kill").args(["-KILL", "--", &group]).status().unwrap().success());
                    shell.wait().unwrap();
                    break None;
                }
                None => {
                    let pause = Duration::from_millis(10);
                    std::thread::sleep(pause);
                    left = left.saturating_sub(pause);
                }
            }
        };
        self.output = String::from_utf8_lossy(&fs::read(output).unwrap()).into_owned();
        self.place = PathBuf::from(fs::read_to_string(place).unwrap().trim_end());
        code
    }

    /// Compares the output of the preceding commands with the document.
    fn compare(&self, block: &Block<'_>) -> Vec<String> {
        let printed: Vec<&str> = self.output.lines().map(str::trim_end).collect();
        if is_shown(&block.lines, &printed) {
            return Vec::new();
        }
        vec![format!("{}: the output is\n{}", block.line, self.output)]
    }

    /// Writes a file, or the code of a program.
    fn write(&self, file: &str, block: &Block<'_>) -> io::Result<()> {
        let path = self.place.join(file);
        let text = match file.ends_with(".pgx") {
            true => with_code(&fs::read_to_string(&path)?, &block.text()),
            false => block.text(),
        };
        fs::write(path, text)
    }
}

/// Whether the block shows commands that are not executed.
fn hides_commands(block: &Block<'_>) -> bool {
    let is_shell = ["console", "shell", "bash", "powershell"].contains(&block.info);
    let has_reason = block.lines.iter().any(|line| line.contains("not executed: "));
    is_shell && !has_reason || block.lines.iter().any(|line| line.starts_with("$ "))
}

/// Replaces the code of a program.
fn with_code(program: &str, code: &str) -> String {
    let (before, rest) = program.split_once("<![CDATA[").unwrap();
    let (_, after) = rest.split_once("]]>").unwrap();
    format!("{before}<![CDATA[{}]]>{after}", code.trim_end())
}

/// Whether the lines match an output. The line `…` matches any number of lines.
fn is_shown(shown: &[&str], printed: &[&str]) -> bool {
    match (shown, printed) {
        ([], printed) => printed.is_empty(),
        ([line, rest @ ..], printed) if line.trim() == "…" => {
            (0..=printed.len()).any(|skipped| is_shown(rest, &printed[skipped..]))
        }
        ([line, rest @ ..], [first, others @ ..]) => is_line(line.trim_end(), first) && is_shown(rest, others),
        ([_, ..], []) => false,
    }
}

/// Whether a line matches an output line. `…` matches any text.
fn is_line(shown: &str, printed: &str) -> bool {
    match shown.split_once('…') {
        None => shown == printed,
        Some((begin, rest)) => {
            let Some(left) = printed.strip_prefix(begin) else { return false };
            left.char_indices().map(|(at, _)| at).chain([left.len()]).any(|at| is_line(rest, &left[at..]))
        }
    }
}

#[test]
fn gaps_stand_for_any_text_and_lines() {
    assert!(is_shown(&["a", "…", "took … s"], &["a", "b", "c", "took 3 s"]));
    assert!(!is_shown(&["a", "…", "took … s"], &["a", "took 3 ms"]));
    assert!(!is_shown(&["a"], &["a", "b"]));
}
