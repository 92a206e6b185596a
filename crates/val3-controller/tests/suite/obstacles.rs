//! Files where a pull needs folders, and folders where it needs files.

use std::fs;

use val3_controller::ControllerError;

use crate::bench::{Bench, path};
use crate::memory::MemoryFiles;
use crate::pulls::{START, bench, teach};

/// Files and folders that have changed places, on the controller and here.
#[test]
fn a_file_becomes_a_folder_and_a_folder_a_file() {
    let inner = "usr/usrapp/demo/start.pgx/inner.pgx";
    let bench = bench();
    let old = |bench: &Bench<MemoryFiles>| bench.server.state().tree.folders.remove("/usr/usrapp/demo/start.pgx");
    for _ in 0..2 {
        teach(&bench, START, None);
        teach(&bench, inner, Some("inner"));
        bench.pull().unwrap();
        assert_eq!(bench.text(inner), "inner");
        teach(&bench, inner, None);
        old(&bench);
        teach(&bench, START, Some("start"));
        bench.pull().unwrap();
        assert_eq!(bench.text(START), "start");
        assert!(bench.status().unwrap().differences.is_empty());
    }
}

#[test]
fn a_local_file_in_the_way_is_named_before_anything_is_written() {
    let inner = "usr/usrapp/demo/more/inner.pgx";
    for (theirs, mine) in [
        (inner, "usr/usrapp/demo/more"),
        ("usr/usrapp/demo/more", inner),
        ("usr/usrapp/demo/more", "usr/usrapp/demo/more/x.bak"),
    ] {
        let bench = bench();
        teach(&bench, theirs, Some("theirs"));
        teach(&bench, START, Some("theirs"));
        bench.write(mine, "mine");
        let obstacle = ControllerError::Obstacle { path: path(theirs), obstacle: path(mine) };
        assert_eq!(bench.pull(), Err(obstacle));
        assert_eq!((bench.text(mine).as_str(), bench.text(START).as_str()), ("mine", "start"));
        fs::remove_file(bench.folder.join(mine)).unwrap();
        bench.pull().unwrap();
        assert_eq!(bench.text(theirs), "theirs");
    }
}

/// After a pull was killed, or a state was removed, copies remain that no state names.
#[test]
fn old_copies_are_not_in_the_way() {
    let bench = bench();
    for (file, copy) in [
        ("usr/usrapp/demo/new.pgx", "usr/usrapp/demo/new.pgx/old.pgx"),
        ("usr/usrapp/demo/more/new.pgx", "usr/usrapp/demo/more"),
        (START, "usr/usrapp/demo/start.pgx/old.pgx"),
    ] {
        let base = bench.folder.join(".val3/base");
        if base.join(file).is_file() {
            fs::remove_file(base.join(file)).unwrap();
        }
        bench.write(&format!(".val3/base/{copy}"), "old");
        teach(&bench, file, Some("theirs"));
        bench.pull().unwrap();
        assert_eq!(bench.text(&format!(".val3/base/{file}")), "theirs");
        assert_eq!(bench.text(file), "theirs");
    }
}
