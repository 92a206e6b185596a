//! Statistics: a short table with the number of differences for each application.

use camino::Utf8Path;
use serde::Serialize;

use super::block::{Block, ReportMark, ReportRow, TextTable};
use super::counts::DifferenceCounts;
use super::points::{by_size, displacement, extent, is_pose};
use crate::model::{ApplicationChange, Change, Comparison, Displacement};

/// Statistics for an application, or for the configuration and files outside of applications.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DiffStatistics {
    /// Application name; `None` for files outside of applications that differ.
    pub name: Option<String>,
    /// Path of the project file; `None` without an application.
    pub path: Option<String>,
    /// Change of the application.
    pub change: Change,
    /// Numbers of items that differ. `others` are other kinds of files in the folder of the application.
    pub counts: DifferenceCounts,
    /// Greatest movement of a position.
    pub greatest: Option<GreatestMovement>,
}

/// The position with the greatest movement.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GreatestMovement {
    /// Data path of the position.
    pub path: String,
    /// Movement in `world`, for a tool on the flange, for a joint position of the axes; `None` if unknown.
    pub displacement: Option<Displacement>,
}

/// Returns the statistics of a comparison, by application.
#[must_use]
pub fn statistics(comparison: &Comparison) -> Vec<DiffStatistics> {
    let mut others: Vec<usize> = vec![0; comparison.applications.len()];
    let mut outside = DifferenceCounts::of(comparison);
    for file in &comparison.others {
        let around =
            comparison.applications.iter().enumerate().filter(|(_, application)| contains(application, &file.path));
        let Some((index, _)) = around.max_by_key(|(_, application)| application.path.len()) else { continue };
        others.iter_mut().skip(index).take(1).for_each(|count| *count += 1);
        outside.others -= 1;
    }
    let with_others = comparison.applications.iter().zip(others);
    let mut found: Vec<DiffStatistics> = with_others.map(|(application, others)| one(application, others)).collect();
    outside = outside.without(found.iter().map(|statistics| &statistics.counts));
    if !outside.is_empty() {
        found.push(DiffStatistics { name: None, path: None, change: Change::Changed, counts: outside, greatest: None });
    }
    found
}

/// Whether a file is in the folder of the application.
fn contains(application: &ApplicationChange, file: &str) -> bool {
    let folder = Utf8Path::new(&application.path).parent();
    folder.is_some_and(|folder| Utf8Path::new(&file.to_lowercase()).starts_with(folder.as_str().to_lowercase()))
}

fn one(application: &ApplicationChange, others: usize) -> DiffStatistics {
    let counts = DifferenceCounts { others, ..DifferenceCounts::default().with(application) };
    DiffStatistics {
        name: Some(application.name.clone()),
        path: Some(application.path.clone()),
        change: application.change,
        counts,
        greatest: greatest(application),
    }
}

fn greatest(application: &ApplicationChange) -> Option<GreatestMovement> {
    let values = || application.data.iter().flat_map(|data| &data.values);
    let moved = values().filter(|value| is_pose(value));
    let own = moved.map(|value| (&value.path, extent(value)));
    let along = values().flat_map(|value| &value.dependents).map(|dependent| (&dependent.path, dependent.in_world));
    // The first of equal movements.
    let greatest = own.chain(along).reduce(|one, other| if by_size(other.1, one.1).is_gt() { other } else { one });
    let (path, displacement) = greatest?;
    Some(GreatestMovement { path: path.clone(), displacement })
}

/// A column of numbers: its title, and the number in a row.
type Column = (&'static str, fn(&DifferenceCounts) -> usize);

const COLUMNS: [Column; 7] = [
    ("Positions", |counts| counts.points),
    ("Moved along", |counts| counts.moved_along),
    ("Values", |counts| counts.data),
    ("In/out", |counts| counts.io),
    ("Programs", |counts| counts.programs),
    ("Files", |counts| counts.texts + counts.contents + counts.others),
    ("Other", |counts| counts.libraries + counts.interface + counts.configuration),
];

/// Returns the table, without columns of zeros; `None` if there is no difference.
pub(super) fn table(comparison: &Comparison) -> Option<Block> {
    let statistics = statistics(comparison);
    if statistics.is_empty() {
        return None;
    }
    let has_number = |(_, number): &&Column| statistics.iter().any(|one| number(&one.counts) > 0);
    let columns: Vec<&Column> = COLUMNS.iter().filter(has_number).collect();
    let titles = std::iter::once("Application").chain(columns.iter().map(|(title, _)| *title));
    let titles = titles.chain(["Greatest movement"]).collect();
    Some(Block::Table(TextTable { titles, rows: statistics.iter().map(|one| row(one, &columns)).collect() }))
}

fn row(statistics: &DiffStatistics, columns: &[&Column]) -> ReportRow {
    let numbers = columns.iter().map(|(_, number)| match number(&statistics.counts) {
        0 => String::new(),
        count => count.to_string(),
    });
    let greatest = statistics.greatest.as_ref().map(|greatest| {
        let moved = greatest.displacement.map_or("unknown".to_owned(), displacement);
        format!("{moved}  {}", greatest.path)
    });
    let name =
        statistics.name.as_deref().map_or("(other files)", |name| if name.is_empty() { "(this folder)" } else { name });
    let cells = std::iter::once(name.to_owned()).chain(numbers).chain([greatest.unwrap_or_default()]);
    ReportRow { mark: ReportMark::from(statistics.change), cells: cells.collect() }
}
