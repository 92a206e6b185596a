//! Encrypted libraries in `val3 run` (6.5, 6.6).

use std::fs;
use std::io::{Cursor, Write};

use val3_test::Fixture;
use zip::unstable::write::FileOptionsExt;
use zip::write::{SimpleFileOptions, ZipWriter};

use crate::support::{CommandOutput, Folder, add_stops};

const PASSWORD: &str = "k7#fjW-20q";

/// An application that loads `part.zip` with a password, and uses the library if it was loaded.
const LOADER: &str = r#"
    library part "Disk://part/part.pjx" autoload=false
    num nCode
    string sPassword
    program start()
    begin
      nCode=part:libLoad("part.zip",sPassword)
      ? nCode
      if nCode==0
        call part:init(2)
        ? part:nWeight
        ? part:libPath()
        ? part:libSave()
      endIf
    end
    --- part
    public num nWeight
    public program init(num x_nFactor)
    begin
    end
"#;

/// The encrypted library. It loads an unencrypted library next to it.
const SECRET: &str = r#"
    --- secret
    library bolt "Disk://bolt/bolt.pjx"
    public num nWeight=20
    num nOwn
    public program init(num x_nFactor)
    begin
      nOwn=x_nFactor*bolt:nCount
      nWeight=nWeight+nOwn
      ? libPath()
    end
    --- bolt
    public num nCount=3
"#;

fn pack<'f>(files: impl IntoIterator<Item = (&'f str, &'f [u8])>) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        let options = SimpleFileOptions::default().with_deprecated_encryption(PASSWORD.as_bytes()).unwrap();
        zip.start_file(name, options).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// Files of the encrypted library.
fn secret() -> Vec<(String, String)> {
    let files = Fixture::parse(SECRET).files.into_iter();
    files.filter_map(|(path, text)| Some((path.strip_prefix("usrapp/secret/")?.to_owned(), text))).collect()
}

/// Runs the application with these bytes as `part.zip`.
#[track_caller]
fn run(archive: &[u8], password: &str) -> CommandOutput {
    let folder = Folder::with(&LOADER.replace("string sPassword", &format!("string sPassword=\"{password}\"")));
    for (path, text) in Fixture::parse(SECRET).files.iter().filter(|(path, _)| path.starts_with("usrapp/bolt/")) {
        folder.write(path, text);
    }
    fs::write(folder.path().join("usrapp/part.zip"), archive).unwrap();
    add_stops(folder.path());
    let before = listing(&folder);
    let run = folder.val3(&["run", "--until", "60"]);
    assert_eq!(listing(&folder), before, "the archive is unpacked in memory alone");
    run
}

/// All files in the cell's folder.
fn listing(folder: &Folder) -> Vec<String> {
    let mut open = vec![folder.path().to_owned()];
    let mut found = Vec::new();
    while let Some(path) = open.pop() {
        for entry in fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()) {
            if entry.is_dir() { open.push(entry) } else { found.push(entry.display().to_string()) }
        }
    }
    found.sort();
    found
}

fn good() -> Vec<u8> {
    let files = secret();
    pack(files.iter().map(|(path, text)| (path.as_str(), text.as_bytes())))
}

#[test]
fn programs_of_an_archive_run_with_the_password() {
    let run = run(&good(), PASSWORD);
    assert_eq!((run.code, run.stdout.as_str()), (0, "0\nDisk://part.zip\n26\nDisk://part.zip\n40\n"), "{run:?}");
}

#[test]
fn another_password_is_refused() {
    for password in ["", "k7#fjW-20Q", "password"] {
        let run = run(&good(), password);
        assert_eq!(run.code, 0, "{run:?}");
        assert!(run.stdout.lines().any(|line| line == "12"), "{password}: {run:?}");
    }
}

#[test]
fn a_plain_archive_is_refused() {
    let run = run(b"no archive", PASSWORD);
    assert_eq!((run.code, run.stdout.as_str()), (0, "23\n"), "{run:?}");
}

#[test]
fn a_hostile_archive_is_refused() {
    let files = secret();
    let files = files.iter().map(|(path, text)| (path.as_str(), text.as_bytes()));
    let with = |name: &'static str, bytes: &'static [u8]| pack(files.clone().chain([(name, bytes)]));
    static ZEROS: [u8; 64 << 20] = [0; 64 << 20];
    let mut cut = good();
    cut.truncate(cut.len() - 30);
    for (name, archive, code) in [
        ("slip", with("../../evil.pgx", b"evil"), "12"),
        ("slip by a root", with("/tmp/evil.pgx", b"evil"), "12"),
        ("slip of Windows", with("..\\evil.pgx", b"evil"), "12"),
        ("bomb", with("bomb.pgx", &ZEROS), "12"),
        ("cut", cut, "23"),
    ] {
        let run = run(&archive, PASSWORD);
        assert_eq!(run.code, 0, "{name}: {run:?}");
        assert!(run.stdout.lines().any(|line| line == code), "{name}: {run:?}");
    }
}

#[test]
fn a_library_with_faults_in_an_archive_is_refused() {
    let mut files = secret();
    for (_, text) in files.iter_mut().filter(|(path, _)| path == "init.pgx") {
        *text = text.replace("nOwn=", "nGone=");
    }
    let archive = pack(files.iter().map(|(path, text)| (path.as_str(), text.as_bytes())));
    let run = run(&archive, PASSWORD);
    assert_eq!(run.code, 0, "{run:?}");
    insta::assert_snapshot!(run.stdout);
}
