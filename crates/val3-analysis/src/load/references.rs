//! Libraries that programs load by path.

use memchr::memmem;
use val3_syntax::decode_entities;

/// Constant part of a path argument of `libLoad(…)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum PathArgument {
    /// An entire path: `libLoad("Disk://part")`.
    Path(String),
    /// A prefix: `libLoad("Disk://parts/" + sName)`.
    Prefix(String),
}

impl PathArgument {
    pub(super) fn whole(&self) -> Option<&str> {
        match self {
            Self::Path(path) => Some(path),
            Self::Prefix(_) => None,
        }
    }

    pub(super) fn prefix(&self) -> Option<&str> {
        match self {
            Self::Path(_) => None,
            Self::Prefix(prefix) => Some(prefix),
        }
    }
}

/// Returns the constant paths that the code in `text` loads.
pub(super) fn loaded_libraries(text: &str) -> Vec<PathArgument> {
    memmem::find_iter(text.as_bytes(), b"libLoad")
        .filter_map(|at| argument(text.get(at + "libLoad".len()..)?))
        .collect()
}

/// Whether two versions of a program load the same constant paths. If this holds and only code changed, the workspace
/// need not be loaded again.
pub fn loads_alike(before: &str, after: &str) -> bool {
    loaded_libraries(before) == loaded_libraries(after)
}

fn argument(rest: &str) -> Option<PathArgument> {
    let line = rest.lines().next()?;
    let line = decode_entities(line.get(..line.floor_char_boundary(1000)).unwrap_or(line));
    let argument = line.trim_start().strip_prefix('(')?.trim_start().strip_prefix('"')?;
    let (path, behind) = argument.split_once('"')?;
    Some(match behind.trim_start().starts_with('+') {
        true => PathArgument::Prefix(path.to_owned()),
        false => PathArgument::Path(path.to_owned()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literal_and_computed_paths_are_found() {
        let text = "n=part:libLoad(\"Disk://a\")\npart:libLoad (&quot;./b&quot;+sName)\nx:libLoad(sPath)";
        assert_eq!(
            loaded_libraries(text),
            [PathArgument::Path("Disk://a".to_owned()), PathArgument::Prefix("./b".to_owned())]
        );
    }
}
