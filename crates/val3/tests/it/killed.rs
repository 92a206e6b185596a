//! Writing commands are killed at random moments. Each file then has its old or its new content; temporary files are
//! recognisable by their names, and the next run of the command removes them.
//!
//! `PROPTEST_CASES=500 cargo test -p val3 --test it -- killed` is the long form.

#![cfg(unix)]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use proptest::prelude::*;
use proptest::sample::Index;

use crate::support::Folder;

/// Number of programs in the application, enough for a kill between two of them.
const PROGRAMS: usize = 12;

/// Commands that write files, each with the output files that grow while it runs.
const WRITERS: [(&[&str], &[&str]); 9] = [
    (&["check", "--fix", "usrapp"], &[]),
    (&["check", "--add-suppressions", "usrapp"], &[]),
    (&["check", "--baseline", "base.json", "--write-baseline"], &[]),
    (&["check", "--baseline", "known.json", "--prune-baseline"], &[]),
    (&["check", "--output", "sarif=old.sarif", "--output", "junit=new.xml"], &[]),
    (&["fmt", "usrapp"], &[]),
    (&["test", "--update", "--power", "--start=0,0,90,0,90,0", "tests"], &[]),
    (&["run", "usrapp/save"], &[]),
    (
        &[
            "run",
            "usrapp/move",
            "--power",
            "--plot=old.svg",
            "--export=new.html",
            "--trace=new.csv",
            "--events=new.jsonl",
        ],
        &["new.csv", "new.jsonl"],
    ),
];

type Files = BTreeMap<String, Vec<u8>>;

/// A command, the files before and after it, and its duration.
struct Writer {
    args: &'static [&'static str],
    growing: &'static [&'static str],
    before: Files,
    after: Files,
    duration: Duration,
}

static REFERENCES: LazyLock<Vec<Writer>> =
    LazyLock::new(|| WRITERS.map(|(args, growing)| reference(args, growing)).into());

fn reference(args: &'static [&'static str], growing: &'static [&'static str]) -> Writer {
    let folder = application();
    let before = files(folder.path());
    let started = Instant::now();
    let output = folder.val3(args);
    let duration = started.elapsed();
    let after = files(folder.path());
    assert!(before != after, "{args:?} writes nothing: {output:?}");
    Writer { args, growing, before, after, duration }
}

fn application() -> Folder {
    let programs: String = (0..PROGRAMS)
        .map(|number| {
            format!("program work{number}()\nbegin\n  IF nCount==1\n   nCount=2\n  endIf\n  nUnknown=1\nend\n")
        })
        .collect();
    let folder = Folder::with(&format!(
        "--- main\nnum nCount\nprogram start()\nbegin\n  nCount=1\nend\n{programs}\
         --- save\nlibrary part \"part\"\nprogram start()\nbegin\n  part:nSaved=7\n  ? part:libSave()\nend\n\
         --- part\npublic num nSaved\n\
         --- move\nmdesc mFast\nprogram start()\nbegin\n  movej({{10,0,90,0,90,0}},flange,mFast)\n  waitEndMove()\nend\n"
    ));
    folder.write(
        "tests/move.toml",
        "application = \"../usrapp/move\"\nuntil = 5\n[expect]\ntrace = \"golden/move.csv\"\n",
    );
    folder.write("old.sarif", "{}");
    folder.write("old.svg", "<svg/>");
    assert!(folder.val3(&["check", "--baseline", "known.json", "--write-baseline"]).code <= 1);
    folder.write("usrapp/main/work0.pgx", &folder.read("usrapp/main/work0.pgx").replace("nUnknown=1", "nCount=1"));
    folder
}

/// Files in a folder by relative path. The folder's path in a text is replaced by a fixed path. All complete pages are
/// considered equal, because their compressed data contain the folder's path.
fn files(folder: &Path) -> Files {
    let root = folder.to_str().unwrap();
    let mut found = Files::new();
    collect(folder, "", &mut found);
    for (path, text) in &mut found {
        *text = match path.strip_suffix(".html") {
            Some(_) if text.trim_ascii_end().ends_with(b"</html>") => b"a page".to_vec(),
            _ => String::from_utf8_lossy(text).replace(root, "/folder").into_bytes(),
        };
    }
    found
}

fn collect(folder: &Path, prefix: &str, found: &mut Files) {
    for entry in fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let path = format!("{prefix}{}", entry.file_name().to_str().unwrap());
        if entry.file_type().unwrap().is_dir() {
            collect(&entry.path(), &format!("{path}/"), found);
        } else {
            found.insert(path, fs::read(entry.path()).unwrap());
        }
    }
}

/// Whether the path is a temporary copy of a written file, or a folder in which `libSave` prepares a library.
fn is_temporary(path: &str) -> bool {
    let name = path.rsplit('/').next().unwrap();
    let is_of_library = path.split('/').any(|folder| folder == ".saving" || folder == ".saved");
    is_of_library || name.starts_with('.') && name.ends_with(".val3-tmp")
}

impl Writer {
    /// Whether a file after a kill has its content before or after the command.
    fn is_whole(&self, path: &str, text: Option<&Vec<u8>>) -> bool {
        let (before, after) = (self.before.get(path), self.after.get(path));
        let is_prefix = || text.zip(after).is_some_and(|(text, after)| after.starts_with(text));
        text == before || text == after || self.growing.contains(&path) && is_prefix()
    }
}

fn cases() -> ProptestConfig {
    let default = ProptestConfig::default();
    let cases = if default.cases == 256 { 40 } else { default.cases };
    ProptestConfig { cases, max_shrink_iters: 0, failure_persistence: None, ..default }
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn killed_commands_leave_whole_files(which in any::<Index>(), moment in 0.0..1.1_f64) {
        let writer = which.get(&REFERENCES);
        let folder = application();
        let mut child = folder.command(writer.args).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        std::thread::sleep(writer.duration.mul_f64(moment));
        child.kill().unwrap();
        child.wait().unwrap();

        let killed = files(folder.path());
        for path in writer.before.keys().chain(writer.after.keys()) {
            prop_assert!(writer.is_whole(path, killed.get(path)), "{:?} tears {path}", writer.args);
        }
        for path in killed.keys() {
            let is_known = writer.before.contains_key(path) || writer.after.contains_key(path);
            prop_assert!(is_known || is_temporary(path), "{:?} leaves {path}", writer.args);
        }

        folder.val3(writer.args);
        let finished = files(folder.path());
        prop_assert_eq!(finished.keys().collect::<Vec<_>>(), writer.after.keys().collect::<Vec<_>>(), "{:?}", writer.args);
        for (path, text) in &writer.after {
            prop_assert!(finished.get(path) == Some(text), "{:?}: {path} after the next run", writer.args);
        }
    }
}
