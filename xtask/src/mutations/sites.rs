//! The places of an application where a mistake can be made.

use std::fmt;
use std::fs;
use std::ops::Range;

use camino::{Utf8Path, Utf8PathBuf};

/// Replacements of words and operators. The longer of two that begin alike comes first.
const WORDS: &[(&str, &str)] = &[
    ("==", "!="),
    ("!=", "=="),
    ("<=", ">"),
    (">=", "<"),
    ("<", ">="),
    (">", "<="),
    ("+", "-"),
    ("-", "+"),
    ("*", "/"),
    (" and ", " or "),
    (" or ", " and "),
    ("true", "false"),
    ("false", "true"),
];

/// The beginnings of lines that end or begin a block: they are never deleted.
const BLOCKS: &[&str] = &[
    "begin",
    "end",
    "if",
    "else",
    "elseIf",
    "endIf",
    "while",
    "endWhile",
    "for",
    "endFor",
    "do",
    "until",
    "switch",
    "case",
    "default",
    "break",
    "endSwitch",
];

/// One mistake.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Site {
    /// The file, relative to the folder.
    pub(super) file: Utf8PathBuf,
    line: usize,
    range: Range<usize>,
    found: String,
    replacement: String,
}

impl fmt::Display for Site {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: `{}` -> `{}`", self.file, self.line, self.found.trim(), self.replacement.trim())
    }
}

impl Site {
    /// The text of the file with the mistake.
    pub(super) fn applied(&self, text: &str) -> String {
        let mut text = text.to_owned();
        text.replace_range(self.range.clone(), &self.replacement);
        text
    }
}

/// All mistakes that can be made in the programs and data of an application.
pub(super) fn sites(folder: &Utf8Path, application: &Utf8Path) -> anyhow::Result<Vec<Site>> {
    let mut files: Vec<Utf8PathBuf> = Vec::new();
    for entry in folder.join(application).read_dir_utf8()? {
        files.push(application.join(entry?.file_name()));
    }
    files.sort();
    let mut found = Vec::new();
    for file in files {
        let text = fs::read_to_string(folder.join(&file))?;
        match file.extension() {
            Some("pgx") => found.extend(in_program(&file, &text)),
            Some("dtx") => found.extend(in_data(&file, &text)),
            _ => {}
        }
    }
    Ok(found)
}

/// Mistakes in the lines of code between `begin` and `end`.
fn in_program(file: &Utf8Path, text: &str) -> Vec<Site> {
    let code = text.find("<![CDATA[begin").unwrap_or(text.len());
    let mut found = Vec::new();
    for (line, start, content) in lines(text).filter(|(_, start, _)| *start > code) {
        let site = |range: Range<usize>, replacement: String| Site {
            file: file.to_owned(),
            line,
            found: content.get(range.clone()).unwrap_or_default().to_owned(),
            range: start + range.start..start + range.end,
            replacement,
        };
        let masked = without_strings(content);
        if content.trim_start().starts_with("//") || content.contains("]]>") {
            continue;
        }
        found.extend(words(&masked).into_iter().map(|(range, replacement)| site(range, replacement.to_owned())));
        found.extend(numbers(&masked).into_iter().map(|(range, number)| site(range, (number + 1.0).to_string())));
        let first = masked.trim_start().split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
        if !first.is_empty() && !BLOCKS.contains(&first) {
            found.push(site(0..content.len(), String::new()));
        }
    }
    found
}

/// Mistakes in the values of numbers and positions: 10 more.
fn in_data(file: &Utf8Path, text: &str) -> Vec<Site> {
    let mut found = Vec::new();
    for (line, start, content) in lines(text).filter(|(_, _, content)| content.trim_start().starts_with("<Value")) {
        for (range, number) in numbers(content) {
            let before = content.get(..range.start).unwrap_or_default();
            if before.ends_with("=\"") && !before.ends_with("key=\"") {
                found.push(Site {
                    file: file.to_owned(),
                    line,
                    found: content.trim().to_owned(),
                    range: start + range.start..start + range.end,
                    replacement: (number + 10.0).to_string(),
                });
            }
        }
    }
    found
}

/// Number, first byte and text of each line.
fn lines(text: &str) -> impl Iterator<Item = (usize, usize, &str)> {
    let starts = text.split_inclusive('\n').scan(0, |next, line| {
        let start = *next;
        *next += line.len();
        Some((start, line.trim_end_matches(['\r', '\n'])))
    });
    starts.zip(1..).map(|((start, line), number)| (number, start, line))
}

/// The line with its strings replaced by underscores of the same length.
fn without_strings(line: &str) -> String {
    let mut is_inside = false;
    let mask = |c: char| {
        let is_quote = c == '"';
        is_inside ^= is_quote;
        if is_inside || is_quote { "_".repeat(c.len_utf8()) } else { c.to_string() }
    };
    line.chars().map(mask).collect()
}

fn words(line: &str) -> Vec<(Range<usize>, &'static str)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(rest) = line.get(at..).filter(|rest| !rest.is_empty()) {
        match WORDS.iter().find(|(word, _)| rest.starts_with(word)) {
            Some((word, replacement)) => {
                found.push((at..at + word.len(), *replacement));
                at += word.trim_end().len();
            }
            None => at += rest.chars().next().map_or(1, char::len_utf8),
        }
    }
    found
}

/// The numbers that are not part of a name.
fn numbers(line: &str) -> Vec<(Range<usize>, f64)> {
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '.');
    let mut found = Vec::new();
    let mut start = None;
    for (at, c) in line.char_indices().chain([(line.len(), ' ')]) {
        match (start, is_part(c)) {
            (None, true) => start = Some(at),
            (Some(from), false) => {
                let number = line.get(from..at).and_then(|word| word.parse().ok());
                found.extend(number.filter(|number: &f64| number.is_finite()).map(|number| (from..at, number)));
                start = None;
            }
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mistakes_are_made_in_code_alone() {
        let text = "<![CDATA[begin\n  // a+1\n  if l_n2<=3 and bOk==true\n    call report(\"a+b\")\n  endIf\nend]]>";
        let found: Vec<String> = in_program("a.pgx".into(), text).iter().map(Site::to_string).collect();
        let expected = [
            "a.pgx:3: `<=` -> `>`",
            "a.pgx:3: `and` -> `or`",
            "a.pgx:3: `==` -> `!=`",
            "a.pgx:3: `true` -> `false`",
            "a.pgx:3: `3` -> `4`",
            "a.pgx:4: `call report(\"a+b\")` -> ``",
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn a_mistake_changes_its_place() {
        let text = "begin\n<Value key=\"0\" x=\"12.5\" fatherId=\"f[0]\" />\n";
        let found = in_data("a.dtx".into(), text);
        let changed: Vec<String> = found.iter().map(|site| site.applied(text)).collect();
        assert_eq!(changed, ["begin\n<Value key=\"0\" x=\"22.5\" fatherId=\"f[0]\" />\n"]);
    }
}
