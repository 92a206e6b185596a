//! Circles in a graph of files.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fmt::Write;

use camino::{Utf8Path, Utf8PathBuf};

use crate::import_circles::edges::Edges;

/// Files that all reach each other.
pub(crate) type Circle = BTreeSet<Utf8PathBuf>;

/// Returns the strongly connected components of more than `size` files, the largest first.
pub(crate) fn circles(edges: &Edges, size: usize) -> Vec<Circle> {
    let reached: BTreeMap<_, _> = edges.keys().map(|file| (file, reached(edges, file))).collect();
    let mut circles = BTreeSet::new();
    for (file, others) in &reached {
        let returns = |other: &&Utf8PathBuf| reached.get(*other).is_some_and(|back| back.contains(*file));
        circles.insert(others.iter().filter(returns).cloned().collect::<Circle>());
    }
    let mut circles: Vec<_> = circles.into_iter().filter(|circle| circle.len() > size).collect();
    circles.sort_by_key(|circle| std::cmp::Reverse(circle.len()));
    circles
}

/// Returns the files that `file` reaches through at least one edge.
fn reached(edges: &Edges, file: &Utf8Path) -> BTreeSet<Utf8PathBuf> {
    let mut reached = BTreeSet::new();
    let mut open = vec![file];
    while let Some(file) = open.pop() {
        let targets = edges.get(file).into_iter().flat_map(BTreeMap::keys);
        open.extend(targets.filter(|target| reached.insert((*target).clone())).map(|target| target.as_path()));
    }
    reached
}

/// Returns a shortest path within `circle` that returns to its beginning, which is at both ends.
pub(crate) fn shortest_cycle<'a>(edges: &'a Edges, circle: &'a Circle) -> Vec<&'a Utf8Path> {
    let cycles = circle.iter().filter_map(|start| cycle_from(edges, circle, start));
    cycles.min_by_key(Vec::len).unwrap_or_default()
}

fn cycle_from<'a>(edges: &'a Edges, circle: &'a Circle, start: &'a Utf8Path) -> Option<Vec<&'a Utf8Path>> {
    let mut sources = BTreeMap::new();
    let mut open = VecDeque::from([start]);
    while let Some(file) = open.pop_front() {
        for target in edges.get(file)?.keys().filter(|target| circle.contains(*target)) {
            if !sources.contains_key(target.as_path()) {
                sources.insert(target.as_path(), file);
                open.push_back(target);
            }
        }
    }
    let mut cycle = vec![start];
    let mut file = *sources.get(start)?;
    while file != start {
        cycle.push(file);
        file = sources.get(file)?;
    }
    cycle.push(start);
    cycle.reverse();
    Some(cycle)
}

/// Describes a circle by its files, and by a shortest cycle with the names that cause it.
pub(crate) fn describe(edges: &Edges, circle: &Circle, root: &Utf8Path) -> String {
    let short = |file: &Utf8Path| file.strip_prefix(root).unwrap_or(file).to_string();
    let mut text = format!("{} files in a circle:\n", circle.len());
    for file in circle {
        writeln!(text, "  {}", short(file)).unwrap();
    }
    writeln!(text, "a shortest cycle:").unwrap();
    for pair in shortest_cycle(edges, circle).windows(2) {
        let names: Vec<_> = edges[pair[0]][pair[1]].iter().map(String::as_str).collect();
        writeln!(text, "  {} names {} of {}", short(pair[0]), names.join(", "), short(pair[1])).unwrap();
    }
    text
}
