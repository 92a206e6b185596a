//! Matching of the old tree's applications with the new tree's.

use std::collections::BTreeMap;

use val3_analysis::paths::path_key;

use super::Application;

/// An application in both trees, or in only one of them.
pub(crate) struct Matched<'a, 't> {
    pub(crate) old: Option<&'a Application<'t>>,
    pub(crate) new: Option<&'a Application<'t>>,
}

/// Matches applications by path. The rest are matched by name, if the name is unique in each tree.
pub(crate) fn matched<'a, 't>(old: &'a [Application<'t>], new: &'a [Application<'t>]) -> Vec<Matched<'a, 't>> {
    let path = |application: &Application<'_>| path_key(application.path.as_str());
    let by_path: BTreeMap<String, &Application<'_>> =
        old.iter().map(|application| (path(application), application)).collect();
    let mut found: Vec<Matched<'a, 't>> =
        new.iter().map(|new| Matched { old: by_path.get(&path(new)).copied(), new: Some(new) }).collect();
    let free = old.iter().filter(|old| !new.iter().any(|new| path(new) == path(old)));
    let mut free: Vec<&'a Application<'t>> = free.collect();
    let alone: Vec<usize> =
        (0..found.len()).filter(|index| found.get(*index).is_some_and(|pair| pair.old.is_none())).collect();
    for index in alone.iter().copied() {
        let Some(new) = found.get(index).and_then(|pair| pair.new) else { continue };
        let others =
            alone.iter().filter_map(|index| found.get(*index)?.new).filter(|other| same_name(other, new)).count();
        let candidates: Vec<usize> =
            (0..free.len()).filter(|at| free.get(*at).is_some_and(|old| same_name(old, new))).collect();
        if let ([at], 1) = (candidates.as_slice(), others) {
            let old = free.remove(*at);
            found.iter_mut().skip(index).take(1).for_each(|pair| pair.old = Some(old));
        }
    }
    found.extend(free.into_iter().map(|old| Matched { old: Some(old), new: None }));
    found.sort_by_key(|pair| pair.new.or(pair.old).map(path));
    found
}

/// Whether the names are equal. A project and a loose folder never match.
fn same_name(one: &Application<'_>, other: &Application<'_>) -> bool {
    one.manifest.is_some() == other.manifest.is_some() && path_key(&one.name) == path_key(&other.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn application(path: &str) -> Application<'static> {
        Application {
            path: path.into(),
            name: camino::Utf8Path::new(path).file_stem().unwrap().to_owned(),
            manifest: Some(b""),
            ..Application::default()
        }
    }

    fn pairs(old: &[&str], new: &[&str]) -> Vec<String> {
        let [old, new] = [old, new].map(|paths| paths.iter().map(|path| application(path)).collect::<Vec<_>>());
        let path = |side: Option<&Application<'_>>| side.map_or("-".to_owned(), |found| found.path.to_string());
        matched(&old, &new).iter().map(|pair| format!("{} {}", path(pair.old), path(pair.new))).collect()
    }

    #[test]
    fn paths_count_before_names() {
        assert_eq!(
            pairs(&["A/a.pjx", "b/b.pjx"], &["a/a.pjx", "c/c.pjx"]),
            ["A/a.pjx a/a.pjx", "b/b.pjx -", "- c/c.pjx"]
        );
        assert_eq!(pairs(&["a.pjx"], &["x/a.pjx"]), ["a.pjx x/a.pjx"]);
        assert_eq!(pairs(&["1/a.pjx", "2/a.pjx"], &["3/a.pjx"]), ["1/a.pjx -", "2/a.pjx -", "- 3/a.pjx"]);
    }
}
