//! Length of functions, determined by the indentation of rustfmt.

use camino::Utf8PathBuf;

use super::files::TextFile;

/// A function.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Function {
    pub(super) name: String,
    pub(super) path: Utf8PathBuf,
    /// First line, from 1.
    pub(super) line: usize,
    /// Number of lines, from its head to its closing bracket.
    pub(super) lines: usize,
}

/// Returns the functions of a file.
pub(super) fn of(file: &TextFile) -> Vec<Function> {
    let lines: Vec<_> = file.text.lines().collect();
    let starts = 0..lines.len();
    starts.filter_map(|index| starting_at(index, lines.get(index..)?, file)).collect()
}

/// Returns the function whose head is the first of `lines`.
fn starting_at(index: usize, lines: &[&str], file: &TextFile) -> Option<Function> {
    let head = lines.first()?;
    let name = name(head)?;
    let depth = indentation(head);
    // Code inside a string has its lines at the same depth.
    if head.ends_with('{') && lines.get(1).is_some_and(|line| indentation(line) <= depth) {
        return None;
    }
    let length = lines.iter().position(|line| closes(line, depth))? + 1;
    Some(Function { name, path: file.path.clone(), line: index + 1, lines: length })
}

/// Returns the name of the function whose head starts in `line`.
fn name(line: &str) -> Option<String> {
    let head = line.trim_start();
    let modifiers = ["pub", "pub(crate)", "pub(super)", "const", "async"];
    let mut words = head.split(' ').skip_while(|word| modifiers.contains(word));
    if words.next()? != "fn" {
        return None;
    }
    let name = words.next()?.split(['(', '<']).next()?;
    Some(name.to_owned())
}

fn indentation(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

/// Whether `line` ends a function whose head is at `depth`: on a separate line, or on the same line (`fn f() {}`, `fn
/// f();`).
fn closes(line: &str, depth: usize) -> bool {
    let same_depth = indentation(line) == depth;
    same_depth && (line.trim() == "}" || line.ends_with("{}") || line.ends_with(';') || line.ends_with(" }"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_are_listed_with_their_lengths() {
        let text = "fn short() {}\n\nimpl X {\n    pub(crate) const fn long<T>(\n        a: T,\n    ) {\n        a();\n    }\n}\n";
        let file = TextFile { path: "a.rs".into(), text: text.to_owned() };
        let found: Vec<_> = of(&file).into_iter().map(|f| (f.name, f.line, f.lines)).collect();
        assert_eq!(found, [("short".to_owned(), 1, 1), ("long".to_owned(), 4, 5)]);
    }
}
