//! Finds faults in a text.

use super::files::TextFile;

/// Largest number of lines in a source file.
const MOST_LINES: usize = 600;

/// Marks of unfinished work, split because this file is checked too.
const UNFINISHED: &[&str] = &[concat!("TO", "DO"), concat!("FIX", "ME"), concat!("XX", "X"), concat!("HA", "CK")];

/// File names that do not describe the content.
const EMPTY_NAMES: &[&str] = &["utils", "util", "common", "helpers", "helper", "manager", "misc", "mod"];

/// Returns the faults of a file, in the form `path:line: fault`.
pub(super) fn of(file: &TextFile) -> Vec<String> {
    let mut faults = name_faults(file);
    for (index, line) in file.text.split('\n').enumerate() {
        let what = line_faults(line).into_iter();
        faults.extend(what.map(|what| format!("{}:{}: {what}", file.path, index + 1)));
    }
    faults.extend(whole_faults(file).into_iter().map(|what| format!("{}: {what}", file.path)));
    faults
}

fn name_faults(file: &TextFile) -> Vec<String> {
    let stem = file.path.file_stem().unwrap_or_default();
    if file.is_source() && EMPTY_NAMES.contains(&stem) {
        return vec![format!("{}: a name that says nothing", file.path)];
    }
    Vec::new()
}

fn line_faults(line: &str) -> Vec<String> {
    let mut faults = Vec::new();
    if line.ends_with('\r') {
        faults.push("a carriage return".to_owned());
    } else if line.ends_with([' ', '\t']) {
        faults.push("blanks at the end of the line".to_owned());
    }
    let words = line.split(|letter: char| !letter.is_ascii_alphanumeric());
    let unfinished = words.filter(|word| UNFINISHED.contains(word));
    faults.extend(unfinished.map(|word| format!("unfinished: {word}")));
    faults
}

fn whole_faults(file: &TextFile) -> Vec<String> {
    let mut faults = Vec::new();
    if !file.text.ends_with('\n') {
        faults.push("no line end at the end of the file".to_owned());
    } else if file.text.ends_with("\n\n") {
        faults.push("blank lines at the end of the file".to_owned());
    }
    let lines = file.text.lines().count();
    if file.is_source() && lines > MOST_LINES {
        faults.push(format!("{lines} lines, more than {MOST_LINES}"));
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(path: &str, text: &str, expected: &[&str]) {
        let file = TextFile { path: path.into(), text: text.to_owned() };
        assert_eq!(of(&file), expected);
    }

    #[test]
    fn tidy_texts_have_no_faults() {
        check("a.rs", "fn a() {}\n", &[]);
    }

    #[test]
    fn blanks_and_line_ends_are_reported() {
        check("a.md", "a \nb", &["a.md:1: blanks at the end of the line", "a.md: no line end at the end of the file"]);
        check("a.md", "a\r\n", &["a.md:1: a carriage return"]);
        check("a.md", "a\n\n", &["a.md: blank lines at the end of the file"]);
    }

    #[test]
    fn unfinished_work_and_empty_names_are_reported() {
        let text = concat!("// TO", "DO: more\n");
        check("mod.rs", text, &["mod.rs: a name that says nothing", concat!("mod.rs:1: unfinished: TO", "DO")]);
    }

    #[test]
    fn long_files_are_reported() {
        let text = "a\n".repeat(MOST_LINES + 1);
        check("table.md", &text, &[]);
        check("written.rs", &text, &["written.rs: 601 lines, more than 600"]);
    }
}
