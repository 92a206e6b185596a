//! How much differs in each application: a short table.

use camino::Utf8Path;
use serde::Serialize;

use super::block::{Block, Mark, Row, Table};
use super::counts::Counts;
use super::points::{by_size, displacement, extent};
use crate::model::{ApplicationChange, Change, Comparison, Displacement};

/// The statistics of an application, or of the configuration and the files outside of applications.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Statistics {
    /// The name of the application; `None` for what belongs to no application that differs.
    pub name: Option<String>,
    /// The path of the project file; `None` without an application.
    pub path: Option<String>,
    /// What happened to the application.
    pub change: Change,
    /// Numbers of items that differ. `others` are the files of other kinds in the folder of the application.
    pub counts: Counts,
    /// The greatest movement of a position.
    pub greatest: Option<GreatestMovement>,
}

/// A position that no other one exceeds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GreatestMovement {
    /// The path of the position.
    pub path: String,
    /// The movement in `world`, for a tool on the flange, of a joint position that of its axes; `None` if it is unknown.
    pub displacement: Option<Displacement>,
}

/// The statistics of a comparison, by application.
#[must_use]
pub fn statistics(comparison: &Comparison) -> Vec<Statistics> {
    let mut others: Vec<usize> = vec![0; comparison.applications.len()];
    let mut outside = Counts::of(comparison);
    for file in &comparison.others {
        let around =
            comparison.applications.iter().enumerate().filter(|(_, application)| contains(application, &file.path));
        let Some((index, _)) = around.max_by_key(|(_, application)| application.path.len()) else { continue };
        others.iter_mut().skip(index).take(1).for_each(|count| *count += 1);
        outside.others -= 1;
    }
    let with_others = comparison.applications.iter().zip(others);
    let mut found: Vec<Statistics> = with_others.map(|(application, others)| one(application, others)).collect();
    outside = outside.without(found.iter().map(|statistics| &statistics.counts));
    if !outside.is_empty() {
        found.push(Statistics { name: None, path: None, change: Change::Changed, counts: outside, greatest: None });
    }
    found
}

/// Whether a file lies in the folder of the application.
fn contains(application: &ApplicationChange, file: &str) -> bool {
    let folder = Utf8Path::new(&application.path).parent();
    folder.is_some_and(|folder| Utf8Path::new(&file.to_lowercase()).starts_with(folder.as_str().to_lowercase()))
}

fn one(application: &ApplicationChange, others: usize) -> Statistics {
    let counts = Counts { others, ..Counts::default().with(application) };
    Statistics {
        name: Some(application.name.clone()),
        path: Some(application.path.clone()),
        change: application.change,
        counts,
        greatest: greatest(application),
    }
}

fn greatest(application: &ApplicationChange) -> Option<GreatestMovement> {
    let values = || application.data.iter().flat_map(|data| &data.values);
    let moved = values().filter(|value| value.movement.is_some() || value.axes.is_some());
    let own = moved.map(|value| (&value.path, extent(value)));
    let along = values().flat_map(|value| &value.dependents).map(|dependent| (&dependent.path, dependent.in_world));
    // Of equal movements the first.
    let greater = |one: (_, Option<Displacement>), other: (_, Option<Displacement>)| {
        if by_size(other.1, one.1).is_gt() { other } else { one }
    };
    let (path, displacement) = own.chain(along).reduce(greater)?;
    Some(GreatestMovement { path: path.clone(), displacement })
}

/// A column of numbers: its title and its numbers.
type Column = (&'static str, fn(&Counts) -> usize);

const COLUMNS: [Column; 7] = [
    ("Positions", |counts| counts.points),
    ("Moved along", |counts| counts.moved_along),
    ("Values", |counts| counts.data),
    ("In/out", |counts| counts.io),
    ("Programs", |counts| counts.programs),
    ("Files", |counts| counts.texts + counts.contents + counts.others),
    ("Other", |counts| counts.libraries + counts.interface + counts.configuration),
];

/// The table, without columns of zeros; nothing if nothing differs.
pub(super) fn table(comparison: &Comparison) -> Option<Block> {
    let statistics = statistics(comparison);
    if statistics.is_empty() {
        return None;
    }
    let has_number = |(_, number): &&Column| statistics.iter().any(|one| number(&one.counts) > 0);
    let columns: Vec<&Column> = COLUMNS.iter().filter(has_number).collect();
    let titles = std::iter::once("Application").chain(columns.iter().map(|(title, _)| *title));
    let titles = titles.chain(["Greatest movement"]).collect();
    Some(Block::Table(Table { titles, rows: statistics.iter().map(|one| row(one, &columns)).collect() }))
}

fn row(statistics: &Statistics, columns: &[&Column]) -> Row {
    let number = |(_, number): &&Column| match number(&statistics.counts) {
        0 => String::new(),
        count => count.to_string(),
    };
    let greatest = statistics.greatest.as_ref().map(|greatest| {
        let moved = greatest.displacement.map_or("unknown".to_owned(), displacement);
        format!("{moved}  {}", greatest.path)
    });
    let name =
        statistics.name.as_deref().map_or("(other files)", |name| if name.is_empty() { "(this folder)" } else { name });
    let cells =
        std::iter::once(name.to_owned()).chain(columns.iter().map(number)).chain([greatest.unwrap_or_default()]);
    Row { mark: Mark::from(statistics.change), cells: cells.collect() }
}
