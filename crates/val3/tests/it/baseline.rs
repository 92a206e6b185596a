//! Baselines: the known findings are exactly the findings at the time of writing.

use std::fs;
use std::path::Path;

use crate::support::{CLEAN, CommandOutput, FAULTY, Folder, copy_folder};

const BASELINE: &str = "val3-baseline.json";

/// A check with the baseline; one line for each finding.
fn check(folder: &Folder, more: &[&str]) -> CommandOutput {
    folder.val3(&[&["check", "--format", "concise", "--baseline", BASELINE], more].concat())
}

#[test]
fn known_findings_are_not_shown() {
    let folder = Folder::with(FAULTY);
    let written = check(&folder, &["--write-baseline"]);
    assert_eq!((written.code, written.stdout.as_str()), (0, ""), "{written:?}");
    assert!(written.stderr.contains("wrote val3-baseline.json with 1 known finding\n"), "{written:?}");
    insta::assert_snapshot!(folder.read(BASELINE));
    let run = check(&folder, &[]);
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
    assert!(run.stderr.contains("not shown: 1 known from the baseline\n"), "{run:?}");
    assert_eq!(folder.val3(&["check"]).code, 1);
}

#[test]
fn a_configuration_names_the_baseline() {
    let folder = Folder::with(FAULTY);
    folder.write("usrapp/main/val3.toml", "baseline = \"known.json\"\n");
    assert_eq!(folder.val3(&["check"]).code, 2, "it is not there yet");
    assert_eq!(folder.val3(&["check", "--write-baseline"]).code, 0);
    assert!(folder.read("usrapp/main/known.json").contains("\"file\": \"start.pgx\""));
    assert_eq!(folder.val3(&["check"]).code, 0);
}

#[test]
fn fixed_findings_are_counted_and_removed() {
    let folder = Folder::with(&format!("{FAULTY}\n--- part\n{FAULTY}"));
    check(&folder, &["--write-baseline"]);
    let start = folder.read("usrapp/main/start.pgx");
    folder.write("usrapp/main/start.pgx", &start.replace("nCuont", "nCount"));
    let run = check(&folder, &[]);
    assert!(run.stderr.contains("no longer found: 1 known finding;"), "{run:?}");
    let elsewhere = check(&folder, &["usrapp/part", "--prune-baseline"]);
    assert!(elsewhere.stderr.contains("with 2 known findings"), "what was not checked stays: {elsewhere:?}");
    let unasked = check(&folder, &["--ignore", "V0101", "--prune-baseline"]);
    assert!(unasked.stderr.contains("with 2 known findings"), "what was not looked for stays: {unasked:?}");
    let pruned = check(&folder, &["--prune-baseline"]);
    assert!(pruned.stderr.contains("with 1 known finding\n"), "{pruned:?}");
    assert!(!check(&folder, &[]).stderr.contains("not found any more"));
}

#[test]
fn unreadable_baselines_are_refused() {
    let folder = Folder::with(CLEAN);
    let missing = check(&folder, &[]);
    assert_eq!(missing.code, 2, "{missing:?}");
    assert!(missing.stderr.contains("--write-baseline"), "{missing:?}");
    folder.write(BASELINE, "{\"version\": 9, \"findings\": []}");
    let newer = check(&folder, &[]);
    assert_eq!(newer.code, 2, "{newer:?}");
    assert!(newer.stderr.contains("`val3-baseline.json`") && newer.stderr.contains("number 9"), "{newer:?}");
    let nameless = folder.val3(&["check", "--write-baseline"]);
    assert_eq!(nameless.code, 2, "{nameless:?}");
    assert!(nameless.stderr.contains("--baseline FILE"), "{nameless:?}");
}

/// A fixed selection of rules, so that new rules do not change the findings of the generated application.
const SELECTED: &[&str] = &["--select", "V0101,V0202,V0701"];

/// Pseudo-random numbers that are the same in every run.
struct Chance(u64);

impl Chance {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % limit
    }
}

/// Twelve programs, each with unique findings and with equal findings on several lines.
fn mid_sized() -> String {
    let calls: String = (0..12).map(|program| format!("call work{program}()\n")).collect();
    format!("num nCount\nnum nSum\n{calls}{}", (0..12).map(program).collect::<String>())
}

fn program(program: usize) -> String {
    let lines = (0..40).map(|line| match line % 8 {
        0 => format!("nUnknown{program}_{line}={line}\n"),
        1 | 5 => "nCount=\"text\"\n".to_owned(),
        2 => format!("IF nCount=={line}\n  nCount=nCount+1\nendIf\n"),
        _ => format!("nSum=nSum+{line}\n"),
    });
    format!("program work{program}()\nbegin\n{}end\n", lines.collect::<String>())
}

/// Edits a program at random. Returns the new text, and the text of the finding that the edit causes, if any.
fn edit(text: &str, step: usize, chance: &mut Chance) -> (String, Option<String>) {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let begin = lines.iter().position(|line| line.contains("begin")).unwrap();
    let end = lines.iter().rposition(|line| line.trim_start().starts_with("end")).unwrap();
    let at = begin + 1 + chance.below(end - begin);
    let is_plain = |line: &String| line.contains("nSum=nSum+");
    let mut line_end = "\n";
    let caused = match chance.below(8) {
        0 => {
            lines.insert(at, String::new());
            None
        }
        1 => {
            lines.insert(at, format!("  // note {step}"));
            None
        }
        2 => {
            let plain = (begin..end).filter(|line| is_plain(&lines[*line])).nth(3).unwrap();
            lines.remove(plain);
            None
        }
        3 => {
            let faulty = lines.iter().position(|line| line.contains("nCount=\"text\"")).unwrap();
            let moved = lines.remove(faulty);
            lines.insert(begin + 1, format!("   {moved}"));
            None
        }
        4 => {
            line_end = "\r\n";
            None
        }
        5 => {
            lines[begin + 1..end].iter_mut().for_each(|line| line.insert(0, '\t'));
            None
        }
        6 => {
            let doubled = (begin + 1..end).filter(|line| is_plain(&lines[*line])).nth(2).unwrap();
            lines.insert(doubled, lines[doubled].clone());
            None
        }
        _ => {
            lines.insert(at, format!("nNew{step}=1"));
            Some(format!("`nNew{step}` is not declared"))
        }
    };
    (lines.join(line_end) + line_end, caused)
}

/// Renames a program: its file, its entry in the project and its calls.
fn rename(folder: &Folder, old: &str, new: &str) {
    let path = |program: &str| format!("usrapp/main/{program}.pgx");
    let text = folder.read(&path(old));
    fs::remove_file(folder.path().join(path(old))).unwrap();
    folder.write(&path(new), &text.replace(&format!("name=\"{old}\""), &format!("name=\"{new}\"")));
    for (path, old, new) in [
        ("usrapp/main/main.pjx", format!("\"{old}.pgx\""), format!("\"{new}.pgx\"")),
        ("usrapp/main/start.pgx", format!("call {old}("), format!("call {new}(")),
    ] {
        let text = folder.read(path);
        assert!(text.contains(&old), "{path}");
        folder.write(path, &text.replace(&old, &new));
    }
}

#[test]
fn random_edits_report_only_their_own_findings() {
    let folder = Folder::with(&mid_sized());
    let written = check(&folder, &[SELECTED, &["--write-baseline"]].concat());
    assert_eq!(written.code, 0, "{written:?}");
    assert!(folder.read(BASELINE).contains("\"count\": 10"), "{}", folder.read(BASELINE));
    let mut chance = Chance(7);
    let mut expected: Vec<String> = Vec::new();
    let mut programs: Vec<String> = (0..12).map(|number| format!("work{number}")).collect();
    for step in 0..40 {
        let at = chance.below(12);
        if chance.below(6) == 0 {
            let new = format!("renamed{step}");
            rename(&folder, &programs[at], &new);
            programs[at] = new;
        }
        let path = format!("usrapp/main/{}.pgx", programs[at]);
        let (text, caused) = edit(&folder.read(&path), step, &mut chance);
        folder.write(&path, &text);
        expected.extend(caused);
        let run = check(&folder, SELECTED);
        assert_eq!(run.stdout.lines().count(), expected.len(), "step {step} in {path}: {run:?}");
        assert!(expected.iter().all(|message| run.stdout.contains(message)), "step {step}: {run:?}");
        assert!(!run.stderr.contains("not found any more"), "step {step}: {run:?}");
    }
    assert!(expected.len() > 2, "some edits cause findings");
    assert!(programs.iter().any(|program| program.starts_with("renamed")), "some programs are renamed");
}

#[test]
fn a_renamed_folder_keeps_its_known_findings() {
    let folder = Folder::with(&mid_sized());
    check(&folder, &["--write-baseline"]);
    fs::rename(folder.path().join("usrapp/main"), folder.path().join("usrapp/other")).unwrap();
    let run = check(&folder, &[]);
    assert!(run.stdout.is_empty() && !run.stderr.contains("not found any more"), "{run:?}");
    check(&folder, &["--prune-baseline"]);
    let pruned = folder.read(BASELINE);
    assert!(pruned.contains("usrapp/other/") && !pruned.contains("usrapp/main/"), "{pruned}");
}

#[test]
fn findings_once_per_application_stay_known_in_another_file() {
    let folder = Folder::with("call p()\n$recClean(\"c\")\nprogram p()\nbegin\n  $recClean(\"d\")\nend");
    check(&folder, &["--write-baseline"]);
    let known = folder.read(BASELINE);
    assert!(known.contains("V0104"), "{known}");
    for (path, use_) in [("usrapp/main/p.pgx", "$recClean(\"d\")"), ("usrapp/main/start.pgx", "$recClean(\"c\")")] {
        let text = folder.read(path);
        assert!(text.contains(use_), "{text}");
        folder.write(path, &text.replace(use_, "delay(0)"));
        assert_eq!(check(&folder, &[]).stdout, "", "{path}");
        folder.write(path, &text);
    }
}

#[test]
fn an_additional_equal_finding_is_reported() {
    let folder = Folder::with(&mid_sized());
    check(&folder, &[SELECTED, &["--write-baseline"]].concat());
    let path = "usrapp/main/work3.pgx";
    folder.write(path, &folder.read(path).replacen("nCount=\"text\"", "nCount=\"text\"\nnCount=\"text\"", 1));
    let run = check(&folder, SELECTED);
    assert_eq!(run.stdout.lines().count(), 1, "{run:?}");
}

#[test]
fn known_findings_stay_known_while_lines_move() {
    let folder = Folder::empty();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/faulty");
    copy_folder(&example, folder.path());
    check(&folder, &["--write-baseline"]);
    let mut chance = Chance(11);
    let path = "usr/usrapp/sorter/start.pgx";
    for step in 0..20 {
        let text = folder.read(path);
        let starts: Vec<usize> = text.match_indices('\n').map(|(at, _)| at + 1).collect();
        let (first, last) = (text.find("begin").unwrap(), text.rfind("\nend").unwrap());
        let inside: Vec<usize> = starts.into_iter().filter(|start| (first..=last).contains(start)).collect();
        let at = inside[chance.below(inside.len())];
        folder.write(path, &format!("{}    // note {step}\n{}", &text[..at], &text[at..]));
        let run = check(&folder, &[]);
        assert_eq!(run.stdout, "", "step {step}: {run:?}");
    }
}
