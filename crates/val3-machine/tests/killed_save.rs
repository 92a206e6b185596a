//! A process that is killed while it saves a library loses no data.
//!
//! The test starts itself as that process, which ends itself before each step in turn with a signal that it cannot
//! catch.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::disallowed_methods, reason = "a test tells its own process what to do")]

use std::io;
use std::process::Command;

use camino::{Utf8Path, Utf8PathBuf};
use val3_data::{SavedContainer, SavedContent, SavedData, SavedValue};
use val3_machine::files::{ControllerPath, LibraryFiles, LibraryPath, Roots, Steps, Uninterrupted};

const FOLDER: &str = "VAL3_TEST_FOLDER";
const STEP: &str = "VAL3_TEST_STEP";

/// Kills the process before the step with this number.
struct Kill {
    left: u32,
}

impl Steps for Kill {
    fn next(&mut self) -> io::Result<()> {
        self.left -= 1;
        if self.left == 0 {
            rustix::process::kill_process(rustix::process::getpid(), rustix::process::Signal::KILL)?;
        }
        Ok(())
    }
}

fn part() -> LibraryPath {
    LibraryPath::new(&ControllerPath::root("Disk").join("part").unwrap()).unwrap()
}

fn mounted(disk: &Utf8Path) -> Roots {
    let mut roots = Roots::default();
    roots.mount("Disk", disk).unwrap();
    roots
}

fn number(name: &str, value: u32) -> SavedData {
    let content = SavedContent::Attributes(vec![("value".into(), value.to_string())]);
    let values = vec![SavedValue { key: "0".to_owned(), content }];
    SavedData {
        name: name.into(),
        type_name: "num".into(),
        shape: SavedContainer::Sizes(vec![1]),
        values,
        is_part: false,
    }
}

fn changed(old: &LibraryFiles) -> LibraryFiles {
    old.with_data(&[number("nA", 2), number("nB", 2)]).unwrap()
}

/// A library with two data files that both change.
fn make(disk: &Utf8Path) {
    let part = disk.join("part");
    std::fs::create_dir_all(&part).unwrap();
    let project = "<Project><Database><Data file=\"a.dtx\" /><Data file=\"b.dtx\" /></Database></Project>";
    std::fs::write(part.join("part.pjx"), project).unwrap();
    for (file, name) in [("a.dtx", "nA"), ("b.dtx", "nB")] {
        let data = format!("<Data name=\"{name}\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"1\" />");
        std::fs::write(part.join(file), format!("<Database><Datas>{data}</Datas></Database>")).unwrap();
    }
}

/// The process that is killed.
#[test]
#[ignore = "started by the other test"]
fn saves_and_is_killed() {
    let Ok(disk) = std::env::var(FOLDER) else { return };
    let left = std::env::var(STEP).unwrap().parse().unwrap();
    let roots = mounted(disk.as_str().into());
    let old = part().read(&roots, "").unwrap();
    part().save(&roots, &old, &changed(&old), &mut Kill { left }).unwrap();
}

/// Saves in a separate process; returns whether it has ended regularly.
fn save_killed(disk: &Utf8Path, step: u32) -> bool {
    let mut command = Command::new(std::env::current_exe().unwrap());
    command.args(["--exact", "saves_and_is_killed", "--ignored"]);
    let output = command.env(FOLDER, disk).env(STEP, step.to_string()).output().unwrap();
    let shown = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.code().is_none() || shown.contains("1 passed"), "{shown}");
    output.status.success()
}

#[test]
fn a_killed_process_leaves_the_old_or_the_new_library() {
    let (mut kept, mut replaced) = (0, 0);
    for step in 1..100 {
        let folder = tempfile::tempdir().unwrap();
        let disk = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
        make(&disk);
        let roots = mounted(&disk);
        let old = part().read(&roots, "").unwrap();
        let new = changed(&old);
        assert_ne!(old, new);
        let ended = save_killed(&disk, step);
        let found = part().read(&roots, "").unwrap();
        assert!(found == old || found == new, "step {step}: {found:?}");
        assert_eq!(disk.join("part").read_dir_utf8().unwrap().count(), 3, "step {step}");
        part().save(&roots, &found, &new, &mut Uninterrupted).unwrap();
        assert_eq!(part().read(&roots, "").unwrap(), new, "step {step}");
        if ended {
            assert!(kept > 5 && replaced > 3, "{kept} {replaced}");
            return;
        }
        if found == old { kept += 1 } else { replaced += 1 }
    }
    panic!("it never ends");
}
