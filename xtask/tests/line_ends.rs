//! Every file of the repository has the line ends that `.gitattributes` declares, in the repository and in the clone.

#![allow(clippy::unwrap_used, clippy::disallowed_methods, reason = "a test may fail loudly, and git is started")]

use std::process::Command;

/// Returns the fault in a line of `git ls-files --eol`: line ends in the repository, in the clone, attributes, path.
fn fault(line: &str) -> Option<String> {
    let (states, path) = line.split_once('\t')?;
    let mut states = states.split_whitespace();
    let (stored, present) = (states.next()?, states.next()?);
    let attributes = states.collect::<Vec<_>>().join(" ");
    let is_declared = attributes == "attr/-text" || attributes == "attr/text=auto eol=lf";
    // Binary files are recognised by their content, and empty files contain no line.
    let is_kept = attributes == "attr/-text"
        || [("i/lf", "w/lf"), ("i/-text", "w/-text"), ("i/none", "w/none")].contains(&(stored, present));
    (!is_declared || !is_kept).then(|| format!("{path}: {stored} {present} {attributes}"))
}

#[test]
fn every_file_has_the_declared_line_ends() {
    let root = xtask::project::root();
    let output = Command::new("git").args(["ls-files", "--eol"]).current_dir(root).output().unwrap();
    let listed = String::from_utf8(output.stdout).unwrap();
    // A source archive contains no repository.
    let is_clone = xtask::project::root().join(".git").exists();
    assert!(!is_clone || listed.lines().count() > 1000, "{}", String::from_utf8_lossy(&output.stderr));
    // Files that were removed in the clone have no state there.
    let present = listed.lines().filter(|line| !line.contains(" w/ "));
    let faults: Vec<_> = present.filter_map(fault).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn converted_and_mixed_line_ends_are_faults() {
    let line = |stored: &str, present: &str, attributes: &str| format!("{stored}    {present}    {attributes} \ta.md");
    assert_eq!(fault(&line("i/lf", "w/lf", "attr/text=auto eol=lf")), None);
    assert_eq!(fault(&line("i/-text", "w/-text", "attr/text=auto eol=lf")), None);
    assert_eq!(fault(&line("i/crlf", "w/crlf", "attr/-text")), None);
    assert!(fault(&line("i/lf", "w/crlf", "attr/text=auto eol=lf")).is_some());
    assert!(fault(&line("i/mixed", "w/mixed", "attr/text=auto eol=lf")).is_some());
    assert_eq!(fault(&line("i/lf", "w/lf", "attr/")).unwrap(), "a.md: i/lf w/lf attr/");
}
