//! Local files that cannot be read: the message names the file, the place and the remedy.

use std::fs;

use val3_controller::{ControllerError, ControllerFiles as _, ControllerProject, FolderFiles};

use crate::bench::path;
use crate::pulls::bench;

#[test]
fn a_damaged_state_is_named_with_its_line() {
    let bench = bench();
    let text = bench.text(".val3/controller.toml");
    for (damaged, line) in [
        (text.replace("address =", "address"), "line 3: "),
        (text.replace("usr/usrapp/tools/tools.pjx", "../tools.pjx"), "line "),
        (text.replace("version = 1", "version = 9"), "it was written by another version"),
        (format!("<<<<<<< ours\n{text}"), "line 1: "),
    ] {
        assert_ne!(damaged, text);
        bench.write(".val3/controller.toml", &damaged);
        let error = ControllerProject::open(&bench.folder).unwrap_err();
        let ControllerError::DamagedState { reason, .. } = &error else { panic!("{error:?}") };
        assert!(reason.starts_with(line) && error.help().contains("val3 pull ADDRESS"), "{reason}");
        assert_eq!(bench.text(".val3/controller.toml"), damaged);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_name_of_an_emulator_that_is_not_utf8_is_shown() {
    use std::os::unix::ffi::OsStrExt as _;
    let bench = bench();
    let name = std::ffi::OsStr::from_bytes(b"Gr\xfcn.pgx");
    fs::write(bench.folder.join("usr/usrapp/demo").as_std_path().join(name), "").unwrap();
    let error = FolderFiles::open(&bench.folder).unwrap().list(&path("usr/usrapp/demo")).unwrap_err();
    let (text, error) = (error.to_string(), ControllerError::from(error));
    assert!(text.ends_with("the name \"Gr\u{fffd}n.pgx\" is rejected: it is not UTF-8"), "{text}");
    assert!(error.help().starts_with("rename"));
    assert!(bench.status().unwrap_err().to_string().contains("the name \"Gr\u{fffd}n.pgx\" in it is not UTF-8"));
}
