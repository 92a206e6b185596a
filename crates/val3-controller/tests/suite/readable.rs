//! Files and folders that the user of the controller may not read.

use val3_controller::{ControllerError, ReadableFiles, SilentObserver, read_readable_files};

use crate::bench::{Bench, applications};
use crate::server::Behaviour;

fn read(behaviour: Behaviour) -> Result<ReadableFiles, ControllerError> {
    let bench = Bench::empty(behaviour);
    read_readable_files(&mut bench.server.connect(), &applications(), &mut SilentObserver)
}

#[test]
fn other_files_are_read() {
    let all = read(Behaviour::default()).unwrap();
    assert!(all.unread.is_empty() && all.unlisted.is_empty());
    let rejections = vec![("RETR /usr/usrapp/demo/demo.dtx", "550 no rights")];
    let read = read(Behaviour { rejections, ..Behaviour::default() }).unwrap();
    let unread: Vec<String> = read.unread.iter().map(|(path, reason)| format!("{path}: {reason}")).collect();
    assert_eq!(unread, ["usr/usrapp/demo/demo.dtx: 550 no rights"]);
    assert_eq!(read.contents.len() + 1, all.contents.len());
    assert!(read.contents.iter().all(|(path, bytes)| all.contents[path] == *bytes));
}

#[test]
fn other_folders_are_listed() {
    let rejections = vec![("CWD /usr/usrapp/demo", "550 no rights")];
    let read = read(Behaviour { rejections, ..Behaviour::default() }).unwrap();
    let unlisted: Vec<String> = read.unlisted.iter().map(|(path, reason)| format!("{path}: {reason}")).collect();
    assert_eq!(unlisted, ["usr/usrapp/demo: 550 no rights"]);
    assert!(!read.contents.keys().any(|path| path.as_str().starts_with("usr/usrapp/demo")));
}

/// An interrupted transfer is no missing right: the next file could fail for the same reason.
#[test]
fn a_lost_connection_is_an_error() {
    for behaviour in [
        Behaviour { breaks: Some("RETR /usr/usrapp/demo/demo.dtx"), ..Behaviour::default() },
        Behaviour { rejections: vec![("RETR /usr/usrapp/demo/demo.dtx", "421 closing")], ..Behaviour::default() },
    ] {
        assert!(matches!(read(behaviour).unwrap_err(), ControllerError::Access(_)));
    }
}
