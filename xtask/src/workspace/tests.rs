use super::{Generated, generate};

fn program<'a>(workspace: &'a Generated, path: &str) -> &'a str {
    &workspace.files.iter().find(|file| file.path == path).unwrap().text
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    assert_eq!(generate(2_000, 7), generate(2_000, 7));
    assert_ne!(generate(2_000, 7), generate(2_000, 8));
}

#[test]
fn the_size_is_the_requested_one() {
    for lines in [100, 2_000, 10_000] {
        let workspace = generate(lines, 1);
        assert!((lines..lines + 300).contains(&workspace.code_lines), "{lines}: {}", workspace.code_lines);
    }
}

#[test]
fn files_are_named_in_their_project() {
    let workspace = generate(2_000, 1);
    let project = program(&workspace, "usr/usrapp/cell001/cell001.pjx");
    for file in &workspace.files {
        if let Some(name) = file.path.strip_prefix("usr/usrapp/cell001/").filter(|name| name.ends_with(".pgx")) {
            assert!(project.contains(&format!("<Program file=\"{name}\" />")), "{name}");
        }
    }
}

#[test]
fn blocks_are_balanced() {
    let workspace = generate(10_000, 3);
    for file in &workspace.files {
        let count = |word: &str| file.text.lines().filter(|line| line.split_whitespace().next() == Some(word)).count();
        for (opener, end) in [("if", "endIf"), ("for", "endFor"), ("while", "endWhile"), ("switch", "endSwitch")] {
            assert_eq!(count(opener), count(end), "{}", file.path);
        }
    }
}

#[test]
fn lines_stay_within_the_limit_of_texts() {
    let workspace = generate(10_000, 3);
    for file in &workspace.files {
        for name in file.text.split('"') {
            assert!(!name.starts_with("l_") || name.len() <= 15, "{name}");
        }
    }
}
