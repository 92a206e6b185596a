//! User page at the end of a run at a terminal.

use crate::support::Folder;
use crate::terminal::output_on_terminal;

const PAGE: &str = "userPage()\ntitle(\"Cell 4\")\ngotoxy(3,1)\nput(\"ready\")\n";

fn shown(program: &str, options: &[&str]) -> String {
    let folder = Folder::with(program);
    let command = folder.command(&[&["run", "usrapp/main"], options].concat());
    output_on_terminal(command).replace('\r', "")
}

#[test]
fn a_page_is_shown_if_nothing_else_was_written() {
    let shown = shown(PAGE, &[]);
    let lines: Vec<&str> = shown.lines().filter(|line| line.starts_with(['+', '|'])).collect();
    assert_eq!(lines.len(), 16, "14 lines in a frame: {shown}");
    assert!(lines[0].starts_with("+Cell 4---") && lines[15].starts_with("+------"), "{shown}");
    assert_eq!(lines[2].trim_matches('|').trim_end(), "   ready", "{shown}");
    assert!(!shown.contains("--screen"), "{shown}");
}

#[test]
fn a_page_beside_other_output_is_mentioned() {
    let shown = shown(&format!("{PAGE}? 42\n"), &[]);
    assert!(shown.contains("42\n") && shown.contains("note: the user page has text; --screen shows it"), "{shown}");
    assert!(!shown.contains("ready"), "{shown}");
}

#[test]
fn a_page_without_text_is_not_shown() {
    assert_eq!(shown("userPage()\ngotoxy(3,1)\n", &[]), "");
}
