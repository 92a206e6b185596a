//! Programs that may let other tasks run.

use val3_analysis::application::application;

use crate::show::{project, workspace};

/// Returns the programs during which other tasks may run, sorted by name.
fn waiting(listing: &str) -> Vec<String> {
    let workspace = workspace(listing);
    let application = application(&workspace.db, project(&workspace, "main"));
    let mut names: Vec<String> = application.waiting.iter().map(ToString::to_string).collect();
    names.sort();
    names
}

fn programs(bodies: &[(&str, &str)]) -> String {
    let programs = bodies.iter().map(|(name, body)| format!("program {name}()\nbegin\n  {body}\nend\n\n"));
    programs.collect()
}

#[test]
fn a_program_waits_if_its_callee_waits() {
    let listing =
        programs(&[("a", "call b()"), ("b", "call c()"), ("c", "delay(0)"), ("d", "put(1)"), ("e", "call d()")]);
    assert_eq!(waiting(&listing), ["a", "b", "c"]);
}

#[test]
fn creating_a_waiting_task_does_not_wait() {
    assert_eq!(waiting(&programs(&[("a", "taskCreate \"t\",10,b()"), ("b", "wait(true)")])), ["b"]);
}

#[test]
fn lines_and_libraries_may_wait() {
    let data = "string sA\nsio line\nlibrary lib \"Disk://lib/lib.pjx\"\n\n";
    let lib = "--- lib\npublic program run()\nbegin\nend\n";
    let listing = programs(&[("a", "sA=line"), ("b", "line=sA"), ("c", "call lib:run()"), ("d", "sA=\"\"")]);
    assert_eq!(waiting(&format!("{data}{listing}{lib}")), ["a", "b", "c"]);
}

#[test]
fn circles_of_calls_are_resolved() {
    let listing = programs(&[("a", "call b()"), ("b", "call a()"), ("c", "call c()")]);
    assert!(waiting(&listing).is_empty());
}

#[test]
fn programs_that_call_themselves() {
    let listing = programs(&[
        ("a", "call b()"),
        ("b", "call c()"),
        ("c", "call b()"),
        ("d", "call d()"),
        ("e", "call f()"),
        ("f", "taskCreate \"t\",10,e()"),
    ]);
    let workspace = workspace(&listing);
    let circles = &application(&workspace.db, project(&workspace, "main")).circles;
    let mut names: Vec<&str> = circles.iter().map(|name| name.as_str()).collect();
    names.sort_unstable();
    assert_eq!(names, ["b", "c", "d"]);
}
