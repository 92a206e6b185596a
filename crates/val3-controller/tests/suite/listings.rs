//! Listings that are not trusted.

use val3_controller::{AccessFault, ControllerError, NameFaultKind};

use crate::bench::Bench;
use crate::server::{Behaviour, ListForm};

fn refused(form: ListForm, line: &'static str) -> AccessFault {
    let bench = Bench::empty(Behaviour { form, extra_lines: vec![line], ..Behaviour::default() });
    match bench.pull().unwrap_err() {
        ControllerError::Access(error) => error.reason,
        other => panic!("{other}"),
    }
}

#[test]
fn names_that_lead_elsewhere_stop_a_pull() {
    for (form, line) in [
        (ListForm::Mlsd, "type=file; ../../x"),
        (ListForm::Unix, "-rw-r--r--   1 0  0   512 Jan  1  1980 ../x"),
        (ListForm::Dos, "01-01-80  12:00AM                  512 C:\\x"),
        (ListForm::Names, "..\\x"),
    ] {
        let AccessFault::Name(fault) = refused(form, line) else { panic!("{form:?}") };
        assert_eq!(fault.reason, NameFaultKind::Separator, "{form:?}");
    }
}

#[test]
fn links_and_unknown_lines_stop_a_pull() {
    let link = "lrwxrwxrwx   1 0  0   4 Jan  1  1980 out -> /etc";
    assert_eq!(refused(ListForm::Unix, link), AccessFault::Special("out".to_owned()));
    assert_eq!(refused(ListForm::Unix, "hello"), AccessFault::Listing("hello".to_owned()));
}

#[test]
fn names_that_differ_only_in_case_stop_a_pull() {
    let bench = Bench::empty(Behaviour::default());
    bench.server.state().tree.files.insert("/usr/usrapp/demo/START.pgx".into(), Vec::new());
    assert!(matches!(bench.pull().unwrap_err(), ControllerError::SameName(..)));
    assert!(!bench.folder.join("usr").exists());
}

#[test]
fn a_new_file_whose_name_differs_only_in_case_is_not_pushed() {
    let bench = Bench::pulled(Behaviour { ignores_case: true, ..Behaviour::default() });
    bench.write("usr/usrapp/DEMO/other.pgx", "x");
    assert!(matches!(bench.plan().unwrap_err(), ControllerError::SameName(..)));
}

#[test]
fn folders_end_at_a_depth() {
    let bench = Bench::empty(Behaviour::default());
    let folders = (1..40).map(|depth| format!("/usr/usrapp{}", "/a".repeat(depth)));
    bench.server.state().tree.folders.extend(folders);
    assert!(matches!(bench.pull().unwrap_err(), ControllerError::TooDeep(_)));
}
